#include "app/waypoint_list.h"

#include <cstdio>

#include <QCoreApplication>

#include "app/exit_code.h"
#include "app/output_paths.h"
#include "exchange/waypoint_steps.h"
#include "sentences/fault_sentence.h"
#include "sentences/subject_name.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

class WaypointListText {
  Q_DECLARE_TR_FUNCTIONS(Waypoints)
};

using words::text;

CommandResult<map::MapKey> mapOf(MapReading& robot, const std::string& id) {
  const map::MapKey named = map::mapKeyFromText(id);
  const auto fail = [&](int code, const QString& sentence) {
    return tl::make_unexpected(robot.failure(code, sentence));
  };
  if (!id.empty() && !robot.local()) {
    if (named.kind == map::MapKind::Stored) return named;
    return fail(kUsage,
                WaypointListText::tr("--map %1: pass the id of a stored map (see mapwright maps list).")
                    .arg(text(id)));
  }
  const auto rows = robot.catalogue();
  if (!rows) return tl::make_unexpected(rows.error());
  const session::Catalogue& catalogue = robot.session().catalogue();
  const map::CatalogueEntry* entry = id.empty() ? catalogue.current() : catalogue.called(id);
  if (!entry && id.empty() && (*rows)->size() == 1) entry = &(*rows)->front();
  if (entry) return entry->key;
  if (!id.empty())
    return fail(kUsage, WaypointListText::tr("There is no map %1 (see mapwright maps list).").arg(text(id)));
  return (*rows)->empty()
             ? fail(kRobotError, WaypointListText::tr("There are no maps."))
             : fail(kRobotError,
                    WaypointListText::tr(
                        "None of its maps is the current one. Pass --map ID (see mapwright maps list)."));
}

tl::expected<robot::StoredWaypoints, map::Failure> readAll(ListedWaypoints& list,
                                                           robot::WaypointSource* source) {
  if (list.store) {
    return list.robot->ask<robot::StoredWaypoints>([&](robot::OutcomeTo<robot::StoredWaypoints> reply) {
      return list.store->read(list.map, std::move(reply));
    });
  }
  auto told = list.robot->ask<map::WaypointList>([&](robot::OutcomeTo<map::WaypointList> reply) {
    return source->waypoints(list.map, std::move(reply));
  });
  if (!told) return tl::make_unexpected(std::move(told.error()));
  robot::StoredWaypoints stored;
  stored.points = std::move(told->points);
  stored.notes = std::move(told->notes);
  return stored;
}

QString someIds(const std::vector<const map::Waypoint*>& points) {
  constexpr std::size_t kMost = 10;
  QStringList ids;
  for (std::size_t i = 0; i < points.size() && i < kMost; ++i) ids << words::plainName(points[i]->id);
  if (points.size() > kMost) ids << QStringLiteral("…");
  return ids.join(QStringLiteral(", "));
}

QString nameLeft(const exchange::TemporaryName& left) {
  const QString name = words::plainName(left.name), permanent = words::plainName(left.permanent);
  return left.is_free ? WaypointListText::tr(
                            "\"%1\" looks like a temporary name left by an interrupted swap of names. It was "
                            "called \"%2\" before. Apply the plan again, or rename it.")
                            .arg(name, permanent)
                      : WaypointListText::tr(
                            "\"%1\" looks like a temporary name left by an interrupted swap of names. "
                            "Another waypoint is called \"%2\" now. Apply the plan again, or rename it.")
                            .arg(name, permanent);
}

}  // namespace

std::vector<exchange::WaypointEdit> fitted(const ListedWaypoints& list,
                                           std::vector<exchange::WaypointEdit> edits) {
  exchange::FittedEdits fitted = exchange::fitted(std::move(edits), list.store->keeps());
  if (!fitted.notes.isEmpty()) list.robot->note(fitted.notes.join(QLatin1Char(' ')));
  return std::move(fitted.edits);
}

CommandFailure ListedWaypoints::failure(const map::Failure& failed) const {
  CommandFailure failure = robot->failure(failed);
  // Files do not answer: they cannot be read or written.
  if (robot->local() && failed.kind != map::FailureKind::Conflict &&
      failed.kind != map::FailureKind::TimedOut)
    failure.exit_code = kUsage;
  return failure;
}

CommandResult<ListedWaypoints> listWaypoints(MapsCommand& command, const WaypointsWords& words,
                                             const std::string& map, Use use) {
  const auto access = RobotAccess::read(words.access, text(words.robot));
  if (!access) return tl::make_unexpected(CommandFailure{kUsage, access.error()});
  const QString address = text(words.robot);
  auto opened = command.open(address, access->forAddress(address), MapReading::Purpose::Maps);
  if (!opened) return tl::make_unexpected(opened.error());
  MapReading& reading = **opened;
  robot::Robot& robot = reading.session().robot();
  ListedWaypoints list{&reading, {}};
  list.store = robot.waypointStore();
  if (!list.store && use == Use::Changing)
    return tl::make_unexpected(reading.lacks(robot::Capability::WaypointEditing));
  if (!list.store && !robot.waypointSource())
    return tl::make_unexpected(reading.lacks(robot::Capability::Waypoints));
  const auto key = mapOf(reading, map);
  if (!key) return tl::make_unexpected(key.error());
  list.map = *key;
  auto stored = readAll(list, robot.waypointSource());
  if (!stored) return tl::make_unexpected(list.failure(stored.error()));
  list.stored = std::move(*stored);
  for (const Fault& note : list.stored.notes)
    reading.note(QStringLiteral("%1: %2").arg(sentences::nameOf(map::placesOf(list.map)),
                                              sentences::sentenceOf(note)));
  if (use == Use::Reading) {
    for (const auto& left : exchange::temporaryNamesIn(exchange::itemsOf(list.stored.points)))
      reading.note(nameLeft(left));
  }
  return list;
}

CommandResult<const map::Waypoint*> chosen(const ListedWaypoints& list, const std::string& word) {
  std::vector<const map::Waypoint*> called, shown_so;
  const QString shown = words::plainName(word);
  for (const map::Waypoint& point : list.stored.points) {
    if (point.id == word) return &point;
    if (point.name == word) called.push_back(&point);
    if (words::plainName(point.name) == shown) shown_so.push_back(&point);
  }
  if (called.empty()) called = std::move(shown_so);
  if (called.size() == 1) return called.front();
  if (called.empty())
    return tl::make_unexpected(list.robot->failure(
        kRobotError,
        WaypointListText::tr("There is no waypoint %1 (see mapwright waypoints list).").arg(shown)));
  return tl::make_unexpected(
      list.robot->failure(kUsage, WaypointListText::tr("Several waypoints are called \"%1\". Pass an id: %2.")
                                      .arg(shown, someIds(called))));
}

int runWaypointsCommand(const WaypointsWords& words, int& argc, char** argv,
                        const std::function<CommandResult<int>(MapsCommand&)>& work) {
  return MapsCommand(words.timeout_s, text(words.report)).run(argc, argv, work);
}

}  // namespace mapwright::app
