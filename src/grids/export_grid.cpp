#include "grids/export_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <vector>

#include "disk/file_error.h"
#include "disk/written_file.h"
#include "grids/faults.h"
#include "grids/png_writer.h"
#include "words/shortest.h"

namespace mapwright::grids {

namespace {

using Proceed = std::function<bool(double done)>;
constexpr std::uint8_t kFreeShade = 254, kOccupiedShade = 0, kUnknownShade = 205;

/// Calls visit(row) for every row of level 0. Returns why it ended early.
template <typename Visit>
std::optional<Fault> eachRow(const GridPyramid& grid, const Proceed& proceed, double from, double to,
                             Visit visit) {
  GridRows rows(grid);
  for (int y = 0; y < grid.height(); ++y) {
    const bool begins_band = y % GridPyramid::kTileEdge == 0;
    if (begins_band && proceed && !proceed(from + (to - from) * y / grid.height()))
      return fault::WritingStopped;
    if (!visit(rows.row(y))) return std::nullopt;
  }
  if (auto trouble = grid.trouble(); trouble.any())
    return std::move(trouble).followedBy(Consequence::NothingWritten);
  if (proceed) proceed(to);
  return std::nullopt;
}

using Histogram = std::array<std::int64_t, 256>;

/// How many cells have each byte.
tl::expected<Histogram, Fault> histogramOf(const GridPyramid& grid, const Proceed& proceed) {
  Histogram counts{};
  const std::size_t width = std::size_t(grid.width());
  auto stopped = eachRow(grid, proceed, 0, 0.3, [&](const std::uint8_t* row) {
    for (std::size_t u = 0; u < width; ++u) ++counts[row[u]];
    return true;
  });
  if (stopped) return tl::unexpected(std::move(*stopped));
  return counts;
}

/// Whether map_saver's three gray levels can represent all cells.
bool isTrinary(const Histogram& counts, const CellMeaning& meaning) {
  for (std::size_t cell = 0; cell < counts.size(); ++cell) {
    const int occupancy = meaning.occupancy[cell];
    if (counts[cell] > 0 && occupancy != 0 && occupancy != 100 && occupancy != -1) return false;
  }
  return true;
}

using Shades = std::array<std::uint8_t, 256>;  // by the byte of a cell

Shades saverShades(const CellMeaning& meaning) {
  Shades shades{};
  for (std::size_t cell = 0; cell < shades.size(); ++cell) {
    const int occupancy = meaning.occupancy[cell];
    shades[cell] = occupancy == 0 ? kFreeShade : occupancy > 0 ? kOccupiedShade : kUnknownShade;
  }
  return shades;
}

map::CellReading readingOf(const MapServerForm& form) {
  map::CellReading reading;
  reading.mode = form.mode;
  reading.occupied_thresh = form.occupied_thresh.value_or(reading.occupied_thresh);
  reading.free_thresh = form.free_thresh.value_or(reading.free_thresh);
  return reading;
}

/// Occupied, as map_server reckons it.
double probabilityOf(int shade) { return (255 - shade) / 255.0; }

/// The gray levels that a map.yaml leaves to each kind of cell. Releases of map_server differ in whether they
/// take a probability that equals a threshold: such levels belong to none.
struct ShadeRanges {
  int lightest_wall = -1, darkest_free = 256;
  std::optional<int> unknown = {};  // the nearest to the middle gray
};
ShadeRanges rangesOf(const map::CellReading& reading) {
  constexpr double kClear = 1e-6;
  ShadeRanges ranges;
  for (int shade = 0; shade < 256; ++shade) {
    const double occupied = probabilityOf(shade);
    if (occupied > reading.occupied_thresh + kClear) {
      ranges.lightest_wall = shade;
    } else if (occupied < reading.free_thresh - kClear) {
      ranges.darkest_free = std::min(ranges.darkest_free, shade);
    } else if (occupied < reading.occupied_thresh - kClear && occupied > reading.free_thresh + kClear &&
               (!ranges.unknown ||
                std::abs(shade - kTransparentGray) < std::abs(*ranges.unknown - kTransparentGray))) {
      ranges.unknown = shade;
    }
  }
  return ranges;
}

/// Each side of the middle spread over the gray levels that it may have, so that map_server finds every wall
/// and every free cell, while darker stays darker.
Shades spreadShades(const CellMeaning& meaning, const ShadeRanges& ranges) {
  std::array<bool, 256> wall{}, free{};  // by intensity
  for (std::size_t cell = 0; cell < 256; ++cell) {
    if (!meaning.known[cell]) continue;
    (meaning.occupancy[cell] >= kOccupiedPercent ? wall : free)[meaning.intensity[cell]] = true;
  }
  Shades of_intensity{};
  const auto spread = [&of_intensity](const std::array<bool, 256>& used, int from, int to) {
    const auto steps = std::max<std::ptrdiff_t>(1, std::count(used.begin(), used.end(), true) - 1);
    double step = 0;
    for (std::size_t intensity = 0; intensity < used.size(); ++intensity) {
      if (used[intensity])
        of_intensity[intensity] = std::uint8_t(std::lround(from + (to - from) * step++ / double(steps)));
    }
  };
  spread(wall, 0, ranges.lightest_wall);
  spread(free, ranges.darkest_free, 255);
  Shades shades{};
  for (std::size_t cell = 0; cell < 256; ++cell) {
    shades[cell] = meaning.known[cell] ? of_intensity[meaning.intensity[cell]]
                                       : std::uint8_t(ranges.unknown.value_or(kTransparentGray));
  }
  return shades;
}

/// The byte for every cell in a picture for map_server; in mode scale unknown ones are transparent besides.
Shades shadesOf(const CellMeaning& meaning, const MapServerForm& form, const Histogram& counts) {
  using Mode = MapServerForm::Mode;
  const map::CellReading reading = readingOf(form);
  const bool own_thresholds = form.occupied_thresh || form.free_thresh;
  if (form.mode == Mode::Trinary && !own_thresholds) {
    return isTrinary(counts, meaning) ? saverShades(meaning) : spreadShades(meaning, rangesOf(reading));
  }
  const int unknown = rangesOf(reading).unknown.value_or(kTransparentGray);
  Shades shades{};
  for (std::size_t cell = 0; cell < shades.size(); ++cell) {
    const int percent = meaning.occupancy[cell];
    if (form.mode == Mode::Raw) {
      shades[cell] = std::uint8_t(percent);
    } else if (!meaning.known[cell]) {
      shades[cell] = std::uint8_t(unknown);
    } else if (own_thresholds || percent == 0 || percent == 100) {
      shades[cell] = meaning.intensity[cell];
    } else {  // scale: map_server interpolates between the thresholds
      const double range = reading.occupied_thresh - reading.free_thresh;
      shades[cell] = std::uint8_t(std::lround(255 * (1 - reading.free_thresh - range * percent / 100)));
    }
  }
  return shades;
}

SeenByRobots seenByRobots(const CellMeaning& meaning, const MapServerForm& form, const Histogram& counts,
                          const Shades& shades) {
  const map::CellReading reading = readingOf(form);
  SeenByRobots seen;
  for (std::size_t cell = 0; cell < counts.size(); ++cell) {
    if (!meaning.known[cell]) {
      seen.shown.unknown += counts[cell];
      continue;
    }
    const std::uint8_t read = cellFromPixel(reading, shades[cell] / 255.0, 1, 1.0, false);
    if (meaning.occupancy[cell] >= kOccupiedPercent) {
      seen.shown.occupied += counts[cell];
      seen.walls += read == 100 ? counts[cell] : 0;
      seen.walls_as_free += read == 0 ? counts[cell] : 0;
    } else {
      seen.shown.free += counts[cell];
      seen.free += read == 0 ? counts[cell] : 0;
    }
  }
  return seen;
}

std::optional<Fault> told(const std::optional<disk::FileError>& fault) {
  return fault ? std::optional(disk::notWritten(*fault)) : std::nullopt;
}

/// The shortest text that reads back as the same number, and not as an integer.
std::string numberText(double number) {
  std::string written = words::shortest(number);
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

std::optional<Fault> writeGridPng(const GridPyramid& grid, const std::string& path, const Proceed& proceed,
                                  disk::Existing existing) {
  const bool as_is = isGray(grid.code());
  const CellMeaning& meaning = meaningOf(grid.code());
  bool trinary = false;
  if (!as_is) {
    const auto counts = histogramOf(grid, proceed);
    if (!counts) return counts.error();
    trinary = isTrinary(*counts, meaning);
  }
  // If every gray level is a value, none is left for missing pixels.
  const bool has_alpha = grid.code() == CellCode::ClearGray || (!as_is && !trinary);
  disk::WrittenFile file(path, existing);
  PngWriter png{file};
  bool good = png.begin(grid.width(), grid.height(), has_alpha ? PngPixels::GrayAlpha : PngPixels::Gray);
  const Shades shades = saverShades(meaning);
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

std::optional<Fault> flawOf(const MapServerForm& form) {
  const map::CellReading reading = readingOf(form);
  const auto within = [](double threshold) { return threshold >= 0 && threshold <= 1; };
  if (!within(reading.occupied_thresh) || !within(reading.free_thresh))
    return Fault(faultText("grids", "The thresholds of a map.yaml are numbers from 0 to 1."));
  if (form.mode != MapServerForm::Mode::Raw && !rangesOf(reading).unknown)
    return Fault(faultText("grids",
                           "Between the thresholds %1 (free) and %2 (occupied) there is no gray level for "
                           "unknown cells."),
                 {numberText(reading.free_thresh), numberText(reading.occupied_thresh)});
  return std::nullopt;
}

MapServerFiles mapServerFiles(const std::string& path, MapServerForm::Mode mode) {
  std::filesystem::path base(path);
  const std::string picture = mode == MapServerForm::Mode::Scale ? ".png" : ".pgm";
  if (base.extension() == picture || base.extension() == ".yaml" || base.extension() == ".yml") {
    base.replace_extension();
  }
  return {base.string() + picture, base.string() + ".yaml"};
}

tl::expected<SeenByRobots, Fault> writeMapServer(const GridPyramid& grid, const map::GridReference& reference,
                                                 const std::string& path, const MapServerForm& form,
                                                 const Proceed& proceed, disk::Existing existing) {
  const auto failed = [](Fault why) { return tl::make_unexpected(std::move(why)); };
  if (auto flaw = flawOf(form)) return failed(std::move(*flaw));
  const auto counts = histogramOf(grid, proceed);
  if (!counts) return failed(counts.error());
  const CellMeaning& meaning = meaningOf(grid.code());
  const Shades shades = shadesOf(meaning, form, *counts);
  const MapServerFiles paths = mapServerFiles(path, form.mode);
  disk::WrittenFile picture(paths.picture, existing), yaml(paths.yaml, existing);
  const bool has_alpha = form.mode == MapServerForm::Mode::Scale;
  PngWriter png{picture};
  bool good = true;
  if (has_alpha) {
    good = png.begin(grid.width(), grid.height(), PngPixels::GrayAlpha);
  } else {
    picture.write("P5\n" + std::to_string(grid.width()) + " " + std::to_string(grid.height()) + "\n255\n");
  }
  const std::size_t width = std::size_t(grid.width());
  std::vector<std::uint8_t> out(width * (has_alpha ? 2 : 1));
  auto stopped = eachRow(grid, proceed, 0.3, 1, [&](const std::uint8_t* row) {
    if (has_alpha) {
      for (std::size_t u = 0; u < width; ++u) {
        out[2 * u] = shades[row[u]];
        out[2 * u + 1] = meaning.known[row[u]] ? 255 : 0;
      }
      good = good && png.row(out.data(), out.size());
    } else {
      for (std::size_t u = 0; u < width; ++u) out[u] = shades[row[u]];
      picture.write(out.data(), out.size());
    }
    return good && picture.good();
  });
  if (stopped) return failed(std::move(*stopped));
  if (!good && picture.good()) return failed(Fault(fault::EncoderFailed, {paths.picture}));
  const auto textNaming = [&](const std::filesystem::path& image) {
    return mapYamlText(reference, image.filename().string(), readingOf(form));
  };
  yaml.write(textNaming(paths.picture));
  yaml.finish();  // both are complete before the first is moved into place
  if (!yaml.good()) return failed(*told(yaml.place()));
  if (const auto problem = picture.place()) {
    // It was kept under another name: the map.yaml names that one.
    if (problem->cause.code == disk::fault::NameTaken)
      disk::writeFile(paths.yaml, textNaming(picture.whereNow()), existing);
    return failed(*told(problem));
  }
  if (auto problem = told(yaml.place())) return failed(std::move(*problem));
  return seenByRobots(meaning, form, *counts, shades);
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

std::string mapYamlText(const map::GridReference& reference, const std::string& image,
                        const map::CellReading& reading) {
  using Mode = map::CellReading::Mode;
  const char* const mode = reading.mode == Mode::Raw     ? "raw"
                           : reading.mode == Mode::Scale ? "scale"
                                                         : "trinary";
  return "image: " + quoted(image) + "\nmode: " + mode +
         "\nresolution: " + numberText(reference.resolution_m) + "\norigin: [" +
         numberText(reference.origin.x_m) + ", " + numberText(reference.origin.y_m) + ", " +
         numberText(reference.origin.yaw_rad) + "]\nnegate: " + (reading.negate ? "1" : "0") +
         "\noccupied_thresh: " + numberText(reading.occupied_thresh) +
         "\nfree_thresh: " + numberText(reading.free_thresh) + "\n";
}

}  // namespace mapwright::grids
