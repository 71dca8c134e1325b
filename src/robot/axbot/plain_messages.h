// The messages that most of a bag is made of, poses and lists of points, read in the one pass that finds
// where they end. Only what is written as robots usually write it: everything else is left to readFrame(),
// and what is read here is what readFrame() would have made of it (tests/robot/test_axbot_bags.cpp).
#pragma once

#include <cstddef>

#include <simdjson.h>

#include "robot/bag_library.h"

namespace mapwright::robot::axbot {

class PlainMessages {
 public:
  /// All of `message` but its place in the text. false: it is to be read otherwise, from its start; `message`
  /// is what it was, or partly filled. The object stands at its end, or anywhere within.
  bool read(simdjson::ondemand::object& object, BagMessage& message);

 private:
  std::size_t last_count_ = 0;  // of points: the next cloud is as large, as a rule
};

}  // namespace mapwright::robot::axbot
