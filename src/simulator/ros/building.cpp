#include "simulator/ros/building.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "simulator/noise.h"

namespace mapwright::simulator::ros {
namespace {

constexpr double kRoomM = 12.5, kWallM = 0.1, kDoorM = 1.2;  // walls: half of their thickness
constexpr std::array<std::uint32_t, Building::kStoreys> kColors{0xd04040, 0xd0a030, 0x40b050, 0x3080d0,
                                                                0x9050c0};

std::int64_t whole(double value) { return static_cast<std::int64_t>(std::floor(value)); }

/// The wall line nearest to a coordinate: its number and how far it is.
struct WallLine {
  std::int64_t number;
  double off_m;
};
WallLine lineNear(double at_m) {
  const double number = std::round(at_m / kRoomM);
  return {static_cast<std::int64_t>(number), std::abs(at_m - number * kRoomM)};
}

struct Columns {
  std::int64_t from_x, to_x, from_y, to_y;  // the end is not in it
  int from_storey, to_storey;               // is in it
  double count() const {
    if (to_x <= from_x || to_y <= from_y || to_storey < from_storey) return 0;
    return double(to_x - from_x) * double(to_y - from_y) * (to_storey - from_storey + 1);
  }
};
Columns columnsIn(double edge_m, const Eigen::Vector3d& low_m, const Eigen::Vector3d& high_m) {
  const double half = std::floor(edge_m / 2);
  const auto from = [&](double at) { return whole(std::clamp(at, -half, edge_m - half)); };
  const auto to = [&](double at) {
    return static_cast<std::int64_t>(std::ceil(std::clamp(at, -half, edge_m - half)));
  };
  const auto storey = [](double z) {
    return static_cast<int>(std::clamp(std::floor(z / Building::kStoreyM), -1.0, Building::kStoreys * 1.0));
  };
  Columns columns{from(low_m.x()),
                  to(high_m.x()),
                  from(low_m.y()),
                  to(high_m.y()),
                  std::max(0, storey(low_m.z())),
                  std::min(Building::kStoreys - 1, storey(high_m.z()))};
  return columns;
}

}  // namespace

bool Building::wallAt(double x_m, double y_m, int storey) const {
  const auto solid = [&](double across, double along, int side) {
    const WallLine line = lineNear(across);
    if (line.off_m > kWallM) return false;
    const std::int64_t room = whole(along / kRoomM);
    const std::uint64_t lot = hashOf(seed_, 7, line.number, room, storey, side);
    if (lot % 13 == 0) return false;  // two rooms are one
    const double door = (double(room) + 0.15 + 0.6 * unitFrom(lot)) * kRoomM;
    return along < door || along > door + kDoorM;
  };
  if (solid(x_m, y_m, 0) || solid(y_m, x_m, 1)) return true;
  // A pillar or a cupboard in every third room.
  const std::int64_t column = whole(x_m / kRoomM), row = whole(y_m / kRoomM);
  const std::uint64_t lot = hashOf(seed_, 8, column, row, storey);
  if (lot % 3 != 0) return false;
  const double at_x = (double(column) + 0.2 + 0.5 * unitFrom(mix(lot))) * kRoomM,
               at_y = (double(row) + 0.2 + 0.5 * unitFrom(mix(lot + 1))) * kRoomM;
  return x_m >= at_x && x_m < at_x + 1.4 && y_m >= at_y && y_m < at_y + 0.8;
}

std::int8_t Building::cellAt(double x_m, double y_m, double from_z_m, double to_z_m) const {
  const double half = std::floor(edge_m_ / 2);
  if (x_m < -half || y_m < -half || x_m >= edge_m_ - half || y_m >= edge_m_ - half) return -1;
  // Outside the outer wall, and some rooms, nobody has been.
  const double reach = edge_m_ / 2 - 0.5;
  const double off = std::hypot(x_m, y_m);
  if (off > reach) return -1;
  if (off > reach - 0.3) return 100;
  if (hashOf(seed_, 9, whole(x_m / kRoomM), whole(y_m / kRoomM)) % 17 == 0) return -1;
  const int from =
      std::clamp(static_cast<int>(std::floor(std::clamp(from_z_m, -1e3, 1e3) / kStoreyM)), 0, kStoreys - 1);
  const int to =
      std::clamp(static_cast<int>(std::floor(std::clamp(to_z_m, -1e3, 1e3) / kStoreyM)), 0, kStoreys - 1);
  for (int storey = from; storey <= to; ++storey) {
    if (wallAt(x_m, y_m, storey)) return 100;
  }
  return 0;
}

double Building::countNear(const Eigen::Vector3d& low_m, const Eigen::Vector3d& high_m) const {
  return columnsIn(edge_m_, low_m, high_m).count() * (kPointsPerColumn / kStoreys);
}

void Building::pointsNear(const Eigen::Vector3d& low_m, const Eigen::Vector3d& high_m,
                          const std::function<void(const Point&)>& take) const {
  constexpr int kEach = kPointsPerColumn / kStoreys;
  const Columns columns = columnsIn(edge_m_, low_m, high_m);
  for (std::int64_t y = columns.from_y; y < columns.to_y; ++y) {
    for (std::int64_t x = columns.from_x; x < columns.to_x; ++x) {
      for (int storey = columns.from_storey; storey <= columns.to_storey; ++storey) {
        Dice dice(hashOf(seed_, 10, x, y, storey));
        const double floor_m = storey * kStoreyM;
        const WallLine wall_x = lineNear(double(x) + 0.5), wall_y = lineNear(double(y) + 0.5);
        for (int i = 0; i < kEach; ++i) {
          Point point{{double(x) + dice.uniform(0, 1), double(y) + dice.uniform(0, 1), floor_m}, 0, 0};
          double height = dice.uniform(0, kStoreyM - 0.3);
          const bool on_x = wall_x.off_m <= 0.5, on_y = wall_y.off_m <= 0.5;
          if (on_x && i % 2 == 0) point.at_m.x() = double(wall_x.number) * kRoomM;
          if (on_y && !on_x && i % 2 == 0) point.at_m.y() = double(wall_y.number) * kRoomM;
          const bool solid = wallAt(point.at_m.x(), point.at_m.y(), storey);
          if (!solid) height = i == 1 ? kStoreyM - 0.3 : 0;  // the ceiling, the floor
          point.at_m.z() += height;
          point.intensity = static_cast<float>(solid ? 180 + 60 * dice.uniform(0, 1) : 40);
          point.rgb = kColors[static_cast<std::size_t>(storey)];
          take(point);
        }
      }
    }
  }
}

}  // namespace mapwright::simulator::ros
