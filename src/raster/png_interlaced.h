// Adam7: the seven passes of a PNG put together. Source: PNG specification (third edition), "Interlacing".
#pragma once

#include "raster/picture_rows.h"
#include "raster/png_header.h"

namespace mapwright::raster {

/// Needs room for the whole picture: in memory up to 64 MB, beyond that in a temporary file without a name.
tl::expected<std::unique_ptr<PictureRows>, GridError> openInterlacedPng(const PngHeader& header,
                                                                        ByteSource bytes);

}  // namespace mapwright::raster
