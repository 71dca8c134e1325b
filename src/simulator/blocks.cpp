#include "simulator/blocks.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mapwright::simulator {
namespace {

constexpr double kFacadeM = 0.24;
constexpr Gap kMainLane{18.8, 21.2};
constexpr Gap kWestLane{0.2, 2.6}, kEastLane{57.4, 59.8};
constexpr Gap kCrossLane{29.0, 31.4};
constexpr double kMainY = 20, kSouthY = 8.1, kNorthY = 31.9;
constexpr double kLaneX = 1.4;  // centre of the lane where the tour begins; mirrored at the other end

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

void appendEntry(Way& way, const BlockRequest& request, double begin_x, double outside_x) {
  if (request.entry == Port::MainLane) way.emplace_back(outside_x, kMainY);
  if (request.entry == Port::SideLane) {
    way.emplace_back(begin_x, 0);
  } else {
    way.emplace_back(begin_x, kMainY);
  }
}

void appendExit(Way& way, const BlockRequest& request, double end_x, double outside_x) {
  if (request.exit == Port::SideLane) {
    way.emplace_back(end_x, kBlockHeightM);
    return;
  }
  way.emplace_back(end_x, kMainY);
  if (request.exit == Port::MainLane) way.emplace_back(outside_x, kMainY);
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
  const double begin = request.mirrored ? kBlockWidthM - kLaneX : kLaneX, end = kBlockWidthM - begin;
  const double before = request.mirrored ? kBlockWidthM : 0, behind = kBlockWidthM - before;
  appendEntry(block.tour, request, begin, before);
  appendCorridor(block.tour, begin, end, kSouthY, south);
  appendCorridor(block.tour, end, begin, kMainY, main);
  appendCorridor(block.tour, begin, end, kNorthY, north);
  appendExit(block.tour, request, end, behind);

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
  const double begin = request.mirrored ? kBlockWidthM - kLaneX : kLaneX, end = kBlockWidthM - begin;
  const double before = request.mirrored ? kBlockWidthM : 0, behind = kBlockWidthM - before;
  appendEntry(block.tour, request, begin, before);
  double from = begin, to = end;
  for (const double y : {6.0, 14.0, 20.0, 26.0, 34.0}) {
    block.tour.emplace_back(from, y);
    block.tour.emplace_back(to, y);
    std::swap(from, to);
  }
  appendExit(block.tour, request, end, behind);

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
