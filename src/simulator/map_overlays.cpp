#include "simulator/map_overlays.h"

#include <array>
#include <numbers>
#include <vector>

#include "simulator/json_text.h"
#include "simulator/value_json.h"

namespace mapwright::simulator {
namespace {

using Eigen::Vector2d;

constexpr double kDegrees = 180 / std::numbers::pi;

void appendPlace(std::string& out, const Vector2d& point) {
  out += '[';
  appendJsonFixed(out, point.x(), 3);
  out += ',';
  appendJsonFixed(out, point.y(), 3);
  out += ']';
}

void appendPlaces(std::string& out, const std::vector<Vector2d>& points) {
  out += '[';
  for (const Vector2d& point : points) {
    if (out.back() != '[') out += ',';
    appendPlace(out, point);
  }
  out += ']';
}

/// Writes features one after the other. `properties` is JSON without its braces.
class Collection {
 public:
  void add(std::string_view shape, const std::string& coordinates, const std::string& properties,
           bool with_id = true) {
    text_ += text_.empty() ? "{" : ",{";
    if (with_id) text_ += "\"id\":\"65a0000000000000000000" + std::to_string(10 + count_) + "\",";
    ++count_;
    text_ += R"("type":"Feature","geometry":{"type":")";
    text_ += shape;
    text_ += R"(","coordinates":)" + coordinates + R"(},"properties":{)" + properties + "}}";
  }
  void point(const geometry::Pose2& at, const std::string& properties, bool with_id = true) {
    std::string coordinates;
    appendPlace(coordinates, {at.x_m, at.y_m});
    add("Point", coordinates, properties, with_id);
  }
  void line(const std::vector<Vector2d>& points, const std::string& properties) {
    std::string coordinates;
    appendPlaces(coordinates, points);
    add("LineString", coordinates, properties);
  }
  void ring(const std::vector<Vector2d>& points, const std::string& properties) {
    std::string coordinates = "[";
    appendPlaces(coordinates, points);
    add("Polygon", coordinates + "]", properties);
  }
  std::string finished() const { return R"({"type":"FeatureCollection","features":[)" + text_ + "]}"; }

 private:
  std::string text_;
  int count_ = 0;
};

/// A rectangle around a place on the way, in its direction; closed as GeoJSON wants unless `open`.
std::vector<Vector2d> box(const geometry::Pose2& at, double length, double width, bool open = false) {
  const double l = length / 2, w = width / 2;
  std::vector<Vector2d> ring{at.apply({-l, -w}), at.apply({l, -w}), at.apply({l, w}), at.apply({-l, w})};
  if (!open) ring.push_back(ring.front());
  return ring;
}

std::string yawOf(const geometry::Pose2& pose, bool as_text) {
  std::string yaw;
  if (as_text) yaw += '"';
  appendJsonFixed(yaw, pose.yaw_rad * kDegrees, 2);
  if (as_text) yaw += '"';
  return yaw;
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
  const Trajectory* way = nullptr;
  for (const Trajectory& trajectory : scene.trajectories) {
    if (trajectory.id == id) way = &trajectory;
  }
  if (way == nullptr) return all.finished();
  const double step = way->drive.length_m() / 40;
  const auto at = [&](int i) { return way->drive.at(step * i); };

  struct PointKind {
    int type;
    const char* name;
    const char* more;
  };
  constexpr std::array<PointKind, 14> kPoints{
      {{9, "Charger", R"(,"dockingPointId":"65a000000000000000000011")"},
       {36, "Docking point", ""},
       {6, "Elevator A", R"(,"deviceIds":["el-1","el-2"])"},
       {10, "Standby", ""},
       {11, "Table 1", ""},
       {11, "餐桌 2", ""},
       {19, "Reception <main>", ""},
       {25, "Waypoint", ""},
       {27, "Exchange", ""},
       {28, "Wait for the elevator", ""},
       {29, "Dispatch", ""},
       {34, "Rack 🏭", ""},
       {3, "Other", ""},
       {77, "Nobody knows", ""}}};
  int place = 1;
  for (const PointKind& kind : kPoints) {
    const geometry::Pose2 pose = at(place);
    std::string properties = R"("type":)";
    const char* quote = place % 3 == 0 ? "\"" : "";
    properties.append(quote).append(std::to_string(kind.type)).append(quote);
    properties += R"(,"yaw":)" + yawOf(pose, place % 2 == 0) + R"(,"name":)";
    appendJsonText(properties, kind.name);
    all.point(pose, properties + kind.more, place != 7);
    ++place;
  }
  all.point(at(16), R"("type":"37","barcodeId":"D2_125","name":"","yaw":)" + yawOf(at(16), true));
  all.point(at(17), R"("type":39,"landmarkId":"landmark_1")");

  all.line({at(1).apply({0, 0}), at(2).apply({0, 0}), at(3).apply({0, 0})},
           R"("lineType":"1","name":"Track","lineName":"Track")");
  all.line({at(18).apply({-1, 0.9}), at(18).apply({1, 0.9}), at(18).apply({1.4, 0.5})},
           R"("lineType":"2","name":"Virtual wall")");
  all.line({at(20).apply({0, 0}), at(21).apply({0, 0})}, R"("lineType":3)");
  all.line({at(22).apply({0, 0}), at(23).apply({0, 0}), at(24).apply({0, 0})},
           R"("lineType":4,"name":"Patrol")");
  all.line({at(24).apply({0, 0}), at(25).apply({0, 0})}, R"("lineType":88)");

  constexpr std::array kRegions{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 13, 15, 16, 17, 99};
  int region_place = 20;
  for (const int region : kRegions) {
    const std::string number = std::to_string(region);
    std::string properties = R"("regionType":)";
    properties.append(number).append(R"(,"name":"Region )").append(number).append("\"");
    if (region == 2) properties += R"(,"speed":0.4)";
    if (region == 4 || region == 5) properties += R"(,"mac":"30:AE:A4:00:11:22")";
    // Robots leave some rings open.
    all.ring(box(at(region_place), 1.6, 1.1, region == 12 || region == 8), properties);
    ++region_place;
  }
  // A ring with a hole, a collection of shapes that no robot draws, and a feature without a place.
  std::string with_hole = "[";
  appendPlaces(with_hole, box(at(37), 2.4, 1.8));
  with_hole += ',';
  appendPlaces(with_hole, box(at(37), 1.0, 0.6));
  all.add("Polygon", with_hole + "]", R"("regionType":1,"name":"With a hole")");
  std::string many;
  appendPlaces(many, {at(38).apply({0, 0}), at(39).apply({0, 0})});
  all.add("MultiPoint", many, R"("type":25,"future":{"a":[1,2,{"b":null}]})");
  all.add("Polygon", "[]", R"("regionType":1,"name":"Empty")");
  return all.finished();
}

}  // namespace mapwright::simulator
