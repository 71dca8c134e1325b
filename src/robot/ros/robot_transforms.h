// The transforms of several robots that use the same names for their frames, each told on topics of its own
// namespace ("/robot1/tf"). Source: nav2 and robot_localization in namespaces; tf_prefix of ROS 1.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "robot/ros/transforms.h"

namespace mapwright::robot::ros {

/// The last of `namespaces` that the topic is below ("/robot1/front/scan" is below "/robot1"); empty: none.
std::string namespaceAmong(const std::vector<std::string>& namespaces, std::string_view topic);

/// Messages are placed by the transforms of the robot that their topic belongs to. What these lack comes from
/// the root ("/tf"): frames that begin with the name of the robot, and pairs without a frame of its own. But
/// the root may be another robot with the same names: see trustRoot(). A frame "laser" on a topic of
/// "/robot1" is "robot1/laser" where that is known. A value; one thread.
class RobotTransforms {
 public:
  using Missing = Transforms::Missing;

  /// Those with transforms of their own, "" for the root; the robot to be shown comes first. Fewer than two:
  /// all transforms are of one robot, whatever their topics.
  void setNamespaces(std::vector<std::string> namespaces);
  const std::vector<std::string>& namespaces() const { return namespaces_; }  // empty: one robot

  /// A transform that arrived on `topic`.
  Transforms::Taken setTransform(const std::string& topic, const std::string& parent,
                                 const std::string& child, const Transform3& transform, double stamp_s,
                                 bool is_static);
  /// What `robot` ("": the root) told of the frame is not known any more.
  void drop(const std::string& robot, const std::string& child);
  /// Transforms::find() for a message of `topic`.
  tl::expected<Transform3, Missing> find(const std::string& topic, const std::string& parent,
                                         const std::string& child, std::optional<double> at_s) const;
  /// The transforms for messages of `topic`.
  const Transforms& of(std::string_view topic) const;
  /// Those of the robot that is shown.
  const Transforms& robot() const;
  /// That one is shown from now on.
  void show(const std::string& robot);
  /// All robots had time to tell their own: the root also places those that told nothing, and frames of which
  /// only it tells (map -> odom); unless it tells a moving pair that the robot tells, too.
  void trustRoot();
  /// Each robot has told something of its own, and nothing that the root tells, too.
  bool rootServesAll() const;

 private:
  struct Lent {
    std::string parent;
    bool is_static = false;
  };
  struct Tree {
    Transforms transforms;
    std::set<std::string> own;         // children told by the robot itself
    std::set<std::string> named;       // frames in its own transforms
    std::map<std::string, Lent> lent;  // pairs of the root, by child
    bool apart = false;                // both tell the same pair
  };
  Tree& treeOf(const std::string& robot);
  void addOwn(Tree& tree, const std::string& robot, const std::string& parent, const std::string& child,
              bool is_static) const;
  void lend(Tree& tree, const std::string& robot, const std::string& parent, const std::string& child,
            const Transform3& transform, double stamp_s, bool is_static) const;
  bool isLent(const Tree& tree, const std::string& robot, const std::string& parent,
              const std::string& child) const;
  void dropLent(Tree& tree, const std::string& robot) const;
  const Tree* treeFor(std::string_view topic, const std::string& frame) const;
  static std::string frameFor(const Transforms& transforms, std::string_view topic, const std::string& frame);

  std::vector<std::string> namespaces_;
  std::map<std::string, Tree> trees_;  // by namespace; "": the root, or all
  bool root_waits_ = true;
};

}  // namespace mapwright::robot::ros
