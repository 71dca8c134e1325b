// Comparing two whole maps cell by cell on the grid of the first.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <QString>
#include <tl/expected.hpp>

#include "render/sample_grid.h"

namespace mapwright::app {

/// Cells of the first map's grid, extended so that the second is inside too.
struct MapDiff {
  int width = 0, height = 0;
  double cell_area_m2 = 0;
  std::array<std::int64_t, render::kDifferences> cells{};  // by render::Difference
  std::int64_t levels_differ =
      0;  // alike by class, but not of the same value (only where the codes are alike)
  bool same() const;
};

/// The difference picture (as on screen) goes to `picture_path` unless empty. The error is a sentence.
tl::expected<MapDiff, QString> diffMaps(const render::PlacedGrid& first, const render::PlacedGrid& second,
                                        const QString& picture_path);

}  // namespace mapwright::app
