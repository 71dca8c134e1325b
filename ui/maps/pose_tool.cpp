#include "ui/maps/pose_tool.h"

#include <array>
#include <cmath>

#include "jobs/set_pose.h"

namespace mapwright::ui {

void PoseTool::setPose(const std::optional<geometry::Pose2>& pose) {
  if (pose == pose_) return;
  pose_ = pose;
  notifyChanged();
}

bool PoseTool::grab(const MapPoint&) {
  before_ = pose_;
  return true;
}

void PoseTool::update(const MapPoint& at) {
  const Eigen::Vector2d& from = hold()->from.world_m;
  const Eigen::Vector2d to = at.world_m - from;
  const double yaw = to.norm() > 0 ? std::atan2(to.y(), to.x()) : pose_ ? pose_->yaw_rad : 0;
  Q_EMIT placed({from.x(), from.y(), yaw});
}

void PoseTool::cancel() {
  if (pose_ != before_) Q_EMIT takenBack(before_);
}

void PoseTool::click(const MapPoint& at) {
  // It keeps looking where it looked.
  Q_EMIT placed({at.world_m.x(), at.world_m.y(), pose_ ? pose_->yaw_rad : 0});
}

void PoseTool::paint(QPainter& painter) {
  if (!pose_) return;
  const QPointF at = px({pose_->x_m, pose_->y_m});
  const QPointF towards = px(pose_->apply({1, 0})) - at;
  const double length = std::hypot(towards.x(), towards.y());
  if (!(length > 0)) return;
  const QPointF along = towards / length, aside(-along.y(), along.x());
  constexpr double kNosePx = 20, kTailPx = 12, kHalfPx = 12;
  const std::array<QPointF, 4> arrow{at + along * kNosePx, at - along * kTailPx + aside * kHalfPx,
                                     at - along * kTailPx / 2, at - along * kTailPx - aside * kHalfPx};
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme().text_halo, 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPolygon(arrow.data(), int(arrow.size()));
  painter.setPen(QPen(theme().measure, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(scene::translucent(theme().measure, 90));
  painter.drawPolygon(arrow.data(), int(arrow.size()));
}

QString PoseTool::hint() const {
  if (!pose_) return tr("Click where the robot is; drag towards where it looks. Esc leaves.");
  return tr("%1. Click or drag again, then set it in the panel. Esc leaves.").arg(jobs::poseWords(*pose_));
}

}  // namespace mapwright::ui

#include "moc_pose_tool.cpp"
