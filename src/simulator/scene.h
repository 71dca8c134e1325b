// The world that the simulated robot lives in: a floor plan and the drives through it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "simulator/floor_plan.h"

namespace mapwright::simulator {

constexpr double kSpeedMPerS = 0.8;
constexpr double kScanStepM = 0.4;        // one scan every half second of driving
constexpr int kScansPerSubmap = 24;       // each scan goes into two submaps, as in Cartographer:
constexpr int kScansPerSubmapStart = 12;  // a new submap begins when the one before is half full

/// How a trajectory comes to be.
enum class Growth {
  Complete,  // a finished map, there at once
  Live,      // grows for ever along a closed drive; only the newest submaps are kept
  Once,      // grows along its drive, then stays
};

struct Trajectory {
  int id = 0;
  Drive drive;
  Growth growth = Growth::Complete;
  double appears_at_s = 0;  // simulated seconds since the SLAM session began
  int submaps = 0;          // at the end; of a live one: how many are kept
  bool incremental = false;
  bool nearby = false;
  int looks = 0;  // so many submaps have cells of their own, the others look like them; 0 = every one

  /// The submap whose cells `index` has.
  int lookOf(int index) const { return looks > 0 ? index % looks : index; }
  /// Scans that went in up to `session_s`. 0: not there yet.
  int scansAt(double session_s) const;
  /// Submaps [first, end) that exist after `scans`.
  std::pair<int, int> submapsAfter(int scans) const;
};

/// The item with this id; null if there is none.
template <typename Items, typename Id>
auto byId(Items& items, const Id& id) -> decltype(items.data()) {
  for (auto& item : items) {
    if (item.id == id) return &item;
  }
  return nullptr;
}

template <typename Items>
auto byName(Items& items, std::string_view name) -> decltype(items.data()) {
  for (auto& item : items) {
    if (item.name == name) return &item;
  }
  return nullptr;
}

template <typename Item>
std::optional<Item> copyOf(const Item* item) {
  return item == nullptr ? std::nullopt : std::optional(*item);
}

struct Scene {
  FloorPlan plan;
  std::vector<Trajectory> trajectories;  // ascending by id

  const Trajectory* find(int id) const { return byId(trajectories, id); }
};

/// At most this many submaps can be asked for.
constexpr int kMostSubmaps = 200'000;
/// A map of more submaps has kLooks different ones: it is there to be large, and drawing so many would keep
/// the machine busier than the client that is to be tried against it.
constexpr int kMostOwnLooks = 20'000;
constexpr int kLooks = 256;

/// The named scene with about `submaps` submaps (0: its own size); nullopt when there is no such scene.
std::optional<Scene> makeScene(const std::string& name, int submaps, std::uint32_t seed);

}  // namespace mapwright::simulator
