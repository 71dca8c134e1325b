// Halving rows of cells: the step from one level of a texture to the next. Pure functions, any thread.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cells/cell_texture.h"

namespace mapwright::cells {

/// Writes `out_cells` cells, each the average of 2x2 cells of the rows `upper` and `lower` (2 * out_cells
/// cells each). Unknown cells count as zero, as in an area average of the composed picture. A cell with an
/// observed child is observed: if the average is zero it becomes (0, 1), which means delta == 0. Folded cells
/// keep the net of value and alpha; pairs keep both.
void reduceRows(CellLayout layout, const std::uint8_t* upper, const std::uint8_t* lower, std::uint8_t* out,
                std::size_t out_cells);

}  // namespace mapwright::cells
