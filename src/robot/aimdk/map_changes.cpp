#include "robot/aimdk/map_changes.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "robot/aimdk/aimdk_link.h"
#include "robot/aimdk/faults.h"
#include "robot/wire/failures.h"
#include "robot/wire/faults.h"
#include "robot/wire/forwarded.h"
#include "robot/wire/net_results.h"

namespace mapwright::robot::aimdk {
namespace {

using std::chrono::steady_clock;

struct MapCall {
  const char* method;
  const char* command;
};

std::optional<MapCall> callOf(MapChange change) {
  switch (change) {
    case MapChange::Rename:
      return MapCall{"RenameMap", "MappingCommand_RENAME_MAP"};
    case MapChange::Load:
      return MapCall{"SetCurrentWorkingMap", "MappingCommand_SET_CURRENT_WORKING_MAP"};
    case MapChange::Delete:
      return MapCall{"DeleteMap", "MappingCommand_DELETE_MAP"};
    case MapChange::StartMapping:
      return MapCall{"StartMapping", "MappingCommand_START_MAPPING"};
    case MapChange::CancelMapping:
      return MapCall{"StopMapping", "MappingCommand_STOP_MAPPING"};
    case MapChange::Save:
      return MapCall{"StopMapping", "MappingCommand_SAVING_MAP"};
    case MapChange::StopMapping:  // would lose what was mapped
    case MapChange::ContinueMapping:
    case MapChange::Archive:
    case MapChange::Unarchive:
      break;
  }
  return std::nullopt;
}

}  // namespace

struct MapChanges::Change {
  wire::TaskPtr task;
  MapOrder order;
  OutcomeTo<map::CatalogueEntry> reply;
  std::vector<map::CatalogueEntry> before = {};
  steady_clock::time_point until = {};
  std::optional<map::Failure> doubt = {};  // the failure, unless the change shows

  map::Subject subject() const {
    return isOfMapping(order.change) ? wire::kMapList : map::subjectOf(order.key);
  }
  static const map::CatalogueEntry* find(const std::vector<map::CatalogueEntry>& maps,
                                         const map::MapKey& key) {
    const auto found = std::find_if(maps.begin(), maps.end(),
                                    [&](const map::CatalogueEntry& entry) { return entry.key == key; });
    return found == maps.end() ? nullptr : &*found;
  }
  void fail(map::Failure failure) const {
    failure.asked_for = map::AskedFor::Change;
    reply(robot::fail(std::move(failure)));
  }
  QByteArray request() const {
    std::vector<std::pair<const char*, std::string>> texts;
    if (!isOfMapping(order.change)) texts.emplace_back("map_id", order.key.id);
    if (order.change == MapChange::Save) texts.emplace_back("map_name", order.name);
    if (order.change == MapChange::Rename) {
      texts.emplace_back("old_name", find(before, order.key)->name);
      texts.emplace_back("new_name", order.name);
    }
    return changeRequest(callOf(order.change)->command, texts);
  }
};

void MapChanges::carryOut(const wire::TaskPtr& task, const MapOrder& order,
                          OutcomeTo<map::CatalogueEntry> reply) {
  const auto change = std::make_shared<Change>(Change{task, order, std::move(reply)});
  if (!callOf(order.change)) return change->fail(wire::notOffered(change->subject()));
  // How it was before: the name that is changed, which ids are not new, and a mapping that must not be lost.
  link_.list(task, [this, change](Outcome<std::vector<map::CatalogueEntry>> maps) {
    if (!maps) {
      maps.error().subject = change->subject();
      return change->fail(std::move(maps.error()));
    }
    change->before = std::move(*maps);
    if (!isOfMapping(change->order.change)) {
      const bool there = Change::find(change->before, change->order.key) != nullptr;
      return there ? send(change) : change->fail(wire::notThere(change->subject()));
    }
    link_.lookAtMapping(change->task, [this, change](Outcome<bool> mapping) {
      if (!mapping) return change->fail(std::move(mapping.error()));
      const bool starts = change->order.change == MapChange::StartMapping;
      if (*mapping != starts) return send(change);
      change->fail(wire::otherwise(change->subject(), starts ? wire::fault::MapsAlready : fault::MapsNotNow));
    });
  });
}

void MapChanges::send(const ChangePtr& change) {
  const std::string method =
      std::string("aimdk.protocol.MappingService/") + callOf(change->order.change)->method;
  link_.post(change->task, method.c_str(), change->request(), [this, change](const net::HttpAnswer& answer) {
    change->doubt = notAccepted(answer, change->subject());
    const bool is_final = change->doubt && isFinal(*change->doubt);
    if (is_final && change->doubt->kind != map::FailureKind::RejectedByRobot)
      return change->fail(std::move(*change->doubt));
    // What was refused is looked at once: some do it all the same.
    change->until = is_final ? steady_clock::now() : steady_clock::now() + times_.confirm;
    look(change);
  });
}

void MapChanges::look(const ChangePtr& change) {
  using Maps = std::vector<map::CatalogueEntry>;
  const MapChange what = change->order.change;
  const bool of_state = what == MapChange::StartMapping || what == MapChange::CancelMapping;
  const auto lookAtMaps = [this, change, what, of_state](bool holds) {
    link_.list(change->task, [this, change, what, of_state, holds](const Outcome<Maps>& maps) {
      if (!maps) return endOrRetry(change, fail(maps.error()), false);
      const auto current = std::find_if(maps->begin(), maps->end(),
                                        [](const map::CatalogueEntry& entry) { return entry.is_current; });
      const auto made = std::find_if(maps->begin(), maps->end(), [&](const map::CatalogueEntry& entry) {
        return !Change::find(change->before, entry.key);
      });
      const map::CatalogueEntry* const map = Change::find(*maps, change->order.key);
      if (of_state)
        return endOrRetry(
            change, current == maps->end() ? map::CatalogueEntry() : map::CatalogueEntry(*current), holds);
      if (what == MapChange::Save)
        return endOrRetry(change, made == maps->end() ? map::CatalogueEntry() : map::CatalogueEntry(*made),
                          made != maps->end());
      if (what == MapChange::Delete)
        return endOrRetry(change, *Change::find(change->before, change->order.key), !map);
      if (!map) return endOrRetry(change, fail(wire::notThere(change->subject())), false);
      endOrRetry(change, *map, what == MapChange::Rename ? map->name == change->order.name : map->is_current);
    });
  };
  if (!isOfMapping(what)) return lookAtMaps(false);
  // The only thing that tells is one of the newer services itself.
  link_.lookAtMapping(change->task, [this, change, what, lookAtMaps](Outcome<bool> mapping) {
    if (!mapping) return endOrRetry(change, fail(std::move(mapping.error())), false);
    lookAtMaps(*mapping == (what == MapChange::StartMapping));
  });
}

void MapChanges::endOrRetry(const ChangePtr& change, Outcome<map::CatalogueEntry> now, bool holds) {
  if (now && holds) return change->reply(std::move(now));
  const bool cancelled = !now && now.error().kind == map::FailureKind::Cancelled;
  if (steady_clock::now() < change->until && !cancelled) {
    return waits_.await(
        change->task, times_.look_again, [] { return false; },
        [this, change](wire::WaitList::End how) {
          if (how != wire::WaitList::End::Cancelled) return look(change);
          change->fail({.kind = map::FailureKind::Cancelled,
                        .subject = change->subject(),
                        .applied = map::Applied::Maybe});
        });
  }
  if (change->doubt) return change->fail(std::move(*change->doubt));
  if (!now) {
    // It said that it did it; how it is now is what counts, and nobody knows that.
    now.error().applied = map::Applied::Maybe;
    return change->fail(std::move(now.error()));
  }
  switch (change->order.change) {
    case MapChange::StartMapping:
      return change->fail(wire::otherwise(change->subject(), wire::fault::NotMapping));
    case MapChange::CancelMapping:
      return change->fail(wire::otherwise(change->subject(), wire::fault::StillMapping));
    case MapChange::Save:
      return change->fail(wire::otherwise(change->subject(), wire::fault::NotListedYet));
    case MapChange::Delete:
      return change->fail(wire::otherwise(change->subject(), wire::fault::StillListed));
    default:
      return change->reply(std::move(now));  // whoever asked sees what it is like
  }
}

}  // namespace mapwright::robot::aimdk
