// What one list of submaps says otherwise than the one before it. Pure, any thread: lists are long, and what
// changes between two of them is little.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "map/problem.h"
#include "map/submap.h"

namespace mapwright::submap {

/// Coordinates beyond this are taken for garbage: no robot's map is 1000 km from its origin.
inline constexpr double kMaxCoordinateM = 1e6;

/// A list without duplicates, ascending by id; null before the first one.
struct ListedBefore {
  std::string uuid;
  std::shared_ptr<const std::vector<map::SubmapEntry>> entries;
};

/// An entry with why its pose cannot be used; None = it can.
struct ListedEntry {
  map::SubmapEntry entry;
  FaultCode pose_problem;
};

struct ListDifference {
  std::string uuid;
  map::SlamState slam_state = map::SlamState::Invalid;
  bool new_session = false;          // another uuid, or the first list of all: `changed` is all of it
  std::vector<ListedEntry> changed;  // new, or other than before; ascending by id
  std::vector<map::SubmapId> removed;
  std::set<map::SubmapId> listed_twice;
  std::vector<map::Problem> problems;  // of rows that cannot be read, and of duplicates
  bool rows_rejected = false;
  ListedBefore now;  // what the next one is to be compared with
};

/// A submap that is listed several times counts once: a usable pose, then the highest version, then the first
/// decides.
ListDifference compareLists(const ListedBefore& before, const map::SubmapList& list);

}  // namespace mapwright::submap
