#include "placing/align.h"

#include <cmath>

#include <Eigen/Geometry>

namespace mapwright::placing {

geometry::Pose2 alignedBy(const std::vector<PointPair>& pairs, const geometry::Pose2& before) {
  if (pairs.empty()) return before;
  Eigen::Matrix2Xd from(2, Eigen::Index(pairs.size())), to(2, Eigen::Index(pairs.size()));
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    from.col(Eigen::Index(i)) = pairs[i].on_map_m;
    to.col(Eigen::Index(i)) = pairs[i].in_world_m;
  }
  const Eigen::Vector2d middle_from = from.rowwise().mean(), middle_to = to.rowwise().mean();
  const bool spread =
      (from.colwise() - middle_from).squaredNorm() > 0 && (to.colwise() - middle_to).squaredNorm() > 0;
  double yaw_rad = before.yaw_rad;
  if (pairs.size() > 1 && spread) {
    const Eigen::Matrix3d pose = Eigen::umeyama(from, to, false);
    yaw_rad = std::atan2(pose(1, 0), pose(0, 0));
  }
  const Eigen::Vector2d shift = middle_to - Eigen::Rotation2Dd(yaw_rad) * middle_from;
  return {shift.x(), shift.y(), yaw_rad};
}

std::vector<double> residualsOf(const std::vector<PointPair>& pairs, const geometry::Pose2& world_from_map) {
  std::vector<double> residuals;
  residuals.reserve(pairs.size());
  for (const PointPair& pair : pairs)
    residuals.push_back((world_from_map.apply(pair.on_map_m) - pair.in_world_m).norm());
  return residuals;
}

double rootMeanSquare(const std::vector<double>& residuals) {
  if (residuals.empty()) return 0;
  double sum = 0;
  for (const double residual : residuals) sum += residual * residual;
  return std::sqrt(sum / double(residuals.size()));
}

}  // namespace mapwright::placing
