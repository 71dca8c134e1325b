// The port: which topics a robot has, whatever they bring, and from which of them a kind of data is taken.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "robot/robot.h"

namespace mapwright::robot {

/// A topic as the robot tells of it. Untrusted plain text.
struct OfferedTopic {
  QString name;
  QString type;  // in the robot's own words; empty: it does not say
  bool operator==(const OfferedTopic&) const = default;
};

/// From which topic a kind of data is taken, instead of from where it comes usually.
using TopicChoices = std::map<map::Stream, QString>;

/// How messages have arrived on this connection.
struct Reception {
  qint64 came = 0;
  qint64 dropped = 0;  // made way for newer ones before they were shown
  qint64 late = 0;     // of sensors: more than a second later than they came at best
  struct TransformAge {
    QString parent, child;
    double age_s = 0;  // by the robot's own clock
    bool operator==(const TransformAge&) const = default;
  };
  std::vector<TransformAge> transforms;  // those that change, the oldest first
  bool operator==(const Reception&) const = default;
};

/// What a robot is besides whose topics are its own affair (ROS); ask topicsOfferedBy(). On the thread of the
/// robot; Robot::capabilitiesChanged() tells that there are others.
class OffersTopics {
 public:
  virtual ~OffersTopics() = default;
  /// All that there are, by name; nullopt: the robot does not tell (yet).
  virtual std::optional<std::vector<OfferedTopic>> offered() const = 0;
  /// Those that `stream` can be taken from, whatever they are called; empty where there is no choice.
  virtual QStringList choicesFor(map::Stream stream) const = 0;
  /// These and no others, from now on; what is not named is taken from where it comes usually. Kept over
  /// reconnects. One that is not there (yet) is waited for.
  virtual void choose(const TopicChoices& choices) = 0;
  virtual TopicChoices chosen() const = 0;
  /// Of topics that are wanted by name no message is left out to spare the network.
  virtual void setEveryMessage(bool /*on*/) {}
  /// nullopt: nothing comes over a network.
  virtual std::optional<Reception> reception() const { return std::nullopt; }
};

/// Null: its topics are those of its maker.
inline OffersTopics* topicsOfferedBy(Robot& robot) { return dynamic_cast<OffersTopics*>(&robot); }

}  // namespace mapwright::robot
