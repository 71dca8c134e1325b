// Rooms along a corridor: partitions, doors and what stands in them.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulator/block_drawing.h"

namespace mapwright::simulator {
namespace {

constexpr double kDoorM = 1.0;
constexpr double kPartitionM = 0.12;

void furnishOffice(BlockDrawing& d, const Room& room) {
  const double back = room.depth - 0.55;
  for (double x = room.x0 + 1.0; x < room.x1 - 0.9; x += d.dice.uniform(1.9, 2.6)) {
    d.desk(x, room.at(back), room.inward > 0 ? 0 : std::numbers::pi);
    if (room.depth > 6 && d.dice.chance(0.5))
      d.desk(x, room.at(back - 2.2), room.inward > 0 ? 0 : std::numbers::pi);
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

}  // namespace

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

}  // namespace mapwright::simulator
