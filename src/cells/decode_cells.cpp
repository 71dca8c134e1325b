#include "cells/decode_cells.h"

#include <array>
#include <cmath>

#include "cells/png_cells.h"
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

tl::unexpected<CellError> failure(std::string sentence) {
  return tl::unexpected(CellError{std::move(sentence)});
}

std::string expectedBytes(const Shape& shape) {
  return words::grouped(std::int64_t(shape.cells())) + " (or " +
         words::grouped(std::int64_t(2 * shape.cells())) + ") were expected";
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

tl::expected<Texture, CellError> fromSingleBytes(std::span<const std::uint8_t> cells, const Shape& shape,
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
  return failure("cell format " + words::grouped(cell_format) +
                 " is unknown: with one byte a cell only 0, 1 and 2 can be read");
}

/// Cells without a container around them.
tl::expected<Texture, CellError> fromPlain(std::span<const std::uint8_t> bytes, const Shape& shape,
                                           int cell_format) {
  if (bytes.size() == shape.cells()) {
    return fromSingleBytes(bytes, shape, cell_format);
  }
  if (bytes.size() == 2 * shape.cells()) {
    // CellPair is two bytes without padding, so the bytes are the pairs.
    const auto* pairs = reinterpret_cast<const CellPair*>(bytes.data());
    return CellTexture::fromPairs(shape.width, shape.height, shape.resolution_m, {pairs, shape.cells()});
  }
  return failure(words::grouped(std::int64_t(bytes.size())) +
                 (bytes.size() == 1 ? " byte where " : " bytes where ") + expectedBytes(shape));
}

std::string unpackSentence(packed::Container container, packed::UnpackFailure why, const Shape& shape) {
  if (why == packed::UnpackFailure::TooLong) {
    return "more than " + words::grouped(std::int64_t(2 * shape.cells())) + " bytes where " +
           expectedBytes(shape);
  }
  return std::string(container == packed::Container::Gzip ? "the gzip" : "the zlib") +
         " data is damaged or cut off";
}

}  // namespace

tl::expected<Texture, CellError> decodeCells(std::span<const std::uint8_t> bytes, int width, int height,
                                             double resolution_m, int cell_format) {
  if (width < 1 || height < 1) {
    return failure("the texture is announced with " + words::dimensions(width, height) + " cells");
  }
  if (std::int64_t(width) * std::int64_t(height) > kMaxCells) {
    return failure("the texture is announced with " + words::dimensions(width, height) + " cells; at most " +
                   words::grouped(kMaxCells) + " are allowed");
  }
  if (!std::isfinite(resolution_m) || resolution_m <= 0) {
    return failure("the cell size is not a positive number of metres");
  }
  if (resolution_m < kMinResolutionM) {
    return failure("the cell size is less than 0.1 mm");
  }
  if (resolution_m > kMaxResolutionM) {
    return failure("the cell size is more than 100 m");
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
      return fromPlain(png->cells.bytes(), shape, cell_format);
    }
    if (may_be_plain && !png.error().is_png) {
      return fromPlain(bytes, shape, cell_format);
    }
    return failure(png.error().sentence);
  }
  const auto unpacked = packed::unpack(container, bytes, 2 * shape.cells());
  if (unpacked) {
    return fromPlain(unpacked->bytes(), shape, cell_format);
  }
  if (may_be_plain) {
    return fromPlain(bytes, shape, cell_format);
  }
  return failure(unpackSentence(container, unpacked.error(), shape));
}

}  // namespace mapwright::cells
