#include "grids/png_writer.h"

namespace mapwright::grids {

namespace {

int writeBytes(spng_ctx*, void* user, void* bytes, std::size_t count) {
  auto& out = *static_cast<disk::WrittenFile*>(user);
  out.write(bytes, count);
  return out.good() ? 0 : int(SPNG_IO_ERROR);
}

}  // namespace

bool PngWriter::begin(int width, int height, PngPixels pixels, PngContent content) {
  spng_ihdr header{};
  header.width = std::uint32_t(width);
  header.height = std::uint32_t(height);
  header.bit_depth = 8;
  header.color_type = pixels == PngPixels::Rgb         ? SPNG_COLOR_TYPE_TRUECOLOR
                      : pixels == PngPixels::GrayAlpha ? SPNG_COLOR_TYPE_GRAYSCALE_ALPHA
                                                       : SPNG_COLOR_TYPE_GRAYSCALE;
  const auto did = [this](int result) { return (failure = result) == 0; };
  const bool flat = content == PngContent::Flat;
  return context != nullptr && did(spng_set_png_stream(context.get(), writeBytes, &file)) &&
         (!flat || (did(spng_set_option(context.get(), SPNG_FILTER_CHOICE, SPNG_DISABLE_FILTERING)) &&
                    did(spng_set_option(context.get(), SPNG_IMG_COMPRESSION_LEVEL, 4)))) &&
         did(spng_set_ihdr(context.get(), &header)) &&
         did(spng_encode_image(context.get(), nullptr, 0, SPNG_FMT_PNG,
                               SPNG_ENCODE_PROGRESSIVE | SPNG_ENCODE_FINALIZE));
}

bool PngWriter::row(const std::uint8_t* bytes, std::size_t count) {
  const int result = spng_encode_row(context.get(), bytes, count);
  failure = result == SPNG_EOI ? 0 : result;
  return failure == 0;
}

}  // namespace mapwright::grids
