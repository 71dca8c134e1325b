#include "robot/ros/map_values.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace mapwright::robot::ros {
namespace {

constexpr double kMeshM = 0.2;              // the edge of the spot that stands for one
constexpr std::uint8_t kUnknownByte = 255;  // Mode::Raw treats everything above 100 as unknown

/// A completely transparent colour means that none was set.
std::optional<std::uint32_t> seen(std::uint32_t rgba) {
  return (rgba & 255) != 0 ? std::optional(rgba) : std::nullopt;
}

/// A line with the two barbs of its tip.
map::Polyline arrow(const Eigen::Vector2d& tail, const Eigen::Vector2d& tip) {
  const Eigen::Vector2d back = (tail - tip) * 0.25;
  const Eigen::Vector2d aside(-back.y() * 0.6, back.x() * 0.6);
  return {tail, tip, tip + back + aside, tip, tip + back - aside};
}

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

std::vector<geometry::Pose2> placedIn(const Poses& poses, const Transform3& in_map) {
  std::vector<geometry::Pose2> placed;
  for (const geometry::Pose2& pose : poses.poses) placed.push_back(in_map.flat() * pose);
  return placed;
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

map::PointCloudMessage placedAlong(const Points& points, const std::string& topic,
                                   const std::vector<Transform3>& along) {
  if (along.size() < 2 || points.when.size() != points.points.size())
    return placedIn(points, topic, along.front());
  auto placed = std::make_shared<std::vector<map::CloudPoint>>(points.points);
  const double steps = double(along.size() - 1);
  for (std::size_t i = 0; i < placed->size(); ++i) {
    map::CloudPoint& point = (*placed)[i];
    const double position = std::clamp(double(points.when[i]), 0.0, 1.0) * steps;
    const std::size_t step = std::min(std::size_t(position), along.size() - 2);
    const Transform3 in_map = between(along[step], along[step + 1], position - double(step));
    const Eigen::Vector3d at = in_map.apply({point.x_m, point.y_m, double(point.z_m)});
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
  box.rgba = seen(marker.rgba);
  return box;
}

std::optional<map::GroundDrawing> drawingOf(const Marker& marker, const Transform3& in_map) {
  using Kind = Marker::Kind;
  using Drawn = map::GroundDrawing::Kind;
  const Transform3 placed = in_map * marker.pose;
  const auto at = [&placed](const Eigen::Vector3d& point) -> Eigen::Vector2d {
    return placed.apply(point).head<2>();
  };
  map::GroundDrawing drawing;
  drawing.size_m = marker.scale_m.x();
  drawing.rgba = seen(marker.rgba);
  const auto readPoints = [&](Drawn kind, std::size_t group) {
    drawing.kind = kind;
    const std::size_t count = marker.points.size() / group * group;
    for (std::size_t i = 0; i < count; ++i) drawing.points.push_back(at(marker.points[i]));
    if (marker.colors.size() >= count)
      drawing.colors.assign(marker.colors.begin(), marker.colors.begin() + std::ptrdiff_t(count));
  };
  switch (marker.kind) {
    case Kind::Arrow: {
      // Either two points give its ends, or it is along x with the length of its scale.
      const bool by_points = marker.points.size() == 2;
      const Eigen::Vector3d tail = by_points ? marker.points[0] : Eigen::Vector3d(0, 0, 0);
      const Eigen::Vector3d tip = by_points ? marker.points[1] : Eigen::Vector3d(marker.scale_m.x(), 0, 0);
      drawing.size_m = by_points ? marker.scale_m.x() : marker.scale_m.y();
      drawing.points = arrow(at(tail), at(tip));
      break;
    }
    case Kind::LineStrip:
      readPoints(Drawn::Line, 1);
      break;
    case Kind::LineList:
      readPoints(Drawn::Segments, 2);
      break;
    case Kind::Triangles:
      readPoints(Drawn::Triangles, 3);
      break;
    case Kind::Points:
    case Kind::CubeList:
    case Kind::SphereList:
      readPoints(Drawn::Points, 1);
      break;
    case Kind::Text:
      drawing.kind = Drawn::Text;
      drawing.text = marker.text;
      drawing.size_m = marker.scale_m.z();
      if (!marker.text.empty()) drawing.points = {at({0, 0, 0})};
      break;
    case Kind::Mesh:
      // Its size is in a file that is not read.
      drawing.kind = Drawn::Points;
      drawing.size_m = kMeshM;
      drawing.points = {at({0, 0, 0})};
      break;
    case Kind::Cube:
    case Kind::Sphere:
    case Kind::Cylinder:
    case Kind::Other:
      break;
  }
  if (drawing.points.empty() || (drawing.kind == Drawn::Line && drawing.points.size() < 2))
    return std::nullopt;
  return drawing;
}

}  // namespace mapwright::robot::ros
