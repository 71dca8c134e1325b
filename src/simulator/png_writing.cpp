#include "simulator/png_writing.h"

#include <cstring>
#include <memory>

#include <libdeflate.h>

#include "simulator/noise.h"

namespace mapwright::simulator {
namespace {

constexpr int kPngDeflateLevel = 1;
constexpr std::size_t kHeaderAt = 8;      // behind the signature
constexpr std::size_t kHeaderBytes = 13;  // of IHDR
constexpr char kGray = 0, kRgb = 2;
constexpr std::string_view kSignature("\x89PNG\r\n\x1a\n", 8);

void appendBig(std::string& out, std::uint32_t value) {
  for (const int shift : {24, 16, 8, 0}) out += static_cast<char>((value >> shift) & 0xFF);
}

void appendChunk(std::string& out, std::string_view type, std::string_view data) {
  appendBig(out, static_cast<std::uint32_t>(data.size()));
  const std::size_t from = out.size();
  out += type;
  out += data;
  appendBig(out, libdeflate_crc32(0, out.data() + from, out.size() - from));
}

struct PngCompressorDeleter {
  void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
};

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
  appendBig(header, static_cast<std::uint32_t>(width));
  appendBig(header, static_cast<std::uint32_t>(height));
  header += static_cast<char>(bits);
  header += colours;
  header.append(3, '\0');  // deflate, adaptive filtering, not interlaced

  const std::unique_ptr<libdeflate_compressor, PngCompressorDeleter> compressor(
      libdeflate_alloc_compressor(kPngDeflateLevel));
  if (!compressor) return {};
  std::string data(libdeflate_zlib_compress_bound(compressor.get(), rows.size()), '\0');
  data.resize(libdeflate_zlib_compress(compressor.get(), rows.data(), rows.size(), data.data(), data.size()));

  std::string png(kSignature);
  appendChunk(png, "IHDR", header);
  appendChunk(png, "IDAT", data);
  appendChunk(png, "IEND", {});
  return png;
}

}  // namespace

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
  appendBig(data, width);
  appendBig(data, height);
  data += png.substr(kHeaderAt + 16, kHeaderBytes - 8);
  std::string chunk;
  appendChunk(chunk, "IHDR", data);
  return png.replace(kHeaderAt, end - kHeaderAt, chunk);
}

std::string base64(std::string_view bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      out += i + k <= bytes.size() ? kDigits[(group >> (18 - 6 * k)) & 63] : '=';
  }
  return out;
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
