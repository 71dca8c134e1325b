// Which submaps a recording requests. Pure; time is passed in.
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
    Listed,  // each listed one, and changed ones at most every kAgainNs
    All,     // every listed version, as fast as the robot can deliver
  };
  static constexpr std::int64_t kAgainNs = 30'000'000'000;
  static constexpr std::int64_t kRetryNs = 2'000'000'000;
  static constexpr int kTries = 5;  // for each version
  static constexpr std::size_t kAtOnce = 4;

  explicit SubmapWishes(Which which) : which_(which) {}

  void take(const map::SubmapList& list, std::int64_t now_ns);
  /// What to request now; it counts as requested until it is answered.
  std::vector<map::SubmapKey> next();
  void answered(const map::SubmapKey& key, map::SubmapAnswer::Outcome outcome, std::int64_t now_ns);
  /// Checks what has become due.
  void look(std::int64_t now_ns);
  /// How many listed ones were never received.
  std::size_t missing() const;

 private:
  struct Row {
    std::int32_t listed = 0, had = 0;  // versions; had 0: none
    std::int64_t not_before_ns = 0;
    int tries = 0;  // for the version `listed`
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
