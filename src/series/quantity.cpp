#include "series/quantity.h"

namespace mapwright::series {

std::optional<double> valueOf(Quantity quantity, const geometry::Pose2& pose) {
  switch (quantity) {
    case Quantity::X:
      return pose.x_m;
    case Quantity::Y:
      return pose.y_m;
    case Quantity::Yaw:
      return geometry::degreesFromRadians(geometry::normalizeAngle(pose.yaw_rad));
    default:
      return std::nullopt;
  }
}

std::optional<double> valueOf(Quantity quantity, const map::TopicMessage& message) {
  if (const auto* tracked = std::get_if<map::TrackedPose>(&message)) return valueOf(quantity, tracked->pose);
  if (const auto* slam = std::get_if<map::SlamStatus>(&message)) {
    if (quantity == Quantity::MatchingScore) return slam->lidar_matching_score;
    if (quantity == Quantity::PositionQuality && slam->position_quality)
      return double(*slam->position_quality);
  }
  if (const auto* battery = std::get_if<map::BatteryState>(&message)) {
    if (quantity == Quantity::Battery && battery->level) return *battery->level * 100;
  }
  return std::nullopt;
}

bool isOfPose(Quantity quantity) {
  return quantity == Quantity::X || quantity == Quantity::Y || quantity == Quantity::Yaw ||
         quantity == Quantity::Speed;
}

bool isStepped(Quantity quantity) { return quantity == Quantity::PositionQuality; }

}  // namespace mapwright::series
