#include "cells/decode_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <libdeflate.h>
#include <spng.h>

#include "cells/faults.h"
#include "packed/png_unfilter.h"
#include "packed/unpack.h"
#include "words/figures.h"

namespace mapwright::cells {

namespace {

using Texture = std::shared_ptr<const CellTexture>;

constexpr double kMinResolutionM = 1e-4;
constexpr double kMaxResolutionM = 100;

enum CellFormat : int { kLogOdds = 0, kTsdfDelta = 1, kIntensity = 2 };

struct Shape {
  int width = 0, height = 0;
  double resolution_m = 0;
  std::size_t cells() const { return std::size_t(width) * std::size_t(height); }
};

tl::unexpected<Fault> failure(Fault reason) { return tl::unexpected(std::move(reason)); }

/// With the expected numbers of bytes.
Fault wrongCount(FaultCode code, std::size_t bytes, const Shape& shape) {
  return {code,
          {words::grouped(std::int64_t(bytes)), words::grouped(std::int64_t(shape.cells())),
           words::grouped(std::int64_t(2 * shape.cells()))}};
}

/// delta as CellLayout::Folded has it, for every byte of LOG_ODDS or TSDF_DELTA.
std::array<std::uint8_t, 256> foldedByByte(int cell_format) {
  std::array<std::uint8_t, 256> table{};
  for (int v = 1; v < 256; ++v) {
    const int delta = cell_format == kLogOdds ? 128 - v : v - 128;
    table[std::size_t(v)] = std::uint8_t(delta == 0 ? -1 : delta);
  }
  return table;
}

tl::expected<Texture, Fault> fromSingleBytes(std::span<const std::uint8_t> cells, const Shape& shape,
                                             int cell_format) {
  if (cell_format == kLogOdds || cell_format == kTsdfDelta) {
    const std::array<std::uint8_t, 256> table = foldedByByte(cell_format);
    std::vector<std::uint8_t> folded(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      folded[i] = table[cells[i]];
    }
    return CellTexture::fromFolded(shape.width, shape.height, shape.resolution_m, folded);
  }
  if (cell_format == kIntensity) {
    std::vector<CellPair> pairs(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      pairs[i] = {cells[i], std::uint8_t(cells[i] == 0 ? 0 : 255)};
    }
    return CellTexture::fromPairs(shape.width, shape.height, shape.resolution_m, pairs);
  }
  return failure(
      {faultText("cells", "cell format %1 is unknown: with one byte per cell only 0, 1 and 2 are supported"),
       {words::grouped(cell_format)}});
}

/// Cells without a container.
tl::expected<Texture, Fault> fromPlain(std::span<const std::uint8_t> bytes, const Shape& shape,
                                       int cell_format) {
  if (bytes.size() == shape.cells()) {
    return fromSingleBytes(bytes, shape, cell_format);
  }
  if (bytes.size() == 2 * shape.cells()) {
    // CellPair is two bytes without padding, so the bytes are the pairs.
    const auto* pairs = reinterpret_cast<const CellPair*>(bytes.data());
    return CellTexture::fromPairs(shape.width, shape.height, shape.resolution_m, {pairs, shape.cells()});
  }
  return failure(wrongCount(fault::BytesUnexpected, bytes.size(), shape));
}

Fault notUnpackedReason(packed::Container container, packed::UnpackFailure why, const Shape& shape) {
  if (why == packed::UnpackFailure::TooLong)
    return wrongCount(faultText("cells", "more than %1 bytes where %2 (or %3) were expected"),
                      2 * shape.cells(), shape);
  return container == packed::Container::Gzip ? fault::GzipDamaged
                                              : faultText("cells", "the zlib data is damaged or cut off");
}

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

struct PngFailure {
  Fault reason;
  bool is_png = false;  // a PNG of the wrong size or kind, and certainly not raw cells that look like one
};

PngFailure unreadable(int error) {
  return {{faultText("cells", "the PNG cannot be read (%1)"), {spng_strerror(error)}}, false};
}

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

/// The cells of a PNG. Gray and palette pictures give one byte per cell: gray with fewer than 8 bits is
/// scaled to 0..255, an index stays as it is. Gray with alpha gives (gray, alpha), colour gives (luminance,
/// alpha or 255). Of 16-bit samples the high byte is used. The picture must be width x height; this is
/// checked before any memory is allocated. Precondition: 1 <= width * height <= kMaxCells.
tl::expected<packed::ByteBuffer, PngFailure> decodePngCells(std::span<const std::uint8_t> bytes, int width,
                                                            int height) {
  if (bytes.size() < kHeaderBytes) {
    return tl::unexpected(PngFailure{faultText("cells", "the PNG header is cut off"), false});
  }
  const std::unique_ptr<spng_ctx, FreeContext> context(spng_ctx_new(0));
  if (context == nullptr) {
    return tl::unexpected(PngFailure{faultText("cells", "there is not enough memory to read the PNG"), true});
  }
  // No chunk can be longer than the file; without this limit a compressed text could still be unpacked
  // endlessly.
  const std::size_t chunk_limit = std::max(bytes.size(), kSmallestChunkLimit);
  if (spng_set_image_limits(context.get(), std::uint32_t(width), std::uint32_t(height)) != 0 ||
      spng_set_chunk_limits(context.get(), chunk_limit, std::max(chunk_limit, kAsideBytes)) != 0 ||
      spng_set_png_buffer(context.get(), bytes.data(), bytes.size()) != 0) {
    return tl::unexpected(PngFailure{faultText("cells", "the PNG cannot be read"), false});
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
    return tl::unexpected(
        PngFailure{{faultText("cells", "the PNG is %1 but should be %2"),
                    {words::dimensions(png_width, png_height), words::dimensions(width, height)}},
                   true});
  }

  const std::size_t channels = channelsOf(header.color_type);
  const std::size_t row_bytes = (std::size_t(width) * channels * header.bit_depth + 7) / 8;
  const std::size_t picture_bytes = row_bytes * std::size_t(height);
  if (picture_bytes / packed::kMaxDeflateRatio > bytes.size()) {
    return tl::unexpected(
        PngFailure{{faultText("cells", "the PNG is cut off: %1 bytes are too few for %2 pixels"),
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
    return picture;
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
  return cells;
}

}  // namespace

tl::expected<Texture, Fault> decodeCells(std::span<const std::uint8_t> bytes, int width, int height,
                                         double resolution_m, int cell_format) {
  if (width < 1 || height < 1) {
    return failure(
        {faultText("cells", "the texture claims to have %1 cells"), {words::dimensions(width, height)}});
  }
  if (std::int64_t(width) * std::int64_t(height) > kMaxCells) {
    return failure({faultText("cells", "the texture claims to have %1 cells; at most %2 are allowed"),
                    {words::dimensions(width, height), words::grouped(kMaxCells)}});
  }
  if (!std::isfinite(resolution_m) || resolution_m <= 0) {
    return failure(faultText("cells", "the cell size is not a positive number of metres"));
  }
  if (resolution_m < kMinResolutionM) {
    return failure(faultText("cells", "the cell size is less than 0.1 mm"));
  }
  if (resolution_m > kMaxResolutionM) {
    return failure(faultText("cells", "the cell size is more than 100 m"));
  }
  const Shape shape{width, height, resolution_m};
  const bool may_be_plain = bytes.size() == shape.cells() || bytes.size() == 2 * shape.cells();

  const packed::Container container = packed::sniffContainer(bytes);
  if (container == packed::Container::Raw) {
    return fromPlain(bytes, shape, cell_format);
  }
  if (container == packed::Container::Png) {
    const auto png = decodePngCells(bytes, width, height);
    if (png) {
      return fromPlain(png->bytes(), shape, cell_format);
    }
    if (may_be_plain && !png.error().is_png) {
      return fromPlain(bytes, shape, cell_format);
    }
    return failure(png.error().reason);
  }
  const auto unpacked = packed::unpack(container, bytes, 2 * shape.cells());
  if (unpacked) {
    return fromPlain(unpacked->bytes(), shape, cell_format);
  }
  if (may_be_plain) {
    return fromPlain(bytes, shape, cell_format);
  }
  return failure(notUnpackedReason(container, unpacked.error(), shape));
}

}  // namespace mapwright::cells
