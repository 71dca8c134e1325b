// A rectangle of cells of a grid. Pure value.
#pragma once

#include <algorithm>
#include <cstdint>

namespace mapwright::picture {

/// Columns left .. right and rows top .. bottom, the second of each excluded; rows count from the top.
struct CellRect {
  int left = 0, top = 0, right = 0, bottom = 0;

  bool empty() const { return left >= right || top >= bottom; }
  int width() const { return empty() ? 0 : right - left; }
  int height() const { return empty() ? 0 : bottom - top; }
  std::int64_t area() const { return std::int64_t(width()) * height(); }
  bool contains(int column, int row) const {
    return column >= left && column < right && row >= top && row < bottom;
  }
  CellRect intersected(const CellRect& other) const {
    const CellRect both{std::max(left, other.left), std::max(top, other.top), std::min(right, other.right),
                        std::min(bottom, other.bottom)};
    return both.empty() ? CellRect{} : both;
  }
  CellRect united(const CellRect& other) const {
    if (empty()) return other;
    if (other.empty()) return *this;
    return {std::min(left, other.left), std::min(top, other.top), std::max(right, other.right),
            std::max(bottom, other.bottom)};
  }
  CellRect grown(int cells) const { return {left - cells, top - cells, right + cells, bottom + cells}; }
  CellRect moved(int columns, int rows) const {
    return {left + columns, top + rows, right + columns, bottom + rows};
  }
  bool operator==(const CellRect&) const = default;
};

}  // namespace mapwright::picture
