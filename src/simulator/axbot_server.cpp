#include "simulator/axbot_server.h"

#include <algorithm>
#include <map>
#include <set>

namespace mapwright::simulator {
namespace {

using std::chrono::steady_clock;

constexpr auto kTick = std::chrono::milliseconds(50);  // or less, when a topic comes more often
constexpr auto kListAtMost = std::chrono::seconds(1);
constexpr std::size_t kMostTopicsAtOnce = 256;
constexpr std::size_t kLongestTopic = 255;
constexpr std::size_t kMostMessageBytes = 64 << 10;
constexpr std::size_t kMostTopics = 256;
constexpr std::size_t kMostQueued = 32;                           // beyond it, what comes again is left out
constexpr std::size_t kMostQueuedBytes = std::size_t{256} << 20;  // beyond it, the reader is given up

/// Appends the topics that a value names; a sentence when it cannot be used.
std::string appendTopics(const Value& value, bool lists_allowed, std::vector<std::string>& topics) {
  const auto* list = value.as<Value::List>();
  if (list == nullptr && value.as<std::string>() == nullptr) return "A topic is a text or a list of texts.";
  if (list != nullptr && !lists_allowed)
    return "A list of topics is not supported by this robot; enable them one by one.";
  for (const Value& one : list != nullptr ? *list : Value::List{value}) {
    if (one.as<std::string>() == nullptr || topics.size() >= kMostTopicsAtOnce)
      return "A list of topics holds something that is no topic.";
    if (one.text().empty() || one.text().size() > kLongestTopic)
      return "A topic's name is empty or too long.";
    topics.push_back(one.text());
  }
  return {};
}

/// Reads {"enable_topic": ..., "disable_topic": ...}; a sentence when nothing is to be done.
std::string readTopics(std::string_view text, bool lists_allowed, std::vector<std::string>& enable,
                       std::vector<std::string>& disable) {
  const Value message = fromJson(text).value_or(Value());
  if (message.as<Value::Object>() == nullptr) return "The message is no JSON object.";
  if (!message.has("enable_topic") && !message.has("disable_topic"))
    return "The message names neither enable_topic nor disable_topic.";
  std::string problem;
  if (message.has("enable_topic")) problem = appendTopics(message["enable_topic"], lists_allowed, enable);
  if (problem.empty() && message.has("disable_topic"))
    problem = appendTopics(message["disable_topic"], lists_allowed, disable);
  return problem;
}

Frame errorFrame(std::string_view sentence) { return textFrame(toJson(Value::Object{{"error", sentence}})); }

}  // namespace

/// One client of /ws/v2/topics.
class TopicSession : public WebSocketLink {
 public:
  /// `target`: what the handshake asks for.
  TopicSession(Connection& connection, AxbotServer& server, std::string_view target)
      : WebSocketLink(connection, kMostMessageBytes, kMostQueuedBytes),
        server_(server),
        binary_(server.robot().options.binary_topics && queryValue(target, "pb") == "1"),
        silent_(server.robot().faults.faults().silent_websocket) {}

  /// The topic's current message, when it is enabled here.
  void publish(std::string_view topic) {
    if (!topics_.contains(topic)) return;
    const Faults faults = server_.robot().faults.faults();
    if (silent_ || faults.silent_websocket || server_.robot().faults.isSilent(topic)) return;
    const AxbotTopic* const own = axbotTopic(topic);
    const bool comes_often = own != nullptr && own->period_s != kWhenItChanges;
    if (comes_often && queued() > kMostQueued) return;
    if (own != nullptr && own->is(kSlow)) {
      make(std::string(topic));
      return;
    }
    if (std::optional<Frame> frame = server_.messages().messageOf(topic, binary_, faults.bad_entries)) {
      send(std::move(*frame));
    }
  }

 private:
  bool opened() override {
    server_.links().join(self());
    return !silent_;
  }

  void gone() override {
    server_.links().leave(this);
    topics_.clear();
  }

  void onMessage(const std::string& text, bool is_text) override {
    if (!is_text) return send(errorFrame("Binary messages are not understood."));
    std::vector<std::string> enable, disable;
    const bool lists_allowed = server_.robot().options.enable_topic_list;
    if (const std::string problem = readTopics(text, lists_allowed, enable, disable); !problem.empty())
      return send(errorFrame(problem));
    for (const std::string& topic : enable) {
      if (topics_.size() < kMostTopics) topics_.insert(topic);
    }
    for (const std::string& topic : disable) topics_.erase(topic);
    send(textFrame(toJson(Value::Object{{"enabled_topics", Value::List(topics_.begin(), topics_.end())}})));
    for (const std::string& topic : enable) {
      const AxbotTopic* const own = axbotTopic(topic);
      if (own != nullptr && own->is(kLatched)) publish(topic);
    }
  }

  void make(const std::string& topic) {
    const auto [entry, is_new] = making_.try_emplace(topic, false);
    if (!is_new) {
      entry->second = true;
      return;
    }
    server_.loop().work([self = self(), topic] {
      std::optional<Frame> frame = self->server_.messages().messageOf(topic, self->binary_, false);
      self->server_.loop().post([self, topic, frame = std::move(frame)]() mutable {
        const bool again = self->making_.extract(topic).mapped();
        if (frame && self->topics_.contains(topic)) self->send(std::move(*frame));
        if (again) self->publish(topic);
      });
    });
  }
  std::shared_ptr<TopicSession> self() { return std::static_pointer_cast<TopicSession>(shared_from_this()); }

  AxbotServer& server_;
  const bool binary_, silent_;
  std::set<std::string, std::less<>> topics_;
  std::map<std::string, bool> making_;  // topics that a worker has; true: publish once more when it is done
};

AxbotServer::AxbotServer(const Robot& robot, RequestLog& log)
    : robot_(robot),
      axbot_routes_(robot),
      aimdk_routes_(robot),
      messages_(robot.state, robot.library, robot.faults, robot.options),
      axbot_{axbot_routes_, log, loop_, {}},
      aimdk_{aimdk_routes_, log, loop_, {}} {
  axbot_.open_topics = [this](Connection& connection, std::string_view target) {
    return std::make_shared<TopicSession>(connection, *this, target);
  };
}

AxbotServer::~AxbotServer() {
  loop_.stop();
  links_.cut();  // sessions must go before the loop
}

std::optional<std::string> AxbotServer::open(HttpService& service, std::uint16_t port,
                                             std::uint16_t& opened) {
  const auto got = loop_.listen(port, "The simulated robot",
                                [&service](Connection& connection) { serveHttp(connection, service); });
  if (!got) return got.error();
  opened = *got;
  return std::nullopt;
}

void AxbotServer::publish(std::string_view topic) {
  for (const std::shared_ptr<TopicSession>& session : links_.all()) session->publish(topic);
}

std::optional<std::string> AxbotServer::start(std::uint16_t port, std::uint16_t aimdk_port) {
  if (std::optional<std::string> failure = open(axbot_, port, port_)) return failure;
  if (std::optional<std::string> failure = open(aimdk_, aimdk_port, aimdk_port_)) return failure;
  published_ = robot_.state.stamp();
  published_maps_ = robot_.library.edits();
  published_mapping_ = robot_.state.mapping().has_value();
  list_at_ = tick_at_ = dropped_at_ = restarted_at_ = steady_clock::now();
  for (const AxbotTopic& topic : axbotTopics()) {
    if (topic.period_s == kWhenItChanges) continue;
    const double period_s = topic.period_s == kAsPoses   ? 1 / robot_.options.pose_hz
                            : topic.period_s == kAsScans ? 1 / robot_.options.scan_hz
                                                         : topic.period_s;
    periodic_.emplace_back(topic.name, period_s, tick_at_);
    if (topic.period_s == kAsPoses) periodic_.back().due = tick_at_;
  }
  tick();
  loop_.start();
  return std::nullopt;
}

void AxbotServer::tick() {
  steady_clock::duration step = kTick;
  for (const Periodic& topic : periodic_) step = std::min(step, topic.period);
  tick_at_ = std::max(tick_at_ + step, steady_clock::now());  // keeps the rate, and never runs after it
  loop_.postAt(tick_at_, [this] {
    const steady_clock::time_point now = steady_clock::now();
    keepFaultSchedule(now);
    publishChanges(now);
    tick();
  });
}

void AxbotServer::publishChanges(steady_clock::time_point now) {
  const bool mapping = robot_.state.mapping().has_value();
  for (Periodic& topic : periodic_) {
    if (topic.comes(now) && (mapping || !axbotTopic(topic.name)->is(kGrows))) publish(topic.name);
  }
  const MapEdits edits = robot_.library.edits();
  if (edits.info != published_maps_.info) publish("/map/info");
  if (edits.pictures != published_maps_.pictures || mapping != published_mapping_) {
    for (const AxbotTopic& topic : axbotTopics()) {
      if (topic.is(kOfMap)) publish(topic.name);
    }
  }
  published_maps_ = edits;
  published_mapping_ = mapping;
  if (now - list_at_ < kListAtMost) return;
  ListStamp stamp = robot_.state.stamp();
  if (stamp == published_) return;
  published_ = std::move(stamp);
  list_at_ = now;
  publish(kSubmapListTopic);
}

void AxbotServer::keepFaultSchedule(steady_clock::time_point now) {
  const Faults faults = robot_.faults.faults();
  if (isTime(faults.websocket_drop_every_s, dropped_at_, now)) links_.cut();
  if (isTime(faults.uuid_change_every_s, restarted_at_, now)) {
    robot_.state.restartSlam();
    publish(kSubmapListTopic);
  }
  if (isTime(faults.overlay_edit_every_s, overlays_edited_at_, now)) {
    if (const auto map = robot_.library.current()) robot_.library.editOverlays(map->id);
  }
}

void AxbotServer::publishList() {
  loop_.post([this] {
    published_ = robot_.state.stamp();
    list_at_ = steady_clock::now();
    publish(kSubmapListTopic);
  });
}

void AxbotServer::dropWebSockets() {
  loop_.postAndWait([this] { links_.cut(); });
}

}  // namespace mapwright::simulator
