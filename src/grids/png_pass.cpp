#include "grids/png_pass.h"

#include <algorithm>

#include "grids/faults.h"
#include "packed/png_unfilter.h"

namespace mapwright::grids {

PngPass::PngPass(const PngHeader& header, int width)
    : width_(width),
      bit_depth_(header.bit_depth),
      stored_bytes_(header.storedRowBytes(width)),
      unit_(std::size_t(std::max(1, header.stored_channels * header.bit_depth / 8))),
      row_(stored_bytes_),
      above_(stored_bytes_),
      unpacked_(header.bit_depth < 8 ? std::size_t(width) : 0) {}

const std::uint8_t* PngPass::next(PngStream& stream, Fault& problem) {
  const std::uint8_t* filtered = stream.take(1 + stored_bytes_);
  if (filtered == nullptr) {
    problem = stream.problem();
    return nullptr;
  }
  row_.swap(above_);
  if (!packed::unfilterRow(filtered[0], filtered + 1, above_.data(), stored_bytes_, unit_, row_.data())) {
    problem = fault::DataDamaged;
    return nullptr;
  }
  if (bit_depth_ >= 8) return row_.data();
  packed::unpackBits(row_.data(), std::size_t(width_), bit_depth_, unpacked_.data());
  return unpacked_.data();
}

}  // namespace mapwright::grids
