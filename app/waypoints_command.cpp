// Lists waypoints and writes them to files.
#include <cstdio>

#include <QCoreApplication>

#include "app/exit_code.h"
#include "app/one_line.h"
#include "app/output_paths.h"
#include "app/table.h"
#include "app/waypoint_file.h"
#include "app/waypoint_list.h"
#include "app/waypoint_warnings.h"
#include "disk/file_error.h"
#include "disk/written_file.h"
#include "exchange/waypoint_json.h"
#include "exchange/waypoint_steps.h"
#include "exchange/waypoint_table.h"
#include "geometry/pose.h"
#include "sentences/fault_sentence.h"
#include "sentences/plural.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

class WaypointsCommandText {
  Q_DECLARE_TR_FUNCTIONS(Waypoints)
};

using words::text;

QString metres(double value) { return QString::number(value, 'f', 3); }

QStringList rowOf(const map::Waypoint& point) {
  return {words::plainName(point.id),
          metres(point.position_m.x()),
          metres(point.position_m.y()),
          point.yaw_rad ? QString::number(geometry::degreesFromRadians(*point.yaw_rad), 'f', 1)
                        : QStringLiteral("-"),
          exchange::tagText(point),
          words::plainName(point.name)};
}

}  // namespace

int waypointsList(const WaypointsWords& words, int& argc, char** argv) {
  return runWaypointsCommand(words, argc, argv, [&](MapsCommand& command) -> CommandResult<int> {
    const auto radius_m = radiusFrom(words.radius);
    if (!radius_m) return tl::make_unexpected(CommandFailure{kUsage, radius_m.error()});
    const auto list = listWaypoints(command, words, words.map, Use::Reading);
    if (!list) return tl::make_unexpected(list.error());
    std::optional<DoubtfulWaypoints> doubtful;
    if (words.warnings) doubtful = doubtsOf(*list, list->stored.points, *radius_m);
    if (doubtful && !doubtful->untold.isEmpty()) list->robot->note(doubtful->untold);
    // The list is complete; the additional data is not.
    const int exit_code = doubtful && !doubtful->looked ? int(kIncomplete) : int(kDone);
    if (words.json) {
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
      std::printf("%s\n", qUtf8Printable(WaypointsCommandText::tr("There are no waypoints.")));
      return exit_code;
    }
    std::vector<QStringList> table{{WaypointsCommandText::tr("ID"), WaypointsCommandText::tr("X (m)"),
                                    WaypointsCommandText::tr("Y (m)"), WaypointsCommandText::tr("YAW (°)"),
                                    WaypointsCommandText::tr("TAGS"), WaypointsCommandText::tr("NAME")}};
    if (doubtful) table.front() << WaypointsCommandText::tr("WARNINGS");
    for (std::size_t i = 0; i < list->stored.points.size(); ++i) {
      table.push_back(rowOf(list->stored.points[i]));
      if (doubtful) table.back() << warningsLine(doubtful->of[i]);
    }
    printTable(table);
    return exit_code;
  });
}

int waypointsGet(const WaypointsWords& words, int& argc, char** argv) {
  return runWaypointsCommand(words, argc, argv, [&](MapsCommand& command) -> CommandResult<int> {
    const auto list = listWaypoints(command, words, words.map, Use::Reading);
    if (!list) return tl::make_unexpected(list.error());
    const auto point = chosen(*list, words.which.front());
    if (!point) return tl::make_unexpected(point.error());
    if (words.json) {
      printJson(exchange::waypointJson(**point, list->mapId()));
      return kDone;
    }
    std::vector<QStringList> table{{WaypointsCommandText::tr("id"), words::plainName((*point)->id)},
                                   {WaypointsCommandText::tr("name"), words::plainName((*point)->name)},
                                   {WaypointsCommandText::tr("place"), exchange::placeText(**point)},
                                   {WaypointsCommandText::tr("tags"), exchange::tagText(**point)}};
    if (!(*point)->type.empty())
      table.push_back({WaypointsCommandText::tr("type"), words::plainName((*point)->type)});
    table.push_back({WaypointsCommandText::tr("map"), words::plainName(list->mapId())});
    printTable(table);
    return kDone;
  });
}

int waypointsExport(const WaypointsWords& words, int& argc, char** argv) {
  return runWaypointsCommand(words, argc, argv, [&](MapsCommand& command) -> CommandResult<int> {
    const auto wrong = [](const QString& sentence) {
      return tl::make_unexpected(CommandFailure{kUsage, sentence});
    };
    const QString output = text(words.output);
    const auto kind = waypointFileKind(words.output, words.format);
    if (!kind) return wrong(kind.error());
    if (const auto why = whyNotWritable(output)) return wrong(*why);
    if (const auto why = whyNotTogether({output, text(words.report)})) return wrong(*why);
    const auto list = listWaypoints(command, words, words.map, Use::Reading);
    if (!list) return tl::make_unexpected(list.error());
    if (const auto why = overOwnSource({output}, waypointSources(words.robot, list->map));
        why && !words.force)
      return wrong(*why);
    const std::string bytes =
        *kind == WaypointFileKind::Csv
            ? exchange::waypointsCsv(list->stored.points, list->mapId())
            : exchange::waypointsGeoJson(list->stored.points, list->mapId()).toStdString();
    if (const auto trouble = disk::writeFile(words.output, bytes))
      return wrong(sentences::wordsOf(disk::notWritten(*trouble)));
    if (!isStandardOutput(output) && !isStandardOutput(text(words.report))) {
      const auto count = qint64(list->stored.points.size());
      std::printf("%s: %s\n", qUtf8Printable(oneLine(output)),
                  qUtf8Printable(sentences::counted(
                      WaypointsCommandText::tr("%1 waypoints", nullptr, sentences::formOf(count)), count)));
    }
    return kDone;
  });
}

}  // namespace mapwright::app
