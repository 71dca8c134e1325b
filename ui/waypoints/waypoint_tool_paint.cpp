// WaypointTool: its handles, what it paints over the map, and its hints.
#include <cmath>

#include <QLocale>
#include <QPainter>

#include "geometry/pose.h"
#include "scene/drawing.h"
#include "ui/waypoints/waypoint_text.h"
#include "ui/waypoints/waypoint_tool.h"

namespace mapwright::window {
namespace {

constexpr double kHandleRadiusPx = 6;
constexpr double kInsidePx = 16;            // minimum distance of handles from the edge of the map
constexpr std::size_t kMostTraces = 2'000;  // with more, individual paths are not drawn

QString metresOf(double value) { return QLocale::c().toString(value, 'f', 2); }

void haloLine(QPainter& painter, const scene::MapTheme& theme, const QPointF& a, const QPointF& b,
              Qt::PenStyle style) {
  for (const auto& [color, width] : {std::pair(theme.text_halo, 3.5), std::pair(theme.accent, 1.5)}) {
    painter.setPen(QPen(color, width, style, Qt::RoundCap));
    painter.drawLine(a, b);
  }
}

}  // namespace

const WaypointTool::Group& WaypointTool::group() const {
  if (!group_) {
    group_.emplace();
    std::vector<placing::Spot> spots;
    for (const edit::Key& key : editing_->selected()) {
      const auto spot = editing_->spotOf(key);
      if (!spot) continue;
      group_->bounds.extend(spot->position_m);
      spots.push_back(*spot);
    }
    group_->pivot_m = placing::middleOf(spots);
  }
  return *group_;
}

std::optional<QPointF> WaypointTool::groupHandle() const {
  const geometry::WorldRect& bounds = group().bounds;
  if (bounds.empty()) return std::nullopt;
  const geometry::ViewTransform& view = scene_->view();
  double top = 1e9;
  for (const double x : {bounds.min_x, bounds.max_x}) {
    for (const double y : {bounds.min_y, bounds.max_y}) top = std::min(top, view.pixelFromWorld({x, y}).y());
  }
  const QPointF pivot = scene::toPoint(view.pixelFromWorld(group().pivot_m));
  // Reachable whenever the middle is on screen, however large the group.
  const double y = std::max(top - kHandlePx, std::min(kInsidePx * 3, pivot.y() - kHandlePx));
  return QPointF(pivot.x(), y);
}

std::optional<QPointF> WaypointTool::handle() const {
  if (!editing_->editable() || editing_->selected().empty()) return std::nullopt;
  if (editing_->selected().size() > 1) return drag_ == Drag::TurnGroup ? now_px_ : groupHandle();
  const auto point = editing_->spotOf(*editing_->selected().begin());
  if (!point) return std::nullopt;
  const double heading = point->yaw_rad.value_or(0) + scene_->view().rotation_rad;
  return scene::toPoint(scene_->view().pixelFromWorld(point->position_m)) +
         QPointF(std::cos(heading), -std::sin(heading)) * kHandlePx;
}

void WaypointTool::paint(QPainter& painter) {
  painter.setRenderHint(QPainter::Antialiasing);
  if (drag_ == Drag::Frame) return paintFrame(painter);
  if (drag_ == Drag::Move || drag_ == Drag::TurnGroup) paintMoved(painter);
  if (drag_ == Drag::Move) return snapping_->paint(painter, snapped_);
  if (landing_ && drag_ == Drag::None) snapping_->paint(painter, *landing_);
  const auto grip = handle();
  if (!grip) return;
  editing_->only() ? paintHeading(painter, *grip) : paintGroup(painter, *grip);
}

void WaypointTool::paintMoved(QPainter& painter) const {
  const scene::MapTheme& theme = scene_->theme();
  if (editing_->preview().size() > kMostTraces) return;
  for (const auto& [key, to] : editing_->preview()) {
    const map::Waypoint* const from = editing_->find(key);
    if (!from) continue;
    const QPointF a = scene::toPoint(scene_->view().pixelFromWorld(from->position_m)),
                  b = scene::toPoint(scene_->view().pixelFromWorld(to.position_m));
    haloLine(painter, theme, a, b, Qt::DashLine);
    painter.setPen(QPen(theme.accent, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(a, 4, 4);
  }
}

void WaypointTool::paintHeading(QPainter& painter, const QPointF& grip) const {
  const scene::MapTheme& theme = scene_->theme();
  const map::Waypoint* const only = editing_->only();
  const bool has_heading = only->yaw_rad || drag_ == Drag::Turn;
  const QPointF from = scene::toPoint(scene_->view().pixelFromWorld(only->position_m));
  haloLine(painter, theme, from, grip, has_heading ? Qt::SolidLine : Qt::DotLine);
  painter.setPen(QPen(theme.accent, 2));
  painter.setBrush(has_heading ? QBrush(theme.accent) : QBrush(theme.text_halo));
  painter.drawEllipse(grip, kHandleRadiusPx, kHandleRadiusPx);
}

void WaypointTool::paintGroup(QPainter& painter, const QPointF& grip) const {
  const scene::MapTheme& theme = scene_->theme();
  const QPointF pivot = scene::toPoint(scene_->view().pixelFromWorld(group().pivot_m));
  haloLine(painter, theme, pivot, grip, Qt::DotLine);
  painter.setPen(QPen(theme.accent, 1.5));
  painter.setBrush(theme.text_halo);
  painter.drawEllipse(pivot, 3, 3);
  painter.setPen(QPen(theme.accent, 2));
  painter.drawEllipse(grip, kHandleRadiusPx + 1, kHandleRadiusPx + 1);
  // A circular arrow: for rotation.
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme.accent, 1.5, Qt::SolidLine, Qt::RoundCap));
  const QRectF ring(grip - QPointF(3.5, 3.5), QSizeF(7, 7));
  painter.drawArc(ring, 40 * 16, 280 * 16);
  painter.drawLine(grip + QPointF(2.7, -2.2), grip + QPointF(4.4, -4.2));
}

void WaypointTool::paintFrame(QPainter& painter) const {
  const scene::MapTheme& theme = scene_->theme();
  QColor fill = theme.accent;
  fill.setAlphaF(0.12F);
  painter.setBrush(fill);
  painter.setPen(QPen(theme.accent, 1.5));
  painter.drawRect(QRectF(press_px_, now_px_).normalized());
}

QString WaypointTool::hint() const {
  if (!editing_->document()) return tr("There is no waypoint list here. Esc leaves.");
  if (drag_ == Drag::Frame)
    return tr("%1 in the frame. Esc cancels.").arg(waypointsText(qsizetype(inFrame().size())));
  if (!editing_->editable()) return editing_->whyNot();
  if (drag_ == Drag::TurnGroup)
    return tr("Turned by %1. Shift turns by 15°, Esc cancels.").arg(yawText(turned_by_rad_));
  if (drag_ == Drag::Turn && editing_->preview().contains(grabbed_))
    return tr("Heading %1. Shift turns by 15°, Esc cancels.")
        .arg(yawText(editing_->preview().at(grabbed_).yaw_rad));
  if (drag_ == Drag::Move && editing_->preview().contains(grabbed_)) {
    const Eigen::Vector2d at = editing_->preview().at(grabbed_).position_m;
    return tr("%1, %2 m. Ctrl: snap to the grid, Alt: no snapping, Esc cancels.")
        .arg(metresOf(at.x()), metresOf(at.y()));
  }
  if (editing_->selected().empty())
    return tr("Click to add a waypoint, drag to move one, Shift and drag to select several. Esc leaves.");
  if (editing_->selected().size() > 1)
    return tr("%1: drag or use the arrows to move, drag the handle to turn, Delete deletes. Esc deselects.")
        .arg(waypointsText(qsizetype(editing_->selected().size())));
  return tr("Drag or use the arrows to move, F2 renames, Delete deletes. Esc deselects.");
}

}  // namespace mapwright::window
