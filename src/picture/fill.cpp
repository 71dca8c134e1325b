#include "picture/fill.h"

#include <algorithm>
#include <array>
#include <deque>
#include <unordered_map>
#include <utility>

namespace mapwright::picture {

namespace {

constexpr int kWords = Canvas::kEdge / 64;
using Row = std::array<std::uint64_t, kWords>;  // bit 0 of word 0 is column 0

struct Tile {
  std::array<Row, Canvas::kEdge> open;  // of the kind to fill
  std::array<Row, Canvas::kEdge> filled;
  std::array<Row, Canvas::kEdge> seeds;  // reached over an edge, and waiting
  bool waits = false;
};

/// Spreads `seed` along the open bits of a word in both directions.
std::uint64_t spread(std::uint64_t seed, std::uint64_t open) {
  std::uint64_t up = seed & open, down = up, way_up = open, way_down = open;
  for (int shift = 1; shift < 64; shift *= 2) {
    up |= way_up & (up << shift);
    way_up &= way_up << shift;
    down |= way_down & (down >> shift);
    way_down &= way_down >> shift;
  }
  return up | down;
}

Row spreadRow(Row seed, const Row& open) {
  for (std::size_t i = 0; i < kWords; ++i) seed[i] = spread(seed[i], open[i]);
  for (std::size_t i = 1; i < kWords; ++i) seed[i] = spread(seed[i] | (seed[i - 1] >> 63 & open[i]), open[i]);
  for (std::size_t i = kWords - 1; i-- > 0;)
    seed[i] = spread(seed[i] | ((seed[i + 1] & 1) << 63 & open[i]), open[i]);
  return seed;
}

class Filling {
 public:
  Filling(Canvas& canvas, Kind kind) : canvas_(canvas), kinds_(kindsOf(canvas.code())), kind_(kind) {}

  bool run(int column, int row, const std::atomic<bool>* cancelled) {
    Tile& first = at(column / Canvas::kEdge, row / Canvas::kEdge);
    first.seeds[std::size_t(row % Canvas::kEdge)][std::size_t(column % Canvas::kEdge / 64)] |=
        std::uint64_t(1) << (column % 64);
    wait(column / Canvas::kEdge, row / Canvas::kEdge, first);
    while (!queue_.empty()) {
      if (tiles_.size() > kMostFilledTiles || (cancelled && cancelled->load(std::memory_order_relaxed)))
        return false;
      const auto [x, y] = queue_.front();
      queue_.pop_front();
      Tile& tile = at(x, y);
      tile.waits = false;
      if (flow(tile)) handOn(x, y, tile);
    }
    return true;
  }

  void paint(const Ink& ink) {
    for (auto& [key, tile] : tiles_) {
      const int x = int(key & 0xffffffff), y = int(key >> 32);
      for (int v = 0; v < Canvas::kEdge; ++v) paintRow(x, y, v, tile.filled[std::size_t(v)], ink);
    }
  }

 private:
  Tile& at(int x, int y) {
    const auto [found, added] = tiles_.try_emplace(std::uint64_t(unsigned(y)) << 32 | unsigned(x));
    Tile& tile = found->second;
    if (!added) return tile;
    tile.filled = {};
    tile.seeds = {};
    look(x, y, tile);
    return tile;
  }

  void look(int x, int y, Tile& tile) {
    const std::uint8_t* cells = canvas_.read(x, y);
    const int columns = std::min(Canvas::kEdge, canvas_.all().right - x * Canvas::kEdge);
    const int rows = std::min(Canvas::kEdge, canvas_.all().bottom - y * Canvas::kEdge);
    tile.open = {};
    std::array<std::uint8_t, 256> open{};
    for (std::size_t byte = 0; byte < open.size(); ++byte) open[byte] = kinds_[byte] == kind_ ? 1 : 0;
    for (int v = 0; v < rows; ++v, cells += Canvas::kEdge) {
      for (int word = 0; word * 64 < columns; ++word) {
        const int count = std::min(64, columns - word * 64);
        std::uint64_t bits = 0;
        for (int u = 0; u < count; ++u) bits |= std::uint64_t(open[cells[word * 64 + u]]) << u;
        tile.open[std::size_t(v)][std::size_t(word)] = bits;
      }
    }
  }

  /// Spreads the seeds within their tile; false if they reached nothing new.
  static bool flow(Tile& tile) {
    bool any = false;
    for (bool more = true; more;) {
      more = false;
      for (int way = 0; way < 2; ++way) {
        for (int step = 0; step < Canvas::kEdge; ++step) {
          const int v = way == 0 ? step : Canvas::kEdge - 1 - step, before = way == 0 ? v - 1 : v + 1;
          const std::size_t r = std::size_t(v);
          Row fresh{};
          bool some = false;
          for (std::size_t i = 0; i < kWords; ++i) {
            std::uint64_t bits = tile.seeds[r][i];
            if (before >= 0 && before < Canvas::kEdge) bits |= tile.filled[std::size_t(before)][i];
            fresh[i] = bits & tile.open[r][i] & ~tile.filled[r][i];
            some = some || fresh[i] != 0;
          }
          tile.seeds[r] = {};
          if (!some) continue;
          const Row grown = spreadRow(fresh, tile.open[r]);
          for (std::size_t i = 0; i < kWords; ++i) tile.filled[r][i] |= grown[i];
          more = any = true;
        }
      }
    }
    return any;
  }

  void wait(int x, int y, Tile& tile) {
    if (std::exchange(tile.waits, true)) return;
    queue_.emplace_back(x, y);
  }

  bool inside(int x, int y) const {
    return x >= 0 && y >= 0 && x * Canvas::kEdge < canvas_.all().right &&
           y * Canvas::kEdge < canvas_.all().bottom;
  }

  void handOn(int x, int y, Tile& tile) {
    constexpr std::size_t kLast = Canvas::kEdge - 1, kLastWord = kWords - 1;
    const auto rowTo = [&](int to_x, int to_y, const Row& bits, std::size_t row) {
      if (!inside(to_x, to_y) || bits == Row{}) return;
      Tile& to = at(to_x, to_y);
      bool some = false;
      for (std::size_t i = 0; i < kWords; ++i) {
        const std::uint64_t fresh = bits[i] & to.open[row][i] & ~to.filled[row][i];
        to.seeds[row][i] |= fresh;
        some = some || fresh != 0;
      }
      if (some) wait(to_x, to_y, to);
    };
    rowTo(x, y - 1, tile.filled[0], kLast);
    rowTo(x, y + 1, tile.filled[kLast], 0);
    const auto columnTo = [&](int to_x, std::size_t word, std::uint64_t bit, std::size_t to_word,
                              std::uint64_t to_bit) {
      if (!inside(to_x, y)) return;
      Tile* to = nullptr;
      bool some = false;
      for (std::size_t v = 0; v < Canvas::kEdge; ++v) {
        if ((tile.filled[v][word] & bit) == 0) continue;
        if (!to) to = &at(to_x, y);
        const std::uint64_t fresh = to_bit & to->open[v][to_word] & ~to->filled[v][to_word];
        to->seeds[v][to_word] |= fresh;
        some = some || fresh != 0;
      }
      if (some) wait(to_x, y, *to);
    };
    constexpr std::uint64_t kHigh = std::uint64_t(1) << 63;
    columnTo(x - 1, 0, 1, kLastWord, kHigh);
    columnTo(x + 1, kLastWord, kHigh, 0, 1);
  }

  void paintRow(int x, int y, int v, const Row& bits, const Ink& ink) {
    if (bits == Row{}) return;
    const int row = y * Canvas::kEdge + v, left = x * Canvas::kEdge;
    for (int u = 0; u < Canvas::kEdge;) {
      const auto on = [&](int column) { return (bits[std::size_t(column / 64)] >> (column % 64) & 1) != 0; };
      if (bits[std::size_t(u / 64)] == 0) {
        u = (u / 64 + 1) * 64;
        continue;
      }
      if (!on(u)) {
        ++u;
        continue;
      }
      int end = u + 1;
      while (end < Canvas::kEdge && on(end)) {
        end = end % 64 == 0 && bits[std::size_t(end / 64)] == ~std::uint64_t(0) ? end + 64 : end + 1;
      }
      canvas_.paintRow(row, left + u, left + end, ink);
      u = end;
    }
  }

  Canvas& canvas_;
  std::array<Kind, 256> kinds_;
  Kind kind_;
  std::unordered_map<std::uint64_t, Tile> tiles_;
  std::deque<std::pair<int, int>> queue_;
};

}  // namespace

bool floodFill(Canvas& canvas, int column, int row, const Ink& ink, const std::atomic<bool>* cancelled) {
  if (!canvas.all().contains(column, row)) return true;
  const std::uint8_t first = canvas.read(
      column / Canvas::kEdge, row / Canvas::kEdge)[std::size_t(row % Canvas::kEdge) * Canvas::kEdge +
                                                   std::size_t(column % Canvas::kEdge)];
  Filling filling(canvas, kindsOf(canvas.code())[first]);
  if (!filling.run(column, row, cancelled)) return false;
  filling.paint(ink);
  return true;
}

}  // namespace mapwright::picture
