#include "robot/axbot/map_changes.h"

#include <algorithm>
#include <set>
#include <utility>

#include <QJsonDocument>

#include "robot/axbot/faults.h"
#include "robot/axbot/parse_maps.h"
#include "robot/wire/failures.h"
#include "robot/wire/faults.h"
#include "robot/wire/net_results.h"

namespace mapwright::robot::axbot {
namespace {

const QString kUsedMapPath = QStringLiteral("/chassis/current-map");
const QString kMapsPath = QStringLiteral("/maps/");
const QString kMappingsPath = QStringLiteral("/mappings/");
const QString kRunningPath = QStringLiteral("/mappings/current");

/// carryOut() refuses what has none.
QString pathOfMap(const map::MapKey& key) { return pathOf(kMapsPath, key.id).value_or(QString()); }

bool isOfOne(MapChange change) {
  return change == MapChange::Rename || change == MapChange::Load || change == MapChange::Delete;
}

/// As robots write them; what is none may be another spelling of an id, or a word of the robot.
bool isNumber(const std::string& id) {
  const QString text = QString::fromStdString(id);
  return QString::number(text.toULongLong()) == text;
}

/// Ids are numbers: whoever gets one as text refuses it.
QJsonValue idValue(const std::string& id) {
  const QString text = QString::fromStdString(id);
  return isNumber(id) ? QJsonValue(text.toLongLong()) : QJsonValue(text);
}

}  // namespace

struct MapChanges::Change {
  Task task;
  MapOrder order;
  OutcomeTo<map::CatalogueEntry> reply;
  map::CatalogueEntry before = {};          // of the map that is changed
  std::set<std::string> ids_before = {};    // Save: of the maps
  std::optional<map::MapKey> mapping = {};  // that is ended

  map::Subject subject() const { return map::subjectOf(order.key); }
};

namespace {

/// It is the mapping in progress.
bool runs(const map::CatalogueEntry& entry) {
  return entry.key.kind == map::MapKind::Mapping && entry.state == "running";
}

}  // namespace

void MapChanges::carryOut(const Task& task, const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply) {
  const auto change = std::make_shared<Change>(Change{task, order, std::move(reply)});
  const bool named = order.key.kind == map::MapKind::Stored && isPlainId(order.key.id);
  if (isOfOne(order.change) && !named) {
    return change->reply(fail(map::Failure{.kind = map::FailureKind::Unsupported,
                                           .subject = change->subject(),
                                           .arguments = {"12"},
                                           .asked_for = map::AskedFor::Change,
                                           .reason = map::FailureReason::NoSuchId}));
  }
  const auto known = [this, change](Outcome<map::CatalogueEntry> before) {
    if (!before) {
      before.error().asked_for = map::AskedFor::Change;
      return change->reply(fail(std::move(before.error())));
    }
    change->before = std::move(*before);
    begin(change);
  };
  // Only what is listed: any other word may mean more to the robot.
  if (order.change == MapChange::Delete) {
    maps_.listAll(task, [key = order.key, known](Outcome<std::vector<map::CatalogueEntry>> list) {
      known(wire::entryOf(key, std::move(list)));
    });
  } else if (isOfOne(order.change) && !isNumber(order.key.id)) {
    maps_.describe(task, order.key, known);
  } else {
    begin(change);
  }
}

void MapChanges::begin(const ChangePtr& change) {
  switch (change->order.change) {
    case MapChange::Rename:
      return rename(change);
    case MapChange::Load:
      return load(change);
    case MapChange::Delete:
      return remove(change);
    case MapChange::StartMapping:
      return startMapping(change, false);
    case MapChange::ContinueMapping:
      return startMapping(change, true);
    case MapChange::StopMapping:
      return endMapping(change, QStringLiteral("finished"));
    case MapChange::CancelMapping:
      return endMapping(change, QStringLiteral("cancelled"));
    case MapChange::Save:
      return save(change);
    default:
      change->reply(fail(wire::notOffered(change->subject(), map::AskedFor::Change)));
  }
}

void MapChanges::send(const ChangePtr& change, net::HttpMethod method, const QString& path,
                      const QJsonObject& body, Look look) {
  net::HttpRequest request = server_.request(path);
  request.method = method;
  if (!body.isEmpty()) request.body = QJsonDocument(body).toJson(QJsonDocument::Compact);
  wire::send(change->task, server_.http, request,
             [change, look = std::move(look)](const net::HttpAnswer& answer) {
               std::optional<map::Failure> doubt =
                   answer.ok() ? refusalIn(answer, change->subject())
                               : wire::failed(answer, change->subject(), map::AskedFor::Change);
               if (doubt && (!answer.sent || doubt->kind == map::FailureKind::Cancelled))
                 return change->reply(fail(std::move(*doubt)));
               const bool refused = doubt && doubt->applied == map::Applied::No;
               if (doubt && !refused) doubt->applied = map::Applied::Maybe;
               // Answers to a change depend on the firmware: look again. That may replace a lost answer, and
               // tell of a refusal that it is none. If it is not so yet that proves nothing: the robot may
               // still be working.
               look(change, [change, doubt, refused](Outcome<map::CatalogueEntry> now, bool holds) {
                 if (doubt && (!now || !holds)) return change->reply(fail(*doubt));
                 if (refused && change->order.change == MapChange::Load) {
                   map::Failure unclear = *doubt;  // it may have been the current one before
                   unclear.applied = map::Applied::Maybe;
                   return change->reply(fail(std::move(unclear)));
                 }
                 if (now || now.error().reason == map::FailureReason::Unfit)
                   return change->reply(std::move(now));
                 // It said that it did it; how it is now is what counts, and nobody knows that.
                 now.error().asked_for = map::AskedFor::Change;
                 now.error().applied = map::Applied::Maybe;
                 change->reply(std::move(now));
               });
             });
}

void MapChanges::rename(const ChangePtr& change) {
  send(change, net::HttpMethod::Patch, pathOfMap(change->order.key),
       {{QStringLiteral("map_name"), QString::fromStdString(change->order.name)}},
       [this](const ChangePtr& of, Seen seen) {
         lookAt(of->task, of->order.key, [of, seen = std::move(seen)](Outcome<map::CatalogueEntry> now) {
           const bool holds = now && now->name == of->order.name;
           seen(std::move(now), holds);
         });
       });
}

void MapChanges::load(const ChangePtr& change) {
  send(change, net::HttpMethod::Post, kUsedMapPath,
       {{QStringLiteral("map_id"), idValue(change->order.key.id)}}, [this](const ChangePtr& of, Seen seen) {
         lookAt(of->task, of->order.key, [seen = std::move(seen)](Outcome<map::CatalogueEntry> now) {
           const bool holds = now && now->is_current;
           seen(std::move(now), holds);
         });
       });
}

void MapChanges::remove(const ChangePtr& change) {
  send(
      change, net::HttpMethod::Delete, pathOfMap(change->order.key), {},
      [this](const ChangePtr& of, Seen seen) {
        maps_.listAll(of->task, [of, seen = std::move(seen)](Outcome<std::vector<map::CatalogueEntry>> list) {
          if (!list) return seen(fail(std::move(list.error())), false);
          const bool there = std::any_of(list->begin(), list->end(), [&](const map::CatalogueEntry& entry) {
            return entry.key == of->order.key;
          });
          if (!there) return seen(std::move(of->before), true);
          seen(fail(wire::otherwise(of->subject(), wire::fault::StillListed)), false);
        });
      });
}

MapChanges::Look MapChanges::lookForMapping(bool wanted) {
  return [this, wanted](const ChangePtr& of, Seen seen) {
    maps_.listAll(of->task, [of, wanted,
                             seen = std::move(seen)](Outcome<std::vector<map::CatalogueEntry>> list) {
      if (!list) return seen(fail(std::move(list.error())), false);
      const auto running = std::find_if(list->begin(), list->end(), runs);
      if ((running != list->end()) != wanted)
        return seen(fail(wire::otherwise(of->subject(),
                                         wanted ? wire::fault::NotMapping : wire::fault::StillMapping)),
                    false);
      if (wanted) return seen(std::move(*running), true);
      const auto ended = std::find_if(list->begin(), list->end(), [&](const map::CatalogueEntry& entry) {
        return entry.key == of->mapping;
      });
      if (ended == list->end()) return seen(map::CatalogueEntry(), of->mapping.has_value());
      const bool cancels = of->order.change == MapChange::CancelMapping;
      if (ended->state == (cancels ? "finished" : "cancelled"))
        return seen(
            fail(wire::otherwise(
                of->subject(),
                cancels
                    ? faultText("axbot",
                                "The robot ended mapping, but kept what was mapped: it lists it as finished.")
                    : faultText("axbot", "The robot ended mapping, but lists it as cancelled."))),
            false);
      seen(std::move(*ended), true);
    });
  };
}

void MapChanges::startMapping(const ChangePtr& change, bool continues) {
  // One that was running before would be taken for the new one, and might be lost.
  maps_.listAll(change->task, [this, change, continues](Outcome<std::vector<map::CatalogueEntry>> list) {
    if (!list) {
      list.error().asked_for = map::AskedFor::Change;
      return change->reply(fail(std::move(list.error())));
    }
    if (std::any_of(list->begin(), list->end(), runs))
      return change->reply(fail(wire::otherwise(change->subject(), wire::fault::MapsAlready)));
    send(change, net::HttpMethod::Post, kMappingsPath,
         {{QStringLiteral("continue_mapping"), continues},
          {QStringLiteral("start_pose_type"),
           continues ? QStringLiteral("current_pose") : QStringLiteral("zero")}},
         lookForMapping(true));
  });
}

void MapChanges::endMapping(const ChangePtr& change, const QString& state) {
  maps_.listAll(change->task, [this, change, state](Outcome<std::vector<map::CatalogueEntry>> list) {
    if (!list && list.error().kind == map::FailureKind::Cancelled) {
      list.error().asked_for = map::AskedFor::Change;
      return change->reply(fail(std::move(list.error())));
    }
    if (list) {  // a mapping can be ended without knowing which
      const auto running = std::find_if(list->begin(), list->end(), runs);
      if (running != list->end()) change->mapping = running->key;
    }
    send(change, net::HttpMethod::Patch, kRunningPath, {{QStringLiteral("state"), state}},
         lookForMapping(false));
  });
}

void MapChanges::progress(const Task& task, OutcomeTo<std::optional<MappingProgress>> reply) {
  wire::send(task, server_.http, server_.request(kMappingsPath),
             [this, reply = std::move(reply)](const net::HttpAnswer& answer) {
               auto running = wire::outcomeOf(answer, {map::SubjectKind::Catalogue, map::kMappingsPart},
                                              parseRunningMapping);
               if (!running) return reply(fail(std::move(running.error())));
               if (!*running) return reply(std::nullopt);
               MappingProgress now{(*running)->key, std::nullopt, (*running)->continues};
               const auto clock_s = robot_now_s_();
               if (clock_s && (*running)->started_s && *clock_s >= *(*running)->started_s)
                 now.lasts_s = *clock_s - *(*running)->started_s;
               reply(std::optional(now));
             });
}

/// The result of the latest mapping that was finished.
void MapChanges::save(const ChangePtr& change) {
  maps_.listAll(change->task, [this, change](Outcome<std::vector<map::CatalogueEntry>> list) {
    if (!list) {
      list.error().asked_for = map::AskedFor::Change;
      return change->reply(fail(std::move(list.error())));
    }
    const map::CatalogueEntry* latest = nullptr;
    for (const map::CatalogueEntry& entry : *list) {
      if (entry.key.kind == map::MapKind::Stored) change->ids_before.insert(entry.key.id);
      const bool whole = entry.key.kind == map::MapKind::Mapping && entry.state == "finished";
      const auto end_s = [](const map::CatalogueEntry& one) { return one.modified_s.value_or(0); };
      if (whole && (!latest || end_s(entry) >= end_s(*latest))) latest = &entry;
    }
    if (!latest) {
      return change->reply(fail(
          map::Failure{.kind = map::FailureKind::RejectedByRobot,
                       .subject = change->subject(),
                       .asked_for = map::AskedFor::Change,
                       .reason = map::FailureReason::Unfit,
                       .cause = faultText("axbot", "There is no finished mapping that could be saved.")}));
    }
    saveMapping(change, latest->key.id);
  });
}

void MapChanges::saveMapping(const ChangePtr& change, const std::string& mapping) {
  send(
      change, net::HttpMethod::Post, kMapsPath,
      {{QStringLiteral("map_name"), QString::fromStdString(change->order.name)},
       {QStringLiteral("mapping_id"), idValue(mapping)}},
      [this](const ChangePtr& of, Seen seen) {
        maps_.listAll(of->task, [of, seen = std::move(seen)](Outcome<std::vector<map::CatalogueEntry>> list) {
          if (!list) return seen(fail(std::move(list.error())), false);
          const auto made = std::find_if(list->begin(), list->end(), [&](const map::CatalogueEntry& entry) {
            return entry.key.kind == map::MapKind::Stored && entry.name == of->order.name &&
                   !of->ids_before.contains(entry.key.id);
          });
          if (made != list->end()) return seen(std::move(*made), true);
          seen(fail(wire::otherwise(of->subject(), wire::fault::NotListedYet)), false);
        });
      });
}

void MapChanges::lookAt(const Task& task, const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply) {
  wire::send(task, server_.http, server_.request(kUsedMapPath),
             [this, task, key, reply = std::move(reply)](const net::HttpAnswer& current) {
               const CurrentMap of_robot =
                   current.ok() ? parseCurrentMap(wire::view(current.body)) : CurrentMap();
               maps_.describe(task, key, [of_robot, reply](Outcome<map::CatalogueEntry> now) {
                 if (now) now->is_current = of_robot.is(*now);
                 reply(std::move(now));
               });
             });
}

}  // namespace mapwright::robot::axbot
