// The SLAM inspector, and submaps on the map.
#pragma once

#include "ui/kit/controller.h"
#include "ui/kit/findings.h"
#include "ui/scene/map_scene.h"
#include "ui/shell/window_context.h"

namespace mapwright::render {
enum class ColorMode;
}

namespace mapwright::ui {

class InspectorDock;

class InspectorController : public Controller {
  Q_OBJECT
 public:
  /// The two actions switch the ids and the outlines of the submaps.
  InspectorController(WindowContext& context, QAction* show_ids, QAction* show_outlines,
                      QObject* parent = nullptr);

  InspectorDock* dock() const { return dock_; }
  void setColorMode(render::ColorMode mode);
  /// A click on the map that nothing else handles.
  void clickedOnMap(const Eigen::Vector2d& world_m);
  void setSession(session::Session* session) override;
  bool escape() override;

 Q_SIGNALS:
  void colorModeWanted(mapwright::render::ColorMode mode);
  void located(mapwright::map::SubmapId id);

 private:
  void addToMapMenu();
  void findSubmaps(const QString& typed, const Findings::See& see);
  void locate(map::SubmapId id);
  void goToFilter();

  WindowContext& context_;
  InspectorDock* dock_;
  bool behind_ = false;  // the previous robot had no submaps
};

}  // namespace mapwright::ui
