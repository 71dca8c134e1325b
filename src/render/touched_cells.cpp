#include "render/touched_cells.h"

#include <algorithm>

namespace mapwright::render {
namespace {

using grids::GridPyramid;

constexpr int kValueBits = 20;  // of a sum over at most a row of a tile: 256 * 255
constexpr double kFlat = 1e-12, kAligned = 1e-9;

/// The first cell of a level that begins at or before `position`, and the last that ends at or after it.
int cellAt(double position, int cells) {
  return int(std::clamp(std::floor(position), 0.0, double(cells - 1)));
}

}  // namespace

HighestTouched::HighestTouched(const GridPyramid& cells, TileReach& reach, const PixelOnCells& square)
    : order_(cells.order()), reach_(reach), square_(square) {
  for (int level = 0; level < cells.levels(); ++level) {
    widths_.push_back(cells.levelWidth(level));
    heights_.push_back(level == 0 ? reach.rows() : cells.levelHeight(level));
  }
  // Two to four cells per pixel: some of them are then completely inside. The levels of a map that is still
  // being read lag behind.
  const double zoom = 2 * square.half();
  start_ =
      reach.complete() ? std::clamp(int(std::floor(std::log2(zoom) + 1e-9)) - 1, 0, cells.levels() - 1) : 0;
}

bool HighestTouched::operator()(const Eigen::Vector2d& centre, std::uint8_t& out) {
  best_ = -1;
  partly_.clear();
  const int width = widths_[std::size_t(start_)], height = heights_[std::size_t(start_)];
  const double shrink = std::ldexp(1.0, -start_), edge = std::ldexp(1.0, start_), half = edge / 2;
  const double reach = square_.reach() - kTouch;
  const Eigen::Vector2d from = (centre - Eigen::Vector2d(reach, reach)) * shrink,
                        to = (centre + Eigen::Vector2d(reach, reach)) * shrink;
  if (!(from.x() < width && from.y() < height && to.x() > 0 && to.y() > 0)) return false;
  const int u0 = cellAt(from.x(), width), u1 = cellAt(to.x(), width);
  const int v0 = cellAt(from.y(), height), v1 = cellAt(to.y(), height);
  for (int v = v0; v <= v1; ++v) {
    const double y = (v + 0.5) * edge - centre.y();
    for (int u = u0; u <= u1; ++u) {
      const PixelOnCells::Share share = square_.shareOf((u + 0.5) * edge - centre.x(), y, half);
      if (share == PixelOnCells::Share::None) continue;
      const std::uint8_t* const cell = reach_.at(start_, u, v);
      if (!cell || order_[*cell] <= best_) continue;
      if (share == PixelOnCells::Share::All || start_ == 0) {
        best_ = order_[*cell];
        best_byte_ = *cell;
      } else {
        partly_.push_back({start_, u, v});
      }
    }
  }
  // By value: nothing is added meanwhile.
  for (const Box& box : partly_) {
    const std::uint8_t* const cell = reach_.at(box.level, box.u, box.v);
    if (order_[*cell] > best_) look(centre, box);
  }
  out = best_byte_;
  return best_ >= 0;
}

void HighestTouched::look(const Eigen::Vector2d& centre, const Box& box) {
  const int level = box.level - 1;
  const double edge = std::ldexp(1.0, level), half = edge / 2;
  const int u1 = std::min(2 * box.u + 1, widths_[std::size_t(level)] - 1);
  const int v1 = std::min(2 * box.v + 1, heights_[std::size_t(level)] - 1);
  for (int v = 2 * box.v; v <= v1; ++v) {
    for (int u = 2 * box.u; u <= u1; ++u) {
      const PixelOnCells::Share share =
          square_.shareOf((u + 0.5) * edge - centre.x(), (v + 0.5) * edge - centre.y(), half);
      if (share == PixelOnCells::Share::None) continue;
      const std::uint8_t* const cell = reach_.at(level, u, v);
      if (!cell || order_[*cell] <= best_) continue;
      if (share == PixelOnCells::Share::All || level == 0) {
        best_ = order_[*cell];
        best_byte_ = *cell;
      } else {
        look(centre, {level, u, v});
      }
    }
  }
}

MeanTouched::MeanTouched(const GridPyramid& cells, TileReach& reach, const PixelOnCells& square)
    : meaning_(grids::meaningOf(cells.code())),
      unknown_(grids::unknownByte(cells.code())),
      reach_(reach),
      square_(square) {
  for (std::size_t byte = 0; byte < 256; ++byte) {
    const bool gray = grids::isGray(cells.code());
    const std::uint32_t value =
        gray ? std::uint32_t(byte) : std::uint32_t(std::max<int>(0, meaning_.occupancy[byte]));
    weight_[byte] = meaning_.known[byte] ? 1u << kValueBits | value : 0;
  }
  const Eigen::Vector2d a = square.along() * square.half(), b(-a.y(), a.x());
  std::array<Eigen::Vector2d, 4> corners{Eigen::Vector2d(a + b), Eigen::Vector2d(a - b),
                                         Eigen::Vector2d(-a + b), Eigen::Vector2d(-a - b)};
  std::sort(corners.begin(), corners.end(),
            [](const auto& one, const auto& other) { return one.y() < other.y(); });
  if (corners[1].y() - corners[0].y() < kAligned) {
    // Not rotated: the sides are upright, and which corner comes first is arbitrary.
    for (const std::size_t first : {std::size_t(0), std::size_t(2)}) {
      if (corners[first].x() > corners[first + 1].x()) std::swap(corners[first], corners[first + 1]);
    }
  }
  top_ = corners[0];
  bottom_ = corners[3];
  left_ = corners[1].x() < corners[2].x() ? corners[1] : corners[2];
  right_ = corners[1].x() < corners[2].x() ? corners[2] : corners[1];
}

double MeanTouched::Side::leftOf(double u) const {
  if (most <= u) return 0;
  // The integral of how far a point is inside the column.
  const auto into = [](double x) { return x <= 0 ? 0.0 : x < 1 ? x * x / 2 : x - 0.5; };
  double area = 0;
  for (int n = 0; n < count; ++n) {
    const Piece& piece = pieces[std::size_t(n)];
    const double from = piece.from - u, to = piece.to - u;
    area += std::abs(to - from) < kFlat ? piece.height * std::clamp((from + to) / 2, 0.0, 1.0)
                                        : piece.height * (into(to) - into(from)) / (to - from);
  }
  return area;
}

/// The side from the uppermost corner to the lowest one via `bend`, between the two heights.
MeanTouched::Side MeanTouched::sideBetween(const Eigen::Vector2d& bend, double top, double bottom) const {
  Side side;
  const auto add = [&](const Eigen::Vector2d& one, const Eigen::Vector2d& other) {
    const double from = std::max(top, one.y()), to = std::min(bottom, other.y());
    if (!(to > from) || !(other.y() - one.y() > kFlat)) return;
    const double slope = (other.x() - one.x()) / (other.y() - one.y());
    side.pieces[std::size_t(side.count++)] = {to - from, one.x() + slope * (from - one.y()),
                                              one.x() + slope * (to - one.y())};
  };
  add(top_, bend);
  add(bend, bottom_);
  for (int n = 0; n < side.count; ++n) {
    const Side::Piece& piece = side.pieces[std::size_t(n)];
    const double least = std::min(piece.from, piece.to), most = std::max(piece.from, piece.to);
    side.least = n == 0 ? least : std::min(side.least, least);
    side.most = n == 0 ? most : std::max(side.most, most);
  }
  return side;
}

void MeanTouched::addCell(int u, int v, double weight, Sums& sums) {
  const std::uint8_t* const cell = reach_.at(0, u, v);
  if (!cell) return;
  sums.read += weight;
  if (!meaning_.known[*cell]) return;
  sums.known += weight;
  sums.value += weight * (weight_[*cell] & ((1u << kValueBits) - 1));
}

/// Cells [from, to) of a row, all with the same weight.
void MeanTouched::addRun(int from, int to, int v, double weight, Sums& sums) {
  while (from < to) {
    const TileReach::Tile tile = reach_.tile(0, from >> TileReach::kEdgeBits, v >> TileReach::kEdgeBits);
    const int end = std::min(to, (from | (GridPyramid::kTileEdge - 1)) + 1), count = end - from;
    if (tile.cells) {
      const std::uint8_t* cells = tile.cells + ((v & (GridPyramid::kTileEdge - 1)) * GridPyramid::kTileEdge +
                                                (from & (GridPyramid::kTileEdge - 1)));
      std::uint32_t sum = 0;
      if (tile.uniform) {
        sum = weight_[*cells] * std::uint32_t(count);
      } else {
        for (int n = 0; n < count; ++n) sum += weight_[cells[n]];
      }
      sums.read += weight * count;
      sums.known += weight * (sum >> kValueBits);
      sums.value += weight * (sum & ((1u << kValueBits) - 1));
    }
    from = end;
  }
}

/// The part of row `v` between two heights, which are relative to the centre.
void MeanTouched::addRow(const Eigen::Vector2d& centre, int v, double top, double bottom, Sums& sums) {
  const Side left = sideBetween(left_, top, bottom), right = sideBetween(right_, top, bottom);
  if (left.count == 0 || right.count == 0) return;
  const int width = reach_.width();
  const auto clamped = [width](double position) { return int(std::clamp(position, 0.0, double(width))); };
  const int begin = clamped(std::floor(left.least + centre.x())),
            end = clamped(std::ceil(right.most + centre.x()));
  int whole_from = clamped(std::ceil(left.most + centre.x())),
      whole_to = clamped(std::floor(right.least + centre.x()));
  if (whole_to < whole_from) whole_from = whole_to = end;
  const auto partly = [&](int from, int to) {
    for (int u = from; u < to; ++u) {
      const double position = u - centre.x();
      const double weight = right.leftOf(position) - left.leftOf(position);
      if (weight > 0) addCell(u, v, weight, sums);
    }
  };
  partly(begin, std::min(whole_from, end));
  addRun(whole_from, whole_to, v, bottom - top, sums);
  partly(whole_to, end);
}

/// Empty ground, which is most of a map: all tiles around the pixel are uniform.
bool MeanTouched::oneValueAround(const Eigen::Vector2d& centre, std::uint8_t& out) {
  const double reach = square_.reach();
  const int x0 = cellAt(centre.x() - reach, reach_.width()) >> TileReach::kEdgeBits;
  const int x1 = cellAt(centre.x() + reach, reach_.width()) >> TileReach::kEdgeBits;
  const int y0 = cellAt(centre.y() - reach, reach_.rows()) >> TileReach::kEdgeBits;
  const int y1 = cellAt(centre.y() + reach, reach_.rows()) >> TileReach::kEdgeBits;
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const TileReach::Tile tile = reach_.tile(0, x, y);
      if (!tile.cells || !tile.uniform) return false;
      if (x == x0 && y == y0) out = *tile.cells;
      if (*tile.cells != out) return false;
    }
  }
  return true;
}

bool MeanTouched::operator()(const Eigen::Vector2d& centre, std::uint8_t& out, bool& is_known) {
  const double width = reach_.width(), rows = reach_.rows();
  if (!(rows > 0) || !square_.touches(width / 2 - centre.x(), rows / 2 - centre.y(), width / 2, rows / 2)) {
    return false;
  }
  if (oneValueAround(centre, out)) {
    is_known = meaning_.known[out];
    return true;
  }
  const double reach = square_.reach();
  const int v0 = cellAt(centre.y() - reach, reach_.rows()), v1 = cellAt(centre.y() + reach, reach_.rows());
  Sums sums;
  for (int v = v0; v <= v1; ++v) {
    const double top = std::max(v - centre.y(), top_.y()), bottom = std::min(v + 1 - centre.y(), bottom_.y());
    if (bottom > top) addRow(centre, v, top, bottom, sums);
  }
  if (!(sums.read > 0)) return false;
  is_known = sums.known > 0 && sums.known * 2 >= sums.read * (1 - kTouch);
  if (is_known) {
    out = std::uint8_t(std::clamp(std::lround(sums.value / sums.known), 0L, 255L));
    return true;
  }
  // The gray of the unknown cell at the centre: pictures keep it.
  const std::uint8_t* const middle =
      reach_.at(0, cellAt(centre.x(), reach_.width()), cellAt(centre.y(), reach_.rows()));
  out = middle && !meaning_.known[*middle] ? *middle : unknown_;
  return true;
}

}  // namespace mapwright::render
