// Submaps for the tests of agreement, and a reading of their cells of its own: every lattice cell of every
// submap, without tiles.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "agreement/survey.h"
#include "cells/cell_texture.h"

namespace mapwright::testing {

using agreement::Rules;
using cells::CellPair;
using render::PlacedTexture;

inline constexpr CellPair kFree{60, 0}, kWall{0, 60}, kNothing{0, 0}, kMaybe{0, 1};

/// A texture whose frame is turned such that column u runs along x and row v along y of the world, the first
/// cell at (x, y): Cartographer's axes run along -y and -x.
inline PlacedTexture submap(int index, double x, double y, int width, int height, std::vector<CellPair> cells,
                            double resolution = 0.05) {
  // Turned by 180 degrees, columns run along +y and rows along +x: so cells are given row by row along x.
  std::vector<CellPair> turned(cells.size());
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column)
      turned[std::size_t(column * height + row)] = cells[std::size_t(row * width + column)];
  }
  return {{0, index},
          cells::CellTexture::fromPairs(height, width, resolution, turned),
          {x, y, std::acos(-1.0)},
          0};
}

/// `width` x `height` cells alike.
inline PlacedTexture plain(int index, double x, double y, int width, int height, CellPair cell) {
  return submap(index, x, y, width, height,
                std::vector<CellPair>(std::size_t(width) * std::size_t(height), cell));
}

using Cell = std::pair<std::int64_t, std::int64_t>;  // column (x), row (y) of the lattice

struct PlainReading {
  std::map<Cell, int> seen_by;
  std::set<Cell> occupied, contradicted;
  /// Cells that contradict in a square of 1 m, and how many of them a submap holds occupied, and saw free.
  std::map<std::pair<int, int>, std::pair<int, std::map<map::SubmapId, std::pair<int, int>>>> squares;
};

/// From the definition alone.
inline PlainReading plainReading(const std::vector<PlacedTexture>& submaps, const Rules& rules) {
  PlainReading all;
  struct Own {
    map::SubmapId id;
    std::set<Cell> occupied, free;
  };
  std::vector<Own> each;
  for (const PlacedTexture& placed : submaps) {
    Own own{placed.id, {}, {}};
    const double turn = placed.world_from_texture.yaw_rad, size = placed.texture->resolutionM();
    const double reach = std::hypot(placed.texture->width(), placed.texture->height()) * size + 1;
    const auto indexOf = [&](double metres) { return std::int64_t(std::floor(metres / rules.cell_m)); };
    for (std::int64_t row = indexOf(placed.world_from_texture.y_m - reach);
         row <= indexOf(placed.world_from_texture.y_m + reach); ++row) {
      for (std::int64_t column = indexOf(placed.world_from_texture.x_m - reach);
           column <= indexOf(placed.world_from_texture.x_m + reach); ++column) {
        const double dx = (double(column) + 0.5) * rules.cell_m - placed.world_from_texture.x_m;
        const double dy = (double(row) + 0.5) * rules.cell_m - placed.world_from_texture.y_m;
        const double x = std::cos(turn) * dx + std::sin(turn) * dy,
                     y = std::cos(turn) * dy - std::sin(turn) * dx;
        const CellPair cell = placed.texture->at(int(std::floor(-y / size)), int(std::floor(-x / size)));
        if (cell == kNothing) continue;
        ++all.seen_by[{column, row}];
        const double p = 1 / (1 + std::exp(-(std::log(1.0 / 9) +
                                             (127.0 - cell.value + cell.alpha) * 2 * std::log(9.0) / 254)));
        if (p > 0.6) own.occupied.insert({column, row});
        if (p < 0.4) own.free.insert({column, row});
      }
    }
    all.occupied.insert(own.occupied.begin(), own.occupied.end());
    each.push_back(std::move(own));
  }
  const auto squareOf = [&](const Cell& cell) {
    return std::pair(int(std::floor((double(cell.first) + 0.5) * rules.cell_m)),
                     int(std::floor((double(cell.second) + 0.5) * rules.cell_m)));
  };
  for (const Cell& cell : all.occupied) {
    std::set<map::SubmapId> who;
    for (const Own& other : each) {
      if (!other.free.contains(cell)) continue;
      bool holds_any = false;
      const int r = rules.tolerance_cells;
      for (int dy = -r; dy <= r && !holds_any; ++dy) {
        for (int dx = -r; dx <= r && !holds_any; ++dx)
          holds_any =
              dx * dx + dy * dy <= r * r && other.occupied.contains({cell.first + dx, cell.second + dy});
      }
      if (!holds_any) who.insert(other.id);
    }
    if (who.empty()) continue;
    all.contradicted.insert(cell);
    auto& [cells, submaps_there] = all.squares[squareOf(cell)];
    ++cells;
    for (const Own& own : each) {
      if (own.occupied.contains(cell)) ++submaps_there[own.id].first;
    }
    for (const map::SubmapId id : who) ++submaps_there[id].second;
  }
  return all;
}

/// Submaps at any angle and of several resolutions around (x, y), which agree here and there.
inline std::vector<PlacedTexture> someSubmaps(unsigned seed, double x, double y, int count) {
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::vector<PlacedTexture> all;
  for (int index = 0; index < count; ++index) {
    const int width = int(between(1, 70)), height = int(between(1, 70));
    std::vector<CellPair> cells(std::size_t(width * height));
    const double walls = between(0.001, 0.06);
    const bool pairs = between(0, 1) < 0.3;  // opaque grays in between: another layout
    for (std::size_t at = 0; at < cells.size(); ++at) {
      const double kind = between(0, 1);
      cells[at] = kind < 0.15           ? kNothing
                  : kind < 0.15 + walls ? CellPair{0, std::uint8_t(between(1, 128))}
                                        : CellPair{std::uint8_t(between(1, 127)), 0};
    }
    if (pairs) cells[0] = {0, 200};  // more than folded cells hold
    all.push_back({{int(between(0, 3)), index},
                   cells::CellTexture::fromPairs(width, height,
                                                 std::vector{0.05, 0.05, 0.02, 0.11}[random() % 4], cells),
                   {x + between(-2, 2), y + between(-2, 2), between(-4, 4)},
                   0});
  }
  return all;
}

}  // namespace mapwright::testing
