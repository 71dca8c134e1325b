// The rows of one pass of a PNG (or of the whole picture if it is not interlaced). One thread.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grids/png_header.h"
#include "grids/png_stream.h"

namespace mapwright::grids {

class PngPass {
 public:
  /// `width`: pixels per row of this pass, at least 1.
  PngPass(const PngHeader& header, int width);
  /// The next row, unpacked to header.format's pixels; null: see `problem`.
  const std::uint8_t* next(PngStream& stream, Fault& problem);

 private:
  int width_, bit_depth_;
  std::size_t stored_bytes_, unit_;
  std::vector<std::uint8_t> row_, above_, unpacked_;
};

}  // namespace mapwright::grids
