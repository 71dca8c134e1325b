#include "grids/png_writer.h"

namespace mapwright::grids {

namespace {

int writeBytes(spng_ctx*, void* user, void* bytes, std::size_t count) {
  auto& out = *static_cast<disk::WrittenFile*>(user);
  out.write(bytes, count);
  return out.good() ? 0 : int(SPNG_IO_ERROR);
}

}  // namespace

bool PngWriter::begin(int width, int height, bool has_alpha) {
  spng_ihdr header{};
  header.width = std::uint32_t(width);
  header.height = std::uint32_t(height);
  header.bit_depth = 8;
  header.color_type = has_alpha ? SPNG_COLOR_TYPE_GRAYSCALE_ALPHA : SPNG_COLOR_TYPE_GRAYSCALE;
  // Flat areas and sharp edges: filters make maps larger, not smaller.
  return context != nullptr && spng_set_png_stream(context.get(), writeBytes, &file) == 0 &&
         spng_set_option(context.get(), SPNG_FILTER_CHOICE, SPNG_DISABLE_FILTERING) == 0 &&
         spng_set_option(context.get(), SPNG_IMG_COMPRESSION_LEVEL, 4) == 0 &&
         spng_set_ihdr(context.get(), &header) == 0 &&
         spng_encode_image(context.get(), nullptr, 0, SPNG_FMT_PNG,
                           SPNG_ENCODE_PROGRESSIVE | SPNG_ENCODE_FINALIZE) == 0;
}

bool PngWriter::row(const std::uint8_t* bytes, std::size_t count) {
  const int result = spng_encode_row(context.get(), bytes, count);
  return result == 0 || result == SPNG_EOI;
}

}  // namespace mapwright::grids
