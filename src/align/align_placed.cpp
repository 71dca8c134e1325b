#include "align/align_placed.h"

#include "align/plan_of.h"

namespace mapwright::align {

std::optional<Alignment> alignPlaced(const render::PlacedGrid& old_map, const render::PlacedGrid& new_map,
                                     const Options& options, const std::atomic<bool>* cancelled) {
  const double cell_m = cellsFor(old_map, new_map);
  const auto old_plan = planOf(old_map, cell_m, cancelled);
  if (!old_plan) return std::nullopt;
  const auto new_plan = planOf(new_map, cell_m, cancelled);
  return new_plan ? alignPlans(*old_plan, *new_plan, options) : std::nullopt;
}

}  // namespace mapwright::align
