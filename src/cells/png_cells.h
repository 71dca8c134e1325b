// Cells out of a PNG. Pure function, any thread.
// Source: docs/protocols/cartographer-submaps.md, "Containers and cell layouts".
#pragma once

#include <cstdint>
#include <span>

#include <tl/expected.hpp>

#include "fault/fault.h"
#include "packed/unpack.h"

namespace mapwright::cells {

/// One byte a cell (gray level or palette index) or two (value, alpha), row-major.
struct PngCells {
  packed::ByteBuffer cells;
};

struct PngFailure {
  Fault reason;
  bool is_png = false;  // a PNG of another size or kind, and surely not raw cells that resemble one
};

/// Gray and palette pictures give one byte a cell: gray of fewer than 8 bits is scaled to 0..255, an index
/// stays as it is. Gray with alpha gives (gray, alpha), colour gives (luminance, alpha or 255). Of 16-bit
/// samples the high byte counts. The picture must be width x height, and this is checked before memory is
/// taken for it. Precondition: 1 <= width * height <= kMaxCells.
tl::expected<PngCells, PngFailure> decodePngCells(std::span<const std::uint8_t> bytes, int width, int height);

}  // namespace mapwright::cells
