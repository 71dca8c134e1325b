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

/// Members may be called from any thread, but listen() only before start().
class Loop {
 public:
  explicit Loop(std::size_t workers);
  ~Loop();
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  /// Opens a port of 127.0.0.1, 0 = a free one, and hands over who comes. The port, or a sentence about whose
  /// port could not be opened.
  tl::expected<std::uint16_t, std::string> listen(std::uint16_t port, const std::string& whose,
                                                  std::function<void(Connection&)> take);
  void start();
  bool isStarted() const;
  /// What has not begun is never done; what a task keeps alive goes with the loop.
  void stop();

  void post(std::function<void()> task);
  /// Returns when it is done.
  void postAndWait(const std::function<void()>& task);
  void postAt(std::chrono::steady_clock::time_point time, std::function<void()> task);
  /// For what takes milliseconds: on a worker.
  void work(std::function<void()> task);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mapwright::simulator
