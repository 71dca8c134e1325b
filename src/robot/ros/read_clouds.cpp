// Scans and clouds of points. Source: sensor_msgs/LaserScan, PointCloud2, PointField.
#include <algorithm>
#include <cmath>
#include <limits>

#include "robot/ros/cloud_layout.h"
#include "robot/ros/faults.h"
#include "robot/ros/parts.h"

namespace mapwright::robot::ros {
namespace {

constexpr std::size_t kMostRays = 10'000'000;
constexpr std::size_t kMostCloudBytes = std::size_t(256) << 20;
constexpr double kLongestSweepS = 5;  // longer is not a plausible scan time

void noteThinned(Points& points, std::size_t came) {
  if (came <= kMostPoints) return;
  points.notes.push_back(
      {fault::RosPointsThinned, {std::int64_t(came), std::int64_t(strideFor(came, kMostPoints))}});
}

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

  const std::size_t stride = std::max<std::size_t>(1, strideFor(ranges->size(), kMostPoints));
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
        points.add(range * std::cos(angle), range * std::sin(angle), 0,
                   intensities ? (*intensities)[i] : 0) &&
        sweeps)
      when.push_back(float(double(i) / steps));
  }
  Points read = std::move(points).points(headerOf(msg), false);
  if (sweeps) {
    read.sweep_s = sweep_s;
    read.when = std::move(when);
  }
  noteThinned(read, ranges->size());
  return read;
}

Read<Points> readPointCloud2(const Field& msg) {
  const auto layout = readCloudLayout(msg, kMostCloudBytes);
  if (!layout) return tl::unexpected(layout.error());
  const CloudLayout& of = *layout;
  const auto data = msg["data"].bytes(kMostCloudBytes);
  if (!data) return fieldMissing("data");
  const std::size_t count = of.width * of.height;
  if (count > 0) {
    // With division: malicious sizes may overflow in a product.
    const std::size_t last_row = of.width * of.point_step;
    const bool rows_fit =
        last_row <= data->size() && of.height - 1 <= (data->size() - last_row) / of.row_step;
    if (!rows_fit) return tl::unexpected(cloudCutShort(of, data->size()));
  }
  const std::size_t stride = std::max<std::size_t>(1, strideFor(count, kMostPoints));
  PointList points;
  points.reserve(count / stride + 1);
  const auto value = [&](const char* record, const std::optional<NumberPlace>& place) {
    return place ? wire::numberAt(record, *place, of.big_endian) : 0;
  };
  for (std::size_t i = 0; i < count; i += stride) {
    const char* const record = data->data() + i / of.width * of.row_step + i % of.width * of.point_step;
    points.add(value(record, of.x), value(record, of.y), value(record, of.z), value(record, of.intensity));
  }
  const bool bytes = of.intensity && wire::isByte(of.intensity->type);
  Points read = std::move(points).points(headerOf(msg), bytes);
  noteThinned(read, count);
  return read;
}

}  // namespace mapwright::robot::ros
