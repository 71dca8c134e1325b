#include "app/maps.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonObject>

#include "app/exit_code.h"
#include "app/map_diff.h"
#include "app/map_facts.h"
#include "app/map_region.h"
#include "app/maps_command.h"
#include "app/one_line.h"
#include "app/output_paths.h"
#include "app/report.h"
#include "app/robot_access.h"
#include "app/robot_factory.h"
#include "app/table.h"
#include "disk/file_error.h"
#include "disk/written_file.h"
#include "grids/export_grid.h"
#include "jobs/export_map.h"
#include "robot/address.h"
#include "sentences/fault_sentence.h"
#include "sentences/plural.h"
#include "session/lacks_picture.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

class MapsText {
  Q_DECLARE_TR_FUNCTIONS(Maps)
};

using words::text;

QStringList rowOf(const map::CatalogueEntry& row) {
  const QString version = row.is_archived   ? MapsText::tr("archived")
                          : row.map_version ? QStringLiteral("v%1").arg(*row.map_version)
                                            : text(row.state);
  return {row.is_current ? QStringLiteral("*") : QStringLiteral(" "), text(map::toText(row.key)),
          version.isEmpty() ? QStringLiteral("-") : version,
          dateText(row.modified_s ? row.modified_s : row.created_s), words::plainName(row.name)};
}

/// NaN when it is no number.
double resolutionOf(const MapsWords& words) {
  bool ok = false;
  const double value = text(words.resolution).toDouble(&ok);
  return words.resolution.empty() ? 0.05 : ok && std::isfinite(value) ? value : std::nan("");
}

/// Whether an operand of `diff` is a file or address of its own, not a map of `robot`.
bool standsAlone(const QString& operand, const QString& robot) {
  if (operand.contains(QLatin1Char('/')) || knownAddresses().isAddress(operand)) return true;
  // An address, refused because of the part before its @: maps have no such names.
  if (robot.isEmpty() && operand.contains(QLatin1Char('@')) && !QFileInfo(operand).isFile()) return true;
  // In a folder of maps their names are ids.
  const auto folder = knownAddresses().parse(robot);
  if (folder && !folder->path.isEmpty() && QFileInfo(folder->path + QLatin1Char('/') + operand).isFile()) {
    return false;
  }
  const QStringList kinds{QStringLiteral("yaml"), QStringLiteral("yml"), QStringLiteral("png"),
                          QStringLiteral("pgm"), QStringLiteral("bmp")};
  // A file that happens to have the name of one of the robot's maps is not that map.
  return kinds.contains(QFileInfo(operand).suffix().toLower()) ||
         (robot.isEmpty() && QFileInfo(operand).isFile());
}

/// Why --resolution and --origin would have no effect on what the command reads.
std::optional<QString> whyNoPlaceIn(const MapsWords& words) {
  if (words.resolution.empty() && words.origin.empty()) return std::nullopt;
  const bool diff = !words.first.empty();
  const std::vector<std::string> operands =
      diff ? std::vector{words.first, words.second} : std::vector{words.id};
  std::optional<QString> why;
  for (const std::string& operand : operands) {
    if (operand == "submaps" && words.origin.empty()) return std::nullopt;
    const bool other = diff && standsAlone(text(operand), text(words.robot));
    why = whyNoPlace(text(other ? operand : words.robot), words.resolution, words.origin);
    if (!why) return std::nullopt;
  }
  return why;
}

using Opened = CommandResult<MapReading*>;
Opened openRobot(MapsCommand& command, const QString& address, const MapsWords& words,
                 MapReading::Purpose purpose = MapReading::Purpose::Maps) {
  if (const auto why = whyNoPlaceIn(words)) return tl::make_unexpected(CommandFailure{kUsage, *why});
  const auto access = RobotAccess::read(words.access, text(words.robot));
  if (!words.resolution.empty() && !(resolutionOf(words) > 0)) {
    return tl::make_unexpected(
        CommandFailure{kUsage, MapsText::tr("--resolution %1: give metres per cell, for example 0.05.")
                                   .arg(text(words.resolution))});
  }
  if (!access) return tl::make_unexpected(CommandFailure{kUsage, access.error()});
  return command.open(placedFile(address, words.resolution, words.origin), access->forAddress(address),
                      purpose);
}

MapReading::Purpose purposeOf(const std::string& id) {
  return id == "submaps" ? MapReading::Purpose::Submaps : MapReading::Purpose::Maps;
}

/// A command's frame.
template <typename Command>
int run(const MapsWords& words, int& argc, char** argv, Command command) {
  return MapsCommand(words.timeout_s, text(words.report)).run(argc, argv, command);
}

}  // namespace

int mapsList(const MapsWords& words, int& argc, char** argv) {
  return run(words, argc, argv, [&](MapsCommand& command) -> CommandResult<int> {
    auto robot = openRobot(command, text(words.robot), words);
    if (!robot) return tl::make_unexpected(robot.error());
    const auto rows = (*robot)->catalogue();
    if (!rows) return tl::make_unexpected(rows.error());
    if (words.json) {
      QJsonArray list;
      for (const map::CatalogueEntry& row : **rows) list << entryJson(row);
      printJson(list);
      return kDone;
    }
    if ((*rows)->empty()) {
      std::printf("%s\n", qUtf8Printable(MapsText::tr("There are no maps.")));
      return kDone;
    }
    std::vector<QStringList> table{{QStringLiteral(" "), MapsText::tr("ID"), MapsText::tr("VERSION"),
                                    MapsText::tr("DATE"), MapsText::tr("NAME")}};
    for (const map::CatalogueEntry& row : **rows) table.push_back(rowOf(row));
    printTable(table);
    return kDone;
  });
}

int mapsCurrent(const MapsWords& words, int& argc, char** argv) {
  return run(words, argc, argv, [&](MapsCommand& command) -> CommandResult<int> {
    auto robot = openRobot(command, text(words.robot), words);
    if (!robot) return tl::make_unexpected(robot.error());
    const auto rows = (*robot)->catalogue();
    if (!rows) return tl::make_unexpected(rows.error());
    const map::CatalogueEntry* const current = (*robot)->session().catalogue().current();
    if (!current) {
      return tl::make_unexpected(CommandFailure{
          kRobotError, MapsText::tr("%1: none of its maps is the current one.").arg(text(words.robot))});
    }
    if (words.json) {
      printJson(entryJson(*current));
    } else {
      std::printf("%s  %s\n", qUtf8Printable(words::plainName(map::toText(current->key))),
                  qUtf8Printable(words::plainName(current->name)));
    }
    return kDone;
  });
}

int mapsShow(const MapsWords& words, int& argc, char** argv) {
  return run(words, argc, argv, [&](MapsCommand& command) -> CommandResult<int> {
    auto robot = openRobot(command, text(words.robot), words, purposeOf(words.id));
    if (!robot) return tl::make_unexpected(robot.error());
    const bool stored = !words.id.empty() && words.id != "live" && words.id != "submaps";
    if (stored) {  // the catalogue has its dates and versions
      if (const auto rows = (*robot)->catalogue(); !rows) return tl::make_unexpected(rows.error());
    }
    const auto placed = (*robot)->map(text(words.id), resolutionOf(words));
    if (!placed && session::lacksPicture((*robot)->session().wholeMap()))
      return showWithoutPicture(**robot, words.json);
    if (!placed) return tl::make_unexpected(placed.error());
    session::Session& session = (*robot)->session();
    const map::WholeMap& shown = session.wholeMap().shown();
    const map::CatalogueEntry* const row = session.catalogue().find(shown.key);
    const QString id = words.id == "submaps" ? text(words.id) : text(map::toText(shown.key));
    QJsonObject json =
        row ? entryJson(*row)
            : QJsonObject{{QStringLiteral("id"), id}, {QStringLiteral("name"), (*robot)->nameOfMap()}};
    json[QStringLiteral("grid")] = gridJson(placed->reference);
    json[QStringLiteral("overlays")] = int(shown.overlays.size());
    json[QStringLiteral("trajectories")] = int(shown.trajectories.size());
    json[QStringLiteral("landmarks")] = int(shown.landmarks.size());
    json[QStringLiteral("waypoints")] = pointsJson(session.wholeMap().waypoints().points);
    if (shown.display_rotation_rad) json[QStringLiteral("display_rotation")] = *shown.display_rotation_rad;
    if (words.json) {
      printJson(json);
      return kDone;
    }
    const map::GridReference& grid = placed->reference;
    std::vector<QStringList> table{
        {MapsText::tr("id"), id},
        {MapsText::tr("name"), words::plainName((*robot)->nameOfMap())},
        {MapsText::tr("cells"), QStringLiteral("%1 x %2").arg(grid.width).arg(grid.height)},
        {MapsText::tr("resolution"), MapsText::tr("%1 m").arg(grid.resolution_m)},
        {MapsText::tr("origin"), MapsText::tr("x %1 m, y %2 m, yaw %3 rad (lower left corner)")
                                     .arg(grid.origin.x_m)
                                     .arg(grid.origin.y_m)
                                     .arg(grid.origin.yaw_rad)},
        {MapsText::tr("extent"), MapsText::tr("%1 m x %2 m")
                                     .arg(grid.width * grid.resolution_m, 0, 'f', 2)
                                     .arg(grid.height * grid.resolution_m, 0, 'f', 2)}};
    if (row) addRow(table, *row);
    table.push_back({MapsText::tr("overlays"), QString::number(shown.overlays.size())});
    addPoints(table, session.wholeMap().waypoints().points);
    printTable(table);
    return kDone;
  });
}

int mapsExport(const MapsWords& words, int& argc, char** argv) {
  return run(words, argc, argv, [&](MapsCommand& command) -> CommandResult<int> {
    const auto wrong = [](const QString& sentence) {
      return tl::make_unexpected(CommandFailure{kUsage, sentence});
    };
    const QString output = text(words.output);
    const QString suffix = QFileInfo(output).suffix().toLower();
    const bool printed = isStandardOutput(output);
    QString format = !words.format.empty() ? text(words.format) : printed ? QStringLiteral("png") : suffix;
    if (format == QLatin1String("yaml") || format == QLatin1String("yml")) format = QStringLiteral("pgm");
    if (format != QLatin1String("png") && format != QLatin1String("pgm")) {
      return wrong(MapsText::tr("--output %1: the name must end in .png, or in .pgm or .yaml to get both of "
                                "these; or pass --format png or pgm.")
                       .arg(output));
    }
    const bool names_png = suffix == QLatin1String("png");
    const bool names_pgm = suffix == QLatin1String("pgm") || suffix.startsWith(QLatin1Char('y'));
    if (!words.format.empty() && (format == QLatin1String("png") ? names_pgm : names_png)) {
      return wrong(MapsText::tr("--output %1 contradicts --format %2.").arg(output, text(words.format)));
    }
    if (printed && (format != QLatin1String("png") || words.world_file)) {
      return wrong(
          MapsText::tr("Only a single PNG can be written to the standard output (--output %1).").arg(output));
    }
    if (const auto why = whyNotWritable(output)) return wrong(*why);
    if (const auto why = whyNotTogether({output, text(words.report)})) return wrong(*why);
    std::optional<map::GridRegion> region;
    const bool live = words.id.empty() || words.id == "live";
    if (!words.region.empty()) {
      const auto typed = gridRegionFrom(words.region);
      if (!typed) return wrong(typed.error());
      if (!live)
        return wrong(MapsText::tr("--region only works with the live map, not with %1.").arg(text(words.id)));
      region = *typed;
    }
    auto robot = openRobot(command, text(words.robot), words, purposeOf(words.id));
    if (!robot) return tl::make_unexpected(robot.error());
    // An export always means the whole map, whatever its size.
    const bool by_part = region || (live && givesMapWhenAsked((*robot)->session().robot()));
    const auto placed = by_part ? (*robot)->part(region) : (*robot)->map(text(words.id), resolutionOf(words));
    if (!placed) return tl::make_unexpected(placed.error());
    const bool png = format == QLatin1String("png");
    const jobs::ExportRequest request{jobs::WholeMapExport{placed->cells, placed->reference},
                                      png ? jobs::ExportFormat::MapPicture : jobs::ExportFormat::MapServer,
                                      output, words.world_file};
    const QStringList outputs = jobs::exportedFiles(output, request.format, words.world_file);
    const auto why = overOwnSource(outputs, (*robot)->sourceFiles());
    if (why && !words.force) return wrong(*why);
    const jobs::ExportResult written = jobs::exportMap(request, nullptr);
    if (!written.error.isEmpty()) return wrong(written.error);
    if (!printed && !isStandardOutput(text(words.report))) {
      const map::GridReference& grid = placed->reference;
      std::printf("%s\n",
                  qUtf8Printable(MapsText::tr("%1: %2 x %3 cells of %4 m")
                                     .arg(oneLine(output), QString::number(grid.width),
                                          QString::number(grid.height), QString::number(grid.resolution_m))));
    }
    return kDone;
  });
}

int mapsDiff(const MapsWords& words, int& argc, char** argv) {
  return run(words, argc, argv, [&](MapsCommand& command) -> CommandResult<int> {
    const QString printed = words.json ? QStringLiteral("-") : QString();
    auto why_not = words.diff_picture.empty() ? std::nullopt : whyNotWritable(text(words.diff_picture));
    if (!why_not) why_not = whyNotTogether({text(words.diff_picture), text(words.report), printed});
    if (why_not) return tl::make_unexpected(CommandFailure{kUsage, *why_not});
    // Before the first one is read, which may take long.
    for (const QString& operand : {text(words.first), text(words.second)}) {
      const auto parsed = knownAddresses().parse(operand);
      if (!parsed && standsAlone(operand, text(words.robot)))
        return tl::make_unexpected(CommandFailure{kUsage, parsed.error()});
    }
    std::vector<std::string> sources;
    std::vector<render::PlacedGrid> maps;
    for (const std::string& word : {words.first, words.second}) {
      const QString operand = text(word);
      const bool alone = standsAlone(operand, text(words.robot));
      auto robot = openRobot(command, alone ? operand : text(words.robot), words,
                             alone ? MapReading::Purpose::Maps : purposeOf(word));
      if (!robot) return tl::make_unexpected(robot.error());
      const auto placed = (*robot)->map(alone ? QString() : operand, resolutionOf(words));
      if (!placed) return tl::make_unexpected(placed.error());
      maps.push_back(*placed);
      for (std::string& file : (*robot)->sourceFiles()) sources.push_back(std::move(file));
    }
    const QString picture = text(words.diff_picture);
    if (const auto why = overOwnSource({picture}, sources); why && !words.force) {
      return tl::make_unexpected(CommandFailure{kUsage, *why});
    }
    const auto diff = diffMaps(maps[0], maps[1], picture);
    if (!diff) return tl::make_unexpected(CommandFailure{kUsage, diff.error()});
    if (isStandardOutput(picture) || isStandardOutput(text(words.report)))
      return diff->same() ? kDone : kIncomplete;
    using render::Difference;
    const auto cells = [&](Difference what) { return qint64(diff->cells[std::size_t(what)]); };
    const std::vector<std::pair<const char*, Difference>> kinds{
        {"appeared", Difference::Appeared},    {"vanished", Difference::Vanished},
        {"only_first", Difference::OnlyFirst}, {"only_second", Difference::OnlySecond},
        {"same_free", Difference::SameFree},   {"same_occupied", Difference::SameOccupied}};
    if (words.json) {
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
        table.push_back({name, MapsText::tr("%1 cells", nullptr, sentences::formOf(count)).arg(count),
                         MapsText::tr("%1 m²").arg(double(count) * diff->cell_area_m2, 0, 'f', 4)});
      };
      row(MapsText::tr("occupied in the second only"), cells(Difference::Appeared));
      row(MapsText::tr("occupied in the first only"), cells(Difference::Vanished));
      row(MapsText::tr("known in the first only"), cells(Difference::OnlyFirst));
      row(MapsText::tr("known in the second only"), cells(Difference::OnlySecond));
      row(MapsText::tr("same state, different gray level"), diff->levels_differ);
      row(MapsText::tr("free in both"), cells(Difference::SameFree));
      row(MapsText::tr("occupied in both"), cells(Difference::SameOccupied));
      printTable(table);
      const QString outcome = !diff->same() ? MapsText::tr("The maps differ.")
                              : command.complete()
                                  ? MapsText::tr("The maps are the same.")
                                  : MapsText::tr("The parts of the maps that could be read are the same.");
      std::printf("%s\n", qUtf8Printable(outcome));
    }
    return diff->same() ? kDone : kIncomplete;
  });
}

}  // namespace mapwright::app
