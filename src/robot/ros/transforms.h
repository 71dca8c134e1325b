// The relative poses of a ROS robot's frames over time. Source: ROS REP 105 (frames), tf2 "buffer_core"
// (interpolation, rejected transforms).
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <Eigen/Geometry>
#include <tl/expected.hpp>

#include "fault/fault.h"
#include "geometry/pose.h"

namespace mapwright::robot::ros {

/// Maps points of a child frame into its parent: p_parent = q * p_child + t_m. Metres; `q` has length 1.
struct Transform3 {
  Eigen::Vector3d t_m{0, 0, 0};
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();

  Eigen::Vector3d apply(const Eigen::Vector3d& p_m) const { return q * p_m + t_m; }
  Transform3 operator*(const Transform3& child) const;
  Transform3 inverse() const;
  /// Its effect in the plane z = 0.
  geometry::Pose2 flat() const;
};

/// Interpolates from one to the other, 0..1.
Transform3 between(const Transform3& from, const Transform3& to, double part);

/// The name of a frame without the leading slashes of old ROS 1.
std::string frameName(std::string_view name);

/// A buffer of transforms over time. Frames form a forest: each has at most one parent. Pure: times are
/// stamps of the robot in seconds, on any clock. One thread.
///
/// - Interpolates between two stamps; does not extrapolate.
/// - Keeps the last 10 s of a pair, at most kMostStamps; a static pair is valid at all times.
/// - A late stamp (up to kLateS) is inserted in order, an equal one replaces. An even older stamp means that
///   the
///   clock was set back (a restarted simulator): everything after it is dropped.
/// - A child with a new parent has that one from now on, and its history is dropped.
/// - A transform that would close a loop is rejected; but a pair of that loop that was not renewed for the
///   whole
///   history is removed instead.
class Transforms {
 public:
  static constexpr double kHistoryS = 10, kLateS = 1;
  static constexpr std::size_t kMostStamps = 4096, kMostFrames = 10'000;

  /// Why there is no transform. For UnknownFrame `child` is the unknown frame; for TooOld and TooNew both are
  /// the pair without data at that time; otherwise the requested (or, for a Loop, rejected) pair.
  struct Missing {
    enum class Kind { UnknownFrame, NotConnected, TooOld, TooNew, Loop } kind;
    std::string parent, child;
    bool operator==(const Missing&) const = default;
  };

  enum class Taken {
    Kept,
    NoNumbers,  // something is not finite, or the quaternion has no direction
    NoFrames,   // a name is empty, both are the same, or there are too many
    Loop,       // see loops()
  };
  /// Whether setTransform() can use it, but for loops: frames with names, a transform of numbers.
  static bool isUsable(const std::string& parent, const std::string& child, const Transform3& transform);
  /// Quaternions are normalised. `stamp_s` of a static transform is ignored.
  Taken setTransform(const std::string& parent, const std::string& child, const Transform3& transform,
                     double stamp_s, bool is_static);

  /// The frame hangs below no other one any more.
  void drop(const std::string& child);

  /// The pose of the frame `child` in `parent` at that time; without a time at the latest time common to all
  /// pairs between them. A frame in itself gives the identity, even if it is unknown.
  tl::expected<Transform3, Missing> find(const std::string& parent, const std::string& child,
                                         std::optional<double> at_s) const;
  /// That latest common time; nullopt if all pairs between them are static.
  tl::expected<std::optional<double>, Missing> latestCommon(const std::string& parent,
                                                            const std::string& child) const;

  std::vector<std::string> frames() const;  // by name
  bool knows(const std::string& frame) const { return indexOf(frame) != kNone; }
  /// The root above the frame; itself, if nothing is known of it.
  std::string rootAbove(const std::string& frame) const;
  /// A dynamic pair with its newest stamp.
  struct Newest {
    std::string parent, child;
    double stamp_s = 0;
  };
  std::vector<Newest> newest() const;      // the oldest first
  std::vector<std::string> roots() const;  // frames with children but no parent, by name

  /// The pairs rejected because of loops and not accepted since.
  const std::vector<Missing>& loops() const { return loops_; }
  /// How many transforms were rejected, for any reason.
  std::size_t refused() const { return refused_; }

 private:
  using Index = std::size_t;
  static constexpr Index kNone = static_cast<Index>(-1);
  struct Stamped {
    double at_s;
    Transform3 transform;
  };
  struct Frame {
    std::string name;
    Index parent = kNone;
    bool is_static = false;
    std::deque<Stamped> history;  // by time, newest last; a single entry for a static one
  };
  struct Chain {
    std::vector<Index> up, down;  // pairs from child and from parent to their common ancestor
  };

  Index indexOf(const std::string& name) const;
  Index made(const std::string& name);
  bool hangsBelow(Index frame, Index above) const;
  bool loosened(Index from, Index above, double stamp_s);
  void remember(const Missing& loop);
  static void file(std::deque<Stamped>& history, const Stamped& entry);
  tl::expected<Chain, Missing> chainOf(const std::string& parent, const std::string& child) const;
  std::optional<double> latestOf(const Chain& chain) const;
  tl::expected<Transform3, Missing> pairAt(Index frame, double at_s) const;
  tl::expected<Transform3, Missing> product(const std::vector<Index>& pairs, double at_s) const;

  std::unordered_map<std::string, Index> by_name_;
  std::vector<Frame> frames_;
  std::vector<Missing> loops_;
  std::size_t refused_ = 0;
};

Fault reasonOf(const Transforms::Missing& missing);

}  // namespace mapwright::robot::ros
