// What is never repeated of a robot's words (net/unsaid.h).
#pragma once

#include <memory>
#include <string>

#include <QByteArray>
#include <QObject>

#include "map/catalogue.h"
#include "robot/robot.h"

namespace mapwright::net {
class Unsaid;
}

namespace mapwright::robot::wire {

/// In what robots say. Immutable; any thread.
class Unsaid {
 public:
  explicit Unsaid(const QByteArray& secret = {});

  void hideIn(std::string& words) const;
  void hideIn(QString& words) const;
  void hideIn(QByteArray& utf8) const;
  void hideIn(Fault& fault) const;
  void hideIn(map::Failure& failure) const;
  void hideIn(map::Problem& problem) const;
  void hideIn(ConnectionState& state) const;
  /// The remarks that come with a value.
  template <typename T>
  void hideInRemarks(T& value) const {
    if constexpr (requires { hideIn(value.reason); }) hideIn(value.reason);
    if constexpr (requires { hideIn(value.notes.front()); }) {
      for (auto& note : value.notes) hideIn(note);
    }
  }

 private:
  std::shared_ptr<const net::Unsaid> secret_;
};

/// Of a RobotLink; nothing for other objects.
const Unsaid& unsaidOf(const QObject* link);

}  // namespace mapwright::robot::wire
