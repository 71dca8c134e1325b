// Reads the cells of occupancy grids in messages. Private to the readers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "robot/ros/read_messages.h"

namespace mapwright::robot::ros {

struct Cells {
  std::vector<std::int8_t> cells;  // -1 unknown, 0..100
  std::size_t odd = 0;             // number of invalid cells, shown as unknown
};

/// How to treat invalid cells.
enum class OddCells {
  Unknown,
  Nearest,  // above 100 counts as 100; others as unknown
};

/// width * height cells; the caller checks the product.
Read<Cells> readCells(const Field& data, std::int64_t width, std::int64_t height, OddCells odd);

/// Width and height of a grid with at most `most` cells.
struct GridSize {
  std::int64_t width = 0, height = 0;
};
enum class EmptyGrids { Refused, Taken };
/// `prefix` as ROS users write the path of the two: "info."
Read<GridSize> readGridSize(const Field& of, const std::string& prefix, std::int64_t most, EmptyGrids empty);

void noteOddCells(std::vector<Fault>& notes, std::size_t odd);

/// The cell edge in metres; NaN if invalid. It is sent as a 32-bit float, so 0.05 arrives as
/// 0.05000000074505806: at a distance of a kilometre cell edges would be on the wrong side. The result is the
/// shortest decimal number with the same float value (docs/protocols/rosbridge.md, "JSON details").
double resolutionOf(const Field& info);

}  // namespace mapwright::robot::ros
