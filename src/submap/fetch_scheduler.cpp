#include "submap/fetch_scheduler.h"

#include <algorithm>
#include <utility>

namespace mapwright::submap {

using Outcome = map::SubmapAnswer::Outcome;

FetchScheduler::FetchScheduler(SchedulerOptions options) : options_(options), random_(options.jitter_seed) {}

void FetchScheduler::setUuid(const std::string& uuid) {
  if (uuid == uuid_) return;
  uuid_ = uuid;
  wishes_.clear();
  queue_stale_ = true;
}

void FetchScheduler::listArrived() {
  for (auto& [id, wish] : wishes_) {
    if (!wish.waits_for_list) continue;
    wish.waits_for_list = false;
    queue_stale_ = true;
  }
}

void FetchScheduler::want(map::SubmapId id, std::int32_t version) {
  const auto [it, added] = wishes_.try_emplace(id);
  if (!added && it->second.wanted == version) return;
  it->second.wanted = version;
  queue_stale_ = true;
}

void FetchScheduler::unwant(map::SubmapId id) {
  if (wishes_.erase(id) > 0) queue_stale_ = true;
}

void FetchScheduler::again(const map::SubmapKey& key) {
  const auto it = wishes_.find(key.id);
  if (key.uuid != uuid_ || it == wishes_.end() || it->second.wanted != key.version) return;
  it->second.any_answer = false;
  it->second.satisfied = -1;
  queue_stale_ = true;
}

void FetchScheduler::retryNow() {
  for (auto& [id, wish] : wishes_) {
    wish.not_found.clear();
    wish.not_before = Millis(0);
    wish.failures = 0;
    wish.waits_for_list = false;
  }
  queue_stale_ = true;
}

void FetchScheduler::setPriority(std::function<double(map::SubmapId)> priority) {
  priority_ = std::move(priority);
  queue_stale_ = true;
}

void FetchScheduler::reorder() { queue_stale_ = true; }

bool FetchScheduler::open(const Wish& wish) const {
  return !wish.fetching && !wish.waits_for_list && (!wish.any_answer || wish.wanted > wish.satisfied) &&
         !wish.not_found.contains(wish.wanted);
}

void FetchScheduler::rebuildQueue() {
  std::vector<std::pair<double, map::SubmapId>> order;
  for (const auto& [id, wish] : wishes_) {
    if (open(wish)) order.emplace_back(priority_ ? priority_(id) : 0.0, id);
  }
  std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a > b; });
  queue_.clear();
  for (const auto& [priority, id] : order) queue_.push_back(id);
  queue_stale_ = false;
}

std::vector<map::SubmapKey> FetchScheduler::take(Millis now) {
  std::vector<map::SubmapKey> keys;
  if (uuid_.empty() || underWay() >= options_.max_concurrent) return keys;
  if (queue_stale_) rebuildQueue();
  std::vector<map::SubmapId> not_yet;
  while (!queue_.empty() && underWay() < options_.max_concurrent) {
    const map::SubmapId id = queue_.back();
    queue_.pop_back();
    Wish& wish = wishes_.at(id);
    if (!open(wish)) continue;  // satisfied since the queue was made
    if (wish.not_before > now) {
      not_yet.push_back(id);
      continue;
    }
    const map::SubmapKey key{uuid_, id, wish.wanted};
    // The submap left the list and came back while its query was still under way.
    if (std::any_of(under_way_.begin(), under_way_.end(),
                    [&](const map::SubmapKey& k) { return k.uuid == key.uuid && k.id == key.id; })) {
      not_yet.push_back(id);
      continue;
    }
    wish.fetching = true;
    wish.failed = false;
    under_way_.push_back(key);
    keys.push_back(key);
  }
  queue_.insert(queue_.end(), not_yet.rbegin(), not_yet.rend());
  return keys;
}

std::optional<Millis> FetchScheduler::nextDue(Millis now) const {
  std::optional<Millis> due;
  if (uuid_.empty() || underWay() >= options_.max_concurrent) return due;
  for (const auto& [id, wish] : wishes_) {
    if (!open(wish)) continue;
    const Millis at = std::max(wish.not_before, now);
    if (!due || at < *due) due = at;
  }
  return due;
}

void FetchScheduler::answered(const map::SubmapKey& key, Outcome outcome, std::int32_t answered_version,
                              Millis now) {
  const auto sent = std::find(under_way_.begin(), under_way_.end(), key);
  if (sent == under_way_.end()) return;
  under_way_.erase(sent);
  if (key.uuid != uuid_) return;
  const auto it = wishes_.find(key.id);
  if (it == wishes_.end()) return;
  Wish& wish = it->second;
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
      wish.not_found.insert(key.version);
      break;
    case Outcome::Cancelled:
      break;
    case Outcome::WrongUuid:
      wish.waits_for_list = true;
      [[fallthrough]];
    case Outcome::Failed: {
      const int doublings = std::min(wish.failures, 16);
      ++wish.failures;
      wish.failed = true;
      const double jitter = std::uniform_real_distribution<double>(1.0, 1.25)(random_);
      const double wait = std::min(double(options_.cooldown.count()) * double(1 << doublings) * jitter,
                                   double(std::max(options_.cooldown, options_.cooldown_limit).count()));
      wish.not_before = now + std::max(options_.cooldown, Millis(std::int64_t(wait)));
      break;
    }
  }
  // Back to the end of the line until the next ordering: sorting ten thousand submaps at every answer would
  // cost more than the answers.
  if (open(wish) && !queue_stale_) queue_.insert(queue_.begin(), key.id);
}

FetchState FetchScheduler::state(map::SubmapId id) const {
  const auto it = wishes_.find(id);
  if (it == wishes_.end()) return FetchState::Idle;
  const Wish& wish = it->second;
  if (wish.fetching) return FetchState::Fetching;
  if (wish.not_found.contains(wish.wanted)) return FetchState::Missing;
  if (wish.failed) return FetchState::Waiting;
  return open(wish) ? FetchState::Queued : FetchState::Idle;
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

int FetchScheduler::queued() const {
  int count = 0;
  for (const auto& [id, wish] : wishes_) count += open(wish) && !wish.failed;
  return count;
}

}  // namespace mapwright::submap
