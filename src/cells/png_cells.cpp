#include "cells/png_cells.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <libdeflate.h>
#include <spng.h>

#include "cells/faults.h"
#include "packed/png_unfilter.h"
#include "words/figures.h"

namespace mapwright::cells {

namespace {

constexpr std::size_t kHeaderBytes = 33;      // signature and IHDR
constexpr std::size_t kAsideBytes = 1 << 20;  // for chunks other than pixels: more than any map needs
constexpr std::size_t kSmallestChunkLimit = 1 << 16;

struct FreeContext {
  void operator()(spng_ctx* context) const { spng_ctx_free(context); }
};

std::uint32_t bigEndian(std::span<const std::uint8_t> bytes, std::size_t at) {
  return std::uint32_t(bytes[at]) << 24 | std::uint32_t(bytes[at + 1]) << 16 |
         std::uint32_t(bytes[at + 2]) << 8 | bytes[at + 3];
}

PngFailure unreadable(int error) { return {{fault::PngNotReadBy, {spng_strerror(error)}}, false}; }

std::size_t channelsOf(std::uint8_t colour_type) {
  switch (colour_type) {
    case SPNG_COLOR_TYPE_GRAYSCALE_ALPHA:
      return 2;
    case SPNG_COLOR_TYPE_TRUECOLOR:
      return 3;
    case SPNG_COLOR_TYPE_TRUECOLOR_ALPHA:
      return 4;
    default:
      return 1;
  }
}

/// One row of gray levels or palette indices of 1, 2, 4, 8 or 16 bits.
void convertSingle(const std::uint8_t* row, const spng_ihdr& header, std::uint8_t* out) {
  const std::size_t width = header.width;
  if (header.bit_depth == 8) {
    std::memcpy(out, row, width);
    return;
  }
  if (header.bit_depth == 16) {
    for (std::size_t u = 0; u < width; ++u) {
      out[u] = row[2 * u];
    }
    return;
  }
  const std::size_t depth = header.bit_depth;
  const unsigned largest = (1u << depth) - 1;
  const unsigned scale = header.color_type == SPNG_COLOR_TYPE_GRAYSCALE ? 255 / largest : 1;
  for (std::size_t u = 0; u < width; ++u) {
    const std::size_t bit = u * depth;
    out[u] = std::uint8_t((row[bit / 8] >> (8 - depth - bit % 8) & largest) * scale);
  }
}

/// One row of several samples per pixel, each of 8 or 16 bits, to (value, alpha).
void convertPairs(const std::uint8_t* row, const spng_ihdr& header, std::size_t channels, std::uint8_t* out) {
  const std::size_t sample = header.bit_depth / 8;
  const bool colour = channels >= 3;
  const bool has_alpha = channels % 2 == 0;
  for (std::size_t u = 0; u < header.width; ++u, row += channels * sample) {
    out[2 * u] =
        colour ? std::uint8_t((299u * row[0] + 587u * row[sample] + 114u * row[2 * sample] + 500) / 1000)
               : row[0];
    out[2 * u + 1] = has_alpha ? row[(channels - 1) * sample] : std::uint8_t(255);
  }
}

/// The pixels of an 8-bit picture that is not interlaced, unpacked in one step: twice as fast. nullopt if
/// anything is unusual; libspng then reports what.
std::optional<packed::ByteBuffer> plainPicture(std::span<const std::uint8_t> bytes, const spng_ihdr& header,
                                               std::size_t unit) {
  if (header.bit_depth != 8 || header.interlace_method != SPNG_INTERLACE_NONE) return std::nullopt;
  constexpr std::size_t kAroundData = 12;  // length, type, checksum
  std::vector<std::uint8_t> joined;
  std::span<const std::uint8_t> data;
  bool has_palette = false;
  for (std::size_t at = kHeaderBytes;;) {
    if (bytes.size() - at < kAroundData) return std::nullopt;
    const std::size_t length = bigEndian(bytes, at);
    if (length > bytes.size() - at - kAroundData) return std::nullopt;
    const std::span<const std::uint8_t> typed = bytes.subspan(at + 4, length + 4);
    const std::string_view type(reinterpret_cast<const char*>(typed.data()), 4);
    if (libdeflate_crc32(0, typed.data(), typed.size()) != bigEndian(bytes, at + 8 + length))
      return std::nullopt;
    at += kAroundData + length;
    if (type == "IEND") break;
    if (type == "PLTE" && data.empty() && header.color_type == SPNG_COLOR_TYPE_INDEXED && !has_palette) {
      has_palette = true;
      continue;
    }
    if (type != "IDAT") return std::nullopt;
    if (data.empty()) {
      data = typed.subspan(4);
      continue;
    }
    if (joined.empty()) joined.assign(data.begin(), data.end());
    joined.insert(joined.end(), typed.begin() + 4, typed.end());
    data = joined;
  }
  if (header.color_type == SPNG_COLOR_TYPE_INDEXED && !has_palette) return std::nullopt;
  const std::size_t row_bytes = std::size_t(header.width) * unit, height = header.height;
  const auto filtered = packed::unpack(packed::Container::Zlib, data, (row_bytes + 1) * height);
  if (!filtered || filtered->size != (row_bytes + 1) * height) return std::nullopt;
  packed::ByteBuffer picture{std::make_unique_for_overwrite<std::uint8_t[]>(row_bytes * height),
                             row_bytes * height};
  const std::vector<std::uint8_t> zeros(row_bytes, 0);
  const std::uint8_t* above = zeros.data();
  for (std::size_t v = 0; v < height; ++v) {
    const std::uint8_t* in = filtered->data.get() + v * (row_bytes + 1);
    std::uint8_t* out = picture.data.get() + v * row_bytes;
    if (!packed::unfilterRow(in[0], in + 1, above, row_bytes, unit, out)) return std::nullopt;
    above = out;
  }
  return picture;
}

}  // namespace

tl::expected<PngCells, PngFailure> decodePngCells(std::span<const std::uint8_t> bytes, int width,
                                                  int height) {
  if (bytes.size() < kHeaderBytes) {
    return tl::unexpected(PngFailure{fault::PngShort, false});
  }
  const std::unique_ptr<spng_ctx, FreeContext> context(spng_ctx_new(0));
  if (context == nullptr) {
    return tl::unexpected(PngFailure{fault::PngWithoutMemory, true});
  }
  // No chunk can be longer than the file; without this limit a compressed text could still be unpacked
  // endlessly.
  const std::size_t chunk_limit = std::max(bytes.size(), kSmallestChunkLimit);
  if (spng_set_image_limits(context.get(), std::uint32_t(width), std::uint32_t(height)) != 0 ||
      spng_set_chunk_limits(context.get(), chunk_limit, std::max(chunk_limit, kAsideBytes)) != 0 ||
      spng_set_png_buffer(context.get(), bytes.data(), bytes.size()) != 0) {
    return tl::unexpected(PngFailure{fault::PngNotRead, false});
  }
  spng_ihdr header{};
  const int header_result = spng_get_ihdr(context.get(), &header);
  const bool beyond_limits = header_result == SPNG_EUSER_WIDTH || header_result == SPNG_EUSER_HEIGHT;
  if (header_result != 0 && !beyond_limits) {
    return tl::unexpected(unreadable(header_result));
  }
  const std::uint32_t png_width = bigEndian(bytes, 16);
  const std::uint32_t png_height = bigEndian(bytes, 20);
  if (beyond_limits || png_width != std::uint32_t(width) || png_height != std::uint32_t(height)) {
    return tl::unexpected(PngFailure{
        {fault::PngOfOtherSize, {words::dimensions(png_width, png_height), words::dimensions(width, height)}},
        true});
  }

  const std::size_t channels = channelsOf(header.color_type);
  const std::size_t row_bytes = (std::size_t(width) * channels * header.bit_depth + 7) / 8;
  const std::size_t picture_bytes = row_bytes * std::size_t(height);
  if (picture_bytes / packed::kMaxDeflateRatio > bytes.size()) {
    return tl::unexpected(
        PngFailure{{fault::PngBytesTooFew,
                    {words::grouped(std::int64_t(bytes.size())), words::dimensions(width, height)}},
                   false});
  }
  auto plain = plainPicture(bytes, header, channels);
  const bool is_plain = plain.has_value();
  packed::ByteBuffer picture =
      is_plain
          ? std::move(*plain)
          : packed::ByteBuffer{std::make_unique_for_overwrite<std::uint8_t[]>(picture_bytes), picture_bytes};
  if (header.interlace_method != SPNG_INTERLACE_NONE && header.bit_depth < 8) {
    std::memset(picture.data.get(), 0,
                picture.size);  // libspng adds the bits of each pass to the present content
  }
  const int result =
      is_plain ? 0 : spng_decode_image(context.get(), picture.data.get(), picture.size, SPNG_FMT_RAW, 0);
  if (result != 0) {
    return tl::unexpected(unreadable(result));
  }
  if (channels == 1 && header.bit_depth == 8) {
    return PngCells{std::move(picture)};
  }

  const std::size_t cell_bytes = channels == 1 ? 1 : 2;
  const std::size_t cells_bytes = std::size_t(width) * std::size_t(height) * cell_bytes;
  packed::ByteBuffer cells{std::make_unique_for_overwrite<std::uint8_t[]>(cells_bytes), cells_bytes};
  for (std::size_t v = 0; v < std::size_t(height); ++v) {
    const std::uint8_t* row = picture.data.get() + v * row_bytes;
    std::uint8_t* out = cells.data.get() + v * std::size_t(width) * cell_bytes;
    if (channels == 1) {
      convertSingle(row, header, out);
    } else {
      convertPairs(row, header, channels, out);
    }
  }
  return PngCells{std::move(cells)};
}

}  // namespace mapwright::cells
