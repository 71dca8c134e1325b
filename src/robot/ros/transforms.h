// Where the frames of a ROS robot lie to each other, in time.
// Source: ROS REP 105 (frames), tf2 "buffer_core" (what is interpolated, what is refused).
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
  /// What it does in the plane z = 0.
  geometry::Pose2 flat() const;
};

/// The part 0..1 of the way from one to the other.
Transform3 between(const Transform3& from, const Transform3& to, double part);

/// The name of a frame without the slashes that ROS 1 of old put before it.
std::string frameName(std::string_view name);

/// A buffer of transforms in time. Frames are a forest: each has one parent or none. Pure: times are stamps
/// of the robot in seconds, on whatever clock. One thread.
///
/// - Between two stamps it interpolates; before the first and after the last one it knows nothing.
/// - The last 10 s of a pair are kept, at most kMostStamps; a static pair counts for all times.
/// - A stamp that comes late (up to kLateS) is filed where it belongs, the same stamp again replaces. One
///   farther back is a clock that was set back (a simulator that was restarted): what was after it is
///   dropped.
/// - A child that comes with another parent has that one from now on, and what was known of it is dropped.
/// - What would close a loop is refused; a pair of that loop that nobody has renewed for the whole history
///   makes way for it instead.
class Transforms {
 public:
  static constexpr double kHistoryS = 10, kLateS = 1;
  static constexpr std::size_t kMostStamps = 4096, kMostFrames = 10'000;

  /// Why there is no transform. Of UnknownFrame `child` is the unknown one; of TooOld and TooNew both are the
  /// pair that is not known at that time; else they are what was asked for (or, of a Loop, refused).
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
  /// A quaternion of another length than 1 is normalised. `stamp_s` of a static transform means nothing.
  Taken take(const std::string& parent, const std::string& child, const Transform3& transform, double stamp_s,
             bool is_static);

  /// The pose of the frame `child` in `parent` at that time; without a time the latest that all pairs between
  /// them have in common. A frame in itself is the identity, also one that was never heard of.
  tl::expected<Transform3, Missing> find(const std::string& parent, const std::string& child,
                                         std::optional<double> at_s) const;
  /// That latest common time; nullopt when all pairs between them are static.
  tl::expected<std::optional<double>, Missing> latestCommon(const std::string& parent,
                                                            const std::string& child) const;

  std::vector<std::string> frames() const;  // by name
  /// What the frame hangs on in the end; itself, where nothing is known of it.
  std::string rootAbove(const std::string& frame) const;
  /// A pair that changes, with its newest stamp.
  struct Newest {
    std::string parent, child;
    double stamp_s = 0;
  };
  std::vector<Newest> newest() const;      // the oldest first
  std::vector<std::string> roots() const;  // those with children and no parent, by name

  /// The pairs that were refused because they would close a loop, and have not been taken since.
  const std::vector<Missing>& loops() const { return loops_; }
  /// How many transforms were refused, of all kinds.
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
    std::deque<Stamped> history;  // by time, newest last; of a static one a single entry
  };
  struct Chain {
    std::vector<Index> up, down;  // pairs from child, and from parent, to what both have above them
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
