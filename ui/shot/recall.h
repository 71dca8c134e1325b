// A session that replays a bag, taken to one moment.
#pragma once

#include <optional>

#include <QObject>

#include "map/failure.h"
#include "replay/replay_robot.h"
#include "session/session.h"

namespace mapwright::ui::shot {

class Recall : public QObject {
 public:
  /// `session` is that of `robot`, and both outlive this.
  Recall(session::Session& session, replay::ReplayRobot& robot);

  /// Once the bag is open.
  void goTo(double at_s);
  /// The session has the exact state of that moment.
  bool in() const { return in_; }
  /// Why it never will, or not all of it; nullopt: nothing stands in the way.
  std::optional<map::Failure> failure() const;

 private:
  replay::ReplayRobot& robot_;
  double at_s_ = 0;
  bool in_ = false;
};

}  // namespace mapwright::ui::shot
