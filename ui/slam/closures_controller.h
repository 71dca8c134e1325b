// The list of loop closures, and the one that is shown on the map.
#pragma once

#include <QPointer>

#include "scene/layer.h"
#include "session/session.h"
#include "ui/kit/controller.h"
#include "ui/shell/window_context.h"

namespace mapwright::window {

class ClosuresDock;
struct ClosureRow;

class ClosuresController : public Controller {
  Q_OBJECT
 public:
  explicit ClosuresController(WindowContext& context, QObject* parent = nullptr);

  ClosuresDock* dock() const { return dock_; }
  void setSession(session::Session* session) override;
  bool escape() override;

 Q_SIGNALS:
  /// The one that a closure on show belongs to.
  void submapShown(mapwright::map::SubmapId id);

 private:
  /// Asks for what is needed while the dock is open.
  void want();
  void refresh();
  void show(const ClosureRow& row);
  QString summary() const;
  /// That draws them: of a robot that only reports residuals another one.
  scene::Layer layer() const;

  WindowContext& context_;
  ClosuresDock* dock_;
  QPointer<session::Session> session_;
  bool marked_ = false;
};

}  // namespace mapwright::window
