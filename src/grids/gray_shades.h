// Which grays of a picture mean unknown ground. The picture itself tells, by how often every gray occurs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "grids/grid_cells.h"
#include "grids/picture_rows.h"

namespace mapwright::grids {

/// How often every gray occurs.
class GrayShades {
 public:
  void add(const std::uint8_t* grays, std::size_t count);
  /// `has_alpha`: 128 stands for transparent pixels, which say nothing about the others. `whole`: every pixel
  /// was counted.
  ///
  /// - Nearly all pixels (99 of 100) black, white, map_saver's 254 and 205, or one gray of the middle
  /// (112..143)
  ///   and its neighbours: a map of three shades. 205 and the middle are unknown (Gray).
  /// - One gray of the middle alone stands out of its neighbours and of all shades between black and white:
  ///   ground that nobody has seen, in a map of many shades. The middle is unknown (ShadedGray).
  /// - Else every gray is one: FullGray, or ClearGray where 128 is needed for pixels that are not there.
  CellCode code(bool has_alpha, bool whole) const;

 private:
  std::array<std::uint64_t, 256> counts_{};
};

/// Pixels that a picture is judged by: all of most maps, and of a huge one its upper part. The same picture
/// gives the same code whoever reads it, and all its rows have it.
inline constexpr std::int64_t kJudgedPixels = std::int64_t(1) << 26;

/// Rows of a picture that are judged.
int judgedRows(const PixelFormat& format);

/// What the first rows look like: nearly always what the judgement will be, long before it can be made. Reads
/// the rows from the first one on; they are used up.
CellCode glimpsedCode(PictureRows& rows, const map::CellReading& reading);

}  // namespace mapwright::grids
