// The port: maps that are too large to be moved whole, in the plane and in space, asked for by region.
// Source: docs/protocols/rep130-map-dispatcher.md.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QObject>

#include "map/map_part.h"
#include "robot/call.h"

namespace mapwright::robot {

/// What a dispatcher may offer, each by itself.
enum class DispatchService {
  Grid,               // the plane, whole
  GridRegion,         // a region of it
  Save,               // the robot writes its map into a file of its own
  Cloud,              // points, whole
  CloudRegion,        // those in a box or a sphere
  Occupancy,          // occupied voxels as points, whole
  OccupancyRegion,    // those in a box or a sphere
  ReadProjections,    // what is projected onto the plane can be asked for
  ChangeProjections,  // and chosen
};

/// Whether one is there.
struct DispatchOffer {
  DispatchService service = DispatchService::Grid;
  bool offered = false;
  std::string name;  // as the robot is asked: "/map_dispatcher/get_sub_map". Untrusted plain text
  std::string type;  // as the robot says; empty = it does not tell types
  bool operator==(const DispatchOffer&) const = default;
};

enum class CloudKind { Points, Occupancy };

/// Of one projection, as it came by its topic.
struct ProjectedPart {
  int index = 0;  // projected_map_<index>
  map::GridPart part;
  double min_z_m = 0, max_z_m = 0;
};

/// How large the whole map is, as the robot tells without sending it. Its frame is that of the map.
struct MapExtent {
  map::GridReference grid;       // usable, with cells; nothing says that what is sent will be of that size
  std::int64_t about_bytes = 0;  // all of its cells over the link: an estimate
  std::int64_t least_bytes = 0;  // no fewer
  std::int64_t most_bytes = 0;   // the link breaks off at a longer answer; 0 = no bound is known
  /// It cannot come at once, whatever its cells are.
  bool beyondLink() const { return most_bytes > 0 && least_bytes > most_bytes; }
  bool operator==(const MapExtent&) const = default;
};

/// Capability: a map dispatcher. Called on the thread that made the robot; what it hands out comes there,
/// too. See robot/call.h for how a request ends. Answers are read off that thread; a call that is cancelled
/// frees nothing on the robot: it goes on reckoning. How many are under way at once is bounded by whoever
/// asks.
class MapDispatch : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  /// Each service once, offered or not.
  virtual std::vector<DispatchOffer> offers() const = 0;
  bool offered(DispatchService service) const;
  /// nullopt: the whole map. Regions whose numbers are not finite, or without size, are refused without
  /// asking (FailureKind::Refused).
  virtual Call grid(const std::optional<map::GridRegion>& region, OutcomeTo<map::GridPart> reply) = 0;
  /// nullopt: the robot does not tell, or what it tells is no size of a map.
  virtual std::optional<MapExtent> extent() const { return std::nullopt; }
  virtual Call cloud(CloudKind kind, const std::optional<map::CloudRegion>& region,
                     OutcomeTo<std::shared_ptr<const map::SpatialCloud>> reply) = 0;
  /// `filename`: on the robot; its extension tells the kind. Ends in the name that was sent.
  virtual Call save(const std::string& filename, OutcomeTo<std::string> reply) = 0;
  /// What is projected now, as the robot says.
  virtual Call projections(OutcomeTo<std::vector<map::Projection>> reply) = 0;
  /// Ends in what the robot then says that it projects, which may be something else.
  virtual Call project(const std::vector<map::Projection>& wanted,
                       OutcomeTo<std::vector<map::Projection>> reply) = 0;
  /// The projected maps that are told of, the newest of each.
  virtual std::vector<ProjectedPart> projected() const = 0;
  /// By which names the robot should tell of projected maps, and has told nothing so far as anybody waited
  /// for it. Untrusted plain text.
  virtual std::vector<std::string> silent() const { return {}; }

 Q_SIGNALS:
  void offersChanged();
  /// The robot's map has become another one: what was fetched may be old.
  void mapChanged();
  void extentChanged();
  /// projected() has another part of that index, or none any more.
  void projectedChanged(int index);
};

}  // namespace mapwright::robot
