// One WebSocket of a client, as all servers of this room have it: whole messages come in, frames go out one
// after the other. Lives on the server's thread, kept alive by `Links` and by its pending operations.
#pragma once

#include <algorithm>
#include <atomic>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "simulator/frame.h"
#include "simulator/loop.h"

namespace mapwright::simulator {

/// A handshake that has been read.
struct Handshake;

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
  virtual void take(const std::string& bytes, bool is_text) = 0;
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

}  // namespace mapwright::simulator
