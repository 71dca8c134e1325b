#include "simulator/ros/ros_session.h"

#include <algorithm>
#include <cmath>

#include "simulator/pictures.h"
#include "simulator/ros/ros_server.h"

namespace mapwright::simulator::ros {
namespace {

constexpr std::size_t kMostMessageBytes = std::size_t{128} << 20;  // a map's picture as base64
constexpr std::size_t kMostQueued = 64;  // beyond it, messages of topics are left out
constexpr std::size_t kMostQueuedBytes = std::size_t{512} << 20;  // beyond it, the reader is given up
constexpr auto kOvertaken = std::chrono::milliseconds(150);
constexpr auto kLongestThrottle = std::chrono::hours(1);
constexpr std::size_t kMostSubscriptions = 1000, kMostOfOne = 100, kLongestQueue = 1000;
constexpr std::int64_t kMostPieces = 1'000'000;
constexpr std::size_t kMostJoinedBytes = std::size_t{512} << 20, kMostJoined = 16;

/// Absent, or a whole number that is not negative.
bool isCount(const Value& message, std::string_view name) {
  if (message[name].isNull()) return true;
  const std::int64_t* number = message[name].as<std::int64_t>();
  return number != nullptr && *number >= 0;
}

bool isTextIfThere(const Value& message, std::string_view name) {
  return message[name].isNull() || message[name].as<std::string>() != nullptr;
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

bool beginsCharacter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0) != 0x80; }

/// Splits long texts like rosbridge servers do. The text itself if it has at most `size` characters or `size`
/// is 0; otherwise {"op":"fragment"} messages of `size` characters each. Their id is that of the message, 0
/// if it has none; their total is a fraction.
std::vector<std::string> fragmentsOf(std::string text, std::size_t size, const Value& id, RosWriter writer) {
  std::vector<std::size_t> begins;
  std::size_t characters = 0;
  for (std::size_t at = 0; size > 0 && text.size() > size && at < text.size(); ++at) {
    if (beginsCharacter(text[at]) && characters++ % size == 0) begins.push_back(at);
  }
  if (begins.size() < 2) return {std::move(text)};
  const double total = static_cast<double>(characters - 1) / static_cast<double>(size) + 1;
  std::vector<std::string> pieces;
  for (std::size_t number = 0; number < begins.size(); ++number) {
    const std::size_t end = number + 1 < begins.size() ? begins[number + 1] : text.size();
    pieces.push_back(toJson(Value::Object{{"op", "fragment"},
                                          {"id", id.isNull() ? Value(0) : id},
                                          {"data", text.substr(begins[number], end - begins[number])},
                                          {"num", number},
                                          {"total", total}},
                            writer));
  }
  return pieces;
}

}  // namespace

Publication::Publication(std::string topic, Value msg, RosWriter writer)
    : topic_(std::move(topic)),
      message_(Value::Object{{"op", "publish"}, {"topic", topic_}, {"msg", std::move(msg)}}),
      writer_(writer) {}

const std::string& Publication::json() const {
  if (json_.empty()) json_ = toJson(message_, writer_);
  return json_;
}

const std::string& Publication::png() const {
  if (!png_.empty()) return png_;
  const double pixels = static_cast<double>(json().size()) / 3;
  const auto width = std::max(1, static_cast<int>(std::sqrt(pixels)));
  const auto height = std::max(1, static_cast<int>(std::ceil(pixels / width)));
  std::string padded = json();
  padded.resize(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), '\n');
  png_ = R"({"op":"png","data":")" + base64(writeRgbPng(width, height, padded)) + "\"}";
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
  return found == topics_.end() ? std::nullopt : std::optional(merged(found->second));
}

bool Subscriptions::admit(const PublicationPtr& message, Time now) {
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

RosSession::RosSession(Connection& connection, RosServer& server)
    : WebSocketLink(connection, kMostMessageBytes, kMostQueuedBytes), server_(server) {
  if (server_.options().ros.status) status_level_ = "error";
}

bool RosSession::opened() {
  server_.links().join(self());
  return true;
}

void RosSession::onMessage(const std::string& text, bool) { understand(text); }

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
  if (op == "fragment" && !joined) return join(*message);
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
    return server_.advertise(topic, type);
  }
  if (op == "unadvertise") return;  // what others hear of the topic stays the same
  complain("Unknown operation: " + op, id);
}

void RosSession::join(const Value& piece) {
  const std::int64_t* const number = piece["num"].as<std::int64_t>();
  const std::int64_t* const total = piece["total"].as<std::int64_t>();
  const std::string* const data = piece["data"].as<std::string>();
  const std::string name = idText(piece["id"]);
  if (number == nullptr || total == nullptr || data == nullptr || name.empty() || *total < 1 ||
      *total > kMostPieces || *number < 0 || *number >= *total)
    return complain("A field of fragment is missing or of another type", piece["id"]);
  if (fragments_.count(name) == 0 && fragments_.size() >= kMostJoined) fragments_.erase(fragments_.begin());
  Fragments& message = fragments_[name];
  if (message.total == 0) message.total = static_cast<std::size_t>(*total);
  message.bytes += data->size();
  if (message.total != static_cast<std::size_t>(*total) || message.bytes > kMostJoinedBytes) {
    fragments_.erase(name);
    return complain("The pieces of a message do not fit together", piece["id"]);
  }
  message.pieces[static_cast<std::size_t>(*number)] = *data;
  if (message.pieces.size() < message.total) return;
  std::string whole;
  whole.reserve(message.bytes);
  for (const auto& [at, text] : message.pieces) whole += text;
  fragments_.erase(name);
  understand(whole, true);
}

void RosSession::subscribe(const Value& message) {
  const Value& id = message["id"];
  const std::string& topic = message["topic"].text();
  server_.logRequest("SUBSCRIBE", topic, 200);
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
  server_.logRequest("UNSUBSCRIBE", topic, 200);
  subscriptions_.remove(topic, message.has("id") ? std::optional(idText(message["id"])) : std::nullopt);
}

void RosSession::publish(const Value& message) {
  const std::string& topic = message["topic"].text();
  server_.logRequest("PUBLISH", topic, 200);
  if (topic.empty() || message["msg"].as<Value::Object>() == nullptr)
    return complain("publish needs a topic and a msg", message["id"]);
  if (const std::string problem = server_.publishFrom(topic, message["msg"]); !problem.empty())
    complain(problem, message["id"]);
}

void RosSession::call(const Value& message) {
  const std::string& service = message["service"].text();
  const Value& id = message["id"];
  if (service.empty()) return complain("call_service needs a service", id);
  const Verdict verdict = server_.plan().decide(server_.robot().kindsOf(service), "CALL", service);
  ++calls_;
  if (verdict.is(FaultKind::Refuse) && verdict.number == 0) {
    server_.logRequest("CALL", service, 503);
    return answer(service, id, false,
                  "service [" + service + "] responded with an error: b'refused on request'",
                  verdict.delay_ms);
  }
  const Answer outcome = verdict.is(FaultKind::Refuse) ? Value::Object{{"result", verdict.number}}
                         : verdict.is(FaultKind::Drop)
                             ? Answer()
                             : server_.robot().call(service, message["args"], verdict);
  if (!verdict.isAnswered()) {
    server_.logRequest("CALL", service, 0);
    server_.publishChanges();
    if (!verdict.is(FaultKind::Silence)) cut();
    return;
  }
  server_.logRequest("CALL", service, outcome ? 200 : 400);
  // The topics of a change come before its answer, or after it.
  if (calls_ % 2 == 0) server_.publishChanges();
  answer(service, id, outcome.has_value(), outcome ? *outcome : Value(outcome.error()), verdict.delay_ms);
  server_.publishChanges();
}

void RosSession::answer(const std::string& service, const Value& id, bool worked, Value values,
                        int delay_ms) {
  Value message = Value::Object{{"op", "service_response"}};
  if (!id.isNull()) message.set("id", id);
  message.set("service", service);
  message.set("values", std::move(values));
  message.set("result", worked);
  std::chrono::milliseconds delay(delay_ms);
  if (server_.faults().shuffled_answers && calls_ % 2 == 1) delay += kOvertaken;
  std::string text = toJson(message, server_.options().ros.writer);
  if (delay.count() == 0) return sendText(std::move(text), id);
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
  if (at_once || subscriptions_.admit(message, std::chrono::steady_clock::now())) encode(*message);
}

void RosSession::tick(Subscriptions::Time now) {
  for (const PublicationPtr& message : subscriptions_.due(now)) encode(*message);
}

void RosSession::encode(const Publication& message) {
  const std::optional<Subscription> wanted = subscriptions_.of(message.topic());
  if (!wanted || queued() > kMostQueued) return;
  if (wanted->compression != Compression::Cbor)
    return sendText(wanted->compression == Compression::Png ? message.png() : message.json(), 0);
  if (message.cbor()) send({std::make_shared<const std::string>(*message.cbor()), true});
}

void RosSession::sendText(std::string text, const Value& id) {
  const int forced = server_.faults().fragment_bytes;
  const std::size_t size = forced > 0 ? static_cast<std::size_t>(forced) : fragment_size_;
  for (std::string& piece : fragmentsOf(std::move(text), size, id, server_.options().ros.writer))
    send(textFrame(std::move(piece)));
}

}  // namespace mapwright::simulator::ros
