#include "agreement/tile.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>
#include <span>
#include <utility>

#include "cells/cell_texture.h"
#include "render/tap_cells.h"

namespace mapwright::agreement {
namespace {

// A window is a tile with one word on either side, of which the tolerance is used, and as many rows above and
// below.
constexpr int kMargin = 64;
constexpr int kWindowCells = kTileCells + 2 * kMargin;
constexpr int kWindowWords = kWindowCells / 64;
static_assert(kMostTolerance < kMargin);

using WindowRow = std::array<std::uint64_t, std::size_t(kWindowWords)>;
using TileRow = std::array<std::uint64_t, std::size_t(Tile::kWords)>;

// Bits of a cell that was read.
constexpr std::uint8_t kOccupiedBit = 1, kFreeBit = 2, kSeenBit = 4;

std::uint8_t bitsOf(cells::CellPair cell) {
  switch (readingOf(cell)) {
    case Reading::Unseen:
      return 0;
    case Reading::Free:
      return kFreeBit | kSeenBit;
    case Reading::Undecided:
      return kSeenBit;
    case Reading::Occupied:
      return kOccupiedBit | kSeenBit;
  }
  return 0;
}

/// By the byte of a folded cell.
const std::array<std::uint8_t, 256>& bitsOfFolded() {
  static const auto table = [] {
    std::array<std::uint8_t, 256> bits{};
    for (int byte = 0; byte < 256; ++byte) {
      const int delta = std::int8_t(byte);
      bits[std::size_t(byte)] = bitsOf({std::uint8_t(std::max(delta, 0)), std::uint8_t(std::max(-delta, 0))});
    }
    return bits;
  }();
  return table;
}

/// By value + 256 * alpha.
const std::vector<std::uint8_t>& bitsOfPairs() {
  static const auto table = [] {
    std::vector<std::uint8_t> bits(65'536);
    for (std::size_t at = 0; at < bits.size(); ++at)
      bits[at] = bitsOf({std::uint8_t(at & 255), std::uint8_t(at >> 8)});
    return bits;
  }();
  return table;
}

/// Continuous cells of a texture (u along its columns, v along its rows) at the centres of lattice cells.
struct Sampling {
  Eigen::Vector2d at_origin;  // at the centre of the tile's cell (0, 0)
  Eigen::Vector2d per_column, per_row;
};

Sampling samplingOf(const render::PlacedTexture& placed, TileKey key, double cell_m) {
  const geometry::Pose2& pose = placed.world_from_texture;
  const double c = std::cos(pose.yaw_rad), s = std::sin(pose.yaw_rad),
               resolution = placed.texture->resolutionM();
  const Eigen::Vector2d first = centreOf(key, 0, 0, cell_m);
  const double x = first.x() - pose.x_m, y = first.y() - pose.y_m;
  // Rows run along -x of the texture's frame, columns along -y.
  const auto toCells = [&](double along_x, double along_y) {
    return Eigen::Vector2d((s * along_x - c * along_y) / resolution,
                           (-c * along_x - s * along_y) / resolution);
  };
  return {toCells(x, y), toCells(cell_m, 0), toCells(0, cell_m)};
}

/// Narrows [first, last] to where start + n * step lies in [0, size], with half a cell more on either side:
/// what rounding adds there is read in the border, which is empty.
void clip(double start, double step, int size, int& first, int& last) {
  const double low = -0.5, high = size + 0.5;
  if (std::abs(step) < 1e-9) {
    if (start < low || start > high) last = first - 1;
    return;
  }
  const double a = (low - start) / step, b = (high - start) / step;
  first = int(std::max(double(first), std::ceil(std::min(a, b))));
  last = int(std::min(double(last), std::floor(std::max(a, b))));
}

/// One submap in the window of a tile.
class SubmapReader {
 public:
  SubmapReader(const TileTask& task, Tile& tile)
      : task_(task), tolerance_(task.rules.tolerance_cells), tile_(tile) {
    const std::size_t rows = std::size_t(kTileCells + 2 * tolerance_);
    occupied_.resize(rows);
    // How far along a row the disc of the tolerance reaches, by rows away from its centre.
    for (int away = 0; away <= tolerance_; ++away)
      reach_.push_back(int(std::sqrt(double(tolerance_ * tolerance_ - away * away))));
  }

  void read(const render::PlacedTexture& placed, const render::TapCells& cells) {
    std::fill(occupied_.begin(), occupied_.end(), WindowRow{});
    free_.fill({});
    const Sampling sampling = samplingOf(placed, task_.key, task_.rules.cell_m);
    const bool folded = cells.level.layout == cells::CellLayout::Folded;
    for (int row = -tolerance_; row < kTileCells + tolerance_; ++row) {
      const Eigen::Vector2d start = sampling.at_origin + row * sampling.per_row;
      int first = -tolerance_, last = kTileCells + tolerance_ - 1;
      clip(start.x(), sampling.per_column.x(), cells.level.width, first, last);
      clip(start.y(), sampling.per_column.y(), cells.level.height, first, last);
      if (first > last) continue;
      if (folded) {
        sample(cells, start + first * sampling.per_column, sampling.per_column, first, last,
               [table = bitsOfFolded().data()](const std::uint8_t* cell) { return table[*cell]; });
      } else {
        sample(cells, start + first * sampling.per_column, sampling.per_column, first, last,
               [table = bitsOfPairs().data()](const std::uint8_t* cell) {
                 return table[cell[0] + 256 * cell[1]];
               });
      }
      keep(row, first, last);
    }
  }

  /// Takes what it saw free without holding anything near it occupied.
  void clearRows(std::array<TileRow, std::size_t(kTileCells)>& clear) const {
    clear = free_;
    for (int row = -tolerance_; row < kTileCells + tolerance_; ++row) {
      WindowRow grown = occupied_[std::size_t(row + tolerance_)];
      if (std::all_of(grown.begin(), grown.end(), [](std::uint64_t word) { return word == 0; })) continue;
      int width = 0;
      for (int away = tolerance_; away >= 0; --away) {  // reach_ grows towards the centre
        for (; width < reach_[std::size_t(away)]; ++width) grow(grown);
        take(clear, row - away, grown);
        if (away != 0) take(clear, row + away, grown);
      }
    }
  }

  TileRow occupiedRow(int row) const {
    TileRow inside;
    std::copy_n(occupied_[std::size_t(row + tolerance_)].begin() + 1, inside.size(), inside.begin());
    return inside;
  }

 private:
  /// Fills classes_ from `first` to `last`. 32 bits after the point: the error stays below 1e-7 cells.
  template <typename Bits>
  void sample(const render::TapCells& cells, const Eigen::Vector2d& start, const Eigen::Vector2d& step,
              int first, int last, Bits bits) {
    constexpr double kOne = 4294967296.0;
    std::int64_t u = std::llround(start.x() * kOne), v = std::llround(start.y() * kOne);
    const std::int64_t du = std::llround(step.x() * kOne), dv = std::llround(step.y() * kOne);
    constexpr int kBorder = cells::DenseCells::kBorder;
    const std::ptrdiff_t stride = cells.level.stride;
    const std::uint8_t* const origin =
        cells.taps.get() + (kBorder * stride + kBorder) * render::TapCells::kBytesPerCell;
    for (int at = kMargin + first; at <= kMargin + last; ++at, u += du, v += dv) {
      const std::ptrdiff_t cell = std::ptrdiff_t(v >> 32) * stride + std::ptrdiff_t(u >> 32);
      classes_[std::size_t(at)] = bits(origin + cell * render::TapCells::kBytesPerCell);
    }
  }

  /// The lowest bit of each of 64 bytes.
  static std::uint64_t packed(const std::uint8_t* bytes, int shift) {
    std::uint64_t word = 0;
    for (int eight = 0; eight < 8; ++eight) {
      std::uint64_t lanes = 0;
      for (int n = 0; n < 8; ++n) lanes |= std::uint64_t(bytes[8 * eight + n]) << (8 * n);
      word |= ((lanes >> shift & 0x0101010101010101) * 0x0102040810204080 >> 56) << (8 * eight);
    }
    return word;
  }

  void keep(int row, int first, int last) {
    WindowRow& occupied = occupied_[std::size_t(row + tolerance_)];
    const bool inside = row >= 0 && row < kTileCells;
    const int last_word = (kMargin + last) / 64;
    for (int word = (kMargin + first) / 64; word <= last_word; ++word) {
      const std::uint8_t* const bytes = classes_.data() + 64 * word;
      occupied[std::size_t(word)] = packed(bytes, 0);
      if (inside && word >= 1 && word <= Tile::kWords) {
        free_[std::size_t(row)][std::size_t(word - 1)] = packed(bytes, 1);
      }
    }
    if (inside) {
      std::uint8_t* const seen_by = tile_.seen_by.data() + std::ptrdiff_t(row) * kTileCells;
      const std::uint8_t* const classes = classes_.data() + kMargin;
      for (int column = 0; column < kTileCells; ++column) {
        const unsigned sum = unsigned(seen_by[column]) + (classes[column] / kSeenBit);
        seen_by[column] = std::uint8_t(std::min(sum, unsigned(Tile::kManySubmaps)));
      }
    }
    std::fill(classes_.begin() + kMargin + first, classes_.begin() + kMargin + last + 1, std::uint8_t(0));
  }

  /// One cell wider on both sides.
  static void grow(WindowRow& row) {
    const WindowRow before = row;
    for (std::size_t word = 0; word < row.size(); ++word) {
      row[word] |= before[word] << 1 | before[word] >> 1;
      if (word > 0) row[word] |= before[word - 1] >> 63;
      if (word + 1 < row.size()) row[word] |= before[word + 1] << 63;
    }
  }

  static void take(std::array<TileRow, std::size_t(kTileCells)>& clear, int row, const WindowRow& near) {
    if (row < 0 || row >= kTileCells) return;
    for (std::size_t word = 0; word < std::size_t(Tile::kWords); ++word)
      clear[std::size_t(row)][word] &= ~near[word + 1];
  }

  const TileTask& task_;
  const int tolerance_;
  Tile& tile_;
  std::vector<int> reach_;
  std::vector<WindowRow> occupied_;  // with those within the tolerance outside
  std::array<TileRow, std::size_t(kTileCells)> free_{};
  std::array<std::uint8_t, std::size_t(kWindowCells)> classes_{};  // of one row; zero between rows
};

/// What a submap claims about the cells of a tile: that they are occupied, or clearly free.
struct Claims {
  map::SubmapId id;
  Tile::Bits occupied, clear;
};

/// For every column of a tile the column behind its square of 1 m.
class SquareColumns {
 public:
  SquareColumns(std::int64_t first, double cell_m) {
    const auto squareOf = [&](int at) { return int(std::floor((double(first + at) + 0.5) * cell_m)); };
    for (int at = kTileCells - 1; at >= 0; --at) {
      square_[std::size_t(at)] = squareOf(at);
      const bool last = at == kTileCells - 1 || square_[std::size_t(at) + 1] != square_[std::size_t(at)];
      end_[std::size_t(at)] = last ? at + 1 : end_[std::size_t(at) + 1];
    }
  }
  int square(int at) const { return square_[std::size_t(at)]; }
  int end(int at) const { return end_[std::size_t(at)]; }

 private:
  std::array<int, std::size_t(kTileCells)> square_{}, end_{};
};

/// Calls visit(column) for set bits of a row; it returns from which column on to look further.
template <typename Visit>
void eachSet(const std::uint64_t* row, Visit visit) {
  int from = 0;
  while (from < kTileCells) {
    const std::uint64_t word = row[from / 64] >> (from % 64);
    if (word == 0) {
      from = (from / 64 + 1) * 64;
      continue;
    }
    from = visit(from + std::countr_zero(word));
  }
}

/// Set bits of a row in [first, end).
int countBetween(const std::uint64_t* row, int first, int end) {
  int count = 0;
  for (int at = first; at < end; at = (at / 64 + 1) * 64) {
    std::uint64_t word = row[at / 64] >> (at % 64);
    if (const int length = end - at; length < 64) word &= (std::uint64_t(1) << length) - 1;
    count += std::popcount(word);
  }
  return count;
}

void findSquares(const TileTask& task, const std::vector<Claims>& all, Tile& tile) {
  const SquareColumns columns(std::int64_t(task.key.column) * kTileCells, task.rules.cell_m);
  const SquareColumns rows(std::int64_t(task.key.row) * kTileCells, task.rules.cell_m);
  for (int row = 0; row < kTileCells; ++row) {
    eachSet(&tile.contradicted[std::size_t(row * Tile::kWords)], [&](int column) {
      ++tile.squares[{columns.square(column), rows.square(row)}].cells;
      return column + 1;
    });
  }
  for (const Claims& claims : all) {  // in ascending order
    for (int row = 0; row < kTileCells; ++row) {
      TileRow occupied, hit;  // of those that contradict
      for (std::size_t word = 0; word < hit.size(); ++word) {
        const std::size_t at = std::size_t(row) * hit.size() + word;
        occupied[word] = claims.occupied[at] & tile.contradicted[at];
        hit[word] = occupied[word] | (claims.clear[at] & tile.contradicted[at]);
      }
      eachSet(hit.data(), [&](int column) {
        const int end = columns.end(column);
        std::vector<Part>& parts = tile.squares[{columns.square(column), rows.square(row)}].submaps;
        if (parts.empty() || parts.back().id != claims.id) parts.push_back({claims.id});
        const int its_occupied = countBetween(occupied.data(), column, end);
        parts.back().occupied = std::uint16_t(parts.back().occupied + its_occupied);
        parts.back().free =
            std::uint16_t(parts.back().free + countBetween(hit.data(), column, end) - its_occupied);
        return end;
      });
    }
  }
}

std::uint64_t countOf(const Tile::Bits& bits) {
  std::uint64_t count = 0;
  for (const std::uint64_t word : bits) count += std::uint64_t(std::popcount(word));
  return count;
}

}  // namespace

Reading readingOf(cells::CellPair cell) {
  if (cell == cells::CellPair{}) return Reading::Unseen;
  double probability = 0;
  if (cell.value == 0 || cell.alpha == 0) {
    const int k = 128 - (int(cell.value) - int(cell.alpha));
    const double least = std::log(0.1 / 0.9);
    probability = 1 / (1 + std::exp(-(least + (k - 1) * (-2 * least) / 254)));
  } else {
    const double intensity = std::min(255.0, cell.value + 128.0 * (255 - cell.alpha) / 255);
    probability = 1 - intensity / 255;
  }
  return probability > 0.6 ? Reading::Occupied : probability < 0.4 ? Reading::Free : Reading::Undecided;
}

Square squareAt(double x, double y) { return {std::int32_t(std::floor(x)), std::int32_t(std::floor(y))}; }

Eigen::Vector2d centreOf(TileKey key, int column, int row, double cell_m) {
  return {(double(key.column) * kTileCells + column + 0.5) * cell_m,
          (double(key.row) * kTileCells + row + 0.5) * cell_m};
}

geometry::WorldRect boundsOf(TileKey key, double cell_m) {
  const double edge = kTileCells * cell_m;
  return {key.column * edge, key.row * edge, (key.column + 1.0) * edge, (key.row + 1.0) * edge};
}

geometry::WorldRect reachOf(TileKey key, const Rules& rules) {
  return boundsOf(key, rules.cell_m).grown(rules.tolerance_cells * rules.cell_m);
}

std::shared_ptr<const Tile> makeTile(const TileTask& task, render::DenseCache& cache,
                                     const std::atomic<bool>* cancelled) {
  const auto tile = std::make_shared<Tile>();
  std::vector<const render::PlacedTexture*> near;
  for (const render::PlacedTexture& placed : task.near) near.push_back(&placed);
  std::sort(near.begin(), near.end(), [](const auto* a, const auto* b) { return a->id < b->id; });
  SubmapReader reader(task, *tile);
  Tile::Bits clear{};  // one of them saw it free, and nothing near it occupied
  std::vector<Claims> all;
  std::array<TileRow, std::size_t(kTileCells)> its_clear{};
  for (const render::PlacedTexture* const placed : near) {
    if (cancelled && cancelled->load()) return nullptr;
    reader.read(*placed, *cache.get(placed->texture, 0));
    reader.clearRows(its_clear);
    Claims& claims = all.emplace_back();
    claims.id = placed->id;
    for (int row = 0; row < kTileCells; ++row) {
      const TileRow its_occupied = reader.occupiedRow(row);
      for (std::size_t word = 0; word < its_occupied.size(); ++word) {
        const std::size_t at = std::size_t(row) * its_occupied.size() + word;
        const std::uint64_t its_free = its_clear[std::size_t(row)][word];
        tile->occupied[at] |= its_occupied[word];
        clear[at] |= its_free;
        claims.occupied[at] = its_occupied[word];
        claims.clear[at] = its_free;
      }
    }
  }
  for (std::size_t at = 0; at < clear.size(); ++at) tile->contradicted[at] = tile->occupied[at] & clear[at];
  tile->occupied_cells = countOf(tile->occupied);
  tile->contradicted_cells = countOf(tile->contradicted);
  for (const std::uint8_t count : tile->seen_by) ++tile->cells_seen_by[count];
  tile->seen_cells = tile->seen_by.size() - tile->cells_seen_by[0];
  if (tile->contradicted_cells > 0) findSquares(task, all, *tile);
  return tile;
}

}  // namespace mapwright::agreement
