// Edits waypoints on the map: click adds or selects, drag moves, a handle turns one or a group, a frame
// selects, keys nudge, rename and delete.
#pragma once

#include <optional>

#include "placing/arrange.h"
#include "ui/view/drag_tool.h"
#include "ui/view/hit_list.h"
#include "ui/waypoints/waypoint_editing.h"
#include "ui/waypoints/waypoint_snapping.h"

namespace mapwright::ui {

class WaypointTool : public DragTool {
  Q_OBJECT
 public:
  /// How far from its waypoint the handle of the heading is, and from a group the one that turns it.
  static constexpr double kHandlePx = 34;

  /// All must outlive this.
  WaypointTool(WaypointEditing* editing, const scene::MapScene* scene, const HitList* hits,
               WaypointSnapping* snapping, QObject* parent = nullptr);

  QString name() const override { return QStringLiteral("waypoints"); }
  QCursor cursor() const override;
  void activate() override { Q_EMIT activated(); }
  void deactivate() override;
  void hovered(const MapPoint& at) override;
  void left() override;
  bool doubleClicked(const MapPoint& at) override;
  bool keyPressed(const MapKeyPress& press) override;
  void paint(QPainter& painter) override;
  std::vector<QRectF> covered() const override;
  QString hint() const override;

  /// Where the handle of what is selected is, in viewport pixels: that of the heading of one, or that which
  /// turns several.
  std::optional<QPointF> handle() const;

 Q_SIGNALS:
  void activated();

 private:
  enum class Drag { None, Move, Turn, TurnGroup, Frame };
  bool grab(const MapPoint& at) override;
  void update(const MapPoint& at) override;
  void finish(const MapPoint& at) override;
  void cancel() override;
  void click(const MapPoint& at) override;
  bool stepBack() override;
  Drag drag() const { return hold() ? drag_ : Drag::None; }
  /// Several that are selected: about which place they turn, and where they are.
  struct Group {
    Eigen::Vector2d pivot_m{0, 0};
    geometry::WorldRect bounds;
  };
  std::optional<edit::Key> under(const MapPoint& at) const;
  bool onHandle(const MapPoint& at) const;
  bool nudge(const MapKeyPress& press);
  void move(const MapPoint& at);
  void turn(const MapPoint& at);
  void turnGroup(const MapPoint& at);
  std::set<edit::Key> inFrame() const;
  const Group& group() const;
  void paintMoved(QPainter& painter) const;
  void paintHeading(QPainter& painter, const QPointF& grip) const;
  void paintGroup(QPainter& painter, const QPointF& grip) const;

  WaypointEditing* editing_;
  const HitList* hits_;
  WaypointSnapping* snapping_;
  Drag drag_ = Drag::None;  // what the press that is held does
  edit::Key grabbed_;
  bool pressed_on_one_ = false;  // what went down on a waypoint is no click on the ground
  double turned_by_rad_ = 0;
  placing::SnappedPlace snapped_;                 // of what is dragged
  std::optional<placing::SnappedPlace> landing_;  // where a click would add one, when something catches it
  std::optional<edit::Key> hovered_;
  edit::Gesture nudging_ = 0;
  std::set<edit::Key> nudged_;
  mutable std::optional<Group> group_;  // as it is; made when it is asked for
};

}  // namespace mapwright::ui
