// Adam7: the seven passes of a PNG put together. Source: PNG specification (third edition), "Interlacing".
#pragma once

#include "grids/picture_rows.h"
#include "grids/png_header.h"

namespace mapwright::grids {

/// As many bytes an interlaced picture may have unpacked (16,384 x 16,384 grays): its seven passes have to be
/// put together before the first row is whole, so what a small file asks for must have an end. No program
/// that writes maps interlaces them.
inline constexpr std::uint64_t kMaxInterlacedBytes = std::uint64_t(1) << 28;

/// Needs room for the whole picture: in memory up to 64 MB, beyond that in a temporary file without a name.
tl::expected<std::unique_ptr<PictureRows>, Fault> openInterlacedPng(const PngHeader& header,
                                                                    ByteSource bytes);

}  // namespace mapwright::grids
