#include "simulator/web_socket_session.h"

#include "simulator/http_answer.h"
#include "simulator/topic_request.h"
#include "simulator/topic_schedule.h"
#include "simulator/value_json.h"

namespace mapwright::simulator {
namespace {

constexpr std::size_t kMostMessageBytes = 64 << 10;
constexpr std::size_t kMostTopics = 256;
constexpr std::size_t kMostQueued = 32;                           // beyond it, what comes again is left out
constexpr std::size_t kMostQueuedBytes = std::size_t{256} << 20;  // beyond it, the reader is given up

Frame errorFrame(std::string_view sentence) { return textFrame(toJson(Value::Object{{"error", sentence}})); }

}  // namespace

WebSocketSession::WebSocketSession(Connection& connection, Services services, std::string_view target)
    : WebSocketLink(connection, kMostMessageBytes, kMostQueuedBytes),
      services_(services),
      binary_(services.robot.options.binary_topics && queryValue(target, "pb") == "1"),
      silent_(services.robot.faults.faults().silent_websocket) {}

bool WebSocketSession::opened() {
  services_.links.join(self());
  return !silent_;
}

void WebSocketSession::gone() {
  services_.links.leave(this);
  topics_.clear();
}

void WebSocketSession::take(const std::string& text, bool is_text) {
  if (!is_text) return send(errorFrame("Binary messages are not understood."));
  const TopicRequest request = parseTopicRequest(text, services_.robot.options.enable_topic_list);
  if (!request.problem.empty()) return send(errorFrame(request.problem));
  for (const std::string& topic : request.enable) {
    if (topics_.size() < kMostTopics) topics_.insert(topic);
  }
  for (const std::string& topic : request.disable) topics_.erase(topic);
  send(textFrame(toJson(Value::Object{{"enabled_topics", Value::List(topics_.begin(), topics_.end())}})));
  for (const std::string& topic : request.enable) {
    if (isLatched(topic)) publish(topic);
  }
}

void WebSocketSession::publish(std::string_view topic) {
  if (!topics_.contains(topic)) return;
  const Faults faults = services_.robot.faults.faults();
  if (silent_ || faults.silent_websocket) return;
  if (mayBeLeftOut(topic) && queued() > kMostQueued) return;
  if (isSlow(topic)) {
    make(std::string(topic));
    return;
  }
  if (std::optional<Frame> frame = services_.messages.messageOf(topic, binary_, faults.bad_entries)) {
    send(std::move(*frame));
  }
}

void WebSocketSession::make(const std::string& topic) {
  const auto [entry, is_new] = making_.try_emplace(topic, false);
  if (!is_new) {
    entry->second = true;
    return;
  }
  services_.loop.work([self = self(), topic] {
    std::optional<Frame> frame = self->services_.messages.messageOf(topic, self->binary_, false);
    self->services_.loop.post([self, topic, frame = std::move(frame)]() mutable {
      const bool again = self->making_.extract(topic).mapped();
      if (frame && self->topics_.contains(topic)) self->send(std::move(*frame));
      if (again) self->publish(topic);
    });
  });
}

}  // namespace mapwright::simulator
