#include "scene/pose_between.h"

namespace mapwright::scene {

PoseBetween::PoseBetween(MapScene* scene) : QObject(scene) {}

PoseBetween& PoseBetween::of(const MapScene& scene) {
  return *scene.findChild<PoseBetween*>(QString(), Qt::FindDirectChildrenOnly);
}

void PoseBetween::show(const std::optional<geometry::Pose2>& pose) {
  if (pose == pose_) return;
  pose_ = pose;
  Q_EMIT changed();
}

std::optional<geometry::Pose2> poseDrawn(const MapScene& scene) {
  if (!scene.session() || !scene.session()->live().robot_pose) return std::nullopt;
  const auto& between = PoseBetween::of(scene).pose();
  return between ? between : scene.session()->live().robot_pose;
}

}  // namespace mapwright::scene

#include "moc_pose_between.cpp"
