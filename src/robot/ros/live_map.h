// The live map of a ROS robot, for requests for the whole map. Lives on the link's thread.
#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include <QObject>
#include <QPointer>

#include "map/live_topics.h"
#include "robot/call.h"
#include "robot/wire/task.h"

namespace mapwright::robot::ros {

class LiveMap : public QObject {
  Q_OBJECT
 public:
  explicit LiveMap(std::chrono::milliseconds patience) : patience_(patience) {}

  void take(const map::GridMessage& grid);
  /// The received map is no longer the robot's current one.
  void forget() { last_.reset(); }
  const std::optional<map::GridMessage>& last() const { return last_; }
  /// The last map received, or the next one, under that key and name. `longer`: waits longer than usual, for
  /// a large one.
  void fetch(const wire::TaskPtr& task, const map::MapKey& key, const std::string& name,
             OutcomeTo<map::WholeMap> reply, std::chrono::milliseconds longer = {});
  /// Somebody waits for it, or wants to hear of each.
  bool wanted() const { return !waits_.empty() || !listeners_.expired(); }
  /// As long as it is held, the map is asked for; came() tells of each. Let go of it on the link's thread,
  /// while this lives or after.
  std::shared_ptr<void> listen();
  /// The connection broke off.
  void lose() { waits_.drop(); }

 Q_SIGNALS:
  void wantedChanged();
  void came();

 private:
  std::chrono::milliseconds patience_;
  std::optional<map::GridMessage> last_;
  wire::WaitList waits_;
  std::weak_ptr<void> listeners_;
};

}  // namespace mapwright::robot::ros
