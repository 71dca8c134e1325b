// Uncompressed BMP as a stream of rows. Source: Microsoft, BITMAPFILEHEADER, BITMAPINFOHEADER,
// BITMAPV4HEADER.
#include <array>
#include <bit>
#include <vector>

#include "grids/faults.h"
#include "grids/picture_rows.h"
#include "packed/png_unfilter.h"

namespace mapwright::grids {

namespace {

constexpr std::size_t kFileHeader = 14, kInfoHeader = 40, kMasksEnd = 56;
constexpr std::uint32_t kCoreHeader = 12;
constexpr std::uint32_t kUncompressed = 0, kBitFields = 3;

std::uint32_t word(const std::uint8_t* at) { return std::uint32_t(at[0] | at[1] << 8); }
std::uint32_t dword(const std::uint8_t* at) { return word(at) | word(at + 2) << 16; }

struct BmpHeader {
  PixelFormat format;
  std::uint64_t pixels_at = 0;
  std::uint64_t stored_row = 0;  // bytes, a multiple of 4
  int bits = 8;
  bool top_down = false;
  std::array<int, 4> byte_of{2, 1, 0, 3};  // where red, green, blue, alpha are in a pixel
};

class BmpRows final : public PictureRows {
 public:
  BmpRows(const BmpHeader& header, ByteSource bytes)
      : header_(header),
        bytes_(std::move(bytes)),
        stored_(header.stored_row),
        row_(header.format.rowBytes()) {}
  const PixelFormat& format() const override { return header_.format; }
  const std::uint8_t* next() override {
    if (done_ == header_.format.height) return nullptr;
    const int row_in_file = header_.top_down ? done_ : header_.format.height - 1 - done_;
    if (!bytes_.readAt(header_.pixels_at + std::uint64_t(row_in_file) * header_.stored_row, stored_.data(),
                       stored_.size())) {
      problem_ = fault::DataEnds;
      return nullptr;
    }
    ++done_;
    const std::size_t width = std::size_t(header_.format.width);
    if (header_.bits == 8) return stored_.data();
    if (header_.bits < 8) {
      packed::unpackBits(stored_.data(), width, header_.bits, row_.data());
      return row_.data();
    }
    const std::size_t unit = std::size_t(header_.bits / 8), channels = std::size_t(header_.format.channels);
    for (std::size_t u = 0; u < width; ++u) {
      for (std::size_t c = 0; c < channels; ++c) {
        row_[u * channels + c] = stored_[u * unit + std::size_t(header_.byte_of[c])];
      }
    }
    return row_.data();
  }

 private:
  BmpHeader header_;
  ByteSource bytes_;
  std::vector<std::uint8_t> stored_, row_;
  int done_ = 0;
};

tl::unexpected<Fault> unreadable(Fault why) { return tl::unexpected(std::move(why)); }

/// Only masks of whole bytes are supported; false for others.
bool readMasks(const std::uint8_t* masks, bool has_alpha, BmpHeader& header) {
  for (std::size_t channel = 0; channel < (has_alpha ? 4u : 3u); ++channel) {
    const std::uint32_t mask = dword(masks + 4 * channel);
    if (channel == 3 && mask == 0) return true;
    const int shift = std::countr_zero(mask);
    if (mask == 0 || shift % 8 != 0 || mask >> shift != 0xff) return false;
    header.byte_of[channel] = shift / 8;
    if (channel == 3) header.format.has_alpha = true;
  }
  return true;
}

/// Whether the fourth byte of 32 bits is alpha, as Pillow and OpenCV write it: nobody says so. Programs that
/// have no alpha leave it 0 everywhere, which would be a picture that nobody sees.
bool hasFourthByte(const BmpHeader& header, ByteSource& bytes) {
  std::vector<std::uint8_t> row(header.stored_row);
  for (int y = 0; y < header.format.height; ++y) {
    if (!bytes.readAt(header.pixels_at + std::uint64_t(y) * header.stored_row, row.data(), row.size()))
      return false;
    for (std::size_t at = 3; at < row.size(); at += 4) {
      if (row[at] != 0) return true;
    }
  }
  return false;
}

}  // namespace

tl::expected<std::unique_ptr<PictureRows>, Fault> openBmp(ByteSource bytes) {
  std::array<std::uint8_t, kFileHeader + kMasksEnd> start{};
  if (!bytes.readAt(0, start.data(), kFileHeader + kInfoHeader)) {
    return unreadable(fault::BmpHeaderShort);
  }
  const std::uint8_t* info = start.data() + kFileHeader;
  const std::uint32_t info_bytes = dword(info);
  if (info_bytes == kCoreHeader || info_bytes < kInfoHeader) {
    return unreadable(
        {faultText("grids", "This kind of BMP is not supported (its header has %1 bytes). Save it as PNG."),
         {std::to_string(info_bytes)}});
  }
  BmpHeader header;
  PixelFormat& format = header.format;
  const std::int32_t width = std::int32_t(dword(info + 4)), height = std::int32_t(dword(info + 8));
  header.top_down = height < 0;
  const std::int64_t rows = height < 0 ? -std::int64_t(height) : height;
  if (width < 0) return unreadable(faultText("grids", "It is a BMP with a negative width."));
  if (auto problem = notThisSizeReason(std::uint64_t(width), std::uint64_t(rows))) {
    return tl::unexpected(std::move(*problem));
  }
  format.width = width;
  format.height = int(rows);
  header.bits = int(word(info + 14));
  const std::uint32_t compression = dword(info + 16);
  const int bits = header.bits;
  const bool bits_known = bits == 1 || bits == 4 || bits == 8 || bits == 24 || bits == 32;
  if (!bits_known || !(compression == kUncompressed || (compression == kBitFields && bits == 32))) {
    return unreadable(
        {compression == kUncompressed
             ? faultText("grids",
                         "It is a BMP with %1 bits per pixel; only 1, 4, 8, 24 and 32 bits, "
                         "uncompressed, are supported. Save it as PNG.")
             : faultText("grids",
                         "It is a compressed BMP with %1 bits per pixel; only 1, 4, 8, 24 and 32 bits, "
                         "uncompressed, are supported. Save it as PNG."),
         {std::to_string(bits)}});
  }
  if (compression == kBitFields) {
    const bool in_header = info_bytes >= kMasksEnd;
    const std::size_t masks = kInfoHeader + (in_header ? 16 : 12);
    if (!bytes.readAt(0, start.data(), kFileHeader + masks)) {
      return unreadable(fault::BmpHeaderShort);
    }
    if (!readMasks(info + kInfoHeader, in_header, header)) {
      return unreadable(faultText("grids", "It is a BMP whose colours are not whole bytes. Save it as PNG."));
    }
  }
  header.pixels_at = dword(start.data() + 10);
  header.stored_row = (std::uint64_t(width) * std::uint64_t(bits) + 31) / 32 * 4;
  format.indexed = bits <= 8;
  if (bits == 32 && compression == kUncompressed) format.has_alpha = hasFourthByte(header, bytes);
  format.channels = format.has_alpha ? 4 : 3;
  if (format.indexed) {
    const std::uint32_t most = 1u << bits, said = dword(info + 32);
    const std::uint32_t colours = said == 0 || said > most ? most : said;
    std::vector<std::uint8_t> palette(colours * 4);
    if (!bytes.readAt(kFileHeader + info_bytes, palette.data(), palette.size())) {
      return unreadable(faultText("grids", "It is a BMP whose palette is cut off."));
    }
    format.gray = true;
    for (std::size_t n = 0; n < colours; ++n) {
      const std::uint8_t b = palette[4 * n], g = palette[4 * n + 1], r = palette[4 * n + 2];
      format.table[n] = {r, g, b, 255};
      format.gray = format.gray && r == g && g == b;
    }
  }
  return std::make_unique<BmpRows>(header, std::move(bytes));
}

}  // namespace mapwright::grids
