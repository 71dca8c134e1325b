// The cells of grids of occupancy as they stand in messages. Private to the readers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "robot/ros/read_messages.h"

namespace mapwright::robot::ros {

struct Cells {
  std::vector<std::int8_t> cells;  // -1 unknown, 0..100
  std::size_t odd = 0;             // how many are shown as unknown because they were none of these
};

/// What becomes of a cell that is no occupancy.
enum class OddCells {
  Unknown,
  Nearest,  // above 100 as 100, which is shown; all else is unknown
};

/// width * height cells; the product is to be checked before.
Read<Cells> readCells(const Field& data, std::int64_t width, std::int64_t height, OddCells odd);

/// Width and height of a grid of at most `most` cells.
struct GridSize {
  std::int64_t width = 0, height = 0;
};
enum class EmptyGrids { Refused, Taken };
/// `prefix` as people who know ROS write the place of the two: "info."
Read<GridSize> readGridSize(const Field& of, const std::string& prefix, std::int64_t most, EmptyGrids empty);

void noteOddCells(std::vector<Fault>& notes, std::size_t odd);

/// The edge of a cell in metres; no number where it is none. It is sent as 32 bits, and what was 0.05 arrives
/// as 0.05000000074505806: a kilometre away that is a cell's edge on the wrong side. It is taken as the
/// shortest number that is written so (docs/protocols/rosbridge.md, "JSON details").
double resolutionOf(const Field& info);

}  // namespace mapwright::robot::ros
