#include "simulator/ros/ros_session.h"

#include <algorithm>
#include <optional>

#include "simulator/ros/fragments.h"
#include "simulator/ros/ros_server.h"
#include "simulator/value_json.h"

namespace mapwright::simulator::ros {
namespace {

constexpr std::size_t kMostMessageBytes = std::size_t{128} << 20;  // a map's picture as base64
constexpr std::size_t kMostQueued = 64;  // beyond it, messages of topics are left out
constexpr std::size_t kMostQueuedBytes = std::size_t{512} << 20;  // beyond it, the reader is given up
constexpr auto kOvertaken = std::chrono::milliseconds(150);
constexpr auto kLongestThrottle = std::chrono::hours(1);

bool holds(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Absent, or a whole number that is not negative.
bool isCount(const Value& message, std::string_view name) {
  if (!message.has(name) || message[name].isNull()) return true;
  const std::int64_t* number = message[name].as<std::int64_t>();
  return number != nullptr && *number >= 0;
}

bool isTextIfThere(const Value& message, std::string_view name) {
  return !message.has(name) || message[name].isNull() || message[name].as<std::string>() != nullptr;
}

bool isWholeAuth(const Value& message) {
  for (const char* name : {"mac", "client", "dest", "rand", "level"}) {
    if (message[name].as<std::string>() == nullptr) return false;
  }
  return message["t"].isNumber() && message["end"].isNumber();
}

std::string idText(const Value& id) {
  return id.as<std::int64_t>() != nullptr ? std::to_string(*id.as<std::int64_t>()) : id.text();
}

}  // namespace

RosSession::RosSession(Connection& connection, RosServer& server)
    : WebSocketLink(connection, kMostMessageBytes, kMostQueuedBytes), server_(server) {
  if (server_.options().ros.status) status_level_ = "error";
}

bool RosSession::opened() {
  server_.links().join(self());
  return true;
}

void RosSession::take(const std::string& text, bool) { understand(text); }

void RosSession::gone() { server_.links().leave(this); }

void RosSession::understand(std::string_view text, bool joined) {
  const std::optional<Value> message = fromJson(text);
  if (!message || (*message)["op"].text().empty()) {
    if (server_.options().ros.needs_auth && !authenticated_) return cut();
    return complain("Received a message without an op, or no JSON", {});
  }
  const std::string& op = (*message)["op"].text();
  const Value& id = (*message)["id"];
  if (op == "auth") {
    authenticated_ = isWholeAuth(*message);
    if (!authenticated_ && server_.options().ros.needs_auth) cut();
    return;
  }
  if (server_.options().ros.needs_auth && !authenticated_) return cut();
  // Whoever asks for fragments gets them for as long as he is connected.
  if (const std::int64_t* size = (*message)["fragment_size"].as<std::int64_t>(); size != nullptr && *size > 0)
    fragment_size_ = static_cast<std::size_t>(*size);
  if (op == "fragment" && !joined) {
    std::string complaint;
    const std::optional<std::string> whole = shelf_.take(*message, complaint);
    if (!complaint.empty()) return complain(complaint, id);
    if (whole) understand(*whole, true);
    return;
  }
  if (op == "call_service") return call(*message);
  if (op == "subscribe") return subscribe(*message);
  if (op == "unsubscribe") return unsubscribe(*message);
  if (op == "publish") return publish(*message);
  if (op == "set_level") {
    status_level_ = (*message)["level"].text() == "none" ? std::string() : (*message)["level"].text();
    return;
  }
  if (op == "advertise") {
    const std::string &topic = (*message)["topic"].text(), &type = (*message)["type"].text();
    if (topic.empty() || type.empty()) return complain("advertise needs a topic and a type", id);
    server_.advertise(topic, type);
    return;
  }
  if (op == "unadvertise") return;  // what others hear of the topic stays the same
  complain("Unknown operation: " + op, id);
}

void RosSession::subscribe(const Value& message) {
  const Value& id = message["id"];
  const std::string& topic = message["topic"].text();
  server_.note("SUBSCRIBE", topic, 200, 0);
  if (topic.empty() || !isTextIfThere(message, "type") || !isTextIfThere(message, "compression") ||
      !isCount(message, "throttle_rate") || !isCount(message, "queue_length") ||
      !isCount(message, "fragment_size"))
    return complain("A field of subscribe is missing or of another type", id);
  Subscription wanted;
  wanted.type = message["type"].text();
  const auto throttle_ms = static_cast<std::int64_t>(message["throttle_rate"].number());
  wanted.throttle = std::min<std::chrono::milliseconds>(
      std::chrono::milliseconds(std::min<std::int64_t>(throttle_ms, 1'000'000'000)), kLongestThrottle);
  wanted.queue_length = static_cast<std::size_t>(std::min(message["queue_length"].number(), 1e6));
  const std::string& compression = message["compression"].text();
  wanted.compression = compression == "png"    ? Compression::Png
                       : compression == "cbor" ? Compression::Cbor
                                               : Compression::None;
  if (!server_.mayDeliver(topic, wanted.type))
    return complain("Unable to subscribe to " + topic + " as " + wanted.type, id);
  if (!subscriptions_.add(topic, idText(id), std::move(wanted)))
    return complain("Too many subscriptions", id);
  server_.deliverLatched(self(), topic);
}

void RosSession::unsubscribe(const Value& message) {
  const std::string& topic = message["topic"].text();
  server_.note("UNSUBSCRIBE", topic, 200, 0);
  subscriptions_.remove(topic, message.has("id") ? std::optional(idText(message["id"])) : std::nullopt);
}

void RosSession::publish(const Value& message) {
  const std::string& topic = message["topic"].text();
  server_.note("PUBLISH", topic, 200, 0);
  if (topic.empty() || message["msg"].as<Value::Object>() == nullptr)
    return complain("publish needs a topic and a msg", message["id"]);
  if (const std::string problem = server_.publishFrom(topic, message["msg"]); !problem.empty())
    complain(problem, message["id"]);
}

void RosSession::call(const Value& message) {
  const std::string& service = message["service"].text();
  const Value& id = message["id"];
  if (service.empty()) return complain("call_service needs a service", id);
  const RosFaults faults = server_.faults();
  ++calls_;
  if (holds(faults.refuse, service)) {
    server_.note("CALL", service, 503, 0);
    return answer(service, id, false,
                  "service [" + service + "] responded with an error: b'refused on request'");
  }
  CallOutcome outcome = server_.call(service, message["args"]);
  if (holds(faults.lose_answer, service) || holds(faults.cut_after, service)) {
    server_.note("CALL", service, 0, 0);
    server_.publishChanges();
    if (holds(faults.cut_after, service)) cut();
    return;
  }
  server_.note("CALL", service, outcome.worked ? 200 : 400, 0);
  // The topics of a change come before its answer, or after it.
  if (calls_ % 2 == 0) server_.publishChanges();
  answer(service, id, outcome.worked, std::move(outcome.values));
  server_.publishChanges();
}

void RosSession::answer(const std::string& service, const Value& id, bool worked, Value values) {
  Value message = Value::Object{{"op", "service_response"}};
  if (!id.isNull()) message.set("id", id);
  message.set("service", service);
  message.set("values", std::move(values));
  message.set("result", worked);
  const RosFaults faults = server_.faults();
  std::chrono::milliseconds delay(std::clamp(faults.slow_ms, 0, 600'000));
  if (faults.shuffled_answers && calls_ % 2 == 1) delay += kOvertaken;
  std::string text = toJson(message, server_.options().ros.writer);
  if (delay.count() == 0) return sendText(std::move(text), id);
  sendLater(std::move(text), id, delay);
}

void RosSession::sendLater(std::string text, const Value& id, std::chrono::milliseconds delay) {
  server_.loop().postAt(std::chrono::steady_clock::now() + delay,
                        [self = self(), text = std::move(text), id] { self->sendText(text, id); });
}

void RosSession::complain(std::string_view sentence, const Value& id) {
  if (status_level_.empty()) return;
  Value message = Value::Object{{"op", "status"}, {"level", "error"}, {"msg", sentence}};
  if (!id.isNull()) message.set("id", id);
  sendText(toJson(message, server_.options().ros.writer), id);
}

void RosSession::deliver(const PublicationPtr& message, bool at_once) {
  if (!isOpen() || !wants(message->topic())) return;
  if (at_once || subscriptions_.take(message, std::chrono::steady_clock::now())) encode(*message);
}

void RosSession::tick(Subscriptions::Time now) {
  for (const PublicationPtr& message : subscriptions_.due(now)) encode(*message);
}

void RosSession::encode(const Publication& message) {
  const std::optional<Subscription> wanted = subscriptions_.of(message.topic());
  if (!wanted || queued() > kMostQueued) return;
  switch (wanted->compression) {
    case Compression::None:
      return sendText(message.json(), 0);
    case Compression::Png:
      return sendText(message.png(), 0);
    case Compression::Cbor:
      if (message.cbor()) send({std::make_shared<const std::string>(*message.cbor()), true});
  }
}

void RosSession::sendText(std::string text, const Value& id) {
  const int forced = server_.faults().fragment_bytes;
  const std::size_t size = forced > 0 ? static_cast<std::size_t>(forced) : fragment_size_;
  for (std::string& piece : fragmentsOf(std::move(text), size, id, server_.options().ros.writer))
    send(textFrame(std::move(piece)));
}

}  // namespace mapwright::simulator::ros
