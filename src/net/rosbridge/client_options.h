// Options of a rosbridge client.
#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include "net/rosbridge/fragment_joiner.h"
#include "net/rosbridge/requests.h"
#include "net/web_socket_link.h"

namespace mapwright::net::rosbridge {

struct ClientOptions {
  WebSocketLinkOptions link;  // of both connections; its max_message_bytes is replaced by the one below
  quint64 max_message_bytes = quint64(256)
                              << 20;       // of a frame, and of the content of its fragments or picture
  FragmentJoiner::Limits fragments;        // its bytes are at most max_message_bytes
  std::optional<Credentials> credentials;  // sent first after each connect
  /// More than about 12 at once can stall a node.
  int calls_at_once = 8;
  /// A call that was given up after sending keeps the server busy: it counts for this long, or until its late
  /// answer.
  std::chrono::milliseconds busy_after_giving_up{20'000};
  /// Limit for a single frame with streamed arguments (ArgsSource); larger ones are sent in fragments. The
  /// servers of ROS 1 and ROS 2 accept 10,000,000 bytes by default.
  qint64 most_whole_bytes = 8'000'000;
  qint64 fragment_bytes = 256 * 1024;
  std::chrono::milliseconds look_every{100};  // how often to check for timeouts
  /// A monotonic clock, and one for seconds since the epoch; empty = the default ones.
  std::function<std::chrono::milliseconds()> now = {};
  std::function<double()> wall_s = {};
};

}  // namespace mapwright::net::rosbridge
