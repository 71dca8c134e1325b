#include "packed/unpack.h"

#include <algorithm>
#include <array>

#include <libdeflate.h>

namespace mapwright::packed {

namespace {

constexpr std::array<std::uint8_t, 8> kPngSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};

bool isGzip(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= 2 && bytes[0] == 0x1F && bytes[1] == 0x8B;
}

bool isZlib(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < 2 || bytes[0] != 0x78) {
    return false;
  }
  const std::uint8_t flags = bytes[1];
  const bool known = flags == 0x01 || flags == 0x5E || flags == 0x9C || flags == 0xDA;
  return known && (bytes[0] * 256 + flags) % 31 == 0;
}

struct FreeDecompressor {
  void operator()(libdeflate_decompressor* decompressor) const { libdeflate_free_decompressor(decompressor); }
};

}  // namespace

Container sniffContainer(std::span<const std::uint8_t> bytes) {
  if (bytes.size() >= kPngSignature.size() &&
      std::equal(kPngSignature.begin(), kPngSignature.end(), bytes.begin())) {
    return Container::Png;
  }
  if (isGzip(bytes)) {
    return Container::Gzip;
  }
  return isZlib(bytes) ? Container::Zlib : Container::Raw;
}

tl::expected<ByteBuffer, UnpackFailure> unpack(Container container, std::span<const std::uint8_t> packed,
                                               std::size_t limit) {
  // 40 KB: one for each thread, not for each picture.
  static thread_local const std::unique_ptr<libdeflate_decompressor, FreeDecompressor> decompressor(
      libdeflate_alloc_decompressor());
  if (decompressor == nullptr) {
    return tl::unexpected(UnpackFailure::Corrupt);
  }
  const std::size_t fillable =
      packed.size() < limit / kMaxDeflateRatio ? packed.size() * kMaxDeflateRatio : limit;
  ByteBuffer out{std::make_unique_for_overwrite<std::uint8_t[]>(fillable), 0};
  do {
    std::size_t taken = 0;
    std::size_t given = 0;
    const auto decompress =
        container == Container::Gzip ? &libdeflate_gzip_decompress_ex : &libdeflate_zlib_decompress_ex;
    const libdeflate_result result =
        decompress(decompressor.get(), packed.data(), packed.size(), out.data.get() + out.size,
                   fillable - out.size, &taken, &given);
    if (result != LIBDEFLATE_SUCCESS) {
      return tl::unexpected(result == LIBDEFLATE_INSUFFICIENT_SPACE ? UnpackFailure::TooLong
                                                                    : UnpackFailure::Corrupt);
    }
    out.size += given;
    packed = packed.subspan(taken);
  } while (container == Container::Gzip && isGzip(packed));
  return out;
}

}  // namespace mapwright::packed
