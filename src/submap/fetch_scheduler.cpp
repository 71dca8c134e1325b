#include "submap/fetch_scheduler.h"

#include <algorithm>

namespace mapwright::submap {

using Outcome = map::SubmapAnswer::Outcome;

FetchScheduler::FetchScheduler(SchedulerOptions options) : options_(options), random_(options.jitter_seed) {}

bool FetchScheduler::missing(const Wish& wish) {
  return std::find(wish.not_found.begin(), wish.not_found.end(), wish.wanted) != wish.not_found.end();
}

bool FetchScheduler::open(const Wish& wish) {
  return !wish.fetching && !wish.waits_for_list && (!wish.any_answer || wish.wanted > wish.satisfied) &&
         !missing(wish);
}

FetchState FetchScheduler::stateOf(const Wish& wish) {
  if (wish.fetching) return FetchState::Fetching;
  if (missing(wish)) return FetchState::Missing;
  if (wish.failed) return FetchState::Waiting;
  return open(wish) ? FetchState::Queued : FetchState::Idle;
}

bool FetchScheduler::isUnderWay(map::SubmapId id) const {
  return std::any_of(under_way_.begin(), under_way_.end(),
                     [&](const map::SubmapKey& key) { return key.id == id && key.uuid == uuid_; });
}

void FetchScheduler::unfile(map::SubmapId id, Wish& wish) {
  if (wish.in_line) line_.remove(id);
  if (wish.resting) rests_.erase({wish.not_before, id});
  wish.in_line = wish.resting = false;
  if (wish.filed_as == FetchState::Queued) --queued_;
  if (wish.filed_as == FetchState::Waiting) {
    const auto count = failing_.find(wish.failures);
    if (--count->second == 0) failing_.erase(count);
  }
  wish.filed_as = FetchState::Idle;
}

void FetchScheduler::file(map::SubmapId id, Wish& wish) {
  wish.filed_as = stateOf(wish);
  if (wish.filed_as == FetchState::Queued) ++queued_;
  if (wish.filed_as == FetchState::Waiting) ++failing_[wish.failures];
  if (wish.failed || !wish.not_found.empty()) {
    troubled_.insert(id);
  } else if (!troubled_.empty()) {
    troubled_.erase(id);
  }
  // One that left the list and came back while its query was still under way waits for that one's end.
  if (!open(wish) || isUnderWay(id)) return;
  if (wish.not_before > now_) {
    wish.resting = true;
    rests_.emplace(wish.not_before, id);
  } else {
    wish.in_line = true;
    line_.put(id, wish.at, wish.hidden);
  }
}

template <typename Change>
void FetchScheduler::change(Wishes::iterator at, Change change) {
  unfile(at->first, at->second);
  change(at->second);
  file(at->first, at->second);
}

void FetchScheduler::setUuid(const std::string& uuid) {
  if (uuid == uuid_) return;
  uuid_ = uuid;
  wishes_.clear();
  line_.clear();
  rests_.clear();
  troubled_.clear();
  waits_for_list_.clear();
  failing_.clear();
  queued_ = 0;
}

std::vector<map::SubmapId> FetchScheduler::listArrived() {
  const std::vector<map::SubmapId> waited(waits_for_list_.begin(), waits_for_list_.end());
  for (const map::SubmapId id : waited)
    change(wishes_.find(id), [](Wish& wish) { wish.waits_for_list = false; });
  waits_for_list_.clear();
  return waited;
}

void FetchScheduler::want(map::SubmapId id, std::int32_t version) {
  const auto [it, added] = wishes_.try_emplace(id);
  if (!added && it->second.wanted == version) return;
  change(it, [version](Wish& wish) { wish.wanted = version; });
}

void FetchScheduler::unwant(map::SubmapId id) {
  const auto it = wishes_.find(id);
  if (it == wishes_.end()) return;
  unfile(id, it->second);
  wishes_.erase(it);
  troubled_.erase(id);
  waits_for_list_.erase(id);
}

void FetchScheduler::again(const map::SubmapKey& key) {
  const auto it = wishes_.find(key.id);
  if (key.uuid != uuid_ || it == wishes_.end() || it->second.wanted != key.version) return;
  change(it, [](Wish& wish) {
    wish.any_answer = false;
    wish.satisfied = -1;
  });
}

std::vector<map::SubmapId> FetchScheduler::retryNow() {
  const std::vector<map::SubmapId> troubled(troubled_.begin(), troubled_.end());
  for (const map::SubmapId id : troubled) {
    change(wishes_.find(id), [](Wish& wish) {
      wish.not_found.clear();
      wish.not_before = Millis(0);
      wish.failures = 0;
      wish.waits_for_list = false;
    });
  }
  waits_for_list_.clear();
  // Those that only rest from their last query, too.
  while (!rests_.empty()) {
    change(wishes_.find(rests_.begin()->second), [](Wish& wish) { wish.not_before = Millis(0); });
  }
  return troubled;
}

void FetchScheduler::place(map::SubmapId id, const Eigen::Vector2d& at, bool hidden) {
  const auto it = wishes_.find(id);
  if (it == wishes_.end()) return;
  Wish& wish = it->second;
  wish.at = at;
  wish.hidden = hidden;
  if (wish.in_line) line_.put(id, at, hidden);
}

void FetchScheduler::setView(const geometry::WorldRect& visible_world, const Eigen::Vector2d& center_m) {
  line_.setView(visible_world, center_m);
}

std::vector<map::SubmapKey> FetchScheduler::take(Millis now) {
  now_ = std::max(now_, now);
  std::vector<map::SubmapKey> keys;
  if (uuid_.empty()) return keys;
  while (!rests_.empty() && rests_.begin()->first <= now) {
    change(wishes_.find(rests_.begin()->second), [](Wish&) {});
  }
  while (underWay() < options_.max_concurrent) {
    const auto id = line_.take();
    if (!id) break;
    const auto it = wishes_.find(*id);
    it->second.in_line = false;
    change(it, [](Wish& wish) {
      wish.fetching = true;
      wish.failed = false;
    });
    keys.push_back({uuid_, *id, it->second.wanted});
    under_way_.push_back(keys.back());
  }
  return keys;
}

std::optional<Millis> FetchScheduler::nextDue(Millis now) const {
  if (uuid_.empty() || underWay() >= options_.max_concurrent) return std::nullopt;
  if (line_.size() > 0) return now;
  if (rests_.empty()) return std::nullopt;
  return std::max(rests_.begin()->first, now);
}

void FetchScheduler::answered(const map::SubmapKey& key, Outcome outcome, std::int32_t answered_version,
                              Millis now) {
  now_ = std::max(now_, now);
  const auto sent = std::find(under_way_.begin(), under_way_.end(), key);
  if (sent == under_way_.end()) return;
  under_way_.erase(sent);
  if (key.uuid != uuid_) return;
  const auto it = wishes_.find(key.id);
  if (it == wishes_.end()) return;
  change(it, [&](Wish& wish) {
    wish.fetching = false;
    wish.not_before = now + options_.min_interval;
    switch (outcome) {
      case Outcome::Ok:
        wish.failures = 0;
        wish.any_answer = true;
        wish.satisfied = std::max({wish.satisfied, key.version, answered_version});
        break;
      case Outcome::NotFound:
        wish.failures = 0;
        wish.not_found.push_back(key.version);
        break;
      case Outcome::Cancelled:
        break;
      case Outcome::WrongUuid:
        wish.waits_for_list = true;
        waits_for_list_.insert(key.id);
        [[fallthrough]];
      case Outcome::Failed: {
        const int doublings = std::min(wish.failures, 16);
        ++wish.failures;
        wish.failed = true;
        const double jitter = std::uniform_real_distribution<double>(1.0, 1.25)(random_);
        const double wait = std::min(double(options_.cooldown.count()) * double(1 << doublings) * jitter,
                                     double(options_.cooldown_limit.count()));
        wish.not_before = now + Millis(std::max<std::int64_t>(1, std::int64_t(wait)));
        break;
      }
    }
  });
}

FetchState FetchScheduler::state(map::SubmapId id) const {
  const auto it = wishes_.find(id);
  return it == wishes_.end() ? FetchState::Idle : stateOf(it->second);
}

int FetchScheduler::failures(map::SubmapId id) const {
  const auto it = wishes_.find(id);
  return it == wishes_.end() ? 0 : it->second.failures;
}

std::optional<Millis> FetchScheduler::retryAt(map::SubmapId id) const {
  const auto it = wishes_.find(id);
  if (it == wishes_.end() || !it->second.failed) return std::nullopt;
  return it->second.not_before;
}

bool FetchScheduler::settled(int tries) const {
  return under_way_.empty() && queued_ == 0 && (failing_.empty() || failing_.begin()->first >= tries);
}

}  // namespace mapwright::submap
