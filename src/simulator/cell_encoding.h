// How robots of different firmware pack a submap's cells (docs/protocols/cartographer-submaps.md, "Containers
// and cell layouts").
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mapwright::simulator {

/// Container and layout of `SubmapTexture.cells`.
enum class Packing {
  PngGray,       // 8-bit gray, one byte per cell by cell_format
  PngPalette,    // the same bytes as palette indices
  PngGrayAlpha,  // (value, alpha)
  GzipPairs,
  ZlibPairs,
  RawPairs,
  RawBytes,
  GzipBytes,
};
constexpr int kPackings = 8;

/// SubmapTexture.cell_format.
enum class CellFormat : int { LogOdds = 0, TsdfDelta = 1, Intensity = 2 };

/// Packs `cells`, which are as in ScanGrid. Pairs are the same for all formats, except that Intensity cells
/// are opaque.
std::string packCells(const std::vector<std::uint8_t>& cells, int width, int height, Packing packing,
                      CellFormat format);

/// A gzip stream without a time stamp, so that equal input gives equal bytes.
std::string gzip(std::string_view bytes);

}  // namespace mapwright::simulator
