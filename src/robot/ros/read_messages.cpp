#include "robot/ros/read_messages.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>

#include "grids/faults.h"
#include "robot/ros/faults.h"
#include "robot/ros/parts.h"

namespace mapwright::robot::ros {
namespace {

/// Cells that are not bytes need eight times the memory while they are read.
constexpr std::size_t kMostOddCells = std::size_t(1) << 25;
constexpr std::int8_t kUnknown = -1, kOccupied = 100;

constexpr std::int64_t kMostCells = std::int64_t(1) << 28;  // a rosbridge frame cannot hold more

constexpr std::size_t kMostTransforms = 10'000;

Read<Placed> placedBy(const Field& msg, const Field& pose, const std::string& name) {
  const PoseRead read = poseOf(pose);
  if (!std::isfinite(read.pose.t_m.x())) return fieldMissing(name + ".position.x");
  if (!std::isfinite(read.pose.t_m.y())) return fieldMissing(name + ".position.y");
  Placed placed;
  placed.header = headerOf(msg);
  placed.pose = read.pose.flat();
  placed.upright = read.upright;
  return placed;
}

template <class PointAt>
Outline outlineOf(const Field& msg, const Field& list, const PointAt& point_at) {
  Outline outline;
  outline.header = headerOf(msg);
  const std::size_t stride = strideFor(list.size(), kMostOutlinePoints);
  std::size_t index = 0;
  list.each([&](const Field& item) {
    if (index++ % stride != 0) return;
    const Eigen::Vector2d point = pointOf(point_at(item)).template head<2>();
    if (point.allFinite()) {
      outline.points.push_back(point);
    } else {
      ++outline.left_out;
    }
  });
  return outline;
}

constexpr std::size_t kMostMarkers = 20'000;
constexpr std::size_t kMostMarkerPoints = 100'000;
constexpr std::size_t kMostPointsOfAll = 500'000;

/// By their numbers. A chain of arrows (12, newer ROS 2) is a line.
constexpr Marker::Kind kMarkerKinds[] = {
    Marker::Kind::Arrow,     Marker::Kind::Cube,     Marker::Kind::Sphere,   Marker::Kind::Cylinder,
    Marker::Kind::LineStrip, Marker::Kind::LineList, Marker::Kind::CubeList, Marker::Kind::SphereList,
    Marker::Kind::Points,    Marker::Kind::Text,     Marker::Kind::Mesh,     Marker::Kind::Triangles,
    Marker::Kind::LineStrip};
Marker::Kind markerKindOf(std::int64_t type) {
  const bool known = type >= 0 && type < std::int64_t(std::size(kMarkerKinds));
  return known ? kMarkerKinds[type] : Marker::Kind::Other;
}

/// 1 has no meaning.
std::optional<Marker::Action> actionOf(std::int64_t action) {
  if (action == 0) return Marker::Action::Add;
  if (action == 2) return Marker::Action::Delete;
  if (action == 3) return Marker::Action::DeleteAll;
  return std::nullopt;
}

std::uint32_t rgbaOf(const Field& color) {
  std::uint32_t rgba = 0;
  for (const char* const channel : {"r", "g", "b", "a"}) {
    const double level = std::clamp(numberOr(color[channel], 1), 0.0, 1.0);
    rgba = rgba << 8 | std::uint32_t(std::lround(level * 255));
  }
  return rgba;
}

/// At most `most` points, with their colours if there are as many.
void readPoints(const Field& field, std::size_t most, Marker& marker) {
  std::vector<bool> taken;
  field["points"].each([&](const Field& item) {
    if (marker.points.size() >= most) return;
    Eigen::Vector3d point = pointOf(item);
    if (std::isnan(point.z())) point.z() = 0;
    taken.push_back(point.allFinite());
    if (taken.back()) marker.points.push_back(point);
  });
  const Field colors = field["colors"];
  if (colors.size() < taken.size() || taken.empty()) return;
  std::size_t at = 0;
  colors.each([&](const Field& item) {
    if (at < taken.size() && taken[at]) marker.colors.push_back(rgbaOf(item));
    ++at;
  });
}

std::optional<Marker> markerOf(const Field& field, std::size_t most_points) {
  const auto action = actionOf(field["action"].integer().value_or(0));
  if (!action) return std::nullopt;
  const PoseRead pose = poseOf(field["pose"]);
  Marker marker;
  marker.header = headerOf(field);
  marker.ns = field["ns"].text();
  marker.id = field["id"].integer().value_or(0);
  marker.action = *action;
  if (*action != Marker::Action::Add) return marker;
  if (!pose.pose.t_m.allFinite()) return std::nullopt;
  marker.kind = markerKindOf(field["type"].integer().value_or(-1));
  marker.pose = pose.pose;
  marker.upright = pose.upright;
  const Eigen::Vector3d scale = pointOf(field["scale"]);
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    marker.scale_m[axis] = std::isfinite(scale[axis]) ? std::abs(scale[axis]) : 0;
  marker.rgba = rgbaOf(field["color"]);
  marker.text = field[marker.kind == Marker::Kind::Mesh ? "mesh_resource" : "text"].text();
  marker.lifetime_s = std::max(0.0, field["lifetime"].time().value_or(0));
  marker.frame_locked = field["frame_locked"].flag().value_or(false);
  readPoints(field, most_points, marker);
  return marker;
}

using Cells = std::vector<std::int8_t>;

/// width * height cells, -1 or 0..100; the caller checks the product. Others are noted.
Read<Cells> readCells(const Field& data, std::int64_t width, std::int64_t height, OddCells odd,
                      std::vector<Fault>& notes) {
  const std::size_t needed = std::size_t(width * height);
  // With a wrong length, cells would be at wrong positions. Servers may send an empty list as a text.
  const bool none = needed == 0 && (data.isNull() || data.isText());
  if (none) return Cells{};
  if (!data.isList()) return fieldMissing("data");
  if (data.size() != needed) {
    return tl::unexpected(
        Fault(fault::RosLengthDiffers, {"data", std::int64_t(data.size()), std::int64_t(needed)}));
  }
  std::size_t odd_cells = 0;
  const auto instead = [&](bool above) {
    const bool shown = above && odd == OddCells::Nearest;
    odd_cells += !shown;
    return shown ? kOccupied : kUnknown;
  };
  Cells cells;
  if (auto bytes = data.int8s(needed)) {
    cells = std::move(*bytes);
    for (std::int8_t& cell : cells) {
      if (cell < kUnknown || cell > kOccupied) cell = instead(cell > kOccupied);
    }
  } else {
    const auto numbers = data.numbers(kMostOddCells);
    if (!numbers || numbers->size() != needed) return fieldMissing("data");
    cells.reserve(needed);
    for (const double value : *numbers) {
      const bool whole = value >= kUnknown && value <= kOccupied && value == std::floor(value);
      cells.push_back(whole ? std::int8_t(value) : instead(value > kOccupied));
    }
  }
  if (odd_cells > 0) notes.push_back({grids::fault::RosCellsOutOfRange, {std::int64_t(odd_cells)}});
  return cells;
}

}  // namespace

Header headerOf(const Field& msg) {
  const Field header = msg["header"];
  Header read;
  read.frame = frameName(header["frame_id"].text());
  read.stamp_s = header["stamp"].time();
  if (read.stamp_s == 0.0) read.stamp_s.reset();
  return read;
}

tl::unexpected<Fault> fieldMissing(std::string name) {
  return tl::unexpected(Fault(fault::RosFieldMissing, {std::move(name)}));
}

tl::unexpected<Fault> fieldWrong(std::string name, double value) {
  return tl::unexpected(Fault(fault::RosFieldWrong, {std::move(name), value}));
}

double numberOr(const Field& field, double fallback) { return field.number().value_or(fallback); }

Eigen::Vector3d pointOf(const Field& field) {
  return {numberOr(field["x"], kNaN), numberOr(field["y"], kNaN), numberOr(field["z"], kNaN)};
}

Eigen::Quaterniond quaternionOf(const Field& field) {
  const Eigen::Quaterniond q(numberOr(field["w"], kNaN), numberOr(field["x"], kNaN),
                             numberOr(field["y"], kNaN), numberOr(field["z"], kNaN));
  return q.coeffs().allFinite() ? q : Eigen::Quaterniond(0, 0, 0, 0);
}

PoseRead poseOf(const Field& field) {
  PoseRead read;
  read.pose.t_m = pointOf(field["position"]);
  if (std::isnan(read.pose.t_m.z())) read.pose.t_m.z() = 0;  // irrelevant in the plane
  const Eigen::Quaterniond q = quaternionOf(field["orientation"]);
  const double length = q.norm();
  read.upright = !std::isfinite(length) || length < kShortestQuaternion;
  if (!read.upright) read.pose.q = Eigen::Quaterniond(q.coeffs() / length);
  return read;
}

Read<GridSize> readGridSize(const Field& of, const std::string& prefix, std::int64_t most, EmptyGrids empty) {
  const auto width = of["width"].integer(), height = of["height"].integer();
  if (!width) return fieldMissing(prefix + "width");
  if (!height) return fieldMissing(prefix + "height");
  if (*width < 0 || *width > most) return fieldWrong(prefix + "width", double(*width));
  if (*height < 0 || *height > most) return fieldWrong(prefix + "height", double(*height));
  if (*width == 0 || *height == 0) {
    if (empty == EmptyGrids::Taken) return GridSize{0, 0};
    return tl::unexpected(Fault(fault::RosGridEmpty, {*width, *height}));
  }
  if (*height > most / *width) return fieldWrong(prefix + "height", double(*height));
  return GridSize{*width, *height};
}

double resolutionOf(const Field& info) {
  const double sent = numberOr(info["resolution"], std::numeric_limits<double>::quiet_NaN());
  const auto single = static_cast<float>(sent);
  if (!std::isfinite(single) || double(single) != sent) return sent;
  std::array<char, 32> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), single);
  double shortest = sent;
  std::from_chars(text.data(), written.ptr, shortest);
  return shortest;
}

Read<Grid> readGridOf(const Field& msg, std::int64_t most_cells, EmptyGrids empty, OddCells odd) {
  const Field info = msg["info"];
  if (!info.isObject()) return fieldMissing("info");
  const auto size = readGridSize(info, "info.", most_cells, empty);
  if (!size) return tl::unexpected(size.error());
  const PoseRead origin = poseOf(info["origin"]);
  Grid grid;
  grid.header = headerOf(msg);
  grid.width = int(size->width);
  grid.height = int(size->height);
  grid.resolution_m = resolutionOf(info);
  grid.origin = origin.pose.flat();
  const auto why = map::unusableReason({grid.width, grid.height, grid.resolution_m, grid.origin});
  if (size->width == 0) {
    // An empty grid needs no position: many senders omit it then.
    if (why) grid.resolution_m = 0;
    if (why) grid.origin = {};
    return grid;
  }
  if (why) return tl::unexpected(*why);
  if (origin.upright) grid.notes.push_back(fault::RosTurnIsZero);
  auto cells = readCells(msg["data"], size->width, size->height, odd, grid.notes);
  if (!cells) return tl::unexpected(cells.error());
  grid.cells = std::move(*cells);
  return grid;
}

namespace {

/// A cost of Nav2 as the percentage that its own topics of grids publish. Source: nav2_costmap_2d,
/// costmap_2d_publisher.cpp (cost_translation_table).
std::int8_t percentOf(std::uint8_t cost) {
  constexpr int kMostPassable = 252, kInscribed = 253, kLethal = 254;
  if (cost == 0) return 0;
  if (cost <= kMostPassable) return std::int8_t(1 + 97 * (cost - 1) / (kMostPassable - 1));
  return cost == kInscribed ? std::int8_t(99) : cost == kLethal ? kOccupied : kUnknown;
}

/// nav2_msgs/Costmap.
Read<Grid> readCostmap(const Field& msg) {
  const Field info = msg["metadata"];
  const auto width = info["size_x"].integer(), height = info["size_y"].integer();
  if (!width || *width < 0 || *width > kMostCells) return fieldMissing("metadata.size_x");
  if (!height || *height < 0 || *height > kMostCells) return fieldMissing("metadata.size_y");
  if (*width == 0 || *height == 0) return tl::unexpected(Fault(fault::RosGridEmpty, {*width, *height}));
  if (*height > kMostCells / *width) return fieldWrong("metadata.size_y", double(*height));
  const PoseRead origin = poseOf(info["origin"]);
  Grid grid;
  grid.header = headerOf(msg);
  grid.width = int(*width);
  grid.height = int(*height);
  grid.resolution_m = resolutionOf(info);
  grid.origin = origin.pose.flat();
  if (const auto why = map::unusableReason({grid.width, grid.height, grid.resolution_m, grid.origin}))
    return tl::unexpected(*why);
  if (origin.upright) grid.notes.push_back(fault::RosTurnIsZero);
  const auto needed = std::size_t(*width * *height);
  const auto costs = msg["data"].bytes(needed);
  if (!costs) return fieldMissing("data");
  if (costs->size() != needed)
    return tl::unexpected(
        Fault(fault::RosLengthDiffers, {"data", std::int64_t(costs->size()), std::int64_t(needed)}));
  grid.cells.reserve(needed);
  for (const char cost : *costs) grid.cells.push_back(percentOf(std::uint8_t(cost)));
  return grid;
}

}  // namespace

Read<Grid> readGrid(const Field& whole) {
  if (whole["metadata"].isObject() && !whole["info"].isObject()) return readCostmap(whole);
  const Field msg = whole["info"].isObject() || !whole["map"].isObject() ? whole : whole["map"];
  return readGridOf(msg, kMostCells, EmptyGrids::Refused, OddCells::Unknown);
}

Read<GridPatch> readGridPatch(const Field& msg) {
  constexpr auto kFits = [](std::int64_t value) { return std::abs(value) <= kMostCells; };
  const auto x = msg["x"].integer(), y = msg["y"].integer();
  if (!x) return fieldMissing("x");
  if (!y) return fieldMissing("y");
  if (!kFits(*x)) return fieldWrong("x", double(*x));
  if (!kFits(*y)) return fieldWrong("y", double(*y));
  const auto size = readGridSize(msg, {}, kMostCells, EmptyGrids::Refused);
  if (!size) return tl::unexpected(size.error());
  GridPatch patch;
  auto cells = readCells(msg["data"], size->width, size->height, OddCells::Unknown, patch.notes);
  if (!cells) return tl::unexpected(cells.error());
  patch.header = headerOf(msg);
  patch.x = int(*x);
  patch.y = int(*y);
  patch.width = int(size->width);
  patch.height = int(size->height);
  patch.cells = std::move(*cells);
  return patch;
}

std::optional<Fault> applyPatch(Grid& grid, const GridPatch& patch) {
  const bool lies_in = patch.x >= 0 && patch.y >= 0 && patch.width > 0 && patch.height > 0 &&
                       patch.width <= grid.width - patch.x && patch.height <= grid.height - patch.y;
  const bool whole = patch.cells.size() == std::size_t(std::int64_t(patch.width) * patch.height) &&
                     grid.cells.size() == std::size_t(std::int64_t(grid.width) * grid.height);
  if (!lies_in || !whole) {
    return Fault(fault::RosPatchOutside,
                 {patch.width, patch.height, patch.x, patch.y, grid.width, grid.height});
  }
  for (int row = 0; row < patch.height; ++row) {
    std::copy_n(patch.cells.begin() + std::ptrdiff_t(row) * patch.width, patch.width,
                grid.cells.begin() + std::ptrdiff_t(patch.y + row) * grid.width + patch.x);
  }
  return std::nullopt;
}

Read<Outline> readPath(const Field& msg) {
  const Field poses = msg["poses"];
  if (!poses.isList()) return fieldMissing("poses");
  Outline path = outlineOf(msg, poses, [](const Field& item) { return item["pose"]["position"]; });
  if (!path.header.frame.empty()) return path;
  bool first = true;
  poses.each([&](const Field& item) {
    if (std::exchange(first, false)) path.header.frame = headerOf(item).frame;
  });
  return path;
}

Read<Outline> readPolygon(const Field& msg) {
  const Field points = msg["polygon"]["points"];
  if (!points.isList()) return fieldMissing("polygon.points");
  return outlineOf(msg, points, [](const Field& item) { return item; });
}

Read<Placed> readPoseStamped(const Field& msg) { return placedBy(msg, msg["pose"], "pose"); }

Read<Placed> readPoseWithCovariance(const Field& msg) {
  return placedBy(msg, msg["pose"]["pose"], "pose.pose");
}

Read<Placed> readOdometry(const Field& msg) {
  return readPoseWithCovariance(msg).map([&](Placed placed) {
    placed.child_frame = frameName(msg["child_frame_id"].text());
    return placed;
  });
}

Read<Poses> readPoseArray(const Field& msg) {
  const Field list = msg["poses"];
  if (!list.isList()) return fieldMissing("poses");
  Poses all;
  all.header = headerOf(msg);
  const std::size_t stride = strideFor(list.size(), kMostPoses);
  std::size_t index = 0;
  list.each([&](const Field& item) {
    if (index++ % stride != 0) return;
    const geometry::Pose2 pose = poseOf(item).pose.flat();
    if (std::isfinite(pose.x_m) && std::isfinite(pose.y_m)) all.poses.push_back(pose);
  });
  return all;
}

std::vector<TfRow> readTf(const Field& msg) {
  std::vector<TfRow> rows;
  msg["transforms"].each([&rows](const Field& item) {
    if (rows.size() >= kMostTransforms) return;
    const Header header = headerOf(item);
    TfRow row;
    row.parent = header.frame;
    row.child = frameName(item["child_frame_id"].text());
    if (row.parent.empty() || row.child.empty()) return;
    row.transform = {pointOf(item["transform"]["translation"]), quaternionOf(item["transform"]["rotation"])};
    row.stamp_s = header.stamp_s.value_or(0);
    rows.push_back(std::move(row));
  });
  return rows;
}

std::string plainType(std::string_view type) {
  const std::size_t package = type.find('/'), name = type.rfind('/');
  if (package == std::string_view::npos || package == name) return std::string(type);
  return std::string(type.substr(0, package)).append(type.substr(name));
}

Read<std::vector<Marker>> readMarkers(const Field& msg, std::int64_t* left_out) {
  std::vector<Marker> markers;
  std::size_t points = 0;
  const auto addMarker = [&](const Field& field) {
    const bool room = markers.size() < kMostMarkers;
    auto marker =
        room ? markerOf(field, std::min(kMostMarkerPoints, kMostPointsOfAll - points)) : std::nullopt;
    const bool adds = marker && marker->action == Marker::Action::Add;
    if (left_out && (!marker || (adds && marker->points.size() < field["points"].size()))) ++*left_out;
    if (!marker) return;
    points += marker->points.size();
    markers.push_back(std::move(*marker));
  };
  const Field list = msg["markers"];
  if (list.isList()) {
    list.each(addMarker);
  } else if (msg["type"].isNumber()) {
    addMarker(msg);
  } else {
    return fieldMissing("markers");
  }
  return markers;
}

}  // namespace mapwright::robot::ros
