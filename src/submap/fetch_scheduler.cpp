#include "submap/fetch_scheduler.h"

#include <algorithm>

#include "map/submap_version.h"

namespace mapwright::submap {

using Outcome = map::SubmapAnswer::Outcome;

namespace {

/// One that is listed without a version is asked for again so often.
constexpr Millis kUnversionedEvery{30'000};

}  // namespace

FetchScheduler::FetchScheduler(SchedulerOptions options) : options_(options), random_(options.jitter_seed) {}

bool FetchScheduler::missing(const Request& request) {
  return std::find(request.not_found.begin(), request.not_found.end(), request.wanted) !=
         request.not_found.end();
}

bool FetchScheduler::open(const Request& request) {
  return !request.fetching && !request.waits_for_list &&
         (!request.any_answer || request.wanted > request.satisfied) && !missing(request);
}

FetchState FetchScheduler::stateOf(const Request& request) {
  if (request.fetching) return FetchState::Fetching;
  if (missing(request)) return FetchState::Missing;
  if (request.failed) return FetchState::Waiting;
  return open(request) ? FetchState::Queued : FetchState::Idle;
}

bool FetchScheduler::isInProgress(map::SubmapId id) const {
  return std::any_of(in_progress_.begin(), in_progress_.end(),
                     [&](const map::SubmapKey& key) { return key.id == id && key.uuid == uuid_; });
}

void FetchScheduler::unfile(map::SubmapId id, Request& request) {
  if (request.in_line) line_.remove(id);
  if (request.resting) rests_.erase({request.not_before, id});
  request.in_line = request.resting = false;
  if (request.filed_as == FetchState::Queued) --queued_;
  if (request.filed_as == FetchState::Waiting) {
    const auto count = failing_.find(request.failures);
    if (--count->second == 0) failing_.erase(count);
  }
  request.filed_as = FetchState::Idle;
}

void FetchScheduler::file(map::SubmapId id, Request& request) {
  request.filed_as = stateOf(request);
  if (request.filed_as == FetchState::Queued) ++queued_;
  if (request.filed_as == FetchState::Waiting) ++failing_[request.failures];
  if (request.failed || !request.not_found.empty() || request.wanted == map::kNoVersion) {
    troubled_.insert(id);
  } else if (!troubled_.empty()) {
    troubled_.erase(id);
  }
  // One that left the list and came back while its query was still in progress waits for that one's end.
  if (!open(request) || isInProgress(id)) return;
  if (request.not_before > now_) {
    request.resting = true;
    rests_.emplace(request.not_before, id);
  } else {
    request.in_line = true;
    line_.put(id, request.at, request.hidden);
  }
}

template <typename Change>
void FetchScheduler::change(Requests::iterator at, Change change) {
  unfile(at->first, at->second);
  change(at->second);
  file(at->first, at->second);
}

void FetchScheduler::setUuid(const std::string& uuid) {
  if (uuid == uuid_) return;
  uuid_ = uuid;
  requests_.clear();
  line_.clear();
  rests_.clear();
  troubled_.clear();
  waits_for_list_.clear();
  failing_.clear();
  queued_ = 0;
}

std::vector<map::SubmapId> FetchScheduler::listArrived() {
  std::vector<map::SubmapId> ready(waits_for_list_.begin(), waits_for_list_.end());
  for (const map::SubmapId id : ready)
    change(requests_.find(id), [](Request& request) { request.waits_for_list = false; });
  waits_for_list_.clear();
  // What nobody has seen yet comes first.
  if (queued_ > 0 || !in_progress_.empty()) return ready;
  const std::vector<map::SubmapId> troubled(troubled_.begin(), troubled_.end());
  for (const map::SubmapId id : troubled) {
    const auto at = requests_.find(id);
    const Request& row = at->second;
    const bool answered = row.any_answer || missing(row);
    if (row.wanted != map::kNoVersion || !answered || row.not_before > now_) continue;
    change(at, [](Request& request) {
      request.any_answer = false;
      request.not_found.clear();
    });
    ready.push_back(id);
  }
  return ready;
}

void FetchScheduler::want(map::SubmapId id, std::int32_t version) {
  const auto [it, added] = requests_.try_emplace(id);
  if (!added && it->second.wanted == version) return;
  change(it, [version](Request& request) {
    request.wanted = version;
    if (version == map::kNoVersion) request.any_answer = false;
    if (version >= 0 && request.satisfied >= version) request.any_answer = true;
  });
}

void FetchScheduler::unwant(map::SubmapId id) {
  const auto it = requests_.find(id);
  if (it == requests_.end()) return;
  unfile(id, it->second);
  requests_.erase(it);
  troubled_.erase(id);
  waits_for_list_.erase(id);
}

void FetchScheduler::again(const map::SubmapKey& key) {
  const auto it = requests_.find(key.id);
  if (key.uuid != uuid_ || it == requests_.end() || it->second.wanted != key.version) return;
  change(it, [](Request& request) {
    request.any_answer = false;
    request.satisfied = -1;
  });
}

std::vector<map::SubmapId> FetchScheduler::retryNow() {
  const std::vector<map::SubmapId> troubled(troubled_.begin(), troubled_.end());
  for (const map::SubmapId id : troubled) {
    change(requests_.find(id), [](Request& request) {
      request.not_found.clear();
      request.not_before = Millis(0);
      request.failures = 0;
      request.waits_for_list = false;
    });
  }
  waits_for_list_.clear();
  // Those that only rest from their last query, too.
  while (!rests_.empty()) {
    change(requests_.find(rests_.begin()->second), [](Request& request) { request.not_before = Millis(0); });
  }
  return troubled;
}

void FetchScheduler::place(map::SubmapId id, const Eigen::Vector2d& at, bool hidden) {
  const auto it = requests_.find(id);
  if (it == requests_.end()) return;
  Request& request = it->second;
  request.at = at;
  request.hidden = hidden;
  if (request.in_line) line_.put(id, at, hidden);
}

void FetchScheduler::setView(const geometry::WorldRect& visible_world, const Eigen::Vector2d& center_m) {
  line_.setView(visible_world, center_m);
}

std::vector<map::SubmapKey> FetchScheduler::take(Millis now) {
  now_ = std::max(now_, now);
  std::vector<map::SubmapKey> keys;
  if (uuid_.empty()) return keys;
  while (!rests_.empty() && rests_.begin()->first <= now) {
    change(requests_.find(rests_.begin()->second), [](Request&) {});
  }
  while (inProgress() < options_.max_concurrent) {
    const auto id = line_.take();
    if (!id) break;
    const auto it = requests_.find(*id);
    it->second.in_line = false;
    change(it, [](Request& request) {
      request.fetching = true;
      request.failed = false;
    });
    keys.push_back({uuid_, *id, it->second.wanted});
    in_progress_.push_back(keys.back());
  }
  return keys;
}

std::optional<Millis> FetchScheduler::nextDue(Millis now) const {
  if (uuid_.empty() || inProgress() >= options_.max_concurrent) return std::nullopt;
  if (line_.size() > 0) return now;
  if (rests_.empty()) return std::nullopt;
  return std::max(rests_.begin()->first, now);
}

void FetchScheduler::answered(const map::SubmapKey& key, Outcome outcome, std::int32_t answered_version,
                              Millis now) {
  now_ = std::max(now_, now);
  const auto sent = std::find(in_progress_.begin(), in_progress_.end(), key);
  if (sent == in_progress_.end()) return;
  in_progress_.erase(sent);
  if (key.uuid != uuid_) return;
  const auto it = requests_.find(key.id);
  if (it == requests_.end()) return;
  const bool versioned = key.version != map::kNoVersion;
  const std::int32_t version = answered_version > 0 ? answered_version : key.version;
  // The version that is listed is still due.
  if (outcome == Outcome::Ok && version < key.version) outcome = Outcome::Failed;
  change(it, [&](Request& request) {
    request.fetching = false;
    request.not_before = now + options_.min_interval;
    switch (outcome) {
      case Outcome::Ok:
        request.failures = 0;
        request.any_answer = true;
        // Without a version what came last counts, also of a robot that begins anew.
        request.satisfied = versioned ? std::max(request.satisfied, version) : version;
        if (!versioned) request.not_before = now + kUnversionedEvery;
        break;
      case Outcome::NotFound:
        request.failures = 0;
        request.not_found.push_back(key.version);
        if (!versioned) request.not_before = now + kUnversionedEvery;
        break;
      case Outcome::Cancelled:
        break;
      case Outcome::WrongUuid:
        request.waits_for_list = true;
        waits_for_list_.insert(key.id);
        [[fallthrough]];
      case Outcome::Failed: {
        const int doublings = std::min(request.failures, 16);
        ++request.failures;
        request.failed = true;
        const double jitter = std::uniform_real_distribution<double>(1.0, 1.25)(random_);
        const double wait = std::min(double(options_.cooldown.count()) * double(1 << doublings) * jitter,
                                     double(options_.cooldown_limit.count()));
        request.not_before = now + Millis(std::max<std::int64_t>(1, std::int64_t(wait)));
        break;
      }
    }
  });
}

FetchState FetchScheduler::state(map::SubmapId id) const {
  const auto it = requests_.find(id);
  return it == requests_.end() ? FetchState::Idle : stateOf(it->second);
}

int FetchScheduler::failures(map::SubmapId id) const {
  const auto it = requests_.find(id);
  return it == requests_.end() ? 0 : it->second.failures;
}

bool FetchScheduler::settled(int tries) const {
  return in_progress_.empty() && queued_ == 0 && (failing_.empty() || failing_.begin()->first >= tries);
}

}  // namespace mapwright::submap
