// Converts the pixels of a row to cells, and decides which gray levels mean unknown. One thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "grids/grid_cells.h"
#include "grids/picture_rows.h"

namespace mapwright::grids {

/// cellFromPixel for whole rows: uses a table where there are few enough different pixels.
class RowCells {
 public:
  RowCells(const PixelFormat& format, const map::CellReading& reading);
  /// `row`: format.rowBytes() bytes; `out`: format.width cells.
  void convert(const std::uint8_t* row, std::uint8_t* out);

 private:
  void convertSamples(const std::uint8_t* row, std::uint8_t* out);
  std::uint8_t fromSamples(const std::uint16_t* samples) const;
  std::uint8_t fromColour(const PixelFormat::Colour& colour) const;

  PixelFormat format_;
  map::CellReading reading_;
  bool identity_ = false;
  std::vector<std::uint8_t> table_;  // by byte, by 16-bit gray, or by gray << 8 | alpha; empty: no table
};

/// The frequency of every gray level.
class GrayShades {
 public:
  void add(const std::uint8_t* grays, std::size_t count);
  /// `has_alpha`: 128 stands for transparent pixels, which say nothing about the others. `whole`: every pixel
  /// was counted.
  ///
  /// - Nearly all pixels (99 of 100) are black, white, map_saver's 254 and 205, or one middle gray (112..143)
  ///   and its neighbours: a map of three gray levels. 205 and the middle are unknown (Gray).
  /// - Only one middle gray stands out from its neighbours and from all levels between black and white:
  ///   unknown areas in a map of many gray levels. The middle is unknown (ShadedGray).
  /// - Otherwise every gray level is a value: FullGray, or ClearGray if 128 is needed for transparent pixels.
  CellCode code(bool has_alpha, bool whole) const;

 private:
  std::array<std::uint64_t, 256> counts_{};
};

/// How many pixels are used for the decision: all of most maps, and the upper part of huge ones. The same
/// picture gives the same code for every reader, in all its rows.
inline constexpr std::int64_t kJudgedPixels = std::int64_t(1) << 26;

/// How many rows of a picture are used for the decision.
int judgedRows(const PixelFormat& format);

/// A guess from the first rows: nearly always right, long before the decision can be made. Consumes the rows
/// from the first one on.
CellCode glimpsedCode(PictureRows& rows, const map::CellReading& reading);

}  // namespace mapwright::grids
