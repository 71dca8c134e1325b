// Decodes the bytes of a slice into cells: container, layout, bounds. Source:
// docs/protocols/cartographer-submaps.md, "Containers and cell layouts". Pure functions, any thread.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include <tl/expected.hpp>

#include "cells/cell_texture.h"
#include "fault/fault.h"

namespace mapwright::cells {

inline constexpr std::int64_t kMaxCells = std::int64_t(64) << 20;  // 64 Mi

/// Decodes the cells of one slice. `bytes` may be PNG, gzip, zlib or raw; the layout is 1 or 2 bytes per cell
/// (1 byte: by cell_format). Never reads or allocates more than width*height allows, whatever the bytes
/// claim. Data that looks like a container but cannot be unpacked is treated as raw if its size fits exactly.
/// The error says what is wrong: "3,200 bytes where 51,200 (or 102,400) were expected".
tl::expected<std::shared_ptr<const CellTexture>, Fault> decodeCells(std::span<const std::uint8_t> bytes,
                                                                    int width, int height,
                                                                    double resolution_m, int cell_format);

}  // namespace mapwright::cells
