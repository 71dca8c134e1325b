#include "simulator/blocks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "simulator/noise.h"

namespace mapwright::simulator {
namespace {

/// An interval along a wall that stays open, metres.
using Gap = std::pair<double, double>;

constexpr double kClearanceM = 0.36;  // half a robot and a hand's breadth
constexpr double kBucketM = 2.0;
constexpr double kDoorM = 1.0;
constexpr double kPartitionM = 0.12;
constexpr double kFacadeM = 0.24;
constexpr Gap kMainLane{18.8, 21.2};
constexpr Gap kWestLane{0.2, 2.6}, kEastLane{57.4, 59.8};
constexpr Gap kCrossLane{29.0, 31.4};
constexpr double kMainY = 20, kSouthY = 8.1, kNorthY = 31.9;
constexpr double kLaneX = 1.4;  // centre of the lane where the tour begins; mirrored at the other end

/// The stretches of [from, to] that the gaps leave.
std::vector<Gap> between(double from, double to, std::vector<Gap> gaps) {
  std::sort(gaps.begin(), gaps.end());
  std::vector<Gap> walls;
  for (const Gap& gap : gaps) {
    if (gap.first > from) walls.emplace_back(from, std::min(gap.first, to));
    from = std::max(from, gap.second);
  }
  if (from < to) walls.emplace_back(from, to);
  return walls;
}

/// A part of a building being drawn, in its own coordinates: metres, x to the east, y to the north.
class BlockDrawing {
 public:
  explicit BlockDrawing(std::uint64_t seed) : dice(seed) {}

  void wallAlongX(double x0, double x1, double y, double thickness, std::vector<Gap> gaps = {}) {
    for (const Gap& wall : between(x0, x1, std::move(gaps))) {
      solids.push_back(
          {{(wall.first + wall.second) / 2, y}, {(wall.second - wall.first) / 2, thickness / 2}});
    }
  }

  void wallAlongY(double x, double y0, double y1, double thickness, std::vector<Gap> gaps = {}) {
    for (const Gap& wall : between(y0, y1, std::move(gaps))) {
      solids.push_back(
          {{x, (wall.first + wall.second) / 2}, {thickness / 2, (wall.second - wall.first) / 2}});
    }
  }

  void post(double x, double y, double size) { solids.push_back({{x, y}, {size / 2, size / 2}}); }

  void box(double x, double y, double width, double depth, double yaw_rad = 0) {
    solids.push_back({{x, y}, {width / 2, depth / 2}, yaw_rad, false, true});
  }

  void disc(double x, double y, double radius) {
    solids.push_back({{x, y}, {radius, radius}, 0, true, true});
  }

  void chair(double x, double y, double yaw_rad) {
    const double r = 0.24;
    for (int leg = 0; leg < 4; ++leg) {
      const double a = yaw_rad + 0.785 + leg * 1.5708;
      disc(x + r * std::cos(a), y + r * std::sin(a), 0.025);
    }
  }

  void table(double x, double y, double width, double depth, double yaw_rad) {
    const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
    for (const double i : {-1.0, 1.0}) {
      for (const double k : {-1.0, 1.0}) {
        const double u = i * (width / 2 - 0.06), v = k * (depth / 2 - 0.06);
        disc(x + c * u - s * v, y + s * u + c * v, 0.035);
      }
    }
  }

  void desk(double x, double y, double yaw_rad) {
    const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
    table(x, y, 1.5, 0.75, yaw_rad);
    box(x + c * 0.5 - s * 0.05, y + s * 0.5 + c * 0.05, 0.42, 0.58, yaw_rad);
    const double along = dice.uniform(-0.35, 0.1), out = dice.uniform(-0.75, -0.45);
    chair(x + c * along - s * out, y + s * along + c * out, dice.uniform(0, 1.5));
  }

  void clear(const std::vector<Eigen::Vector2d>& way) {
    std::map<std::pair<int, int>, std::vector<Eigen::Vector2d>> buckets;
    const auto bucket = [](double v) { return static_cast<int>(std::floor(v / kBucketM)); };
    for (std::size_t i = 1; i < way.size(); ++i) {
      const Eigen::Vector2d step = way[i] - way[i - 1];
      const int pieces = std::max(1, static_cast<int>(step.norm() / 0.15));
      for (int k = 0; k <= pieces; ++k) {
        const Eigen::Vector2d p = way[i - 1] + step * (static_cast<double>(k) / pieces);
        buckets[{bucket(p.x()), bucket(p.y())}].push_back(p);
      }
    }
    std::erase_if(solids, [&](const Solid& solid) {
      if (!solid.movable) return false;
      const double reach = solid.reach() + kClearanceM;
      for (int by = bucket(solid.centre.y() - reach); by <= bucket(solid.centre.y() + reach); ++by) {
        for (int bx = bucket(solid.centre.x() - reach); bx <= bucket(solid.centre.x() + reach); ++bx) {
          const auto found = buckets.find({bx, by});
          if (found == buckets.end()) continue;
          for (const Eigen::Vector2d& p : found->second) {
            if (solid.distanceTo(p) < kClearanceM) return true;
          }
        }
      }
      return false;
    });
  }

  Dice dice;
  std::vector<Solid> solids;
};

/// A room with one door, for furnishing and for visits.
struct Room {
  double x0 = 0, x1 = 0;  // along the corridor
  double door_y = 0;      // the wall with the door
  double depth = 0;       // from that wall
  double inward = 1;      // +1: the room is north of the door, -1: south
  double corridor_y = 0;  // centre line of the corridor
  double door_x = 0;
  bool visited = false;  // the robot goes in

  double at(double from_door) const { return door_y + inward * from_door; }
};

void furnishOffice(BlockDrawing& d, const Room& room) {
  const double back = room.depth - 0.55, yaw = room.inward > 0 ? 0 : std::numbers::pi;
  for (double x = room.x0 + 1.0; x < room.x1 - 0.9; x += d.dice.uniform(1.9, 2.6)) {
    d.desk(x, room.at(back), yaw);
    if (room.depth > 6 && d.dice.chance(0.5)) d.desk(x, room.at(back - 2.2), yaw);
  }
  const double side = d.dice.chance(0.5) ? room.x0 + 0.32 : room.x1 - 0.32;
  for (double t = 1.2; t < room.depth - 1.8; t += 0.95) {
    if (d.dice.chance(0.6)) d.box(side, room.at(t), 0.45, 0.9);
  }
}

void furnishMeeting(BlockDrawing& d, const Room& room) {
  const double x = (room.x0 + room.x1) / 2, t = room.depth * 0.62;
  const double width = std::min(3.2, room.x1 - room.x0 - 2.0);
  if (width < 1.2) return;
  d.table(x, room.at(t), width, 1.2, 0);
  for (double u = -width / 2 + 0.4; u < width / 2; u += 0.8) {
    d.chair(x + u, room.at(t - 1.0 + d.dice.uniform(-0.15, 0.1)), d.dice.uniform(-0.3, 0.3));
    d.chair(x + u, room.at(t + 1.0 + d.dice.uniform(-0.1, 0.2)), d.dice.uniform(-0.3, 0.3));
  }
  d.box(room.x1 - 0.3, room.at(t), 0.3, 1.4);
}

void furnishStorage(BlockDrawing& d, const Room& room) {
  for (double t = 1.3; t < room.depth - 0.6; t += 1.02) {
    d.box(room.x0 + 0.35, room.at(t), 0.5, 0.98);
    if (d.dice.chance(0.85)) d.box(room.x1 - 0.35, room.at(t), 0.5, 0.98);
  }
  const int crates = d.dice.integer(2, 6);
  for (int i = 0; i < crates; ++i) {
    const double size = d.dice.uniform(0.3, 0.8);
    d.box(d.dice.uniform(room.x0 + 1, room.x1 - 1), room.at(d.dice.uniform(2.2, room.depth - 0.6)), size,
          size * d.dice.uniform(0.6, 1.2), d.dice.uniform(0, std::numbers::pi));
  }
}

void furnishWashroom(BlockDrawing& d, const Room& room) {
  for (double x = room.x0 + 1.0; x < room.x1 - 0.4; x += 1.0) {
    d.box(x, room.at(room.depth - 0.75), 0.05, 1.4);
    d.disc(x - 0.5, room.at(room.depth - 0.4), 0.2);
  }
  d.box(room.x0 + 0.3, room.at(2.2), 0.5, 1.6);
}

void furnish(BlockDrawing& d, const Room& room) {
  const double kind = d.dice.uniform(0, 1);
  const double width = room.x1 - room.x0;
  if (kind < 0.55) {
    furnishOffice(d, room);
  } else if (kind < 0.75 && width > 3.8) {
    furnishMeeting(d, room);
  } else if (kind < 0.87) {
    furnishStorage(d, room);
  } else if (kind < 0.94) {
    furnishWashroom(d, room);
  }
  if (d.dice.chance(0.5)) d.disc(room.x0 + 0.4, room.at(room.depth - 0.4), 0.18);
}

void drawDoor(BlockDrawing& d, const Room& room) {
  if (!room.visited && d.dice.chance(0.25)) {
    d.box(room.door_x, room.door_y, kDoorM, 0.06);  // shut
    return;
  }
  // Hinged at the door's west edge and opened into the room by about a right angle.
  const double angle = room.inward * d.dice.uniform(1.45, 2.0);
  const double length = kDoorM - 0.08;
  d.box(room.door_x - kDoorM / 2 + length / 2 * std::cos(angle), room.door_y + length / 2 * std::sin(angle),
        length, 0.05, angle);
}

/// A row of rooms along a corridor, with their walls, doors and furniture. `x0..x1` is the wing's extent.
std::vector<Room> drawRooms(BlockDrawing& d, double x0, double x1, double door_y, double depth, double inward,
                            double corridor_y) {
  std::vector<Room> rooms;
  std::vector<Gap> doors;
  double x = x0;
  while (x < x1 - 0.1) {
    double width = d.dice.uniform(3.4, 7.6);
    if (x1 - x - width < 3.2) width = x1 - x;
    if (width > 9.5) width /= 2;
    Room room{x, x + width, door_y, depth, inward, corridor_y, 0, false};
    room.door_x = d.dice.chance(0.5) ? x + d.dice.uniform(1.0, 1.4) : x + width - d.dice.uniform(1.0, 1.4);
    room.visited = d.dice.chance(0.5);
    doors.emplace_back(room.door_x - kDoorM / 2, room.door_x + kDoorM / 2);
    if (!rooms.empty()) {
      const double y0 = std::min(room.door_y, room.at(depth)), y1 = std::max(room.door_y, room.at(depth));
      d.wallAlongY(x, y0, y1, kPartitionM);
    }
    furnish(d, room);
    drawDoor(d, room);
    rooms.push_back(room);
    x += width;
  }
  d.wallAlongX(x0, x1, door_y, 0.16, doors);
  return rooms;
}

/// The route of a visit: from the corridor through the door, around a small loop and out again.
void appendVisit(std::vector<Eigen::Vector2d>& way, const Room& room) {
  const double side = room.door_x < (room.x0 + room.x1) / 2 ? 0.65 : -0.65;
  way.emplace_back(room.door_x, room.corridor_y);
  way.emplace_back(room.door_x, room.at(1.3));
  way.emplace_back(room.door_x + side * 1.6, room.at(1.5));
  way.emplace_back(room.door_x + side * 1.6, room.at(2.6));
  way.emplace_back(room.door_x, room.at(2.6));
  way.emplace_back(room.door_x, room.at(1.2));
  way.emplace_back(room.door_x, room.corridor_y);
}

using Way = std::vector<Eigen::Vector2d>;

void drawFacade(BlockDrawing& d, const BlockRequest& request) {
  std::vector<Gap> west, east, south, north;
  if (request.west_open) west.push_back(kMainLane);
  if (request.east_open) east.push_back(kMainLane);
  if (request.entry == Port::SideLane) south.push_back(request.mirrored ? kEastLane : kWestLane);
  if (request.exit == Port::SideLane) north.push_back(request.mirrored ? kWestLane : kEastLane);
  d.wallAlongY(0, 0, kBlockHeightM, kFacadeM, west);
  d.wallAlongY(kBlockWidthM, 0, kBlockHeightM, kFacadeM, east);
  d.wallAlongX(0, kBlockWidthM, 0, kFacadeM, south);
  d.wallAlongX(0, kBlockWidthM, kBlockHeightM, kFacadeM, north);
}

/// Goes along a corridor from one x to the other and into the visited rooms on the way.
void appendCorridor(Way& way, double from_x, double to_x, double y, std::vector<Room> rooms) {
  const double direction = to_x > from_x ? 1 : -1;
  std::sort(rooms.begin(), rooms.end(),
            [&](const Room& a, const Room& b) { return direction * a.door_x < direction * b.door_x; });
  way.emplace_back(from_x, y);
  for (const Room& room : rooms) {
    if (room.visited) appendVisit(way, room);
  }
  way.emplace_back(to_x, y);
}

/// The lane where the tour begins; it ends on the opposite one.
double beginOf(const BlockRequest& request) { return request.mirrored ? kBlockWidthM - kLaneX : kLaneX; }

void appendEntry(Way& way, const BlockRequest& request) {
  if (request.entry == Port::MainLane) way.emplace_back(request.mirrored ? kBlockWidthM : 0, kMainY);
  way.emplace_back(beginOf(request), request.entry == Port::SideLane ? 0 : kMainY);
}

void appendExit(Way& way, const BlockRequest& request) {
  way.emplace_back(kBlockWidthM - beginOf(request), request.exit == Port::SideLane ? kBlockHeightM : kMainY);
  if (request.exit == Port::MainLane) way.emplace_back(request.mirrored ? 0 : kBlockWidthM, kMainY);
}

Block drawOffice(const BlockRequest& request) {
  BlockDrawing d(request.seed);
  drawFacade(d, request);
  std::vector<Room> south, main, north;
  for (const Gap& wing : {Gap{2.6, kCrossLane.first}, Gap{kCrossLane.second, 57.4}}) {
    const auto add = [&](std::vector<Room>& rooms, double door_y, double depth, double inward,
                         double corridor_y) {
      const std::vector<Room> drawn =
          drawRooms(d, wing.first, wing.second, door_y, depth, inward, corridor_y);
      rooms.insert(rooms.end(), drawn.begin(), drawn.end());
    };
    add(south, 7.0, 7.0, -1, kSouthY);
    add(south, 9.2, 4.8, 1, kSouthY);
    add(main, 18.8, 4.8, -1, kMainY);
    add(main, 21.2, 4.8, 1, kMainY);
    add(north, 30.8, 4.8, -1, kNorthY);
    add(north, 33.0, 7.0, 1, kNorthY);
    d.wallAlongX(wing.first, wing.second, 14, 0.16);
    d.wallAlongX(wing.first, wing.second, 26, 0.16);
    for (const double x : {wing.first, wing.second}) {
      d.wallAlongY(x, 0, kBlockHeightM, 0.16, {{7.0, 9.2}, kMainLane, {30.8, 33.0}});
    }
  }
  for (const double y : {kSouthY, kMainY, kNorthY}) {  // what stands about in corridors
    for (double x = 4; x < 56; x += d.dice.uniform(4, 11)) {
      const double side = y + (d.dice.chance(0.5) ? 0.86 : -0.86);
      if (d.dice.chance(0.4)) {
        d.disc(x, side, 0.17);
      } else {
        d.box(x, side, d.dice.uniform(0.5, 1.6), 0.32);
      }
    }
  }

  Block block;
  const double begin = beginOf(request), end = kBlockWidthM - begin;
  appendEntry(block.tour, request);
  appendCorridor(block.tour, begin, end, kSouthY, south);
  appendCorridor(block.tour, end, begin, kMainY, main);
  appendCorridor(block.tour, begin, end, kNorthY, north);
  appendExit(block.tour, request);

  appendCorridor(block.round, kLaneX, kBlockWidthM - kLaneX, kSouthY, south);
  appendCorridor(block.round, kBlockWidthM - kLaneX, kLaneX, kMainY, main);
  d.clear(block.tour);
  d.clear(block.round);
  block.solids = std::move(d.solids);
  return block;
}

/// A rack of `x0..x1` as a lidar near the floor sees it: uprights, and the pallets of the lowest level.
void drawRack(BlockDrawing& d, double x0, double x1, double y) {
  constexpr double kBayM = 2.7;
  for (double x = x0; x < x1 + 0.1; x += kBayM) {
    for (const double side : {-0.55, 0.55}) d.post(x, y + side, 0.12);
    if (x + kBayM > x1 + 0.1 || d.dice.chance(0.12)) continue;
    for (const double place : {0.75, 1.95}) {
      if (!d.dice.chance(0.8)) continue;
      d.box(x + place + d.dice.uniform(-0.08, 0.08), y + d.dice.uniform(-0.06, 0.06),
            1.0 - d.dice.uniform(0, 0.2), 1.15 - d.dice.uniform(0, 0.3), d.dice.uniform(-0.05, 0.05));
    }
  }
}

Block drawHall(const BlockRequest& request) {
  BlockDrawing d(request.seed);
  drawFacade(d, request);
  for (const double y : {4.0, 8.0, 12.0, 16.0, 24.0, 28.0, 32.0, 36.0}) {
    drawRack(d, 4, 28.3, y);
    drawRack(d, 32, 56.3, y);
  }
  for (const double y : {10.0, 30.0}) {
    for (const double x : {3.2, 30.1, 56.9}) d.post(x, y, 0.45);
  }
  for (int i = 0; i < 46; ++i) {  // goods and carts along the outer walls and beside the main lane
    const double size = d.dice.uniform(0.6, 1.3);
    const double x = d.dice.uniform(3.5, 56.5);
    const double y = i % 3 == 0 ? 0.9 : i % 3 == 1 ? 39.1 : d.dice.chance(0.5) ? 18.4 : 21.6;
    d.box(x, y, size, 0.8, d.dice.chance(0.2) ? d.dice.uniform(0, std::numbers::pi) : 0);
  }

  Block block;
  const double begin = beginOf(request), end = kBlockWidthM - begin;
  appendEntry(block.tour, request);
  double from = begin, to = end;
  for (const double y : {6.0, 14.0, 20.0, 26.0, 34.0}) {
    block.tour.emplace_back(from, y);
    block.tour.emplace_back(to, y);
    std::swap(from, to);
  }
  appendExit(block.tour, request);

  for (const auto& [x, y] : {Gap{begin, 20}, Gap{begin, 6}, Gap{end, 6}, Gap{end, 20}})
    block.round.emplace_back(x, y);
  d.clear(block.tour);
  block.round.push_back(block.round.front());
  d.clear(block.round);
  block.round.pop_back();
  block.solids = std::move(d.solids);
  return block;
}

}  // namespace

Block drawBlock(const BlockRequest& request) {
  return request.kind == BlockKind::Hall ? drawHall(request) : drawOffice(request);
}

Block drawAnnex(std::uint64_t seed) {
  BlockDrawing d(seed);
  d.wallAlongY(-26, 9, 31, kFacadeM);
  d.wallAlongY(-0.24, 9, 31, kFacadeM, {kMainLane});
  d.wallAlongX(-26, 0, 9, kFacadeM);
  d.wallAlongX(-26, 0, 31, kFacadeM);
  for (const double x : {-21.8, -15.0, -8.2}) {  // columns between the tables
    for (const double y : {16.8, 23.2}) d.post(x, y, 0.5);
  }
  for (double x = -23.5; x < -2; x += 3.4) {
    for (const double y : {12.0, 16.8, 23.2, 28.0}) {
      if (d.dice.chance(0.12)) continue;
      const double yaw = d.dice.uniform(-0.1, 0.1);
      d.table(x, y, 1.8, 0.9, yaw);
      for (const double side : {-0.8, 0.8}) {
        d.chair(x - 0.45, y + side, yaw);
        if (d.dice.chance(0.8)) d.chair(x + 0.45, y + side, d.dice.uniform(-0.5, 0.5));
      }
    }
  }
  d.wallAlongX(-25, -17, 29.6, 0.7);  // the counter
  Block block;
  block.tour = {{-0.2, 20},    {-3.9, 20},   {-3.9, 14.2}, {-22, 14.2}, {-24.6, 14.2},
                {-24.6, 25.8}, {-3.9, 25.8}, {-3.9, 20},   {-22, 20}};
  d.clear(block.tour);
  block.solids = std::move(d.solids);
  return block;
}

Block drawGatehouse(std::uint64_t seed) {
  BlockDrawing d(seed);
  constexpr double kWidth = 40, kHeight = 18, kLaneY = 9.2;
  d.wallAlongY(0, 0, kHeight, kFacadeM, {{8.1, 10.3}});
  d.wallAlongY(kWidth, 0, kHeight, kFacadeM);
  d.wallAlongX(0, kWidth, 0, kFacadeM);
  d.wallAlongX(0, kWidth, kHeight, kFacadeM);
  std::vector<Room> rooms = drawRooms(d, 0, kWidth, 8.1, 8.1, -1, kLaneY);
  const std::vector<Room> north = drawRooms(d, 0, kWidth, 10.3, 7.7, 1, kLaneY);
  rooms.insert(rooms.end(), north.begin(), north.end());
  Block block;
  appendCorridor(block.tour, 0.8, kWidth - 1.4, kLaneY, rooms);
  d.clear(block.tour);
  block.solids = std::move(d.solids);
  return block;
}

}  // namespace mapwright::simulator
