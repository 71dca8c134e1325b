// The port: maps that are too large to be sent whole, 2D and 3D, requested by region. Source:
// docs/protocols/rep130-map-dispatcher.md.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QObject>

#include "map/map_part.h"
#include "robot/call.h"

namespace mapwright::robot {

/// What a dispatcher may offer, independently of each other.
enum class DispatchService {
  Grid,               // the plane, whole
  GridRegion,         // a region of it
  Save,               // the robot writes its map to a file on its own disk
  Cloud,              // points, whole
  CloudRegion,        // the points in a box or a sphere
  Occupancy,          // occupied voxels as points, whole
  OccupancyRegion,    // the cells in a box or a sphere
  ReadProjections,    // the list of projections can be read
  ChangeProjections,  // and chosen
};

/// Whether one is there.
struct DispatchOffer {
  DispatchService service = DispatchService::Grid;
  bool offered = false;
  std::string name;  // the name of the service: "/map_dispatcher/get_sub_map". Untrusted plain text
  std::string type;  // as stated by the robot; empty = not stated
  bool operator==(const DispatchOffer&) const = default;
};

enum class CloudKind { Points, Occupancy };

/// The map of one projection, received on its topic.
struct ProjectedPart {
  int index = 0;  // projected_map_<index>
  map::GridPart part;
  double min_z_m = 0, max_z_m = 0;
};

/// The reported size of the whole map. In the frame of the map.
struct MapExtent {
  map::GridReference grid;       // valid, with cells; what is sent may still have another size
  std::int64_t about_bytes = 0;  // estimated transfer size of all cells
  std::int64_t least_bytes = 0;  // no fewer
  std::int64_t most_bytes = 0;   // the connection fails with a longer answer; 0 = no known limit
  /// It cannot be sent at once, whatever its cells are.
  bool beyondLink() const { return most_bytes > 0 && least_bytes > most_bytes; }
  bool operator==(const MapExtent&) const = default;
};

/// Capability: a map dispatcher. Call it on the thread that made the robot; results arrive there, too. See
/// robot/call.h for how a request ends. Answers are parsed on another thread; cancelling a call does not stop
/// the robot's work on it. The caller limits the number of concurrent calls.
class MapDispatch : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  /// Each service once, offered or not.
  virtual std::vector<DispatchOffer> offers() const = 0;
  bool offered(DispatchService service) const {
    const std::vector<DispatchOffer> all = offers();
    return std::any_of(all.begin(), all.end(), [service](const DispatchOffer& offer) {
      return offer.service == service && offer.offered;
    });
  }
  /// nullopt: the whole map. Regions with non-finite numbers, or without size, are refused without a request
  /// (FailureKind::Refused).
  virtual Call grid(const std::optional<map::GridRegion>& region, OutcomeTo<map::GridPart> reply) = 0;
  /// nullopt: the robot does not report it, or it is invalid.
  virtual std::optional<MapExtent> extent() const { return std::nullopt; }
  virtual Call cloud(CloudKind kind, const std::optional<map::CloudRegion>& region,
                     OutcomeTo<std::shared_ptr<const map::SpatialCloud>> reply) = 0;
  /// `filename`: on the robot; its extension selects the format. Returns the name that was sent.
  virtual Call save(const std::string& filename, OutcomeTo<std::string> reply) = 0;
  /// The current projections, as reported by the robot.
  virtual Call projections(OutcomeTo<std::vector<map::Projection>> reply) = 0;
  /// Returns the projections that the robot reports afterwards, which may differ.
  virtual Call project(const std::vector<map::Projection>& wanted,
                       OutcomeTo<std::vector<map::Projection>> reply) = 0;
  /// The reported projected maps, the newest of each.
  virtual std::vector<ProjectedPart> projected() const = 0;
  /// The topics on which the robot should send projected maps but has sent nothing so far. Untrusted plain
  /// text.
  virtual std::vector<std::string> silent() const { return {}; }

 Q_SIGNALS:
  void offersChanged();
  /// The robot's map has changed: fetched parts may be outdated.
  void mapChanged();
  void extentChanged();
  /// The part with that index in projected() was replaced or removed.
  void projectedChanged(int index);
};

}  // namespace mapwright::robot
