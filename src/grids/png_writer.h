// Writes rows of 8-bit pixels as a PNG; one thread.
#pragma once

#include <cstdint>
#include <memory>

#include <spng.h>

#include "disk/written_file.h"

namespace mapwright::grids {

enum class PngPixels { Gray, GrayAlpha, Rgb };
/// Flat: areas of one value with sharp edges, which PNG filters make larger.
enum class PngContent { Flat, Any };

struct PngWriter {
  disk::WrittenFile& file;
  std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context{spng_ctx_new(SPNG_CTX_ENCODER), spng_ctx_free};
  int failure = 0;  // the last error code of spng

  /// False: it cannot be written; the file may know why.
  bool begin(int width, int height, PngPixels pixels, PngContent content = PngContent::Flat);
  bool row(const std::uint8_t* bytes, std::size_t count);
};

}  // namespace mapwright::grids
