// Scans and clouds of points. Those of large maps keep millimetre precision far from 0. Source:
// sensor_msgs/LaserScan, MultiEchoLaserScan, PointCloud, PointCloud2, PointField.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "robot/ros/dispatch_messages.h"
#include "robot/ros/faults.h"
#include "robot/ros/parts.h"
#include "robot/wire/faults.h"
#include "robot/wire/packed_number.h"

namespace mapwright::robot::ros {
namespace {

constexpr std::size_t kMostRays = 10'000'000;
constexpr std::size_t kMostEchoes = 1'000;
constexpr std::size_t kMostCloudBytes = std::size_t(256) << 20;
constexpr std::size_t kMostPartBytes = std::size_t(1) << 30;
constexpr double kLongestSweepS = 5;  // longer is not a plausible scan time
constexpr double kNearM = 1000;       // closer points are precise enough
constexpr std::size_t kSampled = 1001;

using wire::PackedNumber;

/// The layout of points in the bytes of a PointCloud2.
struct CloudLayout {
  std::optional<PackedNumber> x, y, z, intensity;
  std::optional<PackedNumber> color;  // "rgb" or "rgba": four bytes, 0xAARRGGBB
  std::vector<std::string> outside;   // required fields that extend beyond the record
  std::size_t width = 0, height = 0, point_step = 0, row_step = 0;
  bool big_endian = false;
};

/// The product of any two of its numbers does not overflow: none exceeds `most_bytes`, which is below 2^31.
/// If there are no points, nothing else is read.
Read<CloudLayout> readCloudLayout(const Field& msg, std::size_t most_bytes) {
  // More would not fit into the data; products of two of them do not overflow.
  const auto most = std::int64_t(most_bytes);
  CloudLayout layout;
  const auto readSize = [&](const char* name, std::size_t& to) -> std::optional<Fault> {
    const auto value = msg[name].integer();
    if (!value) return fieldMissing(name).value();
    if (*value < 0 || *value > most) return fieldWrong(name, double(*value)).value();
    to = std::size_t(*value);
    return std::nullopt;
  };
  for (const auto& why : {readSize("width", layout.width), readSize("height", layout.height),
                          readSize("point_step", layout.point_step)}) {
    if (why) return tl::unexpected(*why);
  }
  // Without points the layout does not matter: many senders omit it then.
  if (layout.width == 0 || layout.height == 0) return layout;
  if (layout.point_step == 0) return fieldWrong("point_step", 0);
  const auto row_step = msg["row_step"].integer();
  const std::size_t packed = layout.width * layout.point_step;
  // Senders of clouds with a single row often omit it.
  layout.row_step = row_step && *row_step > 0 ? std::size_t(*row_step) : packed;
  if (layout.height > 1 && layout.row_step < packed) return fieldWrong("row_step", double(layout.row_step));
  layout.big_endian = msg["is_bigendian"].flag().value_or(false);

  const Field fields = msg["fields"];
  if (!fields.isList()) return fieldMissing("fields");
  fields.each([&layout](const Field& row) {
    const std::string name = row["name"].text();
    const auto type = row["datatype"].integer(), offset = row["offset"].integer();
    const bool color = name == "rgb" || name == "rgba";
    std::optional<PackedNumber>* const wanted = name == "x"           ? &layout.x
                                                : name == "y"         ? &layout.y
                                                : name == "z"         ? &layout.z
                                                : name == "intensity" ? &layout.intensity
                                                : color               ? &layout.color
                                                                      : nullptr;
    if (!wanted) return;
    const bool known = type && *type >= 1 && *type <= 8 && offset && *offset >= 0;
    const PackedNumber number =
        known ? PackedNumber{wire::NumberType(*type), std::size_t(*offset)} : PackedNumber{};
    if (!known || !number.liesIn(layout.point_step)) {
      if (layout.outside.size() < 8) layout.outside.push_back(name);
      return;
    }
    if (color && wire::bytesOf(number.type) != 4) return;
    *wanted = number;
  });
  if (!layout.x || !layout.y) return tl::unexpected(Fault(robot::wire::fault::PointsWithoutFields));
  return layout;
}

/// There are fewer bytes than the layout needs.
Fault cloudCutShort(const CloudLayout& layout, std::size_t bytes) {
  const double needed =
      double(layout.height - 1) * double(layout.row_step) + double(layout.width) * double(layout.point_step);
  return {fault::RosLengthDiffers, {"data", std::int64_t(bytes), std::int64_t(std::min(needed, 9e18))}};
}

/// Its complete points.
class Records {
 public:
  Records(const CloudLayout& layout, const std::string& data) : of_(layout), data_(data) {
    if (of_.width == 0 || of_.height == 0 || of_.point_step == 0) return;
    // With division: malicious sizes may overflow in a product.
    const std::size_t last_row = of_.width * of_.point_step;
    if (data.size() < last_row) {
      count_ = data.size() / of_.point_step;
      return;
    }
    const std::size_t rows = std::min(of_.height, (data.size() - last_row) / of_.row_step + 1);
    count_ = rows * of_.width;
    if (rows == of_.height) return;
    const std::size_t rest = data.size() - last_row - (rows - 1) * of_.row_step;
    const std::size_t gap = of_.row_step - last_row;
    if (rest > gap) count_ += std::min(of_.width, (rest - gap) / of_.point_step);
  }
  /// Number of complete points.
  std::size_t count() const { return count_; }
  const char* at(std::size_t i) const {
    return data_.data() + i / of_.width * of_.row_step + i % of_.width * of_.point_step;
  }
  Eigen::Vector3d point(std::size_t i) const {
    const char* const record = at(i);
    return {wire::numberAt(record, *of_.x, of_.big_endian), wire::numberAt(record, *of_.y, of_.big_endian),
            of_.z ? wire::numberAt(record, *of_.z, of_.big_endian) : 0};
  }

 private:
  const CloudLayout& of_;
  const std::string& data_;
  std::size_t count_ = 0;
};

/// The centre of the points, ignoring invalid ones; 0 if that is near.
Eigen::Vector3d originOf(const Records& records) {
  std::array<std::vector<double>, 3> along;
  const std::size_t step = std::max<std::size_t>(1, records.count() / kSampled);
  for (std::size_t i = 0; i < records.count(); i += step) {
    const Eigen::Vector3d at = records.point(i);
    if (!isPlace(at)) continue;
    for (int axis = 0; axis < 3; ++axis) along[std::size_t(axis)].push_back(at[axis]);
  }
  Eigen::Vector3d origin(0, 0, 0);
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double>& values = along[std::size_t(axis)];
    if (values.empty()) continue;
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (std::abs(*middle) > kNearM) origin[axis] = std::round(*middle);
  }
  return origin;
}

/// Collects points. The unit of intensities depends on the sensor and is derived from all of them.
class PointList {
 public:
  void reserve(std::size_t count) {
    points_.reserve(count);
    intensities_.reserve(count);
  }
  /// Points that are not finite, or farther than 10,000 km, are skipped: false.
  bool add(const Eigen::Vector3d& at_m, double intensity) {
    if (!isPlace(at_m)) {
      leaveOut();
      return false;
    }
    points_.push_back({at_m.x(), at_m.y(), float(at_m.z()), 0});
    const float kept = intensity > 0 && std::isfinite(intensity) ? float(std::min(intensity, 1e30)) : 0;
    brightest_ = std::max(brightest_, kept);
    intensities_.push_back(kept);
    return true;
  }
  void leaveOut() { ++left_out_; }
  /// `came`: before they were thinned. `bytes`: intensities are 0..255 in any case.
  Points points(Header header, std::size_t came, bool bytes) && {
    // 0..1, 0..255, or counts of the sensor without a known maximum.
    const float scale = bytes || (brightest_ > 1 && brightest_ <= 255) ? 1
                        : brightest_ <= 1                              ? 255
                                                                       : 255 / brightest_;
    for (std::size_t i = 0; i < points_.size() && brightest_ > 0; ++i)
      points_[i].intensity = std::uint8_t(std::min(255.0f, intensities_[i] * scale + 0.5f));
    Points all;
    all.header = std::move(header);
    all.points = std::move(points_);
    all.left_out = left_out_;
    if (const std::size_t stride = strideFor(came, kMostPoints); stride > 1)
      all.notes.push_back({fault::RosPointsThinned, {std::int64_t(came), std::int64_t(stride)}});
    return all;
  }

 private:
  std::vector<map::CloudPoint> points_;
  std::vector<float> intensities_;
  float brightest_ = 0;
  std::size_t left_out_ = 0;
};

}  // namespace

Read<Points> readLaserScan(const Field& msg) {
  const double angle_min = numberOr(msg["angle_min"], kNaN);
  const double angle_step = numberOr(msg["angle_increment"], kNaN);
  if (!std::isfinite(angle_min)) return fieldMissing("angle_min");
  if (!std::isfinite(angle_step)) return fieldMissing("angle_increment");
  const Field list = msg["ranges"];
  const auto ranges = list.numbers(kMostRays);
  if (!ranges) return fieldMissing("ranges");
  const double nearest = numberOr(msg["range_min"], 0), farthest_said = numberOr(msg["range_max"], 0);
  const double farthest = farthest_said > nearest ? farthest_said : std::numeric_limits<double>::infinity();
  auto intensities = msg["intensities"].numbers(kMostRays);
  if (intensities && intensities->size() != ranges->size()) intensities.reset();

  const std::size_t stride = strideFor(ranges->size(), kMostPoints);
  const double steps = ranges->size() > 1 ? double(ranges->size() - 1) : 1;
  const double sweep_s = numberOr(msg["time_increment"], 0) * steps;
  const bool sweeps = sweep_s > 0 && sweep_s <= kLongestSweepS;
  std::vector<float> when;
  PointList points;
  points.reserve(ranges->size() / stride + 1);
  for (std::size_t i = 0; i < ranges->size(); i += stride) {
    const double range = (*ranges)[i], angle = angle_min + double(i) * angle_step;
    const bool hit = range >= nearest && range <= farthest;
    if (!hit) points.leaveOut();
    if (hit &&
        points.add({range * std::cos(angle), range * std::sin(angle), 0},
                   intensities ? (*intensities)[i] : 0) &&
        sweeps)
      when.push_back(float(double(i) / steps));
  }
  Points read = std::move(points).points(headerOf(msg), ranges->size(), false);
  if (sweeps) {
    read.sweep_s = sweep_s;
    read.when = std::move(when);
  }
  return read;
}

Read<Points> readMultiEchoScan(const Field& msg) {
  const double angle_min = numberOr(msg["angle_min"], kNaN);
  const double angle_step = numberOr(msg["angle_increment"], kNaN);
  if (!std::isfinite(angle_min)) return fieldMissing("angle_min");
  if (!std::isfinite(angle_step)) return fieldMissing("angle_increment");
  const Field list = msg["ranges"];
  if (!list.isList()) return fieldMissing("ranges");
  const double nearest = numberOr(msg["range_min"], 0), farthest_said = numberOr(msg["range_max"], 0);
  const double farthest = farthest_said > nearest ? farthest_said : std::numeric_limits<double>::infinity();
  std::vector<std::vector<double>> intensities;
  msg["intensities"].each([&](const Field& ray) {
    if (intensities.size() < kMostRays)
      intensities.push_back(ray["echoes"].numbers(kMostEchoes).value_or(std::vector<double>()));
  });
  PointList points;
  std::size_t ray = 0, echoes = 0;
  list.each([&](const Field& of) {
    const std::size_t index = ray++;
    const auto ranges = of["echoes"].numbers(kMostEchoes);
    if (!ranges) return points.leaveOut();
    const double angle = angle_min + double(index) * angle_step;
    for (std::size_t i = 0; i < ranges->size() && echoes < kMostPoints; ++i) {
      const double range = (*ranges)[i];
      if (!(range >= nearest && range <= farthest)) {
        points.leaveOut();
        continue;
      }
      const bool bright = index < intensities.size() && i < intensities[index].size();
      points.add({range * std::cos(angle), range * std::sin(angle), 0}, bright ? intensities[index][i] : 0);
      ++echoes;
    }
  });
  return std::move(points).points(headerOf(msg), echoes, false);
}

Read<Points> readPointCloud1(const Field& msg) {
  const Field list = msg["points"];
  if (!list.isList()) return fieldMissing("points");
  std::optional<std::vector<double>> intensities;
  msg["channels"].each([&](const Field& channel) {
    const std::string name = channel["name"].text();
    if (name == "intensity" || name == "intensities") intensities = channel["values"].numbers(kMostRays);
  });
  if (intensities && intensities->size() != list.size()) intensities.reset();
  const std::size_t stride = strideFor(list.size(), kMostPoints);
  PointList points;
  points.reserve(list.size() / stride + 1);
  std::size_t index = 0;
  list.each([&](const Field& item) {
    const std::size_t at = index++;
    if (at % stride == 0) points.add(pointOf(item), intensities ? (*intensities)[at] : 0);
  });
  return std::move(points).points(headerOf(msg), list.size(), false);
}

Read<Points> readPointCloud2(const Field& msg) {
  const auto layout = readCloudLayout(msg, kMostCloudBytes);
  if (!layout) return tl::unexpected(layout.error());
  const CloudLayout& of = *layout;
  const auto data = msg["data"].bytes(kMostCloudBytes);
  if (!data) return fieldMissing("data");
  const Records records(of, *data);
  const std::size_t count = of.width * of.height;
  if (records.count() < count) return tl::unexpected(cloudCutShort(of, data->size()));
  const std::size_t stride = strideFor(count, kMostPoints);
  PointList points;
  points.reserve(count / stride + 1);
  for (std::size_t i = 0; i < count; i += stride) {
    points.add(records.point(i),
               of.intensity ? wire::numberAt(records.at(i), *of.intensity, of.big_endian) : 0);
  }
  const bool bytes = of.intensity && wire::isByte(of.intensity->type);
  return std::move(points).points(headerOf(msg), count, bytes);
}

Read<std::shared_ptr<const map::SpatialCloud>> readSpatialCloud(const Field& msg) {
  const auto layout = readCloudLayout(msg, kMostPartBytes);
  if (!layout) return tl::unexpected(layout.error());
  const CloudLayout& of = *layout;
  auto cloud = std::make_shared<map::SpatialCloud>();
  cloud->frame = headerOf(msg).frame;
  if (of.width == 0 || of.height == 0) return cloud;
  const auto data = msg["data"].bytes(kMostPartBytes);
  if (!data) return fieldMissing("data");
  const Records records(of, *data);
  const std::size_t said = of.width * of.height;
  if (records.count() == 0) return tl::unexpected(cloudCutShort(of, data->size()));
  // Fewer bytes than stated mean missing points; more may mean a wrong size.
  const double packed = double(of.width) * double(of.point_step),
               least = packed + double(of.height - 1) * double(of.row_step),
               most = std::max(least, double(of.height) * double(of.row_step));
  if (records.count() < said || (double(data->size()) != least && double(data->size()) != most))
    cloud->notes.push_back(cloudCutShort(of, data->size()));
  // Rows may be padded, but not by whole points.
  else if (double(data->size()) == most && double(of.row_step) - packed >= double(of.point_step))
    cloud->notes.push_back({fault::RosRowsHoldMore, {std::int64_t(of.row_step), std::int64_t(packed)}});
  cloud->missing = said - std::min(said, records.count());
  for (const std::string& name : of.outside)
    cloud->notes.push_back({fault::RosFieldMissing, {"fields." + name}});
  cloud->has_z = of.z.has_value();
  cloud->origin_m = originOf(records);

  const std::size_t stride = strideFor(records.count(), kMostPartPoints);
  if (stride > 1) {
    cloud->notes.push_back({fault::RosPointsThinned, {std::int64_t(records.count()), std::int64_t(stride)}});
  }
  const std::size_t kept = records.count() / stride + 1;
  cloud->points.reserve(kept);
  if (of.intensity) cloud->intensity.reserve(kept);
  if (of.color) cloud->rgb.reserve(kept);
  for (std::size_t i = 0; i < records.count(); i += stride) {
    const Eigen::Vector3d at = records.point(i);
    if (!isPlace(at)) {
      ++cloud->left_out;
      continue;
    }
    cloud->points.push_back((at - cloud->origin_m).cast<float>());
    const char* const record = records.at(i);
    if (of.intensity) {
      const double value = wire::numberAt(record, *of.intensity, of.big_endian);
      cloud->intensity.push_back(std::isfinite(value) ? float(std::clamp(value, -1e30, 1e30)) : 0);
    }
    // Four bytes, whatever they are read as: a colour may be called a float.
    if (of.color)
      cloud->rgb.push_back(wire::rawNumber<std::uint32_t>(record + of.color->offset, of.big_endian) &
                           0xffffff);
  }
  return cloud;
}

}  // namespace mapwright::robot::ros
