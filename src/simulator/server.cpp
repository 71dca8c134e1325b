#include "simulator/server.h"

#include <future>

#include <boost/asio/post.hpp>

#include "simulator/http_session.h"

namespace mapwright::simulator {
namespace {

using boost::asio::ip::tcp;
using std::chrono::steady_clock;

constexpr auto kTick = std::chrono::milliseconds(50);
constexpr auto kListAtMost = std::chrono::seconds(1);
constexpr auto kSlamStateEvery = std::chrono::seconds(1);

}  // namespace

Server::Server(const Options& options, RobotState& state, FaultPlan& faults, RequestLog& log)
    : options_(options),
      state_(state),
      faults_(faults),
      log_(log),
      routes_(state, faults, options),
      messages_(state) {}

Server::~Server() {
  io_.stop();
  if (thread_.joinable()) thread_.join();
  hub_.drop();  // sessions must go before the io_context
}

std::optional<std::string> Server::start(std::uint16_t port) {
  boost::system::error_code error;
  const tcp::endpoint endpoint(boost::asio::ip::address_v4::loopback(), port);
  acceptor_.open(endpoint.protocol(), error);
  if (!error) acceptor_.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor_.bind(endpoint, error);
  if (!error) acceptor_.listen(boost::asio::socket_base::max_listen_connections, error);
  if (!error) port_ = acceptor_.local_endpoint(error).port();
  if (error) {
    return "The simulated robot could not open port " + std::to_string(port) +
           " on 127.0.0.1: " + error.message() + ". Choose another port, or 0 for a free one.";
  }
  published_ = state_.stamp();
  list_at_ = state_at_ = dropped_at_ = restarted_at_ = steady_clock::now();
  accept();
  tick();
  thread_ = std::thread([this] { io_.run(); });
  return std::nullopt;
}

void Server::accept() {
  acceptor_.async_accept([this](boost::system::error_code error, tcp::socket socket) {
    if (error == boost::asio::error::operation_aborted) return;
    if (!error) {
      socket.set_option(tcp::no_delay(true), error);
      const Services services{options_, state_, faults_, log_, routes_, messages_, hub_};
      std::make_shared<HttpSession>(std::move(socket), services)->read();
    }
    accept();
  });
}

void Server::tick() {
  timer_.expires_after(kTick);
  timer_.async_wait([this](boost::system::error_code error) {
    if (error) return;
    const steady_clock::time_point now = steady_clock::now();
    keepFaultSchedule(now);
    publishChanges(now);
    tick();
  });
}

void Server::publishChanges(steady_clock::time_point now) {
  hub_.publish(kTrackedPoseTopic);
  if (now - state_at_ >= kSlamStateEvery) {
    state_at_ = now;
    hub_.publish(kSlamStateTopic);
  }
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
