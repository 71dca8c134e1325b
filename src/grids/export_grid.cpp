#include "grids/export_grid.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <vector>

#include "disk/file_error.h"
#include "disk/written_file.h"
#include "grids/faults.h"
#include "grids/png_writer.h"

namespace mapwright::grids {

namespace {

using Proceed = std::function<bool(double done)>;
constexpr std::uint8_t kFreeShade = 254, kOccupiedShade = 0, kUnknownShade = 205;

/// Calls take(row) for every row of level 0. Returns why it ended early.
template <typename Take>
std::optional<Fault> eachRow(const GridPyramid& grid, const Proceed& proceed, double from, double to,
                             Take take) {
  GridRows rows(grid);
  for (int y = 0; y < grid.height(); ++y) {
    const bool begins_band = y % GridPyramid::kTileEdge == 0;
    if (begins_band && proceed && !proceed(from + (to - from) * y / grid.height()))
      return fault::WritingStopped;
    if (!take(rows.row(y))) return std::nullopt;
  }
  if (auto trouble = grid.trouble(); trouble.any())
    return std::move(trouble).followedBy(Consequence::NothingWritten);
  if (proceed) proceed(to);
  return std::nullopt;
}

/// Whether map_saver's three gray levels can represent all cells.
tl::expected<bool, Fault> isTrinary(const GridPyramid& grid, const Proceed& proceed) {
  const CellMeaning& meaning = meaningOf(grid.code());
  std::array<bool, 256> seen{};
  const std::size_t width = std::size_t(grid.width());
  auto stopped = eachRow(grid, proceed, 0, 0.3, [&](const std::uint8_t* row) {
    for (std::size_t u = 0; u < width; ++u) seen[row[u]] = true;
    return true;
  });
  if (stopped) return tl::unexpected(std::move(*stopped));
  for (std::size_t cell = 0; cell < seen.size(); ++cell) {
    const int occupancy = meaning.occupancy[cell];
    if (seen[cell] && occupancy != 0 && occupancy != 100 && occupancy != -1) return false;
  }
  return true;
}

/// The byte for every cell in a file for map_server.
std::array<std::uint8_t, 256> shadesOf(CellCode code, bool trinary) {
  const CellMeaning& meaning = meaningOf(code);
  std::array<std::uint8_t, 256> shades{};
  for (std::size_t cell = 0; cell < shades.size(); ++cell) {
    const int occupancy = meaning.occupancy[cell];
    shades[cell] = !trinary         ? std::uint8_t(occupancy)
                   : occupancy == 0 ? kFreeShade
                   : occupancy > 0  ? kOccupiedShade
                                    : kUnknownShade;
  }
  return shades;
}

std::optional<Fault> told(const std::optional<disk::FileError>& fault) {
  return fault ? std::optional(disk::notWritten(*fault)) : std::nullopt;
}

/// The shortest text that reads back as the same number, and not as an integer.
std::string numberText(double number) {
  std::array<char, 64> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  std::string written(text.data(), end);
  // YAML 1.1 reads "1e-05" as a string: there must be a point before the exponent.
  const std::size_t exponent = written.find('e');
  if (written.find('.') == std::string::npos && written.find_first_of("ni") == std::string::npos) {
    written.insert(exponent == std::string::npos ? written.size() : exponent, ".0");
  }
  return written;
}

/// A YAML scalar in double quotes: names may contain anything.
std::string quoted(const std::string& text) {
  static constexpr const char* kHex = "0123456789abcdef";
  std::string out = "\"";
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte < 0x20 || byte == 0x7f) {
      out += {'\\', 'x', kHex[byte >> 4], kHex[byte & 15]};
    } else {
      if (letter == '"' || letter == '\\') out += '\\';
      out += letter;
    }
  }
  return out + '"';
}

}  // namespace

std::optional<Fault> writeGridPng(const GridPyramid& grid, const std::string& path, const Proceed& proceed) {
  const bool as_is = isGray(grid.code());
  const tl::expected<bool, Fault> trinary = as_is ? false : isTrinary(grid, proceed);
  if (!trinary) return trinary.error();
  // If every gray level is a value, none is left for missing pixels.
  const bool has_alpha = grid.code() == CellCode::ClearGray || (!as_is && !*trinary);
  disk::WrittenFile file(path);
  PngWriter png{file};
  bool good = png.begin(grid.width(), grid.height(), has_alpha ? PngPixels::GrayAlpha : PngPixels::Gray);
  const CellMeaning& meaning = meaningOf(grid.code());
  const std::array<std::uint8_t, 256> shades = shadesOf(grid.code(), true);
  const std::size_t width = std::size_t(grid.width());
  std::vector<std::uint8_t> out(width * (has_alpha ? 2 : 1));
  auto stopped = eachRow(grid, proceed, as_is ? 0 : 0.3, 1, [&](const std::uint8_t* row) {
    for (std::size_t u = 0; u < width; ++u) {
      if (has_alpha) {
        out[2 * u] = as_is ? row[u] : meaning.intensity[row[u]];
        out[2 * u + 1] = meaning.known[row[u]] ? 255 : 0;
      } else {
        out[u] = as_is ? row[u] : shades[row[u]];
      }
    }
    good = good && png.row(out.data(), out.size());
    return good;
  });
  if (stopped) return stopped;
  if (!good && file.good()) return Fault(fault::EncoderFailed, {path});
  return told(file.place());
}

MapServerFiles mapServerFiles(const std::string& path) {
  std::filesystem::path base(path);
  if (base.extension() == ".pgm" || base.extension() == ".yaml" || base.extension() == ".yml") {
    base.replace_extension();
  }
  return {base.string() + ".pgm", base.string() + ".yaml"};
}

std::optional<Fault> writeMapServer(const GridPyramid& grid, const map::GridReference& reference,
                                    const std::string& path, const Proceed& proceed) {
  const MapServerFiles paths = mapServerFiles(path);
  const auto trinary = isTrinary(grid, proceed);
  if (!trinary) return trinary.error();
  const std::array<std::uint8_t, 256> shades = shadesOf(grid.code(), *trinary);
  disk::WrittenFile pgm(paths.pgm), yaml(paths.yaml);
  pgm.write("P5\n" + std::to_string(grid.width()) + " " + std::to_string(grid.height()) + "\n255\n");
  const std::size_t width = std::size_t(grid.width());
  std::vector<std::uint8_t> out(width);
  auto stopped = eachRow(grid, proceed, 0.3, 1, [&](const std::uint8_t* row) {
    for (std::size_t u = 0; u < width; ++u) out[u] = shades[row[u]];
    pgm.write(out.data(), out.size());
    return pgm.good();
  });
  if (stopped) return stopped;
  yaml.write(mapYamlText(reference, std::filesystem::path(paths.pgm).filename().string(), !*trinary));
  yaml.finish();  // both are complete before the first is moved into place
  if (!yaml.good()) return told(yaml.place());
  if (auto problem = told(pgm.place())) return problem;
  return told(yaml.place());
}

std::string worldFileText(const map::GridReference& reference) {
  const double across = reference.resolution_m * std::cos(reference.origin.yaw_rad);
  const double along = reference.resolution_m * std::sin(reference.origin.yaw_rad);
  const Eigen::Vector2d centre = reference.worldFromCell({0.5, 0.5});
  std::string text;
  // A column goes along the yaw, a row down goes against its normal: (sin, -cos).
  for (const double number : {across, along, along, -across, centre.x(), centre.y()}) {
    text += numberText(number) + "\n";
  }
  return text;
}

std::string mapYamlText(const map::GridReference& reference, const std::string& image, bool raw) {
  return "image: " + quoted(image) + "\nmode: " + (raw ? "raw" : "trinary") +
         "\nresolution: " + numberText(reference.resolution_m) + "\norigin: [" +
         numberText(reference.origin.x_m) + ", " + numberText(reference.origin.y_m) + ", " +
         numberText(reference.origin.yaw_rad) + "]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
}

}  // namespace mapwright::grids
