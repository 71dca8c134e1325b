// `mapwright waypoints …`: the waypoints of one map of a robot or a folder (docs/command-line.md, "mapwright
// waypoints").
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/command_map.h"
#include "app/command_text.h"
#include "app/output.h"
#include "app/waypoint_list.h"
#include "app/waypoint_sending.h"
#include "disk/file_error.h"
#include "disk/written_file.h"
#include "exchange/waypoint_json.h"
#include "exchange/waypoint_plan.h"
#include "exchange/waypoint_steps.h"
#include "exchange/waypoint_table.h"
#include "geometry/pose.h"
#include "sentences/fault_sentence.h"
#include "sentences/plural.h"
#include "words/fixed.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

using words::text;

QString metres(double value) { return words::fixed(value, 3); }

QStringList rowOf(const map::Waypoint& point) {
  return {words::plainName(point.id),
          metres(point.position_m.x()),
          metres(point.position_m.y()),
          point.yaw_rad ? words::fixed(geometry::degreesFromRadians(*point.yaw_rad), 1) : QStringLiteral("-"),
          exchange::tagText(point),
          words::plainName(point.name)};
}

CommandResult<int> waypointsList(RobotCommand& command, const WaypointsArguments& args) {
  const auto radius_m = radiusFrom(args.radius);
  if (!radius_m) return wrong(radius_m.error());
  const auto list = listWaypoints(command, args.map, Use::Reading);
  if (!list) return passOn(list);
  std::optional<DoubtfulWaypoints> doubtful;
  if (args.warnings) doubtful = doubtsOf(*list, list->stored.points, *radius_m);
  // The list is complete; the additional data is not.
  const int exit_code = doubtful && !doubtful->looked ? int(kIncomplete) : int(kDone);
  if (exit_code == kIncomplete) list->robot->lack(doubtful->untold);
  if (exit_code == kDone && doubtful && !doubtful->untold.isEmpty()) list->robot->addRemark(doubtful->untold);
  if (args.json) {
    QJsonArray rows = exchange::waypointsJson(list->stored.points, list->mapId());
    for (std::size_t i = 0; doubtful && i < doubtful->of.size(); ++i) {
      QJsonObject row = rows[qsizetype(i)].toObject();
      row[QStringLiteral("warnings")] = warningsJson(doubtful->of[i]);
      rows[qsizetype(i)] = row;
    }
    printJson(rows);
    return exit_code;
  }
  if (list->stored.points.empty()) {
    printLine(Text::tr("There are no waypoints."));
    return exit_code;
  }
  std::vector<QStringList> table{{Text::tr("ID"), Text::tr("X (m)"), Text::tr("Y (m)"), Text::tr("YAW (°)"),
                                  Text::tr("TAGS"), Text::tr("NAME")}};
  if (doubtful) table.front() << Text::tr("WARNINGS");
  for (std::size_t i = 0; i < list->stored.points.size(); ++i) {
    table.push_back(rowOf(list->stored.points[i]));
    if (doubtful) table.back() << warningsLine(doubtful->of[i]);
  }
  printTable(table);
  return exit_code;
}

CommandResult<int> waypointsGet(RobotCommand& command, const WaypointsArguments& args) {
  const auto list = listWaypoints(command, args.map, Use::Reading);
  if (!list) return passOn(list);
  const auto point = chosen(*list, args.which.front());
  if (!point) return passOn(point);
  if (args.json) {
    printJson(exchange::waypointJson(**point, list->mapId()));
    return kDone;
  }
  std::vector<QStringList> table{{Text::tr("id"), words::plainName((*point)->id)},
                                 {Text::tr("name"), words::plainName((*point)->name)},
                                 {Text::tr("place"), exchange::placeText(**point)},
                                 {Text::tr("tags"), exchange::tagText(**point)}};
  if (!(*point)->type.empty()) table.push_back({Text::tr("type"), words::plainName((*point)->type)});
  table.push_back({Text::tr("map"), words::plainName(list->mapId())});
  printTable(table);
  return kDone;
}

CommandResult<int> waypointsExport(RobotCommand& command, const WaypointsArguments& args) {
  const QString output = text(args.output);
  const auto kind = waypointFileKind(args.output, args.format);
  if (!kind) return wrong(kind.error());
  if (const auto why = notCreatedReason(output, args.force)) return wrong(*why);
  if (const auto why = notTogetherReason({output, text(args.report)})) return sharedOutput(*why);
  const auto list = listWaypoints(command, args.map, Use::Reading);
  if (!list) return passOn(list);
  const std::string bytes =
      *kind == WaypointFileKind::Csv
          ? exchange::waypointsCsv(list->stored.points, list->mapId())
          : exchange::waypointsGeoJson(list->stored.points, list->mapId()).toStdString();
  if (const auto trouble = disk::writeFile(args.output, bytes, existingBy(args.force)))
    return wrong(sentences::wordsOf(disk::notWritten(*trouble)));
  if (!isStandardOutput(output)) {
    const auto count = qint64(list->stored.points.size());
    printLine(
        words::about(oneLine(output),
                     sentences::counted(Text::tr("%1 waypoints", nullptr, sentences::formOf(count)), count)));
  }
  return kDone;
}

struct PlaceAt {
  Eigen::Vector2d position_m{0, 0};
  std::optional<double> yaw_rad;
};

CommandResult<PlaceAt> placeAt(const std::string& args) {
  const auto numbers = numbersFrom(args);
  if (!numbers || (numbers->size() != 2 && numbers->size() != 3))
    return wrong(
        Text::tr("--at %1: give X,Y in metres, or X,Y,YAW with the yaw in degrees, for example 1.5,-2,90.")
            .arg(text(args)));
  PlaceAt place{{(*numbers)[0], (*numbers)[1]}, {}};
  if (numbers->size() == 3)
    place.yaw_rad = geometry::normalizeAngle(geometry::radiansFromDegrees((*numbers)[2]));
  return place;
}

CommandResult<std::vector<std::string>> tagsIn(const char* option, const std::string& args) {
  auto tags = exchange::tagsOf(args);
  if (tags) return std::move(*tags);
  return wrong(Text::tr("%1 %2: give tags as a,b (%3)").arg(QLatin1String(option), text(args), tags.error()));
}

using Edits = CommandResult<std::vector<exchange::WaypointEdit>>;

/// The change of the selected waypoint.
Edits editOf(const ListedWaypoints& list, const WaypointsArguments& args,
             const std::function<void(map::Waypoint&)>& change) {
  const auto point = chosen(list, args.which.front());
  if (!point) return passOn(point);
  map::Waypoint after = **point;
  change(after);
  return std::vector<exchange::WaypointEdit>{{after.id, **point, after}};
}

void printChanged(const SentWaypoints& sent, const std::vector<exchange::WaypointEdit>& edits,
                  const ListedWaypoints& list, const WaypointsArguments& args) {
  QJsonArray rows;
  for (const exchange::WaypointEdit& edit : edits) {
    const auto kept = sent.kept.find(edit.key);
    const map::Waypoint& point = kept != sent.kept.end() ? kept->second
                                 : edit.after            ? *edit.after
                                                         : *edit.before;
    rows << exchange::waypointJson(point, list.mapId());
    if (!args.json)
      printLine(QStringLiteral("%1  %2").arg(words::plainName(point.id), words::plainName(point.name)));
  }
  if (!args.json) return;
  const bool one = rows.size() == 1 && edits.front().after;
  one ? printJson(rows.first().toObject()) : printJson(rows);
}

/// The common part of these commands, given the change.
CommandResult<int> change(RobotCommand& command, const WaypointsArguments& args,
                          const std::function<Edits(const ListedWaypoints&)>& editsOf) {
  const auto list = listWaypoints(command, args.map, Use::Changing);
  if (!list) return passOn(list);
  Edits edits = editsOf(*list);
  if (!edits) return passOn(edits);
  const bool deletes =
      std::any_of(edits->begin(), edits->end(), [](const auto& edit) { return !edit.after; });
  if (const QString stays = exchange::notRemovedReason(list->store->keeps()); deletes && !stays.isEmpty())
    return list->robot->failure(kRobotError, stays);
  const bool tags = std::any_of(edits->begin(), edits->end(),
                                [](const auto& edit) { return edit.after && !edit.after->tags.empty(); });
  if (tags && !list->store->keeps().tags)
    return list->robot->failure(kRobotError, Text::tr("Waypoints of this robot cannot have tags."));
  edits = fitted(*list, std::move(*edits));
  for (const exchange::WaypointEdit& edit : *edits) {
    const QString why = edit.after ? exchange::notKeptReason(edit.before, *edit.after) : QString();
    if (!why.isEmpty()) return wrong(why);
  }
  if (args.dry_run) {
    const exchange::MergedEdits together = exchange::merged(*edits, exchange::itemsOf(list->stored.points));
    command.report(QStringLiteral("waypoints"), previewReport(*list, together));
    printPreview(*list, together, args.json);
    return kDone;
  }
  const auto sent = sendWaypoints(*list, *edits, args.go_on ? AtFailure::GoOn : AtFailure::Stop);
  if (!sent) return passOn(sent);
  command.report(QStringLiteral("waypoints"), sentReport(*sent, list->mapId()));
  if (sent->complete()) {
    printChanged(*sent, *edits, *list, args);
    return kDone;
  }
  if (edits->size() > 1) args.json ? printJson(sentJson(*sent, list->mapId())) : printSent(*sent);
  const bool of_the_request =
      edits->size() == 1 && sent->conflicts.empty() && sent->steps.front().outcome.failure;
  return list->robot->failure(
      of_the_request ? list->robot->exitCodeHere(*sent->steps.front().outcome.failure) : sent->exitCode(),
      sent->sentence());
}

CommandResult<int> waypointsCreate(RobotCommand& command, const WaypointsArguments& args) {
  const auto place = placeAt(args.at);
  if (!place) return passOn(place);
  const auto tags = tagsIn("--tags", args.tags);
  if (!tags) return passOn(tags);
  return change(command, args, [&](const ListedWaypoints&) -> Edits {
    map::Waypoint point;
    point.name = args.name;
    point.position_m = place->position_m;
    point.yaw_rad = place->yaw_rad;
    point.tags = *tags;
    return std::vector<exchange::WaypointEdit>{{exchange::freshKey(), std::nullopt, point}};
  });
}

CommandResult<int> waypointsRename(RobotCommand& command, const WaypointsArguments& args) {
  return change(command, args, [&](const ListedWaypoints& list) {
    return editOf(list, args, [&](map::Waypoint& point) { point.name = args.name; });
  });
}

CommandResult<int> waypointsMove(RobotCommand& command, const WaypointsArguments& args) {
  const auto place = placeAt(args.at);
  if (!place) return passOn(place);
  return change(command, args, [&](const ListedWaypoints& list) {
    return editOf(list, args, [&](map::Waypoint& point) {
      point.position_m = place->position_m;
      if (place->yaw_rad) point.yaw_rad = place->yaw_rad;
    });
  });
}

CommandResult<int> waypointsTag(RobotCommand& command, const WaypointsArguments& args) {
  const auto tags = tagsIn("--set", args.tags), added = tagsIn("--add", args.added_tags),
             removed = tagsIn("--remove", args.removed_tags);
  for (const auto* read : {&tags, &added, &removed}) {
    if (!*read) return passOn(*read);
  }
  const bool partly = !added->empty() || !removed->empty();
  if (int(!tags->empty()) + int(args.no_tags) + int(partly) != 1)
    return wrong(Text::tr("Which tags? Pass --set a,b, or --clear, or --add and --remove."));
  for (const std::string& tag : *added) {
    if (std::find(removed->begin(), removed->end(), tag) != removed->end())
      return wrong(Text::tr("The tag %1 cannot be both added and removed.").arg(text(tag)));
  }
  return change(command, args, [&](const ListedWaypoints& list) {
    return editOf(list, args, [&](map::Waypoint& point) {
      if (!tags->empty() || args.no_tags) point.tags = *tags;
      for (const std::string& tag : *removed) std::erase(point.tags, tag);
      for (const std::string& tag : *added) {
        if (std::find(point.tags.begin(), point.tags.end(), tag) == point.tags.end())
          point.tags.push_back(tag);
      }
    });
  });
}

CommandResult<int> waypointsDelete(RobotCommand& command, const WaypointsArguments& args) {
  if (!args.yes && !args.dry_run)
    return wrong(Text::tr("Deleting waypoints cannot be undone. Pass --yes to delete them."));
  return change(command, args, [&](const ListedWaypoints& list) -> Edits {
    std::vector<exchange::WaypointEdit> edits;
    for (const std::string& word : args.which) {
      const auto point = chosen(list, word);
      if (!point) return passOn(point);
      const bool is_new = std::none_of(edits.begin(), edits.end(), [&](const exchange::WaypointEdit& edit) {
        return edit.key == (*point)->id;
      });
      if (is_new) edits.push_back({(*point)->id, **point, std::nullopt});
    }
    return edits;
  });
}
CommandResult<int> notAll(const ListedWaypoints& list, const SentWaypoints& sent) {
  const int code = sent.exitCode();
  const bool stopped = code == kRobotError && sent.failure;
  return list.robot->failure(stopped ? list.robot->exitCodeHere(*sent.failure) : code, sent.sentence());
}

/// Sends the changes, or only shows them, and reports the result.
CommandResult<int> carryOut(RobotCommand& command, const ListedWaypoints& list,
                            const std::vector<exchange::WaypointEdit>& edits,
                            const WaypointsArguments& args) {
  if (args.dry_run) {
    const exchange::MergedEdits together = exchange::merged(edits, exchange::itemsOf(list.stored.points));
    command.report(QStringLiteral("waypoints"), previewReport(list, together));
    printPreview(list, together, args.json);
    if (together.conflicts.empty()) return kDone;
    return notAll(list, SentWaypoints{{}, together.conflicts, {}, {}});
  }
  const auto sent = sendWaypoints(list, edits, args.go_on ? AtFailure::GoOn : AtFailure::Stop);
  if (!sent) return passOn(sent);
  command.report(QStringLiteral("waypoints"), sentReport(*sent, list.mapId()));
  args.json ? printJson(sentJson(*sent, list.mapId())) : printSent(*sent);
  if (!args.json && sent->steps.empty() && sent->conflicts.empty())
    printLine(Text::tr("There is nothing to change."));
  if (sent->complete()) return kDone;
  return notAll(list, *sent);
}

/// The changes that the file requires to the present waypoints.
CommandResult<std::vector<exchange::WaypointEdit>> wantedEdits(const ListedWaypoints& list,
                                                               exchange::WantedList wanted,
                                                               const WaypointsArguments& args,
                                                               exchange::Others others) {
  const exchange::WaypointItems kept = exchange::itemsOf(list.stored.points);
  exchange::knowByPlace(wanted.points, kept);
  wanted.notes << exchange::nameNameless(wanted.points, kept);
  wanted.notes.removeAll(QString());
  // As one: of several only the first would be printed.
  if (!wanted.notes.isEmpty())
    list.robot->addRemark(words::about(oneLine(inputCalled(args.file), 200), words::paragraph(wanted.notes)));
  auto edits = exchange::editsFor(kept, wanted.points, others);
  if (!edits) return wrong(words::about(inputCalled(args.file), edits.error()));
  return fitted(list, std::move(*edits));
}

/// Warnings about the list as the plan makes it; says what cannot be checked.
DoubtsAhead doubtsAhead(const ListedWaypoints& list, const std::vector<exchange::WaypointEdit>& edits,
                        std::optional<double> radius_m) {
  exchange::WaypointItems items = exchange::itemsOf(list.stored.points);
  for (const exchange::WaypointEdit& edit : edits) {
    edit.after ? void(items.insert_or_assign(edit.key, *edit.after)) : void(items.erase(edit.key));
  }
  std::vector<map::Waypoint> points;
  for (auto& [key, point] : items) points.push_back(std::move(point));
  const DoubtfulWaypoints doubtful = doubtsOf(list, points, radius_m);
  if (!doubtful.untold.isEmpty()) list.robot->addRemark(doubtful.untold);
  DoubtsAhead ahead;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!doubtful.of[i].empty()) ahead.push_back({points[i].id, points[i].name, doubtful.of[i]});
  }
  return ahead;
}

CommandResult<int> waypointsImport(RobotCommand& command, const WaypointsArguments& args) {
  const exchange::WantedFile wanted = readWantedFile(args.file, args.format, args.angles);
  if (!wanted) return wrong(wanted.error());
  const auto list = listWaypoints(command, args.map, Use::Changing);
  if (!list) return passOn(list);
  const auto edits = wantedEdits(*list, *wanted, args, exchange::Others::Stay);
  if (!edits) return passOn(edits);
  return carryOut(command, *list, *edits, args);
}

CommandResult<int> waypointsPlan(RobotCommand& command, const WaypointsArguments& args) {
  const QString output = text(args.output);
  if (!output.isEmpty()) {
    if (const auto why = notCreatedReason(output, args.force)) return wrong(*why);
  }
  const auto radius_m = radiusFrom(args.radius);
  if (!radius_m) return wrong(radius_m.error());
  const QString printed = args.json ? QStringLiteral("-") : QString();
  if (const auto why = notTogetherReason({output, text(args.report), printed})) return sharedOutput(*why);
  const exchange::WantedFile wanted = readWantedFile(args.file, args.format, args.angles);
  if (!wanted) return wrong(wanted.error());
  const auto list = listWaypoints(command, args.map, Use::Changing);
  if (!list) return passOn(list);
  const auto edits = wantedEdits(*list, *wanted, args, exchange::Others::Go);
  if (!edits) return passOn(edits);
  if (!output.isEmpty()) {
    const exchange::WaypointPlan plan{list->robot->session().robot().address(), list->mapId(),
                                      exchange::itemsOf(list->stored.points), *edits};
    const QByteArray bytes = exchange::planBytes(plan, callsOf(*list, *edits));
    if (const auto trouble = disk::writeFile(args.output, bytes.toStdString(), existingBy(args.force)))
      return wrong(sentences::wordsOf(disk::notWritten(*trouble)));
  }
  const DoubtsAhead doubts = doubtsAhead(*list, *edits, *radius_m);
  command.report(QStringLiteral("waypoints"), previewReport(*list, {*edits, {}}, doubts));
  if (!isStandardOutput(output)) printPreview(*list, {*edits, {}}, args.json, doubts);
  return kDone;
}

CommandResult<int> waypointsApply(RobotCommand& command, const WaypointsArguments& args) {
  const QString file = inputCalled(args.file);
  // A plan contains its base and the changes.
  constexpr std::size_t kMost = 4 * exchange::kMaxWantedBytes;
  const auto bytes = bytesOf(args.file, kMost);
  if (!bytes)
    return wrong(Text::tr("%1 cannot be read: %2.").arg(file, sentences::wordsOf(bytes.error().cause)));
  if (bytes->size() > kMost) return wrong(Text::tr("%1 is larger than 256 MiB.").arg(file));
  auto plan = exchange::planFromBytes(*bytes);
  if (!plan) return wrong(words::about(file, plan.error()));
  const auto list = listWaypoints(command, args.map.empty() ? plan->map : args.map, Use::Changing);
  if (!list) return passOn(list);
  const QString address = list->robot->session().robot().address();
  if (!args.force && (address != plan->robot || list->mapId() != plan->map))
    return wrong(Text::tr("%1 was made for the map %2 of %3. Pass --force to apply it to the map %4 of %5.")
                     .arg(file, text(plan->map), plan->robot, text(list->mapId()), address));
  plan->edits = fitted(*list, std::move(plan->edits));
  const auto edits = exchange::withoutCreated(*plan, exchange::itemsOf(list->stored.points));
  const exchange::WaypointItems now = exchange::itemsOf(list->stored.points);
  const auto deletes =
      std::size_t(std::count_if(edits.begin(), edits.end(), [&](const exchange::WaypointEdit& edit) {
        return !edit.after && now.contains(edit.key);  // what is gone already is no loss
      }));
  const std::size_t there = list->stored.points.size();
  if (!args.yes && !args.dry_run && 2 * deletes > there)
    return wrong(Text::tr("%1 deletes %2 of the %3 waypoints of the map %4. Pass --yes to apply it.")
                     .arg(file, QString::number(deletes), QString::number(there), text(list->mapId())));
  return carryOut(command, *list, edits, args);
}

struct WaypointCommand {
  const char* name;
  QString about;
  CommandResult<int> (*run)(RobotCommand&, const WaypointsArguments&);
};

std::vector<WaypointCommand> waypointCommands() {
  return {{"list", Text::tr("List the waypoints of a map"), waypointsList},
          {"get", Text::tr("Show one waypoint"), waypointsGet},
          {"create", Text::tr("Add a waypoint"), waypointsCreate},
          {"rename", Text::tr("Rename a waypoint"), waypointsRename},
          {"move", Text::tr("Move or turn a waypoint"), waypointsMove},
          {"tag", Text::tr("Change the tags of a waypoint"), waypointsTag},
          {"delete", Text::tr("Delete waypoints (--yes)"), waypointsDelete},
          {"import", Text::tr("Add and update the waypoints listed in a file; others stay"), waypointsImport},
          {"export", Text::tr("Write all waypoints of a map as GeoJSON or CSV"), waypointsExport},
          {"plan", Text::tr("Work out the changes that make the waypoints match a file; sends nothing"),
           waypointsPlan},
          {"apply", Text::tr("Carry out a plan, merged with changes that others have made since"),
           waypointsApply}};
}

/// Adds the options of a command.
void addWaypointOptions(const std::string& name, CLI::App& command, WaypointsArguments& args) {
  const auto is = [&](auto... names) { return ((name == names) || ...); };
  const std::string which = help(Text::tr("Its id, or its name if no other waypoint has it"));
  if (is("get", "rename", "move", "tag"))
    // A single value: a list would also take the name after it.
    command
        .add_option_function<std::string>(
            "id", [&args](const std::string& id) { args.which = {id}; }, which)
        ->required();
  if (is("delete")) command.add_option("ids", args.which, help(Text::tr("Their ids, or names")))->required();
  if (is("create", "rename")) command.add_option("name", args.name, help(Text::tr("New name")))->required();
  if (is("create", "move"))
    command
        .add_option("--at", args.at,
                    help(Text::tr("X,Y or X,Y,YAW in metres of the map and degrees, counter-clockwise")))
        ->required();
  if (is("create")) command.add_option("--tags", args.tags, help(Text::tr("Tags: a,b")));
  if (is("tag")) {
    command.add_option("--set", args.tags, help(Text::tr("Exactly these tags: a,b")));
    command.add_option("--add", args.added_tags, help(Text::tr("Add these tags: a,b")));
    command.add_option("--remove", args.removed_tags, help(Text::tr("Remove these tags: a,b")));
    command.add_flag("--clear", args.no_tags, help(Text::tr("Remove all tags")));
  }
  if (is("delete"))
    command.add_flag("--yes", args.yes, help(Text::tr("Required: deleting cannot be undone")));
  if (is("apply"))
    command.add_flag("--yes", args.yes, help(Text::tr("Even if more waypoints are deleted than kept")));
  if (is("import", "plan"))
    command
        .add_option(
            "file", args.file,
            help(Text::tr("F.geojson, F.csv or F.yaml: a list of places or poses; - is the standard input")))
        ->required();
  if (is("apply"))
    command
        .add_option("file", args.file,
                    help(Text::tr("The output of mapwright waypoints plan -o; - is the standard input")))
        ->required();
  if (is("export"))
    command
        .add_option("-o,--output", args.output,
                    help(Text::tr("F.geojson or F.csv; - is the standard output")))
        ->required();
  if (is("plan"))
    command.add_option(
        "-o,--output", args.output,
        help(Text::tr("Where to write the plan for mapwright waypoints apply; - is the standard output")));
  if (is("list"))
    command.add_flag("--warnings", args.warnings,
                     help(Text::tr("Also show possible mistakes: in a wall, outside the map, "
                                   "near a wall, duplicate name, zero quaternion")));
  if (is("list", "plan"))
    command.add_option("--radius", args.radius,
                       help(Text::tr("Warn of walls that are closer than this, in metres; by "
                                     "default taken from the robot's footprint")));
  if (is("export"))
    command.add_option("--format", args.format,
                       help(Text::tr("csv or geojson, if the file name does not say")));
  if (is("import", "plan")) {
    command.add_option("--format", args.format,
                       help(Text::tr("csv, geojson or yaml, if the file name does not say")));
    command.add_option("--angles", args.angles,
                       help(Text::tr("degrees or radians, for headings whose name has no unit; by default "
                                     "radians unless one is more than a full turn")));
  }
  if (is("export", "plan")) addForce(command, args.force);
  if (is("apply"))
    command.add_flag("--force", args.force,
                     help(Text::tr("Apply it even to a map that the plan was not made for")));
  if (is("import", "apply", "delete")) {
    CLI::Option* const stop =
        command.add_flag("--stop-at-failure", args.stop_at_failure,
                         help(Text::tr("Stop after the first request that fails (default)")));
    command
        .add_flag("--go-on", args.go_on,
                  help(Text::tr("Send the remaining ones anyway, unless the connection is lost")))
        ->excludes(stop);
  }
  if (!is("list", "get", "export", "plan"))
    command.add_flag("--dry-run", args.dry_run, help(Text::tr("Print the changes without sending anything")));
  if (!is("export")) addJson(command, args.json);
}

}  // namespace

void addWaypoints(Commands& commands) {
  const auto args = std::make_shared<WaypointsArguments>();
  CLI::App* const waypoints = commands.program().add_subcommand(
      "waypoints", help(Text::tr("The waypoints of a map: list, change, import, export, plan, apply")));
  waypoints->require_subcommand(1);
  for (const WaypointCommand& one : waypointCommands()) {
    CLI::App* const command = addReading(
        commands, *waypoints, one.name, one.about,
        Text::tr("Robot address, map.yaml, picture or folder (or MAPWRIGHT_ROBOT)"), args, one.run);
    command->add_option(
        "--map", args->map,
        help(Text::tr("Id of a stored map (see mapwright maps list); by default the current one")));
    addWaypointOptions(one.name, *command, *args);
  }
  addCarry(commands, *waypoints, CarriedKind::Waypoints);
}

}  // namespace mapwright::app
