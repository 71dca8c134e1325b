#include "recorder/entry_queue.h"

#include <utility>

namespace mapwright::recorder {
namespace {

constexpr std::size_t kOverhead = 256;  // memory of an entry besides its bytes

}  // namespace

bool EntryQueue::put(Entry entry, std::string_view bytes) {
  const std::size_t size = bytes.size() + kOverhead;
  {
    const std::lock_guard lock(mutex_);
    if (closed_) return false;
    if (entry.kind == Entry::Kind::Message && !entry.before) entry.sequence = ++sequences_[entry.name];
    if (entry.kind == Entry::Kind::Message && entry.before) said_before_.insert(entry.name);
    // One that exceeds the limit is accepted if it is alone.
    if (held_bytes_ > 0 && held_bytes_ + size > most_bytes_) {
      ++lost_.entries;
      lost_.bytes += bytes.size();
      return false;
    }
    held_bytes_ += size;
    ++being_put_;
  }
  entry.bytes.assign(bytes);
  {
    const std::lock_guard lock(mutex_);
    --being_put_;
    entries_.push_back(std::move(entry));
  }
  came_.notify_one();
  return true;
}

bool EntryQueue::heard(const std::string& topic) const {
  const std::lock_guard lock(mutex_);
  return sequences_.contains(topic) || said_before_.contains(topic);
}

std::vector<Entry> EntryQueue::take(std::chrono::milliseconds at_most) {
  std::unique_lock lock(mutex_);
  came_.wait_for(lock, at_most, [this] { return !entries_.empty() || (closed_ && being_put_ == 0); });
  for (const Entry& entry : entries_) held_bytes_ -= entry.bytes.size() + kOverhead;
  return std::exchange(entries_, {});
}

void EntryQueue::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  came_.notify_one();
}

bool EntryQueue::over() const {
  const std::lock_guard lock(mutex_);
  return closed_ && entries_.empty() && being_put_ == 0;
}

EntryQueue::Losses EntryQueue::lost() const {
  const std::lock_guard lock(mutex_);
  return lost_;
}

}  // namespace mapwright::recorder
