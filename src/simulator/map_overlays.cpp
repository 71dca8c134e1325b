#include "simulator/map_overlays.h"

#include <array>
#include <numbers>
#include <vector>

#include "simulator/json_shapes.h"
#include "simulator/value_json.h"

namespace mapwright::simulator {
namespace {

using Eigen::Vector2d;

constexpr double kDegrees = 180 / std::numbers::pi;

/// Puts features one after the other.
class Collection {
 public:
  void add(const char* shape, Value coordinates, Value::Object properties, bool with_id = true) {
    Value feature;
    if (with_id) feature.set("id", "65a0000000000000000000" + std::to_string(10 + features_.size()));
    feature.set("type", "Feature");
    feature.set("geometry", Value::Object{{"type", shape}, {"coordinates", std::move(coordinates)}});
    feature.set("properties", std::move(properties));
    features_.push_back(std::move(feature));
  }
  void point(const geometry::Pose2& at, Value::Object properties, bool with_id = true) {
    add("Point", pointOf({at.x_m, at.y_m}), std::move(properties), with_id);
  }
  void line(const std::vector<Vector2d>& points, Value::Object properties) {
    add("LineString", pointsOf(points), std::move(properties));
  }
  void ring(const std::vector<Vector2d>& points, Value::Object properties) {
    add("Polygon", Value::List{pointsOf(points)}, std::move(properties));
  }
  std::string finished() const {
    return toJson(Value::Object{{"type", "FeatureCollection"}, {"features", features_}});
  }

 private:
  Value::List features_;
};

/// A rectangle around a place on the way, in its direction; closed as GeoJSON wants unless `open`.
std::vector<Vector2d> box(const geometry::Pose2& at, double length, double width, bool open = false) {
  std::vector<Vector2d> ring = cornersOf(at, length, width);
  if (!open) ring.push_back(ring.front());
  return ring;
}

Value yawOf(const geometry::Pose2& pose, bool as_text) {
  const Value yaw = fixed(pose.yaw_rad * kDegrees, 2);
  return as_text ? Value(toJson(yaw)) : yaw;
}

}  // namespace

std::string noOverlays() { return Collection().finished(); }

bool isOverlays(std::string_view text) {
  if (text.empty()) return true;
  const std::optional<Value> overlays = fromJson(text);
  return overlays && (*overlays)["features"].as<Value::List>() != nullptr;
}

std::string overlaysAlong(const Scene& scene, int id) {
  Collection all;
  const Trajectory* way = scene.find(id);
  if (way == nullptr) return all.finished();
  const double step = way->drive.length_m() / 40;
  const auto at = [&](int i) { return way->drive.at(step * i); };

  struct PointKind {
    int type;
    const char* name;
  };
  constexpr std::array<PointKind, 14> kPoints{{{9, "Charger"},
                                               {36, "Docking point"},
                                               {6, "Elevator A"},
                                               {10, "Standby"},
                                               {11, "Table 1"},
                                               {11, "餐桌 2"},
                                               {19, "Reception <main>"},
                                               {25, "Waypoint"},
                                               {27, "Exchange"},
                                               {28, "Wait for the elevator"},
                                               {29, "Dispatch"},
                                               {34, "Rack 🏭"},
                                               {3, "Other"},
                                               {77, "Nobody knows"}}};
  int place = 1;
  for (const PointKind& kind : kPoints) {
    const Value type = place % 3 == 0 ? Value(std::to_string(kind.type)) : Value(kind.type);
    Value::Object properties{{"type", type}, {"yaw", yawOf(at(place), place % 2 == 0)}, {"name", kind.name}};
    if (place == 1) properties.emplace_back("dockingPointId", "65a000000000000000000011");
    if (place == 3) properties.emplace_back("deviceIds", Value::List{"el-1", "el-2"});
    all.point(at(place), std::move(properties), place != 7);
    ++place;
  }
  all.point(at(16), {{"type", "37"}, {"barcodeId", "D2_125"}, {"name", ""}, {"yaw", yawOf(at(16), true)}});
  all.point(at(17), {{"type", 39}, {"landmarkId", "landmark_1"}});

  const auto between = [&](int from, int to) {
    std::vector<Vector2d> points;
    for (int i = from; i <= to; ++i) points.push_back(at(i).apply({0, 0}));
    return points;
  };
  all.line(between(1, 3), {{"lineType", "1"}, {"name", "Track"}, {"lineName", "Track"}});
  all.line({at(18).apply({-1, 0.9}), at(18).apply({1, 0.9}), at(18).apply({1.4, 0.5})},
           {{"lineType", "2"}, {"name", "Virtual wall"}});
  all.line(between(20, 21), {{"lineType", 3}});
  all.line(between(22, 24), {{"lineType", 4}, {"name", "Patrol"}});
  all.line(between(24, 25), {{"lineType", 88}});

  int region_place = 20;
  for (const int region : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 13, 15, 16, 17, 99}) {
    Value::Object properties{{"regionType", region}, {"name", "Region " + std::to_string(region)}};
    if (region == 2) properties.emplace_back("speed", 0.4);
    if (region == 4 || region == 5) properties.emplace_back("mac", "30:AE:A4:00:11:22");
    // Robots leave some rings open.
    all.ring(box(at(region_place), 1.6, 1.1, region == 12 || region == 8), std::move(properties));
    ++region_place;
  }
  // A ring with a hole, a collection of shapes that no robot draws, and a feature without a place.
  all.add("Polygon", Value::List{pointsOf(box(at(37), 2.4, 1.8)), pointsOf(box(at(37), 1.0, 0.6))},
          {{"regionType", 1}, {"name", "With a hole"}});
  all.add("MultiPoint", pointsOf(between(38, 39)),
          {{"type", 25}, {"future", Value::Json{R"({"a":[1,2,{"b":null}]})"}}});
  all.add("Polygon", Value::List{}, {{"regionType", 1}, {"name", "Empty"}});
  return all.finished();
}

}  // namespace mapwright::simulator
