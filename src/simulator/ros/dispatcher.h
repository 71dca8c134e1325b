// A REP 130 map dispatcher next to the simulated ROS robot (docs/protocols/rep130-map-dispatcher.md): regions
// of a Building as grids and clouds, its projections, and the variations between dispatchers.
#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/fault_plan.h"
#include "simulator/ros/building.h"
#include "simulator/ros/shapes.h"
#include "simulator/value.h"

namespace mapwright::simulator::ros {

struct CallOutcome;

/// Safe from any thread. Its messages have the stamp 0: they do not change with time.
class Dispatcher {
 public:
  Dispatcher(const Options& options, const FaultPlan& faults);

  struct Row {
    std::string_view name, type;
  };
  /// Its services; none if it is disabled.
  std::vector<Row> services() const;
  /// Its present topics.
  std::vector<Row> topics() const;
  bool has(std::string_view service) const;
  CallOutcome call(std::string_view service, const Value& request);
  std::optional<Value> messageOf(std::string_view topic) const;

  /// Increases when a topic has new content.
  struct Edits {
    int projections = 0, map = 0;
    bool operator==(const Edits&) const = default;
  };
  Edits edits() const;
  /// All topics that may ever exist.
  static const std::vector<std::string_view>& projectedTopics();

 private:
  struct Projection {
    std::string frame;
    double x = 0, y = 0, width = 0, height = 0, min_z = 0, max_z = 0;
  };
  struct Region {
    Eigen::Vector2d centre_m, size_m;
  };
  CallOutcome grid(const Region& region, bool whole);
  CallOutcome cloud(const Value& request, bool whole, bool occupancy) const;
  Value projectionsValue() const;
  CallOutcome setProjections(const Value& request);
  Value info(double resolution_m, int width, int height, const geometry::Pose2& origin) const;
  CallOutcome save(const std::string& filename);

  const Options& options_;
  const FaultPlan& faults_;
  const Building building_;
  mutable std::mutex mutex_;
  std::vector<Projection> projections_;
  int calls_ = 0;
  Edits edits_;
};

}  // namespace mapwright::simulator::ros
