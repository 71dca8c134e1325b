#include "robot/ros/read_cells.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "grids/faults.h"
#include "robot/ros/faults.h"
#include "robot/ros/parts.h"

namespace mapwright::robot::ros {
namespace {

/// Cells that are not bytes need eight times the memory while they are read.
constexpr std::size_t kMostOddCells = std::size_t(1) << 25;
constexpr std::int8_t kUnknown = -1, kOccupied = 100;

}  // namespace

Read<Cells> readCells(const Field& data, std::int64_t width, std::int64_t height, OddCells odd) {
  const std::size_t needed = std::size_t(width * height);
  // With a wrong length, cells would be at wrong positions. Servers may send an empty list as a text.
  const bool none = needed == 0 && (data.isNull() || data.isText());
  if (none) return Cells{};
  if (!data.isList()) return fieldMissing("data");
  if (data.size() != needed) {
    return tl::unexpected(
        Fault(fault::RosLengthDiffers, {"data", std::int64_t(data.size()), std::int64_t(needed)}));
  }
  Cells read;
  if (auto bytes = data.int8s(needed)) {
    read.cells = std::move(*bytes);
    for (std::int8_t& cell : read.cells) {
      if (cell >= kUnknown && cell <= kOccupied) continue;
      const bool shown = odd == OddCells::Nearest && cell > kOccupied;
      cell = shown ? kOccupied : kUnknown;
      read.odd += !shown;
    }
    return read;
  }
  const auto numbers = data.numbers(kMostOddCells);
  if (!numbers || numbers->size() != needed) return fieldMissing("data");
  read.cells.reserve(needed);
  for (const double value : *numbers) {
    const bool whole = value >= kUnknown && value <= kOccupied && value == std::floor(value);
    const bool above = odd == OddCells::Nearest && value > kOccupied;
    read.cells.push_back(whole ? std::int8_t(value) : above ? kOccupied : kUnknown);
    read.odd += !whole && !above;
  }
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

void noteOddCells(std::vector<Fault>& notes, std::size_t odd) {
  if (odd > 0) notes.push_back({grids::fault::RosCellsOutOfRange, {std::int64_t(odd)}});
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

}  // namespace mapwright::robot::ros
