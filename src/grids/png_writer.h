// Rows of 8-bit gray, or gray and alpha, as a PNG. Private to what writes pictures; one thread.
#pragma once

#include <cstdint>
#include <memory>

#include <spng.h>

#include "disk/written_file.h"

namespace mapwright::grids {

struct PngWriter {
  disk::WrittenFile& file;
  std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context{spng_ctx_new(SPNG_CTX_ENCODER), spng_ctx_free};

  bool begin(int width, int height, bool has_alpha);
  /// False: it cannot be written; the file may know why.
  bool row(const std::uint8_t* bytes, std::size_t count);
};

}  // namespace mapwright::grids
