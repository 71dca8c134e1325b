// What is never repeated of a robot's words: the secret that it was given, and what rosauth proves it with.
#pragma once

#include <string>
#include <vector>

#include <QByteArray>
#include <QObject>

#include "map/catalogue.h"
#include "robot/robot.h"

namespace mapwright::robot::wire {

/// Immutable; any thread.
class Unsaid {
 public:
  Unsaid() = default;
  /// Shorter secrets stay: they are part of other words.
  explicit Unsaid(const QByteArray& secret, std::size_t shortest = 4);

  /// Puts "***" in its place.
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
  std::vector<std::string>
      forms_;  // as it is, in addresses, in JSON, as base64, as texts of robots are shown
};

/// Of a RobotLink; nothing for other objects.
const Unsaid& unsaidOf(const QObject* link);

}  // namespace mapwright::robot::wire
