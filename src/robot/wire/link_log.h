// What becomes of a connection, for the log.
#pragma once

#include <string>

#include <QLoggingCategory>

#include "robot/robot.h"

namespace mapwright::robot::wire {

/// One line for each change; what is measured all the time (round trips, seconds until the next try) is none.
class LinkLog {
 public:
  /// `category` outlives this. `who`: the robot, "10.0.0.7:8090", or a file.
  LinkLog(const QLoggingCategory& category, std::string who) : category_(category), who_(std::move(who)) {}
  void note(const ConnectionState& state);
  void note(const Fault& fault);

 private:
  const QLoggingCategory& category_;
  std::string who_;
  ConnectionState last_;
};

}  // namespace mapwright::robot::wire
