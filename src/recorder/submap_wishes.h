// Which submaps a recording asks the robot for. Pure; time is handed in.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "map/submap.h"

namespace mapwright::recorder {

class SubmapWishes {
 public:
  enum class Which : std::uint8_t {
    None,
    Listed,  // each that is listed, and one that changes again at most every kAgainNs
    All,     // every version that is listed, as fast as the robot gives them
  };
  static constexpr std::int64_t kAgainNs = 30'000'000'000;
  static constexpr std::int64_t kRetryNs = 2'000'000'000;
  static constexpr int kTries = 5;  // of one version
  static constexpr std::size_t kAtOnce = 4;

  explicit SubmapWishes(Which which) : which_(which) {}

  void take(const map::SubmapList& list, std::int64_t now_ns);
  /// What is to be asked for now; it counts as asked for until it is answered.
  std::vector<map::SubmapKey> next();
  void answered(const map::SubmapKey& key, map::SubmapAnswer::Outcome outcome, std::int64_t now_ns);
  /// Looks for what is due by time alone.
  void look(std::int64_t now_ns);
  /// How many listed ones were never had.
  std::size_t missing() const;

 private:
  struct Row {
    std::int32_t listed = 0, had = 0;  // versions; had 0: none
    std::int64_t not_before_ns = 0;
    int tries = 0;  // of the version `listed`
    bool asked = false;
  };
  void judge(map::SubmapId id, const Row& row, std::int64_t now_ns);

  Which which_;
  std::string uuid_;
  std::map<map::SubmapId, Row> rows_;
  std::set<map::SubmapId> due_;
  std::size_t asked_ = 0;
};

}  // namespace mapwright::recorder
