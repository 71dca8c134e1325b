#include "robot/ros/ros_maps.h"

#include <utility>

#include "robot/ros/faults.h"
#include "robot/ros/kabam_failures.h"
#include "robot/ros/projected_maps.h"
#include "robot/wire/failures.h"
#include "robot/wire/forwarded.h"

namespace mapwright::robot::ros {
namespace {

const map::MapKey kLive{map::MapKind::Live, {}};

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
  const auto index = projectedIndex(key);
  if (!index) return nullptr;
  const auto found = of_.dispatch.projected().find(*index);
  return found == of_.dispatch.projected().end() ? nullptr : found->second;
}

Outcome<map::WholeMap> RosMaps::projectedMap(const ProjectedPart& projected) const {
  const map::MapKey key = projectedKey(projected.index);
  map::Failure failure{.kind = map::FailureKind::RejectedByRobot, .subject = map::subjectOf(key)};
  if (projected.part.grid.width < 1 || projected.part.grid.height < 1) {
    failure.reason = map::FailureReason::Empty;
    return fail(std::move(failure));
  }
  const std::string& frame = projected.part.frame;
  if (frame.empty() || frame == of_.world.fixedFrame()) return wholeMapOf(projected, Transform3());
  const auto in_map = of_.world.transforms().find(of_.world.fixedFrame(), frame, std::nullopt);
  if (in_map) return wholeMapOf(projected, *in_map);
  failure.reason = map::FailureReason::Unfit;
  failure.cause = reasonOf(in_map.error());
  return fail(std::move(failure));
}

void RosMaps::listKept(const wire::TaskPtr& task, OutcomeTo<std::vector<map::CatalogueEntry>> reply) {
  if (of_.kabam.there()) return of_.kabam.list(task, std::move(reply));
  std::vector<map::CatalogueEntry> entries;
  if (auto entry = liveEntry()) entries.push_back(std::move(*entry));
  reply(std::move(entries));
}

void RosMaps::list(const wire::TaskPtr& task, OutcomeTo<std::vector<map::CatalogueEntry>> reply) {
  of_.when_known(task, wire::kMapList, map::AskedFor::All,
                 [this, task, reply = std::move(reply)](std::optional<map::Failure> failure) {
                   if (failure) return reply(fail(std::move(*failure)));
                   of_.dispatch.awaitProjected(
                       task, [this, task, reply](const Outcome<std::vector<map::Projection>>& shown) {
                         if (!shown) return reply(fail(shown.error()));
                         listKept(task, [this, reply](Outcome<std::vector<map::CatalogueEntry>> told) {
                           if (!told) return reply(std::move(told));
                           for (const auto& [index, part] : of_.dispatch.projected())
                             told->push_back(entryOf(*part));
                           reply(std::move(told));
                         });
                       });
                 });
}

void RosMaps::describe(const wire::TaskPtr& task, const map::MapKey& key,
                       OutcomeTo<map::CatalogueEntry> reply) {
  of_.when_known(task, map::subjectOf(key), map::AskedFor::All,
                 [this, task, key, reply = std::move(reply)](std::optional<map::Failure> failure) {
                   if (failure) return reply(fail(std::move(*failure)));
                   if (!projectedIndex(key) || findProjected(key)) return describeNow(task, key, reply);
                   of_.dispatch.awaitProjected(
                       task, [this, task, key, reply](const Outcome<std::vector<map::Projection>>& shown) {
                         if (!shown) return reply(fail(shown.error()));
                         describeNow(task, key, reply);
                       });
                 });
}

void RosMaps::describeNow(const wire::TaskPtr& task, const map::MapKey& key,
                          OutcomeTo<map::CatalogueEntry> reply) {
  if (projectedIndex(key)) {
    const auto projected = findProjected(key);
    return reply(projected ? Outcome<map::CatalogueEntry>(entryOf(*projected))
                           : fail(wire::notThere(map::subjectOf(key))));
  }
  if (key == kLive) {
    auto entry = liveEntry();
    return reply(entry ? Outcome<map::CatalogueEntry>(std::move(*entry))
                       : fail(wire::notThere(map::subjectOf(key))));
  }
  if (!of_.kabam.there()) return reply(fail(wire::notThere(map::subjectOf(key))));
  of_.kabam.describe(task, key, [this, reply](Outcome<map::CatalogueEntry> told) {
    if (told && told->is_current && of_.live_map.last()) told->grid = of_.live_map.last()->grid;
    reply(std::move(told));
  });
}

void RosMaps::fetch(const wire::TaskPtr& task, const map::MapKey& key, OutcomeTo<map::WholeMap> reply) {
  describe(task, key, [this, task, key, reply = std::move(reply)](Outcome<map::CatalogueEntry> entry) {
    if (!entry) return reply(fail(entry.error()));
    if (const auto projected = findProjected(key)) return reply(projectedMap(*projected));
    if (!entry->is_current) return reply(fail(unsupported(map::subjectOf(key), {fault::OnlyCurrentMapSent})));
    if (sourcesFor(map::Stream::WholeMap, of_.sources).empty())
      return reply(fail(unsupported(map::subjectOf(key), {})));
    of_.live_map.fetch(task, key, entry->name, reply);
  });
}

}  // namespace mapwright::robot::ros
