#include "simulator/server.h"

#include "simulator/http_session.h"
#include "simulator/web_socket_session.h"

namespace mapwright::simulator {
namespace {

using std::chrono::steady_clock;

constexpr auto kTick = std::chrono::milliseconds(50);  // or less, when a topic comes more often
constexpr auto kListAtMost = std::chrono::seconds(1);

}  // namespace

Server::Server(const Robot& robot, RequestLog& log)
    : robot_(robot),
      log_(log),
      routes_(robot),
      aimdk_routes_(robot),
      messages_(robot.state, robot.library, robot.faults, robot.options) {}

Server::~Server() {
  loop_.stop();
  links_.cut();  // sessions must go before the loop
}

std::optional<std::string> Server::open(Door& door, std::uint16_t port) {
  const Services services{robot_, log_, door.routes, messages_, links_, loop_};
  const auto opened = loop_.listen(port, "The simulated robot",
                                   [services](Connection& connection) { serveHttp(connection, services); });
  if (!opened) return opened.error();
  door.port = *opened;
  return std::nullopt;
}

void Server::publish(std::string_view topic) {
  for (const std::shared_ptr<WebSocketSession>& session : links_.all()) session->publish(topic);
}

std::optional<std::string> Server::start(std::uint16_t port, std::uint16_t aimdk_port) {
  if (std::optional<std::string> failure = open(axbot_, port)) return failure;
  if (std::optional<std::string> failure = open(aimdk_, aimdk_port)) return failure;
  published_ = robot_.state.stamp();
  published_maps_ = robot_.library.edits();
  published_mapping_ = robot_.state.mapping().has_value();
  list_at_ = tick_at_ = dropped_at_ = restarted_at_ = steady_clock::now();
  periodic_ = periodicTopics(robot_.options, tick_at_);
  tick();
  loop_.start();
  return std::nullopt;
}

void Server::tick() {
  steady_clock::duration step = kTick;
  for (const PeriodicTopic& topic : periodic_) step = std::min(step, topic.period);
  tick_at_ = std::max(tick_at_ + step, steady_clock::now());  // keeps the rate, and never runs after it
  loop_.postAt(tick_at_, [this] {
    const steady_clock::time_point now = steady_clock::now();
    keepFaultSchedule(now);
    publishChanges(now);
    tick();
  });
}

void Server::publishChanges(steady_clock::time_point now) {
  const bool mapping = robot_.state.mapping().has_value();
  for (PeriodicTopic& topic : periodic_) {
    if (now < topic.due) continue;
    topic.due = std::max(topic.due + topic.period, now);
    if (mapping || !growsWhileMapping(topic.topic)) publish(topic.topic);
  }
  const MapEdits edits = robot_.library.edits();
  if (edits.info != published_maps_.info) publish("/map/info");
  if (edits.pictures != published_maps_.pictures || mapping != published_mapping_) {
    for (const std::string_view topic : mapTopics()) publish(topic);
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

void Server::keepFaultSchedule(steady_clock::time_point now) {
  const Faults faults = robot_.faults.faults();
  if (faults.websocket_drop_every_s > 0 &&
      now - dropped_at_ >= std::chrono::seconds(faults.websocket_drop_every_s)) {
    dropped_at_ = now;
    links_.cut();
  }
  if (faults.uuid_change_every_s > 0 &&
      now - restarted_at_ >= std::chrono::seconds(faults.uuid_change_every_s)) {
    restarted_at_ = now;
    robot_.state.restartSlam();
    publish(kSubmapListTopic);
  }
}

void Server::publishList() {
  loop_.post([this] {
    published_ = robot_.state.stamp();
    list_at_ = steady_clock::now();
    publish(kSubmapListTopic);
  });
}

void Server::dropWebSockets() {
  loop_.postAndWait([this] { links_.cut(); });
}

}  // namespace mapwright::simulator
