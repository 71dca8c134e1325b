// The pose graph of the robot's SLAM session and how far its constraints are from it: requested once somebody
// wants it, and again when it may have changed.
#pragma once

#include <memory>
#include <optional>

#include <QObject>

#include "map/closures.h"
#include "robot/call.h"
#include "work/workers.h"

namespace mapwright::robot {
class Robot;
}

namespace mapwright::session {

/// GUI-thread object. The robot must outlive it.
class PoseGraphSlot : public QObject {
  Q_OBJECT
 public:
  PoseGraphSlot(robot::Robot& robot, std::shared_ptr<work::Workers> workers);
  ~PoseGraphSlot() override;

  /// The robot has one.
  bool offered() const;
  /// Requests it, unless it is here, on its way, or has failed.
  void want();
  /// It may have changed: requests it again if anybody has wanted it. What is here stays until then.
  void refresh();
  bool loading() const { return loading_; }
  /// Why the last request failed; nullopt if it did not.
  const std::optional<map::Failure>& failure() const { return failure_; }
  /// Null: not here.
  const std::shared_ptr<const map::Closures>& closures() const { return closures_; }

 Q_SIGNALS:
  void changed();

 private:
  using Graph = std::shared_ptr<const map::PoseGraph>;
  void onAnswer(robot::Outcome<Graph> answer);
  void onRanked(std::shared_ptr<const map::Closures> closures, quint64 of);

  robot::Robot& robot_;
  bool wanted_ = false, loading_ = false, again_ = false;
  std::optional<map::Failure> failure_;
  std::shared_ptr<const map::Closures> closures_;
  robot::Call call_;
  quint64 request_ = 0;
  work::Tasks ranking_;  // last: waits for running work
};

}  // namespace mapwright::session
