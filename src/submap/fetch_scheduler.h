// Which submap to request next. Pure state; time is passed in; no clocks, no threads, no network. Source:
// docs/protocols/cartographer-submaps.md, "Versions, caching and fetching".
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "map/submap.h"
#include "submap/nearest_first.h"

namespace mapwright::submap {

/// Time on any monotonic clock.
using Millis = std::chrono::milliseconds;

struct SchedulerOptions {
  int max_concurrent = 4;
  Millis cooldown{3'000};         // delay after a failure before that submap is retried
  Millis cooldown_limit{60'000};  // the delay doubles up to this
  Millis min_interval{250};       // between two requests for one submap
  std::uint32_t jitter_seed = 1;
};

/// The state of the wanted version of a submap.
enum class FetchState {
  Idle,      // nothing to do: loaded, or not wanted
  Queued,    // will be requested
  Fetching,  // request in progress
  Missing,   // 404 for this version
  Waiting,   // failed; waits for a retry
};

/// Decides which keys to request. One fetch per key while it is wanted, at most max_concurrent at a time and
/// one per submap; a 404 is remembered for its key; any other failure makes that submap wait (backoff with
/// jitter). Keys of another uuid, superseded versions and unwanted submaps are never requested. Visible ones
/// come first, then by distance. Only bulk calls (setUuid, retryNow) cost more with more submaps.
class FetchScheduler {
 public:
  explicit FetchScheduler(SchedulerOptions options = {});

  /// A new SLAM session: drops everything of the old one. Requests in progress keep their slot until
  /// answered().
  void setUuid(const std::string& uuid);
  /// A new list arrived: submaps that wait for one (UUID_MISMATCH) may be retried. Returns them.
  std::vector<map::SubmapId> listArrived();
  /// The robot lists `version` of `id`. Does nothing for loaded or remembered versions.
  void want(map::SubmapId id, std::int32_t version);
  /// The submap left the list.
  void unwant(map::SubmapId id);
  /// The answer for this key is not available (unusable, or lost since): requests it once more if it is still
  /// wanted.
  void again(const map::SubmapKey& key);
  /// Drops waits and remembered 404s, so that everything missing is tried at once. Returns those that had
  /// failed or were missing.
  std::vector<map::SubmapId> retryNow();

  /// The position of a wanted submap, metres in the world, and whether it is hidden. By default: at the
  /// origin, visible.
  void place(map::SubmapId id, const Eigen::Vector2d& at, bool hidden);
  /// The visible area.
  void setView(const geometry::WorldRect& visible_world, const Eigen::Vector2d& center_m);

  /// Keys to request now; they count as in progress until answered().
  std::vector<map::SubmapKey> take(Millis now);
  /// When take() may return something new without any other event; nullopt = only after another event.
  std::optional<Millis> nextDue(Millis now) const;
  /// The answer for a key from take(). `answered_version` is the answer's own version (0 = not stated).
  void answered(const map::SubmapKey& key, map::SubmapAnswer::Outcome outcome, std::int32_t answered_version,
                Millis now);

  FetchState state(map::SubmapId id) const;
  int failures(map::SubmapId id) const;  // in a row
  int inProgress() const { return int(in_progress_.size()); }
  int queued() const { return queued_; }
  /// Nothing more can be loaded without retrying what failed at least `tries` times.
  bool settled(int tries) const;

 private:
  struct Request {
    std::int32_t wanted = 0;
    std::int32_t satisfied = -1;  // highest version received
    bool any_answer = false;
    std::vector<std::int32_t> not_found;  // versions that gave 404
    int failures = 0;
    bool waits_for_list = false;
    Millis not_before{0};
    bool fetching = false;
    bool failed = false;  // the last attempt failed and has not been repeated
    bool hidden = false;
    Eigen::Vector2d at{0, 0};
    // Where it is filed: see file().
    FetchState filed_as = FetchState::Idle;
    bool in_line = false, resting = false;
  };
  using Requests = std::unordered_map<map::SubmapId, Request>;
  static bool missing(const Request& request);
  static bool open(const Request& request);
  static FetchState stateOf(const Request& request);
  bool isInProgress(map::SubmapId id) const;
  void unfile(map::SubmapId id, Request& request);
  void file(map::SubmapId id, Request& request);
  template <typename Change>
  void change(Requests::iterator at, Change change);

  SchedulerOptions options_;
  std::string uuid_;
  Requests requests_;
  std::vector<map::SubmapKey> in_progress_;
  NearestFirst line_;                                 // open, and can be requested as far as known
  std::set<std::pair<Millis, map::SubmapId>> rests_;  // open, but not before that time
  std::unordered_set<map::SubmapId> troubled_;        // had a failure or a 404
  std::unordered_set<map::SubmapId> waits_for_list_;
  std::map<int, int> failing_;  // how many are Waiting, by their failures in a row
  int queued_ = 0;
  Millis now_{0};  // the latest time passed in
  std::minstd_rand random_;
};

}  // namespace mapwright::submap
