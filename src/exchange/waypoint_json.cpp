#include "exchange/waypoint_json.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <QCoreApplication>
#include <QRegularExpression>

#include "exchange/waypoint_reading.h"
#include "json/json_text.h"
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

/// The first name that an object in it has twice.
std::optional<std::string> nameTwiceIn(const json::JsonValue& value) {
  std::set<std::string> met;
  for (const json::JsonValue& child : value.children()) {
    if (value.isObject() && !met.insert(child.key()).second) return child.key();
    if (auto deeper = nameTwiceIn(child)) return deeper;
  }
  return std::nullopt;
}

/// How a coordinate system is called: as GeoJSON of 2008 had it, or as a text. Empty = it is not said.
QString systemOf(const QJsonObject& object) {
  const QJsonValue crs = object.value(QLatin1String("crs"));
  if (crs.isString()) return crs.toString();
  const QJsonObject properties = crs.toObject().value(QLatin1String("properties")).toObject();
  for (const char* member : {"name", "href", "code"}) {
    const QJsonValue value = properties.value(QLatin1String(member));
    if (value.isString()) return value.toString();
    if (value.isDouble()) return QStringLiteral("EPSG:%1").arg(value.toInteger());
  }
  return crs.isObject() ? QStringLiteral("?") : QString();
}

/// Longitude and latitude, by the code or the name: EPSG 4000 to 4999 and some newer ones, CRS84.
bool isInDegrees(const QString& system) {
  const QString name = system.toUpper();
  for (const char* known : {"CRS84", "CRS:84", "CRS83", "CRS27", "WGS84", "WGS 84", "WGS_1984"}) {
    if (name.contains(QLatin1String(known)) && !name.contains(QLatin1String("UTM"))) return true;
  }
  if (!name.contains(QLatin1String("EPSG"))) return false;
  const int code = name.mid(name.lastIndexOf(QRegularExpression(QStringLiteral("[:/]"))) + 1).toInt();
  return (code >= 4000 && code < 5000) || code == 6318 || code == 7844 || code == 9000 || code == 9057;
}

tl::unexpected<QString> wrongSystem(const QString& system) {
  return wrong(
      WaypointJsonText::tr("Its coordinates are longitude and latitude (crs %1), not metres of the map. "
                           "If they are metres, remove \"crs\" from the file.")
          .arg(words::plainName(system.left(80))));
}

/// One FeatureCollection.
class GeoJsonReading {
 public:
  explicit GeoJsonReading(AngleUnit angles) : reading_(angles) {}

  WantedFile read(const QJsonObject& collection, const QJsonArray& features) {
    const QString system = systemOf(collection);
    if (isInDegrees(system)) return wrongSystem(system);
    for (const QString& member : collection.keys()) {
      if (!QStringList{QStringLiteral("type"), QStringLiteral("features"), QStringLiteral("crs")}.contains(
              member))
        reading_.leaveOut(member.toStdString());
    }
    for (const QJsonValue& feature : features) is_graph_ = is_graph_ || isEdge(feature.toObject());
    int row = 0;
    for (const QJsonValue& value : features) {
      if (auto read = readFeature(++row, value.toObject()); !read)
        return wrong(WaypointJsonText::tr("Feature %1: %2").arg(QString::number(row), read.error()));
      if (reading_.size() > kMaxWanted)
        return wrong(WaypointJsonText::tr("It has more than %1 waypoints.").arg(kMaxWanted));
    }
    const bool says_metres = framed_ == reading_.size();
    if (!says_metres && isTooClose())
      return wrong(WaypointJsonText::tr(
          "Its coordinates look like longitude and latitude: as metres, all points would lie within 5 cm."));
    addNotes(system, says_metres);
    return std::move(reading_).finish();
  }

 private:
  static bool isEdge(const QJsonObject& feature) {
    const QJsonObject properties = feature.value(QLatin1String("properties")).toObject();
    return properties.contains(QLatin1String("startid")) && properties.contains(QLatin1String("endid"));
  }

  tl::expected<void, QString> readFeature(int row, const QJsonObject& feature) {
    const QJsonObject geometry = feature.value(QLatin1String("geometry")).toObject();
    const QJsonObject given = feature.value(QLatin1String("properties")).toObject();
    if (geometry.value(QLatin1String("type")).toString() != QLatin1String("Point")) {
      ++(isEdge(feature) ? edges_ : left_out_);
      return {};
    }
    for (const QJsonObject& object : {feature, geometry, given}) {
      if (const QString system = systemOf(object); isInDegrees(system)) return wrongSystem(system);
    }
    for (const QString& member : feature.keys()) {
      if (!QStringList{QStringLiteral("type"), QStringLiteral("geometry"), QStringLiteral("properties"),
                       QStringLiteral("id")}
               .contains(member))
        reading_.leaveOut(member.toStdString());
    }
    const QJsonArray coordinates = geometry.value(QLatin1String("coordinates")).toArray();
    const auto at_m = placeOf(coordinates.at(0), coordinates.at(1));
    if (!at_m) return wrong(WaypointJsonText::tr("the coordinates are not two numbers."));
    if (coordinates.size() > 3) reading_.leaveOut("coordinates[3]");
    const FileValue properties = fromJson(given);
    FileValue entry{FileValue::Kind::Map};
    bool other_place = false, has_id = false, framed = false;
    for (const auto& member : properties.members) {
      const FieldMeaning meaning = meaningOf(member.first);
      const auto number = member.second.asNumber();
      framed = framed || (meaning == FieldMeaning::Frame && !member.second.isBlank());
      has_id = has_id || (meaning == FieldMeaning::Id && !member.second.isBlank());
      if (meaning == FieldMeaning::X || meaning == FieldMeaning::Y) {
        // The coordinates count.
        const double here = meaning == FieldMeaning::X ? at_m->x() : at_m->y();
        other_place = other_place || !number || std::abs(*number - here) > 1e-6;
      } else if (meaning != FieldMeaning::Z || coordinates.size() < 3) {
        entry.members.push_back(member);
      }
    }
    if (const QJsonValue id = feature.value(QLatin1String("id")); !has_id && isThere(id)) {
      entry.members.emplace_back("id", fromJson(id));
    } else if (has_id && isThere(id) && !isSameId(id, properties)) {
      reading_.leaveOut("id");
    }
    entry.members.emplace_back("x", FileValue::ofNumber(at_m->x()));
    entry.members.emplace_back("y", FileValue::ofNumber(at_m->y()));
    if (coordinates.size() > 2) entry.members.emplace_back("z", fromJson(coordinates.at(2)));
    std::string node;
    if (is_graph_) {
      // Ids of a graph are its own: a waypoint of the map that has the same one is another.
      std::erase_if(entry.members, [&](const auto& member) {
        const bool is_id = meaningOf(member.first) == FieldMeaning::Id;
        if (is_id) node = "Node " + member.second.text;
        return is_id;
      });
      nodes_ += node.empty() ? 0 : 1;
    }
    if (auto read = reading_.add(row, entry, node); !read) return read;
    framed_ += framed ? 1 : 0;
    other_places_ += other_place ? 1 : 0;
    lowest_ = lowest_.cwiseMin(*at_m);
    highest_ = highest_.cwiseMax(*at_m);
    return {};
  }

  static bool isSameId(const QJsonValue& id, const FileValue& properties) {
    const auto said = idOf(id);
    return std::any_of(properties.members.begin(), properties.members.end(), [&](const auto& member) {
      return meaningOf(member.first) == FieldMeaning::Id && said == member.second.text;
    });
  }

  /// Farther from the origin than from each other, and all within the range of degrees: 0.05 degrees are 5
  /// km.
  bool isTooClose() const {
    constexpr double kClose = 0.05;
    if (reading_.size() < 2) return false;
    const double extent = (highest_ - lowest_).maxCoeff();
    const Eigen::Vector2d far = lowest_.cwiseAbs().cwiseMax(highest_.cwiseAbs());
    return extent > 1e-6 && extent < kClose && far.x() <= 180 && far.y() <= 90 && far.minCoeff() > 1;
  }

  void addNotes(const QString& system, bool says_metres) {
    if (!system.isEmpty())
      reading_.addRemark(WaypointJsonText::tr("Its coordinates (crs %1) were read as metres of the map.")
                             .arg(words::plainName(system.left(80))));
    if (system.isEmpty() && !says_metres)
      reading_.addRemark(
          WaypointJsonText::tr("It does not say that its coordinates are metres of the map (\"frame\": "
                               "\"map\"); they were read so."));
    const auto count = [&](qint64 number, const QString& sentence) {
      if (number > 0) reading_.addRemark(sentences::counted(sentence, number));
    };
    count(other_places_,
          WaypointJsonText::tr(
              "x and y of %1 features are not where their coordinates are. The coordinates count.", nullptr,
              sentences::formOf(other_places_)));
    count(nodes_, WaypointJsonText::tr("%1 nodes of a route graph were named by their ids.", nullptr,
                                       sentences::formOf(nodes_)));
    count(edges_, WaypointJsonText::tr("%1 edges of a route graph were left out.", nullptr,
                                       sentences::formOf(edges_)));
    count(left_out_, WaypointJsonText::tr("%1 features that are not points were left out.", nullptr,
                                          sentences::formOf(left_out_)));
  }

  WaypointReading reading_;
  bool is_graph_ = false;
  std::size_t framed_ = 0;
  qint64 left_out_ = 0, edges_ = 0, nodes_ = 0, other_places_ = 0;
  Eigen::Vector2d lowest_ = Eigen::Vector2d::Constant(HUGE_VAL),
                  highest_ = Eigen::Vector2d::Constant(-HUGE_VAL);
};

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

WantedFile wantedFromGeoJson(const QJsonObject& collection, AngleUnit angles) {
  const QJsonValue features = collection.value(QLatin1String("features"));
  if (collection.value(QLatin1String("type")).toString() != QLatin1String("FeatureCollection") ||
      !features.isArray())
    return wrong(WaypointJsonText::tr("It is not a GeoJSON FeatureCollection."));
  return GeoJsonReading(angles).read(collection, features.toArray());
}

WantedFile wantedFromGeoJson(std::string_view bytes, AngleUnit angles) {
  const auto json = jsonOf(bytes);
  if (!json) return wrong(json.error());
  return wantedFromGeoJson(json->object(), angles);
}

tl::expected<QJsonDocument, QString> jsonOf(std::string_view bytes) {
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  QJsonParseError error;
  QJsonDocument document =
      QJsonDocument::fromJson(QByteArray::fromRawData(bytes.data(), qsizetype(bytes.size())), &error);
  if (error.error != QJsonParseError::NoError)
    return wrong(
        WaypointJsonText::tr("It is not JSON (%1, byte %2).").arg(error.errorString()).arg(error.offset));
  // Programs disagree about which of them counts.
  if (const auto json = json::JsonText::read(std::string(bytes))) {
    if (const auto twice = nameTwiceIn(json->root()))
      return wrong(WaypointJsonText::tr("A \"%1\" is written twice. Remove one of them.")
                       .arg(words::plainName(text(*twice))));
  }
  return document;
}

}  // namespace mapwright::exchange
