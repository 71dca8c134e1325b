// Maps of made-up buildings, and what a second mapping of the same site does to them. Deterministic.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "align/plan.h"
#include "geometry/pose.h"

namespace mapwright::testing {

using align::Ground;
using align::Plan;
using geometry::Pose2;

class Chance {
 public:
  explicit Chance(unsigned seed) : bits_(seed) {}
  double between(double low, double high) { return low + (high - low) * (double(bits_()) / 4294967296.0); }
  int below(int count) { return int(between(0, count)); }
  bool happens(double share) { return between(0, 1) < share; }

 private:
  std::mt19937 bits_;
};

inline Ground& cellOf(Plan& plan, int column, int row) {
  return plan.cells[std::size_t(row) * std::size_t(plan.width) + std::size_t(column)];
}

inline void fill(Plan& plan, int left, int low, int right, int high, Ground ground) {
  for (int row = std::max(low, 0); row <= std::min(high, plan.height - 1); ++row) {
    for (int column = std::max(left, 0); column <= std::min(right, plan.width - 1); ++column) {
      cellOf(plan, column, row) = ground;
    }
  }
}

/// Walls in a part of a building, with a door in each, down to rooms of a few metres.
inline void divide(Plan& plan, Chance& chance, int left, int low, int right, int high) {
  const int width = right - left, height = high - low, least = 70;
  if (std::max(width, height) < 2 * least || (std::max(width, height) < 4 * least && chance.happens(0.15)))
    return;
  const int door = 18;
  if (width > height) {
    const int at = left + least + chance.below(width - 2 * least + 1);
    const int gap = low + 4 + chance.below(std::max(1, height - door - 8));
    fill(plan, at, low, at + 1, high, Ground::Wall);
    fill(plan, at, gap, at + 1, gap + door, Ground::Free);
    divide(plan, chance, left, low, at, high);
    divide(plan, chance, at + 1, low, right, high);
  } else {
    const int at = low + least + chance.below(height - 2 * least + 1);
    const int gap = left + 4 + chance.below(std::max(1, width - door - 8));
    fill(plan, left, at, right, at + 1, Ground::Wall);
    fill(plan, gap, at, gap + door, at + 1, Ground::Free);
    divide(plan, chance, left, low, right, at);
    divide(plan, chance, left, at + 1, right, high);
  }
}

/// Boxes on free ground.
inline void furnish(Plan& plan, Chance& chance, int pieces) {
  for (int piece = 0; piece < pieces; ++piece) {
    const int column = chance.below(plan.width), row = chance.below(plan.height);
    if (plan.at(column, row) != Ground::Free) continue;
    fill(plan, column, row, column + 5 + chance.below(22), row + 5 + chance.below(22), Ground::Wall);
  }
}

/// About 16 m x 11 m at 5 cm, without furniture.
inline Plan building(Chance& chance) {
  Plan plan;
  plan.width = 300 + chance.below(60);
  plan.height = 200 + chance.below(60);
  plan.resolution_m = 0.05;
  plan.corner_m = {chance.between(-30, 30), chance.between(-30, 30)};
  plan.cells.assign(std::size_t(plan.width) * std::size_t(plan.height), Ground::Unknown);
  fill(plan, 0, 0, plan.width - 1, plan.height - 1, Ground::Wall);
  fill(plan, 2, 2, plan.width - 3, plan.height - 3, Ground::Free);
  divide(plan, chance, 1, 1, plan.width - 2, plan.height - 2);
  return plan;
}

/// Each with its own furniture.
inline Plan furnished(Plan plan, Chance& chance, int pieces) {
  furnish(plan, chance, pieces);
  return plan;
}

/// Half a turn changes nothing.
inline Plan symmetric(Plan plan) {
  for (std::size_t i = 0; i < plan.cells.size(); ++i) {
    plan.cells[i] = std::max(plan.cells[i], plan.cells[plan.cells.size() - 1 - i]);
  }
  return plan;
}

inline Plan mirrored(Plan plan) {
  for (int row = 0; row < plan.height; ++row) {
    const auto from = plan.cells.begin() + std::ptrdiff_t(row) * plan.width;
    std::reverse(from, from + plan.width);
  }
  return plan;
}

/// A rectangle of it, of that share of its area; the rest was not seen.
inline Plan cropped(Plan plan, Chance& chance, double share) {
  const double wide = std::clamp(std::sqrt(share) * chance.between(0.8, 1.25), share, 1.0);
  const int width = int(plan.width * wide), height = int(plan.height * share / wide);
  const int left = chance.below(plan.width - width + 1), low = chance.below(plan.height - height + 1);
  for (int row = 0; row < plan.height; ++row) {
    for (int column = 0; column < plan.width; ++column) {
      const bool inside = column >= left && column < left + width && row >= low && row < low + height;
      if (!inside) cellOf(plan, column, row) = Ground::Unknown;
    }
  }
  return plan;
}

/// Walls with holes, and dots on free ground.
inline Plan noisy(Plan plan, Chance& chance, double holes, double dots) {
  for (Ground& cell : plan.cells) {
    if (cell == Ground::Wall && chance.happens(holes)) {
      cell = Ground::Free;
    } else if (cell == Ground::Free && chance.happens(dots)) {
      cell = Ground::Wall;
    }
  }
  return plan;
}

/// Two walls 2 m apart, and nothing else.
inline Plan corridor(double length_m) {
  Plan plan;
  plan.width = int(length_m / 0.05);
  plan.height = 44;
  plan.resolution_m = 0.05;
  plan.cells.assign(std::size_t(plan.width) * std::size_t(plan.height), Ground::Free);
  fill(plan, 0, 0, plan.width - 1, 1, Ground::Wall);
  fill(plan, 0, plan.height - 2, plan.width - 1, plan.height - 1, Ground::Wall);
  return plan;
}

/// The same place, mapped from elsewhere with other cells: p' = transform p.
inline Plan mappedAgain(const Plan& plan, const Pose2& transform, double resolution_m) {
  geometry::WorldRect bounds;
  for (const double x : {0.0, double(plan.width)}) {
    for (const double y : {0.0, double(plan.height)}) {
      bounds.extend(transform.apply(plan.corner_m + plan.resolution_m * Eigen::Vector2d(x, y)));
    }
  }
  bounds = bounds.grown(1);
  Plan out;
  out.resolution_m = resolution_m;
  out.corner_m = {bounds.min_x, bounds.min_y};
  out.width = int(bounds.width() / resolution_m);
  out.height = int(bounds.height() / resolution_m);
  out.cells.assign(std::size_t(out.width) * std::size_t(out.height), Ground::Unknown);
  const Pose2 back = transform.inverse();
  const int samples = resolution_m > 1.2 * plan.resolution_m ? 3 : 1;  // along each side of a cell
  for (int row = 0; row < out.height; ++row) {
    for (int column = 0; column < out.width; ++column) {
      for (int sample = 0; sample < samples * samples; ++sample) {
        const Eigen::Vector2d in_cell((sample % samples + 0.5) / samples, (sample / samples + 0.5) / samples);
        const Eigen::Vector2d at = out.corner_m + resolution_m * (Eigen::Vector2d(column, row) + in_cell);
        const Eigen::Vector2d from = (back.apply(at) - plan.corner_m) / plan.resolution_m;
        if (!(from.x() >= 0 && from.y() >= 0 && from.x() < plan.width && from.y() < plan.height)) continue;
        Ground& cell = cellOf(out, column, row);
        cell = std::max(cell, plan.at(int(from.x()), int(from.y())));
      }
    }
  }
  return out;
}

}  // namespace mapwright::testing
