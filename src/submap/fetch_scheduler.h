// Which submap to ask for next. Pure state with the time handed in; no clocks, no threads, no network.
// Source: submap-textures.md, "Versions, cache and fetch rules".
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "map/submap.h"

namespace mapwright::submap {

/// Time on any monotonic clock.
using Millis = std::chrono::milliseconds;

struct SchedulerOptions {
  int max_concurrent = 4;
  Millis cooldown{3'000};         // after a failure, before that submap is tried again
  Millis cooldown_limit{60'000};  // the wait doubles up to this
  Millis min_interval{250};       // between two queries of one submap
  std::uint32_t jitter_seed = 1;
};

/// Where the wanted version of a submap stands.
enum class FetchState {
  Idle,      // nothing to do: have it, or not wanted
  Queued,    // will be asked for
  Fetching,  // is being asked for
  Missing,   // 404 for this version
  Waiting,   // failed; waits for its next try
};

/// Decides which keys go out. One fetch per key while it is wanted, at most max_concurrent at a time and one
/// per submap; a 404 is remembered for its key; any other failure makes that submap wait (backoff with
/// jitter). Keys of another uuid, superseded versions and unwanted submaps are never sent.
class FetchScheduler {
 public:
  explicit FetchScheduler(SchedulerOptions options = {});

  /// A new SLAM session: forgets everything of the old one. Answers still under way keep their slot until
  /// answered().
  void setUuid(const std::string& uuid);
  /// A new list arrived: submaps that wait for one (UUID_MISMATCH) may be tried again.
  void listArrived();
  /// The robot lists `version` of `id`. Satisfied or remembered versions cause nothing.
  void want(map::SubmapId id, std::int32_t version);
  /// The submap left the list.
  void unwant(map::SubmapId id);
  /// The answer for this key was of no use: it is asked for once more, if it is still the one that is wanted.
  void again(const map::SubmapKey& key);
  /// Forgets waits and remembered 404s, so that everything not yet satisfied is tried at once.
  void retryNow();

  /// Smaller goes first. Evaluated again after reorder().
  void setPriority(std::function<double(map::SubmapId)> priority);
  void reorder();

  /// Keys to send now; they count as under way until answered().
  std::vector<map::SubmapKey> take(Millis now);
  /// When take() may have something new without any other event; nullopt = not before another event.
  std::optional<Millis> nextDue(Millis now) const;
  /// An answer for a key that take() gave. `answered_version` is the answer's own version (0 = unsaid).
  void answered(const map::SubmapKey& key, map::SubmapAnswer::Outcome outcome, std::int32_t answered_version,
                Millis now);

  FetchState state(map::SubmapId id) const;
  int failures(map::SubmapId id) const;                   // in a row
  std::optional<Millis> retryAt(map::SubmapId id) const;  // while Waiting
  int underWay() const { return int(under_way_.size()); }
  int queued() const;

 private:
  struct Wish {
    std::int32_t wanted = 0;
    std::int32_t satisfied = -1;  // highest version that was answered
    bool any_answer = false;
    std::unordered_set<std::int32_t> not_found;  // versions that gave 404
    int failures = 0;
    bool waits_for_list = false;
    Millis not_before{0};
    bool fetching = false;
    bool failed = false;  // last try failed and has not been repeated
  };
  bool open(const Wish& wish) const;
  void rebuildQueue();

  SchedulerOptions options_;
  std::string uuid_;
  std::unordered_map<map::SubmapId, Wish> wishes_;
  std::vector<map::SubmapKey> under_way_;
  std::vector<map::SubmapId> queue_;  // best last
  bool queue_stale_ = true;
  std::function<double(map::SubmapId)> priority_;
  std::minstd_rand random_;
};

}  // namespace mapwright::submap
