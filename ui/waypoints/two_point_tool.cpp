#include "ui/waypoints/two_point_tool.h"

#include <cmath>
#include <utility>

namespace mapwright::ui {

TwoPointTool::TwoPointTool(const scene::MapScene* scene, WaypointSnapping* snapping, QObject* parent)
    : DragTool(scene, parent), snapping_(snapping) {}

double TwoPointTool::Line::heading() const {
  const Eigen::Vector2d along = to_m - from_m;
  return std::atan2(along.y(), along.x());
}

void TwoPointTool::deactivate() {
  DragTool::deactivate();
  forget();
}

void TwoPointTool::forget() {
  line_.reset();
  ended_ = begins_ = false;
  landing_ = {};
  notifyChanged();
}

Eigen::Vector2d TwoPointTool::caught(const MapPoint& at) {
  landing_ = snapping_->place(at.world_m, at.modifiers, [](const Hit&) { return false; });
  if (!line_ || !(at.modifiers & Qt::ShiftModifier)) return landing_.at_m;
  const double heading = snapping_->heading(Line{line_->from_m, at.world_m}.heading(), at.modifiers);
  const Eigen::Vector2d direction(std::cos(heading), std::sin(heading));
  landing_ = {line_->from_m + direction * (at.world_m - line_->from_m).dot(direction), {}};
  return landing_.at_m;
}

bool TwoPointTool::grab(const MapPoint& at) {
  begins_ = !line_ || ended_;
  if (!begins_) return true;
  line_.reset();
  ended_ = false;
  const Eigen::Vector2d from = caught(at);
  line_ = Line{from, from};
  lineMoved();
  notifyChanged();
  return true;
}

void TwoPointTool::follow(const MapPoint& at) {
  if (!line_ || ended_) return;
  line_->to_m = caught(at);
  lineMoved();
}

void TwoPointTool::end(const MapPoint& at) {
  if (!line_ || ended_) return;
  follow(at);
  ended_ = line_->length() > 0;
  landing_ = {};
  lineMoved();
  if (ended_) lineDrawn();
}

/// The first end stays when the second one is given up.
void TwoPointTool::cancel() {
  if (begins_) forget();
}

void TwoPointTool::click(const MapPoint& at) {
  if (!std::exchange(begins_, false)) end(at);
}

void TwoPointTool::hovered(const MapPoint& at) {
  if (ended_) return;
  if (line_) {
    follow(at);
    notifyChanged();
  } else {
    caught(at);
    Q_EMIT changed();
  }
}

void TwoPointTool::left() {
  landing_ = {};
  Q_EMIT changed();
}

bool TwoPointTool::stepBack() {
  const bool any = line_.has_value();
  forget();
  return any;
}

void TwoPointTool::paint(QPainter& painter) {
  snapping_->paint(painter, landing_);
  painter.setRenderHint(QPainter::Antialiasing);
}

}  // namespace mapwright::ui

#include "moc_two_point_tool.cpp"
