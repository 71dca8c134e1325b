#include "robot/ros/kabam_plan.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "map/waypoint.h"

namespace mapwright::robot::ros {
namespace {

bool moves(const map::Waypoint& before, const map::Waypoint& after) {
  return !map::samePlace(before.position_m, after.position_m) ||
         !map::sameHeading(before.yaw_rad, after.yaw_rad);
}

map::Waypoint called(map::Waypoint point, const std::string& name) {
  point.name = name;
  return point;
}

/// The names at each step, and all present and future names.
class Names {
 public:
  void reserve(const std::string& name) { taken_.insert(name); }
  void put(const std::string& id, const std::string& name) {
    remove(id);
    names_[id] = name;
    holders_[name].insert(id);
    taken_.insert(name);
  }
  void remove(const std::string& id) {
    const auto known = names_.find(id);
    if (known == names_.end()) return;
    holders_[known->second].erase(id);
    names_.erase(known);
  }
  const std::set<std::string>& holders(const std::string& name) { return holders_[name]; }
  /// "Dock ~1", a name that is not and will not be used.
  std::string freeName(const std::string& like) const {
    std::string name;
    for (int n = 1; name.empty() || taken_.contains(name); ++n) name = map::temporaryName(like, n);
    return name;
  }

 private:
  std::unordered_map<std::string, std::string> names_;  // by id
  std::unordered_map<std::string, std::set<std::string>> holders_;
  std::unordered_set<std::string> taken_;
};

/// Orders renames so that no name is used twice at any time. Costs no more than a sort.
std::vector<WaypointChange> inOrder(std::vector<WaypointChange> renamed, Names& names) {
  std::unordered_map<std::string, std::size_t> waiting;                   // by id
  std::unordered_map<std::string, std::vector<std::size_t>> wishing_for;  // by name
  std::set<std::size_t> left, ready;
  for (std::size_t i = 0; i < renamed.size(); ++i) {
    waiting.emplace(renamed[i].id, i);
    wishing_for[renamed[i].after->name].push_back(i);
    left.insert(i);
  }
  // One whose name is free, or held permanently by another: that one the robot has to refuse.
  const auto look = [&](std::size_t i) {
    const auto& holders = names.holders(renamed[i].after->name);
    const bool held =
        std::any_of(holders.begin(), holders.end(), [&](const auto& id) { return waiting.contains(id); });
    if (left.contains(i)) held ? void(ready.erase(i)) : void(ready.insert(i));
  };
  const auto lookAtThoseFor = [&](const std::string& name) {
    for (const std::size_t i : wishing_for[name]) look(i);
  };
  for (const std::size_t i : left) look(i);
  std::vector<WaypointChange> ordered;
  while (!left.empty()) {
    if (!ready.empty()) {
      const std::size_t next = *ready.begin();
      WaypointChange& change = renamed[next];
      ready.erase(next);
      left.erase(next);
      waiting.erase(change.id);
      const std::string freed = change.before->name, taken = change.after->name;
      names.put(change.id, taken);
      ordered.push_back(std::move(change));
      for (const std::string& name : {freed, taken}) lookAtThoseFor(name);
      continue;
    }
    // They form a cycle: the first gets a temporary name.
    WaypointChange& first = renamed[*left.begin()];
    const std::string freed = first.before->name;
    const map::Waypoint aside = called(*first.before, names.freeName(freed));
    names.put(first.id, aside.name);
    ordered.push_back({first.id, first.before, aside});
    first.before = aside;
    lookAtThoseFor(freed);
  }
  return ordered;
}

}  // namespace

WaypointService serviceOf(const WaypointChange& change) {
  if (!change.before) return WaypointService::Create;
  if (!change.after) return WaypointService::Delete;
  return change.before->name != change.after->name ? WaypointService::Rename : WaypointService::Reposition;
}

const char* nameOf(WaypointService service) {
  switch (service) {
    case WaypointService::Create:
      return "create_waypoint";
    case WaypointService::Rename:
      return "rename_waypoint";
    case WaypointService::Reposition:
      return "reposition_waypoint";
    case WaypointService::Delete:
      break;
  }
  return "delete_waypoint";
}

std::vector<WaypointRequest> planWaypoints(const StoredWaypoints& now,
                                           const std::vector<WaypointChange>& changes) {
  std::vector<WaypointChange> deleted, renamed, created, moved;
  Names names;
  for (const map::Waypoint& point : now.points) names.put(point.id, point.name);
  for (const WaypointChange& change : changes) {
    if (change.after) names.reserve(change.after->name);
    if (!change.before && !change.after) continue;
    if (!change.before) {
      created.push_back(change);
      continue;
    }
    if (!change.after) {
      deleted.push_back(change);
      names.remove(change.id);
      continue;
    }
    const bool rename = change.before->name != change.after->name;
    const bool move = moves(*change.before, *change.after);
    const bool retag = change.before->tags != change.after->tags;
    map::Waypoint halfway = *change.after;
    if (rename && move) {
      halfway = called(*change.before, change.after->name);
      moved.push_back({change.id, halfway, change.after});
    } else if (move || (retag && !rename)) {
      moved.push_back(change);
    }
    if (rename) renamed.push_back({change.id, change.before, halfway});
  }

  std::vector<WaypointChange> ordered = std::move(deleted);
  for (WaypointChange& change : inOrder(std::move(renamed), names)) ordered.push_back(std::move(change));
  for (auto* rest : {&created, &moved}) std::move(rest->begin(), rest->end(), std::back_inserter(ordered));

  std::vector<WaypointRequest> requests;
  requests.reserve(ordered.size());
  for (WaypointChange& change : ordered) requests.push_back({{std::move(change)}, now.revision});
  return requests;
}

}  // namespace mapwright::robot::ros
