// Small coloured pictures (costmaps). Rank of a colour for reduction: more opaque wins, and of equally opaque
// colours the darker one; so an obstacle is never lost to transparent or light ground when zoomed out. Rank 0
// is for invisible colours. Gray pictures use the rank of the Gray code.
#include <algorithm>
#include <array>
#include <atomic>
#include <numeric>
#include <unordered_map>

#include "grids/band_builder.h"
#include "grids/faults.h"
#include "grids/grid_pyramid.h"
#include "grids/pixel_colours.h"
#include "words/figures.h"

namespace mapwright::grids {

namespace {

using Indices = std::vector<std::uint8_t>;

constexpr std::size_t kPaletteSize = 256;

/// All invisible colours are one.
Argb visible(Argb colour) { return colour >> 24 == 0 ? 0 : colour; }

/// The set for pictures with more colours: transparent, half opaque (3 levels per channel) and opaque (6
/// levels per channel, and 12 grays between).
std::vector<Argb> fixedSet() {
  std::vector<Argb> set{0};
  const auto cube = [&set](int alpha, int levels) {
    for (int r = 0; r < levels; ++r) {
      for (int g = 0; g < levels; ++g) {
        for (int b = 0; b < levels; ++b) {
          set.push_back(
              argbOf(alpha, r * 255 / (levels - 1), g * 255 / (levels - 1), b * 255 / (levels - 1)));
        }
      }
    }
  };
  cube(255, 6);
  cube(128, 3);
  for (int gray = 1; set.size() < kPaletteSize; ++gray)
    set.push_back(argbOf(255, gray * 20, gray * 20, gray * 20));
  return set;
}

int squared(int a, int b) { return (a - b) * (a - b); }

std::uint8_t nearest(const std::vector<Argb>& set, Argb colour) {
  const auto part = [](Argb of, int shift) { return int(of >> shift & 0xff); };
  if (part(colour, 24) < 32) return 0;
  std::size_t best = 0;
  int least = 1 << 30;
  for (std::size_t n = 1; n < set.size(); ++n) {
    int distance = 3 * squared(part(set[n], 24), part(colour, 24));
    for (const int shift : {0, 8, 16}) distance += squared(part(set[n], shift), part(colour, shift));
    if (distance < least) {
      least = distance;
      best = n;
    }
  }
  return std::uint8_t(best);
}

std::array<std::uint8_t, kPaletteSize> rankOf(const std::vector<Argb>& palette) {
  std::array<std::uint8_t, kPaletteSize> rank{};
  std::vector<std::size_t> order(palette.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto weight = [&palette](std::size_t n) {
    const Argb colour = palette[n];
    const int light = int((colour >> 16 & 0xff) * 299 + (colour >> 8 & 0xff) * 587 + (colour & 0xff) * 114);
    return std::pair(colour >> 24, -light);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return weight(a) < weight(b); });
  for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = std::uint8_t(i);
  for (std::size_t n = 0; n < palette.size(); ++n) {
    if (palette[n] >> 24 == 0) rank[n] = 0;
  }
  return rank;
}

/// Reads all rows as indices into a growing palette; beyond 256 colours everything is mapped to the fixed
/// set.
class Quantiser {
 public:
  explicit Quantiser(const PixelFormat& format) : format_(format), colours_(format) {}

  void appendRow(const std::uint8_t* row, Indices& out) {
    const std::size_t unit = format_.pixelBytes();
    for (int u = 0; u < format_.width; ++u, row += unit)
      out.push_back(indexOf(visible(colours_.at(row)), out));
  }
  const std::vector<Argb>& palette() const { return palette_; }

 private:
  std::uint8_t indexOf(Argb colour, Indices& before) {
    if (last_ && last_->first == colour) return last_->second;
    const auto known = indices_.find(colour);
    if (known != indices_.end()) return remember(colour, known->second);
    if (!fixed_ && palette_.size() == kPaletteSize) useFixedSet(before);
    if (fixed_) {
      if (indices_.size() > kMostRemembered) indices_.clear();
      const std::uint8_t index = nearest(palette_, colour);
      indices_[colour] = index;
      return remember(colour, index);
    }
    palette_.push_back(colour);
    return remember(colour, indices_[colour] = std::uint8_t(palette_.size() - 1));
  }
  std::uint8_t remember(Argb colour, std::uint8_t index) {
    last_ = {colour, index};
    return index;
  }
  void useFixedSet(Indices& before) {
    const std::vector<Argb> set = fixedSet();
    std::array<std::uint8_t, kPaletteSize> moved{};
    for (std::size_t n = 0; n < palette_.size(); ++n) moved[n] = nearest(set, palette_[n]);
    for (std::uint8_t& index : before) index = moved[index];
    palette_ = set;
    indices_.clear();
    last_.reset();
    fixed_ = true;
  }

  static constexpr std::size_t kMostRemembered = 1 << 16;
  PixelFormat format_;
  PixelColours colours_;
  std::vector<Argb> palette_;
  std::unordered_map<Argb, std::uint8_t> indices_;
  std::optional<std::pair<Argb, std::uint8_t>> last_;
  bool fixed_ = false;
};

bool isPlainGray(const PixelFormat& format) { return format.gray && !format.has_alpha; }

Fault tooLarge(const PixelFormat& format, std::int64_t max_cells) {
  return {faultText("grids", "It is %1 pixels, but at most %2 can be read."),
          {words::dimensions(format.width, format.height), words::grouped(max_cells)}};
}

Fault brokenOff(const PixelFormat& format, int came, const Fault& problem) {
  return {fault::PictureEndsEarlyUnused,
          {words::grouped(came), words::dimensions(format.width, format.height)},
          {problem}};
}

}  // namespace

tl::expected<ColoredGrid, Fault> decodeOccupancy(std::shared_ptr<const std::string> bytes,
                                                 const map::CellReading& reading, std::int64_t max_cells,
                                                 const Resources& resources) {
  if (!bytes) bytes = std::make_shared<const std::string>();
  const auto rows = openPicture(ByteSource(bytes));
  if (!rows) return tl::unexpected(rows.error());
  const PixelFormat& format = (*rows)->format();
  if (std::int64_t(format.width) * format.height > max_cells)
    return tl::unexpected(tooLarge(format, max_cells));
  GridOptions options;
  options.reading = reading;
  options.resources = resources;
  auto opened = openGrid(std::move(bytes), options);
  if (!opened) return tl::unexpected(std::move(opened.error()));
  const std::atomic<bool> never{false};
  if (auto error = (*opened)->read(never, [] {})) return tl::unexpected(std::move(*error));
  ColoredGrid grid;
  grid.indices = (*opened)->pyramid();
  return grid;
}

tl::expected<ColoredGrid, Fault> decodeColors(std::shared_ptr<const std::string> bytes,
                                              std::int64_t max_cells, const Resources& resources) {
  auto rows = openPicture(ByteSource(std::move(bytes)));
  if (!rows) return tl::unexpected(std::move(rows.error()));
  const PixelFormat& format = (*rows)->format();
  if (std::int64_t(format.width) * format.height > max_cells)
    return tl::unexpected(tooLarge(format, max_cells));
  const bool gray = isPlainGray(format);
  Quantiser quantiser(format);
  Indices indices;
  for (int row = 0; row < format.height; ++row) {
    const std::uint8_t* pixels = (*rows)->next();
    if (pixels == nullptr) return tl::unexpected(brokenOff(format, row, (*rows)->problem()));
    if (gray) {
      const PixelColours colours(format);
      for (int u = 0; u < format.width; ++u, pixels += format.pixelBytes()) {
        indices.push_back(std::uint8_t(colours.at(pixels)));
      }
    } else {
      quantiser.appendRow(pixels, indices);
    }
  }
  ColoredGrid grid;
  if (!gray) grid.palette = quantiser.palette();
  const GridReducer reducer =
      gray ? GridReducer(CellCode::Gray, Reduction::OccupiedWins) : GridReducer(rankOf(grid.palette));
  BandBuilder builder(format.width, format.height, CellCode::Gray, Reduction::OccupiedWins, reducer,
                      resources);
  const std::size_t width = std::size_t(format.width);
  for (std::size_t row = 0; row < std::size_t(format.height); ++row) {
    builder.pushRow({indices.data() + row * width, width});
  }
  builder.finish();
  grid.indices = builder.pyramid();
  return grid;
}

}  // namespace mapwright::grids
