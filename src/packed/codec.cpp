#include "packed/codec.h"

#include <algorithm>
#include <bzlib.h>
#include <limits>
#include <lz4frame.h>
#include <new>
#include <zstd.h>

#include <libdeflate.h>

namespace mapwright::packed {
namespace {

// A block of Zstandard is at least four bytes, and at most 128 KiB unpacked; a byte of LZ4 stands for at most
// 255.
constexpr std::size_t kMostZstdRatio = 32768;
constexpr std::size_t kMostLz4Ratio = 255;

using Outcome = tl::expected<ByteBuffer, UnpackFailure>;

Outcome failed(UnpackFailure why) { return tl::unexpected(why); }

bool couldFill(std::size_t packed, std::size_t ratio, std::size_t size) { return size / ratio <= packed; }

/// Empty if there is not enough memory.
ByteBuffer room(std::size_t size) {
  return {std::unique_ptr<std::uint8_t[]>(new (std::nothrow) std::uint8_t[std::max<std::size_t>(size, 1)]),
          size};
}

Outcome unpackZstd(std::span<const std::uint8_t> packed, std::size_t size) {
  const unsigned long long said = ZSTD_getFrameContentSize(packed.data(), packed.size());
  if (said == ZSTD_CONTENTSIZE_ERROR) return failed(UnpackFailure::Corrupt);
  if (said != ZSTD_CONTENTSIZE_UNKNOWN && said > size) return failed(UnpackFailure::TooLong);
  if (!couldFill(packed.size(), kMostZstdRatio, size)) return failed(UnpackFailure::Corrupt);
  ByteBuffer out = room(size);
  if (!out.data) return failed(UnpackFailure::TooLong);
  const std::size_t got = ZSTD_decompress(out.data.get(), size, packed.data(), packed.size());
  if (ZSTD_isError(got) || got != size) return failed(UnpackFailure::Corrupt);
  return out;
}

struct FreeCompressor {
  void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
};

struct FreeLz4 {
  void operator()(LZ4F_dctx* context) const { LZ4F_freeDecompressionContext(context); }
};

Outcome unpackLz4(std::span<const std::uint8_t> packed, std::size_t size) {
  if (!couldFill(packed.size(), kMostLz4Ratio, size)) return failed(UnpackFailure::Corrupt);
  LZ4F_dctx* made = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION)))
    return failed(UnpackFailure::TooLong);
  const std::unique_ptr<LZ4F_dctx, FreeLz4> context(made);
  ByteBuffer out = room(size);
  if (!out.data) return failed(UnpackFailure::TooLong);
  std::size_t given = 0;
  std::size_t expects = 1;
  while (expects != 0) {
    std::size_t taken = packed.size();
    std::size_t fits = size - given;
    expects = LZ4F_decompress(context.get(), out.data.get() + given, &fits, packed.data(), &taken, nullptr);
    if (LZ4F_isError(expects)) return failed(UnpackFailure::Corrupt);
    given += fits;
    packed = packed.subspan(taken);
    if (expects != 0 && taken == 0 && fits == 0) {
      return failed(given == size && !packed.empty() ? UnpackFailure::TooLong : UnpackFailure::Corrupt);
    }
  }
  if (given != size) return failed(UnpackFailure::Corrupt);
  return out;
}

Outcome unpackBzip2(std::span<const std::uint8_t> packed, std::size_t size) {
  constexpr std::size_t kMost = std::numeric_limits<unsigned int>::max();
  if (packed.size() > kMost || size > kMost) return failed(UnpackFailure::TooLong);
  ByteBuffer out = room(size);
  if (!out.data) return failed(UnpackFailure::TooLong);
  auto given = static_cast<unsigned int>(size);
  // bzip2 takes its input as char*, but does not modify it.
  auto* const from = const_cast<char*>(reinterpret_cast<const char*>(packed.data()));
  const int result = BZ2_bzBuffToBuffDecompress(reinterpret_cast<char*>(out.data.get()), &given, from,
                                                static_cast<unsigned int>(packed.size()), 0, 0);
  if (result == BZ_OUTBUFF_FULL || result == BZ_MEM_ERROR) return failed(UnpackFailure::TooLong);
  if (result != BZ_OK || given != size) return failed(UnpackFailure::Corrupt);
  return out;
}

}  // namespace

Outcome unpackExactly(Codec codec, std::span<const std::uint8_t> packed, std::size_t size) {
  switch (codec) {
    case Codec::Zstd:
      return unpackZstd(packed, size);
    case Codec::Lz4:
      return unpackLz4(packed, size);
    case Codec::Bzip2:
      break;
  }
  return unpackBzip2(packed, size);
}

ByteBuffer packZstd(std::span<const std::uint8_t> bytes, int level) {
  ByteBuffer out = room(ZSTD_compressBound(bytes.size()));
  if (!out.data) return {};
  const std::size_t size = ZSTD_compress(out.data.get(), out.size, bytes.data(), bytes.size(), level);
  if (ZSTD_isError(size)) return {};
  out.size = size;
  return out;
}

ByteBuffer packGzip(std::span<const std::uint8_t> bytes) {
  constexpr int kUsualLevel = 6;
  const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(
      libdeflate_alloc_compressor(kUsualLevel));
  if (!compressor) return {};
  ByteBuffer out = room(libdeflate_gzip_compress_bound(compressor.get(), bytes.size()));
  if (!out.data) return {};
  out.size = libdeflate_gzip_compress(compressor.get(), bytes.data(), bytes.size(), out.data.get(), out.size);
  return out;
}

std::optional<std::uint64_t> zstdContentSize(std::span<const std::uint8_t> packed) {
  const unsigned long long stated = ZSTD_getFrameContentSize(packed.data(), packed.size());
  if (stated == ZSTD_CONTENTSIZE_UNKNOWN || stated == ZSTD_CONTENTSIZE_ERROR) return std::nullopt;
  return stated;
}

std::uint32_t crc32(std::uint32_t before, std::span<const std::uint8_t> bytes) {
  return libdeflate_crc32(before, bytes.data(), bytes.size());
}

}  // namespace mapwright::packed
