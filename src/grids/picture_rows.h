// A picture file as a stream of rows, in any format.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "grids/byte_source.h"
#include "grids/grid_pyramid.h"

namespace mapwright::grids {

/// The meaning of the bytes of a row. Indexed: one byte per pixel, looked up in `table`. Otherwise `channels`
/// samples per pixel (gray, gray+alpha, RGB, RGBA), of 1 byte or 2 (big-endian).
struct PixelFormat {
  struct Colour {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;
  };
  int width = 0, height = 0;
  bool indexed = false;
  bool gray = false;       // no colours: one channel
  bool has_alpha = false;  // a channel, or a transparent colour
  int channels = 1;
  int sample_bytes = 1;
  int sample_max = 255;  // 65535, or maxval of a PGM
  std::array<Colour, 256> table{};
  std::optional<std::array<std::uint16_t, 3>> transparent;  // samples that mean alpha 0

  std::size_t pixelBytes() const { return std::size_t(indexed ? 1 : channels * sample_bytes); }
  std::size_t rowBytes() const { return std::size_t(width) * pixelBytes(); }
};

/// One thread. The size is within kMaxGridEdge and kMaxGridCells.
class PictureRows {
 public:
  virtual ~PictureRows() = default;
  virtual const PixelFormat& format() const = 0;
  /// The next row from the top, format().rowBytes() bytes, valid until the next call. Null: the end, or see
  /// problem().
  virtual const std::uint8_t* next() = 0;
  /// Starts over with the first row. False: impossible without opening the picture again.
  virtual bool rewind() { return false; }
  /// If next() has to read much before its first row, it gives up when `cancelled` becomes true.
  virtual void stopWhen(const std::atomic<bool>&) {}
  /// Called after the last row: finds out what is wrong although all rows arrived.
  virtual void checkEnd() {}
  /// Half a sentence after "it is 60 x 60 pixels, but ": why rows are missing or unreliable; empty = nothing.
  const Fault& problem() const { return problem_; }

 protected:
  Fault problem_;
};

/// Detects the format by signature; reads only the header.
tl::expected<std::unique_ptr<PictureRows>, Fault> openPicture(ByteSource bytes);

/// nullopt = fine, otherwise why not.
std::optional<Fault> notThisSizeReason(std::uint64_t width, std::uint64_t height);

// The formats. Precondition: the signature matches.
tl::expected<std::unique_ptr<PictureRows>, Fault> openPng(ByteSource bytes);
tl::expected<std::unique_ptr<PictureRows>, Fault> openPgm(ByteSource bytes);
tl::expected<std::unique_ptr<PictureRows>, Fault> openBmp(ByteSource bytes);

}  // namespace mapwright::grids
