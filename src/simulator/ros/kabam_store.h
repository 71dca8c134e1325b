// The maps, waypoints and state of the simulated KABAM MapManagerV2 (docs/protocols/kabam-map-manager.md).
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/map_pictures.h"
#include "simulator/robot_state.h"
#include "simulator/ros/ros_options.h"
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

// The services' own codes.
enum class SaveResult { Saved = 0, Invalid = 1, NameExists = 2, Failed = 3 };
enum class LoadResult { Loaded = 0, NoSuchMap = 1, AlreadyLoaded = 2, Invalid = 3, Failed = 4 };
enum class UpdateResult { Updated = 0, Deleted = 1, NoSuchMap = 2, Invalid = 3, Failed = 4 };
enum class WaypointResult {
  Created = 0,
  NoSuchMap = 1,
  NameExists = 2,
  Updated = 3,
  NotFound = 4,
  Deleted = 5,
  Failed = 6
};

/// Which topics have to be sent again.
struct KabamEdits {
  std::uint64_t info = 0, lists = 0, waypoints = 0, picture = 0;
  bool operator==(const KabamEdits&) const = default;
};

/// Safe from any thread. A pure function of scene, seed, clock and the requests so far.
class KabamStore {
 public:
  KabamStore(const RobotState& state, MapPictures& pictures, const RosOptions& options, std::uint32_t seed);

  ManagerState state() const;
  std::optional<KabamMap> current() const;  // none unless Active
  std::vector<KabamMap> maps() const;       // archived ones among them
  KabamEdits edits() const;
  /// nullopt if the robot has no map at all.
  std::optional<RasterSource> raster() const;

  /// false if the state does not allow it.
  bool startMapping();
  bool stopMapping();
  SaveResult save(const std::string& name, std::string& id);
  LoadResult load(const std::string& id, const std::string& loc_waypoint_name);
  UpdateResult remove(const std::string& id, bool flag);
  UpdateResult archive(const std::string& id, bool archived);
  UpdateResult relabel(const std::string& id, const std::string& label);
  /// `image` is a complete sensor_msgs/Image.
  UpdateResult replaceImage(const std::string& id, const Value& image);

  /// `info` and the answer are a complete kabam_msgs/MapWaypoint.
  WaypointResult create(const Value& info, Value& answer);
  WaypointResult removeWaypoint(const Value& info, bool flag, Value& answer);
  WaypointResult rename(const Value& info, Value& answer);
  WaypointResult reposition(const Value& info, Value& answer);

  /// Another client changes something different each time.
  void otherOperator();
  /// Another client paints a spot on the current map, each time elsewhere.
  void otherPainter();

 private:
  struct Place {
    KabamMap* map = nullptr;
    KabamWaypoint* waypoint = nullptr;
  };
  std::string newId();
  KabamMap* mapOf(std::string_view id);
  WaypointResult find(const Value& info, Place& place);
  bool nameTaken(const KabamMap& map, std::string_view name, const KabamWaypoint* but) const;
  void takeTags(KabamWaypoint& waypoint, const Value& info) const;
  void touch(KabamMap& map);
  KabamWaypoint waypointAt(const KabamMap& map, double metres, std::string name,
                           std::vector<std::string> tags);
  void furnish(int waypoints);

  const RobotState& robot_;
  MapPictures& pictures_;
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

/// kabam_msgs/MapWaypoint.
Value waypointMessage(const KabamWaypoint& waypoint, std::string_view map_id);

}  // namespace mapwright::simulator::ros
