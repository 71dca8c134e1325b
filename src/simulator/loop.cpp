#include "simulator/loop.h"

#include <future>
#include <list>
#include <thread>

#include <boost/asio/basic_socket_acceptor.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/thread_pool.hpp>

#include "simulator/boost_sockets.h"

namespace mapwright::simulator {

using boost::asio::ip::tcp;
using Acceptor = boost::asio::basic_socket_acceptor<tcp, Executor>;
using Take = std::function<void(Connection&)>;

struct Loop::Impl {
  explicit Impl(std::size_t count) : workers(count) {}

  void accept(Acceptor& acceptor, Take take) {
    acceptor.async_accept([this, &acceptor, take = std::move(take)](ErrorCode error, Socket socket) mutable {
      if (error == boost::asio::error::operation_aborted) return;
      if (!error) {
        socket.set_option(tcp::no_delay(true), error);
        Connection connection{std::move(socket)};
        take(connection);
      }
      accept(acceptor, std::move(take));
    });
  }

  boost::asio::io_context io{1};
  boost::asio::thread_pool workers;
  std::list<Acceptor> acceptors;
  std::thread thread;
};

Loop::Loop(std::size_t workers) : impl_(std::make_unique<Impl>(workers)) {}

Loop::~Loop() { stop(); }

tl::expected<std::uint16_t, std::string> Loop::listen(std::uint16_t port, const std::string& whose,
                                                      Take take) {
  Acceptor& acceptor = impl_->acceptors.emplace_back(impl_->io);
  ErrorCode error;
  const tcp::endpoint endpoint(boost::asio::ip::address_v4::loopback(), port);
  std::uint16_t opened = 0;
  acceptor.open(endpoint.protocol(), error);
  if (!error) acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor.bind(endpoint, error);
  if (!error) acceptor.listen(boost::asio::socket_base::max_listen_connections, error);
  if (!error) opened = acceptor.local_endpoint(error).port();
  if (error) {
    return tl::make_unexpected(whose + " could not open port " + std::to_string(port) + " on 127.0.0.1: " +
                               error.message() + ". Choose another port, or 0 for a free one.");
  }
  impl_->accept(acceptor, std::move(take));
  return opened;
}

void Loop::start() {
  impl_->thread = std::thread([this] { impl_->io.run(); });
}

bool Loop::isStarted() const { return impl_->thread.joinable(); }

void Loop::stop() {
  impl_->io.stop();
  if (impl_->thread.joinable()) impl_->thread.join();
  impl_->workers.stop();
  impl_->workers.join();
}

void Loop::post(std::function<void()> task) { boost::asio::post(impl_->io.get_executor(), std::move(task)); }

void Loop::postAndWait(const std::function<void()>& task) {
  const auto promise = std::make_shared<std::promise<void>>();
  post([task, promise] {
    task();
    promise->set_value();
  });
  promise->get_future().wait();
}

void Loop::postAt(std::chrono::steady_clock::time_point time, std::function<void()> task) {
  const auto timer = std::make_shared<Timer>(impl_->io, time);
  timer->async_wait(Waited([timer, task = std::move(task)](ErrorCode error) {
    if (!error) task();
  }));
}

void Loop::work(std::function<void()> task) {
  boost::asio::post(impl_->workers.get_executor(), std::move(task));
}

void readHttp(Stream& stream, boost::beast::flat_buffer& buffer, HttpParser& parser, Transferred done) {
  boost::beast::http::async_read(stream, buffer, parser, std::move(done));
}

void shutDown(Stream& stream) {
  ErrorCode ignored;  // the connection ends either way
  stream.socket().shutdown(tcp::socket::shutdown_both, ignored);
  stream.close();
}

}  // namespace mapwright::simulator
