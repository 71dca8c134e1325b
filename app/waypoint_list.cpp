#include "app/waypoint_list.h"

#include <chrono>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include <QFileInfo>
#include <QJsonObject>

#include "app/command_map.h"
#include "app/command_text.h"
#include "app/output.h"
#include "disk/read_file.h"
#include "exchange/waypoint_file.h"
#include "exchange/waypoint_json.h"
#include "sentences/fault_sentence.h"
#include "sentences/placing_sentence.h"
#include "sentences/problem_sentence.h"
#include "sentences/subject_name.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

using words::text;

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
  return words::listed(ids);
}

QString nameLeft(const exchange::TemporaryName& left) {
  const QString name = words::plainName(left.name), permanent = words::plainName(left.permanent);
  return left.is_free ? Text::tr(
                            "\"%1\" looks like a temporary name left by an interrupted swap of names. It was "
                            "called \"%2\" before. Apply the plan again, or rename it.")
                            .arg(name, permanent)
                      : Text::tr(
                            "\"%1\" looks like a temporary name left by an interrupted swap of names. "
                            "Another waypoint is called \"%2\" now. Apply the plan again, or rename it.")
                            .arg(name, permanent);
}

std::optional<WaypointFileKind> kindCalled(const QString& word) {
  if (word == QLatin1String("csv")) return WaypointFileKind::Csv;
  if (word == QLatin1String("geojson") || word == QLatin1String("json")) return WaypointFileKind::GeoJson;
  return std::nullopt;
}

constexpr std::pair<placing::WarningKind, const char*> kWarningWords[] = {
    {placing::WarningKind::InWall, "in_wall"},       {placing::WarningKind::OutsideMap, "outside_map"},
    {placing::WarningKind::NearWall, "near_wall"},   {placing::WarningKind::OnUnknown, "on_unknown"},
    {placing::WarningKind::NameTwice, "name_twice"}, {placing::WarningKind::TemporaryName, "temporary_name"},
    {placing::WarningKind::ZeroTurn, "zero_turn"}};

QString stableWordOf(placing::WarningKind kind) {
  for (const auto& [one, word] : kWarningWords) {
    if (one == kind) return QLatin1String(word);
  }
  return {};
}

QJsonArray doubtsJson(const DoubtsAhead& doubts) {
  QJsonArray rows;
  for (const DoubtAhead& one : doubts) {
    rows << QJsonObject{
        {QStringLiteral("id"), one.id.empty() ? QJsonValue() : QJsonValue(QString::fromStdString(one.id))},
        {QStringLiteral("name"), QString::fromStdString(one.name)},
        {QStringLiteral("warnings"), warningsJson(one.warnings)}};
  }
  return rows;
}

std::set<edit::Key> refusedOf(const ListedWaypoints& list, const std::vector<exchange::WaypointEdit>& edits) {
  return edit::refusedNames(exchange::itemsOf(list.stored.points), edits, list.store->keeps());
}

QJsonArray refusedJson(const ListedWaypoints& list, const std::vector<exchange::WaypointEdit>& edits) {
  const std::set<edit::Key> refused = refusedOf(list, edits);
  QJsonArray rows;
  for (const exchange::WaypointEdit& edit : edits) {
    if (!refused.contains(edit.key)) continue;
    rows << QJsonObject{
        {QStringLiteral("id"), edit.before ? QJsonValue(QString::fromStdString(edit.key)) : QJsonValue()},
        {QStringLiteral("name"), QString::fromStdString(edit.after->name)}};
  }
  return rows;
}

QJsonObject previewJson(const ListedWaypoints& list, const exchange::MergedEdits& edits,
                        const std::optional<DoubtsAhead>& doubts) {
  QJsonObject json{
      {QStringLiteral("changes"), exchange::stepsJson(exchange::stepsOf(edits.edits), list.mapId())},
      {QStringLiteral("calls"), callsOf(list, edits.edits)},
      {QStringLiteral("conflicts"), exchange::conflictsJson(edits.conflicts, list.mapId())}};
  if (const QJsonArray refused = refusedJson(list, edits.edits); !refused.isEmpty())
    json[QStringLiteral("refused")] = refused;
  if (doubts) json[QStringLiteral("warnings")] = doubtsJson(*doubts);
  return json;
}

}  // namespace

std::vector<exchange::WaypointEdit> fitted(const ListedWaypoints& list,
                                           std::vector<exchange::WaypointEdit> edits) {
  exchange::FittedEdits fitted = exchange::fitted(std::move(edits), list.store->keeps());
  if (!fitted.notes.isEmpty()) list.robot->addRemark(words::paragraph(fitted.notes));
  return std::move(fitted.edits);
}

CommandResult<ListedWaypoints> listWaypoints(RobotCommand& command, const std::string& map, Use use) {
  const auto opened = command.open();
  if (!opened) return passOn(opened);
  return listWaypoints(**opened, map, use);
}

CommandResult<ListedWaypoints> listWaypoints(RobotReading& reading, const std::string& map, Use use) {
  robot::Robot& robot = reading.session().robot();
  ListedWaypoints list{&reading, {}};
  if (use == Use::Changing) reading.await(robot::Capability::WaypointEditing);
  list.store = robot.waypointStore();
  if (!list.store && use == Use::Changing) return reading.lacks(robot::Capability::WaypointEditing);
  if (!list.store && !robot.waypointSource()) return reading.lacks(robot::Capability::Waypoints);
  const auto key = storedMap(reading, map);
  if (!key) return passOn(key);
  list.map = *key;
  auto stored = readAll(list, robot.waypointSource());
  if (!stored) return list.robot->failure(stored.error());
  list.stored = std::move(*stored);
  if (use == Use::Changing) reading.warnOfUnconfirmed(robot::Capability::WaypointEditing);
  for (const Fault& note : list.stored.notes)
    reading.addRemark(words::about(sentences::nameOf(map::placesOf(list.map)), sentences::sentenceOf(note)));
  if (use == Use::Reading) {
    for (const auto& left : exchange::temporaryNamesIn(exchange::itemsOf(list.stored.points)))
      reading.addRemark(nameLeft(left));
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
    return list.robot->failure(
        kRobotError, Text::tr("There is no waypoint %1 (see mapwright waypoints list).").arg(shown));
  return list.robot->failure(
      kUsage, Text::tr("Several waypoints are called \"%1\". Pass an id: %2.").arg(shown, someIds(called)));
}

tl::expected<WaypointFileKind, QString> waypointFileKind(const std::string& path, const std::string& format) {
  if (!format.empty()) {
    if (const auto kind = kindCalled(text(format))) return *kind;
    return tl::make_unexpected(Text::tr("--format %1: must be csv or geojson.").arg(text(format)));
  }
  if (isStandardOutput(text(path))) return WaypointFileKind::GeoJson;
  if (const auto kind = kindCalled(QFileInfo(text(path)).suffix().toLower())) return *kind;
  return tl::make_unexpected(
      Text::tr("%1: the name must end in .geojson or .csv; or pass --format geojson or csv.")
          .arg(text(path)));
}

tl::expected<exchange::WantedList, QString> readWantedFile(const std::string& path, const std::string& format,
                                                           const std::string& angles) {
  exchange::AngleUnit unit = exchange::AngleUnit::Guess;
  if (angles == "degrees") {
    unit = exchange::AngleUnit::Degrees;
  } else if (angles == "radians") {
    unit = exchange::AngleUnit::Radians;
  } else if (!angles.empty()) {
    return tl::make_unexpected(Text::tr("--angles %1: must be degrees or radians.").arg(text(angles)));
  }
  const bool by_content = isStandardInput(path) && format.empty();
  const QString word = format.empty() ? QFileInfo(text(path)).suffix().toLower() : text(format);
  auto kind = exchange::waypointFormatCalled(word);
  if (!kind && !format.empty())
    return tl::make_unexpected(Text::tr("--format %1: must be csv, geojson or yaml.").arg(text(format)));
  if (!kind && !by_content)
    return tl::make_unexpected(Text::tr("%1: the name must end in .geojson, .json, .csv or .yaml; or pass "
                                        "--format geojson, csv or yaml.")
                                   .arg(text(path)));
  const QString called = inputCalled(path);
  const auto bytes = bytesOf(path, exchange::kMaxWantedBytes);
  if (!bytes)
    return tl::make_unexpected(
        Text::tr("%1 cannot be read: %2.").arg(called, sentences::wordsOf(bytes.error().cause)));
  if (bytes->size() > exchange::kMaxWantedBytes)
    return tl::make_unexpected(Text::tr("%1 is larger than 64 MiB.").arg(called));
  exchange::WantedFile wanted =
      exchange::wantedFromFile(*bytes, kind ? *kind : exchange::waypointFormatOf(*bytes), unit);
  if (!wanted) return tl::make_unexpected(words::about(called, wanted.error()));
  if (wanted->unit_guessed)
    wanted->notes << Text::tr("Pass --angles degrees or --angles radians to be sure.");
  return wanted;
}

DoubtfulWaypoints doubtsOf(const ListedWaypoints& list, const std::vector<map::Waypoint>& points,
                           std::optional<double> radius_m) {
  const double radius = radius_m ? *radius_m : robotRadius(*list.robot);
  const MapBelow ground = mapBelow(*list.robot, list.map);
  std::vector<Eigen::Vector2d> places;
  places.reserve(points.size());
  std::vector<std::string> names;
  for (const map::Waypoint& point : points) {
    places.push_back(point.position_m);
    names.push_back(point.name);
  }
  const std::set<std::string> twice = placing::namesTwice(names);
  const placing::GroundWarnings found = placing::groundWarnings(places, ground.map, radius, nullptr);
  DoubtfulWaypoints doubtful;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool zero_turn = points[i].yaw_rad == 0.0 && list.stored.zero_turns.contains(points[i].id);
    doubtful.of.push_back(
        placing::together(found.of[i], points[i].name, twice.contains(points[i].name), zero_turn));
  }
  doubtful.looked = found.state != placing::GroundState::None;
  if (!doubtful.looked) {
    doubtful.untold = words::paragraph(
        {Text::tr("The map under the waypoints cannot be read, so they are not checked for walls."),
         ground.unavailable_reason});
  } else {
    doubtful.untold = sentences::sentenceOf(found.state);
  }
  return doubtful;
}

QJsonArray warningsJson(const placing::Warnings& warnings) {
  QJsonArray rows;
  for (const placing::Warning& warning : warnings) {
    QJsonObject row{{QStringLiteral("kind"), stableWordOf(warning.kind)},
                    {QStringLiteral("sentence"), sentences::sentenceOf(warning)}};
    if (warning.kind == placing::WarningKind::NearWall) {
      row[QStringLiteral("distance_m")] = warning.distance_m;
      row[QStringLiteral("radius_m")] = warning.radius_m;
    }
    rows << row;
  }
  return rows;
}

QString warningsLine(const placing::Warnings& warnings) {
  return words::paragraph(sentences::sentencesOf(warnings).split(QLatin1Char('\n')));
}

QJsonArray callsOf(const ListedWaypoints& list, const std::vector<exchange::WaypointEdit>& edits) {
  const std::set<edit::Key> refused = refusedOf(list, edits);
  std::vector<robot::WaypointChange> changes;
  for (const exchange::WaypointEdit& edit : edits) {
    if (!refused.contains(edit.key)) changes.push_back({edit.key, edit.before, edit.after});
  }
  return exchange::callsJson(*list.store, list.store->plan(list.stored, changes), list.map);
}

QJsonObject previewReport(const ListedWaypoints& list, const exchange::MergedEdits& edits,
                          const std::optional<DoubtsAhead>& doubts) {
  QJsonObject report = previewJson(list, edits, doubts);
  report[QStringLiteral("dry_run")] = true;
  report[QStringLiteral("map")] = QString::fromStdString(list.mapId());
  return report;
}

void printPreview(const ListedWaypoints& list, const exchange::MergedEdits& edits, bool json,
                  const std::optional<DoubtsAhead>& doubts) {
  const std::vector<exchange::WaypointStep> steps = exchange::stepsOf(edits.edits);
  if (json) {
    printJson(previewJson(list, edits, doubts));
    return;
  }
  std::vector<QStringList> table{
      {Text::tr("CHANGE"), Text::tr("ID"), Text::tr("NAME"), Text::tr("NEW VALUE")}};
  for (const exchange::WaypointStep& step : steps) {
    const std::string id = step.id();
    table.push_back({wordOf(step.kind), id.empty() ? QStringLiteral("-") : words::plainName(id),
                     words::plainName(step.name()), exchange::detailOf(step)});
  }
  for (const QString& line : exchange::conflictLines(edits.conflicts))
    table.push_back({Text::tr("conflict"), QString(), QString(), line});
  if (const QString why = exchange::refusedText(refusedOf(list, edits.edits), edits.edits); !why.isEmpty())
    table.push_back({Text::tr("refused"), QString(), QString(), why});
  const bool changes = table.size() > 1;
  for (const DoubtAhead& one : doubts.value_or(DoubtsAhead())) {
    table.push_back({Text::tr("warning"), one.id.empty() ? QStringLiteral("-") : words::plainName(one.id),
                     words::plainName(one.name), warningsLine(one.warnings)});
  }
  if (table.size() > 1) {
    if (!changes) printLine(Text::tr("There is nothing to change."));
    printTable(table);
  } else {
    printLine(Text::tr("There is nothing to change."));
  }
}

}  // namespace mapwright::app
