#include "simulator/ros/dispatcher.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

#include "simulator/ros/cloud_bytes.h"
#include "simulator/ros/ros_services.h"

namespace mapwright::simulator::ros {
namespace {

constexpr std::string_view kPlace = "/map_dispatcher/";
constexpr double kCellM = 0.05, kCoarseCellM = 0.1, kProjectedCellM = 0.1;
constexpr double kMostCells = 40e6, kMostPoints = 4e6, kMostCandidates = 30e6;
constexpr double kMostProjectedM = 200;
constexpr std::string_view kFrame = "map";

CallOutcome refused(std::string_view service, std::string_view why) {
  return {false, "service [" + std::string(kPlace) + std::string(service) + "] responded with an error: b'" +
                     std::string(why) + "'"};
}

bool finite(const Value& request, std::initializer_list<const char*> names) {
  return std::all_of(names.begin(), names.end(),
                     [&](const char* name) { return std::abs(request[name].number()) <= 1e9; });
}

}  // namespace

Dispatcher::Dispatcher(const Options& options, const FaultPlan& faults)
    : options_(options),
      faults_(faults),
      building_(options.ros.dispatcher.edge_m, options.seed),
      projections_{{std::string(kFrame), -20, -15, 40, 30, 0.2, 2.0},
                   {std::string(kFrame), -20, -15, 40, 30, 3.7, 5.5}} {}

const std::vector<std::string_view>& Dispatcher::projectedTopics() {
  static const std::vector<std::string_view> all{
      "/map_dispatcher/projected_map_0", "/map_dispatcher/projected_map_1", "/map_dispatcher/projected_map_2",
      "/map_dispatcher/projected_map_3", "/map_dispatcher/projected_map_4", "/map_dispatcher/projected_map_5",
      "/map_dispatcher/projected_map_6", "/map_dispatcher/projected_map_7"};
  return all;
}

std::vector<Dispatcher::Row> Dispatcher::services() const {
  const DispatcherOptions& own = options_.ros.dispatcher;
  if (!own.there) return {};
  std::vector<Row> rows{{"/map_dispatcher/save_map", "map_msgs/SaveMap"}};
  if (own.planar) {
    rows.push_back({"/map_dispatcher/get_map", "nav_msgs/GetMap"});
    rows.push_back({"/map_dispatcher/get_sub_map", "map_msgs/GetMapROI"});
  }
  if (!own.spatial) return rows;
  for (const Row& row : {Row{"/map_dispatcher/get_point_map", "map_msgs/GetPointMap"},
                         Row{"/map_dispatcher/get_sub_point_map", "map_msgs/GetPointMapROI"},
                         Row{"/map_dispatcher/get_occupancy_map", "map_msgs/GetPointMap"},
                         Row{"/map_dispatcher/get_sub_occupancy_map", "map_msgs/GetPointMapROI"},
                         Row{"/map_dispatcher/set_map_projections",
                             own.writable ? "map_msgs/ProjectedMapsInfo" : "map_msgs/SetMapProjections"}})
    rows.push_back(row);
  return rows;
}

std::vector<Dispatcher::Row> Dispatcher::topics() const {
  const DispatcherOptions& own = options_.ros.dispatcher;
  std::vector<Row> rows;
  if (!own.there) return rows;
  if (own.planar) rows.push_back({"/map_metadata", "nav_msgs/MapMetaData"});
  if (!own.spatial) return rows;
  const std::lock_guard lock(mutex_);
  for (std::size_t i = 0; i < projections_.size() && i < projectedTopics().size(); ++i)
    rows.push_back({projectedTopics()[i], "map_msgs/ProjectedMap"});
  return rows;
}

bool Dispatcher::has(std::string_view service) const {
  const std::vector<Row> rows = services();
  return std::any_of(rows.begin(), rows.end(), [&](const Row& row) { return row.name == service; });
}

Dispatcher::Edits Dispatcher::edits() const {
  const std::lock_guard lock(mutex_);
  return edits_;
}

Value Dispatcher::info(double resolution_m, int width, int height, const geometry::Pose2& origin) const {
  return Value::Object{{"map_load_time", timeOf(0, options_.ros.dialect)},
                       {"resolution", float32(resolution_m)},
                       {"width", width},
                       {"height", height},
                       {"origin", poseOf(origin)}};
}

CallOutcome Dispatcher::call(std::string_view service, const Value& request) {
  const std::string_view verb = service.substr(kPlace.size());
  if (verb == "get_map") {
    const double half = std::floor(building_.edge_m() / 2), middle = building_.edge_m() / 2 - half;
    return grid({{middle, middle}, {building_.edge_m(), building_.edge_m()}}, true);
  }
  if (verb == "get_sub_map") {
    if (!finite(request, {"x", "y", "l_x", "l_y"})) return refused(verb, "not a region");
    return grid(
        {{request["x"].number(), request["y"].number()}, {request["l_x"].number(), request["l_y"].number()}},
        false);
  }
  if (verb == "save_map") return save(request["filename"]["data"].text());
  if (verb == "get_point_map" || verb == "get_occupancy_map")
    return cloud(request, true, verb == "get_occupancy_map");
  if (verb == "get_sub_point_map" || verb == "get_sub_occupancy_map")
    return cloud(request, false, verb == "get_sub_occupancy_map");
  if (options_.ros.dispatcher.writable) return setProjections(request);
  const std::lock_guard lock(mutex_);
  return {true, projectionsValue()};
}

CallOutcome Dispatcher::save(const std::string& filename) {
  const std::size_t dot = filename.rfind('.');
  const std::string kind = dot == std::string::npos ? std::string() : filename.substr(dot + 1);
  const std::set<std::string> known{"png", "pgm", "yaml", "pcd", "ply", "vtk", "bt"};
  if (!known.contains(kind)) return refused("save_map", "I do not know how to save " + filename);
  return {true, Value::Object{}};
}

CallOutcome Dispatcher::grid(const Region& asked, bool whole) {
  const DispatcherFaults odd = faults_.faults().ros.dispatcher;
  const char* const verb = whole ? "get_map" : "get_sub_map";
  int call = 0;
  {
    const std::lock_guard lock(mutex_);
    call = calls_++;
    if (odd.regrids && call % 4 == 3) ++edits_.map;
  }
  const double edge = building_.edge_m(), half = std::floor(edge / 2);
  const double cell = odd.resolution_changes && call % 2 == 1 ? kCoarseCellM : kCellM;
  const double shift = odd.regrids ? 0.013 * edits().map : 0;
  Region region = asked;
  if (odd.answer == "elsewhere") region.centre_m.x() += 2 * asked.size_m.x();
  if (odd.answer == "corner" && !whole) region.centre_m += asked.size_m / 2;
  // In cells of the whole map.
  const auto first = [&](double at) { return std::floor((at + half - shift) / cell + 1e-6); };
  const auto last = [&](double at) { return std::ceil((at + half - shift) / cell - 1e-6); };
  const Eigen::Vector2d low = region.centre_m - region.size_m / 2, high = region.centre_m + region.size_m / 2;
  double u0 = first(low.x()), v0 = first(low.y()), u1 = last(high.x()), v1 = last(high.y());
  if (odd.answer != "pad" && odd.answer != "rotated") {
    const double most = std::round(edge / cell);
    u0 = std::max(u0, 0.0);
    v0 = std::max(v0, 0.0);
    u1 = std::min(u1, most);
    v1 = std::min(v1, most);
  }
  const bool beyond = u1 <= u0 || v1 <= v0;
  const bool cut = odd.answer == "empty" &&
                   (u0 > first(low.x()) || v0 > first(low.y()) || u1 < last(high.x()) || v1 < last(high.y()));
  const Value header = headerOf(kFrame, 0, options_.ros.dialect);
  const char* const member = whole ? "map" : "sub_map";
  const bool too_much = !whole && odd.most_cells > 0 && !beyond && (u1 - u0) * (v1 - v0) > odd.most_cells;
  if (too_much && odd.too_much == "error") return refused(verb, "this region is too large");
  if (beyond || cut || (too_much && odd.too_much == "empty")) {
    return {true, Value::Object{{member, Value::Object{{"header", header},
                                                       {"info", info(cell, 0, 0, {})},
                                                       {"data", Value::Int8s{}}}}}};
  }
  geometry::Pose2 origin{u0 * cell - half + shift, v0 * cell - half + shift, 0};
  double columns = u1 - u0, rows = v1 - v0;
  if (odd.answer == "rotated") {
    // A grid that lies askew has to be larger to hold the region.
    constexpr double kTurn = 0.3;
    const double c = std::cos(kTurn), s = std::sin(kTurn);
    columns = std::ceil((region.size_m.x() * c + region.size_m.y() * s) / cell);
    rows = std::ceil((region.size_m.x() * s + region.size_m.y() * c) / cell);
    const Eigen::Vector2d corner =
        region.centre_m - Eigen::Vector2d(columns * c - rows * s, columns * s + rows * c) * cell / 2;
    origin = {corner.x(), corner.y(), kTurn};
  }
  if (too_much && odd.answer != "rotated") {
    const double edge_cells = std::floor(std::sqrt(odd.most_cells));
    columns = std::min(columns, std::max(edge_cells, std::floor(odd.most_cells / rows)));
    rows = std::min(rows, std::floor(odd.most_cells / columns));
  }
  if (columns * rows > kMostCells) return refused(verb, "not enough memory for so many cells");
  const int width = static_cast<int>(columns), height = static_cast<int>(rows);
  Value::Int8s cells;
  cells.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      const Eigen::Vector2d at = origin.apply({(u + 0.5) * cell, (v + 0.5) * cell});
      cells.push_back(building_.cellAt(at.x(), at.y()));
    }
  }
  for (std::size_t i = 0; odd.cloud.lie == "cells" && i < cells.size(); i += 1000)
    cells[i] = i % 2000 == 0 ? 120 : -7;
  if (odd.cloud.lie == "data") cells.resize(cells.size() - cells.size() / 3);
  return {true, Value::Object{{member, Value::Object{{"header", header},
                                                     {"info", info(cell, width, height, origin)},
                                                     {"data", std::move(cells)}}}}};
}

CallOutcome Dispatcher::cloud(const Value& request, bool whole, bool occupancy) const {
  const DispatcherFaults odd = faults_.faults().ros.dispatcher;
  const char* const verb = occupancy ? (whole ? "get_occupancy_map" : "get_sub_occupancy_map")
                                     : (whole ? "get_point_map" : "get_sub_point_map");
  if (!whole && !finite(request, {"x", "y", "z", "r", "l_x", "l_y", "l_z"}))
    return refused(verb, "not a region");
  Eigen::Vector3d centre(request["x"].number(), request["y"].number(), request["z"].number());
  const double radius = whole ? 0 : request["r"].number();
  if (radius < 0) return refused(verb, "a radius below 0 means nothing");
  Eigen::Vector3d half(radius, radius, radius);
  if (radius == 0)
    half = {request["l_x"].number() / 2, request["l_y"].number() / 2, request["l_z"].number() / 2};
  if (whole) {
    centre = {0, 0, 0};
    half = {1e6, 1e6, 1e6};
  }
  if (odd.answer == "elsewhere") centre.x() += 4 * half.x();
  if (odd.answer == "pad") half *= 1.2;
  const Eigen::Vector3d low = centre - half, high = centre + half;
  if (building_.countNear(low, high) > kMostCandidates)
    return refused(verb, "not enough memory for so many points");
  std::vector<Building::Point> points;
  std::set<std::tuple<int, int, int>> voxels;
  bool too_many = false;
  if (odd.answer != "empty") {
    building_.pointsNear(low, high, [&](const Building::Point& point) {
      if (too_many) return;
      Building::Point taken = point;
      if (occupancy) {
        const Eigen::Vector3d voxel = (point.at_m / Building::kVoxelM).array().floor();
        if (!voxels
                 .emplace(static_cast<int>(voxel.x()), static_cast<int>(voxel.y()),
                          static_cast<int>(voxel.z()))
                 .second)
          return;
        taken.at_m = (voxel.array() + 0.5) * Building::kVoxelM;
      }
      const bool inside = radius > 0 && odd.answer != "pad" ? (taken.at_m - centre).norm() <= radius
                                                            : ((taken.at_m - low).array() >= 0).all() &&
                                                                  ((high - taken.at_m).array() >= 0).all();
      if (!inside) return;
      points.push_back(taken);
      too_many = double(points.size()) > kMostPoints;
    });
  }
  if (too_many) return refused(verb, "not enough memory for so many points");
  return {true,
          Value::Object{{whole ? "map" : "sub_map", cloudMessage(headerOf(kFrame, 0, options_.ros.dialect),
                                                                 points, !occupancy, odd.cloud)}}};
}

Value Dispatcher::projectionsValue() const {
  Value::List rows;
  for (const Projection& one : projections_) {
    rows.push_back(Value::Object{{"frame_id", one.frame},
                                 {"x", one.x},
                                 {"y", one.y},
                                 {"width", one.width},
                                 {"height", one.height},
                                 {"min_z", one.min_z},
                                 {"max_z", one.max_z}});
  }
  return Value::Object{
      {options_.ros.dispatcher.other_member ? "projected_maps" : "projected_maps_info", std::move(rows)}};
}

CallOutcome Dispatcher::setProjections(const Value& request) {
  const auto* rows = request["projected_maps_info"].as<Value::List>();
  std::vector<Projection> wanted;
  for (const Value& row : rows != nullptr ? *rows : Value::List{}) {
    if (!finite(row, {"x", "y", "width", "height", "min_z", "max_z"}) || row["width"].number() <= 0 ||
        row["height"].number() <= 0)
      return refused("set_map_projections", "not a projection");
    const std::string& frame = row["frame_id"].text();
    if (!frame.empty() && frame != kFrame) return refused("set_map_projections", "unknown frame " + frame);
    // It projects whole decimetres, so many and no more.
    const auto whole = [](double value) { return std::round(value / kProjectedCellM) * kProjectedCellM; };
    if (wanted.size() < projectedTopics().size()) {
      wanted.push_back({std::string(kFrame), whole(row["x"].number()), whole(row["y"].number()),
                        std::clamp(whole(row["width"].number()), kProjectedCellM, kMostProjectedM),
                        std::clamp(whole(row["height"].number()), kProjectedCellM, kMostProjectedM),
                        row["min_z"].number(), row["max_z"].number()});
    }
  }
  const std::lock_guard lock(mutex_);
  projections_ = std::move(wanted);
  ++edits_.projections;
  return {true, Value::Object{}};
}

std::optional<Value> Dispatcher::messageOf(std::string_view topic) const {
  if (!options_.ros.dispatcher.there) return std::nullopt;
  if (topic == "/map_metadata") {
    const double edge = building_.edge_m(), half = std::floor(edge / 2);
    const double shift = 0.013 * edits().map;
    const int cells = static_cast<int>(std::round(edge / kCellM));
    return info(kCellM, cells, cells, {shift - half, shift - half, 0});
  }
  const auto& names = projectedTopics();
  const auto found = std::find(names.begin(), names.end(), topic);
  if (found == names.end()) return std::nullopt;
  Projection of;
  {
    const std::lock_guard lock(mutex_);
    const auto index = static_cast<std::size_t>(found - names.begin());
    if (index >= projections_.size()) return std::nullopt;
    of = projections_[index];
  }
  const int width = static_cast<int>(std::round(of.width / kProjectedCellM)),
            height = static_cast<int>(std::round(of.height / kProjectedCellM));
  Value::Int8s cells;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      cells.push_back(building_.cellAt(of.x + (u + 0.5) * kProjectedCellM, of.y + (v + 0.5) * kProjectedCellM,
                                       of.min_z, of.max_z));
    }
  }
  return Value::Object{{"map", Value::Object{{"header", headerOf(kFrame, 0, options_.ros.dialect)},
                                             {"info", info(kProjectedCellM, width, height, {of.x, of.y, 0})},
                                             {"data", std::move(cells)}}},
                       {"min_z", of.min_z},
                       {"max_z", of.max_z}};
}

}  // namespace mapwright::simulator::ros
