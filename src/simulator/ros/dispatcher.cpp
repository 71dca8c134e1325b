#include "simulator/ros/dispatcher.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <tuple>

#include "simulator/noise.h"

namespace mapwright::simulator::ros {
namespace {

constexpr double kRoomM = 12.5, kWallM = 0.1, kDoorM = 1.2;  // walls: half of their thickness
constexpr std::array<std::uint32_t, 5> kColors{0xd04040, 0xd0a030, 0x40b050, 0x3080d0, 0x9050c0};

std::int64_t whole(double value) { return static_cast<std::int64_t>(std::floor(value)); }

/// The wall line nearest to a coordinate: its number and how far it is.
struct WallLine {
  std::int64_t number;
  double off_m;
};
WallLine lineNear(double at_m) {
  const double number = std::round(at_m / kRoomM);
  return {static_cast<std::int64_t>(number), std::abs(at_m - number * kRoomM)};
}

}  // namespace

/// A building of five storeys around the point (0, 0), too large for memory: cells and points are functions
/// of their position, computed on demand. Immutable, safe from any thread.
class Building {
 public:
  static constexpr int kStoreys = 5;
  static constexpr double kStoreyM = 3.5;      // from floor to floor; the first is at z = 0
  static constexpr int kPointsPerColumn = 40;  // per square metre, all storeys together
  static constexpr double kVoxelM = 0.25;

  /// `edge_m`: whole metres, 10..2000; 1000 m gives 40 million points.
  Building(double edge_m, std::uint32_t seed) : edge_m_(edge_m), seed_(seed) {}

  double edge_m() const { return edge_m_; }
  /// The cell at a position between two heights: -1, 0 or 100.
  std::int8_t cellAt(double x_m, double y_m, double from_z_m, double to_z_m) const {
    const double half = std::floor(edge_m_ / 2);
    if (x_m < -half || y_m < -half || x_m >= edge_m_ - half || y_m >= edge_m_ - half) return -1;
    // Outside the outer wall, and some rooms, nobody has been.
    const double reach = edge_m_ / 2 - 0.5;
    const double off = std::hypot(x_m, y_m);
    if (off > reach) return -1;
    if (off > reach - 0.3) return 100;
    if (hashOf(seed_, 9, whole(x_m / kRoomM), whole(y_m / kRoomM)) % 17 == 0) return -1;
    const auto storey = [](double z_m) {
      return static_cast<int>(
          std::clamp(std::floor(std::clamp(z_m, -1e3, 1e3) / kStoreyM), 0.0, kStoreys - 1.0));
    };
    for (int level = storey(from_z_m); level <= storey(to_z_m); ++level) {
      if (wallAt(x_m, y_m, level)) return 100;
    }
    return 0;
  }

  /// The cells of a grid whose lower left corner is `origin`.
  Value::Int8s cellsFrom(const geometry::Pose2& origin, double cell_m, int width, int height, double from_z_m,
                         double to_z_m) const {
    Value::Int8s cells;
    cells.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        const Eigen::Vector2d at = origin.apply({(u + 0.5) * cell_m, (v + 0.5) * cell_m});
        cells.push_back(cellAt(at.x(), at.y(), from_z_m, to_z_m));
      }
    }
    return cells;
  }

  struct Point {
    Eigen::Vector3d at_m;
    float intensity;    // 0..255
    std::uint32_t rgb;  // of the storey
  };
  /// The points of the square metres that the box touches, in a fixed order.
  void pointsNear(const Eigen::Vector3d& low_m, const Eigen::Vector3d& high_m,
                  const std::function<void(const Point&)>& visit) const {
    constexpr int kEach = kPointsPerColumn / kStoreys;
    const Columns columns = columnsIn(low_m, high_m);
    for (std::int64_t y = columns.from_y; y < columns.to_y; ++y) {
      for (std::int64_t x = columns.from_x; x < columns.to_x; ++x) {
        for (int storey = columns.from_storey; storey <= columns.to_storey; ++storey) {
          Dice dice(hashOf(seed_, 10, x, y, storey));
          const double floor_m = storey * kStoreyM;
          const WallLine wall_x = lineNear(double(x) + 0.5), wall_y = lineNear(double(y) + 0.5);
          for (int i = 0; i < kEach; ++i) {
            Point point{{double(x) + dice.uniform(0, 1), double(y) + dice.uniform(0, 1), floor_m}, 0, 0};
            double height = dice.uniform(0, kStoreyM - 0.3);
            const bool on_x = wall_x.off_m <= 0.5, on_y = wall_y.off_m <= 0.5;
            if (on_x && i % 2 == 0) point.at_m.x() = double(wall_x.number) * kRoomM;
            if (on_y && !on_x && i % 2 == 0) point.at_m.y() = double(wall_y.number) * kRoomM;
            const bool solid = wallAt(point.at_m.x(), point.at_m.y(), storey);
            if (!solid) height = i == 1 ? kStoreyM - 0.3 : 0;  // the ceiling, the floor
            point.at_m.z() += height;
            point.intensity = static_cast<float>(solid ? 180 + 60 * dice.uniform(0, 1) : 40);
            point.rgb = kColors[static_cast<std::size_t>(storey)];
            visit(point);
          }
        }
      }
    }
  }
  /// How many these are.
  double countNear(const Eigen::Vector3d& low_m, const Eigen::Vector3d& high_m) const {
    const Columns in = columnsIn(low_m, high_m);
    if (in.to_x <= in.from_x || in.to_y <= in.from_y || in.to_storey < in.from_storey) return 0;
    return double(in.to_x - in.from_x) * double(in.to_y - in.from_y) * (in.to_storey - in.from_storey + 1) *
           (kPointsPerColumn / kStoreys);
  }

 private:
  /// Square metres; the ends are not among them, the last storey is.
  struct Columns {
    std::int64_t from_x, to_x, from_y, to_y;
    int from_storey, to_storey;
  };
  Columns columnsIn(const Eigen::Vector3d& low_m, const Eigen::Vector3d& high_m) const {
    const double half = std::floor(edge_m_ / 2);
    const auto from = [&](double at) { return whole(std::clamp(at, -half, edge_m_ - half)); };
    const auto to = [&](double at) {
      return static_cast<std::int64_t>(std::ceil(std::clamp(at, -half, edge_m_ - half)));
    };
    const auto storey = [](double z) {
      return static_cast<int>(std::clamp(std::floor(z / kStoreyM), -1.0, kStoreys * 1.0));
    };
    return {from(low_m.x()),
            to(high_m.x()),
            from(low_m.y()),
            to(high_m.y()),
            std::max(0, storey(low_m.z())),
            std::min(kStoreys - 1, storey(high_m.z()))};
  }

  bool wallAt(double x_m, double y_m, int storey) const {
    const auto solid = [&](double across, double along, int side) {
      const WallLine line = lineNear(across);
      if (line.off_m > kWallM) return false;
      const std::int64_t room = whole(along / kRoomM);
      const std::uint64_t lot = hashOf(seed_, 7, line.number, room, storey, side);
      if (lot % 13 == 0) return false;  // two rooms are one
      const double door = (double(room) + 0.15 + 0.6 * unitFrom(lot)) * kRoomM;
      return along < door || along > door + kDoorM;
    };
    if (solid(x_m, y_m, 0) || solid(y_m, x_m, 1)) return true;
    // A pillar or a cupboard in every third room.
    const std::int64_t column = whole(x_m / kRoomM), row = whole(y_m / kRoomM);
    const std::uint64_t lot = hashOf(seed_, 8, column, row, storey);
    if (lot % 3 != 0) return false;
    const double at_x = (double(column) + 0.2 + 0.5 * unitFrom(mix(lot))) * kRoomM,
                 at_y = (double(row) + 0.2 + 0.5 * unitFrom(mix(lot + 1))) * kRoomM;
    return x_m >= at_x && x_m < at_x + 1.4 && y_m >= at_y && y_m < at_y + 0.8;
  }

  double edge_m_;
  std::uint32_t seed_;
};

namespace {

constexpr std::string_view kNamespace = "/map_dispatcher/";
constexpr double kCellM = 0.05, kCoarseCellM = 0.1, kProjectedCellM = 0.1;
constexpr double kMostCells = 40e6, kMostPoints = 4e6, kMostCandidates = 30e6;
constexpr double kMostProjectedM = 200;
constexpr std::string_view kFrame = "map";

tl::unexpected<std::string> refused(std::string_view service, std::string_view why) {
  return tl::make_unexpected("service [" + std::string(kNamespace) + std::string(service) +
                             "] responded with an error: b'" + std::string(why) + "'");
}

bool finite(const Value& request, std::initializer_list<const char*> names) {
  return std::all_of(names.begin(), names.end(),
                     [&](const char* name) { return std::abs(request[name].number()) <= 1e9; });
}

Answer saved(const Value& request) {
  const std::string& filename = request["filename"]["data"].text();
  const std::size_t dot = filename.rfind('.');
  const std::set<std::string> known{"png", "pgm", "yaml", "pcd", "ply", "vtk", "bt"};
  if (dot == std::string::npos || !known.contains(filename.substr(dot + 1)))
    return refused("save_map", "I do not know how to save " + filename);
  return Value::Object{};
}

/// A cloud in one of the layouts used by senders (sensor_msgs/PointCloud2).
Value cloudMessage(Value header, const std::vector<Building::Point>& points, bool colored,
                   const CloudOddities& odd) {
  constexpr int kUint32 = 6, kFloat32 = 7, kFloat64 = 8;
  // Between the fields there may be bytes of nobody's.
  const std::size_t before = odd.odd_offsets ? 3 : 0, behind = odd.odd_offsets ? 1 : 0;
  std::size_t step = before;
  Value::List fields;
  const auto field = [&](const char* name, int type) {
    fields.push_back(Value::Object{{"name", name}, {"offset", step}, {"datatype", type}, {"count", 1}});
    step += (type == kFloat64 ? 8 : 4) + behind;
  };
  const int number = odd.float64 ? kFloat64 : kFloat32;
  field("x", number);
  field("y", number);
  if (!odd.no_z) field("z", number);
  if (colored) field("intensity", kFloat32);
  if (colored) field("rgb", odd.float64 ? kUint32 : kFloat32);
  std::string data;
  data.reserve(points.size() * step);
  const auto put = [&](auto value) {
    appendNumber(data, value, odd.big_endian);
    data.append(behind, '\x7f');
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Building::Point& point = points[i];
    data.append(before, '\x7f');
    for (int axis = 0; axis < (odd.no_z ? 2 : 3); ++axis) {
      const double at = point.at_m[axis] - (axis == 2 ? odd.far_m : 0) + odd.far_m;
      const double value = odd.nan && i % 10 == 3 ? std::numeric_limits<double>::quiet_NaN() : at;
      if (odd.float64) {
        put(value);
      } else {
        put(static_cast<float>(value));
      }
    }
    if (!colored) continue;
    put(point.intensity);
    put(point.rgb);
  }
  std::size_t width = points.size(), point_step = step, row_step = data.size();
  if (odd.lie == "point-step") point_step = step / 2 + 1;
  if (odd.lie == "row-step") row_step = data.size() * 3 + 7;
  if (odd.lie == "width") width = points.size() * 1000 + 1;
  if (odd.lie == "data") data.resize(data.size() - data.size() / 3);
  return Value::Object{{"header", std::move(header)},
                       {"height", 1},
                       {"width", width},
                       {"fields", std::move(fields)},
                       {"is_bigendian", odd.big_endian},
                       {"point_step", point_step},
                       {"row_step", row_step},
                       {"data", Value::Bytes{std::move(data)}},
                       {"is_dense", !odd.nan}};
}

}  // namespace

Dispatcher::Dispatcher(const Options& options, const FaultPlan& faults)
    : options_(options),
      faults_(faults),
      building_(std::make_unique<const Building>(options.ros.dispatcher.edge_m, options.seed)),
      projections_{{-20, -15, 40, 30, 0.2, 2.0}, {-20, -15, 40, 30, 3.7, 5.5}} {}

Dispatcher::~Dispatcher() = default;

const std::vector<std::string_view>& Dispatcher::projectedTopics() {
  static const std::vector<std::string_view> all{
      "/map_dispatcher/projected_map_0", "/map_dispatcher/projected_map_1", "/map_dispatcher/projected_map_2",
      "/map_dispatcher/projected_map_3", "/map_dispatcher/projected_map_4", "/map_dispatcher/projected_map_5",
      "/map_dispatcher/projected_map_6", "/map_dispatcher/projected_map_7"};
  return all;
}

std::vector<Service> Dispatcher::services() {
  const DispatcherOptions& own = options_.ros.dispatcher;
  std::vector<Service> rows;
  const auto add = [&](bool there, const char* verb, std::string_view type, auto answer,
                       bool changes = false) {
    const auto kept = [answer](const Value& request, bool keep) {
      return keep ? answer(request) : Answer(Value::Object{});
    };
    if (own.there && there) rows.push_back({std::string(kNamespace) + verb, type, kept, changes});
  };
  const auto gridded = [this](bool whole) {
    return [this, whole](const Value& request) { return grid(request, whole); };
  };
  const auto clouded = [this](bool whole, bool occupancy) {
    return [this, whole, occupancy](const Value& request) { return cloud(request, whole, occupancy); };
  };
  add(true, "save_map", "map_msgs/SaveMap", saved);
  add(own.planar, "get_map", "nav_msgs/GetMap", gridded(true));
  add(own.planar, "get_sub_map", "map_msgs/GetMapROI", gridded(false));
  add(own.spatial, "get_point_map", "map_msgs/GetPointMap", clouded(true, false));
  add(own.spatial, "get_sub_point_map", "map_msgs/GetPointMapROI", clouded(false, false));
  add(own.spatial, "get_occupancy_map", "map_msgs/GetPointMap", clouded(true, true));
  add(own.spatial, "get_sub_occupancy_map", "map_msgs/GetPointMapROI", clouded(false, true));
  add(
      own.spatial, "set_map_projections",
      own.writable ? "map_msgs/ProjectedMapsInfo" : "map_msgs/SetMapProjections",
      [this](const Value& request) { return projections(request); }, own.writable);
  return rows;
}

bool Dispatcher::has(std::string_view topic) const {
  const auto& names = projectedTopics();
  const auto index = static_cast<std::size_t>(std::find(names.begin(), names.end(), topic) - names.begin());
  const std::lock_guard lock(mutex_);
  return index >= names.size() || index < projections_.size();
}

Dispatcher::Edits Dispatcher::edits() const {
  const std::lock_guard lock(mutex_);
  return edits_;
}

Value Dispatcher::gridMessage(double resolution_m, int width, int height, const geometry::Pose2& origin,
                              Value::Int8s cells) const {
  return Value::Object{{"header", headerOf(kFrame, 0, options_.ros.dialect)},
                       {"info", mapInfo(resolution_m, width, height, origin, options_.ros.dialect)},
                       {"data", std::move(cells)}};
}

Answer Dispatcher::grid(const Value& request, bool whole) {
  const DispatcherFaults odd = faults_.faults().ros.dispatcher;
  const char* const verb = whole ? "get_map" : "get_sub_map";
  const double edge = building_->edge_m(), half = std::floor(edge / 2), middle = edge / 2 - half;
  if (!whole && !finite(request, {"x", "y", "l_x", "l_y"})) return refused(verb, "not a region");
  const Region asked = whole ? Region{{middle, middle}, {edge, edge}}
                             : Region{{request["x"].number(), request["y"].number()},
                                      {request["l_x"].number(), request["l_y"].number()}};
  int call = 0;
  {
    const std::lock_guard lock(mutex_);
    call = calls_++;
    if (odd.regrids && call % 4 == 3) ++edits_.map;
  }
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
  const char* const member = whole ? "map" : "sub_map";
  const bool too_much = !whole && odd.most_cells > 0 && !beyond && (u1 - u0) * (v1 - v0) > odd.most_cells;
  if (too_much && odd.too_much == "error") return refused(verb, "this region is too large");
  if (beyond || cut || (too_much && odd.too_much == "empty"))
    return Value::Object{{member, gridMessage(cell, 0, 0, {}, {})}};
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
  Value::Int8s cells = building_->cellsFrom(origin, cell, width, height, 0.1, 2);
  for (std::size_t i = 0; odd.cloud.lie == "cells" && i < cells.size(); i += 1000)
    cells[i] = i % 2000 == 0 ? 120 : -7;
  if (odd.cloud.lie == "data") cells.resize(cells.size() - cells.size() / 3);
  return Value::Object{{member, gridMessage(cell, width, height, origin, std::move(cells))}};
}

Answer Dispatcher::cloud(const Value& request, bool whole, bool occupancy) const {
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
  if (building_->countNear(low, high) > kMostCandidates)
    return refused(verb, "not enough memory for so many points");
  std::vector<Building::Point> points;
  std::set<std::tuple<int, int, int>> voxels;
  bool too_many = false;
  const auto addPoint = [&](const Building::Point& point) {
    if (too_many) return;
    Building::Point taken = point;
    if (occupancy) {
      const Eigen::Vector3d voxel = (point.at_m / Building::kVoxelM).array().floor();
      const std::tuple key(static_cast<int>(voxel.x()), static_cast<int>(voxel.y()),
                           static_cast<int>(voxel.z()));
      if (!voxels.insert(key).second) return;
      taken.at_m = (voxel.array() + 0.5) * Building::kVoxelM;
    }
    const bool inside = radius > 0 && odd.answer != "pad" ? (taken.at_m - centre).norm() <= radius
                                                          : ((taken.at_m - low).array() >= 0).all() &&
                                                                ((high - taken.at_m).array() >= 0).all();
    if (!inside) return;
    points.push_back(taken);
    too_many = double(points.size()) > kMostPoints;
  };
  if (odd.answer != "empty") building_->pointsNear(low, high, addPoint);
  if (too_many) return refused(verb, "not enough memory for so many points");
  return Value::Object{{whole ? "map" : "sub_map", cloudMessage(headerOf(kFrame, 0, options_.ros.dialect),
                                                                points, !occupancy, odd.cloud)}};
}

/// What set_map_projections does: it sets them where they can be written, and tells them otherwise.
Answer Dispatcher::projections(const Value& request) {
  const DispatcherOptions& own = options_.ros.dispatcher;
  if (!own.writable) {
    Value::List rows;
    const std::lock_guard lock(mutex_);
    for (const Projection& one : projections_) {
      rows.push_back(Value::Object{{"frame_id", kFrame},
                                   {"x", one.x},
                                   {"y", one.y},
                                   {"width", one.width},
                                   {"height", one.height},
                                   {"min_z", one.min_z},
                                   {"max_z", one.max_z}});
    }
    return Value::Object{{own.other_member ? "projected_maps" : "projected_maps_info", std::move(rows)}};
  }
  const auto* rows = request["projected_maps_info"].as<Value::List>();
  std::vector<Projection> wanted;
  for (const Value& row : rows != nullptr ? *rows : Value::List{}) {
    if (!finite(row, {"x", "y", "width", "height", "min_z", "max_z"}) || row["width"].number() <= 0 ||
        row["height"].number() <= 0)
      return refused("set_map_projections", "not a projection");
    const std::string& frame = row["frame_id"].text();
    if (!frame.empty() && frame != kFrame) return refused("set_map_projections", "unknown frame " + frame);
    if (wanted.size() >= projectedTopics().size()) continue;
    // It projects whole decimetres, so many and no more.
    const auto cells = [&](const char* name) {
      return std::round(row[name].number() / kProjectedCellM) * kProjectedCellM;
    };
    wanted.push_back({cells("x"), cells("y"), std::clamp(cells("width"), kProjectedCellM, kMostProjectedM),
                      std::clamp(cells("height"), kProjectedCellM, kMostProjectedM), row["min_z"].number(),
                      row["max_z"].number()});
  }
  const std::lock_guard lock(mutex_);
  projections_ = std::move(wanted);
  ++edits_.projections;
  return Value::Object{};
}

Value Dispatcher::messageOf(std::string_view topic) const {
  if (!options_.ros.dispatcher.there) return {};
  if (topic == "/map_metadata") {
    const double edge = building_->edge_m(), half = std::floor(edge / 2);
    const double shift = 0.013 * edits().map;
    const int cells = static_cast<int>(std::round(edge / kCellM));
    return mapInfo(kCellM, cells, cells, {shift - half, shift - half, 0}, options_.ros.dialect);
  }
  const auto& names = projectedTopics();
  const auto index = static_cast<std::size_t>(std::find(names.begin(), names.end(), topic) - names.begin());
  Projection of;
  {
    const std::lock_guard lock(mutex_);
    if (index >= projections_.size()) return {};
    of = projections_[index];
  }
  const int width = static_cast<int>(std::round(of.width / kProjectedCellM)),
            height = static_cast<int>(std::round(of.height / kProjectedCellM));
  const geometry::Pose2 origin{of.x, of.y, 0};
  Value::Int8s cells = building_->cellsFrom(origin, kProjectedCellM, width, height, of.min_z, of.max_z);
  return Value::Object{{"map", gridMessage(kProjectedCellM, width, height, origin, std::move(cells))},
                       {"min_z", of.min_z},
                       {"max_z", of.max_z}};
}

}  // namespace mapwright::simulator::ros
