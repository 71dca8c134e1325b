// Removes typical SLAM artefacts: specks, gaps in walls, ragged edges of free space. Uses OpenCV's connected
// components and morphology, block by block, so that memory does not grow with the map. Any thread.
#pragma once

#include <atomic>
#include <cstdint>

#include "picture/canvas.h"

namespace mapwright::picture {

inline constexpr int kLargestSpeck = 1'000;  // cells
inline constexpr int kWidestGap = 100;       // cells

struct Tidied {
  std::int64_t pieces = 0;  // number of specks; otherwise 0
  std::int64_t cells = 0;   // that become others
};

/// Groups of occupied cells (connected by edges and corners) of at most `most_cells` become what most cells
/// around them are, free or unknown. Groups that extend beyond the rectangle are judged as a whole; only
/// cells inside change.
Tidied removeSpecks(Canvas& canvas, const CellRect& within, int most_cells,
                    const std::atomic<bool>* cancelled = nullptr);
/// Gaps of at most `most_cells` between occupied cells become occupied, along eight directions (closing by
/// lines).
Tidied closeGaps(Canvas& canvas, const CellRect& within, int most_cells,
                 const std::atomic<bool>* cancelled = nullptr);
/// Removes spikes of free space into unknown space and fills notches, both up to `cells` wide (opening and
/// closing by a disc). Occupied cells stay.
Tidied smoothFree(Canvas& canvas, const CellRect& within, int cells,
                  const std::atomic<bool>* cancelled = nullptr);

}  // namespace mapwright::picture
