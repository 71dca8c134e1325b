// Occupancy and costs as ROS sends them: row 0 at the bottom, -1 unknown, 0 free, 100 occupied.
#include <algorithm>
#include <cmath>

#include "simulator/ros/ros_messages.h"
#include "simulator/ros/shapes.h"

namespace mapwright::simulator::ros {
namespace {

constexpr std::int8_t kUnknown = -1, kFree = 0, kOccupied = 100;

std::int8_t cellOf(FloorCell cell) {
  return cell == FloorCell::Unknown ? kUnknown : cell == FloorCell::Free ? kFree : kOccupied;
}

/// As map_server reads shades: dark is occupied, light is free.
std::int8_t cellOf(std::uint8_t shade) {
  const double occupied = (255 - shade) / 255.0;
  return occupied > 0.65 ? kOccupied : occupied < 0.196 ? kFree : kUnknown;
}

/// As costmap_2d publishes its costs.
std::int8_t cellOfCost(std::uint8_t cost) {
  if (cost == 0) return kFree;
  if (cost >= 254) return kOccupied;
  if (cost == 253) return 99;
  return static_cast<std::int8_t>(1 + (97 * (cost - 1)) / 251);
}

/// Calls take(from, to) for every cell: the same row at the top in one, at the bottom in the other.
template <typename Take>
void upsideDown(int width, int height, const Take& take) {
  const auto columns = static_cast<std::size_t>(width), rows = static_cast<std::size_t>(height);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t u = 0; u < columns; ++u) take((rows - 1 - row) * columns + u, row * columns + u);
  }
}

}  // namespace

OccupancyCells occupancyOf(const FloorCells& floor, const GrayPicture* image) {
  OccupancyCells grid;
  grid.place = {floor.width, floor.height, floor.resolution_m, floor.origin_m};
  grid.cells.resize(floor.cells.size());
  upsideDown(floor.width, floor.height, [&](std::size_t from, std::size_t to) {
    grid.cells[to] = image != nullptr ? cellOf(image->levels[from]) : cellOf(floor.cells[from]);
  });
  return grid;
}

OccupancyCells occupancyOf(const GrayPicture& costs, const GridPlace& place) {
  OccupancyCells grid;
  grid.place = place;
  grid.cells.resize(costs.levels.size());
  upsideDown(costs.width, costs.height,
             [&](std::size_t from, std::size_t to) { grid.cells[to] = cellOfCost(costs.levels[from]); });
  return grid;
}

Value gridMessage(const Moment& moment, std::string_view frame, OccupancyCells grid) {
  const geometry::Pose2 corner{grid.place.origin_m.x(), grid.place.origin_m.y(), 0};
  const Value info = Value::Object{{"map_load_time", timeOf(0, moment.dialect())},
                                   {"resolution", float32(grid.place.resolution_m)},
                                   {"width", grid.place.width},
                                   {"height", grid.place.height},
                                   {"origin", poseOf(corner)}};
  return Value::Object{{"header", headerOf(frame, moment.time_s, moment.dialect())},
                       {"info", info},
                       {"data", std::move(grid.cells)}};
}

Value gridPatchMessage(const Moment& moment, std::string_view frame, const OccupancyCells& of,
                       const Eigen::Vector2d& around_m, double reach_m) {
  const Eigen::Vector2d middle = (around_m - of.place.origin_m) / of.place.resolution_m;
  const double reach = reach_m / of.place.resolution_m;
  const auto clamped = [](double at, int most) {
    return static_cast<int>(std::clamp(std::floor(at), 0.0, 1.0 * most));
  };
  const int u0 = clamped(middle.x() - reach, of.place.width),
            u1 = clamped(middle.x() + reach, of.place.width);
  const int v0 = clamped(middle.y() - reach, of.place.height),
            v1 = clamped(middle.y() + reach, of.place.height);
  if (u1 <= u0 || v1 <= v0) return {};
  Value::Int8s cells;
  for (int v = v0; v < v1; ++v) {
    const auto row = of.cells.begin() + static_cast<std::ptrdiff_t>(v) * of.place.width;
    cells.insert(cells.end(), row + u0, row + u1);
  }
  return Value::Object{{"header", headerOf(frame, moment.time_s, moment.dialect())},
                       {"x", u0},
                       {"y", v0},
                       {"width", u1 - u0},
                       {"height", v1 - v0},
                       {"data", std::move(cells)}};
}

}  // namespace mapwright::simulator::ros
