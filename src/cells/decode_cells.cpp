#include "cells/decode_cells.h"

#include <array>
#include <cmath>

#include "cells/faults.h"
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

tl::unexpected<Fault> failure(Fault reason) { return tl::unexpected(std::move(reason)); }

/// With the expected numbers of bytes.
Fault wrongCount(FaultCode code, std::size_t bytes, const Shape& shape) {
  return {code,
          {words::grouped(std::int64_t(bytes)), words::grouped(std::int64_t(shape.cells())),
           words::grouped(std::int64_t(2 * shape.cells()))}};
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

tl::expected<Texture, Fault> fromSingleBytes(std::span<const std::uint8_t> cells, const Shape& shape,
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
  return failure({fault::CellFormatUnknown, {words::grouped(cell_format)}});
}

/// Cells without a container.
tl::expected<Texture, Fault> fromPlain(std::span<const std::uint8_t> bytes, const Shape& shape,
                                       int cell_format) {
  if (bytes.size() == shape.cells()) {
    return fromSingleBytes(bytes, shape, cell_format);
  }
  if (bytes.size() == 2 * shape.cells()) {
    // CellPair is two bytes without padding, so the bytes are the pairs.
    const auto* pairs = reinterpret_cast<const CellPair*>(bytes.data());
    return CellTexture::fromPairs(shape.width, shape.height, shape.resolution_m, {pairs, shape.cells()});
  }
  return failure(wrongCount(fault::BytesUnexpected, bytes.size(), shape));
}

Fault whyNotUnpacked(packed::Container container, packed::UnpackFailure why, const Shape& shape) {
  if (why == packed::UnpackFailure::TooLong) return wrongCount(fault::BytesTooMany, 2 * shape.cells(), shape);
  return container == packed::Container::Gzip ? fault::GzipDamaged : fault::ZlibDamaged;
}

}  // namespace

tl::expected<Texture, Fault> decodeCells(std::span<const std::uint8_t> bytes, int width, int height,
                                         double resolution_m, int cell_format) {
  if (width < 1 || height < 1) {
    return failure({fault::TextureEmpty, {words::dimensions(width, height)}});
  }
  if (std::int64_t(width) * std::int64_t(height) > kMaxCells) {
    return failure({fault::TextureTooLarge, {words::dimensions(width, height), words::grouped(kMaxCells)}});
  }
  if (!std::isfinite(resolution_m) || resolution_m <= 0) {
    return failure(fault::CellSizeNotPositive);
  }
  if (resolution_m < kMinResolutionM) {
    return failure(fault::CellSizeTooSmall);
  }
  if (resolution_m > kMaxResolutionM) {
    return failure(fault::CellSizeTooLarge);
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
    return failure(png.error().reason);
  }
  const auto unpacked = packed::unpack(container, bytes, 2 * shape.cells());
  if (unpacked) {
    return fromPlain(unpacked->bytes(), shape, cell_format);
  }
  if (may_be_plain) {
    return fromPlain(bytes, shape, cell_format);
  }
  return failure(whyNotUnpacked(container, unpacked.error(), shape));
}

}  // namespace mapwright::cells
