#include "recorder/layout.h"

#include <charconv>

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "words/text.h"

namespace mapwright::recorder {
namespace {

constexpr std::string_view kSubmaps = "submaps/", kMaps = "maps/", kWaypoints = "waypoints/",
                           kPictures = "pictures/", kFacts = ".json";

using words::text;

std::string encoded(const std::string& id) {
  if (id.empty()) return "-";
  const std::string safe = QByteArray::fromStdString(id).toPercentEncoding().toStdString();
  return safe == "-" ? "%2D" : safe;
}

std::string decoded(std::string_view id) {
  if (id == "-") return {};
  return QByteArray::fromPercentEncoding(QByteArray(id.data(), qsizetype(id.size()))).toStdString();
}

constexpr std::pair<map::MapKind, std::string_view> kKinds[] = {{map::MapKind::Live, "live"},
                                                                {map::MapKind::Stored, "stored"},
                                                                {map::MapKind::Mapping, "mapping"},
                                                                {map::MapKind::File, "file"}};

std::string_view wordOf(map::MapKind kind) {
  for (const auto& [known, word] : kKinds) {
    if (known == kind) return word;
  }
  return "stored";
}

std::string attachmentName(std::string_view folder, const map::MapKey& key, std::string_view suffix) {
  return std::string(folder) + std::string(wordOf(key.kind)) + '/' + encoded(key.id) + std::string(suffix);
}

/// Takes what stands before the next slash.
std::string_view nextPart(std::string_view& rest) {
  const std::size_t slash = rest.find('/');
  const std::string_view part = rest.substr(0, slash);
  rest = slash == std::string_view::npos ? std::string_view() : rest.substr(slash + 1);
  return part;
}

std::optional<std::int32_t> wholeOf(std::string_view part) {
  std::int32_t number = 0;
  const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
  if (error != std::errc() || end != part.data() + part.size()) return std::nullopt;
  return number;
}

QJsonArray jsonOf(const std::vector<Eigen::Vector2d>& line) {
  QJsonArray points;
  for (const Eigen::Vector2d& point : line) points.append(QJsonArray{point.x(), point.y()});
  return points;
}

QJsonArray jsonOf(const std::vector<std::vector<Eigen::Vector2d>>& lines) {
  QJsonArray all;
  for (const auto& line : lines) all.append(jsonOf(line));
  return all;
}

QJsonObject keyed(const map::MapKey& key) {
  const std::string_view word = wordOf(key.kind);
  return {{QStringLiteral("kind"), QString::fromLatin1(word.data(), qsizetype(word.size()))},
          {QStringLiteral("id"), text(key.id)}};
}

QString modeOf(map::CellReading::Mode mode) {
  using Mode = map::CellReading::Mode;
  return mode == Mode::Trinary ? QStringLiteral("trinary")
         : mode == Mode::Scale ? QStringLiteral("scale")
         : mode == Mode::Raw   ? QStringLiteral("raw")
                               : QStringLiteral("picture");
}

QString shapeOf(map::OverlayShape shape) {
  return shape == map::OverlayShape::Point  ? QStringLiteral("point")
         : shape == map::OverlayShape::Line ? QStringLiteral("line")
                                            : QStringLiteral("polygon");
}

QJsonObject jsonOf(const map::Waypoint& point) {
  QJsonObject out{{QStringLiteral("id"), text(point.id)},
                  {QStringLiteral("name"), text(point.name)},
                  {QStringLiteral("type"), text(point.type)},
                  {QStringLiteral("x_m"), point.position_m.x()},
                  {QStringLiteral("y_m"), point.position_m.y()}};
  if (point.yaw_rad) out[QStringLiteral("yaw_rad")] = *point.yaw_rad;
  QJsonArray tags;
  for (const std::string& tag : point.tags) tags.append(text(tag));
  out[QStringLiteral("tags")] = tags;
  if (!point.source.empty()) out[QStringLiteral("source")] = text(point.source);
  return out;
}

QJsonObject jsonOf(const map::OverlayFeature& feature) {
  QJsonObject out{{QStringLiteral("shape"), shapeOf(feature.shape)},
                  {QStringLiteral("type"), feature.type},
                  {QStringLiteral("id"), text(feature.id)},
                  {QStringLiteral("name"), text(feature.name)},
                  {QStringLiteral("parts"), jsonOf(feature.parts)}};
  if (feature.yaw_rad) out[QStringLiteral("yaw_rad")] = *feature.yaw_rad;
  return out;
}

std::string written(const QJsonObject& object) {
  return QJsonDocument(object).toJson(QJsonDocument::Compact).toStdString();
}

}  // namespace

std::string submapName(const map::SubmapKey& key) {
  return std::string(kSubmaps) + encoded(key.uuid) + '/' + std::to_string(key.id.trajectory) + '/' +
         std::to_string(key.id.index) + '/' + std::to_string(key.version);
}

std::optional<map::SubmapKey> submapFrom(std::string_view name) {
  if (!name.starts_with(kSubmaps)) return std::nullopt;
  std::string_view rest = name.substr(kSubmaps.size());
  map::SubmapKey key;
  key.uuid = decoded(nextPart(rest));
  const auto trajectory = wholeOf(nextPart(rest));
  const auto index = wholeOf(nextPart(rest));
  const auto version = wholeOf(rest);
  if (!trajectory || !index || !version) return std::nullopt;
  key.id = {*trajectory, *index};
  key.version = *version;
  return key;
}

std::string mapName(const map::MapKey& key) { return attachmentName(kMaps, key, {}); }
std::string mapFactsName(const map::MapKey& key) { return attachmentName(kMaps, key, kFacts); }
std::string waypointsName(const map::MapKey& key) { return attachmentName(kWaypoints, key, kFacts); }

std::optional<map::MapKey> mapFrom(std::string_view name) {
  if (!name.starts_with(kMaps) || name.ends_with(kFacts)) return std::nullopt;
  std::string_view rest = name.substr(kMaps.size());
  const std::string_view word = nextPart(rest);
  for (const auto& [kind, known] : kKinds) {
    if (known == word && !rest.empty()) return map::MapKey{kind, decoded(rest)};
  }
  return std::nullopt;
}

std::string pictureName(std::string_view url) { return std::string(kPictures) + std::string(url); }

std::string mapFacts(const map::WholeMap& map, bool current, const map::CatalogueEntry& entry) {
  QJsonObject out = keyed(map.key);
  out[QStringLiteral("name")] = text(map.name.empty() ? entry.name : map.name);
  if (!entry.uid.empty()) out[QStringLiteral("uid")] = text(entry.uid);
  if (entry.map_version) out[QStringLiteral("map_version")] = *entry.map_version;
  out[QStringLiteral("current")] = current;
  out[QStringLiteral("grid")] = QJsonObject{{QStringLiteral("width"), map.grid.width},
                                            {QStringLiteral("height"), map.grid.height},
                                            {QStringLiteral("resolution_m"), map.grid.resolution_m},
                                            {QStringLiteral("x_m"), map.grid.origin.x_m},
                                            {QStringLiteral("y_m"), map.grid.origin.y_m},
                                            {QStringLiteral("yaw_rad"), map.grid.origin.yaw_rad}};
  out[QStringLiteral("reading")] =
      QJsonObject{{QStringLiteral("mode"), modeOf(map.reading.mode)},
                  {QStringLiteral("negate"), map.reading.negate},
                  {QStringLiteral("occupied_thresh"), map.reading.occupied_thresh},
                  {QStringLiteral("free_thresh"), map.reading.free_thresh}};
  out[QStringLiteral("fingerprint")] = text(map.fingerprint);
  if (map.display_rotation_rad) out[QStringLiteral("display_rotation_rad")] = *map.display_rotation_rad;
  out[QStringLiteral("trajectories")] = jsonOf(map.trajectories);
  QJsonArray landmarks;
  for (const map::WholeMap::Landmark& landmark : map.landmarks) {
    landmarks.append(QJsonObject{{QStringLiteral("id"), text(landmark.id)},
                                 {QStringLiteral("x_m"), landmark.position_m.x()},
                                 {QStringLiteral("y_m"), landmark.position_m.y()}});
  }
  out[QStringLiteral("landmarks")] = landmarks;
  return written(out);
}

std::string placesText(const map::MapKey& key, const map::WaypointList& places,
                       const std::vector<map::OverlayFeature>& overlays) {
  QJsonObject out = keyed(key);
  QJsonArray points, features;
  for (const map::Waypoint& point : places.points) points.append(jsonOf(point));
  for (const map::OverlayFeature& feature : overlays) features.append(jsonOf(feature));
  out[QStringLiteral("waypoints")] = points;
  out[QStringLiteral("overlays")] = features;
  return written(out);
}

}  // namespace mapwright::recorder
