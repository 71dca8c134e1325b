#include "robot/ros/projected_maps.h"

#include <charconv>
#include <cstdio>
#include <memory>
#include <string_view>
#include <utility>

#include "robot/ros/map_values.h"

namespace mapwright::robot::ros {
namespace {

constexpr std::string_view kStem = "projected_map_";

std::string nameOf(const ProjectedPart& projected) {
  char heights[96];
  std::snprintf(heights, sizeof heights, ": z %.2f … %.2f m", projected.min_z_m, projected.max_z_m);
  return projectedKey(projected.index).id + heights;
}

}  // namespace

map::MapKey projectedKey(int index) {
  return {map::MapKind::Stored, std::string(kStem) + std::to_string(index)};
}

std::optional<int> projectedIndex(const map::MapKey& key) {
  if (key.kind != map::MapKind::Stored || !key.id.starts_with(kStem)) return std::nullopt;
  const std::string_view digits = std::string_view(key.id).substr(kStem.size());
  int index = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
  if (error != std::errc() || end != digits.data() + digits.size() || projectedKey(index) != key)
    return std::nullopt;
  return index;
}

map::CatalogueEntry entryOf(const ProjectedPart& projected) {
  map::CatalogueEntry entry;
  entry.key = projectedKey(projected.index);
  entry.name = nameOf(projected);
  entry.grid = projected.part.grid;
  return entry;
}

map::WholeMap wholeMapOf(const ProjectedPart& projected, const Transform3& in_map) {
  const map::GridPart& part = projected.part;
  Grid grid;
  grid.width = part.grid.width;
  grid.height = part.grid.height;
  if (part.cells) grid.cells = *part.cells;
  map::WholeMap whole;
  whole.key = projectedKey(projected.index);
  whole.name = nameOf(projected);
  whole.grid = part.grid;
  whole.grid.origin = in_map.flat() * part.grid.origin;
  whole.reading = kPgmReading;
  whole.bytes = std::make_shared<const std::string>(pgmOf(grid));
  whole.body_bytes = whole.bytes->size();
  return whole;
}

}  // namespace mapwright::robot::ros
