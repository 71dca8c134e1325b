// What a recording asks the robot for by itself: listed submaps, the map that it works with, its places.
// GUI-thread object, like the robot.
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
  /// Gets what is to be an attachment; the bodies of submaps come by the tap of the robot.
  using Keep = std::function<void(std::string name, std::string media_type, std::string_view bytes)>;
  Fetches(robot::Robot& robot, SubmapWishes::Which submaps, Keep keep, std::function<std::int64_t()> now_ns);
  ~Fetches() override;

  /// A map that somebody has opened belongs to the recording like the one that the robot works with, and
  /// again whenever it changes. What is live comes by its topic.
  void wantMap(const map::MapKey& key);
  /// What the robot has listed before the recording began.
  void takeList(const map::SubmapList& list);
  std::size_t submapsMissing() const { return wishes_.missing(); }

 Q_SIGNALS:
  /// Something that was to be in the recording could not be had.
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
    std::optional<map::CatalogueEntry> had;  // as the robot's list told it when it was asked for
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
