// RosLink: outgoing requests.
#include <algorithm>
#include <utility>

#include "robot/ros/faults.h"
#include "robot/ros/projected_maps.h"
#include "robot/ros/ros_link.h"

namespace mapwright::robot::ros {
namespace {

using MaybeFailure = std::optional<map::Failure>;

const map::MapKey kLive{map::MapKind::Live, {}};
const map::Subject kDispatcher{std::string("map dispatcher (REP 130)")};

map::Failure notThere(const map::MapKey& key) {
  return {.kind = map::FailureKind::RejectedByRobot,
          .subject = map::subjectOf(key),
          .reason = map::FailureReason::NotThere};
}

map::Failure unsupported(map::Subject subject, Fault cause) {
  map::Failure failure;
  failure.kind = map::FailureKind::Unsupported;
  failure.subject = std::move(subject);
  failure.reason = cause.any() ? map::FailureReason::Unfit : map::FailureReason::NotOffered;
  failure.cause = std::move(cause);
  return failure;
}

}  // namespace

void RosLink::endEarly(const EarlyPtr& early, std::optional<map::FailureKind> kind) {
  const auto found = std::find(early_.begin(), early_.end(), early);
  if (found == early_.end()) return;
  early_.erase(found);
  early->errand->ended(early->number);
  if (!kind) return early->then(std::nullopt);
  map::Failure failure;
  failure.kind = *kind;
  if (*kind != map::FailureKind::Cancelled) failure.cause = {fault::NotConnected};
  early->then(std::move(failure));
}

void RosLink::whenKnown(const wire::ErrandPtr& errand, map::Subject subject, map::AskedFor asked_for,
                        std::function<void(MaybeFailure)> then) {
  if (known_) return then(std::nullopt);
  const auto early = std::make_shared<Early>();
  early->errand = errand;
  early->then = [subject = std::move(subject), asked_for, then = std::move(then)](MaybeFailure failure) {
    if (failure) {
      failure->subject = subject;
      failure->asked_for = asked_for;
    }
    then(std::move(failure));
  };
  early_.push_back(early);
  using State = net::WebSocketLink::State;
  const bool coming =
      client_ && !awaits_manager_ && (open_() || client_->link().state() == State::Connecting);
  if (!coming) return endEarly(early, map::FailureKind::Unreachable);
  early->number = errand->begun([this, held = std::weak_ptr(early)] {
    QMetaObject::invokeMethod(
        this,
        [this, held] {
          if (const EarlyPtr now = held.lock()) endEarly(now, map::FailureKind::Cancelled);
        },
        Qt::QueuedConnection);
  });
}

std::optional<map::CatalogueEntry> RosLink::liveEntry() const {
  const std::vector<Source> sources = sourcesFor(map::Stream::WholeMap, sources_);
  if (sources.empty()) return std::nullopt;
  map::CatalogueEntry entry;
  entry.key = kLive;
  entry.name = sources.front().topic;
  entry.is_current = true;
  if (live_map_->last()) {
    entry.grid = live_map_->last()->grid;
    entry.bytes = live_map_->last()->png ? live_map_->last()->png->size() : 0;
  }
  return entry;
}

std::shared_ptr<const ProjectedPart> RosLink::findProjected(const map::MapKey& key) const {
  const auto index = projectedIndex(key);
  if (!index) return nullptr;
  const auto found = dispatch_->projected().find(*index);
  return found == dispatch_->projected().end() ? nullptr : found->second;
}

void RosLink::addProjected(std::vector<map::CatalogueEntry>& entries) const {
  for (const auto& [index, part] : dispatch_->projected()) entries.push_back(entryOf(*part));
}

Outcome<map::WholeMap> RosLink::projectedMap(const ProjectedPart& projected) const {
  const map::MapKey key = projectedKey(projected.index);
  map::Failure failure{.kind = map::FailureKind::RejectedByRobot, .subject = map::subjectOf(key)};
  if (projected.part.grid.width < 1 || projected.part.grid.height < 1) {
    failure.reason = map::FailureReason::Empty;
    return fail(std::move(failure));
  }
  const std::string& frame = projected.part.frame;
  if (frame.empty() || frame == world_.fixedFrame()) return wholeMapOf(projected, Transform3());
  const auto in_map = world_.transforms().find(world_.fixedFrame(), frame, std::nullopt);
  if (in_map) return wholeMapOf(projected, *in_map);
  failure.reason = map::FailureReason::Unfit;
  failure.cause = reasonOf(in_map.error());
  return fail(std::move(failure));
}

void RosLink::listKept(const wire::ErrandPtr& errand, OutcomeTo<std::vector<map::CatalogueEntry>> reply) {
  if (has_manager_) return kabam_->list(errand, std::move(reply));
  std::vector<map::CatalogueEntry> entries;
  if (auto entry = liveEntry()) entries.push_back(std::move(*entry));
  reply(std::move(entries));
}

void RosLink::list(const wire::ErrandPtr& errand, OutcomeTo<std::vector<map::CatalogueEntry>> reply) {
  whenKnown(errand, {map::SubjectKind::Catalogue, map::kMapsPart}, map::AskedFor::All,
            [this, errand, reply = std::move(reply)](MaybeFailure failure) {
              if (failure) return reply(fail(std::move(*failure)));
              dispatch_->awaitProjected(
                  errand, [this, errand, reply](const Outcome<std::vector<map::Projection>>& shown) {
                    if (!shown) return reply(fail(shown.error()));
                    listKept(errand, [this, reply](Outcome<std::vector<map::CatalogueEntry>> told) {
                      if (told) addProjected(*told);
                      reply(std::move(told));
                    });
                  });
            });
}

void RosLink::describe(const wire::ErrandPtr& errand, const map::MapKey& key,
                       OutcomeTo<map::CatalogueEntry> reply) {
  whenKnown(errand, map::subjectOf(key), map::AskedFor::All,
            [this, errand, key, reply = std::move(reply)](MaybeFailure failure) {
              if (failure) return reply(fail(std::move(*failure)));
              auto entry = key == kLive ? liveEntry() : std::nullopt;
              if (entry) return reply(std::move(*entry));
              if (projectedIndex(key) && !findProjected(key)) {
                return dispatch_->awaitProjected(
                    errand, [this, key, reply](const Outcome<std::vector<map::Projection>>& shown) {
                      if (!shown) return reply(fail(shown.error()));
                      const auto projected = findProjected(key);
                      if (!projected) return reply(fail(notThere(key)));
                      reply(entryOf(*projected));
                    });
              }
              if (const auto projected = findProjected(key)) return reply(entryOf(*projected));
              if (!has_manager_ || key == kLive) return reply(fail(notThere(key)));
              kabam_->describe(errand, key, [this, reply](Outcome<map::CatalogueEntry> told) {
                if (told && told->is_current && live_map_->last()) told->grid = live_map_->last()->grid;
                reply(std::move(told));
              });
            });
}

void RosLink::fetch(const wire::ErrandPtr& errand, const map::MapKey& key, OutcomeTo<map::WholeMap> reply) {
  describe(errand, key, [this, errand, key, reply = std::move(reply)](Outcome<map::CatalogueEntry> entry) {
    if (!entry) return reply(fail(entry.error()));
    if (const auto projected = findProjected(key)) return reply(projectedMap(*projected));
    if (!entry->is_current) return reply(fail(unsupported(map::subjectOf(key), {fault::OnlyCurrentMapSent})));
    if (sourcesFor(map::Stream::WholeMap, sources_).empty())
      return reply(fail(unsupported(map::subjectOf(key), {})));
    live_map_->fetch(errand, key, entry->name, reply);
  });
}

void RosLink::waypoints(const wire::ErrandPtr& errand, const map::MapKey& key,
                        OutcomeTo<StoredWaypoints> reply) {
  whenKnown(errand, map::placesOf(key), map::AskedFor::All,
            [this, errand, key, reply = std::move(reply)](MaybeFailure failure) {
              if (failure) return reply(fail(std::move(*failure)));
              if (!has_manager_) return reply(fail(unsupported(map::placesOf(key), {})));
              kabam_->waypoints(errand, key, reply);
            });
}

void RosLink::perform(const wire::ErrandPtr& errand, const map::MapKey& key, const WaypointRequest& request,
                      OutcomeTo<WaypointReceipt> reply) {
  whenKnown(errand, map::placesOf(key), map::AskedFor::Change,
            [this, errand, key, request, reply = std::move(reply)](MaybeFailure failure) {
              if (failure) return reply(fail(std::move(*failure)));
              if (!has_manager_) return reply(fail(unsupported(map::placesOf(key), {})));
              kabam_->perform(errand, key, request, reply);
            });
}

void RosLink::carryOut(const wire::ErrandPtr& errand, const MapOrder& order,
                       OutcomeTo<map::CatalogueEntry> reply) {
  const map::Subject subject = order.key.id.empty()
                                   ? map::Subject(map::SubjectKind::Catalogue, map::kMapsPart)
                                   : map::subjectOf(order.key);
  whenKnown(errand, subject, map::AskedFor::Change,
            [this, errand, order, subject, reply = std::move(reply)](MaybeFailure failure) {
              if (failure) return reply(fail(std::move(*failure)));
              if (!has_manager_) return reply(fail(unsupported(subject, {})));
              kabam_->carryOut(errand, order, reply);
            });
}

void RosLink::dispatchGrid(const wire::ErrandPtr& errand, const std::optional<map::GridRegion>& region,
                           OutcomeTo<map::GridPart> reply) {
  whenKnown(errand, kDispatcher, map::AskedFor::All,
            [this, errand, region, reply = std::move(reply)](MaybeFailure failure) {
              if (failure) return reply(fail(std::move(*failure)));
              dispatch_->grid(errand, region, reply);
            });
}

void RosLink::dispatchCloud(const wire::ErrandPtr& errand, CloudKind kind,
                            const std::optional<map::CloudRegion>& region,
                            OutcomeTo<std::shared_ptr<const map::SpatialCloud>> reply) {
  whenKnown(errand, kDispatcher, map::AskedFor::All,
            [this, errand, kind, region, reply = std::move(reply)](MaybeFailure failure) {
              if (failure) return reply(fail(std::move(*failure)));
              dispatch_->cloud(errand, kind, region, reply);
            });
}

void RosLink::dispatchSave(const wire::ErrandPtr& errand, const std::string& filename,
                           OutcomeTo<std::string> reply) {
  whenKnown(errand, kDispatcher, map::AskedFor::Change,
            [this, errand, filename, reply = std::move(reply)](MaybeFailure failure) {
              if (failure) return reply(fail(std::move(*failure)));
              dispatch_->save(errand, filename, reply);
            });
}

void RosLink::dispatchProjections(const wire::ErrandPtr& errand,
                                  OutcomeTo<std::vector<map::Projection>> reply) {
  whenKnown(errand, kDispatcher, map::AskedFor::All,
            [this, errand, reply = std::move(reply)](MaybeFailure failure) {
              if (failure) return reply(fail(std::move(*failure)));
              dispatch_->projections(errand, reply);
            });
}

void RosLink::dispatchProject(const wire::ErrandPtr& errand, const std::vector<map::Projection>& wanted,
                              OutcomeTo<std::vector<map::Projection>> reply) {
  whenKnown(errand, kDispatcher, map::AskedFor::Change,
            [this, errand, wanted, reply = std::move(reply)](MaybeFailure failure) {
              if (failure) return reply(fail(std::move(*failure)));
              dispatch_->project(errand, wanted, reply);
            });
}

void RosLink::writePicture(const wire::ErrandPtr& errand, const PictureChange& change,
                           OutcomeTo<PictureReceipt> reply) {
  const map::Subject subject = map::subjectOf(change.map);
  whenKnown(errand, subject, map::AskedFor::Change,
            [this, errand, change, subject, reply = std::move(reply)](MaybeFailure failure) {
              if (failure) return reply(fail(std::move(*failure)));
              if (!has_manager_) return reply(fail(unsupported(subject, {})));
              pictures_->write(errand, change, reply);
            });
}

}  // namespace mapwright::robot::ros
