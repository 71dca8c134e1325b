// A server's thread, which handles all sockets, and its workers.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include <tl/expected.hpp>

namespace mapwright::simulator {

/// A client that has come.
struct Connection;

/// Members may be called from any thread, except listen(), which must come before start().
class Loop {
 public:
  explicit Loop(std::size_t workers);
  ~Loop();
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  /// Opens a port of 127.0.0.1, 0 = a free one, and passes on new connections. Returns the port, or a
  /// sentence if it could not be opened.
  tl::expected<std::uint16_t, std::string> listen(std::uint16_t port, const std::string& whose,
                                                  std::function<void(Connection&)> take);
  void start();
  bool isStarted() const;
  /// Tasks not started yet are dropped; what they keep alive is destroyed with the loop.
  void stop();

  void post(std::function<void()> task);
  /// Returns when it is done.
  void postAndWait(const std::function<void()>& task);
  void postAt(std::chrono::steady_clock::time_point time, std::function<void()> task);
  /// For tasks of several milliseconds: runs on a worker.
  void work(std::function<void()> task);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::simulator
