// How robots pack cells and pictures: the cells of submaps as different firmware does it
// (docs/protocols/cartographer-submaps.md, "Containers and cell layouts"), gray PNGs, gzip.
#pragma once

#include <cstdint>
#include <optional>
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

/// Gray levels 0 (black) .. 255 (white), the top row first.
struct GrayPicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> levels;
};

/// A gray PNG with `bits` (1, 2, 4 or 8) per pixel: the highest bits of each level.
std::string writePng(const GrayPicture& picture, int bits);

/// A PNG of 3 * width * height bytes, red, green and blue, the top row first.
std::string writeRgbPng(int width, int height, std::string_view pixels);

/// The same PNG with another size declared in its header (with a correct checksum).
std::string withDeclaredSize(std::string png, std::uint32_t width, std::uint32_t height);

/// The gray levels of any PNG, kUnknownShade where it is transparent; nullopt when it cannot be read, or is
/// too large for this robot.
std::optional<GrayPicture> readPng(const std::string& png);
constexpr std::uint8_t kUnknownShade = 128;

/// 64 hexadecimal digits derived from the bytes: an identifier without any security.
std::string contentHash(std::string_view bytes);

}  // namespace mapwright::simulator
