// The maps of a ROS robot: what it sends live, what a map manager keeps, and what a map dispatcher projects.
// Lives on the link's thread.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "robot/ros/dispatch_requests.h"
#include "robot/ros/kabam_requests.h"
#include "robot/ros/live_map.h"
#include "robot/ros/ros_topics.h"
#include "robot/ros/ros_world.h"

namespace mapwright::robot::ros {

class RosMaps {
 public:
  /// All of them outlive this. `sources` are kept up to date by the link.
  struct Parts {
    KabamRequests& kabam;
    DispatchRequests& dispatch;
    LiveMap& live_map;
    const RosWorld& world;
    const std::vector<Source>& sources;
    WhenKnown when_known;
  };
  explicit RosMaps(Parts parts) : of_(std::move(parts)) {}

  void list(const wire::TaskPtr& task, OutcomeTo<std::vector<map::CatalogueEntry>> reply);
  void describe(const wire::TaskPtr& task, const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply);
  /// The map that the robot works with, or a projected one; of others it sends nothing.
  void fetch(const wire::TaskPtr& task, const map::MapKey& key, OutcomeTo<map::WholeMap> reply);

  /// Of the same maps; nothing is asked for that does not come anyway. The whole map of a robot that gives it
  /// by region has one once it has come.
  void thumbnail(const wire::TaskPtr& task, const map::MapKey& key, OutcomeTo<std::string> reply);

 private:
  std::optional<map::CatalogueEntry> liveEntry() const;
  bool hasThumbnail(const map::MapKey& key) const;
  std::shared_ptr<const ProjectedPart> findProjected(const map::MapKey& key) const;
  void listKept(const wire::TaskPtr& task, OutcomeTo<std::vector<map::CatalogueEntry>> reply);
  void describeNow(const wire::TaskPtr& task, const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply);
  Outcome<map::WholeMap> projectedMap(const ProjectedPart& projected) const;

  Parts of_;
};

}  // namespace mapwright::robot::ros
