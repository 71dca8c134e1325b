// Fetches a cloud of points from a map dispatcher: what lies outside of the region that was asked for is
// cropped, and what is missing is told.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include <QStringList>

#include "map/map_part.h"
#include "robot/map_dispatch.h"
#include "work/workers.h"

namespace mapwright::jobs {

struct FetchedCloud {
  std::shared_ptr<const map::SpatialCloud> cloud;  // never null
  std::uint64_t beyond = 0;                        // points outside of the region, cropped

  /// The robot has answered with another region: nothing of what came lies in the one that was asked for.
  bool elsewhere() const { return beyond > 0 && cloud->points.empty(); }
  /// Points that were announced did not come.
  bool complete() const { return cloud->missing == 0; }
  /// What people should know of it, a sentence each.
  QStringList notes() const;
};

/// `region`: nullopt = the whole map. Called on the thread of the robot; the points are cropped on `workers`.
/// Nothing comes when the dispatcher goes before.
robot::Call fetchCloud(robot::MapDispatch& dispatch, robot::CloudKind kind,
                       const std::optional<map::CloudRegion>& region, std::shared_ptr<work::Workers> workers,
                       robot::OutcomeTo<FetchedCloud> reply);

}  // namespace mapwright::jobs
