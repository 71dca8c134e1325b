// Clouds of points: as lists, as packed records and as the binary PointCloud message. Pure functions, any
// thread. Source: docs/protocols/autoxing.md, "Point clouds".
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "map/live_topics.h"
#include "robot/wire/read_json.h"

namespace ros_messages {
class PointCloud;
}

namespace mapwright::robot::axbot {

/// Collects points. Skips those that are not finite or absurdly far away, and takes at most kMaxPoints.
/// Intensities come as 0..1 or 0..255; their maximum tells which.
class CloudPoints {
 public:
  static constexpr std::size_t kMaxPoints = 2'000'000;
  static constexpr double kFarthestM = 1e7;

  bool full() const { return points_.size() >= kMaxPoints; }
  std::size_t count() const { return points_.size(); }
  void reserve(std::size_t count) {
    points_.reserve(std::min(count, kMaxPoints));
    intensities_.reserve(std::min(count, kMaxPoints));
  }
  /// World metres.
  void add(double x, double y, double z, double intensity) {
    if (full() || !(std::abs(x) <= kFarthestM) || !(std::abs(y) <= kFarthestM)) return;
    points_.push_back({x, y, std::isfinite(z) ? float(z) : 0, 0});
    const float kept = intensity > 0 && std::isfinite(intensity) ? float(intensity) : 0;
    brightest_ = std::max(brightest_, kept);
    intensities_.push_back(kept);
  }
  /// Takes them out. `bytes`: intensities are certainly 0..255.
  map::PointCloudMessage message(const std::string& topic, bool bytes = false) {
    const float scale = brightest_ <= 1 && !bytes ? 255 : 1;
    for (std::size_t i = 0; i < points_.size() && brightest_ > 0; ++i) {
      points_[i].intensity = std::uint8_t(std::min(255.0f, intensities_[i] * scale + 0.5f));
    }
    return {topic, std::make_shared<const std::vector<map::CloudPoint>>(std::move(points_))};
  }

 private:
  std::vector<map::CloudPoint> points_;
  std::vector<float> intensities_;
  float brightest_ = 0;
};

bool isCloudTopic(const std::string& topic);
/// The message of a cloud topic, with its points as a list or as fields and data.
map::TopicMessage readCloud(const std::string& topic, const wire::Json& message);
/// The same for a binary message.
map::TopicMessage readCloud(const std::string& topic, const ros_messages::PointCloud& message);

}  // namespace mapwright::robot::axbot
