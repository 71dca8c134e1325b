// Comparing two whole maps cell by cell on the grid of the first.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <QString>
#include <tl/expected.hpp>

#include "render/sample_grid.h"

namespace mapwright::app {

/// The cells of the first map's grid, extended to contain the second map.
struct MapDiff {
  int width = 0, height = 0;
  double cell_area_m2 = 0;
  std::array<std::int64_t, render::kDifferences> cells{};  // by render::Difference
  std::int64_t levels_differ = 0;  // same class but another value (only if the codes are comparable)
  bool same() const;
};

/// Writes the difference picture (as on screen) to `picture_path` unless that is empty. The error is a
/// sentence.
tl::expected<MapDiff, QString> diffMaps(const render::PlacedGrid& first, const render::PlacedGrid& second,
                                        const QString& picture_path);

}  // namespace mapwright::app
