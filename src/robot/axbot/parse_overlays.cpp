#include "robot/axbot/parse_overlays.h"

namespace mapwright::robot::axbot {
namespace {

using map::OverlayFeature;
using map::OverlayShape;
using wire::Json;

constexpr std::string_view kMulti = "Multi";
constexpr int kDeepest = 4;  // nested geometry collections

std::string_view typeOf(const Json& object) {
  std::string_view type;
  return object["type"].get(type) ? std::string_view() : type;
}

/// Everything of a feature except its geometry.
OverlayFeature described(const Json& feature, const Json& properties) {
  OverlayFeature described;
  described.id = wire::text(feature, {"id"});
  if (described.id.empty()) described.id = wire::text(properties, {"id"});
  described.name = wire::text(properties, {"name"});
  return described;
}

class Reader {
 public:
  explicit Reader(std::vector<OverlayFeature>& out) : out_(out) {}

  void readFeature(const Json& feature) {
    const auto geometry = wire::member(feature, {"geometry"});
    if (!geometry) return;
    Json properties = feature;
    if (const auto given = wire::member(feature, {"properties"})) properties = *given;
    readGeometry(*geometry, described(feature, properties), properties, kDeepest);
  }

 private:
  void readGeometry(const Json& geometry, const OverlayFeature& model, const Json& properties, int depth) {
    std::string_view type = typeOf(geometry);
    if (type == "GeometryCollection" && depth > 0) {
      if (const auto parts = wire::list(geometry, {"geometries"})) {
        for (const Json part : *parts) readGeometry(part, model, properties, depth - 1);
      }
      return;
    }
    const auto coordinates = wire::member(geometry, {"coordinates"});
    if (!coordinates) return;
    if (!type.starts_with(kMulti)) {
      add(type, *coordinates, model, properties);
      return;
    }
    type.remove_prefix(kMulti.size());
    wire::JsonList parts;
    if (coordinates->get(parts)) return;
    for (const Json part : parts) add(type, part, model, properties);
  }

  void add(std::string_view type, const Json& coordinates, OverlayFeature feature, const Json& properties) {
    if (type == "Point") {
      const auto at = wire::asPoint(coordinates);
      if (!at) return;
      feature.shape = OverlayShape::Point;
      feature.type = wire::smallInteger(properties, {"type"}).value_or(0);
      if (const auto yaw = wire::number(properties, {"yaw"}))
        feature.yaw_rad = geometry::radiansFromDegrees(*yaw);
      feature.parts.push_back({*at});
    } else if (type == "LineString") {
      feature.shape = OverlayShape::Line;
      feature.type = wire::smallInteger(properties, {"lineType"}).value_or(0);
      feature.parts.push_back(wire::asPolyline(coordinates));
      if (feature.parts[0].size() < 2) return;
    } else if (type == "Polygon") {
      feature.shape = OverlayShape::Polygon;
      feature.type = wire::smallInteger(properties, {"regionType"}).value_or(0);
      wire::JsonList rings;
      if (coordinates.get(rings)) return;
      for (const Json ring : rings) addRing(wire::asPolyline(ring), feature);
      if (feature.parts.empty()) return;
    } else {
      return;
    }
    out_.push_back(std::move(feature));
  }

  static void addRing(std::vector<Eigen::Vector2d> ring, OverlayFeature& feature) {
    if (ring.size() < 3) return;
    if (ring.front() != ring.back()) ring.push_back(Eigen::Vector2d(ring.front()));
    feature.parts.push_back(std::move(ring));
  }

  std::vector<OverlayFeature>& out_;
};

std::optional<std::vector<OverlayFeature>> featuresOf(const Json& overlays) {
  std::vector<OverlayFeature> features;
  Reader reader(features);
  wire::JsonList rows;
  if (!overlays.get(rows)) {  // the features without their collection
    for (const Json row : rows) reader.readFeature(row);
  } else if (const auto list = wire::list(overlays, {"features"})) {
    for (const Json feature : *list) reader.readFeature(feature);
  } else if (overlays.is_object()) {
    reader.readFeature(overlays);
  } else if (!overlays.is_null()) {
    return std::nullopt;
  }
  return features;
}

}  // namespace

std::optional<std::vector<OverlayFeature>> parseOverlays(const Json& overlays) {
  std::string_view text;
  return overlays.get(text) ? featuresOf(overlays) : parseOverlays(text);
}

std::optional<std::vector<OverlayFeature>> parseOverlays(std::string_view geo_json) {
  if (geo_json.find_first_not_of(" \t\r\n") == std::string_view::npos) return std::vector<OverlayFeature>();
  wire::JsonReader reader;
  const auto root = reader.read(geo_json);
  return root ? featuresOf(*root) : std::nullopt;  // a text inside a text is not parsed
}

}  // namespace mapwright::robot::axbot
