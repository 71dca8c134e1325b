#include "grids/cell_counts.h"

#include <array>

#include "grids/grid_cells.h"

namespace mapwright::grids {

std::optional<CellCounts> countCells(const GridPyramid& cells, const std::atomic<bool>& cancelled) {
  std::array<std::int64_t, 256> of_byte{};
  GridRows rows(cells);
  for (int y = 0; y < cells.height(); ++y) {
    if (cancelled) return std::nullopt;
    const std::uint8_t* const row = rows.row(y);
    for (int x = 0; x < cells.width(); ++x) ++of_byte[row[x]];
  }
  const CellMeaning& meaning = meaningOf(cells.code());
  CellCounts counts;
  for (std::size_t byte = 0; byte < of_byte.size(); ++byte) {
    (!meaning.known[byte]                          ? counts.unknown
     : meaning.occupancy[byte] >= kOccupiedPercent ? counts.occupied
                                                   : counts.free) += of_byte[byte];
  }
  return counts;
}

}  // namespace mapwright::grids
