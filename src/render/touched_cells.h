// Combines the cells touched by a pixel, exactly. Private to sampling; one thread.
// A cell is touched if it overlaps the rotated square of the pixel by more than an edge.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/cells_of_pixels.h"
#include "render/tile_reach.h"

namespace mapwright::render {

/// The touched cell with the highest rank (of equal ones the greatest byte).
/// A cell of a coarser level is the highest of the cells in it. So if it lies completely inside the pixel it
/// stands for all of them, and if only partly, its cells only matter if it is higher than the best so far.
class HighestTouched {
 public:
  HighestTouched(const grids::GridPyramid& cells, TileReach& reach, const PixelOnCells& square);
  /// `centre`: of the pixel, in cells. False if nothing has been read there.
  bool operator()(const Eigen::Vector2d& centre, std::uint8_t& out);

 private:
  struct Box {
    int level, u, v;
  };
  void look(const Eigen::Vector2d& centre, const Box& box);

  const std::array<std::uint8_t, 256>& order_;
  TileReach& reach_;
  const PixelOnCells& square_;
  int start_;                          // the level to look at first
  std::vector<int> widths_, heights_;  // of the levels
  std::vector<Box> partly_;
  int best_ = -1;
  std::uint8_t best_byte_ = 0;
};

/// The mean of the touched known cells, weighted by their area inside the pixel. Unknown if less than half
/// the area is known.
class MeanTouched {
 public:
  MeanTouched(const grids::GridPyramid& cells, TileReach& reach, const PixelOnCells& square);
  /// As above. `is_known` says whether the byte means a known cell, whatever it would mean by itself.
  bool operator()(const Eigen::Vector2d& centre, std::uint8_t& out, bool& is_known);

 private:
  /// One side of the square between two heights: straight pieces.
  struct Side {
    struct Piece {
      double height, from, to;
    };
    std::array<Piece, 2> pieces;
    int count = 0;
    double least = 0, most = 0;
    /// How much of the column [u, u + 1] is to the left of the side.
    double leftOf(double u) const;
  };
  struct Sums {
    double value = 0, known = 0, read = 0;
  };
  Side sideBetween(const Eigen::Vector2d& bend, double top, double bottom) const;
  void addRow(const Eigen::Vector2d& centre, int v, double top, double bottom, Sums& sums);
  void addCell(int u, int v, double weight, Sums& sums);
  void addRun(int from, int to, int v, double weight, Sums& sums);
  bool oneValueAround(const Eigen::Vector2d& centre, std::uint8_t& out);

  const grids::CellMeaning& meaning_;
  std::uint8_t unknown_;
  TileReach& reach_;
  const PixelOnCells& square_;
  std::array<std::uint32_t, 256> weight_{};  // known << 20 | value
  // Corners relative to the centre: the uppermost, where the sides bend, the lowest.
  Eigen::Vector2d top_, left_, right_, bottom_;
};

}  // namespace mapwright::render
