// Fetches a cloud from a map dispatcher: crops points outside the requested region and reports missing ones.
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
  std::uint64_t beyond = 0;                        // points outside the region, cropped

  /// The robot answered with another region: no point lies in the requested one.
  bool elsewhere() const { return beyond > 0 && cloud->points.empty(); }
  /// False if announced points did not arrive.
  bool complete() const { return cloud->missing == 0; }
  /// Notes for the user, a sentence each.
  QStringList notes() const;
};

/// `region`: nullopt = the whole map. Call it on the robot's thread; points are cropped on `workers`. No
/// result if the dispatcher is destroyed first.
robot::Call fetchCloud(robot::MapDispatch& dispatch, robot::CloudKind kind,
                       const std::optional<map::CloudRegion>& region, std::shared_ptr<work::Workers> workers,
                       robot::OutcomeTo<FetchedCloud> reply);

}  // namespace mapwright::jobs
