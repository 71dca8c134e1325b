// Reads cells from a PNG. Pure function, any thread. Source: docs/protocols/cartographer-submaps.md,
// "Containers and cell layouts".
#pragma once

#include <cstdint>
#include <span>

#include <tl/expected.hpp>

#include "fault/fault.h"
#include "packed/unpack.h"

namespace mapwright::cells {

/// One byte per cell (gray level or palette index) or two (value, alpha), row-major.
struct PngCells {
  packed::ByteBuffer cells;
};

struct PngFailure {
  Fault reason;
  bool is_png = false;  // a PNG of the wrong size or kind, and certainly not raw cells that look like one
};

/// Gray and palette pictures give one byte per cell: gray with fewer than 8 bits is scaled to 0..255, an
/// index stays as it is. Gray with alpha gives (gray, alpha), colour gives (luminance, alpha or 255). Of
/// 16-bit samples the high byte is used. The picture must be width x height; this is checked before any
/// memory is allocated. Precondition: 1 <= width * height <= kMaxCells.
tl::expected<PngCells, PngFailure> decodePngCells(std::span<const std::uint8_t> bytes, int width, int height);

}  // namespace mapwright::cells
