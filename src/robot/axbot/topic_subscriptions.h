// Which topics a robot is asked for, and how. Pure; any thread. Source: docs/protocols/autoxing.md, "Live
// topics".
#pragma once

#include <QString>
#include <QStringList>

#include "robot/robot.h"

namespace mapwright::robot::axbot {

class TopicSubscriptions {
 public:
  /// What a robot is asked for, wanted or not.
  void setBasics(const LiveTopics::Basics& basics) { basics_ = basics; }
  QStringList always() const;

  /// The texts to send so that exactly `topics` and always() are on; each name once, at most 256 characters.
  QStringList setWanted(const QStringList& topics);
  /// A new connection: the texts that switch on everything.
  QStringList all() const;
  /// The texts that switch these off and on again.
  QStringList anew(const QStringList& topics) const;
  /// The names that all() switches on.
  QStringList names() const { return always() + wanted_; }
  /// Whether the robot takes lists of topics.
  void setTakesLists(bool takes) { takes_lists_ = takes; }
  bool takesLists() const { return takes_lists_; }

 private:
  QStringList requests(const char* verb, const QStringList& topics) const;

  LiveTopics::Basics basics_;
  QStringList wanted_;  // besides always()
  bool takes_lists_ = false;
};

}  // namespace mapwright::robot::axbot
