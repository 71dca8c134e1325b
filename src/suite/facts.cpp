#include "suite/facts.h"

#include <cmath>

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "compare/picture_view.h"
#include "exchange/waypoint_json.h"
#include "words/text.h"

namespace mapwright::suite {
namespace {

struct FactsText {
  Q_DECLARE_TR_FUNCTIONS(FactsText)
};

using words::text;

constexpr int kVersion = 1;  // of the files

/// A tenth of a millimetre: what robots compute anew differs by less.
double rounded(double value) {
  if (!(std::abs(value) < 1e11)) return value;  // a double has no such decimals there
  const double fine = std::round(value * 1e4) / 1e4;
  return fine == 0 ? 0 : fine;  // no -0
}

QJsonArray poseJson(const geometry::Pose2& pose) {
  return {rounded(pose.x_m), rounded(pose.y_m), rounded(pose.yaw_rad)};
}

std::optional<geometry::Pose2> poseFrom(const QJsonValue& value) {
  const QJsonArray numbers = value.toArray();
  if (numbers.size() != 3) return std::nullopt;
  return geometry::Pose2{numbers[0].toDouble(), numbers[1].toDouble(), numbers[2].toDouble()};
}

QJsonValue boxJson(const geometry::WorldRect& box) {
  if (box.empty()) return {};
  return QJsonArray{rounded(box.min_x), rounded(box.min_y), rounded(box.width()), rounded(box.height())};
}

geometry::WorldRect boxFrom(const QJsonValue& value) {
  const QJsonArray numbers = value.toArray();
  geometry::WorldRect box;
  if (numbers.size() != 4) return box;
  const Eigen::Vector2d low(numbers[0].toDouble(), numbers[1].toDouble());
  box.extend(low);
  box.extend(low + Eigen::Vector2d(numbers[2].toDouble(), numbers[3].toDouble()));
  return box;
}

std::optional<int> intFrom(const QJsonValue& value) {
  return value.isDouble() ? std::optional(value.toInt()) : std::nullopt;
}

QJsonValue orNull(const std::optional<int>& value) { return value ? QJsonValue(*value) : QJsonValue(); }

QJsonArray pointJson(const Eigen::Vector2d& point) { return {rounded(point.x()), rounded(point.y())}; }

QJsonObject geometryJson(const map::OverlayFeature& feature) {
  QJsonArray coordinates;
  const char* type = "Polygon";
  const auto pointsOf = [](const std::vector<Eigen::Vector2d>& part) {
    QJsonArray points;
    for (const Eigen::Vector2d& point : part) points << pointJson(point);
    return points;
  };
  if (feature.shape == map::OverlayShape::Polygon) {
    for (const auto& ring : feature.parts) {
      QJsonArray points = pointsOf(ring);
      if (!ring.empty() && ring.front() != ring.back()) points << pointJson(ring.front());
      coordinates << points;
    }
  } else if (!feature.parts.empty()) {
    const bool point = feature.shape == map::OverlayShape::Point;
    type = point ? "Point" : "LineString";
    coordinates = pointsOf(feature.parts.front());
    if (point && !feature.parts.front().empty()) coordinates = pointJson(feature.parts.front().front());
  }
  return {{QStringLiteral("type"), QLatin1String(type)}, {QStringLiteral("coordinates"), coordinates}};
}

QJsonObject featureJson(const map::OverlayFeature& feature) {
  const char* const type = feature.shape == map::OverlayShape::Point  ? "type"
                           : feature.shape == map::OverlayShape::Line ? "lineType"
                                                                      : "regionType";
  QJsonObject properties{{QLatin1String(type), feature.type}};
  if (!feature.name.empty()) properties[QStringLiteral("name")] = text(feature.name);
  if (feature.yaw_rad)
    properties[QStringLiteral("yaw")] = rounded(geometry::degreesFromRadians(*feature.yaw_rad));
  QJsonObject json{{QStringLiteral("type"), QStringLiteral("Feature")},
                   {QStringLiteral("geometry"), geometryJson(feature)},
                   {QStringLiteral("properties"), properties}};
  if (!feature.id.empty()) json[QStringLiteral("id")] = text(feature.id);
  return json;
}

QJsonObject mapJson(const MapFact& map) {
  QJsonObject json{{QStringLiteral("id"), text(map.id)},
                   {QStringLiteral("name"), text(map.name)},
                   {QStringLiteral("uid"), text(map.uid)},
                   {QStringLiteral("version"), orNull(map.version)},
                   {QStringLiteral("overlays_version"), orNull(map.overlays_version)},
                   {QStringLiteral("cells"), text(map.cells)},
                   {QStringLiteral("box"), boxJson(map.box)}};
  if (map.origin) json[QStringLiteral("origin")] = poseJson(*map.origin);
  if (map.resolution_m) json[QStringLiteral("resolution")] = *map.resolution_m;
  if (map.blocks.known()) json[QStringLiteral("blocks")] = jsonOf(map.blocks);
  return json;
}

MapFact mapFrom(const QJsonObject& json) {
  const auto word = [&](const char* name) { return json[QLatin1String(name)].toString().toStdString(); };
  const QJsonValue resolution = json[QLatin1String("resolution")];
  return {word("id"),
          word("name"),
          word("uid"),
          intFrom(json[QLatin1String("version")]),
          intFrom(json[QLatin1String("overlays_version")]),
          word("cells"),
          boxFrom(json[QLatin1String("box")]),
          poseFrom(json[QLatin1String("origin")]),
          resolution.isDouble() ? std::optional(resolution.toDouble()) : std::nullopt,
          blocksFrom(json[QLatin1String("blocks")])};
}

QJsonObject closuresJson(const ClosuresFact& closures) {
  return {{QStringLiteral("inter"), qint64(closures.inter)},
          {QStringLiteral("largest_m"), closures.largest_m ? QJsonValue(*closures.largest_m) : QJsonValue()}};
}

QJsonObject disagreementJson(const DisagreementFact& disagreement) {
  return {{QStringLiteral("tolerance_cells"), disagreement.tolerance_cells},
          {QStringLiteral("occupied_cells"), qint64(disagreement.occupied_cells)},
          {QStringLiteral("contradicted_cells"), qint64(disagreement.contradicted_cells)},
          {QStringLiteral("share"), disagreement.share()}};
}

void readFigures(const QJsonObject& json, Facts& facts) {
  if (const QJsonValue value = json[QLatin1String("closures")]; value.isObject()) {
    const QJsonValue largest = value[QLatin1String("largest_m")];
    facts.closures = ClosuresFact{value[QLatin1String("inter")].toInteger(),
                                  largest.isDouble() ? std::optional(largest.toDouble()) : std::nullopt};
  }
  if (const QJsonValue value = json[QLatin1String("disagreement")]; value.isObject())
    facts.disagreement = DisagreementFact{value[QLatin1String("tolerance_cells")].toInt(),
                                          value[QLatin1String("occupied_cells")].toInteger(),
                                          value[QLatin1String("contradicted_cells")].toInteger()};
}

std::optional<map::SubmapId> idFrom(const QString& word) {
  const auto split = word.lastIndexOf(QLatin1Char('-'));
  bool ok_trajectory = false, ok_index = false;
  const map::SubmapId id{word.left(split).toInt(&ok_trajectory), word.mid(split + 1).toInt(&ok_index)};
  return split > 0 && ok_trajectory && ok_index ? std::optional(id) : std::nullopt;
}

}  // namespace

std::string overlaysText(const std::vector<map::OverlayFeature>& features) {
  QJsonArray list;
  for (const map::OverlayFeature& feature : features) list << featureJson(feature);
  return QJsonDocument(QJsonObject{{QStringLiteral("type"), QStringLiteral("FeatureCollection")},
                                   {QStringLiteral("features"), list}})
      .toJson(QJsonDocument::Compact)
      .toStdString();
}

std::string sumOf(const QString& path) {
  QFile file(path);
  QCryptographicHash sum(QCryptographicHash::Sha256);
  return file.open(QIODevice::ReadOnly) && sum.addData(&file) ? sum.result().toHex().toStdString()
                                                              : std::string();
}

QByteArray factsBytes(const Facts& facts) {
  QJsonObject json{{QStringLiteral("mapwright"), QStringLiteral("facts")},
                   {QStringLiteral("version"), kVersion}};
  if (!facts.picture.empty()) json[QStringLiteral("picture")] = text(facts.picture);
  if (facts.view) json[QStringLiteral("view")] = compare::jsonOf(*facts.view);
  if (!facts.theme.empty()) {
    QJsonArray layers;
    for (const std::string& layer : facts.layers) layers << text(layer);
    json[QStringLiteral("drawn")] =
        QJsonObject{{QStringLiteral("theme"), text(facts.theme)}, {QStringLiteral("layers"), layers}};
  }
  if (facts.map) json[QStringLiteral("map")] = mapJson(*facts.map);
  if (!facts.session.empty()) json[QStringLiteral("session")] = text(facts.session);
  QJsonArray submaps;
  for (const auto& [id, submap] : facts.submaps) {
    submaps << QJsonObject{{QStringLiteral("id"), text(map::toText(id))},
                           {QStringLiteral("version"), submap.version},
                           {QStringLiteral("pose"), poseJson(submap.pose)},
                           {QStringLiteral("box"), boxJson(submap.box)}};
  }
  if (!submaps.isEmpty()) json[QStringLiteral("submaps")] = submaps;
  if (!facts.overlays.empty())
    json[QStringLiteral("overlays")] =
        QJsonDocument::fromJson(QByteArray::fromStdString(facts.overlays)).object();
  if (!facts.waypoints.empty()) {
    std::vector<map::Waypoint> points = facts.waypoints;
    for (map::Waypoint& point : points) {
      point.position_m = {rounded(point.position_m.x()), rounded(point.position_m.y())};
      if (point.yaw_rad) point.yaw_rad = rounded(*point.yaw_rad);
    }
    json[QStringLiteral("waypoints")] =
        exchange::waypointsJson(points, facts.map ? facts.map->id : std::string());
  }
  if (facts.robot) json[QStringLiteral("robot")] = poseJson(*facts.robot);
  if (facts.closures) json[QStringLiteral("closures")] = closuresJson(*facts.closures);
  if (facts.disagreement) json[QStringLiteral("disagreement")] = disagreementJson(*facts.disagreement);
  QJsonObject stamps;
  for (const auto& [topic, stamp_s] : facts.stamps) stamps[text(topic)] = stamp_s;
  if (!stamps.isEmpty()) json[QStringLiteral("stamps")] = stamps;
  return QJsonDocument(json).toJson();
}

tl::expected<Facts, QString> factsFrom(const QByteArray& bytes) {
  QJsonParseError error;
  const QJsonObject json = QJsonDocument::fromJson(bytes, &error).object();
  if (json[QLatin1String("mapwright")].toString() != QLatin1String("facts"))
    return tl::make_unexpected(FactsText::tr("It does not hold the facts of a picture."));
  if (const QJsonValue version = json[QLatin1String("version")]; version != kVersion)
    return tl::make_unexpected(
        FactsText::tr("Its version is %1; only version %2 can be read.")
            .arg(version.isDouble() ? QString::number(version.toDouble()) : FactsText::tr("unknown"))
            .arg(kVersion));
  Facts facts;
  facts.picture = json[QLatin1String("picture")].toString().toStdString();
  facts.view = compare::viewOf(json);
  const QJsonObject drawn = json[QLatin1String("drawn")].toObject();
  facts.theme = drawn[QLatin1String("theme")].toString().toStdString();
  for (const QJsonValue& layer : drawn[QLatin1String("layers")].toArray())
    facts.layers.push_back(layer.toString().toStdString());
  if (const QJsonValue map = json[QLatin1String("map")]; map.isObject()) facts.map = mapFrom(map.toObject());
  facts.session = json[QLatin1String("session")].toString().toStdString();
  for (const QJsonValue& value : json[QLatin1String("submaps")].toArray()) {
    const QJsonObject submap = value.toObject();
    const auto id = idFrom(submap[QLatin1String("id")].toString());
    const auto pose = poseFrom(submap[QLatin1String("pose")]);
    if (!id || !pose) return tl::make_unexpected(FactsText::tr("A submap in it cannot be read."));
    facts.submaps[*id] = {submap[QLatin1String("version")].toInt(), *pose,
                          boxFrom(submap[QLatin1String("box")])};
  }
  if (const QJsonValue overlays = json[QLatin1String("overlays")]; overlays.isObject())
    facts.overlays = QJsonDocument(overlays.toObject()).toJson(QJsonDocument::Compact).toStdString();
  for (const QJsonValue& value : json[QLatin1String("waypoints")].toArray()) {
    const auto point = exchange::waypointFromJson(value.toObject());
    if (!point)
      return tl::make_unexpected(FactsText::tr("A waypoint in it cannot be read: %1").arg(point.error()));
    facts.waypoints.push_back(*point);
  }
  facts.robot = poseFrom(json[QLatin1String("robot")]);
  readFigures(json, facts);
  const QJsonObject stamps = json[QLatin1String("stamps")].toObject();
  for (auto it = stamps.begin(); it != stamps.end(); ++it)
    facts.stamps[it.key().toStdString()] = it.value().toDouble();
  return facts;
}

}  // namespace mapwright::suite
