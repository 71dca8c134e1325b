// Overlay features as the map draws them (read only). Source: docs/protocols/autoxing.md, "Overlays".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fault/fault.h"

namespace mapwright::map {

enum class OverlayShape { Point, Line, Polygon };

/// One feature in world metres. `type` is the number of properties.type (points), lineType or regionType; 0 =
/// none given or unknown. Names are untrusted plain text.
struct OverlayFeature {
  OverlayShape shape = OverlayShape::Point;
  int type = 0;
  std::string id, name;
  std::optional<double> yaw_rad;  // points that have a heading
  std::vector<std::vector<Eigen::Vector2d>>
      parts;  // point: one with one element; line: one; polygon: its rings
  bool operator==(const OverlayFeature&) const = default;
};

/// A feature that cannot be read. `at_m`: one of its points, if any of them can be.
struct BrokenOverlay {
  std::string id, name;
  Fault reason;
  std::optional<Eigen::Vector2d> at_m;
  bool operator==(const BrokenOverlay&) const = default;
};

}  // namespace mapwright::map
