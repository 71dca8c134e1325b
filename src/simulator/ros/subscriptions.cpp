#include "simulator/ros/subscriptions.h"

#include <algorithm>

#include "simulator/value_cbor.h"
#include "simulator/value_json.h"

namespace mapwright::simulator::ros {
namespace {

constexpr std::size_t kMostSubscriptions = 1000, kMostOfOne = 100, kLongestQueue = 1000;

}  // namespace

Publication::Publication(std::string topic, Value msg, RosWriter writer)
    : topic_(std::move(topic)), writer_(writer) {
  message_.set("op", "publish");
  message_.set("topic", topic_);
  message_.set("msg", std::move(msg));
}

const std::string& Publication::json() const {
  if (json_.empty()) json_ = toJson(message_, writer_);
  return json_;
}

const std::string& Publication::png() const {
  if (png_.empty()) png_ = toPng(json());
  return png_;
}

const std::optional<std::string>& Publication::cbor() const {
  if (!cbor_) cbor_ = toCbor(message_);
  return *cbor_;
}

bool Subscriptions::add(const std::string& topic, const std::string& id, Subscription wanted) {
  if (topics_.size() >= kMostSubscriptions && !has(topic)) return false;
  wanted.queue_length = std::min(wanted.queue_length, kLongestQueue);
  std::map<std::string, Subscription>& by_id = topics_[topic].by_id;
  if (by_id.size() >= kMostOfOne && !by_id.contains(id)) return false;
  by_id[id] = std::move(wanted);
  return true;
}

void Subscriptions::remove(const std::string& topic, const std::optional<std::string>& id) {
  const auto found = topics_.find(topic);
  if (found == topics_.end()) return;
  if (id) found->second.by_id.erase(*id);
  if (!id || found->second.by_id.empty()) topics_.erase(found);
}

Subscription Subscriptions::merged(const Topic& topic) {
  Subscription merged = topic.by_id.begin()->second;
  for (const auto& [id, one] : topic.by_id) {
    merged.throttle = std::min(merged.throttle, one.throttle);
    merged.queue_length = std::min(merged.queue_length, one.queue_length);
    if (merged.compression != Compression::Png && one.compression != Compression::None)
      merged.compression = one.compression;
    if (merged.type.empty()) merged.type = one.type;
  }
  return merged;
}

std::optional<Subscription> Subscriptions::of(std::string_view topic) const {
  const auto found = topics_.find(topic);
  if (found == topics_.end()) return std::nullopt;
  return merged(found->second);
}

bool Subscriptions::take(const PublicationPtr& message, Time now) {
  const auto found = topics_.find(message->topic());
  if (found == topics_.end()) return false;
  Topic& topic = found->second;
  const Subscription wanted = merged(topic);
  if (now >= topic.free_at && topic.waiting.empty()) {
    topic.free_at = now + wanted.throttle;
    return true;
  }
  if (wanted.queue_length == 0) return false;
  topic.waiting.push_back(message);
  while (topic.waiting.size() > wanted.queue_length) topic.waiting.pop_front();
  return false;
}

std::vector<PublicationPtr> Subscriptions::due(Time now) {
  std::vector<PublicationPtr> messages;
  for (auto& [name, topic] : topics_) {
    if (topic.waiting.empty() || now < topic.free_at) continue;
    messages.push_back(topic.waiting.front());
    topic.waiting.pop_front();
    topic.free_at = now + merged(topic).throttle;
  }
  return messages;
}

}  // namespace mapwright::simulator::ros
