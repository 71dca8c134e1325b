// Where the robot was in a bag, sample by sample, and that as text for other programs. Pure.
//
// The track is in pieces: one ends where the position jumps, where nothing tells which way was gone (a gap),
// where another map or session begins, and where a range between has not been read. Nothing may be drawn or
// measured across.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/pose.h"
#include "replay/chunks.h"
#include "replay/digest.h"

namespace mapwright::replay {

struct TrackPoint {
  double stamp_s = 0;     // seconds since the epoch
  geometry::Pose2 pose;   // in the frame of the map of its time, metres
  double speed_m_s = 0;   // from the samples around it, within its piece; 0 where it has no other
  int quality = 0;        // SlamStatus::position_quality as said last; 0 = unknown
  std::size_t piece = 0;  // counts from 0
  bool operator==(const TrackPoint&) const = default;
};

/// By time; samples with equal stamps stay as they were recorded.
std::vector<TrackPoint> trackOf(const std::map<Tick, Digest>& digests);
/// Those from `from_s` to `to_s`, both counted in.
std::vector<TrackPoint> within(const std::vector<TrackPoint>& track, double from_s, double to_s);

/// Row by row: stamp_s, x_m, y_m, yaw_rad, speed_m_s, quality, piece. Lines end in "\n".
std::string csvOf(const std::vector<TrackPoint>& track);
/// "timestamp tx ty tz qx qy qz qw", as the TUM RGB-D benchmark has it. Pieces cannot be told in it.
std::string tumOf(const std::vector<TrackPoint>& track);
/// A FeatureCollection with one LineString a piece (a Point, where it is a single sample). Coordinates are
/// metres of the map ("units" of the collection says so), not degrees. Properties: "piece", "start_s",
/// "end_s", "length_m", and the samples' "stamps_s", "yaws_rad", "speeds_m_s", "qualities".
std::string geoJsonOf(const std::vector<TrackPoint>& track);

}  // namespace mapwright::replay
