#include "simulator/server.h"

#include <future>

#include <boost/asio/post.hpp>

#include "simulator/http_session.h"

namespace mapwright::simulator {
namespace {

using boost::asio::ip::tcp;
using std::chrono::steady_clock;

constexpr auto kTick = std::chrono::milliseconds(50);  // or less, when a topic comes more often
constexpr auto kListAtMost = std::chrono::seconds(1);

}  // namespace

Server::Server(const Options& options, RobotState& state, MapLibrary& library, MappingBook& mappings,
               FaultPlan& faults, RequestLog& log)
    : options_(options),
      state_(state),
      library_(library),
      faults_(faults),
      log_(log),
      routes_(state, library, mappings, faults, options),
      aimdk_routes_(library, faults),
      messages_(state, library, faults, options) {}

Server::~Server() {
  io_.stop();
  if (thread_.joinable()) thread_.join();
  workers_.stop();
  workers_.join();
  hub_.drop();  // sessions must go before the io_context
}

std::optional<std::string> Server::open(Door& door, std::uint16_t port) {
  boost::system::error_code error;
  const tcp::endpoint endpoint(boost::asio::ip::address_v4::loopback(), port);
  door.acceptor.open(endpoint.protocol(), error);
  if (!error) door.acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) door.acceptor.bind(endpoint, error);
  if (!error) door.acceptor.listen(boost::asio::socket_base::max_listen_connections, error);
  if (!error) door.port = door.acceptor.local_endpoint(error).port();
  if (!error) return std::nullopt;
  return "The simulated robot could not open port " + std::to_string(port) +
         " on 127.0.0.1: " + error.message() + ". Choose another port, or 0 for a free one.";
}

std::optional<std::string> Server::start(std::uint16_t port, std::uint16_t aimdk_port) {
  if (std::optional<std::string> failure = open(axbot_, port)) return failure;
  if (std::optional<std::string> failure = open(aimdk_, aimdk_port)) return failure;
  published_ = state_.stamp();
  published_maps_ = library_.edits();
  published_mapping_ = state_.mapping().has_value();
  list_at_ = tick_at_ = dropped_at_ = restarted_at_ = steady_clock::now();
  periodic_ = periodicTopics(options_, tick_at_);
  accept(axbot_);
  accept(aimdk_);
  tick();
  thread_ = std::thread([this] { io_.run(); });
  return std::nullopt;
}

void Server::accept(Door& door) {
  door.acceptor.async_accept([this, &door](boost::system::error_code error, tcp::socket socket) {
    if (error == boost::asio::error::operation_aborted) return;
    if (!error) {
      socket.set_option(tcp::no_delay(true), error);
      const Services services{options_, state_, faults_, log_, door.routes, messages_, hub_, workers_};
      std::make_shared<HttpSession>(std::move(socket), services)->read();
    }
    accept(door);
  });
}

void Server::tick() {
  steady_clock::duration step = kTick;
  for (const PeriodicTopic& topic : periodic_) step = std::min(step, topic.period);
  tick_at_ = std::max(tick_at_ + step, steady_clock::now());  // keeps the rate, and never runs after it
  timer_.expires_at(tick_at_);
  timer_.async_wait([this](boost::system::error_code error) {
    if (error) return;
    const steady_clock::time_point now = steady_clock::now();
    keepFaultSchedule(now);
    publishChanges(now);
    tick();
  });
}

void Server::publishChanges(steady_clock::time_point now) {
  const bool mapping = state_.mapping().has_value();
  for (PeriodicTopic& topic : periodic_) {
    if (now < topic.due) continue;
    topic.due = std::max(topic.due + topic.period, now);
    if (mapping || !growsWhileMapping(topic.topic)) hub_.publish(topic.topic);
  }
  const MapEdits edits = library_.edits();
  if (edits.info != published_maps_.info) hub_.publish("/map/info");
  if (edits.pictures != published_maps_.pictures || mapping != published_mapping_) {
    for (const std::string_view topic : mapTopics()) hub_.publish(topic);
  }
  published_maps_ = edits;
  published_mapping_ = mapping;
  if (now - list_at_ < kListAtMost) return;
  ListStamp stamp = state_.stamp();
  if (stamp == published_) return;
  published_ = std::move(stamp);
  list_at_ = now;
  hub_.publish(kSubmapListTopic);
}

void Server::keepFaultSchedule(steady_clock::time_point now) {
  const Faults faults = faults_.faults();
  if (faults.websocket_drop_every_s > 0 &&
      now - dropped_at_ >= std::chrono::seconds(faults.websocket_drop_every_s)) {
    dropped_at_ = now;
    hub_.drop();
  }
  if (faults.uuid_change_every_s > 0 &&
      now - restarted_at_ >= std::chrono::seconds(faults.uuid_change_every_s)) {
    restarted_at_ = now;
    state_.restartSlam();
    hub_.publish(kSubmapListTopic);
  }
}

void Server::publishList() {
  boost::asio::post(io_, [this] {
    published_ = state_.stamp();
    list_at_ = steady_clock::now();
    hub_.publish(kSubmapListTopic);
  });
}

void Server::dropWebSockets() {
  auto cut = std::make_shared<std::promise<void>>();
  const std::future<void> done = cut->get_future();
  boost::asio::post(io_, [this, cut] {
    hub_.drop();
    cut->set_value();
  });
  done.wait();
}

}  // namespace mapwright::simulator
