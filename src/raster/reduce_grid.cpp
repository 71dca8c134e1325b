#include "raster/reduce_grid.h"

#include <algorithm>
#include <numeric>

namespace mapwright::raster {

namespace {

// Grays in an order that a vectoriser can compute: the lowest wins. Black 0 .. white 222, unknown above.
constexpr std::uint8_t grayOrder(std::uint8_t gray) {
  const std::uint8_t known = std::uint8_t(gray - (gray > 143 ? 32 : 0) - (gray > 205 ? 1 : 0));
  // Unknown ones backwards, so that of several the greatest byte wins: 205, 143, .. 112.
  const std::uint8_t unknown = gray == 205 ? std::uint8_t(223) : std::uint8_t(224 + (143 - gray));
  return (gray >= 112 && gray <= 143) || gray == 205 ? unknown : known;
}

constexpr std::uint8_t grayOf(std::uint8_t order) {
  if (order >= 224) return std::uint8_t(143 - (order - 224));
  if (order == 223) return 205;
  return std::uint8_t(order + (order >= 112 ? 32 : 0) + (order >= 173 ? 1 : 0));
}

static_assert([] {
  for (int gray = 0; gray < 256; ++gray) {
    if (grayOf(grayOrder(std::uint8_t(gray))) != gray) return false;
  }
  return true;
}());

}  // namespace

GridReducer::GridReducer(CellCode code, Reduction reduction) {
  const CellMeaning& meaning = meaningOf(code);
  rankBytes(meaning.rank);
  unknown_ = code == CellCode::Gray ? kTransparentGray : kUnknownOccupancy;
  if (reduction == Reduction::OccupiedWins) {
    kind_ = code == CellCode::Gray ? Kind::GrayWins : Kind::OccupancyWins;
    return;
  }
  kind_ = Kind::Average;
  for (std::size_t byte = 0; byte < 256; ++byte) {
    const std::uint32_t value =
        code == CellCode::Gray ? std::uint32_t(byte) : std::uint32_t(std::uint8_t(meaning.occupancy[byte]));
    weight_[byte] = meaning.known[byte] ? 1u << 16 | value : 0;
    mean_[byte] = std::uint8_t(byte);
    // A mean of known grays must not read as unknown: the nearest gray that does not, the darker of two.
    if (code == CellCode::Gray && !meaning.known[byte]) {
      mean_[byte] = byte == 205 ? std::uint8_t(204) : byte < 128 ? std::uint8_t(111) : std::uint8_t(144);
    }
  }
}

GridReducer::GridReducer(const std::array<std::uint8_t, 256>& rank) : kind_(Kind::TableWins) {
  rankBytes(rank);
}

void GridReducer::rankBytes(const std::array<std::uint8_t, 256>& rank) {
  std::iota(cell_.begin(), cell_.end(), std::uint8_t(0));
  std::stable_sort(cell_.begin(), cell_.end(),
                   [&rank](std::uint8_t a, std::uint8_t b) { return rank[a] < rank[b]; });
  for (std::size_t key = 0; key < 256; ++key) key_[cell_[key]] = std::uint8_t(key);
}

std::uint8_t GridReducer::reduced(std::uint8_t a, std::uint8_t b, std::uint8_t c, std::uint8_t d) const {
  if (kind_ != Kind::Average) {
    return cell_[std::max(std::max(key_[a], key_[b]), std::max(key_[c], key_[d]))];
  }
  const std::uint32_t sum = weight_[a] + weight_[b] + weight_[c] + weight_[d];
  const std::uint32_t known = sum >> 16;
  if (known < 2) return unknown_;
  return mean_[((sum & 0xffff) * 2 + known) / (2 * known)];
}

void GridReducer::reduceRow(const std::uint8_t* upper, const std::uint8_t* lower, std::size_t cells,
                            std::uint8_t* out) const {
  const std::size_t pairs = cells / 2;
  if (kind_ == Kind::GrayWins) {
    for (std::size_t u = 0; u < pairs; ++u) {
      out[u] = grayOf(std::min(std::min(grayOrder(upper[2 * u]), grayOrder(upper[2 * u + 1])),
                               std::min(grayOrder(lower[2 * u]), grayOrder(lower[2 * u + 1]))));
    }
  } else if (kind_ == Kind::OccupancyWins) {
    // As int8 the order is that of the ranks: unknown below 0, the rest upwards.
    for (std::size_t u = 0; u < pairs; ++u) {
      out[u] = std::uint8_t(std::max(std::max(std::int8_t(upper[2 * u]), std::int8_t(upper[2 * u + 1])),
                                     std::max(std::int8_t(lower[2 * u]), std::int8_t(lower[2 * u + 1]))));
    }
  } else {
    for (std::size_t u = 0; u < pairs; ++u) {
      const std::uint8_t a = upper[2 * u], b = upper[2 * u + 1], c = lower[2 * u], d = lower[2 * u + 1];
      out[u] = a == b && c == d && a == c && kind_ == Kind::TableWins ? a : reduced(a, b, c, d);
    }
  }
  if (cells % 2 != 0) {
    const std::uint8_t a = upper[cells - 1], c = lower[cells - 1];
    out[pairs] = reduced(a, a, c, c);
  }
}

}  // namespace mapwright::raster
