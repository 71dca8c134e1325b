#include "simulator/encoding.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <zlib.h>

#include <libdeflate.h>
#include <spng.h>

#include "simulator/noise.h"
#include "simulator/value.h"

namespace mapwright::simulator {
namespace {

constexpr int kDeflateLevel = 1;
constexpr std::size_t kHeaderAt = 8;      // behind the signature
constexpr std::size_t kHeaderBytes = 13;  // of IHDR
constexpr char kGray = 0, kRgb = 2;
constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);
constexpr std::uint32_t kLongestEdge = 20'000;
constexpr double kMostPixels = 32e6;

enum class Wrapper { Gzip, Zlib };

std::string deflate(std::string_view bytes, Wrapper wrapper) {
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(kDeflateLevel), &libdeflate_free_compressor);
  if (!compressor) return {};
  const bool gzip = wrapper == Wrapper::Gzip;
  std::string out(gzip ? libdeflate_gzip_compress_bound(compressor.get(), bytes.size())
                       : libdeflate_zlib_compress_bound(compressor.get(), bytes.size()),
                  '\0');
  const auto compress = gzip ? libdeflate_gzip_compress : libdeflate_zlib_compress;
  out.resize(compress(compressor.get(), bytes.data(), bytes.size(), out.data(), out.size()));
  return out;
}

using PngContext = std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)>;

std::string png(std::string_view bytes, int width, int height, spng_color_type type) {
  const PngContext context(spng_ctx_new(SPNG_CTX_ENCODER), &spng_ctx_free);
  if (!context) return {};
  spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1);
  spng_set_option(context.get(), SPNG_IMG_COMPRESSION_LEVEL, 1);
  spng_set_option(context.get(), SPNG_IMG_COMPRESSION_STRATEGY, Z_RLE);  // fast, and grids are runs
  spng_set_option(context.get(), SPNG_FILTER_CHOICE, SPNG_DISABLE_FILTERING);
  spng_ihdr header{};
  header.width = static_cast<std::uint32_t>(width);
  header.height = static_cast<std::uint32_t>(height);
  header.bit_depth = 8;
  header.color_type = static_cast<std::uint8_t>(type);
  spng_set_ihdr(context.get(), &header);
  if (type == SPNG_COLOR_TYPE_INDEXED) {
    // Colours for people who open the file; what counts are the indices.
    spng_plte palette{};
    palette.n_entries = 256;
    for (unsigned i = 0; i < 256; ++i) {
      const auto level = static_cast<std::uint8_t>(255 - i);
      palette.entries[i] = {level, i > 160 ? std::uint8_t{40} : level, i == 0 ? std::uint8_t{160} : level,
                            255};
    }
    spng_set_plte(context.get(), &palette);
  }
  if (spng_encode_image(context.get(), bytes.data(), bytes.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE) != 0)
    return {};
  std::size_t size = 0;
  int error = 0;
  const std::unique_ptr<void, decltype(&std::free)> buffer(spng_get_png_buffer(context.get(), &size, &error),
                                                           &std::free);
  return buffer && error == 0 ? std::string(static_cast<const char*>(buffer.get()), size) : std::string();
}

/// A brightness in 1..255: open floor is bright, walls are dark.
int intensityOf(int cell) { return std::clamp(128 + (128 - cell) * 3, 1, 255); }

/// One byte per cell, by format.
std::string asBytes(const std::vector<std::uint8_t>& cells, CellFormat format) {
  std::array<char, 256> byte_of{};
  for (int v = 1; v < 256; ++v) {
    byte_of[static_cast<std::size_t>(v)] =
        static_cast<char>(format == CellFormat::LogOdds     ? v
                          : format == CellFormat::TsdfDelta ? 256 - v
                                                            : intensityOf(v));
  }
  std::string out(cells.size(), '\0');
  std::transform(cells.begin(), cells.end(), out.begin(), [&](std::uint8_t cell) { return byte_of[cell]; });
  return out;
}

/// (value, alpha) as Cartographer paints them.
std::string asPairs(const std::vector<std::uint8_t>& cells, CellFormat format) {
  std::array<std::array<char, 2>, 256> pair_of{};
  for (int v = 1; v < 256; ++v) {
    const int delta = 128 - v;
    int value = delta > 0 ? delta : 0;
    int alpha = delta > 0 ? 0 : delta < 0 ? -delta : 1;
    if (format == CellFormat::Intensity) {
      value = intensityOf(v);
      alpha = 255;
    }
    pair_of[static_cast<std::size_t>(v)] = {static_cast<char>(value), static_cast<char>(alpha)};
  }
  std::string out(cells.size() * 2, '\0');
  for (std::size_t i = 0; i < cells.size(); ++i) std::memcpy(out.data() + 2 * i, pair_of[cells[i]].data(), 2);
  return out;
}

void appendChunk(std::string& out, std::string_view type, std::string_view data) {
  appendNumber(out, static_cast<std::uint32_t>(data.size()), true);
  const std::size_t from = out.size();
  out += type;
  out += data;
  appendNumber(out, libdeflate_crc32(0, out.data() + from, out.size() - from), true);
}

/// Rows of `bits` per pixel, each behind the byte that says "not filtered".
std::string packedRows(const GrayPicture& picture, int bits) {
  const auto width = static_cast<std::size_t>(picture.width),
             height = static_cast<std::size_t>(picture.height);
  const std::size_t stride = 1 + (width * static_cast<std::size_t>(bits) + 7) / 8;
  std::string rows(stride * height, '\0');
  for (std::size_t v = 0; v < height; ++v) {
    const std::uint8_t* levels = picture.levels.data() + v * width;
    char* row = rows.data() + v * stride + 1;
    if (bits == 8) {
      std::memcpy(row, levels, width);
      continue;
    }
    for (std::size_t u = 0; u < width; ++u) {
      const std::size_t bit = u * static_cast<std::size_t>(bits);
      const unsigned value = static_cast<unsigned>(levels[u]) >> (8 - bits);
      const auto shift = static_cast<unsigned>(8 - bits) - static_cast<unsigned>(bit % 8);
      row[bit / 8] = static_cast<char>(static_cast<unsigned char>(row[bit / 8]) | (value << shift));
    }
  }
  return rows;
}

std::string assemble(int width, int height, int bits, char colours, const std::string& rows) {
  std::string header;
  appendNumber(header, width, true);
  appendNumber(header, height, true);
  header += static_cast<char>(bits);
  header += colours;
  header.append(3, '\0');  // deflate, adaptive filtering, not interlaced
  std::string png(kSignature);
  appendChunk(png, "IHDR", header);
  appendChunk(png, "IDAT", deflate(rows, Wrapper::Zlib));
  appendChunk(png, "IEND", {});
  return png;
}

}  // namespace

std::string packCells(const std::vector<std::uint8_t>& cells, int width, int height, Packing packing,
                      CellFormat format) {
  switch (packing) {
    case Packing::PngGray:
      return png(asBytes(cells, format), width, height, SPNG_COLOR_TYPE_GRAYSCALE);
    case Packing::PngPalette:
      return png(asBytes(cells, format), width, height, SPNG_COLOR_TYPE_INDEXED);
    case Packing::PngGrayAlpha:
      return png(asPairs(cells, format), width, height, SPNG_COLOR_TYPE_GRAYSCALE_ALPHA);
    case Packing::GzipPairs:
      return deflate(asPairs(cells, format), Wrapper::Gzip);
    case Packing::ZlibPairs:
      return deflate(asPairs(cells, format), Wrapper::Zlib);
    case Packing::RawPairs:
      return asPairs(cells, format);
    case Packing::RawBytes:
      return asBytes(cells, format);
    case Packing::GzipBytes:
      return deflate(asBytes(cells, format), Wrapper::Gzip);
  }
  return {};
}

std::string gzip(std::string_view bytes) { return deflate(bytes, Wrapper::Gzip); }

std::string writePng(const GrayPicture& picture, int bits) {
  return assemble(picture.width, picture.height, bits, kGray, packedRows(picture, bits));
}

std::string writeRgbPng(int width, int height, std::string_view pixels) {
  const std::size_t stride = 3 * static_cast<std::size_t>(width);
  std::string rows;
  rows.reserve(pixels.size() + static_cast<std::size_t>(height));
  for (std::size_t from = 0; from < pixels.size(); from += stride) {
    rows += '\0';  // not filtered
    rows += pixels.substr(from, stride);
  }
  return assemble(width, height, 8, kRgb, rows);
}

std::string withDeclaredSize(std::string png, std::uint32_t width, std::uint32_t height) {
  const std::size_t end = kHeaderAt + 8 + kHeaderBytes + 4;
  if (png.size() < end) return png;
  std::string data;
  appendNumber(data, width, true);
  appendNumber(data, height, true);
  data += png.substr(kHeaderAt + 16, kHeaderBytes - 8);
  std::string chunk;
  appendChunk(chunk, "IHDR", data);
  return png.replace(kHeaderAt, end - kHeaderAt, chunk);
}

std::optional<GrayPicture> readPng(const std::string& png) {
  const PngContext context(spng_ctx_new(0), &spng_ctx_free);
  spng_ihdr header{};
  if (!context || spng_set_image_limits(context.get(), kLongestEdge, kLongestEdge) != 0 ||
      spng_set_png_buffer(context.get(), png.data(), png.size()) != 0 ||
      spng_get_ihdr(context.get(), &header) != 0 || double(header.width) * header.height > kMostPixels)
    return std::nullopt;
  std::size_t size = 0;
  if (spng_decoded_image_size(context.get(), SPNG_FMT_RGBA8, &size) != 0) return std::nullopt;
  std::vector<std::uint8_t> rgba(size);
  if (spng_decode_image(context.get(), rgba.data(), size, SPNG_FMT_RGBA8, SPNG_DECODE_TRNS) != 0)
    return std::nullopt;
  GrayPicture picture{static_cast<int>(header.width), static_cast<int>(header.height), {}};
  picture.levels.reserve(size / 4);
  for (std::size_t i = 0; i + 3 < size; i += 4) {
    const int gray = (299 * rgba[i] + 587 * rgba[i + 1] + 114 * rgba[i + 2] + 500) / 1000;
    picture.levels.push_back(rgba[i + 3] < 128 ? kUnknownShade : static_cast<std::uint8_t>(gray));
  }
  return picture;
}

std::string contentHash(std::string_view bytes) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::uint64_t h = hashOf(bytes.size(), libdeflate_crc32(0, bytes.data(), bytes.size()));
  for (std::size_t i = 0; i + 8 <= bytes.size(); i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + i, 8);
    h = mix(h ^ word);
  }
  std::string text;
  for (unsigned part = 0; part < 4; ++part) {
    const std::uint64_t word = hashOf(h, part);
    for (unsigned shift = 0; shift < 64; shift += 4) text += kDigits[(word >> shift) & 15];
  }
  return text;
}

}  // namespace mapwright::simulator
