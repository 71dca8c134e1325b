// `mapwright maps …`: the maps of a robot or a folder, exports, differences and changes
// (docs/command-line.md).
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <QDateTime>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>

#include "app/command_map.h"
#include "app/command_text.h"
#include "app/map_diff.h"
#include "app/map_operand.h"
#include "app/map_request.h"
#include "app/maps_align.h"
#include "app/output.h"
#include "app/robot_command.h"
#include "app/robot_factory.h"
#include "grids/export_grid.h"
#include "jobs/change_map.h"
#include "jobs/export_map.h"
#include "robot/address.h"
#include "robot/map_dispatch.h"
#include "sentences/fault_sentence.h"
#include "sentences/plural.h"
#include "sentences/problem_sentence.h"
#include "sentences/subject_name.h"
#include "session/lacks_picture.h"
#include "words/decimal.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

using robot::MapChange;
using words::text;

/// The options as typed; empty = not given.
struct MapsArguments : RobotArguments {
  std::string id;             // show, export: a map (12, mapping:48, live, submaps)
  std::string label;          // rename, save: the new name
  std::string place;          // load: the name of the waypoint where the robot stands
  std::string first, second;  // diff: a map of the robot, or a file
  std::string output, format, diff_picture;
  std::string resolution, origin;        // of a plain picture file; resolution also for exported submaps
  std::string region;                    // export: X,Y,LX,LY
  std::string filename;                  // save-on-robot
  std::string map_mode;                  // export: of the map.yaml
  std::optional<double> occupied, free;  // export: its thresholds
  bool world_file = false;
  bool allow_missing = false;  // export, diff: write maps of which most is missing
  bool force = false;          // overwrite files even if the map was read from them
  bool yes = false;            // delete: confirmed
  bool continues = false;      // start-mapping: more of the current map
  bool cancels = false;        // stop-mapping: what was mapped is lost
};

/// "2026-11-22 10:00"; "-" = unknown. `epoch_s`: seconds since 1970.
QString dateText(std::optional<double> epoch_s) {
  if (!epoch_s || !(*epoch_s > 0) || *epoch_s > 4e11) return QStringLiteral("-");
  return QDateTime::fromMSecsSinceEpoch(qint64(*epoch_s * 1000)).toString(QStringLiteral("yyyy-MM-dd hh:mm"));
}

/// [{"id","name","type","x","y","yaw"}], metres and radians.
QJsonArray pointsJson(const std::vector<map::Waypoint>& points) {
  QJsonArray rows;
  for (const map::Waypoint& point : points) {
    rows << QJsonObject{{QStringLiteral("id"), text(point.id)},
                        {QStringLiteral("name"), text(point.name)},
                        {QStringLiteral("type"), text(point.type)},
                        {QStringLiteral("x"), point.position_m.x()},
                        {QStringLiteral("y"), point.position_m.y()},
                        {QStringLiteral("yaw"), point.yaw_rad ? QJsonValue(*point.yaw_rad) : QJsonValue()}};
  }
  return rows;
}

void addPoints(std::vector<QStringList>& table, const std::vector<map::Waypoint>& points) {
  for (const map::Waypoint& point : points) {
    table.push_back(
        {Text::tr("point"),
         Text::tr("%1 %2  x %3 m, y %4 m%5")
             .arg(words::plainName(point.id), words::plainName(point.name),
                  words::decimal(point.position_m.x()), words::decimal(point.position_m.y()),
                  point.yaw_rad ? Text::tr(", yaw %1 rad").arg(words::decimal(*point.yaw_rad)) : QString())});
  }
}

void addRow(std::vector<QStringList>& table, const map::CatalogueEntry& row) {
  table.push_back({Text::tr("date"), dateText(row.modified_s ? row.modified_s : row.created_s)});
  table.push_back({Text::tr("current"), row.is_current ? Text::tr("yes") : Text::tr("no")});
  if (!row.state.empty()) table.push_back({Text::tr("state"), words::plainName(row.state)});
  if (!row.file_name.empty()) table.push_back({Text::tr("map name"), words::plainName(row.file_name)});
}

/// Shows what is known of a map without a picture (session::lacksPicture()): its name, catalogue entry and
/// waypoints; "grid" is null in JSON. Reports the missing picture, and the result is incomplete.
CommandResult<int> showWithoutPicture(RobotReading& reading, bool json_wanted) {
  session::Session& session = reading.session();
  const session::MapSlot& slot = session.wholeMap();
  const map::MapKey key = slot.key();
  const auto no_picture = reading.failure(kIncomplete, sentences::sentenceOf(slot.remark()));
  std::vector<map::Waypoint> points;
  if (robot::WaypointSource* const source = session.robot().waypointSource()) {
    auto told = reading.ask<map::WaypointList>(
        [&](robot::OutcomeTo<map::WaypointList> reply) { return source->waypoints(key, std::move(reply)); });
    if (!told) return reading.failure(told.error());
    points = std::move(told->points);
    for (const Fault& note : told->notes)
      reading.addRemark(words::about(sentences::nameOf(map::placesOf(key)), sentences::sentenceOf(note)));
  }
  const map::CatalogueEntry* const row = session.catalogue().find(key);
  if (json_wanted) {
    QJsonObject json = row ? entryJson(*row)
                           : QJsonObject{{QStringLiteral("id"), text(map::toText(key))},
                                         {QStringLiteral("name"), slot.name()}};
    json[QStringLiteral("grid")] = QJsonValue();
    json[QStringLiteral("waypoints")] = pointsJson(points);
    printJson(json);
    return no_picture;
  }
  std::vector<QStringList> table{{Text::tr("id"), text(map::toText(key))},
                                 {Text::tr("name"), words::plainName(slot.name().toStdString())},
                                 {Text::tr("picture"), Text::tr("none")}};
  if (row) addRow(table, *row);
  addPoints(table, points);
  printTable(table);
  return no_picture;
}

/// `file_names`: also that of its files.
QStringList rowOf(const map::CatalogueEntry& row, bool file_names) {
  const QString version = row.is_archived   ? Text::tr("archived")
                          : row.map_version ? QStringLiteral("v%1").arg(*row.map_version)
                                            : text(row.state);
  QStringList cells{row.is_current ? QStringLiteral("*") : QStringLiteral(" "), text(map::toText(row.key)),
                    version.isEmpty() ? QStringLiteral("-") : version,
                    dateText(row.modified_s ? row.modified_s : row.created_s)};
  if (file_names) cells << (row.file_name.empty() ? QStringLiteral("-") : words::plainName(row.file_name));
  return cells << words::plainName(row.name);
}

CommandResult<RobotReading*> openRobot(RobotCommand& command, const MapsArguments& args,
                                       RobotReading::Purpose purpose = RobotReading::Purpose::Maps) {
  return openPlaced(command, {text(args.id), text(args.robot)}, {args.resolution, args.origin}, purpose);
}

/// Its live map comes from a map dispatcher only, which can also send it whole on request.
bool givesMapWhenAsked(robot::Robot& robot) {
  robot::MapDispatch* const dispatch = robot.mapDispatch();
  if (!dispatch || !robot.liveTopics() || !dispatch->offered(robot::DispatchService::Grid)) return false;
  const auto offers = dispatch->offers();
  const QStringList by = robot.liveTopics()->topicsOf(map::Stream::WholeMap);
  return std::all_of(by.begin(), by.end(), [&](const QString& name) {
    return std::any_of(offers.begin(), offers.end(), [&](const robot::DispatchOffer& offer) {
      return offer.service == robot::DispatchService::Grid && offer.name == name.toStdString();
    });
  });
}

RobotReading::Purpose purposeOf(const std::string& id) {
  return id == "submaps" ? RobotReading::Purpose::Submaps : RobotReading::Purpose::Maps;
}

void print(const map::CatalogueEntry& entry, bool json) {
  if (json) {
    printJson(entryJson(entry));
  } else {
    printLine(
        QStringLiteral("%1  %2").arg(words::plainName(map::toText(entry.key)), words::plainName(entry.name)));
  }
}

/// What its map manager does while no map is the current one, whose entry would say so; empty: nothing is
/// known.
QString withoutCurrent(RobotReading& reading) {
  const robot::MapAdministration* const maps = reading.session().robot().mapAdministration();
  const std::string state = maps ? maps->managerState() : std::string();
  if (state.empty() || reading.session().catalogue().current()) return {};
  return Text::tr("The map manager is %1.").arg(words::plainName(state));
}

CommandResult<int> mapsList(RobotCommand& command, const MapsArguments& args) {
  auto robot = openRobot(command, args);
  if (!robot) return passOn(robot);
  const auto rows = (*robot)->catalogue();
  if (!rows) return passOn(rows);
  if (args.json) {
    QJsonArray list;
    for (const map::CatalogueEntry& row : **rows) list << entryJson(row);
    printJson(list);
    return kDone;
  }
  if ((*rows)->empty()) {
    printLine(Text::tr("There are no maps."));
    return kDone;
  }
  const bool file_names =
      std::any_of((*rows)->begin(), (*rows)->end(), [](const auto& row) { return !row.file_name.empty(); });
  QStringList header{QStringLiteral(" "), Text::tr("ID"), Text::tr("VERSION"), Text::tr("DATE")};
  if (file_names) header << Text::tr("MAP NAME");
  std::vector<QStringList> table{header << Text::tr("NAME")};
  for (const map::CatalogueEntry& row : **rows) table.push_back(rowOf(row, file_names));
  printTable(table);
  if (const QString state = withoutCurrent(**robot); !state.isEmpty()) printLine(state);
  return kDone;
}

CommandResult<int> mapsCurrent(RobotCommand& command, const MapsArguments& args) {
  auto robot = openRobot(command, args);
  if (!robot) return passOn(robot);
  const auto rows = (*robot)->catalogue();
  if (!rows) return passOn(rows);
  const map::CatalogueEntry* const current = (*robot)->session().catalogue().current();
  if (!current) {
    return tl::make_unexpected(CommandFailure{
        kRobotError,
        words::paragraph({Text::tr("%1: none of its maps is the current one.").arg(text(args.robot)),
                          withoutCurrent(**robot)})});
  }
  print(*current, args.json);
  return kDone;
}

CommandResult<int> mapsShow(RobotCommand& command, const MapsArguments& args) {
  auto robot = openRobot(command, args, purposeOf(args.id));
  if (!robot) return passOn(robot);
  const bool stored = !args.id.empty() && args.id != "live" && args.id != "submaps";
  if (stored) {  // the catalogue has its dates and versions
    if (const auto rows = (*robot)->catalogue(); !rows) return passOn(rows);
  }
  const auto placed = (*robot)->map(text(args.id), resolutionOf(args.resolution));
  if (!placed && session::lacksPicture((*robot)->session().wholeMap()))
    return showWithoutPicture(**robot, args.json);
  if (!placed) return passOn(placed);
  session::Session& session = (*robot)->session();
  const map::WholeMap& shown = session.wholeMap().shown();
  const map::CatalogueEntry* const row = session.catalogue().find(shown.key);
  const QString id = args.id == "submaps" ? text(args.id) : text(map::toText(shown.key));
  QJsonObject json =
      row ? entryJson(*row)
          : QJsonObject{{QStringLiteral("id"), id}, {QStringLiteral("name"), (*robot)->nameOfMap()}};
  json[QStringLiteral("grid")] = gridJson(placed->reference);
  json[QStringLiteral("overlays")] = int(shown.overlays.size());
  json[QStringLiteral("trajectories")] = int(shown.trajectories.size());
  json[QStringLiteral("landmarks")] = int(shown.landmarks.size());
  json[QStringLiteral("waypoints")] = pointsJson(session.wholeMap().waypoints().points);
  if (shown.display_rotation_rad) json[QStringLiteral("display_rotation")] = *shown.display_rotation_rad;
  if (args.json) {
    printJson(json);
    return kDone;
  }
  const map::GridReference& grid = placed->reference;
  std::vector<QStringList> table{
      {Text::tr("id"), id},
      {Text::tr("name"), words::plainName((*robot)->nameOfMap())},
      {Text::tr("cells"), QStringLiteral("%1 x %2").arg(grid.width).arg(grid.height)},
      {Text::tr("resolution"), Text::tr("%1 m").arg(words::decimal(grid.resolution_m))},
      {Text::tr("origin"), Text::tr("x %1 m, y %2 m, yaw %3 rad (lower left corner)")
                               .arg(words::decimal(grid.origin.x_m), words::decimal(grid.origin.y_m),
                                    words::decimal(grid.origin.yaw_rad))},
      {Text::tr("extent"), Text::tr("%1 m x %2 m")
                               .arg(grid.width * grid.resolution_m, 0, 'f', 2)
                               .arg(grid.height * grid.resolution_m, 0, 'f', 2)}};
  if (row) addRow(table, *row);
  table.push_back({Text::tr("overlays"), QString::number(shown.overlays.size())});
  addPoints(table, session.wholeMap().waypoints().points);
  printTable(table);
  return kDone;
}

/// Why it is not written without --allow-missing.
std::optional<QString> missingReason(const MapsArguments& args, const render::PlacedGrid& map) {
  if (args.allow_missing) return std::nullopt;
  const QString why = jobs::mostlyMissingReason(*map.cells);
  if (why.isEmpty()) return std::nullopt;
  return QStringLiteral("%1 %2").arg(why, Text::tr("Pass --allow-missing to write them all the same."));
}

/// How map_server is to read the exported picture. The error is a sentence.
tl::expected<grids::MapServerForm, QString> formOf(const MapsArguments& args, const QString& output,
                                                   bool png) {
  using Mode = grids::MapServerForm::Mode;
  const auto no = [](const QString& sentence) { return tl::make_unexpected(sentence); };
  const bool given = !args.map_mode.empty() || args.occupied || args.free;
  if (png && given)
    return no(
        Text::tr("--map-mode, --occupied and --free need a map.yaml: name the output NAME.yaml, not %1.")
            .arg(output));
  grids::MapServerForm form{.occupied_thresh = args.occupied, .free_thresh = args.free};
  if (args.map_mode == "raw") {
    form.mode = Mode::Raw;
  } else if (args.map_mode == "scale") {
    form.mode = Mode::Scale;
  } else if (!args.map_mode.empty() && args.map_mode != "trinary") {
    return no(Text::tr("--map-mode %1: it must be trinary, scale or raw.").arg(text(args.map_mode)));
  }
  if (form.mode == Mode::Raw && (args.occupied || args.free))
    return no(Text::tr("--occupied and --free have no effect in mode raw."));
  const bool pgm = args.format == "pgm" || QFileInfo(output).suffix().toLower() == QLatin1String("pgm");
  if (form.mode == Mode::Scale && pgm)
    return no(
        Text::tr("A PGM cannot hold unknown cells in mode scale. Name the output NAME.yaml: its picture "
                 "will be a PNG."));
  if (const auto flaw = grids::flawOf(form)) return no(sentences::sentenceOf(*flaw));
  return form;
}

CommandResult<int> mapsExport(RobotCommand& command, const MapsArguments& args) {
  const QString output = text(args.output);
  const QString suffix = QFileInfo(output).suffix().toLower();
  const bool printed = isStandardOutput(output);
  QString format = !args.format.empty() ? text(args.format) : printed ? QStringLiteral("png") : suffix;
  if (format == QLatin1String("yaml") || format == QLatin1String("yml")) format = QStringLiteral("pgm");
  if (format != QLatin1String("png") && format != QLatin1String("pgm")) {
    return wrong(Text::tr("--output %1: the name must end in .png, or in .pgm or .yaml to get both of "
                          "these; or pass --format png or pgm.")
                     .arg(output));
  }
  const bool names_png = suffix == QLatin1String("png");
  const bool names_pgm = suffix == QLatin1String("pgm") || suffix.startsWith(QLatin1Char('y'));
  if (!args.format.empty() && (format == QLatin1String("png") ? names_pgm : names_png)) {
    return wrong(Text::tr("--output %1 contradicts --format %2.").arg(output, text(args.format)));
  }
  if (printed && (format != QLatin1String("png") || args.world_file)) {
    return wrong(
        Text::tr("Only a single PNG can be written to the standard output (--output %1).").arg(output));
  }
  const bool png = format == QLatin1String("png");
  const auto form = formOf(args, output, png);
  if (!form) return wrong(form.error());
  const auto files = png ? jobs::ExportFormat::MapPicture : jobs::ExportFormat::MapServer;
  for (const QString& file : jobs::exportedFiles(output, files, args.world_file, form->mode)) {
    if (const auto why = notCreatedReason(file, args.force)) return wrong(*why);
  }
  if (const auto why = notTogetherReason({output, text(args.report)})) return sharedOutput(*why);
  std::optional<map::GridRegion> region;
  const bool live = args.id.empty() || args.id == "live";
  if (!args.region.empty()) {
    const auto typed = gridRegionFrom(args.region);
    if (!typed) return wrong(typed.error());
    if (!live)
      return wrong(Text::tr("--region only works with the live map, not with %1.").arg(text(args.id)));
    region = *typed;
  }
  auto robot = openRobot(command, args, purposeOf(args.id));
  if (!robot) return passOn(robot);
  // An export always means the whole map, whatever its size.
  const bool by_part = region || (live && givesMapWhenAsked((*robot)->session().robot()));
  const auto placed =
      by_part ? (*robot)->part(region) : (*robot)->map(text(args.id), resolutionOf(args.resolution));
  if (!placed) return passOn(placed);
  const jobs::ExportRequest request{jobs::WholeMapExport{placed->cells, placed->reference},
                                    files,
                                    output,
                                    args.world_file,
                                    *form,
                                    existingBy(args.force)};
  if (const auto missing = missingReason(args, *placed)) return wrong(*missing);
  const jobs::ExportResult written = jobs::exportMap(request, nullptr);
  if (!written.error.isEmpty()) return wrong(written.error);
  if (!written.remark.isEmpty()) (*robot)->addRemark(written.remark);
  if (!printed) {
    const map::GridReference& grid = placed->reference;
    printLine(Text::tr("%1: %2 x %3 cells of %4 m")
                  .arg(oneLine(output), QString::number(grid.width), QString::number(grid.height),
                       words::decimal(grid.resolution_m)));
  }
  return kDone;
}

CommandResult<int> mapsDiff(RobotCommand& command, const MapsArguments& args) {
  command.answerByCode();
  const QString printed = args.json ? QStringLiteral("-") : QString();
  const auto unavailable_reason =
      args.diff_picture.empty() ? std::nullopt : pngNotWritableReason(text(args.diff_picture));
  if (unavailable_reason) return wrong(*unavailable_reason);
  if (const auto why = notTogetherReason({text(args.diff_picture), text(args.report), printed}))
    return sharedOutput(*why);
  if (const auto why = robotWithoutEffectReason({args.first, args.second}, text(args.robot)))
    return wrong(*why);
  const PicturePlace place{args.resolution, args.origin};
  const auto pair = openMaps(command, {args.first, args.second}, text(args.robot), place);
  if (!pair) return passOn(pair);
  const std::vector<render::PlacedGrid>& maps = pair->maps;
  const QString picture = text(args.diff_picture);
  if (const auto why = overOwnSource({picture}, pair->source_files); why && !args.force) {
    return wrong(*why);
  }
  for (const render::PlacedGrid& map : maps) {
    if (const auto missing = picture.isEmpty() ? std::nullopt : missingReason(args, map))
      return wrong(*missing);
  }
  const auto diff = diffMaps(maps[0], maps[1], picture);
  if (!diff) return wrong(diff.error());
  if (isStandardOutput(picture)) return diff->same() ? kDone : kIncomplete;
  using render::Difference;
  const auto cells = [&](Difference what) { return qint64(diff->cells[std::size_t(what)]); };
  const std::vector<std::pair<const char*, Difference>> kinds{
      {"appeared", Difference::Appeared},    {"vanished", Difference::Vanished},
      {"only_first", Difference::OnlyFirst}, {"only_second", Difference::OnlySecond},
      {"same_free", Difference::SameFree},   {"same_occupied", Difference::SameOccupied}};
  if (args.json) {
    QJsonObject json{{QStringLiteral("same"), diff->same()},
                     {QStringLiteral("complete"), command.complete()},
                     {QStringLiteral("size"), QJsonArray{diff->width, diff->height}},
                     {QStringLiteral("cell_area_m2"), diff->cell_area_m2},
                     {QStringLiteral("levels_differ"), qint64(diff->levels_differ)}};
    for (const auto& [name, what] : kinds) json[QLatin1String(name)] = cells(what);
    printJson(json);
  } else {
    std::vector<QStringList> table;
    const auto row = [&](const QString& name, qint64 count) {
      table.push_back({name, Text::tr("%1 cells", nullptr, sentences::formOf(count)).arg(count),
                       Text::tr("%1 m²").arg(double(count) * diff->cell_area_m2, 0, 'f', 4)});
    };
    row(Text::tr("occupied in the second only"), cells(Difference::Appeared));
    row(Text::tr("occupied in the first only"), cells(Difference::Vanished));
    row(Text::tr("known in the first only"), cells(Difference::OnlyFirst));
    row(Text::tr("known in the second only"), cells(Difference::OnlySecond));
    row(Text::tr("same state, different gray level"), diff->levels_differ);
    row(Text::tr("free in both"), cells(Difference::SameFree));
    row(Text::tr("occupied in both"), cells(Difference::SameOccupied));
    printTable(table);
    const QString outcome = !diff->same() ? Text::tr("The maps differ.")
                            : command.complete()
                                ? Text::tr("The maps are the same.")
                                : Text::tr("The parts of the maps that could be read are the same.");
    printLine(outcome);
  }
  return diff->same() ? kDone : kIncomplete;
}

bool isOfOneMap(MapChange change) { return !robot::isOfMapping(change); }

bool names(MapChange change) { return change == MapChange::Rename || change == MapChange::Save; }

/// Why it is not even requested; empty if it is.
QString notAskedReason(MapChange change, const MapsArguments& args) {
  if (names(change)) {
    const QString label = text(args.label);
    if (label.trimmed().isEmpty()) {
      return change == MapChange::Save ? Text::tr("Name the map: maps save NAME.")
                                       : Text::tr("Name the map: maps rename ID NAME.");
    }
    if (const QString why = jobs::noMapNameReason(label); !why.isEmpty()) return why;
  }
  const map::MapKey key = map::mapKeyFromText(args.id);
  if (isOfOneMap(change) && (key.kind != map::MapKind::Stored || !isPlainId(key.id)))
    return Text::tr("%1: pass the id of a stored map (see mapwright maps list).").arg(text(args.id));
  if (change == MapChange::Delete && !args.yes)
    return Text::tr("Deleting a map cannot be undone. Pass --yes to delete %1.").arg(text(args.id));
  return {};
}

CommandResult<int> mapsChange(RobotCommand& command, const MapsArguments& args, MapChange change) {
  if (change == MapChange::StartMapping && args.continues) change = MapChange::ContinueMapping;
  if (change == MapChange::StopMapping && args.cancels) change = MapChange::CancelMapping;
  if (const QString why = notAskedReason(change, args); !why.isEmpty()) return wrong(why);
  const auto robot = command.open();
  if (!robot) return passOn(robot);
  (*robot)->await(robot::Capability::Administration);
  robot::MapOrder order{.change = change};
  if (isOfOneMap(change)) order.key = map::mapKeyFromText(args.id);
  if (names(change)) order.name = args.label;
  if (!args.place.empty()) {
    const robot::MapAdministration* const maps = (*robot)->session().robot().mapAdministration();
    if (maps && !maps->loadAsksForPlace())
      return (*robot)->failure(
          kUsage,
          Text::tr("--waypoint: this robot does not ask where it stands when it loads a map. Leave it out."));
  }
  if (change == MapChange::Load) order.place = args.place;
  if (names(change) && (*robot)->session().catalogue().offered()) {
    const auto maps = (*robot)->catalogue();
    const QString remark = maps ? jobs::alsoCalledSo(order, **maps) : QString();
    if (!remark.isEmpty()) (*robot)->addRemark((*robot)->about(remark));
  }
  const auto entry = (*robot)->change(order);
  if (!entry) return passOn(entry);
  if (args.json || !entry->key.id.empty()) print(*entry, args.json);
  const QString odd = jobs::oddity(order, *entry);
  if (odd.isEmpty()) return kDone;
  return tl::make_unexpected(CommandFailure{kIncomplete, words::about(text(args.robot), odd)});
}

CommandResult<int> mapsSaveOnRobot(RobotCommand& command, const MapsArguments& args) {
  if (const QString why = jobs::noFilenameReason(text(args.filename)); !why.isEmpty()) return wrong(why);
  const auto robot = command.open();
  if (!robot) return passOn(robot);
  robot::MapDispatch* const dispatch = (*robot)->session().robot().mapDispatch();
  if (!dispatch) return (*robot)->lacks(robot::Capability::Dispatch);
  const auto saved = (*robot)->ask<std::string>(
      [&](robot::OutcomeTo<std::string> reply) { return dispatch->save(args.filename, std::move(reply)); });
  if (!saved) return (*robot)->failure(saved.error());
  printLine(Text::tr("The robot wrote %1.").arg(words::plainName(*saved)));
  return kDone;
}

/// A `mapwright maps …` that changes something.
struct MapChangeCommand {
  MapChange change;
  const char* name;
  QString about;
};

std::vector<MapChangeCommand> mapChangeCommands() {
  return {{MapChange::Rename, "rename", Text::tr("Rename a stored map")},
          {MapChange::Load, "load", Text::tr("Make a stored map the current one")},
          {MapChange::Archive, "archive", Text::tr("Archive a stored map")},
          {MapChange::Unarchive, "unarchive", Text::tr("Restore a map from the archive")},
          {MapChange::Delete, "delete", Text::tr("Delete a stored map (--yes)")},
          {MapChange::StartMapping, "start-mapping", Text::tr("Start mapping")},
          {MapChange::StopMapping, "stop-mapping", Text::tr("End mapping; save stores the result")},
          {MapChange::Save, "save", Text::tr("Store the result of mapping under a name")}};
}

}  // namespace

void addMaps(Commands& commands) {
  const auto shared = std::make_shared<MapsArguments>();
  MapsArguments& args = *shared;
  CLI::App* maps = commands.program().add_subcommand(
      "maps", help(Text::tr("Maps stored on a robot or in a folder: list, export, compare, change")));
  maps->require_subcommand(1);
  using Run = std::function<CommandResult<int>(RobotCommand&, const MapsArguments&)>;
  const auto addOne = [&](const char* name, const QString& what, Run run) {
    return addReading(commands, *maps, name, what,
                      Text::tr("Robot address, map.yaml, picture or folder (or MAPWRIGHT_ROBOT)"), shared,
                      std::move(run));
  };
  const auto add = [&](const char* name, const QString& what, Run run) {
    CLI::App* command = addOne(name, what, std::move(run));
    command->add_option("--resolution", args.resolution,
                        help(Text::tr("Metres per cell, for a plain picture file or for submaps "
                                      "that are exported or compared (default: 0.05)")));
    command->add_option("--origin", args.origin,
                        help(Text::tr("Lower left corner of a plain picture file: X,Y or X,Y,YAW")));
    return command;
  };
  const std::string which =
      help(Text::tr("Id of a stored map, mapping:ID, live, or submaps; by default the live or current one"));
  addJson(*add("list", Text::tr("List all maps and mapping results; * marks the current one"), mapsList),
          args.json);
  addJson(*add("current", Text::tr("Show the robot's current map"), mapsCurrent), args.json);
  CLI::App* show = add("show", Text::tr("Show size, place, dates and waypoints of a map"), mapsShow);
  show->add_option("id", args.id, which);
  addJson(*show, args.json);
  CLI::App* exported =
      add("export", Text::tr("Write a map as PNG, or as PGM and YAML for map_server"), mapsExport);
  exported->add_option("id", args.id, which);
  exported
      ->add_option("-o,--output", args.output,
                   help(Text::tr("Output file: NAME.png, or NAME.yaml / NAME.pgm (both); - writes "
                                 "a PNG to the standard output")))
      ->required();
  addForce(*exported, args.force);
  exported->add_option("--format", args.format, help(Text::tr("png or pgm, if the file name does not say")));
  exported->add_flag("--world-file", args.world_file,
                     help(Text::tr("Also write a world file: NAME.pgw of a PNG, NAME.wld of a PGM")));
  const std::string allow_missing =
      help(Text::tr("Write the map even if most of its picture is missing, as unknown cells"));
  exported->add_flag("--allow-missing", args.allow_missing, allow_missing);
  exported->add_option("--map-mode", args.map_mode,
                       help(Text::tr("How map_server reads the picture: trinary (default: walls, free and "
                                     "unknown as shown), or scale or raw (percentages)")));
  exported->add_option("--occupied", args.occupied,
                       help(Text::tr("occupied_thresh, 0 to 1: cells of a higher probability are walls. "
                                     "Without thresholds 0.65, with shades that keep all walls")));
  exported->add_option(
      "--free", args.free,
      help(Text::tr("free_thresh, 0 to 1: cells of a lower probability are free (default: 0.196)")));
  exported->add_option("--region", args.region,
                       help(Text::tr("Only this region of the live map of a map dispatcher (REP "
                                     "130): X,Y,LX,LY, its centre and side lengths in metres")));
  CLI::App* saved = addOne("save-on-robot",
                           Text::tr("Make a map dispatcher (REP 130) write its map to a file on the robot"),
                           mapsSaveOnRobot);
  saved
      ->add_option("file", args.filename,
                   help(Text::tr("File name on the robot. Its extension selects the format: most know .png, "
                                 ".pgm or .yaml for grids and .pcd, .ply or .vtk for clouds")))
      ->required();
  CLI::App* diff =
      add("diff", Text::tr("Compare two maps cell by cell; exit code 1 when they differ"), mapsDiff);
  diff->add_option("first", args.first,
                   help(Text::tr("A map of --robot (id, mapping:ID, live, submaps), or a file or address")))
      ->required();
  diff->add_option("second", args.second, help(Text::tr("The same for the second map")))->required();
  diff->add_option("--diff", args.diff_picture,
                   help(Text::tr("Write the differences as a PNG; - is the standard output")));
  diff->add_flag("--force", args.force, help(Text::tr("Overwrite a file even if a map was read from it")));
  diff->add_flag("--allow-missing", args.allow_missing, allow_missing);
  addJson(*diff, args.json);
  for (const MapChangeCommand& one : mapChangeCommands()) {
    CLI::App* command =
        addOne(one.name, one.about, [change = one.change](RobotCommand& each, const MapsArguments& typed) {
          return mapsChange(each, typed, change);
        });
    addJson(*command, args.json);
    if (isOfOneMap(one.change))
      command->add_option("id", args.id, help(Text::tr("Id of a stored map")))->required();
    if (names(one.change)) command->add_option("name", args.label, help(Text::tr("New name")))->required();
    if (one.change == MapChange::Load)
      command->add_option("--waypoint", args.place, help(Text::tr("Waypoint at which the robot stands")));
    if (one.change == MapChange::StartMapping)
      command->add_flag("--continue", args.continues, help(Text::tr("Extend the current map")));
    if (one.change == MapChange::StopMapping)
      command->add_flag("--cancel", args.cancels,
                        help(Text::tr("Discard the result; this cannot be undone")));
    if (one.change == MapChange::Delete)
      command->add_flag("--yes", args.yes, help(Text::tr("Required: deleting cannot be undone")));
  }
  addMapAlign(commands, *maps);
  addMapRehearsal(commands, *maps);
  addPoses(commands, *maps);
  addMapTransfers(commands, *maps);
}

}  // namespace mapwright::app
