#include "net/rosbridge/png_text.h"

#include <memory>

#include <spng.h>

namespace mapwright::net::rosbridge {
namespace {

constexpr std::size_t kMostUnpacked = 1032;  // bytes that one byte of deflate can expand to

}  // namespace

std::optional<QByteArray> textOfPng(std::string_view png, std::size_t max) {
  const std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)> reader(spng_ctx_new(0), &spng_ctx_free);
  spng_ihdr header{};
  if (!reader || spng_set_png_buffer(reader.get(), png.data(), png.size()) != 0 ||
      spng_get_ihdr(reader.get(), &header) != 0) {
    return std::nullopt;
  }
  if (header.color_type != SPNG_COLOR_TYPE_TRUECOLOR || header.bit_depth != 8) return std::nullopt;
  // Each side has at most 31 bits.
  const std::uint64_t pixels = std::uint64_t(header.width) * header.height;
  if (pixels > max / 3 || pixels * 3 / kMostUnpacked > png.size()) return std::nullopt;
  std::size_t bytes = 0;
  if (spng_decoded_image_size(reader.get(), SPNG_FMT_RGB8, &bytes) != 0 || bytes > max) return std::nullopt;
  QByteArray text(qsizetype(bytes), Qt::Uninitialized);
  if (spng_decode_image(reader.get(), text.data(), bytes, SPNG_FMT_RGB8, 0) != 0) return std::nullopt;
  qsizetype end = text.size();
  while (end > 0 && (text[end - 1] == '\n' || text[end - 1] == '\0')) --end;
  text.truncate(end);
  return text;
}

}  // namespace mapwright::net::rosbridge
