// PGM as a stream of rows. Source: netpbm, "PGM Format Specification" (plain P2 and raw P5).
#include <array>
#include <cctype>
#include <vector>

#include "grids/faults.h"
#include "grids/picture_rows.h"

namespace mapwright::grids {

namespace {

constexpr std::uint64_t kLongestHeader = 1 << 16;  // comments included
constexpr std::size_t kTextWindow = std::size_t(64) << 10;
constexpr int kLargestMaxval = 65535;

constexpr FaultCode kExceeds = faultText("grids", "a number exceeds the maximum in the header");

bool isSpace(int byte) { return byte == ' ' || (byte >= '\t' && byte <= '\r'); }

/// Bytes one after the other.
class Cursor {
 public:
  Cursor(ByteSource& bytes, std::uint64_t at) : bytes_(bytes), at_(at) {}
  int next() {  // -1 at the end
    if (position_ == window_.size()) {
      window_ = bytes_.window(at_, kTextWindow);
      position_ = 0;
      if (window_.empty()) return -1;
    }
    ++at_;
    return window_[position_++];
  }
  /// The next number, after white space and comments; -1: there is none. Consumes one byte after it.
  long number() {
    int byte = next();
    while (isSpace(byte) || byte == '#') {
      if (byte == '#') {
        while (byte != -1 && byte != '\n' && byte != '\r') byte = next();
      }
      byte = next();
    }
    if (byte < '0' || byte > '9') return -1;
    long value = 0;
    for (; byte >= '0' && byte <= '9'; byte = next()) {
      if (value < 100'000'000'000) value = value * 10 + (byte - '0');
    }
    // A comment may follow a number at once, and its line end is then the single white space.
    while (byte != -1 && byte == '#') {
      while (byte != -1 && byte != '\n' && byte != '\r') byte = next();
    }
    return value;
  }
  std::uint64_t at() const { return at_; }

 private:
  ByteSource& bytes_;
  std::uint64_t at_;
  std::span<const std::uint8_t> window_;
  std::size_t position_ = 0;
};

PixelFormat formatOf(int width, int height, int maxval) {
  PixelFormat format;
  format.width = width;
  format.height = height;
  format.gray = true;
  format.indexed = maxval <= 255;
  format.sample_bytes = maxval <= 255 ? 1 : 2;
  format.sample_max = maxval;
  for (int level = 0; level < 256 && format.indexed; ++level) {
    const std::uint8_t gray = std::uint8_t((std::min(level, maxval) * 510 + maxval) / (2 * maxval));
    format.table[std::size_t(level)] = {gray, gray, gray, 255};
  }
  return format;
}

class RawRows final : public PictureRows {
 public:
  RawRows(const PixelFormat& format, ByteSource bytes, std::uint64_t at)
      : format_(format), bytes_(std::move(bytes)), at_(at), row_(format.rowBytes()) {}
  const PixelFormat& format() const override { return format_; }
  const std::uint8_t* next() override {
    if (done_ == format_.height) return nullptr;
    const auto window = bytes_.window(at_, row_.size());
    const std::uint8_t* row = window.data();
    if (window.size() < row_.size()) {  // at the end of the buffer, or of the file
      row = row_.data();
      if (!bytes_.readAt(at_, row_.data(), row_.size())) {
        problem_ = fault::DataEnds;
        return nullptr;
      }
    }
    at_ += row_.size();
    ++done_;
    exceeds_ = exceeds_ || exceedsMaximum(row);
    return row;
  }
  void checkEnd() override {
    if (exceeds_ && !problem_.any()) problem_ = kExceeds;
  }

 private:
  /// Such samples are shown as the maximum.
  bool exceedsMaximum(const std::uint8_t* row) const {
    if (format_.sample_max == 255 || format_.sample_max == kLargestMaxval) return false;
    const int step = format_.sample_bytes;
    for (std::size_t i = 0; i < row_.size(); i += std::size_t(step)) {
      if ((step == 1 ? row[i] : row[i] << 8 | row[i + 1]) > format_.sample_max) return true;
    }
    return false;
  }

  PixelFormat format_;
  ByteSource bytes_;
  std::uint64_t at_;
  std::vector<std::uint8_t> row_;
  int done_ = 0;
  bool exceeds_ = false;
};

class PlainRows final : public PictureRows {
 public:
  PlainRows(const PixelFormat& format, ByteSource bytes, std::uint64_t at)
      : format_(format), bytes_(std::move(bytes)), cursor_(bytes_, at), row_(format.rowBytes()) {}
  const PixelFormat& format() const override { return format_; }
  const std::uint8_t* next() override {
    if (done_ == format_.height) return nullptr;
    std::uint8_t* out = row_.data();
    for (int u = 0; u < format_.width; ++u) {
      const long level = cursor_.number();
      if (level < 0 || level > format_.sample_max) {
        problem_ = level >= 0                      ? kExceeds
                   : cursor_.at() >= bytes_.size() ? fault::DataEnds
                                                   : faultText("grids", "something in it is not a number");
        return nullptr;
      }
      if (format_.sample_bytes == 2) *out++ = std::uint8_t(level >> 8);
      *out++ = std::uint8_t(level);
    }
    ++done_;
    return row_.data();
  }

 private:
  PixelFormat format_;
  ByteSource bytes_;
  Cursor cursor_;
  std::vector<std::uint8_t> row_;
  int done_ = 0;
};

}  // namespace

tl::expected<std::unique_ptr<PictureRows>, Fault> openPgm(ByteSource bytes) {
  std::array<std::uint8_t, 2> magic{};
  bytes.readAt(0, magic.data(), magic.size());
  Cursor cursor(bytes, magic.size());
  std::array<long, 3> head{};
  for (long& number : head) {
    number = cursor.number();
    if (number < 0 || cursor.at() > kLongestHeader) {
      return tl::unexpected(Fault(faultText("grids", "It is a PGM whose header is cut off or invalid.")));
    }
  }
  if (auto problem = notThisSizeReason(std::uint64_t(head[0]), std::uint64_t(head[1]))) {
    return tl::unexpected(std::move(*problem));
  }
  if (head[2] < 1 || head[2] > kLargestMaxval) {
    return tl::unexpected(
        Fault(faultText("grids", "It is a PGM with a maximum gray of %1; it must be 1 to 65535."),
              {std::to_string(head[2])}));
  }
  const PixelFormat format = formatOf(int(head[0]), int(head[1]), int(head[2]));
  const std::uint64_t at = cursor.at();
  if (magic[1] == '2') return std::make_unique<PlainRows>(format, std::move(bytes), at);
  return std::make_unique<RawRows>(format, std::move(bytes), at);
}

}  // namespace mapwright::grids
