#include "grids/picture_shades.h"

#include <initializer_list>
#include <vector>

namespace mapwright::grids {

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
