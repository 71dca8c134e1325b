// Combines four cells of a grid into one of the next coarser level. Immutable, any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "grids/grid_cells.h"
#include "grids/grid_pyramid.h"

namespace mapwright::grids {

class GridReducer {
 public:
  GridReducer(CellCode code, Reduction reduction);
  /// The highest of these ranks wins, whatever the bytes mean (palette indices).
  explicit GridReducer(const std::array<std::uint8_t, 256>& rank);

  /// Every byte has a unique rank: of several cells the highest wins.
  const std::array<std::uint8_t, 256>& order() const { return key_; }

  /// Writes (cells + 1) / 2 cells to `out` from the rows `upper` and `lower` of `cells` cells. The last row
  /// of an odd height is passed as both; the last cell of an odd row counts twice, so that edges only use
  /// existing cells. OccupiedWins: the highest rank; of equal ranks the greater byte. Average: the rounded
  /// mean of the known ones, never a byte that means unknown.
  void reduceRow(const std::uint8_t* upper, const std::uint8_t* lower, std::size_t cells,
                 std::uint8_t* out) const;

 private:
  enum class Kind : std::uint8_t { GrayWins, OccupancyWins, TableWins, Average };
  template <CellCode code>
  static void reduceGrays(const std::uint8_t* upper, const std::uint8_t* lower, std::size_t pairs,
                          std::uint8_t* out);
  void rankBytes(const std::array<std::uint8_t, 256>& rank);
  std::uint8_t reduced(std::uint8_t a, std::uint8_t b, std::uint8_t c, std::uint8_t d) const;

  Kind kind_;
  CellCode code_ = CellCode::Gray;
  std::array<std::uint8_t, 256> key_{};      // orders the bytes by rank
  std::array<std::uint8_t, 256> cell_{};     // and back
  std::array<std::uint32_t, 256> weight_{};  // Average: 0 unknown, otherwise 1 << 16 | value
  std::array<std::uint8_t, 256> mean_{};     // Average: the byte for a value
  std::uint8_t unknown_ = 0;
};

}  // namespace mapwright::grids
