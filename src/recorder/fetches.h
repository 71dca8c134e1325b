// The data that a recording requests by itself: listed submaps, the current map, its waypoints. GUI-thread
// object, like the robot.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <QObject>
#include <QPointer>
#include <QTimer>

#include "recorder/submap_wishes.h"
#include "robot/robot.h"

namespace mapwright::recorder {

class Fetches : public QObject {
  Q_OBJECT
 public:
  /// Receives attachments; the bodies of submaps come through the robot's tap.
  using Keep = std::function<void(std::string name, std::string media_type, std::string_view bytes)>;
  Fetches(robot::Robot& robot, SubmapWishes::Which submaps, Keep keep, std::function<std::int64_t()> now_ns);
  ~Fetches() override;

  /// Adds a map that the user has opened to the recording, like the robot's current one, again whenever it
  /// changes. Live maps come by topic.
  void wantMap(const map::MapKey& key);
  /// The submaps listed before the recording began.
  void takeList(const map::SubmapList& list);
  std::size_t submapsMissing() const { return wishes_.missing(); }

 Q_SIGNALS:
  /// Something could not be loaded for the recording.
  void notHad(const mapwright::map::Failure& failure);

 private:
  void takeTopic(const map::StampedMessage& stamped);
  void pump();
  void askMaps();
  void takeMaps(const std::vector<map::CatalogueEntry>& entries);
  void askMap(const map::MapKey& key);
  void keepMap(const map::WholeMap& map);
  void askPlaces(const map::MapKey& key, std::vector<map::OverlayFeature> overlays);

  QPointer<robot::Robot> robot_;
  SubmapWishes wishes_;
  Keep keep_;
  std::function<std::int64_t()> now_ns_;
  QTimer look_;
  bool asking_ = false, again_ = false;
  struct Wanted {
    std::optional<map::CatalogueEntry> had;  // its catalogue entry at the time of the request
    bool asked = false, current = false;
    robot::Call map, places;
  };
  std::map<map::MapKey, Wanted> wanted_;
  std::optional<std::vector<map::CatalogueEntry>> listed_;
  quint64 last_call_ = 0;
  std::map<quint64, robot::Call> calls_;  // of submaps, under way
  robot::Call list_;
};

}  // namespace mapwright::recorder
