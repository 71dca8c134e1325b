// Recorded ways, driven once more on a new map: what they cross there. Pure; not for the GUI thread. Why:
// docs/tasks/new-map.md.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "geometry/pose.h"
#include "map/map_identity.h"
#include "render/sample_grid.h"

namespace mapwright::carry {

/// What the line of a way meets. The worst last.
enum class Crossing {
  Free,
  Outside,   // of the new map
  Unknown,   // the new map knows nothing there
  TooClose,  // to a wall, for the radius of the robot
  Obstacle,  // with where the robot is too close just before and after it
};
inline constexpr int kCrossings = 5;
/// For scripts, never changes: "too_close".
const char* nameOf(Crossing crossing);

struct WayPoint {
  Eigen::Vector2d position_m{0, 0};
  double stamp_s = 0;
  std::size_t piece = 0;  // nothing is known between two points of different ones
  std::size_t map = 0;    // of those that the robot was on
};

/// A stretch along which a way meets one thing.
struct Stretch {
  Crossing what = Crossing::Free;
  double from_s = 0, to_s = 0;  // in the recording
  double length_m = 0;          // 0: the robot stood there
  Eigen::Vector2d middle_m{0, 0};
  std::vector<Eigen::Vector2d> line = {};  // on the new map; one point if it has no length
};

struct Rehearsed {
  double length_m = 0;
  double from_s = 0, to_s = 0;
  std::size_t points = 0;
  std::size_t unusable = 0;  // points without numbers: left out
  std::size_t jumps = 0;     // nothing is known of the way between two points
  double elsewhere_m = 0;    // driven on another map: left out, too
  /// How it is known which of the maps that the robot was on is the one that counts.
  enum class Part {
    Only,      // there is one
    Recorded,  // by the uid or name in the recording
    ByGround,  // it is not: the one whose free ground fits the way best
  };
  Part part = Part::Only;
  bool of_another = false;           // by its uid, none of them is the one that it should be
  std::vector<Stretch> stretches{};  // all of it, also what is free, in the order of the way
  std::array<double, kCrossings> lengths_m{};
  enum class Reach {
    Reached,
    CutOff,   // its end from its start
    NoStart,  // the robot cannot stand where it starts
    NoEnd,
  };
  Reach reach = Reach::Reached;

  /// Those that are not free, the longest first.
  std::vector<Stretch> crossed() const;
  /// Nothing is crossed, and its end can be reached.
  bool free() const;
};

struct RehearsalOptions {
  double radius_m = 0.3;           // of the robot; 0: only what the line itself meets counts
  geometry::Pose2 transform = {};  // from the frame of the way to the new map
  /// What the way was driven on. Where it kept as close to a wall there, it is not too close (carried.h).
  std::optional<render::PlacedGrid> old_map = {};
  /// What the map is called that it was driven on: the old one, or without one the new one.
  map::MapIdentity driven_on = {};
};

class Rehearsal {
 public:
  Rehearsal(const render::PlacedGrid& new_map, const RehearsalOptions& options);
  ~Rehearsal();

  /// By time. A jump that `way` does not know of is none of its line either. `maps`: what the recording calls
  /// those of WayPoint::map. Of several that the robot was on, the one counts that is called as `driven_on`.
  /// Where that is not known: that on whose free ground most of the way lies.
  Rehearsed of(const std::vector<WayPoint>& way, const std::vector<map::MapIdentity>& maps = {}) const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

}  // namespace mapwright::carry
