#include "robot/ros/ros_maps.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

#include "grids/thumbnail.h"
#include "robot/ros/faults.h"
#include "robot/ros/map_values.h"
#include "robot/ros/ros_calls.h"
#include "robot/wire/failures.h"
#include "robot/wire/forwarded.h"

namespace mapwright::robot::ros {
namespace {

using Entries = std::vector<map::CatalogueEntry>;
using Projections = std::vector<map::Projection>;

const map::MapKey kLive{map::MapKind::Live, {}};

/// "projected_map_0", whatever its topic is called.
map::MapKey projectedKey(int index) {
  return {map::MapKind::Stored, "projected_map_" + std::to_string(index)};
}

/// With the heights: "projected_map_0: z 0.10 … 1.80 m".
std::string nameOf(const ProjectedPart& projected) {
  char heights[96];
  std::snprintf(heights, sizeof heights, ": z %.2f … %.2f m", projected.min_z_m, projected.max_z_m);
  return projectedKey(projected.index).id + heights;
}

map::CatalogueEntry entryOf(const ProjectedPart& projected) {
  map::CatalogueEntry entry;
  entry.key = projectedKey(projected.index);
  entry.name = nameOf(projected);
  entry.grid = projected.part.grid;
  return entry;
}

/// `in_map`: the pose of its frame in that of the map. It has at least one cell.
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

}  // namespace

std::optional<map::CatalogueEntry> RosMaps::liveEntry() const {
  const std::vector<Source> sources = sourcesFor(map::Stream::WholeMap, of_.sources);
  if (sources.empty()) return std::nullopt;
  map::CatalogueEntry entry;
  entry.key = kLive;
  entry.name = sources.front().topic;
  entry.is_current = true;
  if (of_.live_map.last()) {
    entry.grid = of_.live_map.last()->grid;
    entry.bytes = of_.live_map.last()->png ? of_.live_map.last()->png->size() : 0;
  }
  return entry;
}

std::shared_ptr<const ProjectedPart> RosMaps::findProjected(const map::MapKey& key) const {
  for (const auto& [index, part] : of_.dispatch.projected()) {
    if (projectedKey(index) == key) return part;
  }
  return nullptr;
}

Outcome<map::WholeMap> RosMaps::projectedMap(const ProjectedPart& projected) const {
  map::Failure failure{.kind = map::FailureKind::RejectedByRobot,
                       .subject = map::subjectOf(projectedKey(projected.index)),
                       .reason = map::FailureReason::Empty};
  if (projected.part.grid.width < 1 || projected.part.grid.height < 1) return fail(std::move(failure));
  const std::string& frame = projected.part.frame;
  if (frame.empty() || frame == of_.world.fixedFrame()) return wholeMapOf(projected, Transform3());
  const auto in_map = of_.world.transforms().find(of_.world.fixedFrame(), frame, std::nullopt);
  if (in_map) return wholeMapOf(projected, *in_map);
  failure.reason = map::FailureReason::Unfit;
  failure.cause = reasonOf(in_map.error());
  return fail(std::move(failure));
}

void RosMaps::listKept(const wire::TaskPtr& task, OutcomeTo<Entries> reply) {
  if (of_.kabam.there()) return of_.kabam.list(task, std::move(reply));
  Entries entries;
  if (auto entry = liveEntry()) entries.push_back(std::move(*entry));
  reply(std::move(entries));
}

void RosMaps::list(const wire::TaskPtr& task, OutcomeTo<Entries> reply) {
  const auto with_projected = withValue<Entries>(reply, [this, reply](Entries entries) {
    // Where nothing else is in use, the first projection stands for the map in space.
    const bool none =
        std::none_of(entries.begin(), entries.end(), [](const auto& one) { return one.is_current; });
    for (const auto& [index, part] : of_.dispatch.projected()) entries.push_back(entryOf(*part));
    if (none && !of_.dispatch.projected().empty())
      entries[entries.size() - of_.dispatch.projected().size()].is_current = true;
    // Why one has none is told when it is asked for.
    for (map::CatalogueEntry& entry : entries) entry.has_thumbnail = hasThumbnail(entry.key);
    reply(std::move(entries));
  });
  const auto shown = withValue<Projections>(
      reply, [this, task, with_projected](const Projections&) { listKept(task, with_projected); });
  of_.when_known(task, wire::kMapList, map::AskedFor::All,
                 unlessFailed(reply, [this, task, shown] { of_.dispatch.awaitProjected(task, shown); }));
}

/// A map that is given by region may be gigabytes: people decide about the whole.
bool RosMaps::hasThumbnail(const map::MapKey& key) const {
  return isProjected(key) || of_.live_map.last() ||
         !of_.dispatch.dispatcher().has(DispatchService::GridRegion);
}

void RosMaps::describe(const wire::TaskPtr& task, const map::MapKey& key,
                       OutcomeTo<map::CatalogueEntry> reply) {
  const auto now = [this, task, key, reply] { describeNow(task, key, reply); };
  const auto known = [this, task, key, reply, now] {
    if (!isProjected(key) || findProjected(key)) return now();
    of_.dispatch.awaitProjected(task, withValue<Projections>(reply, [now](const Projections&) { now(); }));
  };
  of_.when_known(task, map::subjectOf(key), map::AskedFor::All, unlessFailed(reply, known));
}

void RosMaps::describeNow(const wire::TaskPtr& task, const map::MapKey& key,
                          OutcomeTo<map::CatalogueEntry> reply) {
  const auto answer = [&](std::optional<map::CatalogueEntry> entry) {
    if (!entry) return reply(fail(wire::notThere(map::subjectOf(key))));
    reply(std::move(*entry));
  };
  if (isProjected(key)) {
    const auto projected = findProjected(key);
    return answer(projected ? std::optional(entryOf(*projected)) : std::nullopt);
  }
  if (key == kLive) return answer(liveEntry());
  if (!of_.kabam.there()) return answer(std::nullopt);
  of_.kabam.describe(task, key, [this, reply](Outcome<map::CatalogueEntry> entry) {
    if (entry && entry->is_current && of_.live_map.last()) entry->grid = of_.live_map.last()->grid;
    reply(std::move(entry));
  });
}

void RosMaps::fetch(const wire::TaskPtr& task, const map::MapKey& key, OutcomeTo<map::WholeMap> reply) {
  describe(
      task, key,
      withValue<map::CatalogueEntry>(reply, [this, task, key, reply](const map::CatalogueEntry& entry) {
        if (const auto projected = findProjected(key)) return reply(projectedMap(*projected));
        if (!entry.is_current)
          return reply(fail(unsupported(map::subjectOf(key), {fault::OnlyCurrentMapSent})));
        if (sourcesFor(map::Stream::WholeMap, of_.sources).empty()) {
          const bool projected = !of_.dispatch.projected().empty();
          return reply(fail(unsupported(
              map::subjectOf(key),
              projected
                  ? Fault(faultText(
                        "ros",
                        "The robot sends no map in the plane, only projections of its 3D map: choose one of "
                        "them (projected_map_0 and so on)."))
                  : Fault())));
        }
        of_.live_map.fetch(task, key, entry.name, reply);
      }));
}

void RosMaps::thumbnail(const wire::TaskPtr& task, const map::MapKey& key, OutcomeTo<std::string> reply) {
  if (!hasThumbnail(key)) {
    map::Failure none = unsupported(map::subjectOf(key), {fault::WholeMapNotFetched});
    none.asked_for = map::AskedFor::SmallPicture;
    return reply(fail(std::move(none)));
  }
  fetch(task, key, [key, reply = std::move(reply)](Outcome<map::WholeMap> whole) {
    const auto picture = whole ? grids::thumbnailOf(*whole) : tl::make_unexpected(Fault());
    if (picture) return reply(*picture);
    map::Failure none = whole ? map::Failure{.kind = map::FailureKind::MalformedAnswer,
                                             .subject = map::subjectOf(key),
                                             .reason = map::FailureReason::Unfit,
                                             .cause = picture.error()}
                              : std::move(whole.error());
    none.asked_for = map::AskedFor::SmallPicture;
    reply(fail(std::move(none)));
  });
}

}  // namespace mapwright::robot::ros
