#include "ui/scene/submap_classes.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <limits>

#include "map/submap_version.h"

namespace mapwright::ui::scene {

using render::kClasses;

int trajectoryClass(std::int32_t trajectory) { return ((trajectory % kClasses) + kClasses) % kClasses; }

int ageClass(std::int32_t index, std::int32_t newest_index) {
  return std::max(index, 0) >> ageShift(std::max(index, newest_index));
}

int ageShift(std::int32_t newest_index) {
  const int bits = int(std::bit_width(unsigned(std::max(newest_index, 0))));
  return std::max(0, bits - int(std::bit_width(unsigned(kClasses - 1))));
}

int versionClass(std::int32_t version) {
  if (version < 0) return render::kUnknownVersion;
  return std::min(kClasses - 1, int(std::bit_width(unsigned(version) / kFirstVersionStep)));
}

render::PixelClasses classesOf(const submap::SubmapStore& submaps, map::SubmapId id) {
  const submap::SubmapRow* const row = submaps.find(id);
  // A picture without a version is kept as version 0.
  const bool known = row && (row->shown_version > 0 || row->entry.version != map::kNoVersion);
  return {trajectoryClass(id.trajectory), ageClass(id.index, newestIndex(submaps, id.trajectory)),
          versionClass(known ? row->shown_version : map::kNoVersion)};
}

std::int32_t newestIndex(const submap::SubmapStore& submaps, std::int32_t trajectory) {
  constexpr auto kLast = std::numeric_limits<std::int32_t>::max();
  const auto after = submaps.rows().upper_bound({trajectory, kLast});
  if (after == submaps.rows().begin()) return -1;
  const map::SubmapId last = std::prev(after)->first;
  return last.trajectory == trajectory ? last.index : -1;
}

std::set<std::int32_t> trajectoriesOf(const submap::SubmapStore& submaps) {
  constexpr auto kLast = std::numeric_limits<std::int32_t>::max();
  std::set<std::int32_t> found;
  for (auto at = submaps.rows().begin(); at != submaps.rows().end();
       at = submaps.rows().upper_bound({at->first.trajectory, kLast})) {
    found.insert(at->first.trajectory);
  }
  return found;
}

}  // namespace mapwright::ui::scene
