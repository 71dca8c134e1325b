// The hand on waypoints: click adds or selects, drag moves, the handle turns, keys nudge, rename and delete.
#pragma once

#include <optional>

#include "scene/map_scene.h"
#include "window/map/hit_list.h"
#include "window/map/map_tool.h"
#include "window/waypoints/waypoint_editing.h"

namespace mapwright::window {

class WaypointTool : public MapTool {
  Q_OBJECT
 public:
  /// How far from its waypoint the handle of the heading is.
  static constexpr double kHandlePx = 34;

  /// All must outlive this.
  WaypointTool(WaypointEditing* editing, const scene::MapScene* scene, const HitList* hits,
               QObject* parent = nullptr);

  QString name() const override { return QStringLiteral("waypoints"); }
  QCursor cursor() const override;
  void activate() override { Q_EMIT activated(); }
  void deactivate() override;
  bool pressed(const MapPoint& at) override;
  void dragged(const MapPoint& at) override;
  void released(const MapPoint& at) override;
  void dragCancelled() override;
  void clicked(const MapPoint& at) override;
  void hovered(const MapPoint& at) override;
  void left() override;
  bool doubleClicked(const MapPoint& at) override;
  bool keyPressed(const MapKeyPress& press) override;
  void paint(QPainter& painter) override;
  QString hint() const override;

  /// Where the handle of the only selected one is, in viewport pixels.
  std::optional<QPointF> handle() const;

 Q_SIGNALS:
  void activated();

 private:
  enum class Drag { None, Move, Turn };
  std::optional<edit::Key> under(const MapPoint& at) const;
  bool onHandle(const MapPoint& at) const;
  bool nudge(const MapKeyPress& press);
  void endDrag();

  WaypointEditing* editing_;
  const scene::MapScene* scene_;
  const HitList* hits_;
  Drag drag_ = Drag::None;
  edit::Key grabbed_;
  bool pressed_on_one_ = false;  // what went down on a waypoint or its handle is no click on the ground
  Eigen::Vector2d press_m_{0, 0};
  Snapped snapped_;
  std::optional<edit::Key> hovered_;
  edit::Gesture nudging_ = 0;
  std::set<edit::Key> nudged_;
};

}  // namespace mapwright::window
