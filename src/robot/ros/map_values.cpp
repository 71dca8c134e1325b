#include "robot/ros/map_values.h"

#include <memory>
#include <utility>

namespace mapwright::robot::ros {
namespace {

constexpr std::uint8_t kUnknownByte = 255;  // Mode::Raw takes all above 100 for unknown

std::uint8_t byteOf(std::int8_t cell) { return cell >= 0 && cell <= 100 ? std::uint8_t(cell) : kUnknownByte; }

}  // namespace

std::string pgmOf(const Grid& grid) {
  const std::size_t width = std::size_t(grid.width), height = std::size_t(grid.height);
  if (grid.width < 1 || grid.height < 1 || grid.cells.size() / width < height) return {};
  std::string pgm = "P5\n" + std::to_string(grid.width) + ' ' + std::to_string(grid.height) + "\n255\n";
  pgm.reserve(pgm.size() + width * height);
  for (std::size_t row = height; row-- > 0;) {
    const std::int8_t* const cells = grid.cells.data() + row * width;
    for (std::size_t column = 0; column < width; ++column) pgm.push_back(char(byteOf(cells[column])));
  }
  return pgm;
}

map::GridMessage gridMessage(const Grid& grid, const std::string& topic, map::GridKind kind,
                             const Transform3& in_map) {
  map::GridMessage message;
  message.topic = topic;
  message.kind = kind;
  message.grid = {grid.width, grid.height, grid.resolution_m, in_map.flat() * grid.origin};
  message.reading = kPgmReading;
  message.png = std::make_shared<const std::string>(pgmOf(grid));
  return message;
}

geometry::Pose2 placedIn(const Placed& placed, const Transform3& in_map) {
  return in_map.flat() * placed.pose;
}

map::Polyline placedIn(const Outline& outline, const Transform3& in_map) {
  map::Polyline placed;
  placed.reserve(outline.points.size());
  for (const Eigen::Vector2d& point : outline.points)
    placed.push_back(in_map.apply({point.x(), point.y(), 0}).head<2>());
  return placed;
}

map::PointCloudMessage placedIn(const Points& points, const std::string& topic, const Transform3& in_map) {
  auto placed = std::make_shared<std::vector<map::CloudPoint>>(points.points);
  const Eigen::Matrix3d turn = in_map.q.toRotationMatrix();
  for (map::CloudPoint& point : *placed) {
    const Eigen::Vector3d at = turn * Eigen::Vector3d(point.x_m, point.y_m, double(point.z_m)) + in_map.t_m;
    point.x_m = at.x();
    point.y_m = at.y();
    point.z_m = float(at.z());
  }
  return {topic, std::move(placed)};
}

std::optional<map::GroundBox> boxOf(const Marker& marker, const Transform3& in_map) {
  using Kind = Marker::Kind;
  if (marker.kind != Kind::Cube && marker.kind != Kind::Sphere && marker.kind != Kind::Cylinder)
    return std::nullopt;
  map::GroundBox box;
  box.label = marker.text;
  if (box.label.empty()) box.label = (marker.ns.empty() ? "" : marker.ns + ' ') + std::to_string(marker.id);
  box.pose = (in_map * marker.pose).flat();
  box.length_m = marker.scale_m.x();
  box.width_m = marker.scale_m.y();
  return box;
}

std::vector<map::Polyline> linesOf(const Marker& marker, const Transform3& in_map) {
  using Kind = Marker::Kind;
  const Transform3 placed = in_map * marker.pose;
  const auto at = [&placed](const Eigen::Vector3d& point) -> Eigen::Vector2d {
    return placed.apply(point).head<2>();
  };
  std::vector<map::Polyline> lines;
  if (marker.kind == Kind::Arrow) {
    // Either two points say where it begins and ends, or it lies along x, as long as its scale says.
    const bool by_points = marker.points.size() == 2;
    const Eigen::Vector3d tail = by_points ? marker.points[0] : Eigen::Vector3d(0, 0, 0);
    const Eigen::Vector3d tip = by_points ? marker.points[1] : Eigen::Vector3d(marker.scale_m.x(), 0, 0);
    lines.push_back({at(tail), at(tip)});
  } else if (marker.kind == Kind::LineStrip && marker.points.size() > 1) {
    map::Polyline line;
    for (const Eigen::Vector3d& point : marker.points) line.push_back(at(point));
    lines.push_back(std::move(line));
  } else if (marker.kind == Kind::LineList) {
    for (std::size_t i = 0; i + 1 < marker.points.size(); i += 2)
      lines.push_back({at(marker.points[i]), at(marker.points[i + 1])});
  }
  return lines;
}

}  // namespace mapwright::robot::ros
