// Named positions that a robot can be sent to. Source: docs/protocols/agibot-aimdk.md, "Methods",
// docs/protocols/kabam-map-manager.md, "Topics".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "fault/fault.h"

namespace mapwright::map {

/// A position in world metres. Names, types and tags are untrusted plain text; ids keep every digit.
struct Waypoint {
  std::string id, name, type;
  Eigen::Vector2d position_m{0, 0};
  std::optional<double> yaw_rad = {};
  std::vector<std::string> tags = {};
  /// The stored form, including what is not understood here. Only the store's reader and writer use it; empty
  /// = not stored yet.
  std::string source = {};
  bool operator==(const Waypoint&) const = default;
};

/// The waypoints of one map. `notes`: warnings about them.
struct WaypointList {
  std::vector<Waypoint> points;
  std::vector<Fault> notes;
};

// Swapping names: one waypoint gets a temporary name, "Dock ~1", until the wanted name is free. If the swap
// is interrupted the name stays on the robot, and is recognized by its form.

/// "Dock ~2"; counts from 1.
std::string temporaryName(std::string_view name, int number);
/// "Dock" for "Dock ~2" and "Dock ~1 ~2"; empty = not a temporary name.
std::string_view permanentName(std::string_view temporary);
/// Whether `name` is a temporary name for `permanent`.
bool isTemporaryFor(std::string_view name, std::string_view permanent);

// Numbers sent to a robot or written to a file come back slightly different (a heading as a quaternion,
// truncated decimals): the one tolerance for all comparisons.

inline constexpr double kSameM = 1e-4, kSameRad = 1e-4;

bool samePlace(const Eigen::Vector2d& a_m, const Eigen::Vector2d& b_m);
/// Radians, modulo full turns.
bool sameHeading(double a_rad, double b_rad);
/// No heading differs from any heading.
bool sameHeading(const std::optional<double>& a_rad, const std::optional<double>& b_rad);

}  // namespace mapwright::map
