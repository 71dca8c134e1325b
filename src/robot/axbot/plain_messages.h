// A fast path for the most common messages of a bag, poses and lists of points, and for repetitions of a
// topic's previous message, without building a tree. Only handles the usual formatting: everything else is
// left to readFrame(), and the results are identical (tests/robot/test_axbot_bags.cpp).
#pragma once

#include <cstddef>
#include <string_view>
#include <unordered_map>

#include "robot/bag_library.h"

namespace mapwright::robot::axbot {

/// Reads the messages of one text, which ends with a zero byte and must outlive it.
class PlainMessages {
 public:
  /// Reads the message that begins at `at`, except its position in the text; returns its end. nullptr: use
  /// the normal reader; `message` is then unchanged or partly filled.
  const char* read(const char* at, BagMessage& message);
  /// `message`, with the JSON `json`, was read by the normal reader: the next one of its topic may be the
  /// same. `index`: its index among all messages.
  void remember(std::string_view json, const BagMessage& message, std::size_t index);
  /// If the message only repeats its topic's last one at a later time: its end, with that one's index in
  /// `of`. nullptr: it does not.
  const char* readAgain(const char* at, std::size_t& of, double& stamp_s) const;

 private:
  struct Said {
    std::string_view before, behind;  // the text around its stamp
    std::size_t index = 0;
  };

  std::size_t last_count_ = 0;                       // of points: the next cloud usually has the same size
  std::unordered_map<std::string_view, Said> said_;  // by topic
};

}  // namespace mapwright::robot::axbot
