// Overlay features as the map draws them (read only). Source: docs/protocols/autoxing.md, "Overlays".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

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

}  // namespace mapwright::map
