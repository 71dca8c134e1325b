// The recordings of the simulated robot: bags continuously, recordings on demand.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "simulator/bag_recording.h"
#include "simulator/robot_state.h"

namespace mapwright::simulator {

enum class BagFolder { Bags, Recordings };
enum class BagCondition { Whole, Recording, Corrupt };

struct Bag {
  std::string name;
  BagSpan span;
  BagCondition condition = BagCondition::Whole;
};

/// "31-Oct-2023 14:36:17" of a simulated second.
std::string listedTime(double time_s);
/// "6.8KB".
std::string listedSize(std::size_t bytes);
/// A ROS bag without messages; half of it if the bag is damaged.
std::string bagBytes(const Bag& bag);

/// Safe from any thread. Every ten minutes of simulated time are one bag; the newest dozen are kept.
class BagStore {
 public:
  /// `odd`: with the bags of BagOptions::odd.
  BagStore(const RobotState& state, bool odd);

  std::vector<Bag> list(BagFolder folder) const;  // oldest first
  std::optional<Bag> find(BagFolder folder, std::string_view name) const;
  /// Stores the last seconds. Replaces a file with the same second and name.
  Bag record(std::string_view suffix, double duration_s, bool every_scan);

  enum class Removal { Removed, Missing, Recording };
  Removal remove(BagFolder folder, std::string_view name);
  /// The bag being recorded stays.
  void removeAll(BagFolder folder);

 private:
  std::vector<Bag> bags() const;

  const RobotState& state_;
  const bool odd_;
  mutable std::mutex mutex_;
  std::set<std::string, std::less<>> removed_;  // bags
  std::vector<Bag> recordings_;
};

}  // namespace mapwright::simulator
