#include "grids/grid_cells.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mapwright::grids {

namespace {

constexpr std::uint8_t kFree = 0, kOccupied = 100;

CellMeaning grayMeaning(CellCode code) {
  const UnknownGrays unknown = unknownGrays(code);
  CellMeaning meaning;
  for (int gray = 0; gray < 256; ++gray) {
    const bool known = (gray < unknown.from || gray > unknown.to) && !(unknown.saver && gray == 205);
    const std::size_t at = std::size_t(gray);
    meaning.known[at] = known;
    meaning.intensity[at] = known ? std::uint8_t(gray) : kTransparentGray;
    meaning.occupancy[at] = known ? std::int8_t(std::lround((255 - gray) * 100 / 255.0)) : std::int8_t(-1);
    // Decreasing with the gray level: unknown grays in the middle leave room for white to be 1. Without them
    // the two lightest share it.
    const bool room = unknown.to >= unknown.from && gray > unknown.to;
    meaning.rank[at] = known ? std::uint8_t(std::max(1, 255 - gray + (room ? 1 : 0))) : std::uint8_t(0);
  }
  return meaning;
}

CellMeaning occupancyMeaning() {
  CellMeaning meaning;
  for (int byte = 0; byte < 256; ++byte) {
    const bool known = byte < 128;
    const int percent = std::min(byte, 100);
    const std::size_t at = std::size_t(byte);
    meaning.known[at] = known;
    meaning.intensity[at] =
        known ? std::uint8_t(std::lround((100 - percent) * 255 / 100.0)) : kTransparentGray;
    meaning.occupancy[at] = known ? std::int8_t(percent) : std::int8_t(-1);
    meaning.rank[at] = known ? std::uint8_t(1 + std::lround(percent * 254 / 100.0)) : std::uint8_t(0);
  }
  return meaning;
}

}  // namespace

const CellMeaning& meaningOf(CellCode code) {
  static const std::array<CellMeaning, kCellCodes> meanings{
      grayMeaning(CellCode::Gray), occupancyMeaning(), grayMeaning(CellCode::ShadedGray),
      grayMeaning(CellCode::ClearGray), grayMeaning(CellCode::FullGray)};
  return meanings[std::size_t(code)];
}

CellCode codeOf(const map::CellReading& reading) {
  return reading.mode == map::CellReading::Mode::Picture ? CellCode::Gray : CellCode::Occupancy;
}

// nav2's map_io up to Jazzy, where map_server of ROS 1 differs:
// - scale interpolates to 0..100 and rounds to even; ROS 1 cuts 1 + 98 * ratio (or 99 * ratio) down;
// - scale looks at alpha before the thresholds; ROS 1 only between them, and takes any alpha but 0 as opaque;
// - raw takes what is above 100 as unknown and ignores negate; ROS 1 keeps every byte and inverts.
// Both compare strictly with the thresholds.
std::uint8_t cellFromPixel(const map::CellReading& reading, double shade_sum, int channels, double alpha,
                           bool has_alpha) {
  using Mode = map::CellReading::Mode;
  const double colour = shade_sum / channels;
  if (reading.mode == Mode::Picture) {
    if (has_alpha && alpha < 0.5) return kTransparentGray;
    return std::uint8_t(std::clamp(std::lround(colour * 255), 0l, 255l));
  }
  if (reading.mode == Mode::Raw) {
    const long cell = std::lround(colour * 255);
    return cell >= kFree && cell <= kOccupied ? std::uint8_t(cell) : kUnknownOccupancy;
  }
  if (reading.mode == Mode::Scale && has_alpha && alpha < 1) return kUnknownOccupancy;
  const bool averages_alpha = reading.mode == Mode::Trinary && has_alpha;
  const double shade = averages_alpha ? (shade_sum + alpha) / (channels + 1) : colour;
  const double occupied = reading.negate ? shade : 1.0 - shade;
  if (reading.occupied_thresh < occupied) return kOccupied;
  if (occupied < reading.free_thresh) return kFree;
  if (reading.mode == Mode::Trinary) return kUnknownOccupancy;
  const double ratio = (occupied - reading.free_thresh) / (reading.occupied_thresh - reading.free_thresh);
  // Equal thresholds leave no range to interpolate in.
  if (!std::isfinite(ratio)) return kUnknownOccupancy;
  return std::uint8_t(std::clamp(std::lrint(ratio * 100.0), 0l, 100l));
}

PictureShades shadesFor(const map::CellReading& reading) {
  PictureShades shades;
  std::array<std::vector<std::uint8_t>, 256> candidates;
  for (int gray = 0; gray < 256; ++gray) {
    const std::uint8_t cell = cellFromPixel(reading, gray / 255.0, 1, 1.0, false);
    shades.cell_of[std::size_t(gray)] = cell;
    candidates[cell].push_back(std::uint8_t(gray));
  }
  for (std::size_t cell = 0; cell < candidates.size(); ++cell) {
    // One from the middle is least likely to be read as something else.
    if (!candidates[cell].empty()) shades.shade_of[cell] = candidates[cell][candidates[cell].size() / 2];
  }
  if (reading.mode == map::CellReading::Mode::Raw) {
    shades.shade_of[kUnknownOccupancy] = kUnknownOccupancy;
  } else if (reading.mode != map::CellReading::Mode::Picture) {
    for (const int saver : {205, 0, 254})
      shades.shade_of[shades.cell_of[std::size_t(saver)]] = std::uint8_t(saver);
  }
  shades.transparent = cellFromPixel(reading, 3 * kTransparentGray / 255.0, 3, 0.0, true);
  return shades;
}

}  // namespace mapwright::grids
