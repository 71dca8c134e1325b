#include "simulator/ros/ros_server.h"

#include <algorithm>
#include <future>

namespace mapwright::simulator::ros {
namespace {

using std::chrono::steady_clock;

constexpr auto kRosTick = std::chrono::milliseconds(20);
constexpr auto kIdleTick = std::chrono::milliseconds(100);
constexpr auto kGarbageEvery = std::chrono::milliseconds(250);
constexpr std::size_t kMostAdvertised = 1000;

/// The `number`th of a repeating sequence of frames that are not valid messages.
Frame garbageFrame(std::size_t number) {
  static const std::string texts[] = {
      "this is no JSON",
      R"({"op":"publish","topic":"/map","msg":{"info":{"width":)",
      "",
      R"({"op":"no such op","id":7})",
      R"({"op":"publish","topic":"/map"})",
      R"({"op":"publish","topic":17,"msg":[]})",
      R"({"op":"service_response","id":"never asked","service":"/x","values":{},"result":true})",
      std::string(2000, '['),
      R"({"op":"fragment","id":0,"data":"{\"op\":","num":5,"total":2.5})",
      R"({"op":"png","data":"iVBORw0KGgo*** this is no base64 ***"})",
      "[1,2,3]",
      std::string("\xBF\x62op", 4),                                     // CBOR that ends too early
      std::string("\xD8\x48\x5B\x7F\xFF\xFF\xFF\xFF\xFF\xFF\xFF", 11),  // and one that lies
      R"({"op":"service_response","values":null})",
      R"({"op":"publish","topic":"/scan","msg":{"ranges":[NaN,Infinity],"header":null}})",
      ""};
  const std::size_t kind = number % std::size(texts);
  if (kind == 2) return {std::make_shared<const std::string>(garbage(number)), true};
  return {std::make_shared<const std::string>(texts[kind]), kind == 11 || kind == 12};
}

}  // namespace

RosServer::RosServer(const Options& options, const RobotState& robot, FaultPlan& faults, RequestLog& log,
                     KabamStore& kabam, MapPictures& pictures)
    : options_(options),
      plan_(faults),
      log_(log),
      kabam_(kabam),
      robot_(options, robot, faults, kabam, pictures) {}

RosServer::~RosServer() {
  stall(false);
  loop_.stop();
  links_.cut();  // sessions must go before the loop
}

std::optional<std::string> RosServer::start(std::uint16_t port) {
  const auto opened = loop_.listen(port, "The simulated ROS robot", [this](Connection& connection) {
    std::make_shared<RosSession>(connection, *this)->accept();
  });
  if (!opened) return opened.error();
  port_ = *opened;
  published_ = kabam_.edits();
  if (faults().waypoints_lag_ms > 0) {
    const std::string topic(kWaypointsTopic);
    if (auto message = publicationOf(topic)) last_[topic] = std::move(message);
  }
  tick_at_ = restarted_at_ = edited_at_ = painted_at_ = garbage_at_ = steady_clock::now();
  for (const TopicRow& row : robot_.topics()) {
    if (row.period_s > 0) periodic_.emplace_back(row.name, row.period_s, tick_at_);
  }
  tick();
  loop_.start();
  return std::nullopt;
}

void RosServer::logRequest(std::string_view method, std::string_view target, int status) {
  RequestRecord record;
  record.method = method;
  record.target = target;
  LoggedRequest(log_, std::move(record), false).finish(status, 0);
}

void RosServer::tick() {
  const steady_clock::duration step = links_.open() == 0 ? kIdleTick : kRosTick;
  tick_at_ = std::max(tick_at_ + step, steady_clock::now());
  loop_.postAt(tick_at_, [this] {
    const steady_clock::time_point now = steady_clock::now();
    keepFaultSchedule(now);
    publishChanges();
    const bool maps = kabam_.state() == ManagerState::Mapping;
    for (Periodic& topic : periodic_) {
      // A finished map is told once.
      if (topic.comes(now) && (topic.name != "/map" || maps)) publish(topic.name);
    }
    publishLate(now);
    for (const auto& session : links_.all()) session->tick(now);
    tick();
  });
}

void RosServer::keepFaultSchedule(steady_clock::time_point now) {
  const RosFaults faults = this->faults();
  if (isTime(faults.restart_every_s, restarted_at_, now)) {
    links_.cut();
    last_.clear();
  }
  if (isTime(faults.other_operator_every_s, edited_at_, now)) kabam_.otherOperator();
  if (isTime(faults.other_painter_every_s, painted_at_, now)) kabam_.otherPainter();
  if (faults.garbage && now - garbage_at_ >= kGarbageEvery) {
    garbage_at_ = now;
    const Frame frame = garbageFrame(garbage_++);
    for (const auto& session : links_.all()) session->send(frame);
  }
}

void RosServer::publishChanges() {
  const Dispatcher::Edits dispatcher = robot_.dispatcherEdits();
  const Dispatcher::Edits dispatched = std::exchange(dispatched_, dispatcher);
  if (dispatcher.map != dispatched.map) publish("/map_metadata");
  if (dispatcher.projections != dispatched.projections) {
    for (const std::string_view name : Dispatcher::projectedTopics()) publish(name);
  }
  const KabamEdits edits = kabam_.edits();
  const KabamEdits before = std::exchange(published_, edits);
  if (edits == before) return;
  if (edits.lists != before.lists) {
    publish(kMapListTopic);
    publish(kArchivedListTopic);
  }
  if (edits.info != before.info) publish(kMapInfoTopic);
  if (edits.waypoints != before.waypoints) publishWaypoints();
  if (edits.picture != before.picture) {
    publish("/map");
    publish("/global_costmap/costmap");
  }
}

void RosServer::publishWaypoints() {
  const std::chrono::milliseconds lag(faults().waypoints_lag_ms);
  if (lag.count() == 0) return publish(kWaypointsTopic);
  late_.push_back({steady_clock::now() + lag, publicationOf(std::string(kWaypointsTopic))});
}

void RosServer::publishLate(steady_clock::time_point now) {
  while (!late_.empty() && late_.front().first <= now) {
    const PublicationPtr message = std::move(late_.front().second);
    late_.pop_front();
    if (!message) continue;
    last_[message->topic()] = message;
    if (!plan_.isSilent(message->topic())) deliverAll(message);
  }
}

bool RosServer::mayDeliver(std::string_view topic, std::string_view type) const {
  const RosDialect dialect = options_.ros.dialect;
  if (const TopicRow* const row = robot_.topic(topic)) {
    const std::string_view plain = robot_.typeOf(*row);  // ROS 1 does not know another name
    return type.empty() || type == plain || type == typeName(plain, "msg", dialect);
  }
  if (const auto found = advertised_.find(topic); found != advertised_.end())
    return type.empty() || type == found->second;
  // What does not exist yet comes to be with the type that is named here, if that is one.
  const auto parts = 1 + std::count(type.begin(), type.end(), '/');
  return parts == 2 || (parts == 3 && dialect == RosDialect::Ros2);
}

void RosServer::deliverLatched(const std::shared_ptr<RosSession>& session, const std::string& topic) {
  const TopicRow* row = robot_.topic(topic);
  if (row == nullptr || !row->latched || plan_.isSilent(topic)) return;
  if (const auto found = last_.find(topic); found != last_.end())
    return session->deliver(found->second, true);
  make(topic, session, false);
}

void RosServer::publish(std::string_view topic) {
  const std::vector<std::shared_ptr<RosSession>> sessions = links_.all();
  const bool wanted = std::any_of(sessions.begin(), sessions.end(),
                                  [&](const auto& session) { return session->wants(topic); });
  if (const auto kept = last_.find(topic); kept != last_.end()) last_.erase(kept);
  if (wanted && !plan_.isSilent(topic)) make(std::string(topic), {}, true);
}

PublicationPtr RosServer::publicationOf(const std::string& topic) {
  Value msg = robot_.messageOf(topic);
  if (msg.isNull()) return nullptr;
  return std::make_shared<const Publication>(topic, std::move(msg), options_.ros.writer);
}

void RosServer::make(const std::string& topic, std::weak_ptr<RosSession> only_for, bool for_all) {
  const TopicRow* row = robot_.topic(topic);
  const bool latched = row != nullptr && row->latched;
  const auto done = [this, topic, latched, only_for, for_all](const PublicationPtr& message) {
    if (!message) return;
    if (latched) last_[topic] = message;
    if (for_all) return deliverAll(message);
    if (const std::shared_ptr<RosSession> session = only_for.lock()) session->deliver(message, true);
  };
  if (row == nullptr || !row->slow) return done(publicationOf(topic));
  if (for_all) {
    const auto [entry, is_new] = making_.try_emplace(topic, false);
    if (!is_new) {
      entry->second = true;
      return;
    }
  }
  loop_.work([this, topic, for_all, done] {
    PublicationPtr message = publicationOf(topic);
    loop_.post([this, topic, for_all, done, message = std::move(message)] {
      const bool again = for_all && making_.extract(topic).mapped();
      done(message);
      if (again) publish(topic);
    });
  });
}

void RosServer::deliverAll(const PublicationPtr& message) {
  for (const auto& session : links_.all()) session->deliver(message, false);
}

void RosServer::advertise(const std::string& topic, const std::string& type) {
  if (advertised_.size() < kMostAdvertised && robot_.topic(topic) == nullptr)
    advertised_.emplace(topic, type);
}

std::string RosServer::publishFrom(const std::string& topic, const Value& msg) {
  const TopicRow* row = robot_.topic(topic);
  const auto advertised = advertised_.find(topic);
  if (row == nullptr && advertised == advertised_.end()) return "Topic " + topic + " was not advertised";
  std::string type = row != nullptr ? std::string(row->type) : advertised->second;
  if (const std::size_t middle = type.find("/msg/"); middle != std::string::npos) type.erase(middle, 4);
  Answer whole = robot_.types().knows(type) ? robot_.types().complete(type, msg) : Answer(msg);
  if (!whole) return whole.error();
  if (!plan_.isSilent(topic))
    deliverAll(std::make_shared<const Publication>(topic, std::move(*whole), options_.ros.writer));
  return {};
}

void RosServer::runAndWait(const std::function<void()>& action) {
  if (stalled_) return loop_.post(action);
  loop_.postAndWait(action);
}

void RosServer::stall(bool on) {
  if (!loop_.isStarted() || stalled_ == on) return;
  if (on) {
    const auto standing = std::make_shared<std::promise<void>>();
    loop_.post([this, standing] {
      stalled_ = true;
      standing->set_value();
      stalled_.wait(true);
    });
    return standing->get_future().wait();
  }
  stalled_ = false;
  stalled_.notify_all();
  runAndWait([] {});  // it stands no more
}

void RosServer::dropLinks() {
  runAndWait([this] { links_.cut(); });
}

void RosServer::refresh() {
  runAndWait([this] {
    for (const TopicRow& row : robot_.topics()) publish(row.name);
  });
}

void RosServer::otherOperator() {
  runAndWait([this] {
    kabam_.otherOperator();
    publishChanges();
  });
}

void RosServer::otherPainter() {
  runAndWait([this] {
    kabam_.otherPainter();
    publishChanges();
  });
}

}  // namespace mapwright::simulator::ros
