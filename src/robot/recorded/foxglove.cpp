#include "robot/recorded/foxglove.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <QCborArray>
#include <QCborMap>
#include <QCborValue>

#include "robot/ros/faults.h"
#include "robot/wire/faults.h"
#include "robot/wire/packed_number.h"

namespace mapwright::robot::recorded {
namespace {

using net::rosbridge::Field;
template <typename T>
using Read = tl::expected<T, Fault>;

constexpr std::size_t kMostBytes = std::size_t(256) << 20;  // of the cells and points of one message
constexpr std::size_t kMostNumbers = 10'000'000;
constexpr std::int64_t kMostCells = std::int64_t(1) << 28;
constexpr int kInt8List = 72;  // RFC 8746, 2.1
constexpr std::int8_t kUnknown = -1, kOccupied = 100;

struct KindName {
  FoxgloveKind kind;
  std::string_view name;
  const char* ros_type;
};
constexpr KindName kKinds[] = {{FoxgloveKind::Grid, "Grid", "nav_msgs/OccupancyGrid"},
                               {FoxgloveKind::LaserScan, "LaserScan", "sensor_msgs/PointCloud2"},
                               {FoxgloveKind::PointCloud, "PointCloud", "sensor_msgs/PointCloud2"},
                               {FoxgloveKind::PoseInFrame, "PoseInFrame", "geometry_msgs/PoseStamped"},
                               {FoxgloveKind::PosesInFrame, "PosesInFrame", "nav_msgs/Path"},
                               {FoxgloveKind::FrameTransform, "FrameTransform", "tf2_msgs/TFMessage"},
                               {FoxgloveKind::FrameTransforms, "FrameTransforms", "tf2_msgs/TFMessage"}};

tl::unexpected<Fault> missing(const char* member) {
  return tl::unexpected(Fault(robot::ros::fault::RosFieldMissing, {member}));
}

using wire::NumberType;
using Packed = wire::PackedNumber;
using PackedFields = std::vector<std::pair<std::string, Packed>>;

/// NumericType, by its name or by its number in the schema.
std::optional<NumberType> typeOf(const Field& field) {
  constexpr std::pair<std::string_view, NumberType> kTypes[] = {
      {"UINT8", NumberType::U8},    {"INT8", NumberType::I8},    {"UINT16", NumberType::U16},
      {"INT16", NumberType::I16},   {"UINT32", NumberType::U32}, {"INT32", NumberType::I32},
      {"FLOAT32", NumberType::F32}, {"FLOAT64", NumberType::F64}};
  if (const auto number = field.integer()) {
    const bool known = *number > 0 && *number <= std::int64_t(std::size(kTypes));
    return known ? std::optional(kTypes[*number - 1].second) : std::nullopt;
  }
  const std::string name = field.text();
  for (const auto& [called, type] : kTypes) {
    if (called == name) return type;
  }
  return std::nullopt;
}

/// Those inside a record of `stride` bytes.
PackedFields packedFields(const Field& fields, std::size_t stride) {
  constexpr std::size_t kMostFields = 256;
  PackedFields all;
  fields.each([&](const Field& field) {
    const auto type = typeOf(field["type"]);
    // What is 0 may be left out.
    const auto offset = field["offset"].isNull() ? std::optional<std::int64_t>(0) : field["offset"].integer();
    if (!type || !offset || *offset < 0 || all.size() >= kMostFields) return;
    const Packed number{*type, std::size_t(*offset)};
    if (number.liesIn(stride)) all.emplace_back(field["name"].text(), number);
  });
  return all;
}

std::optional<Packed> called(const PackedFields& fields, std::string_view name) {
  const auto found =
      std::find_if(fields.begin(), fields.end(), [&](const auto& field) { return field.first == name; });
  return found == fields.end() ? std::nullopt : std::optional(found->second);
}

QByteArray cborOf(const QCborMap& map) { return map.toCborValue().toCbor(); }

/// {"sec","nsec"} of JSON, {"seconds","nanos"} of protobuf, a time of ROS.
QCborMap timeOf(const Field& time) {
  const auto part = [&](std::initializer_list<const char*> names) -> qint64 {
    for (const char* name : names) {
      if (const auto value = time[name].integer()) return *value;
    }
    return 0;
  };
  return {{QStringLiteral("secs"), part({"sec", "seconds", "secs"})},
          {QStringLiteral("nsecs"), part({"nsec", "nanos", "nsecs", "nanosec"})}};
}

QCborValue text(const Field& field) { return QString::fromStdString(field.text()); }

QCborMap headerOf(const Field& message, const char* frame = "frame_id") {
  return {{QStringLiteral("stamp"), timeOf(message["timestamp"])},
          {QStringLiteral("frame_id"), text(message[frame])}};
}

double numberOf(const Field& field, double otherwise) { return field.number().value_or(otherwise); }

QCborMap vectorOf(const Field& vector) {
  return {{QStringLiteral("x"), numberOf(vector["x"], 0)},
          {QStringLiteral("y"), numberOf(vector["y"], 0)},
          {QStringLiteral("z"), numberOf(vector["z"], 0)}};
}

/// By default no rotation; protobuf omits zeros.
Eigen::Quaterniond turnOf(const Field& turn) {
  const Eigen::Quaterniond q(numberOf(turn["w"], 0), numberOf(turn["x"], 0), numberOf(turn["y"], 0),
                             numberOf(turn["z"], 0));
  return q.norm() > 1e-6 && std::isfinite(q.norm()) ? q.normalized() : Eigen::Quaterniond::Identity();
}

QCborMap turnMap(const Field& turn) {
  const Eigen::Quaterniond q = turnOf(turn);
  return {{QStringLiteral("x"), q.x()},
          {QStringLiteral("y"), q.y()},
          {QStringLiteral("z"), q.z()},
          {QStringLiteral("w"), q.w()}};
}

QCborMap poseOf(const Field& pose) {
  return {{QStringLiteral("position"), vectorOf(pose["position"])},
          {QStringLiteral("orientation"), turnMap(pose["orientation"])}};
}

Eigen::Isometry3d transformOf(const Field& pose) {
  const Field at = pose["position"];
  Eigen::Isometry3d transform(turnOf(pose["orientation"]));
  transform.translation() = Eigen::Vector3d(numberOf(at["x"], 0), numberOf(at["y"], 0), numberOf(at["z"], 0));
  return transform;
}

/// Points as floats, x y z and intensity.
class Points {
 public:
  explicit Points(const Field& pose) : transform_(transformOf(pose)) {}
  void reserve(std::size_t count) { bytes_.reserve(qsizetype(count * kRecord)); }
  void add(const Eigen::Vector3d& at, double intensity) {
    const Eigen::Vector3d placed = transform_ * at;
    if (!placed.allFinite()) return;
    for (const double value : {placed.x(), placed.y(), placed.z(), intensity}) {
      const float number = float(value);
      bytes_.append(reinterpret_cast<const char*>(&number), sizeof(number));
    }
  }
  QByteArray message(const Field& of) const {
    QCborArray fields;
    int offset = 0;
    for (const char* name : {"x", "y", "z", "intensity"}) {
      fields.append(QCborMap{{QStringLiteral("name"), QString::fromLatin1(name)},
                             {QStringLiteral("offset"), offset},
                             {QStringLiteral("datatype"), 7},
                             {QStringLiteral("count"), 1}});
      offset += int(sizeof(float));
    }
    const QCborMap cloud{{QStringLiteral("header"), headerOf(of)},
                         {QStringLiteral("height"), 1},
                         {QStringLiteral("width"), qint64(std::size_t(bytes_.size()) / kRecord)},
                         {QStringLiteral("fields"), fields},
                         {QStringLiteral("is_bigendian"), false},
                         {QStringLiteral("point_step"), qint64(kRecord)},
                         {QStringLiteral("row_step"), qint64(bytes_.size())},
                         {QStringLiteral("data"), bytes_},
                         {QStringLiteral("is_dense"), true}};
    return cborOf(cloud);
  }

 private:
  static constexpr std::size_t kRecord = 4 * sizeof(float);
  Eigen::Isometry3d transform_;
  QByteArray bytes_;
};

Read<QByteArray> scan(const Field& message) {
  const auto ranges = message["ranges"].isNull() ? std::optional<std::vector<double>>(std::vector<double>())
                                                 : message["ranges"].numbers(kMostNumbers);
  if (!ranges) return missing("ranges");
  const auto strengths = message["intensities"].numbers(kMostNumbers);
  const double from = numberOf(message["start_angle"], 0), to = numberOf(message["end_angle"], 0);
  const double step = ranges->size() > 1 ? (to - from) / double(ranges->size() - 1) : 0;
  Points points(message["pose"]);
  points.reserve(ranges->size());
  for (std::size_t i = 0; i < ranges->size(); ++i) {
    const double range = (*ranges)[i], angle = from + double(i) * step;
    if (!(range > 0) || !std::isfinite(range)) continue;
    const bool has = strengths && i < strengths->size();
    points.add({range * std::cos(angle), range * std::sin(angle), 0}, has ? (*strengths)[i] : 0);
  }
  return points.message(message);
}

Read<QByteArray> cloud(const Field& message) {
  const auto stride = message["point_stride"].integer();
  if (!stride || *stride <= 0 || std::size_t(*stride) > kMostBytes) return missing("point_stride");
  const auto data = message["data"].isNull() ? std::optional<std::string>(std::string())
                                             : message["data"].bytes(kMostBytes);
  if (!data) return missing("data");
  const auto fields = packedFields(message["fields"], std::size_t(*stride));
  const auto x = called(fields, "x"), y = called(fields, "y"), z = called(fields, "z");
  auto strength = called(fields, "intensity");
  if (!x || !y) return tl::unexpected(Fault(robot::wire::fault::PointsWithoutFields));
  const std::size_t count = data->size() / std::size_t(*stride);
  Points points(message["pose"]);
  points.reserve(std::min(count, kMostNumbers));
  for (std::size_t i = 0; i < std::min(count, kMostNumbers); ++i) {
    const char* const record = data->data() + i * std::size_t(*stride);
    points.add({wire::numberAt(record, *x), wire::numberAt(record, *y), z ? wire::numberAt(record, *z) : 0},
               strength ? wire::numberAt(record, *strength) : 0);
  }
  return points.message(message);
}

/// The occupancy of a cell. Colours are those of a map picture: dark is occupied, transparent is unknown.
/// Bytes are those of ROS (0..100, 255: unknown), or costs up to 254 if there are any. Fractions are from 0
/// to 1.
class CellReader {
 public:
  explicit CellReader(const PackedFields& fields) {
    red_ = called(fields, "red");
    green_ = called(fields, "green");
    blue_ = called(fields, "blue");
    alpha_ = called(fields, "alpha");
    for (const char* name : {"occupancy", "occupied", "value", "data", "cost"}) {
      if (!value_) value_ = called(fields, name);
    }
    const bool colours = red_ && green_ && blue_;
    if (!value_ && !colours && !fields.empty()) value_ = fields.front().second;
  }
  bool any() const { return value_ || (red_ && green_ && blue_); }
  /// Call it for every cell before reading any.
  void look(const char* record) {
    if (!value_) return;
    const double value = wire::numberAt(record, *value_);
    if (std::isfinite(value) && value != 255) most_ = std::max(most_, value);
  }
  std::int8_t read(const char* record) const {
    if (!value_) {
      if (alpha_ && !(wire::numberAt(record, *alpha_) > 0)) return kUnknown;
      const double most = red_->type == NumberType::F32 || red_->type == NumberType::F64 ? 1 : 255;
      const double light =
          (wire::numberAt(record, *red_) + wire::numberAt(record, *green_) + wire::numberAt(record, *blue_)) /
          (3 * most);
      return within(100 * (1 - light));
    }
    const double value = wire::numberAt(record, *value_);
    if (!std::isfinite(value) || value < 0) return kUnknown;
    if (value_->type == NumberType::F32 || value_->type == NumberType::F64) return within(100 * value);
    if (value > 254) return kUnknown;
    return within(most_ > kOccupied ? value * kOccupied / 254 : value);
  }

 private:
  static std::int8_t within(double value) {
    if (std::isnan(value)) return kUnknown;
    return std::int8_t(std::lround(std::clamp(value, 0.0, double(kOccupied))));
  }
  std::optional<Packed> red_, green_, blue_, alpha_, value_;
  double most_ = 0;
};

Read<QByteArray> grid(const Field& message) {
  const auto columns = message["column_count"].integer();
  const auto row_stride = message["row_stride"].integer(), cell_stride = message["cell_stride"].integer();
  if (!columns || *columns <= 0 || *columns > kMostCells) return missing("column_count");
  if (!cell_stride || *cell_stride <= 0 || *cell_stride > std::int64_t(kMostBytes))
    return missing("cell_stride");
  if (!row_stride || *row_stride < *columns * *cell_stride) return missing("row_stride");
  const auto data = message["data"].bytes(kMostBytes);
  if (!data) return missing("data");
  const Field size = message["cell_size"];
  const double wide = numberOf(size["x"], 0), high = numberOf(size["y"], 0);
  // Cells of a map must be square here.
  if (!(wide > 0) || std::abs(wide - high) > 1e-6 * wide) return missing("cell_size");
  CellReader reader(packedFields(message["fields"], std::size_t(*cell_stride)));
  if (!reader.any()) return missing("fields");
  // The last row may end with its last cell.
  const std::size_t row = std::size_t(*row_stride), cell = std::size_t(*cell_stride);
  const std::size_t packed = std::size_t(*columns) * cell;
  const std::size_t rows = data->size() / row + (data->size() % row >= packed ? 1 : 0);
  if (rows > std::size_t(kMostCells / *columns)) return missing("row_stride");
  const auto each = [&](auto&& visit) {
    for (std::size_t y = 0; y < rows; ++y) {
      const char* const begins = data->data() + y * row;
      for (std::size_t x = 0; x < std::size_t(*columns); ++x) visit(begins + x * cell);
    }
  };
  each([&](const char* record) { reader.look(record); });
  QByteArray cells;
  cells.reserve(qsizetype(rows * std::size_t(*columns)));
  each([&](const char* record) { cells.append(char(reader.read(record))); });
  const QCborMap info{{QStringLiteral("resolution"), wide},
                      {QStringLiteral("width"), qint64(*columns)},
                      {QStringLiteral("height"), qint64(rows)},
                      {QStringLiteral("origin"), poseOf(message["pose"])}};
  const QCborMap map{{QStringLiteral("header"), headerOf(message)},
                     {QStringLiteral("info"), info},
                     {QStringLiteral("data"), QCborValue(QCborTag(kInt8List), QCborValue(cells))}};
  return cborOf(map);
}

QCborMap transform(const Field& message) {
  return {{QStringLiteral("header"), headerOf(message, "parent_frame_id")},
          {QStringLiteral("child_frame_id"), text(message["child_frame_id"])},
          {QStringLiteral("transform"),
           QCborMap{{QStringLiteral("translation"), vectorOf(message["translation"])},
                    {QStringLiteral("rotation"), turnMap(message["rotation"])}}}};
}

QByteArray transforms(const QCborArray& all) { return cborOf({{QStringLiteral("transforms"), all}}); }

}  // namespace

std::optional<FoxgloveKind> foxgloveKind(const recording::Channel& channel) {
  std::string_view name = channel.schema_name;
  for (const std::string_view start : {"foxglove.", "foxglove_msgs/msg/", "foxglove_msgs/"}) {
    if (!name.starts_with(start)) continue;
    name.remove_prefix(start.size());
    for (const KindName& one : kKinds) {
      if (one.name == name) return one.kind;
    }
    return std::nullopt;
  }
  return std::nullopt;
}

const char* rosTypeOf(FoxgloveKind kind) { return kKinds[std::size_t(kind)].ros_type; }

Read<QByteArray> foxgloveToRos(FoxgloveKind kind, const Field& message) {
  switch (kind) {
    case FoxgloveKind::Grid:
      return grid(message);
    case FoxgloveKind::LaserScan:
      return scan(message);
    case FoxgloveKind::PointCloud:
      return cloud(message);
    case FoxgloveKind::PoseInFrame:
      return cborOf(
          {{QStringLiteral("header"), headerOf(message)}, {QStringLiteral("pose"), poseOf(message["pose"])}});
    case FoxgloveKind::PosesInFrame: {
      QCborArray poses;
      const QCborMap header = headerOf(message);
      message["poses"].each([&](const Field& pose) {
        poses.append(QCborMap{{QStringLiteral("header"), header}, {QStringLiteral("pose"), poseOf(pose)}});
      });
      return cborOf({{QStringLiteral("header"), header}, {QStringLiteral("poses"), poses}});
    }
    case FoxgloveKind::FrameTransform:
      return transforms({transform(message)});
    case FoxgloveKind::FrameTransforms: {
      QCborArray all;
      message["transforms"].each([&](const Field& one) { all.append(transform(one)); });
      return transforms(all);
    }
  }
  return missing("schema");
}

}  // namespace mapwright::robot::recorded
