// Which robots answer at a server: asked without a secret, and only what changes nothing. Each adapter
// recognises its own kind; jobs/robot_search.h asks all of them.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <QObject>
#include <QString>
#include <QUrl>

#include "fault/fault.h"
#include "robot/robot.h"

namespace mapwright::robot {

/// A robot that can be connected to.
struct FoundRobot {
  QString address;
  RobotIdentity identity = {};  // as far as it tells without a secret
  /// It did not answer what it was asked: it seems to be of this kind, and to want a secret.
  bool wants_secret = false;
  std::optional<std::int64_t> topics = {}, services = {};  // how many it lists
  bool operator==(const FoundRobot&) const = default;
};

/// What came of one question: robots, the most particular one first, or why there is none.
struct ProbeAnswer {
  std::vector<FoundRobot> found = {};
  Fault reason = {};
  bool somebody = false;  // something answers there, only not as such a robot does
};

struct Probe {
  QString title;  // which kind is looked for: AddressScheme::title
  QUrl server;
  /// Called once, later, never from within `ask`; not after `owner` is destroyed, which ends it early.
  using Reply = std::function<void(ProbeAnswer)>;
  std::function<void(QObject* owner, std::chrono::milliseconds within, Reply reply)> ask;
};

}  // namespace mapwright::robot
