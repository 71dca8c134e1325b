// One connected robot as the window and the command line see it: the live state, the submaps, the whole maps,
// the problems. A facade: the submaps are the business of session::Submaps. GUI-thread object.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include <QElapsedTimer>
#include <QObject>
#include <QSet>
#include <QString>
#include <QTimer>

#include "geometry/rect.h"
#include "map/world.h"
#include "robot/robot.h"
#include "session/catalogue.h"
#include "session/layer_grids.h"
#include "session/map_slot.h"
#include "session/problem_log.h"
#include "session/safety_watch.h"
#include "session/submaps.h"
#include "work/budgets.h"
#include "work/workers.h"

namespace mapwright::session {

class Session : public QObject {
  Q_OBJECT
 public:
  struct Options {
    submap::SchedulerOptions scheduler;
    std::shared_ptr<work::Workers> workers = {};  // null = a crew of its own
    /// Finished pyramids of large maps are kept there (empty = nowhere), and what of the submaps does not go
    /// into the memory, for as long as the program runs.
    QString sidecar_folder = {};
    work::Budgets budgets = work::budgetsFrom();  // of which it takes `textures` and `unpacked`
    bool overview = true;  // ask for a picture of the whole SLAM map while submaps are still loading
    /// What the robot is asked for without a wish of anybody. Without `submaps` none is listed or fetched.
    robot::LiveTopics::Basics basics = {};
    bool maps = true;         // the catalogue is asked for and the first whole map opened without being told
    bool log_safety = false;  // what is wrong with the robot itself is a problem, too
    /// The time of day: of arriving messages, and of problems.
    std::function<QDateTime()> wall = [] { return QDateTime::currentDateTime(); };
    /// How long a robot that can send its map may keep silent before its current stored one is shown.
    int live_map_within_ms = 5'000;
  };
  /// Takes the robot over; connect with open(). `monotonic` is the clock of all waits.
  Session(std::unique_ptr<robot::Robot> robot, Options options, QObject* parent = nullptr,
          std::function<submap::Millis()> monotonic = {});
  ~Session() override;

  void open();
  void close();
  /// From now on nothing changes any more, whatever the robot sends: for whoever draws the present state and
  /// says what he has drawn. Cannot be undone.
  void standStill();
  void retryNow();  // reconnect if need be; ask again for everything that failed or was missing

  robot::Robot& robot() { return *robot_; }
  const robot::Robot& robot() const { return *robot_; }
  robot::ConnectionState connection() const { return robot_->connection(); }
  const map::LiveState& live() const { return live_; }
  /// All that the robot has said.
  const map::World& world() const { return world_; }
  /// Shows this world from now on, as if its messages had come: what a recording was at some time, say. What
  /// the robot says goes on from there. Not `whole`: what is missing in it may still be found, and the
  /// submaps of before stay until then.
  void reset(map::World world, bool whole = true);
  const submap::SubmapBook& book() const { return submaps_.book(); }
  const ProblemLog& problems() const { return problems_; }
  void clearProblems();
  /// Something went wrong, or is well again, `at` some time (now, where it is not given).
  void report(const map::Problem& problem, const QDateTime& at = {});
  void recover(const map::Recovery& recovery, const QDateTime& at = {});
  /// What people near the robot must know at once.
  const SafetyWatch& safety() const { return safety_; }
  /// When live messages stopped (link lost); nullopt while online or never online.
  std::optional<QDateTime> staleSince() const { return stale_since_; }

  SubmapCounts counts() const;
  /// Pictures of submaps that were held and could not be read back. They are fetched again, unless all stands
  /// still.
  int lostPictures() const { return submaps_.lost(); }
  SubmapStatus status(map::SubmapId id) const { return submaps_.status(id); }
  /// Why Missing, Waiting, Corrupt or Unplaced; plain text.
  Fault reason(map::SubmapId id) const { return submaps_.reason(id); }
  /// True when nothing more can be expected of the present list without waiting for another try of a failed
  /// one: every listed submap is on screen, missing, corrupt, unplaced, or has failed at least `tries` times.
  bool settled(int tries) const { return submaps_.settled(tries); }

  int slice() const { return submaps_.slice(); }
  void setSlice(int slice) { submaps_.setSlice(slice); }
  void setVisible(const std::vector<map::SubmapId>& ids, bool visible) { submaps_.setVisible(ids, visible); }
  /// What the user looks at, to fetch that first.
  void setView(const geometry::WorldRect& visible_world, const Eigen::Vector2d& center_m) {
    submaps_.setView(visible_world, center_m);
  }

  // Whole maps (session_maps.cpp).
  Catalogue& catalogue() { return catalogue_; }
  const Catalogue& catalogue() const { return catalogue_; }
  MapSlot& wholeMap() { return whole_map_; }
  const MapSlot& wholeMap() const { return whole_map_; }
  MapSlot& comparedMap() { return compared_map_; }
  const MapSlot& comparedMap() const { return compared_map_; }
  /// A coarse picture of the SLAM map, until every submap is in.
  const MapSlot& overview() const { return overview_; }
  const LayerGrids& layerGrids() const { return layer_grids_; }
  /// The map whose named places belong to what `slot` shows: it itself; of what the robot sends, the stored
  /// one that it works with. nullopt: that is not known, or it keeps none.
  std::optional<map::MapKey> placesOf(const MapSlot& slot) const;
  /// Shows a map without loading it on the robot. MapKind::Live: what the robot sends, from now on.
  void openMap(const map::MapKey& key);
  /// The second map of a comparison; nullopt ends it.
  void compareWith(std::optional<map::MapKey> key);
  /// The same with a map that is not of this robot: a file. Its key becomes one that the robot has not.
  void compareWith(map::WholeMap map);
  /// Keeps the map on screen as it is now as the second of a comparison, however it changes later.
  void keepForComparing();
  /// What `owner` (a layer list, a panel) wants of the robot: kinds of data, and topics by the robot's own
  /// names. Replaces what it wanted before.
  void want(const QString& owner, const map::Streams& streams, const QStringList& topics = {});

  /// What its caches hold: textures and unpacked tiles. Of the others it knows nothing.
  work::Budgets memory() const;

  /// Bounds of everything drawn and visible; while nothing is held, of the poses. Empty without submaps.
  geometry::WorldRect contentBounds() const { return submaps_.contentBounds(); }

 Q_SIGNALS:
  void connectionChanged();
  void identityChanged();
  /// Something of live(); `what` is the TopicMessage alternative that came (map::topicIndex). What the robot
  /// says again as it was is no change, but for the first message of its kind.
  void liveChanged(int what);
  /// The same for every message, after liveChanged(): for whoever waits for more than its content.
  void liveHeard(int what);
  void listChanged();  // submaps were added or removed, or the session is new
  /// The world's coordinates begin anew (see map::LiveState): much of live() is gone.
  void frameChanged();
  void sessionRestarted();  // new uuid: every picture is gone. Comes before listChanged()
  void submapsPlaced(
      const std::vector<mapwright::map::SubmapId>& ids);  // picture, pose, flags or visibility: draw again
  void submapsRemoved(const std::vector<mapwright::map::SubmapId>& ids);
  void sliceChanged();  // every picture: draw again
  void rowsChanged();   // some status or counter; coalesced to 10 times a second
  void rowsTouched(const mapwright::session::TouchedRows& rows);  // whose; comes before rowsChanged()
  void problemsChanged();                                         // coalesced likewise

 private:
  void takeTopic(const map::StampedMessage& stamped);
  void take(const map::StampedMessage& message);
  void tellProblems();
  void noteConnection();
  void countFetch(std::size_t body_bytes, bool from_cache);
  void wireMaps();
  void wireSubmaps();
  void wireSafety(bool log);
  void discardPicture(const std::string& fingerprint);
  /// `repeated`: the picture is the one of before.
  void takeGrid(const map::GridMessage& message, bool repeated = false);
  bool listensTo(const std::string& topic) const;
  void takeFrame();
  void forgetUnwanted();
  void openInto(MapSlot& slot, const map::MapKey& key);
  void askForPlaces(MapSlot& slot, const map::MapKey& key, std::function<bool()> still_wanted);
  std::optional<map::MapKey> placesOfLiveMap() const;
  void followLivePlaces();  // the places of the map that the robot sends
  void readLivePlacesAgain();
  void readPictureAgain(const map::MapKey& key);
  void openFirstMap();
  void retryMaps();  // those that could not be had
  void askForOverview();
  void sendWants();
  submap::Millis now() const { return monotonic_(); }
  double wallSeconds() const { return double(wall_().toMSecsSinceEpoch()) / 1000; }

  std::unique_ptr<robot::Robot> robot_;
  std::function<submap::Millis()> monotonic_;
  std::function<QDateTime()> wall_;
  grids::Means means_;
  map::World world_;
  map::LiveState& live_ = world_.live;
  SafetyWatch safety_;
  Submaps submaps_;
  ProblemLog problems_;
  std::optional<QDateTime> stale_since_;
  bool was_online_ = false;
  quint64 generation_ = 0;  // of SLAM sessions
  quint64 fetches_ = 0, cache_hits_ = 0, bytes_fetched_ = 0;
  bool overview_wanted_, submaps_wanted_, maps_by_itself_;
  bool still_ = false;
  std::set<std::size_t> heard_;                  // kinds of messages
  bool live_wanted_ = true;                      // the whole map on screen is the one that the robot sends
  bool map_chosen_ = false;                      // by the user
  std::optional<map::WholeMap> compared_aside_;  // the robot is not asked for it
  struct Wish {
    map::Streams streams;
    QStringList topics;
    bool operator==(const Wish&) const = default;
  };
  std::map<QString, Wish> wants_;
  Wish wanted_;                   // all of them together
  QSet<QString> retired_topics_;  // wanted once and no more: what still comes of them is not taken
  QStringList wanted_topics_;     // every topic that may come of it
  std::map<const MapSlot*, map::MapKey> live_places_;  // whose places were asked for last
  std::optional<submap::Millis> listed_at_;  // when the catalogue came last; nullopt when it failed since
  Catalogue catalogue_;
  MapSlot whole_map_, compared_map_, overview_;
  LayerGrids layer_grids_;
  QTimer problems_timer_, no_live_map_timer_;
};

}  // namespace mapwright::session
