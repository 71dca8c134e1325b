// The colours of disagreement and coverage: the same in the window and in pictures. Pure.
#pragma once

#include <cstdint>

#include "agreement/survey.h"

namespace mapwright::agreement {

/// 0xAARRGGBB, not premultiplied.
using Argb = std::uint32_t;

inline constexpr Argb kUnseen = 0x00000000;
inline constexpr Argb kSeenGround = 0xffe6e6e6;    // some submap saw it, and none contradicts
inline constexpr Argb kOccupied = 0xff707070;      // the same where one holds it occupied
inline constexpr Argb kSeenOnce = 0xffd9a441;      // proves nothing
inline constexpr Argb kSeenOnceLine = 0xff8a5a00;  // the hatching over it

/// Yellow to dark red, by the contradicted cells in the same square of 1 m; `full`: cells that give the
/// darkest.
Argb contradictionColor(std::uint64_t cells_in_square, std::uint64_t full);
/// Light to dark blue from two submaps on, in steps of doubling up to 32; kUnseen for 0, and kSeenOnce for 1.
Argb coverageColor(int seen_by);
/// Cells seen once are hatched: whether the line runs through this lattice cell.
bool isHatched(std::int64_t column, std::int64_t row);

}  // namespace mapwright::agreement
