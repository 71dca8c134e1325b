// The data that a recording requests by itself: listed submaps, the current map, its waypoints. GUI-thread
// object, like the robot.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <QObject>
#include <QPointer>
#include <QTimer>

#include "map/submap.h"
#include "robot/robot.h"

namespace mapwright::map {
struct StampedMessage;
}

namespace mapwright::recorder {

/// Which submaps a recording requests. Pure; time is passed in.
class SubmapRequests {
 public:
  enum class Which : std::uint8_t {
    None,
    Listed,  // each listed one, and changed ones at most every kAgainNs
    All,     // every listed version, as fast as the robot can deliver
  };
  static constexpr std::int64_t kAgainNs = 30'000'000'000;
  static constexpr std::int64_t kRetryNs = 2'000'000'000;
  static constexpr int kTries = 5;  // for each version
  static constexpr std::size_t kAtOnce = 4;

  explicit SubmapRequests(Which which) : which_(which) {}

  void onList(const map::SubmapList& list, std::int64_t now_ns);
  /// What to request now; it counts as requested until it is answered.
  std::vector<map::SubmapKey> next();
  void answered(const map::SubmapKey& key, map::SubmapAnswer::Outcome outcome, std::int64_t now_ns);
  /// Checks what has become due.
  void look(std::int64_t now_ns);
  /// How many listed ones were never received.
  std::size_t missing() const;

 private:
  struct Row {
    std::int32_t listed = 0, had = 0;  // versions; had 0: none
    std::int64_t not_before_ns = 0;
    int tries = 0;  // for the version `listed`
    bool asked = false;
  };
  void judge(map::SubmapId id, const Row& row, std::int64_t now_ns);

  Which which_;
  std::string uuid_;
  std::map<map::SubmapId, Row> rows_;
  std::set<map::SubmapId> due_;
  std::size_t asked_ = 0;
};

class Fetches : public QObject {
  Q_OBJECT
 public:
  /// Receives attachments; the bodies of submaps come through the robot's tap.
  using Keep = std::function<void(std::string name, std::string media_type, std::string_view bytes)>;
  Fetches(robot::Robot& robot, SubmapRequests::Which submaps, Keep keep,
          std::function<std::int64_t()> now_ns);
  ~Fetches() override;

  /// Adds a map that the user has opened to the recording, like the robot's current one, again whenever it
  /// changes. Live maps come by topic.
  void wantMap(const map::MapKey& key);
  /// The submaps listed before the recording began.
  void onList(const map::SubmapList& list);
  std::size_t submapsMissing() const { return submaps_.missing(); }

 Q_SIGNALS:
  /// Something could not be loaded for the recording.
  void notHad(const mapwright::map::Failure& failure);

 private:
  void onTopic(const map::StampedMessage& stamped);
  void pump();
  void askMaps();
  void onMaps(const std::vector<map::CatalogueEntry>& entries);
  void askMap(const map::MapKey& key);
  void keepMap(const map::WholeMap& map);
  void askPlaces(const map::MapKey& key, std::vector<map::OverlayFeature> overlays);

  QPointer<robot::Robot> robot_;
  SubmapRequests submaps_;
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
  std::map<quint64, robot::Call> calls_;  // of submaps, in progress
  robot::Call list_;
};

}  // namespace mapwright::recorder
