// The maps, waypoints and state of the simulated KABAM MapManagerV2 (docs/protocols/kabam-map-manager.md),
// and what its services do.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/fault_plan.h"
#include "simulator/pictures.h"
#include "simulator/robot_state.h"
#include "simulator/ros/message_types.h"
#include "simulator/value.h"

namespace mapwright::simulator::ros {

enum class ManagerState { Idle, Mapping, Active };

struct KabamWaypoint {
  std::string name, id, frame_id;
  Value pose;  // geometry_msgs/Pose, complete, as received
  std::vector<std::string> tags;
};

struct KabamMap {
  std::string id, name, label;
  double created_s = 0, updated_s = 0;  // simulated; initial ones are negative
  bool archived = false;
  PictureSpec spec;                          // how to draw the raster,
  std::shared_ptr<const GrayPicture> image;  // or an uploaded one: same size, 0 = occupied, 255 = free
  std::uint64_t picture_edits = 0;           // identifies a raster together with the id
  std::vector<KabamWaypoint> waypoints;
};

/// The present source of a robot's map.
struct RasterSource {
  std::string map_id;  // empty while mapping
  std::uint64_t picture_edits = 0;
  PictureSpec spec;
  std::shared_ptr<const GrayPicture> image;
  bool operator==(const RasterSource&) const = default;
};

/// Which topics have to be sent again.
struct KabamEdits {
  std::uint64_t info = 0, lists = 0, waypoints = 0, picture = 0;
  bool operator==(const KabamEdits&) const = default;
};

/// Safe from any thread. A pure function of scene, seed, clock and the requests so far.
class KabamStore {
 public:
  KabamStore(const RobotState& state, MapPictures& pictures, const FaultPlan& faults, const Options& options);

  ManagerState state() const;
  std::optional<KabamMap> current() const;  // none unless Active
  std::vector<KabamMap> maps() const;       // archived ones among them
  KabamEdits edits() const;
  /// nullopt if the robot has no map at all.
  std::optional<RasterSource> raster() const;

  std::vector<Service> services();

  /// Another client changes something different each time.
  void otherOperator();
  /// Another client paints a spot on the current map, each time elsewhere.
  void otherPainter();

 private:
  enum class WaypointResult;
  using WaypointChange = std::function<WaypointResult(const KabamMap& map, KabamWaypoint& waypoint)>;
  using Call = Value (KabamStore::*)(const Value& request);

  Value answer(Call call, const Value& request, bool keep);
  Value startMapping(const Value& request);
  Value stopMapping(const Value& request);
  Value saveMap(const Value& request);
  Value loadMap(const Value& request);
  Value deleteMap(const Value& request);
  Value archiveMap(const Value& request);
  Value renameMap(const Value& request);
  Value updateMapImage(const Value& request);
  Value createWaypoint(const Value& request);
  Value deleteWaypoint(const Value& request);
  Value renameWaypoint(const Value& request);
  Value repositionWaypoint(const Value& request);
  Value getWaypoint(const Value& request);

  /// Finds the waypoint of a request and changes it, or removes it where `change` says so.
  Value changed(const Value& request, const WaypointChange& change);
  static Value response(WaypointResult result, Value waypoint = {});

  std::string newId();
  KabamMap* mapOf(std::string_view id);
  bool isMapping() const { return state_ == ManagerState::Mapping; }
  PictureSpec mappedUntil(double time_s) const;
  void readTags(KabamWaypoint& waypoint, const Value& info) const;
  void touch(KabamMap& map);
  void setImage(KabamMap& map, GrayPicture image);
  KabamWaypoint waypointAt(const KabamMap& map, double metres, std::string name,
                           std::vector<std::string> tags);
  void furnish(int waypoints);

  const RobotState& robot_;
  MapPictures& pictures_;
  const FaultPlan& faults_;
  const RosOptions options_;
  const std::uint32_t seed_;
  mutable std::mutex mutex_;
  std::vector<KabamMap> maps_;
  std::string current_;  // id; empty unless Active
  ManagerState state_ = ManagerState::Idle;
  std::optional<double> mapping_since_s_;  // of an active or unsaved mapping
  double mapping_until_s_ = 0;             // once stopped
  std::uint64_t ids_ = 0, turns_ = 0, spots_ = 0, picture_edits_ = 0;
  KabamEdits edits_;
};

/// kabam_msgs/MapWaypointList, as the faults leave it; of the waypoint with an id alone if one is given.
Value waypointList(const KabamMap& map, const RosFaults& faults, std::string_view id = {});

}  // namespace mapwright::simulator::ros
