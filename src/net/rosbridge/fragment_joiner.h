// Joins fragmented messages (rosbridge v2, "fragmentation").
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <optional>
#include <string>

#include <QByteArray>
#include <tl/expected.hpp>

#include "net/rosbridge/field.h"

namespace mapwright::net::rosbridge {

/// Joins {"op":"fragment","id","num","total","data"} to messages, in any order. A pure value; time is passed
/// in and only increases. One for each connection.
/// Ids are numbers or texts, and need not be unique: a fragment whose id (and total) is in use goes to the
/// oldest message that lacks it. If the limits are exceeded, the oldest message is dropped. The count is the
/// integer part of `total`; a server that computes it as length / size + 1 sends one fragment less when the
/// length is a multiple: a message that is a complete object without the last fragment is accepted.
class FragmentJoiner {
 public:
  struct Limits {
    std::size_t bytes = std::size_t(256) << 20;  // of all incomplete messages, with overhead
    std::size_t messages = 64;                   // incomplete at once
    std::size_t pieces = 1 << 20;                // of one message
    std::chrono::milliseconds timeout{30'000};   // for the next fragment of a message
  };
  enum class Fault {
    Malformed,  // a fragment without number, count or data
    TooLarge,   // that message alone exceeds the limits
  };

  explicit FragmentJoiner(Limits limits) : limits_(limits) {}

  /// The message completed by this fragment, as JSON text.
  tl::expected<std::optional<QByteArray>, Fault> add(const Field& fragment, std::chrono::milliseconds now);
  /// Drops messages that have waited too long.
  void expire(std::chrono::milliseconds now);
  void clear();

  std::size_t heldBytes() const { return held_; }
  std::size_t heldMessages() const { return open_.size(); }
  std::uint64_t dropped() const {
    return dropped_;
  }  // incomplete messages that were dropped, except by clear()

 private:
  struct Message {
    std::string id;  // with its type: 0 differs from "0"
    double total = 0;
    std::size_t count = 0;
    std::map<std::size_t, std::string> pieces;
    std::size_t bytes = 0;
    std::chrono::milliseconds last{0};
  };
  using Iterator = std::list<Message>::iterator;

  void close(Iterator entry);
  void giveUp(Iterator entry);
  std::optional<QByteArray> complete(Iterator entry);

  Limits limits_;
  std::list<Message> open_;  // oldest first
  std::size_t held_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace mapwright::net::rosbridge
