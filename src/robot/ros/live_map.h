// The live map of a ROS robot, for requests for the whole map. Lives on the link's thread.
#pragma once

#include <chrono>
#include <list>
#include <memory>
#include <optional>

#include <QObject>
#include <QPointer>
#include <QTimer>

#include "map/live_topics.h"
#include "robot/call.h"
#include "robot/wire/errand.h"

namespace mapwright::robot::ros {

class LiveMap : public QObject {
  Q_OBJECT
 public:
  explicit LiveMap(std::chrono::milliseconds patience, QObject* parent = nullptr)
      : QObject(parent), patience_(patience) {}

  void take(const map::GridMessage& grid);
  /// The received map is no longer the robot's current one.
  void forget() { last_.reset(); }
  const std::optional<map::GridMessage>& last() const { return last_; }
  /// The last map received, or the next one, under that key and name. `longer`: waits longer than usual, for
  /// a large one.
  void fetch(const wire::ErrandPtr& errand, const map::MapKey& key, const std::string& name,
             OutcomeTo<map::WholeMap> reply, std::chrono::milliseconds longer = {});
  /// Somebody waits for it, or listens to every one.
  bool wanted() const { return !waiting_.empty() || !listeners_.expired(); }
  /// The map is requested as long as the result is held; came() reports each one. Release it on the link's
  /// thread, while this lives or after.
  std::shared_ptr<void> listen();
  void endAll(const map::Failure& failure);

 Q_SIGNALS:
  void wantedChanged();
  void came();

 private:
  struct Waiting {
    map::MapKey key;
    std::string name;
    OutcomeTo<map::WholeMap> reply;
    wire::ErrandPtr errand;
    int number = 0;
    std::unique_ptr<QTimer> patience;
  };
  using Entry = std::shared_ptr<Waiting>;
  void end(const Entry& entry, Outcome<map::WholeMap> outcome);

  std::chrono::milliseconds patience_;
  std::optional<map::GridMessage> last_;
  std::list<Entry> waiting_;
  std::weak_ptr<void> listeners_;
};

}  // namespace mapwright::robot::ros
