#include "ui/maps/align_on_screen.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "align/align_placed.h"
#include "cells/cell_texture.h"
#include "render/compose_grid.h"
#include "render/dense_cache.h"

namespace mapwright::ui {
namespace {

constexpr double kComposePart = 0.2;

/// What submaps are composed in: finer than what maps are aligned in is of no use.
double cellOf(const std::vector<render::PlacedTexture>& submaps) {
  constexpr double kFinest_m = 0.05;
  double finest = std::numeric_limits<double>::infinity();
  for (const render::PlacedTexture& placed : submaps) {
    if (placed.texture->resolutionM() > 0) finest = std::min(finest, placed.texture->resolutionM());
  }
  return std::isfinite(finest) ? std::max(kFinest_m, finest) : kFinest_m;
}

}  // namespace

tl::expected<std::optional<align::Alignment>, Fault> alignOnScreen(
    const render::PlacedGrid& old_map, const OnScreen& new_map, const std::vector<placing::PointPair>& pairs,
    const std::shared_ptr<work::Workers>& workers, const BackgroundRun::Running& run) {
  const auto* const submaps = std::get_if<std::vector<render::PlacedTexture>>(&new_map);
  render::PlacedGrid on;
  if (submaps) {
    render::DenseCache cache;
    const auto composed =
        render::composeGrid(*submaps, cellOf(*submaps), cache,
                            [&](double done) { return run.proceed(done * kComposePart); }, {workers});
    if (!composed) return tl::unexpected(composed.error());
    on = {composed->cells, composed->reference};
  } else {
    on = std::get<render::PlacedGrid>(new_map);
  }
  const double from = submaps ? kComposePart : 0;
  return align::alignPlaced(
      old_map, on, {pairs, workers, [&](double done) { return run.proceed(from + (1 - from) * done); }},
      &run.cancelled);
}

}  // namespace mapwright::ui
