// The port: which topics a robot has, and which of them provides a kind of data.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "robot/robot.h"

namespace mapwright::robot {

/// A topic as listed by the robot. Untrusted plain text.
struct OfferedTopic {
  QString name;
  QString type;  // the robot's name for its type; empty: not stated
  bool operator==(const OfferedTopic&) const = default;
};

/// Which topic to use for a kind of data, instead of the usual one.
using TopicChoices = std::map<map::Stream, QString>;

/// Statistics of messages on this connection.
struct Reception {
  qint64 came = 0;
  qint64 dropped = 0;  // replaced by newer ones before they were shown
  qint64 late = 0;     // for sensors: more than a second later than at best
  struct TransformAge {
    QString parent, child;
    double age_s = 0;  // by the robot's own clock
    bool operator==(const TransformAge&) const = default;
  };
  std::vector<TransformAge> transforms;  // the changing ones, oldest first
  bool operator==(const Reception&) const = default;
};

/// Interface of a robot with freely named topics (ROS); get it with topicsOfferedBy(). On the thread of the
/// robot; Robot::capabilitiesChanged() reports new topics.
class OffersTopics {
 public:
  virtual ~OffersTopics() = default;
  /// All topics by name; nullopt: the robot does not list them (yet).
  virtual std::optional<std::vector<OfferedTopic>> offered() const = 0;
  /// The topics that can be used for `stream`; empty if there is no choice.
  virtual QStringList choicesFor(map::Stream stream) const = 0;
  /// Uses exactly these from now on; streams without an entry use their usual topic. Kept across reconnects.
  /// If a topic does not exist (yet) it is waited for.
  virtual void choose(const TopicChoices& choices) = 0;
  virtual TopicChoices chosen() const = 0;
  /// No message of explicitly requested topics is dropped to save bandwidth.
  virtual void setEveryMessage(bool /*on*/) {}
  /// By topic: how many markers are not shown because the transforms that place them have not arrived.
  virtual std::map<QString, int> unplacedMarkers() const { return {}; }
  /// nullopt: there is no network connection.
  virtual std::optional<Reception> reception() const { return std::nullopt; }
};

/// Null: its topics are fixed by its maker.
inline OffersTopics* topicsOfferedBy(Robot& robot) { return dynamic_cast<OffersTopics*>(&robot); }

}  // namespace mapwright::robot
