#include "app/map_facts.h"

#include <cstdio>

#include <QCoreApplication>
#include <QDateTime>
#include <QJsonObject>

#include "app/exit_code.h"
#include "app/output_paths.h"
#include "app/report.h"
#include "app/table.h"
#include "sentences/fault_sentence.h"
#include "sentences/problem_sentence.h"
#include "sentences/subject_name.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::app {
namespace {

class MapFactsText {
  Q_DECLARE_TR_FUNCTIONS(Maps)
};

using words::text;

}  // namespace

QString dateText(std::optional<double> epoch_s) {
  if (!epoch_s || !(*epoch_s > 0) || *epoch_s > 4e11) return QStringLiteral("-");
  return QDateTime::fromMSecsSinceEpoch(qint64(*epoch_s * 1000)).toString(QStringLiteral("yyyy-MM-dd hh:mm"));
}

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
        {MapFactsText::tr("point"),
         MapFactsText::tr("%1 %2  x %3 m, y %4 m%5")
             .arg(words::plainName(point.id), words::plainName(point.name),
                  QString::number(point.position_m.x()), QString::number(point.position_m.y()),
                  point.yaw_rad ? MapFactsText::tr(", yaw %1 rad").arg(*point.yaw_rad) : QString())});
  }
}

void addRow(std::vector<QStringList>& table, const map::CatalogueEntry& row) {
  table.push_back({MapFactsText::tr("date"), dateText(row.modified_s ? row.modified_s : row.created_s)});
  table.push_back(
      {MapFactsText::tr("current"), row.is_current ? MapFactsText::tr("yes") : MapFactsText::tr("no")});
}

CommandResult<int> showWithoutPicture(MapReading& reading, bool json_wanted) {
  session::Session& session = reading.session();
  const session::MapSlot& slot = session.wholeMap();
  const map::MapKey key = slot.key();
  const CommandFailure no_picture = reading.failure(kIncomplete, sentences::sentenceOf(slot.remark()));
  std::vector<map::Waypoint> points;
  if (robot::WaypointSource* const source = session.robot().waypointSource()) {
    auto told = reading.ask<map::WaypointList>(
        [&](robot::OutcomeTo<map::WaypointList> reply) { return source->waypoints(key, std::move(reply)); });
    if (!told) return tl::make_unexpected(reading.failure(told.error()));
    points = std::move(told->points);
    for (const Fault& note : told->notes)
      reading.note(
          QStringLiteral("%1: %2").arg(sentences::nameOf(map::placesOf(key)), sentences::sentenceOf(note)));
  }
  const map::CatalogueEntry* const row = session.catalogue().find(key);
  if (json_wanted) {
    QJsonObject json = row ? entryJson(*row)
                           : QJsonObject{{QStringLiteral("id"), text(map::toText(key))},
                                         {QStringLiteral("name"), slot.name()}};
    json[QStringLiteral("grid")] = QJsonValue();
    json[QStringLiteral("waypoints")] = pointsJson(points);
    printJson(json);
    return tl::make_unexpected(no_picture);
  }
  std::vector<QStringList> table{{MapFactsText::tr("id"), text(map::toText(key))},
                                 {MapFactsText::tr("name"), words::plainName(slot.name().toStdString())},
                                 {MapFactsText::tr("picture"), MapFactsText::tr("none")}};
  if (row) addRow(table, *row);
  addPoints(table, points);
  printTable(table);
  return tl::make_unexpected(no_picture);
}

}  // namespace mapwright::app
