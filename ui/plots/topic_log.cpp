#include "ui/plots/topic_log.h"

#include <algorithm>

namespace mapwright::window {

namespace {
constexpr qint64 kShortestSpanMs = 1'000;  // a single message just now does not mean a thousand per second
}

void TopicLog::note(const robot::RawMessage& message, qint64 now_ms, Telling telling) {
  auto found = topics_.find(message.topic);
  if (found == topics_.end()) {
    if (topics_.size() >= std::size_t(kMaxTopics)) {
      ++dropped_;
      return;
    }
    found = topics_.emplace(message.topic, TopicTally{}).first;
    found->second.topic = message.topic;
  }
  TopicTally& tally = found->second;
  Arrivals& arrivals = arrivals_[message.topic];
  const bool counted = telling == Telling::Again && tally.count > 0 && tally.last == message.received;
  tally.binary = message.binary;
  if (!counted) ++tally.count;
  tally.last_bytes = message.bytes;
  tally.last = message.received;
  tally.cut = message.text.size() > kMaxText || message.text.size() >= robot::kMaxRawText;
  tally.text = tally.cut ? message.text.left(kMaxText) : message.text;
  if (tally.count == 1) arrivals.first_ms = now_ms;
  while (!arrivals.recent.empty() &&
         (arrivals.recent.size() >= kMaxRecent || arrivals.recent.front().first <= now_ms - kRateSpanMs)) {
    arrivals.recent.pop_front();
  }
  if (!counted) arrivals.recent.emplace_back(now_ms, message.bytes);
}

void TopicLog::setAskedFor(const QStringList& topics) {
  for (auto it = topics_.begin(); it != topics_.end();) {
    it->second.asked_for = topics.contains(it->first);
    // A row without any messages is removed.
    it = !it->second.asked_for && it->second.count == 0 ? topics_.erase(it) : std::next(it);
  }
  for (const QString& topic : topics) {
    TopicTally& tally = topics_[topic];
    tally.topic = topic;
    tally.asked_for = true;
  }
}

void TopicLog::clear() {
  QStringList asked;
  for (const auto& [topic, tally] : topics_) {
    if (tally.asked_for) asked << topic;
  }
  topics_.clear();
  arrivals_.clear();
  dropped_ = 0;
  setAskedFor(asked);
}

const TopicTally* TopicLog::find(const QString& topic) const {
  const auto found = topics_.find(topic);
  return found == topics_.end() ? nullptr : &found->second;
}

template <typename Sum>
double TopicLog::perSecond(const QString& topic, qint64 now_ms, Sum sum) const {
  const auto found = arrivals_.find(topic);
  if (found == arrivals_.end()) return 0;
  double total = 0;
  qint64 since = recorded_ ? rates_from_ms_ : found->second.first_ms;
  for (const auto& [when, bytes] : found->second.recent) {
    const bool within = when > now_ms - kRateSpanMs && (!recorded_ || (when > since && when <= now_ms));
    if (within) total += sum(bytes);
  }
  // There were so many that the oldest ones are no longer stored.
  if (found->second.recent.size() >= kMaxRecent) since = found->second.recent.front().first;
  const qint64 span = std::clamp(now_ms - since, kShortestSpanMs, kRateSpanMs);
  return total * 1000.0 / double(span);
}

bool TopicLog::ratesKnown(const QString& topic, qint64 now_ms) const {
  const auto found = arrivals_.find(topic);
  if (found == arrivals_.end() || found->second.recent.empty()) return false;
  return !recorded_ || now_ms - rates_from_ms_ >= kShortestSpanMs;
}

double TopicLog::messagesPerSecond(const QString& topic, qint64 now_ms) const {
  return perSecond(topic, now_ms, [](qint64) { return 1.0; });
}

double TopicLog::bytesPerSecond(const QString& topic, qint64 now_ms) const {
  return perSecond(topic, now_ms, [](qint64 bytes) { return double(bytes); });
}

}  // namespace mapwright::window
