// A REP 130 map dispatcher next to the simulated ROS robot (docs/protocols/rep130-map-dispatcher.md): regions
// of a building of five storeys as grids and clouds, its projections, and the variations between dispatchers.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/ros/kabam_store.h"
#include "simulator/ros/message_types.h"
#include "simulator/ros/ros_messages.h"

namespace mapwright::simulator::ros {

class Building;

/// Safe from any thread. Its messages have the stamp 0: they do not change with time.
class Dispatcher {
 public:
  Dispatcher(const Options& options, const FaultPlan& faults);
  ~Dispatcher();

  /// Its services; none if it is disabled.
  std::vector<Service> services();
  /// Null for topics that it does not have at present.
  Value messageOf(std::string_view topic) const;
  /// False for a topic of a projection that is not set.
  bool has(std::string_view topic) const;

  /// Increases when a topic has new content.
  struct Edits {
    int projections = 0, map = 0;
    bool operator==(const Edits&) const = default;
  };
  Edits edits() const;
  /// The topics of all projections that may ever be set.
  static const std::vector<std::string_view>& projectedTopics();

 private:
  struct Projection {
    double x = 0, y = 0, width = 0, height = 0, min_z = 0, max_z = 0;
  };
  struct Region {
    Eigen::Vector2d centre_m, size_m;
  };
  Answer grid(const Value& request, bool whole);
  Answer cloud(const Value& request, bool whole, bool occupancy) const;
  Answer projections(const Value& request);
  Value gridMessage(double resolution_m, int width, int height, const geometry::Pose2& origin,
                    Value::Int8s cells) const;

  const Options& options_;
  const FaultPlan& faults_;
  const std::unique_ptr<const Building> building_;
  mutable std::mutex mutex_;
  std::vector<Projection> projections_;
  int calls_ = 0;
  Edits edits_;
};

}  // namespace mapwright::simulator::ros
