#include "exchange/waypoint_json.h"

#include <cmath>

#include <QCoreApplication>
#include <QJsonDocument>

#include "sentences/plural.h"
#include "words/qt_plain.h"
#include "words/text.h"

namespace mapwright::exchange {
namespace {

class WaypointJsonText {
  Q_DECLARE_TR_FUNCTIONS(WaypointJson)
};

using words::text;

/// Numbers are valid ids as long as no digit is lost.
std::optional<std::string> idOf(const QJsonValue& value) {
  if (value.isUndefined() || value.isNull()) return std::string();
  if (value.isString()) return value.toString().toStdString();
  constexpr double kExact = 9007199254740992.0;
  const double number = value.toDouble(NAN);
  if (!(std::abs(number) <= kExact) || number != std::floor(number)) return std::nullopt;
  return std::to_string(value.toInteger());
}

bool isThere(const QJsonValue& value) { return !value.isUndefined() && !value.isNull(); }

std::optional<Eigen::Vector2d> placeOf(const QJsonValue& x, const QJsonValue& y) {
  if (!x.isDouble() || !y.isDouble()) return std::nullopt;
  const Eigen::Vector2d place(x.toDouble(), y.toDouble());
  return place.allFinite() ? std::optional(place) : std::nullopt;
}

}  // namespace

std::string frameOf(const map::Waypoint& point) {
  static const std::string kMap = "map";
  if (point.source.find("\"frame_id\"") == std::string::npos) return kMap;
  const QJsonObject source = QJsonDocument::fromJson(QByteArray::fromStdString(point.source)).object();
  QString frame = source.value(QLatin1String("frame_id")).toString();
  if (frame.startsWith(QLatin1Char('/'))) frame.remove(0, 1);
  return frame.isEmpty() ? kMap : frame.toStdString();
}

QJsonObject waypointJson(const map::Waypoint& point, const std::string& map) {
  QJsonArray tags;
  for (const std::string& tag : point.tags) tags << text(tag);
  QJsonObject row{{QStringLiteral("id"), text(point.id)},
                  {QStringLiteral("name"), text(point.name)},
                  {QStringLiteral("x"), point.position_m.x()},
                  {QStringLiteral("y"), point.position_m.y()},
                  {QStringLiteral("yaw_rad"), point.yaw_rad ? QJsonValue(*point.yaw_rad) : QJsonValue()},
                  {QStringLiteral("tags"), tags},
                  {QStringLiteral("frame"), text(frameOf(point))},
                  {QStringLiteral("map"), text(map)}};
  if (!point.type.empty()) row[QStringLiteral("type")] = text(point.type);
  return row;
}

QJsonArray waypointsJson(const std::vector<map::Waypoint>& points, const std::string& map) {
  QJsonArray rows;
  for (const map::Waypoint& point : points) rows << waypointJson(point, map);
  return rows;
}

tl::expected<WantedWaypoint, QString> wantedFromJson(const QJsonObject& row) {
  WantedWaypoint wanted;
  const auto id = idOf(row.value(QLatin1String("id")));
  if (!id) return wrong(WaypointJsonText::tr("the id is not a text."));
  wanted.id = *id;
  for (const auto& [member, into] : {std::pair{"name", &wanted.name}, {"type", &wanted.type}}) {
    const QJsonValue value = row.value(QLatin1String(member));
    if (!isThere(value)) continue;
    if (!value.isString()) return wrong(WaypointJsonText::tr("%1 is not a text.").arg(QLatin1String(member)));
    *into = value.toString().toStdString();
  }
  const QJsonValue frame = row.value(QLatin1String("frame"));
  if (isThere(frame) && frame.toString() != QLatin1String("map")) {
    wanted.frame = frame.toString().toStdString();
    if (wanted.id.empty() || wanted.frame.empty())
      return wrong(WaypointJsonText::tr("the frame is \"%1\". Only \"map\" is supported.")
                       .arg(words::plainName(frame.toString().left(80))));
  }
  const QJsonValue x = row.value(QLatin1String("x")), y = row.value(QLatin1String("y"));
  if (isThere(x) || isThere(y)) {
    wanted.position_m = placeOf(x, y);
    if (!wanted.position_m) return wrong(WaypointJsonText::tr("x and y are not two numbers."));
  }
  const QJsonValue yaw = row.value(QLatin1String("yaw_rad"));
  if (!yaw.isUndefined()) {
    if (!yaw.isNull() && !(yaw.isDouble() && std::isfinite(yaw.toDouble())))
      return wrong(WaypointJsonText::tr("yaw_rad is not a number."));
    wanted.yaw_rad.emplace();
    if (!yaw.isNull()) *wanted.yaw_rad = yaw.toDouble();
  }
  const QJsonValue tags = row.value(QLatin1String("tags"));
  if (isThere(tags)) {
    if (!tags.isArray()) return wrong(WaypointJsonText::tr("the tags are not a list of texts."));
    wanted.tags.emplace();
    for (const QJsonValue& tag : tags.toArray()) {
      if (!tag.isString()) return wrong(WaypointJsonText::tr("the tags are not a list of texts."));
      wanted.tags->push_back(tag.toString().toStdString());
    }
  }
  return wanted;
}

tl::expected<map::Waypoint, QString> waypointFromJson(const QJsonObject& row) {
  auto wanted = wantedFromJson(row);
  if (!wanted) return tl::make_unexpected(wanted.error());
  if (!wanted->position_m) return wrong(WaypointJsonText::tr("x and y are not two numbers."));
  map::Waypoint point;
  point.id = wanted->id;
  point.name = wanted->name.value_or("");
  point.type = wanted->type.value_or("");
  point.position_m = *wanted->position_m;
  point.yaw_rad = wanted->yaw_rad.value_or(std::nullopt);
  point.tags = wanted->tags.value_or(std::vector<std::string>());
  return point;
}

QByteArray waypointsGeoJson(const std::vector<map::Waypoint>& points, const std::string& map) {
  QJsonArray features;
  for (const map::Waypoint& point : points) {
    features << QJsonObject{
        {QStringLiteral("type"), QStringLiteral("Feature")},
        {QStringLiteral("geometry"), QJsonObject{{QStringLiteral("type"), QStringLiteral("Point")},
                                                 {QStringLiteral("coordinates"),
                                                  QJsonArray{point.position_m.x(), point.position_m.y()}}}},
        {QStringLiteral("properties"), waypointJson(point, map)}};
  }
  const QJsonObject collection{{QStringLiteral("type"), QStringLiteral("FeatureCollection")},
                               {QStringLiteral("features"), features}};
  return words::escapedJson(QJsonDocument(collection).toJson());
}

WantedFile wantedFromGeoJson(std::string_view bytes) {
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  QJsonParseError error;
  const QJsonDocument document =
      QJsonDocument::fromJson(QByteArray::fromRawData(bytes.data(), qsizetype(bytes.size())), &error);
  if (error.error != QJsonParseError::NoError)
    return wrong(
        WaypointJsonText::tr("It is not JSON (%1, byte %2).").arg(error.errorString()).arg(error.offset));
  const QJsonObject collection = document.object();
  const QJsonValue features = collection.value(QLatin1String("features"));
  if (collection.value(QLatin1String("type")).toString() != QLatin1String("FeatureCollection") ||
      !features.isArray())
    return wrong(WaypointJsonText::tr("It is not a GeoJSON FeatureCollection."));
  WantedList list;
  int left_out = 0, row = 0;
  for (const QJsonValue& value : features.toArray()) {
    ++row;
    const QJsonObject feature = value.toObject(),
                      geometry = feature.value(QLatin1String("geometry")).toObject();
    if (geometry.value(QLatin1String("type")).toString() != QLatin1String("Point")) {
      ++left_out;
      continue;
    }
    if (list.points.size() == kMaxWanted)
      return wrong(WaypointJsonText::tr("It has more than %1 waypoints.").arg(kMaxWanted));
    const auto inRow = [&](const QString& why) {
      return wrong(WaypointJsonText::tr("Feature %1: %2").arg(QString::number(row), why));
    };
    QJsonObject properties = feature.value(QLatin1String("properties")).toObject();
    const QJsonArray place = geometry.value(QLatin1String("coordinates")).toArray();
    properties[QStringLiteral("x")] = place.at(0);
    properties[QStringLiteral("y")] = place.at(1);
    if (!isThere(properties.value(QLatin1String("id"))))
      properties[QStringLiteral("id")] = feature.value(QLatin1String("id"));
    if (!placeOf(place.at(0), place.at(1)))
      return inRow(WaypointJsonText::tr("the coordinates are not two numbers."));
    auto wanted = wantedFromJson(properties);
    if (!wanted) return inRow(wanted.error());
    wanted->row = row;
    list.points.push_back(std::move(*wanted));
  }
  if (left_out > 0)
    list.notes << sentences::counted(WaypointJsonText::tr("%1 features that are not points were left out.",
                                                          nullptr, sentences::formOf(left_out)),
                                     left_out);
  return list;
}

}  // namespace mapwright::exchange
