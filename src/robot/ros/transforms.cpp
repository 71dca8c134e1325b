#include "robot/ros/transforms.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "robot/ros/faults.h"
#include "robot/ros/parts.h"

namespace mapwright::robot::ros {
namespace {

/// Seconds since the epoch in a double are no finer than this.
constexpr double kSameTimeS = 1e-6;
constexpr std::size_t kMostLoops = 100;

std::optional<Transform3> normalised(const Transform3& transform) {
  const double length = transform.q.norm();
  if (!transform.t_m.allFinite() || !std::isfinite(length) || length < kShortestQuaternion)
    return std::nullopt;
  return Transform3{transform.t_m, Eigen::Quaterniond(transform.q.coeffs() / length)};
}

}  // namespace

Transform3 between(const Transform3& from, const Transform3& to, double part) {
  return {from.t_m + (to.t_m - from.t_m) * part, from.q.slerp(part, to.q)};
}

Transform3 Transform3::operator*(const Transform3& child) const {
  return {apply(child.t_m), (q * child.q).normalized()};
}

Transform3 Transform3::inverse() const {
  const Eigen::Quaterniond back = q.conjugate();
  return {-(back * t_m), back};
}

geometry::Pose2 Transform3::flat() const {
  const Eigen::Vector3d x_axis = q * Eigen::Vector3d::UnitX();
  return {t_m.x(), t_m.y(), std::atan2(x_axis.y(), x_axis.x())};
}

std::string frameName(std::string_view name) {
  name.remove_prefix(std::min(name.find_first_not_of('/'), name.size()));
  return std::string(name);
}

Transforms::Index Transforms::indexOf(const std::string& name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? kNone : found->second;
}

Transforms::Index Transforms::made(const std::string& name) {
  const auto [entry, is_new] = by_name_.try_emplace(name, frames_.size());
  if (is_new) {
    Frame frame;
    frame.name = name;
    frames_.push_back(std::move(frame));
  }
  return entry->second;
}

bool Transforms::hangsBelow(Index frame, Index above) const {
  for (; frame != kNone; frame = frames_[frame].parent) {
    if (frame == above) return true;
  }
  return false;
}

/// Removes a pair between `from` and `above` that was not renewed.
bool Transforms::loosened(Index from, Index above, double stamp_s) {
  for (; from != above; from = frames_[from].parent) {
    Frame& frame = frames_[from];
    // Far ahead is as dead as far behind: of a clock before it was set back.
    if (frame.is_static || std::abs(frame.history.back().at_s - stamp_s) <= kHistoryS) continue;
    frame.parent = kNone;
    frame.history.clear();
    return true;
  }
  return false;
}

void Transforms::remember(const Missing& loop) {
  if (loops_.size() < kMostLoops && std::find(loops_.begin(), loops_.end(), loop) == loops_.end())
    loops_.push_back(loop);
}

bool Transforms::isUsable(const std::string& parent, const std::string& child, const Transform3& transform) {
  const std::string parent_name = frameName(parent), child_name = frameName(child);
  return normalised(transform) && !parent_name.empty() && !child_name.empty() && parent_name != child_name;
}

Transforms::Taken Transforms::setTransform(const std::string& parent, const std::string& child,
                                           const Transform3& transform, double stamp_s, bool is_static) {
  const auto refuse = [this](Taken why) {
    ++refused_;
    return why;
  };
  const auto usable = normalised(transform);
  if (!usable || (!is_static && !std::isfinite(stamp_s))) return refuse(Taken::NoNumbers);
  const std::string parent_name = frameName(parent), child_name = frameName(child);
  if (!isUsable(parent, child, transform)) return refuse(Taken::NoFrames);
  Index above = indexOf(parent_name), below = indexOf(child_name);
  const std::size_t more = std::size_t(above == kNone) + std::size_t(below == kNone);
  if (frames_.size() + more > kMostFrames) return refuse(Taken::NoFrames);

  if (above == kNone || below == kNone || frames_[below].parent != above) {
    const Missing loop{Missing::Kind::Loop, parent_name, child_name};
    const bool closes = above != kNone && below != kNone && hangsBelow(above, below);
    if (closes && (is_static || !loosened(above, below, stamp_s))) {
      remember(loop);
      return refuse(Taken::Loop);
    }
    std::erase(loops_, loop);
    above = made(parent_name);
    below = made(child_name);
    frames_[below].parent = above;
    frames_[below].history.clear();
  }
  Frame& frame = frames_[below];
  if (is_static || frame.is_static) frame.history.clear();
  frame.is_static = is_static;
  file(frame.history, {stamp_s, *usable});
  return Taken::Kept;
}

void Transforms::drop(const std::string& child) {
  const Index index = indexOf(frameName(child));
  if (index == kNone) return;
  frames_[index].parent = kNone;
  frames_[index].history.clear();
}

void Transforms::file(std::deque<Stamped>& history, const Stamped& entry) {
  const auto later = [](double at_s, const Stamped& kept) { return at_s < kept.at_s; };
  if (!history.empty() && entry.at_s < history.back().at_s - kLateS) {
    history.erase(std::upper_bound(history.begin(), history.end(), entry.at_s, later), history.end());
  }
  auto next = history.empty() || history.back().at_s < entry.at_s
                  ? history.end()
                  : std::upper_bound(history.begin(), history.end(), entry.at_s, later);
  if (next != history.begin() && std::prev(next)->at_s == entry.at_s) {
    std::prev(next)->transform = entry.transform;
  } else {
    history.insert(next, entry);
  }
  while (history.size() > kMostStamps || history.front().at_s < history.back().at_s - kHistoryS)
    history.pop_front();
}

tl::expected<Transforms::Chain, Transforms::Missing> Transforms::chainOf(const std::string& parent,
                                                                         const std::string& child) const {
  const Index from = indexOf(child), to = indexOf(parent);
  if (from == kNone) return tl::unexpected(Missing{Missing::Kind::UnknownFrame, parent, child});
  if (to == kNone) return tl::unexpected(Missing{Missing::Kind::UnknownFrame, child, parent});
  const auto pathUp = [this](Index frame) {
    std::vector<Index> path;
    for (; frame != kNone; frame = frames_[frame].parent) path.push_back(frame);
    return path;
  };
  Chain chain{pathUp(from), pathUp(to)};
  if (chain.up.back() != chain.down.back())
    return tl::unexpected(Missing{Missing::Kind::NotConnected, parent, child});
  // Common ancestors are irrelevant, and the frame where both meet is not a pair.
  while (!chain.up.empty() && !chain.down.empty() && chain.up.back() == chain.down.back()) {
    chain.up.pop_back();
    chain.down.pop_back();
  }
  return chain;
}

std::optional<double> Transforms::latestOf(const Chain& chain) const {
  std::optional<double> latest;
  for (const std::vector<Index>* pairs : {&chain.up, &chain.down}) {
    for (const Index pair : *pairs) {
      const Frame& frame = frames_[pair];
      if (frame.is_static) continue;
      const double newest = frame.history.back().at_s;
      latest = latest ? std::min(*latest, newest) : newest;
    }
  }
  return latest;
}

tl::expected<std::optional<double>, Transforms::Missing> Transforms::latestCommon(
    const std::string& parent, const std::string& child) const {
  const std::string parent_name = frameName(parent), child_name = frameName(child);
  if (parent_name == child_name) return std::optional<double>();
  return chainOf(parent_name, child_name).map([this](const Chain& chain) { return latestOf(chain); });
}

tl::expected<Transform3, Transforms::Missing> Transforms::pairAt(Index index, double at_s) const {
  const Frame& frame = frames_[index];
  const std::deque<Stamped>& history = frame.history;
  if (frame.is_static) return history.back().transform;
  const auto missing = [&](Missing::Kind kind) {
    return tl::unexpected(Missing{kind, frames_[frame.parent].name, frame.name});
  };
  if (at_s < history.front().at_s - kSameTimeS) return missing(Missing::Kind::TooOld);
  if (at_s > history.back().at_s + kSameTimeS) return missing(Missing::Kind::TooNew);
  const auto after = std::upper_bound(history.begin(), history.end(), at_s,
                                      [](double at, const Stamped& kept) { return at < kept.at_s; });
  if (after == history.begin()) return history.front().transform;
  if (after == history.end()) return history.back().transform;
  const Stamped& before = *std::prev(after);
  return between(before.transform, after->transform, (at_s - before.at_s) / (after->at_s - before.at_s));
}

tl::expected<Transform3, Transforms::Missing> Transforms::product(const std::vector<Index>& pairs,
                                                                  double at_s) const {
  Transform3 whole;
  for (const Index pair : pairs) {
    const auto step = pairAt(pair, at_s);
    if (!step) return step;
    whole = *step * whole;
  }
  return whole;
}

tl::expected<Transform3, Transforms::Missing> Transforms::find(const std::string& parent,
                                                               const std::string& child,
                                                               std::optional<double> at_s) const {
  const std::string parent_name = frameName(parent), child_name = frameName(child);
  if (parent_name == child_name) return Transform3{};
  const auto chain = chainOf(parent_name, child_name);
  if (!chain) return tl::unexpected(chain.error());
  const double at = at_s ? *at_s : latestOf(*chain).value_or(0);
  const auto up = product(chain->up, at);
  if (!up) return up;
  const auto down = product(chain->down, at);
  if (!down) return down;
  return down->inverse() * *up;
}

std::vector<std::string> Transforms::frames() const {
  std::vector<std::string> names;
  for (const Frame& frame : frames_) names.push_back(frame.name);
  std::sort(names.begin(), names.end());
  return names;
}

std::string Transforms::rootAbove(const std::string& frame) const {
  std::string name = frameName(frame);
  Index at = indexOf(name);
  if (at == kNone) return name;
  while (frames_[at].parent != kNone) at = frames_[at].parent;
  return frames_[at].name;
}

std::vector<Transforms::Newest> Transforms::newest() const {
  std::vector<Newest> ages;
  for (const Frame& frame : frames_) {
    if (frame.parent == kNone || frame.is_static || frame.history.empty()) continue;
    ages.push_back({frames_[frame.parent].name, frame.name, frame.history.back().at_s});
  }
  std::sort(ages.begin(), ages.end(), [](const Newest& a, const Newest& b) {
    return std::tie(a.stamp_s, a.child) < std::tie(b.stamp_s, b.child);
  });
  return ages;
}

std::vector<std::string> Transforms::roots() const {
  std::vector<bool> has_children(frames_.size());
  for (const Frame& frame : frames_) {
    if (frame.parent != kNone) has_children[frame.parent] = true;
  }
  std::vector<std::string> names;
  for (Index index = 0; index < frames_.size(); ++index) {
    if (frames_[index].parent == kNone && has_children[index]) names.push_back(frames_[index].name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

Fault reasonOf(const Transforms::Missing& missing) {
  constexpr FaultCode kCodes[] = {fault::RosFrameUnknown, fault::RosFramesApart, fault::RosTransformTooOld,
                                  fault::RosTransformTooNew, fault::RosTransformLoop};  // by their kind
  Fault reason{kCodes[int(missing.kind)], {missing.child}};
  if (missing.kind != Transforms::Missing::Kind::UnknownFrame) reason.arguments.push_back(missing.parent);
  return reason;
}

}  // namespace mapwright::robot::ros
