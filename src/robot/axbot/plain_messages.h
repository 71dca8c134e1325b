// The messages that most of a bag is made of, poses and lists of points, and those that say once more what
// their topic said before, read without making a tree of them. Only what is written as robots usually write
// it: everything else is left to readFrame(), and what is read here is what readFrame() would have made of it
// (tests/robot/test_axbot_bags.cpp).
#pragma once

#include <cstddef>
#include <string_view>
#include <unordered_map>

#include "robot/bag_library.h"

namespace mapwright::robot::axbot {

/// Reads the messages of one text, which ends with a zero byte and must outlive it.
class PlainMessages {
 public:
  /// All of the message that begins at `at`, but its place in the text; returns where it ends. nullptr: it is
  /// to be read otherwise; `message` is what it was, or partly filled.
  const char* read(const char* at, BagMessage& message);
  /// `message`, written as `json`, has been read otherwise: the next of its topic may say the same. `index`:
  /// its place among all that have been read.
  void remember(std::string_view json, const BagMessage& message, std::size_t index);
  /// Where one that only says once more, later, what its topic said last ends; `of` is that one's index.
  /// nullptr: there is none, or it says something else.
  const char* readAgain(const char* at, std::size_t& of, double& stamp_s) const;

 private:
  struct Said {
    std::string_view before, behind;  // of the number of its stamp
    std::size_t index = 0;
  };

  std::size_t last_count_ = 0;                       // of points: the next cloud is as large, as a rule
  std::unordered_map<std::string_view, Said> said_;  // by topic
};

}  // namespace mapwright::robot::axbot
