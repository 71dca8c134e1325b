// Converts the pixels of a row to cells. One thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

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

}  // namespace mapwright::grids
