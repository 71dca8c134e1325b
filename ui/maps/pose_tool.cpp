#include "ui/maps/pose_tool.h"

#include <array>
#include <cmath>

#include <QPainter>

#include "jobs/set_pose.h"
#include "scene/drawing.h"

namespace mapwright::window {

PoseTool::PoseTool(const scene::MapScene* scene, QObject* parent) : MapTool(parent), scene_(scene) {}

void PoseTool::setPose(const std::optional<geometry::Pose2>& pose) {
  if (pose == pose_) return;
  pose_ = pose;
  Q_EMIT changed();
  Q_EMIT hintChanged();
}

bool PoseTool::pressed(const MapPoint& at) {
  before_ = pose_;
  from_m_ = at.world_m;
  return true;
}

void PoseTool::dragged(const MapPoint& at) {
  if (!from_m_) return;
  const Eigen::Vector2d to = at.world_m - *from_m_;
  const double yaw = to.norm() > 0 ? std::atan2(to.y(), to.x()) : pose_ ? pose_->yaw_rad : 0;
  Q_EMIT placed({from_m_->x(), from_m_->y(), yaw});
}

void PoseTool::released(const MapPoint& at) {
  dragged(at);
  from_m_.reset();
}

void PoseTool::dragCancelled() {
  if (!from_m_) return;
  from_m_.reset();
  Q_EMIT takenBack(before_);
}

void PoseTool::clicked(const MapPoint& at) {
  from_m_.reset();
  // It keeps looking where it looked.
  Q_EMIT placed({at.world_m.x(), at.world_m.y(), pose_ ? pose_->yaw_rad : 0});
}

bool PoseTool::keyPressed(const MapKeyPress& press) {
  if (press.key != Qt::Key_Escape) return false;
  Q_EMIT finished();
  return true;
}

void PoseTool::paint(QPainter& painter) {
  if (!pose_) return;
  const geometry::ViewTransform& view = scene_->view();
  const QPointF at = scene::toPoint(view.pixelFromWorld({pose_->x_m, pose_->y_m}));
  const Eigen::Vector2d ahead = pose_->apply({1, 0});
  const QPointF towards = scene::toPoint(view.pixelFromWorld(ahead)) - at;
  const double length = std::hypot(towards.x(), towards.y());
  if (!(length > 0)) return;
  const QPointF along = towards / length, aside(-along.y(), along.x());
  constexpr double kNosePx = 20, kTailPx = 12, kHalfPx = 12;
  const std::array<QPointF, 4> arrow{at + along * kNosePx, at - along * kTailPx + aside * kHalfPx,
                                     at - along * kTailPx / 2, at - along * kTailPx - aside * kHalfPx};
  const scene::MapTheme& theme = scene_->theme();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme.text_halo, 5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPolygon(arrow.data(), int(arrow.size()));
  painter.setPen(QPen(theme.measure, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(scene::translucent(theme.measure, 90));
  painter.drawPolygon(arrow.data(), int(arrow.size()));
}

QString PoseTool::hint() const {
  if (!pose_) return tr("Click where the robot is; drag towards where it looks. Esc leaves.");
  return tr("%1. Click or drag again, then set it in the panel. Esc leaves.").arg(jobs::poseWords(*pose_));
}

}  // namespace mapwright::window

#include "moc_pose_tool.cpp"
