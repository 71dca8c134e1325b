#include "ui/waypoints/mirror_tool.h"

#include <cmath>
#include <utility>

#include <QPainter>

#include "scene/drawing.h"
#include "ui/waypoints/waypoint_text.h"

namespace mapwright::window {

MirrorTool::MirrorTool(WaypointEditing* editing, const scene::MapScene* scene, WaypointSnapping* snapping,
                       QObject* parent)
    : MapTool(parent), editing_(editing), scene_(scene), snapping_(snapping) {}

void MirrorTool::activate() {
  forget();
  Q_EMIT activated();
}

void MirrorTool::forget() {
  const bool any = from_.has_value();
  from_.reset();
  to_.reset();
  first_press_ = false;
  if (any) editing_->setPreview({});
  tell();
}

bool MirrorTool::pressed(const MapPoint& at) {
  first_press_ = !from_;
  if (first_press_) from_ = snapping_->place(at.world_m, at.modifiers, [](const Hit&) { return false; }).at_m;
  tell();
  return true;
}

void MirrorTool::follow(const MapPoint& at) {
  if (!from_) return;
  Eigen::Vector2d along = at.world_m - *from_;
  // Shift: in steps of 15 degrees.
  if (at.modifiers & Qt::ShiftModifier) {
    const double heading = snapping_->heading(std::atan2(along.y(), along.x()), at.modifiers);
    along = along.norm() * Eigen::Vector2d(std::cos(heading), std::sin(heading));
  }
  to_ = *from_ + along;
  WaypointPreview preview;
  if (along.norm() > 0 && editing_->editable()) {
    const std::vector<edit::Key> keys(editing_->selected().begin(), editing_->selected().end());
    const auto spots = placing::mirrored(editing_->spots(keys), *from_, std::atan2(along.y(), along.x()));
    for (std::size_t i = 0; i < keys.size(); ++i) preview.emplace_hint(preview.end(), keys[i], spots[i]);
  }
  editing_->setPreview(std::move(preview));
  Q_EMIT changed();
}

void MirrorTool::end(const MapPoint& at) {
  follow(at);
  const auto count = qsizetype(editing_->preview().size());
  if (count == 0) return;
  editing_->applyPreview(tr("mirror %1").arg(waypointsText(count)));
  forget();
  Q_EMIT ended();
}

void MirrorTool::released(const MapPoint& at) {
  if (from_) end(at);
}

void MirrorTool::clicked(const MapPoint& at) {
  if (!std::exchange(first_press_, false) && from_) end(at);
}

bool MirrorTool::keyPressed(const MapKeyPress& press) {
  if (press.key != Qt::Key_Escape) return false;
  if (from_) {
    forget();
  } else {
    Q_EMIT ended();
  }
  return true;
}

void MirrorTool::paint(QPainter& painter) {
  if (!from_) return;
  const scene::MapTheme& theme = scene_->theme();
  painter.setRenderHint(QPainter::Antialiasing);
  const auto px = [&](const Eigen::Vector2d& at) {
    return scene::toPoint(scene_->view().pixelFromWorld(at));
  };
  const QPointF a = px(*from_), b = px(to_.value_or(*from_));
  const QLineF drawn(a, b);
  // A mirror has no ends.
  QLineF whole = drawn;
  if (drawn.length() > 0) {
    const QPointF far = drawn.unitVector().p2() - drawn.p1();
    const double reach = scene_->view().width_px + scene_->view().height_px;
    whole = QLineF(a - far * reach, a + far * reach);
  }
  for (const auto& [color, width] : {std::pair(theme.text_halo, 3.5), std::pair(theme.accent, 1.5)}) {
    painter.setPen(QPen(color, width, Qt::DashLine, Qt::RoundCap));
    painter.drawLine(whole);
  }
  painter.setPen(QPen(theme.accent, 1.5));
  painter.setBrush(theme.text_halo);
  for (const QPointF& end : {a, b}) painter.drawEllipse(end, 4, 4);
}

QString MirrorTool::hint() const {
  if (editing_->selected().empty()) return tr("Select waypoints first. Esc leaves.");
  return from_ ? tr("Click a second point of the mirror line. Shift: steps of 15°, Esc starts over.")
               : tr("Mirror %1: click a point of the mirror line, or drag along it. Esc leaves.")
                     .arg(waypointsText(qsizetype(editing_->selected().size())));
}

}  // namespace mapwright::window

#include "moc_mirror_tool.cpp"
