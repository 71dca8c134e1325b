#include "robot/ros/kabam_plan.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace mapwright::robot::ros {
namespace {

bool moves(const map::Waypoint& before, const map::Waypoint& after) {
  return before.position_m != after.position_m || before.yaw_rad != after.yaw_rad;
}

map::Waypoint called(map::Waypoint point, const std::string& name) {
  point.name = name;
  return point;
}

/// "Dock ~1", such that nobody is, or will be, called so.
std::string freeName(const std::string& like, const std::set<std::string>& taken) {
  std::string name;
  for (int n = 1; name.empty() || taken.contains(name); ++n) name = like + " ~" + std::to_string(n);
  return name;
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
  std::map<std::string, std::string> names;  // as they are at each step, by id
  std::set<std::string> taken;               // every name that is or will be there
  for (const map::Waypoint& point : now.points) {
    names[point.id] = point.name;
    taken.insert(point.name);
  }
  for (const WaypointChange& change : changes) {
    if (change.after) taken.insert(change.after->name);
    if (!change.before && !change.after) continue;
    if (!change.before) {
      created.push_back(change);
      continue;
    }
    if (!change.after) {
      deleted.push_back(change);
      names.erase(change.id);
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
  const auto holder = [&](const std::string& name) {
    return std::find_if(names.begin(), names.end(), [&](const auto& one) { return one.second == name; });
  };
  while (!renamed.empty()) {
    // One whose name is free, or held by somebody who will not let go: that the robot has to refuse.
    const auto next = std::find_if(renamed.begin(), renamed.end(), [&](const WaypointChange& change) {
      const auto held = holder(change.after->name);
      return held == names.end() || std::none_of(renamed.begin(), renamed.end(),
                                                 [&](const auto& other) { return other.id == held->first; });
    });
    if (next != renamed.end()) {
      names[next->id] = next->after->name;
      ordered.push_back(*next);
      renamed.erase(next);
      continue;
    }
    // They wait for one another in a ring: the first steps aside.
    WaypointChange& first = renamed.front();
    const map::Waypoint aside = called(*first.before, freeName(first.before->name, taken));
    taken.insert(aside.name);
    names[first.id] = aside.name;
    ordered.push_back({first.id, first.before, aside});
    first.before = aside;
  }
  for (auto* rest : {&created, &moved}) std::move(rest->begin(), rest->end(), std::back_inserter(ordered));

  std::vector<WaypointRequest> requests;
  requests.reserve(ordered.size());
  for (WaypointChange& change : ordered) requests.push_back({{std::move(change)}, now.revision});
  return requests;
}

}  // namespace mapwright::robot::ros
