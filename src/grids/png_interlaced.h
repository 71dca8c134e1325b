// Adam7: combines the seven passes of a PNG. Source: PNG specification (third edition), "Interlacing".
#pragma once

#include "grids/picture_rows.h"
#include "grids/png_header.h"

namespace mapwright::grids {

/// The maximum unpacked size of an interlaced picture (16,384 x 16,384 grays): all seven passes are needed
/// before the first row is complete, so a small file must not demand unlimited memory. No program that writes
/// maps interlaces them.
inline constexpr std::uint64_t kMaxInterlacedBytes = std::uint64_t(1) << 28;

/// Needs space for the whole picture: in memory up to 64 MB, beyond that in an unnamed temporary file.
tl::expected<std::unique_ptr<PictureRows>, Fault> openInterlacedPng(const PngHeader& header,
                                                                    ByteSource bytes);

}  // namespace mapwright::grids
