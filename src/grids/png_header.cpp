#include "grids/png_header.h"

#include <algorithm>
#include <isa-l/crc.h>
#include <vector>

#include "grids/faults.h"
#include "words/figures.h"

namespace mapwright::grids {

namespace {

constexpr std::uint64_t kSignatureBytes = 8;
constexpr std::uint32_t kLargestLength = 0x7fffffff;
constexpr std::uint32_t kLargestPalette = 3 * 256;
constexpr std::uint32_t kHeaderLength = 13;

enum ColourType { kGray = 0, kRgb = 2, kPalette = 3, kGrayAlpha = 4, kRgba = 6 };

std::uint32_t bigEndian(const std::uint8_t* at) {
  return std::uint32_t(at[0]) << 24 | std::uint32_t(at[1]) << 16 | std::uint32_t(at[2]) << 8 | at[3];
}

tl::unexpected<Fault> refused(Fault why) { return tl::unexpected(std::move(why)); }

bool depthFits(int colour_type, int depth) {
  switch (colour_type) {
    case kGray:
      return depth == 1 || depth == 2 || depth == 4 || depth == 8 || depth == 16;
    case kPalette:
      return depth == 1 || depth == 2 || depth == 4 || depth == 8;
    case kRgb:
    case kGrayAlpha:
    case kRgba:
      return depth == 8 || depth == 16;
    default:
      return false;
  }
}

int channelsOf(int colour_type) {
  return colour_type == kRgb ? 3 : colour_type == kGrayAlpha ? 2 : colour_type == kRgba ? 4 : 1;
}

/// The content of a chunk if its checksum is right.
std::optional<std::vector<std::uint8_t>> contentOf(const ByteSource& bytes, std::uint64_t offset,
                                                   std::uint32_t length) {
  std::vector<std::uint8_t> content(std::size_t(length) + 8);  // type, data, checksum
  if (!bytes.readAt(offset + 4, content.data(), content.size())) return std::nullopt;
  const std::uint32_t sum = crc32_gzip_refl(0, content.data(), std::size_t(length) + 4);
  if (sum != bigEndian(content.data() + content.size() - 4)) return std::nullopt;
  content.resize(content.size() - 4);
  content.erase(content.begin(), content.begin() + 4);
  return content;
}

tl::expected<PngHeader, Fault> fromIhdr(const std::vector<std::uint8_t>& ihdr) {
  const std::uint32_t width = bigEndian(ihdr.data()), height = bigEndian(ihdr.data() + 4);
  if (auto problem = notThisSizeReason(width, height)) return tl::unexpected(std::move(*problem));
  const int depth = ihdr[8], colour_type = ihdr[9];
  if (!depthFits(colour_type, depth)) {
    return refused(
        {faultText("grids",
                   "It is a PNG of colour type %1 with %2 bits per sample, which the format does not allow."),
         {std::to_string(colour_type), std::to_string(depth)}});
  }
  if (ihdr[10] != 0 || ihdr[11] != 0 || ihdr[12] > 1) {
    return refused(faultText(
        "grids", "It is a PNG with a compression, filter or interlace method that does not exist."));
  }
  PngHeader header;
  header.bit_depth = depth;
  header.stored_channels = channelsOf(colour_type);
  header.interlaced = ihdr[12] == 1;
  PixelFormat& format = header.format;
  format.width = int(width);
  format.height = int(height);
  format.gray = colour_type == kGray || colour_type == kGrayAlpha;
  format.has_alpha = colour_type == kGrayAlpha || colour_type == kRgba;
  format.indexed = colour_type == kPalette || (colour_type == kGray && depth <= 8);
  format.channels = header.stored_channels;
  format.sample_bytes = depth == 16 ? 2 : 1;
  format.sample_max = depth == 16 ? 65535 : 255;
  if (colour_type == kGray && depth <= 8) {
    const int largest = (1 << depth) - 1;
    for (int level = 0; level <= largest; ++level) {
      const std::uint8_t gray = std::uint8_t(level * 255 / largest);
      format.table[std::size_t(level)] = {gray, gray, gray, 255};
    }
  }
  return header;
}

void readPalette(const std::vector<std::uint8_t>& plte, PixelFormat& format) {
  for (std::size_t n = 0; n < plte.size() / 3; ++n) {
    format.table[n] = {plte[3 * n], plte[3 * n + 1], plte[3 * n + 2], 255};
  }
}

void readTransparency(const std::vector<std::uint8_t>& trns, bool palette, int depth, PixelFormat& format) {
  if (palette) {
    for (std::size_t n = 0; n < std::min<std::size_t>(trns.size(), 256); ++n) format.table[n].a = trns[n];
    format.has_alpha = true;
    return;
  }
  const std::size_t samples = format.gray ? 1 : 3;
  if (format.has_alpha || trns.size() < 2 * samples) return;  // meaningless with an alpha channel
  format.has_alpha = true;
  if (format.indexed) {
    format.table[trns[1] & ((1u << depth) - 1)].a = 0;
    return;
  }
  std::array<std::uint16_t, 3> key{};
  for (std::size_t n = 0; n < samples; ++n) {
    key[n] = std::uint16_t((trns[2 * n] << 8 | trns[2 * n + 1]) & (depth == 16 ? 0xffff : 0xff));
  }
  format.transparent = key;
}

}  // namespace

std::optional<PngChunk> pngChunkAt(const ByteSource& bytes, std::uint64_t offset) {
  std::array<std::uint8_t, 8> start{};
  if (!bytes.readAt(offset, start.data(), start.size())) return std::nullopt;
  PngChunk chunk;
  chunk.length = bigEndian(start.data());
  std::copy(start.begin() + 4, start.end(), chunk.type.begin());
  return chunk;
}

tl::expected<PngHeader, Fault> readPngHeader(const ByteSource& bytes) {
  const auto first = pngChunkAt(bytes, kSignatureBytes);
  if (!first) return refused(fault::PngHeaderShort);
  if (!first->is("IHDR") || first->length != kHeaderLength) {
    return refused(faultText("grids", "It starts like a PNG, but its header is not in the right place."));
  }
  if (bytes.size() < kSignatureBytes + kHeaderLength + PngChunk::kAround)
    return refused(fault::PngHeaderShort);
  const auto ihdr = contentOf(bytes, kSignatureBytes, kHeaderLength);
  if (!ihdr) return refused(faultText("grids", "It is a PNG with a damaged header (wrong checksum)."));
  auto header = fromIhdr(*ihdr);
  if (!header) return header;

  const bool palette = (*ihdr)[9] == kPalette;
  bool has_palette = false;
  std::uint64_t at = kSignatureBytes + kHeaderLength + PngChunk::kAround;
  for (;;) {
    const auto chunk = pngChunkAt(bytes, at);
    if (!chunk) return refused(fault::PngEndsBeforePixels);
    if (chunk->is("IDAT")) break;
    if (chunk->length > kLargestLength || chunk->is("IEND")) {
      return refused(faultText("grids", "It is a PNG without pixels."));
    }
    const bool is_palette = chunk->is("PLTE");
    if ((is_palette && chunk->length <= kLargestPalette) || (chunk->is("tRNS") && chunk->length <= 256)) {
      if (at + PngChunk::kAround + chunk->length > bytes.size()) {
        return refused(fault::PngEndsBeforePixels);
      }
      const auto content = contentOf(bytes, at, chunk->length);
      if (!content) {
        return refused(
            is_palette
                ? faultText("grids", "It is a PNG with a damaged palette (wrong checksum).")
                : faultText("grids", "It is a PNG with a damaged transparency chunk (wrong checksum)."));
      }
      if (is_palette && palette) {
        readPalette(*content, header->format);
        has_palette = true;
      } else if (!is_palette) {
        readTransparency(*content, palette, header->bit_depth, header->format);
      }
    } else if (chunk->is("acTL")) {
      std::array<std::uint8_t, 4> pictures{};
      const bool whole = bytes.readAt(at + 8, pictures.data(), pictures.size());
      header->animated = whole && bigEndian(pictures.data()) > 1;
    } else if ((chunk->type[0] & 0x20) == 0 && !is_palette) {
      return refused(faultText("grids", "It is a PNG with a critical chunk that is not in the standard."));
    }
    at += PngChunk::kAround + chunk->length;
  }
  if (palette && !has_palette) return refused(faultText("grids", "It is a PNG whose palette is missing."));
  header->pixels_at = at;
  return header;
}

}  // namespace mapwright::grids
