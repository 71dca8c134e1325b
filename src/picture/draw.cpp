#include "picture/draw.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <deque>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace mapwright::picture {
namespace {

// The cursor may be far outside the map; integers must not overflow there.
constexpr double kFarthest = 1e8;
// A cell exactly on the edge of the brush is inside, in spite of rounding.
constexpr double kSlack = 1e-9;

Eigen::Vector2d bounded(const Eigen::Vector2d& at) {
  const auto one = [](double value) {
    return std::isfinite(value) ? std::clamp(value, -kFarthest, kFarthest) : kFarthest;
  };
  return {one(at.x()), one(at.y())};
}

struct Span {
  double from = std::numeric_limits<double>::infinity(), to = -std::numeric_limits<double>::infinity();
  void add(double x) {
    from = std::min(from, x);
    to = std::max(to, x);
  }
};

void addCircle(Span& span, const Eigen::Vector2d& centre, double radius, double y) {
  const double rest = radius * radius - (y - centre.y()) * (y - centre.y());
  if (rest < -kSlack) return;
  const double half = std::sqrt(std::max(rest, 0.0));
  span.add(centre.x() - half);
  span.add(centre.x() + half);
}

void addEdge(Span& span, const Eigen::Vector2d& a, const Eigen::Vector2d& b, double y) {
  if (y < std::min(a.y(), b.y()) || y > std::max(a.y(), b.y())) return;
  if (a.y() == b.y()) {
    span.add(a.x());
    span.add(b.x());
  } else {
    span.add(a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
  }
}

void paintSpan(Canvas& canvas, int row, double from, double to, const Ink& ink) {
  if (!(from <= to)) return;
  canvas.paintRow(row, int(std::ceil(from - 0.5 - kSlack)), int(std::floor(to - 0.5 + kSlack)) + 1, ink);
}

/// Maps the bytes of one code to another, by kind.
std::array<std::uint8_t, 256> translated(grids::CellCode from, grids::CellCode to) {
  const std::array<Kind, 256> kinds = kindsOf(from);
  std::array<std::uint8_t, 256> bytes{};
  for (std::size_t byte = 0; byte < bytes.size(); ++byte) {
    bytes[byte] = from == to ? std::uint8_t(byte) : byteOf(kinds[byte], to).value_or(grids::unknownByte(to));
  }
  return bytes;
}

constexpr int kWords = kEdge / 64;
using Row = std::array<std::uint64_t, kWords>;  // bit 0 of word 0 is column 0

struct Tile {
  std::array<Row, kEdge> open;  // of the kind to fill
  std::array<Row, kEdge> filled;
  std::array<Row, kEdge> seeds;  // reached over an edge, and waiting
  bool waits = false;
};

/// Spreads `seed` along the open bits of a word in both directions.
std::uint64_t spread(std::uint64_t seed, std::uint64_t open) {
  std::uint64_t up = seed & open, down = up, open_up = open, open_down = open;
  for (int shift = 1; shift < 64; shift *= 2) {
    up |= open_up & (up << shift);
    open_up &= open_up << shift;
    down |= open_down & (down >> shift);
    open_down &= open_down >> shift;
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
    Tile& first = at(column / kEdge, row / kEdge);
    first.seeds[std::size_t(row % kEdge)][std::size_t(column % kEdge / 64)] |= std::uint64_t(1)
                                                                               << (column % 64);
    wait(column / kEdge, row / kEdge, first);
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
      for (int v = 0; v < kEdge; ++v) paintRow(x, y, v, tile.filled[std::size_t(v)], ink);
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
    const int columns = std::min(kEdge, canvas_.all().right - x * kEdge);
    const int rows = std::min(kEdge, canvas_.all().bottom - y * kEdge);
    tile.open = {};
    std::array<std::uint8_t, 256> open{};
    for (std::size_t byte = 0; byte < open.size(); ++byte) open[byte] = kinds_[byte] == kind_ ? 1 : 0;
    for (int v = 0; v < rows; ++v, cells += kEdge) {
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
      for (int pass = 0; pass < 2; ++pass) {
        for (int step = 0; step < kEdge; ++step) {
          const int v = pass == 0 ? step : kEdge - 1 - step, before = pass == 0 ? v - 1 : v + 1;
          const std::size_t r = std::size_t(v);
          Row fresh{};
          bool some = false;
          for (std::size_t i = 0; i < kWords; ++i) {
            std::uint64_t bits = tile.seeds[r][i];
            if (before >= 0 && before < kEdge) bits |= tile.filled[std::size_t(before)][i];
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
    return x >= 0 && y >= 0 && x * kEdge < canvas_.all().right && y * kEdge < canvas_.all().bottom;
  }

  void handOn(int x, int y, Tile& tile) {
    constexpr std::size_t kLast = kEdge - 1, kLastWord = kWords - 1;
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
      for (std::size_t v = 0; v < kEdge; ++v) {
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
    const int row = y * kEdge + v, left = x * kEdge;
    for (int u = 0; u < kEdge;) {
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
      while (end < kEdge && on(end)) {
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

Eigen::Vector2d brushCentre(const Eigen::Vector2d& at, int across) {
  const Eigen::Vector2d near = bounded(at);
  if (across % 2 != 0) return {std::floor(near.x()) + 0.5, std::floor(near.y()) + 0.5};
  return {std::round(near.x()), std::round(near.y())};
}

void drawLine(Canvas& canvas, const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Brush& brush) {
  const int across = std::clamp(brush.across, 1, kWidestBrush);
  const Eigen::Vector2d a = brushCentre(from, across), b = brushCentre(to, across);
  const double radius = across / 2.0;
  const Eigen::Vector2d along = b - a;
  const double length = along.norm();
  const Eigen::Vector2d side =
      length > 0 ? Eigen::Vector2d(-along.y(), along.x()) * (radius / length) : Eigen::Vector2d(0, 0);
  const int top = std::max(int(std::floor(std::min(a.y(), b.y()) - radius)), 0);
  const int bottom = std::min(int(std::ceil(std::max(a.y(), b.y()) + radius)) + 1, canvas.all().bottom);
  for (int row = top; row < bottom; ++row) {
    const double y = row + 0.5;
    Span span;
    addCircle(span, a, radius, y);
    if (length > 0) {
      addCircle(span, b, radius, y);
      addEdge(span, a + side, b + side, y);
      addEdge(span, a - side, b - side, y);
      addEdge(span, a - side, a + side, y);
      addEdge(span, b - side, b + side, y);
    }
    paintSpan(canvas, row, span.from, span.to, brush.ink);
  }
}

CellRect rectangleOf(const Eigen::Vector2d& corner, const Eigen::Vector2d& opposite) {
  const Eigen::Vector2d a = bounded(corner), b = bounded(opposite);
  return {int(std::floor(std::min(a.x(), b.x()))), int(std::floor(std::min(a.y(), b.y()))),
          int(std::floor(std::max(a.x(), b.x()))) + 1, int(std::floor(std::max(a.y(), b.y()))) + 1};
}

void drawRectangle(Canvas& canvas, const CellRect& rect, const Ink& ink) {
  const CellRect inside = rect.intersected(canvas.all());
  for (int row = inside.top; row < inside.bottom; ++row) canvas.paintRow(row, inside.left, inside.right, ink);
}

void drawPolygon(Canvas& canvas, std::span<const Eigen::Vector2d> corners, const Ink& ink) {
  if (corners.size() < 3) return;
  std::vector<Eigen::Vector2d> points;
  points.reserve(corners.size());
  double least = kFarthest, most = -kFarthest;
  for (const Eigen::Vector2d& corner : corners) {
    points.push_back(bounded(corner));
    least = std::min(least, points.back().y());
    most = std::max(most, points.back().y());
  }
  const int top = std::max(int(std::floor(least)), 0);
  const int bottom = std::min(int(std::ceil(most)) + 1, canvas.all().bottom);
  std::vector<double> crossings;
  for (int row = top; row < bottom; ++row) {
    const double y = row + 0.5;
    crossings.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector2d &a = points[i], &b = points[(i + 1) % points.size()];
      if ((a.y() <= y) == (b.y() <= y)) continue;
      crossings.push_back(a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      paintSpan(canvas, row, crossings[i], crossings[i + 1], ink);
    }
  }
}

CellRect Stroke::to(const Eigen::Vector2d& at) {
  Canvas canvas(grid_);
  drawLine(canvas, last_.value_or(at), at, brush_);
  last_ = at;
  const Patch step = canvas.take();
  if (step.empty()) return {};
  grid_.apply(step);
  patch_.append(step);
  return step.cells;
}

std::optional<Clip> copyCells(Canvas& canvas, const CellRect& rect) {
  const CellRect inside = rect.intersected(canvas.all());
  if (inside.empty() || inside.area() > kMostClippedCells) return std::nullopt;
  Clip clip{inside.width(), inside.height(), {}, canvas.code()};
  clip.cells.resize(std::size_t(inside.area()));
  for (int row = inside.top; row < inside.bottom; ++row)
    canvas.getRow(row, inside.left, inside.right,
                  clip.cells.data() + std::size_t(row - inside.top) * std::size_t(clip.width));
  return clip;
}

void putClip(Canvas& canvas, const Clip& clip, int left, int top) {
  const std::array<std::uint8_t, 256> bytes = translated(clip.code, canvas.code());
  std::vector<std::uint8_t> row(std::size_t(std::max(clip.width, 0)));
  for (int v = 0; v < clip.height; ++v) {
    const std::uint8_t* const cells = clip.cells.data() + std::size_t(v) * row.size();
    std::transform(cells, cells + row.size(), row.begin(), [&](std::uint8_t cell) { return bytes[cell]; });
    canvas.putRow(top + v, left, left + clip.width, row.data());
  }
}

bool floodFill(Canvas& canvas, int column, int row, const Ink& ink, const std::atomic<bool>* cancelled) {
  if (!canvas.all().contains(column, row)) return true;
  const std::uint8_t first = canvas.read(
      column / kEdge, row / kEdge)[std::size_t(row % kEdge) * kEdge + std::size_t(column % kEdge)];
  Filling filling(canvas, kindsOf(canvas.code())[first]);
  if (!filling.run(column, row, cancelled)) return false;
  filling.paint(ink);
  return true;
}

}  // namespace mapwright::picture
