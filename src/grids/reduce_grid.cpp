#include "grids/reduce_grid.h"

#include <algorithm>
#include <numeric>

namespace mapwright::grids {

namespace {

// Grays in an order that a compiler can vectorise: the lowest wins. Black 0 up to white, unknown above in
// reverse, so that of several the greatest byte wins: 205, then the range.
template <CellCode code>
constexpr std::uint8_t grayOrder(std::uint8_t gray) {
  constexpr UnknownGrays kUnknown = unknownGrays(code);
  constexpr int kBand = kUnknown.to - kUnknown.from + 1, kKnown = 256 - kBand - (kUnknown.saver ? 1 : 0);
  const std::uint8_t known = std::uint8_t(gray - (kBand > 0 && gray > kUnknown.to ? kBand : 0) -
                                          (kUnknown.saver && gray > 205 ? 1 : 0));
  const bool saver = kUnknown.saver && gray == 205;
  const std::uint8_t unknown =
      saver ? std::uint8_t(kKnown) : std::uint8_t(kKnown + (kUnknown.saver ? 1 : 0) + kUnknown.to - gray);
  return (kBand > 0 && gray >= kUnknown.from && gray <= kUnknown.to) || saver ? unknown : known;
}

template <CellCode code>
constexpr std::uint8_t grayOf(std::uint8_t order) {
  constexpr UnknownGrays kUnknown = unknownGrays(code);
  constexpr int kBand = kUnknown.to - kUnknown.from + 1, kKnown = 256 - kBand - (kUnknown.saver ? 1 : 0);
  constexpr int kFirst = kKnown + (kUnknown.saver ? 1 : 0);  // of the band
  if (kBand > 0 && order >= kFirst) return std::uint8_t(kUnknown.to - (order - kFirst));
  if (kUnknown.saver && order == kKnown) return 205;
  const int lighter = order + (kBand > 0 && order >= kUnknown.from ? kBand : 0);
  return std::uint8_t(lighter + (kUnknown.saver && lighter >= 205 ? 1 : 0));
}

template <CellCode code>
constexpr bool comesBack() {
  for (int gray = 0; gray < 256; ++gray) {
    if (grayOf<code>(grayOrder<code>(std::uint8_t(gray))) != gray) return false;
  }
  return true;
}
static_assert(comesBack<CellCode::Gray>() && comesBack<CellCode::ShadedGray>() &&
              comesBack<CellCode::ClearGray>() && comesBack<CellCode::FullGray>());

}  // namespace

GridReducer::GridReducer(CellCode code, Reduction reduction) : code_(code) {
  const CellMeaning& meaning = meaningOf(code);
  rankBytes(meaning.rank);
  // A rank has no room for 256 grays and unknown: the lightest two share one, and the darker has to win.
  if (code == CellCode::FullGray) {
    for (std::size_t gray = 0; gray < 256; ++gray) key_[gray] = cell_[gray] = std::uint8_t(255 - gray);
  }
  unknown_ = unknownByte(code);
  if (reduction == Reduction::OccupiedWins) {
    kind_ = isGray(code) ? Kind::GrayWins : Kind::OccupancyWins;
    return;
  }
  kind_ = Kind::Average;
  for (std::size_t byte = 0; byte < 256; ++byte) {
    const std::uint32_t value =
        isGray(code) ? std::uint32_t(byte) : std::uint32_t(std::uint8_t(meaning.occupancy[byte]));
    weight_[byte] = meaning.known[byte] ? 1u << 16 | value : 0;
    mean_[byte] = std::uint8_t(byte);
    // A mean of known grays must not mean unknown: use the nearest gray that does not, the darker of two.
    if (isGray(code) && !meaning.known[byte]) {
      const UnknownGrays unknown = unknownGrays(code);
      const bool darker = int(byte) * 2 <= unknown.from + unknown.to;
      mean_[byte] = std::uint8_t(byte == 205 ? 204 : darker ? unknown.from - 1 : unknown.to + 1);
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

template <CellCode code>
void GridReducer::reduceGrays(const std::uint8_t* upper, const std::uint8_t* lower, std::size_t pairs,
                              std::uint8_t* out) {
  for (std::size_t u = 0; u < pairs; ++u) {
    out[u] =
        grayOf<code>(std::min(std::min(grayOrder<code>(upper[2 * u]), grayOrder<code>(upper[2 * u + 1])),
                              std::min(grayOrder<code>(lower[2 * u]), grayOrder<code>(lower[2 * u + 1]))));
  }
}

void GridReducer::reduceRow(const std::uint8_t* upper, const std::uint8_t* lower, std::size_t cells,
                            std::uint8_t* out) const {
  const std::size_t pairs = cells / 2;
  if (kind_ == Kind::GrayWins) {
    const auto reduce = code_ == CellCode::ShadedGray  ? reduceGrays<CellCode::ShadedGray>
                        : code_ == CellCode::ClearGray ? reduceGrays<CellCode::ClearGray>
                        : code_ == CellCode::FullGray  ? reduceGrays<CellCode::FullGray>
                                                       : reduceGrays<CellCode::Gray>;
    reduce(upper, lower, pairs, out);
  } else if (kind_ == Kind::OccupancyWins) {
    // As int8 the order equals that of the ranks: unknown below 0, the rest above.
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

}  // namespace mapwright::grids
