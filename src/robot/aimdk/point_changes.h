// Changes of the waypoints of an Agibot robot with newer firmware. Lives on the link's thread. Source:
// docs/protocols/agibot-aimdk.md, "Newer services".
#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include "robot/aimdk/map_changes.h"
#include "robot/aimdk/parse_rpc.h"
#include "robot/waypoint_store.h"
#include "robot/wire/task.h"

namespace mapwright::robot::aimdk {

/// The points, and the size of the pixels on which the robot keeps them.
struct PixelPoints {
  StoredWaypoints stored;
  double pixel_m = 0;  // 0 = not known
};

class PointChanges {
 public:
  /// `link` outlives this.
  PointChanges(AimdkLink& link, const ChangeTimes& times) : link_(link), times_(times) {}

  void read(const wire::TaskPtr& task, const map::MapKey& key, OutcomeTo<PixelPoints> reply);
  /// Sent once; then the robot is asked where it has the point, also if the answer is lost.
  void perform(const wire::TaskPtr& task, const map::MapKey& key, const WaypointRequest& request,
               OutcomeTo<WaypointReceipt> reply);

 private:
  struct Change;
  using ChangePtr = std::shared_ptr<Change>;

  /// The request, given how it is now; or why there is none.
  static Outcome<QByteArray> requestFor(Change& change, const Topology& now, const ParsedMap* frame);
  void send(const ChangePtr& change, const QByteArray& body);
  void look(const ChangePtr& change);
  void endOrRetry(const ChangePtr& change, std::optional<map::Failure> wrong);

  AimdkLink& link_;
  const ChangeTimes times_;
  wire::WaitList waits_;
};

}  // namespace mapwright::robot::aimdk
