// The list of loop closures, and the one that is shown on the map.
#pragma once

#include <QPointer>

#include "session/session.h"
#include "ui/kit/controller.h"
#include "ui/scene/layer.h"
#include "ui/scene/map_object.h"
#include "ui/shell/window_context.h"

namespace mapwright::ui {

class ClosuresDock;
struct ClosureRow;

class ClosuresController : public Controller {
  Q_OBJECT
 public:
  explicit ClosuresController(WindowContext& context, QObject* parent = nullptr);

  ClosuresDock* dock() const { return dock_; }
  void setSession(session::Session* session) override;
  bool escape() override;
  /// Of a closure that was clicked on the map, its row becomes the current one: the view stays.
  void chosenOnMap(const scene::MapObject& object);

 Q_SIGNALS:
  /// The one that a closure on show belongs to.
  void submapShown(mapwright::map::SubmapId id);

 private:
  /// Asks for what is needed while the dock is open.
  void want();
  void refresh();
  void show(const ClosureRow& row);
  void say(const ClosureRow& row);
  /// What the list leaves out is not drawn while it is open.
  void follow();
  void showOnMap();
  QString summary() const;
  /// That draws them: of a robot that only reports residuals another one.
  scene::Layer layer() const;

  WindowContext& context_;
  ClosuresDock* dock_;
  QPointer<session::Session> session_;
  bool marked_ = false;
};

}  // namespace mapwright::ui
