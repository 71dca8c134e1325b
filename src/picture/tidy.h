// Tidying up what SLAM leaves behind: specks, gaps in walls, frayed edges of free space. By OpenCV's
// connected components and morphology, block by block, so that memory does not grow with the map. Any thread.
#pragma once

#include <atomic>
#include <cstdint>

#include "picture/canvas.h"

namespace mapwright::picture {

inline constexpr int kLargestSpeck = 1'000;  // cells
inline constexpr int kWidestGap = 100;       // cells

struct Tidied {
  std::int64_t pieces = 0;  // specks; of the others 0
  std::int64_t cells = 0;   // that become others
};

/// Pieces of occupied cells (joined over edges and corners) of at most `most_cells` become what most cells
/// around them are, free or unknown. Pieces that reach into the rectangle's outside are judged as they are as
/// a whole; only cells inside change.
Tidied removeSpecks(Canvas& canvas, const CellRect& within, int most_cells,
                    const std::atomic<bool>* cancelled = nullptr);
/// Between occupied cells with at most `most_cells` others between them everything becomes occupied, along
/// eight directions (closing by lines).
Tidied closeGaps(Canvas& canvas, const CellRect& within, int most_cells,
                 const std::atomic<bool>* cancelled = nullptr);
/// Free ground loses its spikes into unknown ground and gains its notches, both up to `cells` wide (opening
/// and closing by a disc). Occupied cells stay.
Tidied smoothFree(Canvas& canvas, const CellRect& within, int cells,
                  const std::atomic<bool>* cancelled = nullptr);

}  // namespace mapwright::picture
