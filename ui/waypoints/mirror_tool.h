// Mirrors the selected waypoints about a line that is drawn: two clicks or a drag, with a preview of the
// result.
#pragma once

#include <optional>

#include "scene/map_scene.h"
#include "ui/view/map_tool.h"
#include "ui/waypoints/waypoint_editing.h"
#include "ui/waypoints/waypoint_snapping.h"

namespace mapwright::window {

class MirrorTool : public MapTool {
  Q_OBJECT
 public:
  /// All must outlive this.
  MirrorTool(WaypointEditing* editing, const scene::MapScene* scene, WaypointSnapping* snapping,
             QObject* parent = nullptr);

  QString name() const override { return QStringLiteral("mirrorWaypoints"); }
  void activate() override;
  void deactivate() override { forget(); }
  bool pressed(const MapPoint& at) override;
  void dragged(const MapPoint& at) override { follow(at); }
  void released(const MapPoint& at) override;
  void dragCancelled() override { forget(); }
  void clicked(const MapPoint& at) override;
  void hovered(const MapPoint& at) override { follow(at); }
  bool doubleClicked(const MapPoint&) override { return true; }
  bool keyPressed(const MapKeyPress& press) override;
  void paint(QPainter& painter) override;
  QString hint() const override;

 Q_SIGNALS:
  void activated();
  void ended();  // mirrored, or given up

 private:
  void forget();
  void follow(const MapPoint& at);
  void end(const MapPoint& at);

  WaypointEditing* editing_;
  const scene::MapScene* scene_;
  WaypointSnapping* snapping_;
  std::optional<Eigen::Vector2d> from_, to_;
  bool first_press_ = false;  // the one under way began the line
};

}  // namespace mapwright::window
