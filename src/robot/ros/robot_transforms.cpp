#include "robot/ros/robot_transforms.h"

#include <algorithm>
#include <utility>

#include "robot/ros/ros_topics.h"

namespace mapwright::robot::ros {
namespace {

/// "robot1/" of "/robot1": how its frames begin where names are shared.
std::string prefixOf(std::string_view robot) { return frameName(robot) + '/'; }

/// Of a robot that has told nothing yet.
const Transforms& noTransforms() {
  static const Transforms none;
  return none;
}

}  // namespace

std::string namespaceAmong(const std::vector<std::string>& namespaces, std::string_view topic) {
  std::string longest;
  for (const std::string& one : namespaces) {
    if (one.size() > longest.size() && isBelow(topic, one)) longest = one;
  }
  return longest;
}

void RobotTransforms::setNamespaces(std::vector<std::string> namespaces) {
  if (namespaces.size() < 2) namespaces.clear();
  if (namespaces == namespaces_) return;
  if (namespaces.empty()) {
    Tree one;
    one.transforms = robot();
    trees_.clear();
    trees_.emplace(std::string(), std::move(one));
  }
  if (namespaces_.empty()) {
    // What came before a second robot did is that of the root.
    Tree& root = treeOf({});
    for (const Transforms::Newest& pair : root.transforms.newest())
      root.lent.insert_or_assign(pair.child, Lent{pair.parent, false});
  }
  namespaces_ = std::move(namespaces);
  std::erase_if(trees_, [this](const auto& tree) {
    return !tree.first.empty() &&
           std::find(namespaces_.begin(), namespaces_.end(), tree.first) == namespaces_.end();
  });
}

RobotTransforms::Tree& RobotTransforms::treeOf(const std::string& robot) {
  const auto known = trees_.find(robot);
  if (known != trees_.end()) return known->second;
  Tree tree;
  if (const auto root = trees_.find(std::string()); root != trees_.end()) {
    tree.transforms = root->second.transforms;
    tree.lent = root->second.lent;
  }
  return trees_.emplace(robot, std::move(tree)).first->second;
}

bool RobotTransforms::isLent(const Tree& tree, const std::string& robot, const std::string& parent,
                             const std::string& child) const {
  if (child.starts_with(prefixOf(robot))) return true;
  if (!tree.named.contains(parent) && !tree.named.contains(child)) return true;
  return !tree.apart && !root_waits_;
}

void RobotTransforms::dropLent(Tree& tree, const std::string& robot) const {
  std::erase_if(tree.lent, [&](const auto& pair) {
    const auto& [child, lent] = pair;
    if (isLent(tree, robot, lent.parent, child)) return false;
    tree.transforms.drop(child);
    return true;
  });
}

/// Makes room for a pair of the robot itself.
void RobotTransforms::addOwn(Tree& tree, const std::string& robot, const std::string& parent,
                             const std::string& child, bool is_static) const {
  const std::size_t known = tree.named.size();
  tree.named.insert({parent, child});
  const auto lent = tree.lent.find(child);
  const bool same_pair =
      lent != tree.lent.end() && !lent->second.is_static && !is_static && !child.starts_with(prefixOf(robot));
  if (lent != tree.lent.end()) tree.lent.erase(lent);
  if (!tree.own.contains(child)) tree.transforms.drop(child);
  if (same_pair) tree.apart = true;
  if (same_pair || tree.named.size() > known) dropLent(tree, robot);
}

/// A pair of the root.
void RobotTransforms::lend(Tree& tree, const std::string& robot, const std::string& parent,
                           const std::string& child, const Transform3& transform, double stamp_s,
                           bool is_static) const {
  if (tree.own.contains(child)) {
    const bool same_pair = !is_static && !child.starts_with(prefixOf(robot));
    if (same_pair && !std::exchange(tree.apart, true)) dropLent(tree, robot);
    return;
  }
  if (!isLent(tree, robot, parent, child)) return;
  if (tree.transforms.setTransform(parent, child, transform, stamp_s, is_static) == Transforms::Taken::Kept)
    tree.lent.insert_or_assign(child, Lent{parent, is_static});
}

Transforms::Taken RobotTransforms::setTransform(const std::string& topic, const std::string& parent,
                                                const std::string& child, const Transform3& transform,
                                                double stamp_s, bool is_static) {
  using Taken = Transforms::Taken;
  const std::string robot = namespaceAmong(namespaces_, topic);
  Tree& tree = treeOf(robot);
  if (namespaces_.empty()) return tree.transforms.setTransform(parent, child, transform, stamp_s, is_static);
  const std::string above = frameName(parent), below = frameName(child);
  if (robot.empty()) {
    const Taken taken = tree.transforms.setTransform(above, below, transform, stamp_s, is_static);
    if (taken == Taken::Kept) tree.lent.insert_or_assign(below, Lent{above, is_static});
    for (const std::string& other : namespaces_) {
      if (!other.empty()) lend(treeOf(other), other, above, below, transform, stamp_s, is_static);
    }
    return taken;
  }
  addOwn(tree, robot, above, below, is_static);
  Taken taken = tree.transforms.setTransform(above, below, transform, stamp_s, is_static);
  if (taken == Taken::Loop && !tree.lent.empty()) {
    for (const auto& [frame, of] : std::exchange(tree.lent, {})) tree.transforms.drop(frame);
    taken = tree.transforms.setTransform(above, below, transform, stamp_s, is_static);
  }
  if (taken == Taken::Kept) tree.own.insert(below);
  return taken;
}

void RobotTransforms::drop(const std::string& robot, const std::string& child) {
  for (auto& [name, tree] : trees_) {
    const bool told = name == robot || (robot.empty() && tree.lent.contains(child));
    if (!told) continue;
    tree.transforms.drop(child);
    tree.lent.erase(child);
    tree.own.erase(child);
  }
}

const RobotTransforms::Tree* RobotTransforms::treeFor(std::string_view topic,
                                                      const std::string& frame) const {
  std::string robot = namespaceAmong(namespaces_, topic);
  // A frame with the name of another robot is that one's.
  for (const std::string& other : namespaces_) {
    const auto tree = trees_.find(other);
    if (!other.empty() && tree != trees_.end() && frame.starts_with(prefixOf(other)) &&
        tree->second.transforms.knows(frame))
      robot = other;
  }
  const auto tree = trees_.find(robot);
  return tree == trees_.end() ? nullptr : &tree->second;
}

std::string RobotTransforms::frameFor(const Transforms& transforms, std::string_view topic,
                                      const std::string& frame) {
  const bool plain = transforms.knows(frame);
  for (std::size_t end = topic.rfind('/'); end != std::string_view::npos && end > 0;
       end = topic.rfind('/', end - 1)) {
    const std::string prefix = prefixOf(topic.substr(0, end));
    // If both are known, the one of the robot.
    const bool of_robot =
        transforms.knows(prefix + "base_link") || transforms.knows(prefix + "base_footprint");
    if ((of_robot || !plain) && transforms.knows(prefix + frame)) return prefix + frame;
  }
  return frame;
}

tl::expected<Transform3, Transforms::Missing> RobotTransforms::find(const std::string& topic,
                                                                    const std::string& parent,
                                                                    const std::string& child,
                                                                    std::optional<double> at_s) const {
  const std::string name = frameName(child);
  const Tree* const tree = treeFor(topic, name);
  if (!tree || name == frameName(parent)) return noTransforms().find(parent, name, at_s);
  const std::string frame = tree->own.contains(name) ? name : frameFor(tree->transforms, topic, name);
  const bool silent = tree->own.empty() && frame == name && root_waits_;
  if (silent && !namespaceAmong(namespaces_, topic).empty()) return noTransforms().find(parent, name, at_s);
  return tree->transforms.find(parent, frame, at_s);
}

const Transforms& RobotTransforms::of(std::string_view topic) const {
  const Tree* const tree = treeFor(topic, {});
  return tree ? tree->transforms : noTransforms();
}

const Transforms& RobotTransforms::robot() const {
  const auto tree = trees_.find(namespaces_.empty() ? std::string() : namespaces_.front());
  return tree == trees_.end() ? noTransforms() : tree->second.transforms;
}

void RobotTransforms::trustRoot() {
  if (!std::exchange(root_waits_, false)) return;
  const auto root = trees_.find(std::string());
  if (root == trees_.end()) return;
  // What does not move is told once.
  for (const auto& [child, lent] : root->second.lent) {
    const auto pair = lent.is_static ? root->second.transforms.find(lent.parent, child, {})
                                     : tl::make_unexpected(Missing());
    if (!pair) continue;
    for (auto& [robot, tree] : trees_) {
      if (!robot.empty()) lend(tree, robot, lent.parent, child, *pair, 0, true);
    }
  }
}

bool RobotTransforms::rootServesAll() const {
  return std::all_of(namespaces_.begin(), namespaces_.end(), [this](const std::string& robot) {
    const auto tree = trees_.find(robot);
    return robot.empty() || (tree != trees_.end() && !tree->second.own.empty() && !tree->second.apart);
  });
}

void RobotTransforms::show(const std::string& robot) {
  const auto found = std::find(namespaces_.begin(), namespaces_.end(), robot);
  if (found != namespaces_.end()) std::rotate(namespaces_.begin(), found, found + 1);
}

}  // namespace mapwright::robot::ros
