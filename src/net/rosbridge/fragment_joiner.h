// Messages that come in pieces (rosbridge v2, "fragmentation").
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

/// Joins {"op":"fragment","id","num","total","data"} to messages, whatever order they come in. A pure value;
/// time is handed in and only goes forward. One for each connection.
///
/// Ids are numbers or texts, and need not differ: pieces with an id (and total) that is in use go to the
/// oldest message that lacks them. What is oldest is dropped when all together exceed the limits. The count
/// is the whole part of `total`; a server that computes it as length / size + 1 sends one piece less when the
/// length is a multiple: what is a whole object without the last piece is complete.
class FragmentJoiner {
 public:
  struct Limits {
    std::size_t bytes = std::size_t(256) << 20;  // of all that is not complete, overhead included
    std::size_t messages = 64;                   // not complete at once
    std::size_t pieces = 1 << 20;                // of one message
    std::chrono::milliseconds patience{30'000};  // for the next piece of a message
  };
  enum class Fault {
    Malformed,  // a piece without a number, a count or data
    TooLarge,   // that message alone exceeds the limits
  };

  explicit FragmentJoiner(Limits limits) : limits_(limits) {}

  /// The message that this piece completes, as JSON text.
  tl::expected<std::optional<QByteArray>, Fault> take(const Field& fragment, std::chrono::milliseconds now);
  /// Drops what has waited too long.
  void expire(std::chrono::milliseconds now);
  void clear();

  std::size_t heldBytes() const { return held_; }
  std::size_t heldMessages() const { return open_.size(); }
  std::uint64_t dropped() const { return dropped_; }  // messages that were begun and given up, clear() apart

 private:
  struct Message {
    std::string id;  // with its type: 0 is not "0"
    double total = 0;
    std::size_t count = 0;
    std::map<std::size_t, std::string> pieces;
    std::size_t bytes = 0;
    std::chrono::milliseconds last{0};
  };
  using Place = std::list<Message>::iterator;

  void close(Place place);
  void giveUp(Place place);
  std::optional<QByteArray> complete(Place place);

  Limits limits_;
  std::list<Message> open_;  // oldest first
  std::size_t held_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace mapwright::net::rosbridge
