#include "recorder/submap_wishes.h"

#include <algorithm>

namespace mapwright::recorder {

void SubmapWishes::take(const map::SubmapList& list, std::int64_t now_ns) {
  if (which_ == Which::None) return;
  if (list.uuid != uuid_) {
    uuid_ = list.uuid;
    rows_.clear();
    due_.clear();
    asked_ = 0;
  }
  for (const map::SubmapEntry& entry : list.entries) {
    Row& row = rows_[entry.id];
    if (row.listed != entry.version) row.tries = 0;
    row.listed = entry.version;
    judge(entry.id, row, now_ns);
  }
}

void SubmapWishes::judge(map::SubmapId id, const Row& row, std::int64_t now_ns) {
  const bool newer = row.had == 0 || row.listed > row.had;
  if (newer && !row.asked && row.tries < kTries && now_ns >= row.not_before_ns) due_.insert(id);
}

std::vector<map::SubmapKey> SubmapWishes::next() {
  std::vector<map::SubmapKey> keys;
  while (!due_.empty() && asked_ < kAtOnce) {
    const map::SubmapId id = *due_.begin();
    due_.erase(due_.begin());
    Row& row = rows_[id];
    row.asked = true;
    ++asked_;
    keys.push_back({uuid_, id, row.listed});
  }
  return keys;
}

void SubmapWishes::answered(const map::SubmapKey& key, map::SubmapAnswer::Outcome outcome,
                            std::int64_t now_ns) {
  using Outcome = map::SubmapAnswer::Outcome;
  const auto found = rows_.find(key.id);
  if (key.uuid != uuid_ || found == rows_.end() || !found->second.asked) return;
  Row& row = found->second;
  row.asked = false;
  --asked_;
  if (outcome == Outcome::Ok) {
    row.had = std::max(key.version, 1);
    row.tries = 0;
    row.not_before_ns = which_ == Which::All ? now_ns : now_ns + kAgainNs;
  } else if (outcome == Outcome::NotFound) {
    if (row.listed == key.version) row.tries = kTries;
  } else {
    ++row.tries;
    row.not_before_ns = now_ns + kRetryNs;
  }
  judge(key.id, row, now_ns);
}

void SubmapWishes::look(std::int64_t now_ns) {
  for (const auto& [id, row] : rows_) judge(id, row, now_ns);
}

std::size_t SubmapWishes::missing() const {
  std::size_t count = 0;
  for (const auto& [id, row] : rows_) count += row.had == 0;
  return count;
}

}  // namespace mapwright::recorder
