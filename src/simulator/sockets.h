// The sockets of the simulated robots: a server's thread with its workers, WebSocket links, HTTP connections.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "simulator/http_answer.h"
#include "simulator/request_log.h"

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
                                                  std::function<void(Connection&)> on_connection);
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

/// Something that comes again and again.
struct Periodic {
  Periodic(std::string_view what, double period_s, std::chrono::steady_clock::time_point now)
      : name(what),
        period(std::chrono::duration_cast<std::chrono::steady_clock::duration>(
            std::chrono::duration<double>(period_s))),
        due(now + period) {}
  /// Whether it is due; then it is due a period later again.
  bool comes(std::chrono::steady_clock::time_point now) {
    if (now < due) return false;
    due = std::max(due + period, now);
    return true;
  }

  std::string_view name;
  std::chrono::steady_clock::duration period;
  std::chrono::steady_clock::time_point due;
};

/// Whether so many seconds have passed since `last`, which is then now; never if they are 0.
inline bool isTime(int every_s, std::chrono::steady_clock::time_point& last,
                   std::chrono::steady_clock::time_point now) {
  if (every_s <= 0 || now - last < std::chrono::seconds(every_s)) return false;
  last = now;
  return true;
}

/// What is sent over a WebSocket at once.
struct Frame {
  std::shared_ptr<const std::string> bytes;
  bool binary = false;
};

inline Frame textFrame(std::string text) {
  return {std::make_shared<const std::string>(std::move(text)), false};
}

/// A handshake that has been read.
struct Handshake;

/// One WebSocket of a client, as all servers of this room have it: whole messages come in, frames go out one
/// after the other. Lives on the server's thread, kept alive by `Links` and by its pending operations.
class WebSocketLink : public std::enable_shared_from_this<WebSocketLink> {
 public:
  virtual ~WebSocketLink();
  WebSocketLink(const WebSocketLink&) = delete;
  WebSocketLink& operator=(const WebSocketLink&) = delete;

  /// Reads the handshake and answers it.
  void accept();
  /// Answers one that has been read.
  void accept(Handshake handshake);
  void send(Frame frame);
  /// Without a closing handshake.
  void cut();

 protected:
  /// Beyond so many bytes in its queue a reader is given up.
  WebSocketLink(Connection& connection, std::size_t most_message_bytes, std::size_t most_queued_bytes);

  /// The handshake is done. Nothing is read when it answers false: who does not read does not pong either.
  virtual bool opened() = 0;
  virtual void onMessage(const std::string& bytes, bool is_text) = 0;
  /// It is closed or cut; comes more than once.
  virtual void gone() = 0;

  bool isOpen() const { return open_; }
  std::size_t queued() const { return outgoing_.size(); }

 private:
  void read();
  void write();

  struct Wire;
  const std::unique_ptr<Wire> wire_;
  const std::size_t most_queued_bytes_;
  bool open_ = false;
  std::deque<Frame> outgoing_;
  std::size_t outgoing_bytes_ = 0;
};

/// The open ones of a server, on its thread.
template <typename Link>
class Links {
 public:
  void join(std::shared_ptr<Link> link) {
    links_.push_back(std::move(link));
    open_ = static_cast<int>(links_.size());
  }
  void leave(const Link* link) {
    const auto found =
        std::find_if(links_.begin(), links_.end(), [&](const auto& one) { return one.get() == link; });
    if (found == links_.end()) return;
    const std::shared_ptr<Link> last = std::move(*found);  // goes when all is in order
    links_.erase(found);
    open_ = static_cast<int>(links_.size());
  }
  /// A copy: what is done with one may end others.
  std::vector<std::shared_ptr<Link>> all() const { return links_; }
  void cut() {
    for (const std::shared_ptr<Link>& link : all()) link->cut();
  }
  /// How many; from any thread.
  int open() const { return open_; }

 private:
  std::vector<std::shared_ptr<Link>> links_;
  std::atomic<int> open_ = 0;
};

/// What HTTP connections work with. Outlives them.
struct HttpService {
  Answerer& routes;
  RequestLog& log;
  Loop& loop;
  /// Makes the link of a client that asks for the topics of `target`.
  std::function<std::shared_ptr<WebSocketLink>(Connection& connection, std::string_view target)> open_topics;
};

/// Handles a client's requests until it leaves or becomes a WebSocket. On the loop's thread.
void serveHttp(Connection& connection, const HttpService& service);

}  // namespace mapwright::simulator
