// How a client of rosbridge behaves.
#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include "net/rosbridge/fragment_joiner.h"
#include "net/rosbridge/requests.h"
#include "net/web_socket_link.h"

namespace mapwright::net::rosbridge {

struct ClientOptions {
  WebSocketLinkOptions link;                       // of both connections; its max_message_bytes is that below
  quint64 max_message_bytes = quint64(256) << 20;  // of a frame, and of what its pieces or its picture hold
  FragmentJoiner::Limits fragments;                // its bytes are at most max_message_bytes
  std::optional<Credentials> credentials;          // said after each opening, before all else
  /// More than about 12 at once can stall a node.
  int calls_at_once = 8;
  /// A call that was given up after it was sent still keeps the server busy: it counts for so long, or until
  /// its late answer.
  std::chrono::milliseconds busy_after_giving_up{20'000};
  /// Of arguments that are made while they travel (ArgsSource): a frame holds no more, or they go in
  /// fragments. The servers of ROS 1 and ROS 2 take 10,000,000 bytes as they are delivered.
  qint64 most_whole_bytes = 8'000'000;
  qint64 fragment_bytes = 256 * 1024;
  std::chrono::milliseconds look_every{100};  // for what has run out of time
  /// A clock that only goes forward, and one that tells seconds since the epoch; empty = the usual ones.
  std::function<std::chrono::milliseconds()> now = {};
  std::function<double()> wall_s = {};
};

}  // namespace mapwright::net::rosbridge
