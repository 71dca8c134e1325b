#include "grids/thumbnail.h"

#include <algorithm>

#include "grids/faults.h"
#include "grids/grid_cells.h"
#include "grids/grid_pyramid.h"
#include "words/figures.h"

namespace mapwright::grids {

namespace {

constexpr int kThumbnailEdge = 192;
constexpr std::uint8_t kUnseenShade = 205;  // as map_server writes it

tl::expected<std::unique_ptr<GridReading>, Fault> openWhole(const map::WholeMap& whole,
                                                            std::optional<CellCode> code) {
  GridOptions options;
  options.reading = whole.reading;
  options.code = code;
  if (whole.bytes) return openGrid(whole.bytes, options);
  if (!whole.path.empty()) return openGridFile(whole.path, options);
  return openGrid(whole.cells, whole.grid.width, whole.grid.height, options);
}

int levelFor(const GridPyramid& cells) {
  int level = 0;
  while (level + 1 < cells.levels() &&
         std::max(cells.levelWidth(level), cells.levelHeight(level)) > kThumbnailEdge)
    ++level;
  return level;
}

std::string pictureOf(const GridPyramid& cells) {
  const int level = levelFor(cells), width = cells.levelWidth(level), height = cells.levelHeight(level);
  const CellMeaning& meaning = meaningOf(cells.code());
  std::string picture = "P5\n" + std::to_string(width) + ' ' + std::to_string(height) + "\n255\n";
  for (int y = 0; y < height; ++y) {
    std::optional<GridTile> tile;
    for (int x = 0; x < width; ++x) {
      if (x % GridPyramid::kTileEdge == 0)
        tile = cells.tile(level, x / GridPyramid::kTileEdge, y / GridPyramid::kTileEdge);
      const std::size_t at = std::size_t(y % GridPyramid::kTileEdge) * GridPyramid::kTileEdge +
                             std::size_t(x % GridPyramid::kTileEdge);
      const std::uint8_t cell = tile ? tile->cells.get()[at] : unknownByte(cells.code());
      picture += char(meaning.known[cell] ? meaning.intensity[cell] : kUnseenShade);
    }
  }
  return picture;
}

}  // namespace

tl::expected<std::string, Fault> thumbnailOf(const map::WholeMap& whole,
                                             const std::function<bool()>& wanted_no_more,
                                             std::int64_t most_cells) {
  std::optional<CellCode> code;
  for (int times = 0; times < 2; ++times) {
    const auto opened = openWhole(whole, code);
    if (!opened) return tl::make_unexpected(opened.error());
    GridReading& reading = **opened;
    const std::int64_t count = std::int64_t(reading.pyramid()->width()) * reading.pyramid()->height();
    if (count > most_cells)
      return tl::make_unexpected(Fault(fault::TooLargeForThumbnail, {words::grouped(count)}));
    std::atomic<bool> cancelled{false};
    const auto trouble = reading.read(cancelled, [&] { cancelled = wanted_no_more && wanted_no_more(); });
    if (trouble) return tl::make_unexpected(*trouble);
    if (times == 0 && reading.otherCode()) {
      code = reading.otherCode();
      continue;
    }
    return pictureOf(*reading.pyramid());
  }
  return tl::make_unexpected(Fault(fault::TooLargeForThumbnail, {words::grouped(most_cells)}));
}

}  // namespace mapwright::grids
