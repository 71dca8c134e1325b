// What is plotted of every kind of robot, whatever its topics are called. Pure.
#pragma once

#include <array>
#include <optional>

#include "map/live_topics.h"

namespace mapwright::series {

enum class Quantity {
  X,                // metres
  Y,                // metres
  Yaw,              // degrees, -180..180
  Speed,            // metres a second, made of the poses (series/speed.h)
  PositionQuality,  // 0 unknown, 1 lost, 3 poor, 8 good, 10 excellent
  MatchingScore,    // of the lidar, as the robot tells it
  Battery,          // percent
};
inline constexpr std::array kQuantities{Quantity::X,
                                        Quantity::Y,
                                        Quantity::Yaw,
                                        Quantity::Speed,
                                        Quantity::PositionQuality,
                                        Quantity::MatchingScore,
                                        Quantity::Battery};

/// What this message says of it; nullopt = nothing. Of Speed no message says anything by itself.
std::optional<double> valueOf(Quantity quantity, const map::TopicMessage& message);
std::optional<double> valueOf(Quantity quantity, const geometry::Pose2& pose);
/// It is made of poses.
bool isOfPose(Quantity quantity);
/// It stays as it is until the next message: drawn in steps.
bool isStepped(Quantity quantity);

}  // namespace mapwright::series
