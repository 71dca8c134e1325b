// Quantities that can be plotted for every kind of robot, independent of topic names. Pure.
#pragma once

#include <array>
#include <optional>

#include "map/live_topics.h"

namespace mapwright::series {

enum class Quantity {
  X,                // metres
  Y,                // metres
  Yaw,              // degrees, -180..180
  Speed,            // metres per second, from the poses (series/speed.h)
  PositionQuality,  // 0 unknown, 1 lost, 3 poor, 8 good, 10 excellent
  MatchingScore,    // of the lidar, as reported by the robot
  Battery,          // percent
};
inline constexpr std::array kQuantities{Quantity::X,
                                        Quantity::Y,
                                        Quantity::Yaw,
                                        Quantity::Speed,
                                        Quantity::PositionQuality,
                                        Quantity::MatchingScore,
                                        Quantity::Battery};

/// The value in this message; nullopt = none. For Speed no single message has a value.
std::optional<double> valueOf(Quantity quantity, const map::TopicMessage& message);
std::optional<double> valueOf(Quantity quantity, const geometry::Pose2& pose);
/// It is derived from poses.
bool isOfPose(Quantity quantity);
/// It keeps its value until the next message: drawn in steps.
bool isStepped(Quantity quantity);

}  // namespace mapwright::series
