#include "simulator/cell_encoding.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <zlib.h>

#include <libdeflate.h>
#include <spng.h>

namespace mapwright::simulator {
namespace {

constexpr int kDeflateLevel = 1;

struct CompressorDeleter {
  void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
};
using Compressor = std::unique_ptr<libdeflate_compressor, CompressorDeleter>;

enum class Wrapper { Gzip, Zlib };

std::string deflate(std::string_view bytes, Wrapper wrapper) {
  const Compressor compressor(libdeflate_alloc_compressor(kDeflateLevel));
  if (!compressor) return {};
  const bool gzip = wrapper == Wrapper::Gzip;
  std::string out(gzip ? libdeflate_gzip_compress_bound(compressor.get(), bytes.size())
                       : libdeflate_zlib_compress_bound(compressor.get(), bytes.size()),
                  '\0');
  const auto compress = gzip ? libdeflate_gzip_compress : libdeflate_zlib_compress;
  out.resize(compress(compressor.get(), bytes.data(), bytes.size(), out.data(), out.size()));
  return out;
}

struct PngDeleter {
  void operator()(spng_ctx* context) const { spng_ctx_free(context); }
};

std::string png(std::string_view bytes, int width, int height, spng_color_type type) {
  const std::unique_ptr<spng_ctx, PngDeleter> context(spng_ctx_new(SPNG_CTX_ENCODER));
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

}  // namespace mapwright::simulator
