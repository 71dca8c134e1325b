// Which topics to subscribe to, and how. Pure; any thread. Source: docs/protocols/autoxing.md, "Live topics".
#pragma once

#include <QString>
#include <QStringList>

#include "robot/robot.h"

namespace mapwright::robot::axbot {

class TopicSubscriptions {
 public:
  /// Topics that are always subscribed.
  void setBasics(const LiveTopics::Basics& basics) { basics_ = basics; }
  QStringList always() const;

  /// The messages to send so that exactly `topics` and always() are enabled; each name once, at most 256
  /// characters.
  QStringList setWanted(const QStringList& topics);
  /// For a new connection: the messages that enable everything.
  QStringList all() const;
  /// The messages that disable and enable these again.
  QStringList anew(const QStringList& topics) const;
  /// The names that all() enables.
  QStringList names() const { return always() + wanted_; }
  /// Whether the robot accepts lists of topics.
  void setTakesLists(bool takes) { takes_lists_ = takes; }
  bool takesLists() const { return takes_lists_; }

 private:
  QStringList requests(const char* verb, const QStringList& topics) const;

  LiveTopics::Basics basics_;
  QStringList wanted_;  // besides always()
  bool takes_lists_ = false;
};

}  // namespace mapwright::robot::axbot
