#include "carry/overlays_carried.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string>

#include "overlays/overlay_box.h"
#include "overlays/overlay_check.h"
#include "overlays/overlay_edits.h"
#include "overlays/overlay_reach.h"
#include "overlays/overlay_shapes.h"

namespace mapwright::carry {
namespace {

using geometry::Pose2;
using overlays::Feature;
using overlays::OverlayDocument;

Feature movedFeature(const Feature& feature, const Pose2& transform) {
  return overlays::movedBy(overlays::turnedAbout(feature, {0, 0}, transform.yaw_rad),
                           {transform.x_m, transform.y_m});
}

/// Texts and numbers under names that are called ids: `dockingPointId`, `deviceIds`.
void collectReferences(const overlays::JsonValue& value, const std::string& name,
                       std::set<std::string>& found) {
  const bool called_id = name.ends_with("Id") || name.ends_with("Ids") || name.ends_with("_id");
  if (called_id && value.kind() == overlays::JsonKind::String && !value.string().empty())
    found.insert(value.string());
  if (called_id && value.kind() == overlays::JsonKind::Number) found.emplace(value.text());
  for (const overlays::JsonValue& child : value.children())
    collectReferences(child, value.isObject() ? child.key() : name, found);
}

/// Groups of features that refer to each other, or to the same thing (a gate and its region to one device):
/// the first index of its group for each.
std::vector<std::size_t> groupsOf(const OverlayDocument& document) {
  std::vector<std::size_t> group(document.features().size());
  std::iota(group.begin(), group.end(), std::size_t(0));
  const auto root = [&](std::size_t i) {
    while (group[i] != i) i = group[i] = group[group[i]];
    return i;
  };
  std::map<std::string, std::size_t> known;  // by its id, or the first that refers to it
  for (std::size_t i = 0; i < group.size(); ++i) {
    if (const std::string id = document.features()[i].id(); !id.empty()) known.emplace(id, i);
  }
  for (std::size_t i = 0; i < group.size(); ++i) {
    const auto properties = document.features()[i].root().member("properties");
    if (!properties) continue;
    std::set<std::string> references;
    collectReferences(*properties, {}, references);
    for (const std::string& reference : references) {
      const std::size_t a = root(i), b = root(known.emplace(reference, i).first->second);
      group[std::max(a, b)] = std::min(a, b);
    }
  }
  for (std::size_t& one : group) one = root(one);
  return group;
}

/// The same without an id: its shape, type and name, and the place.
bool isThere(const Feature& moved, const OverlayDocument& there) {
  constexpr double kSame_m = 0.1;
  const auto at = overlays::shapesOf(moved).somewhere();
  return at && std::any_of(there.features().begin(), there.features().end(), [&](const Feature& other) {
           if (!other.id().empty() || other.shape() != moved.shape() || other.type() != moved.type() ||
               other.name() != moved.name())
             return false;
           const auto other_at = overlays::shapesOf(other).somewhere();
           return other_at && (*other_at - *at).norm() <= kSame_m;
         });
}

/// The worst of a group is that of all.
int rankOf(Verdict verdict) { return sound(verdict) ? 0 : int(verdict); }

}  // namespace

std::vector<CarriedFeature> carriedOverlays(const Site& site, const OverlayDocument& old_overlays,
                                            const OverlayDocument& new_overlays,
                                            const render::PlacedGrid& new_map, const CarryOptions& options) {
  std::set<std::string> there;
  for (const Feature& feature : new_overlays.features()) {
    if (!feature.id().empty()) there.insert(feature.id());
  }
  std::vector<CarriedFeature> all;
  std::vector<std::size_t> at_of(old_overlays.features().size(), old_overlays.features().size());
  for (std::size_t i = 0; i < old_overlays.features().size(); ++i) {
    const Feature& feature = old_overlays.features()[i];
    const overlays::Shapes shapes = overlays::shapesOf(feature);
    std::vector<Eigen::Vector2d> points;
    for (const overlays::Path& path : shapes.paths)
      points.insert(points.end(), path.points.begin(), path.points.end());
    // A corner that is no place would stay where it is while the others move.
    if (points.empty() || shapes.bad) continue;
    Carried carried;
    if (overlays::isDestination(feature)) {
      carried = site.carriedStop({points.front()}, options);
    } else {
      carried = site.carriedShape(points, options.adjust);
    }
    at_of[i] = all.size();
    Feature moved = movedFeature(feature, carried.transform);
    if (const auto yaw = overlays::yawOf(moved)) carried.spot.yaw_rad = geometry::radiansFromDegrees(*yaw);
    const bool is_there = feature.id().empty() ? isThere(moved, new_overlays) : there.contains(feature.id());
    all.push_back({i, std::move(moved), carried, is_there});
    if (auto boxed = overlays::reboxed(all.back().moved, feature))
      all.back().moved = std::move(boxed->feature), all.back().box_removed = boxed->removed;
  }
  // Reached from the chargers, around walls and forbidden regions of both maps.
  OverlayDocument together = new_overlays;
  std::map<std::size_t, std::size_t> carried_at;
  for (std::size_t at = 0; at < all.size(); ++at) {
    if (all[at].there_already || !sound(all[at].carried.verdict)) continue;
    carried_at[together.features().size()] = at;
    together.add(all[at].moved);
  }
  const placing::PlacedMap below{new_map.cells, new_map.reference, false};
  for (const std::size_t feature : overlays::unreachable(together, below, options.radius_m)) {
    if (const auto at = carried_at.find(feature); at != carried_at.end())
      all[at->second].carried.verdict = Verdict::Unreachable;
  }
  const std::vector<std::size_t> group = groupsOf(old_overlays);
  std::map<std::size_t, std::vector<std::size_t>> members;
  for (std::size_t i = 0; i < group.size(); ++i) {
    if (at_of[i] < all.size()) members[group[i]].push_back(i);
  }
  for (const auto& [first, indices] : members) {
    if (indices.size() < 2) continue;
    Verdict worst = Verdict::Kept;
    bool one_there = false;
    for (const std::size_t i : indices) {
      const Verdict one = all[at_of[i]].carried.verdict;
      if (rankOf(one) > rankOf(worst)) worst = one;
      one_there = one_there || all[at_of[i]].there_already;
    }
    for (const std::size_t i : indices) {
      CarriedFeature& one = all[at_of[i]];
      if (!sound(worst)) one.carried.verdict = worst;
      one.one_there = one_there && !one.there_already;
      for (const std::size_t other : indices) {
        if (other != i) one.with.push_back(other);
      }
    }
  }
  return all;
}

}  // namespace mapwright::carry
