// Points of large maps: keeps millimetre precision far from 0. Source: sensor_msgs/PointCloud2.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "robot/ros/cloud_layout.h"
#include "robot/ros/dispatch_messages.h"
#include "robot/ros/faults.h"
#include "robot/ros/parts.h"

namespace mapwright::robot::ros {
namespace {

constexpr std::size_t kMostBytes = std::size_t(1) << 30;
constexpr double kNearM = 1000;  // closer points are precise enough
constexpr std::size_t kSampled = 1001;

bool isPlace(const Eigen::Vector3d& at_m) {
  return std::abs(at_m.x()) <= kFarthestM && std::abs(at_m.y()) <= kFarthestM &&
         std::abs(at_m.z()) <= kFarthestM;
}

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

}  // namespace

Read<std::shared_ptr<const map::SpatialCloud>> readSpatialCloud(const Field& msg) {
  const auto layout = readCloudLayout(msg, kMostBytes);
  if (!layout) return tl::unexpected(layout.error());
  const CloudLayout& of = *layout;
  auto cloud = std::make_shared<map::SpatialCloud>();
  cloud->frame = headerOf(msg).frame;
  if (of.width == 0 || of.height == 0) return cloud;
  const auto data = msg["data"].bytes(kMostBytes);
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

  const std::size_t stride = std::max<std::size_t>(1, strideFor(records.count(), kMostPartPoints));
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
