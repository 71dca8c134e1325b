// The robot's path in a bag, sample by sample, and its export as text. Pure.
// The track consists of pieces: a piece ends where the position jumps, where the path is unknown (a gap),
// where the map or session changes, and at unread ranges. Do not draw or measure across them.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/pose.h"
#include "map/map_identity.h"
#include "replay/chunks.h"
#include "replay/digest.h"

namespace mapwright::replay {

struct TrackPoint {
  double stamp_s = 0;     // seconds since the epoch
  geometry::Pose2 pose;   // in the frame of the map at that time, metres
  double speed_m_s = 0;   // from the neighbouring samples of its piece; 0 if there are none
  int quality = 0;        // the last SlamStatus::position_quality; 0 = unknown
  std::size_t piece = 0;  // counts from 0
  std::size_t map = 0;    // the same number for the same map of the robot, by name and uid; counts from 0
  bool operator==(const TrackPoint&) const = default;
};

/// By time; samples with equal stamps stay in recorded order.
std::vector<TrackPoint> trackOf(const std::map<Tick, Digest>& digests);
/// What the recording calls the maps of TrackPoint::map; empty if it says nothing.
std::vector<map::MapIdentity> mapsOf(const std::map<Tick, Digest>& digests);
/// Those from `from_s` to `to_s`, both inclusive.
std::vector<TrackPoint> within(const std::vector<TrackPoint>& track, double from_s, double to_s);

/// Columns: stamp_s, x_m, y_m, yaw_rad, speed_m_s, quality, piece, map. Lines end in "
/// ".
std::string csvOf(const std::vector<TrackPoint>& track);
/// "timestamp tx ty tz qx qy qz qw", as in the TUM RGB-D benchmark. The format has no pieces.
std::string tumOf(const std::vector<TrackPoint>& track);
/// A FeatureCollection with one LineString per piece (a Point for a single sample). Coordinates are metres of
/// the map (see "units" of the collection), not degrees. Properties: "piece", "map", "start_s", "end_s",
/// "length_m", what `maps` knows of the map as "map_uid" and "map_name", and the samples' "stamps_s",
/// "yaws_rad", "speeds_m_s", "qualities".
std::string geoJsonOf(const std::vector<TrackPoint>& track, const std::vector<map::MapIdentity>& maps = {});

}  // namespace mapwright::replay
