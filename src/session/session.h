// One connected robot for the window and the command line: the live state, the submaps, the whole maps, the
// problems. A facade: session::Submaps handles the submaps. GUI-thread object.
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
#include "map/problem.h"
#include "map/stream.h"
#include "map/submap.h"
#include "robot/robot.h"
#include "session/catalogue.h"
#include "session/map_slot.h"
#include "session/pose_graph_slot.h"
#include "session/problem_log.h"
#include "session/safety_watch.h"
#include "session/submap_tally.h"
#include "work/budgets.h"

namespace mapwright::map {
struct GridMessage;
struct LiveState;
struct StampedMessage;
struct World;
}  // namespace mapwright::map
namespace mapwright::submap {
class SubmapStore;
}

namespace mapwright::session {

class LayerGrids;
class Submaps;

class Session : public QObject {
  Q_OBJECT
 public:
  struct Options;  // session/session_options.h
  /// Takes ownership of the robot; connect with open(). `monotonic` is the clock for all waits.
  Session(std::unique_ptr<robot::Robot> robot, Options options, QObject* parent = nullptr,
          std::function<std::chrono::milliseconds()> monotonic = {});
  ~Session() override;

  void open();
  void close();
  /// Freezes the state, whatever the robot sends, so that it can be drawn and reported consistently. Cannot
  /// be undone.
  void standStill();
  void retryNow();  // reconnect if necessary; repeat all requests that failed or had no result

  robot::Robot& robot() { return *robot_; }
  const robot::Robot& robot() const { return *robot_; }
  robot::ConnectionState connection() const { return robot_->connection(); }
  const map::LiveState& live() const { return live_; }
  /// Everything received from the robot.
  const map::World& world() const { return *world_; }
  /// When messages of a kind came, seconds since the epoch (of a replay: of the bag).
  struct Heard {
    QString topic;           // the robot's name for it; may be empty
    double last_s = 0;       // the last one
    double unchanged_s = 0;  // since when they say the same
  };
  /// `what` is the TopicMessage alternative. nullopt: none since the connection was made, or the world was
  /// replaced.
  std::optional<Heard> heard(int what) const;
  /// Replaces the world, as if its messages had arrived: for example the state of a recording at some time.
  /// Later messages apply to it. Not `whole`: missing parts may still be found, and the previous submaps stay
  /// until then.
  void reset(map::World world, bool whole = true);
  const submap::SubmapStore& submaps() const;
  const ProblemLog& problems() const { return problems_; }
  void clearProblems();
  /// Reports a problem or a recovery at `at` (default: now).
  void report(const map::Problem& problem, const QDateTime& at = {});
  void recover(const map::Recovery& recovery, const QDateTime& at = {});
  /// Conditions that people near the robot must know at once.
  const SafetyWatch& safety() const { return safety_; }
  /// When live messages stopped (connection lost); nullopt while online or if never online.
  std::optional<QDateTime> staleSince() const { return stale_since_; }

  SubmapCounts counts() const;
  /// Number of pictures of submaps that could not be read back. They are fetched again, unless everything is
  /// frozen.
  int lostPictures() const;
  SubmapStatus status(map::SubmapId id) const;
  /// Why it is Missing, Waiting, Corrupt or Unplaced; plain text.
  Fault reason(map::SubmapId id) const;
  /// True if nothing more can be expected of the present list without another retry: every listed submap is
  /// on screen, missing, corrupt, unplaced, or has failed at least `tries` times.
  bool settled(int tries) const;

  int slice() const;
  void setSlice(int slice);
  void setVisible(const std::vector<map::SubmapId>& ids, bool visible);
  /// The visible area, which is fetched first.
  void setView(const geometry::WorldRect& visible_world, const Eigen::Vector2d& center_m);

  // Whole maps (session_maps.cpp).
  Catalogue& catalogue() { return catalogue_; }
  const Catalogue& catalogue() const { return catalogue_; }
  MapSlot& wholeMap() { return whole_map_; }
  const MapSlot& wholeMap() const { return whole_map_; }
  MapSlot& comparedMap() { return compared_map_; }
  const MapSlot& comparedMap() const { return compared_map_; }
  /// A map that checks need and that is not on screen: readForChecks().
  const MapSlot& mapForChecks() const { return map_for_checks_; }
  /// Reads it unless it is there already; nullopt = none is needed any more. Not a live map.
  void readForChecks(const std::optional<map::MapKey>& key);
  /// A coarse picture of the SLAM map, until all submaps are loaded.
  const MapSlot& overview() const { return overview_; }
  const LayerGrids& layerGrids() const { return *layer_grids_; }
  /// How far the constraints of the SLAM session are from its map.
  PoseGraphSlot& poseGraph() { return pose_graph_; }
  const PoseGraphSlot& poseGraph() const { return pose_graph_; }
  /// The map whose waypoints belong to what `slot` shows: the map itself; for the live map, the stored one
  /// that the robot uses. nullopt: unknown, or there is none.
  std::optional<map::MapKey> placesOf(const MapSlot& slot) const;
  /// Shows a map without loading it on the robot. MapKind::Live: whatever the robot sends, from now on.
  void openMap(const map::MapKey& key);
  /// The second map of a comparison; nullopt ends it.
  void compareWith(std::optional<map::MapKey> key);
  /// The same with a map that is not of this robot: a file. Its key is changed to one that the robot does not
  /// have.
  void compareWith(map::WholeMap map);
  /// Keeps the present state of the map on screen as the second map of a comparison.
  void keepForComparing();
  /// What `owner` (a layer list, a panel) needs from the robot: kinds of data, and topics by name. Replaces
  /// its previous request.
  void want(const QString& owner, const map::Streams& streams, const QStringList& topics = {});

  /// Memory of its caches: textures and unpacked tiles; it does not know the others.
  work::Budgets memory() const;

  /// Bounds of everything drawn and visible; if nothing is loaded, of the poses. Empty without submaps.
  geometry::WorldRect contentBounds() const;

 Q_SIGNALS:
  void connectionChanged();
  void identityChanged();
  /// Part of live() has changed; `what` is the TopicMessage alternative (map::topicIndex). Repetitions are
  /// not changes, except for the first message of its kind.
  void liveChanged(int what);
  /// Emitted for every message, after liveChanged(): for listeners that wait for more than its content.
  void liveHeard(int what);
  void listChanged();  // submaps were added or removed, or the session is new
  /// The coordinate frame has changed (see map::LiveState): much of live() was dropped.
  void frameChanged();
  void sessionRestarted();  // new uuid: all pictures were dropped. Emitted before listChanged()
  void submapsPlaced(
      const std::vector<mapwright::map::SubmapId>& ids);  // picture, pose, flags or visibility: redraw
  void submapsRemoved(const std::vector<mapwright::map::SubmapId>& ids);
  void sliceChanged();  // every picture: draw again
  void rowsChanged();   // some status or counter; at most 10 times a second
  void rowsTouched(const mapwright::session::TouchedRows& rows);  // whose; comes before rowsChanged()
  void problemsChanged();                                         // coalesced likewise

 private:
  void onTopic(const map::StampedMessage& stamped);
  void onMessage(const map::StampedMessage& message);
  void reportProblems();
  void onConnection();
  void countFetch(std::size_t body_bytes, bool from_cache);
  void wireMaps();
  void wireSubmaps();
  void wireSafety(bool log);
  void discardPicture(const std::string& fingerprint);
  /// `repeated`: the picture is the same as before.
  void onGrid(const map::GridMessage& message, bool repeated = false);
  bool listensTo(const std::string& topic) const;
  void onFrame();
  void forgetUnwanted();
  void openInto(MapSlot& slot, const map::MapKey& key);
  void askForPlaces(MapSlot& slot, const map::MapKey& key, std::function<bool()> still_wanted);
  std::optional<map::MapKey> placesOfLiveMap() const;
  void followLivePlaces();  // the waypoints of the live map
  void readLivePlacesAgain();
  void readPictureAgain(const map::MapKey& key);
  /// Its source has changed. A map that is on its way is read to the end first: one that changes faster than
  /// it can be read would never be seen.
  void openAgain(MapSlot& slot);
  void openFirstMap();
  void retryMaps();  // those that failed
  void askForOverview();
  void sendWants();
  std::chrono::milliseconds now() const { return monotonic_(); }
  double wallSeconds() const { return double(wall_().toMSecsSinceEpoch()) / 1000; }

  std::unique_ptr<robot::Robot> robot_;
  std::function<std::chrono::milliseconds()> monotonic_;
  std::function<QDateTime()> wall_;
  const std::unique_ptr<const grids::Resources> resources_;
  const std::unique_ptr<map::World> world_;
  map::LiveState& live_;  // its
  SafetyWatch safety_;
  const std::unique_ptr<Submaps> submaps_;
  ProblemLog problems_;
  std::optional<QDateTime> stale_since_;
  bool was_online_ = false;
  quint64 generation_ = 0;  // of SLAM sessions
  quint64 fetches_ = 0, cache_hits_ = 0, bytes_fetched_ = 0;
  bool overview_wanted_, submaps_wanted_, maps_by_itself_;
  bool still_ = false;
  std::map<std::size_t, std::optional<Heard>> heard_;  // by kind; nullopt: in an earlier world
  bool live_wanted_ = true;                            // the whole map on screen is the live one
  bool map_chosen_ = false;                            // by the user
  std::optional<map::WholeMap> compared_aside_;        // not requested from the robot
  struct Subscription {
    map::Streams streams;
    QStringList topics;
    bool operator==(const Subscription&) const = default;
  };
  std::map<QString, Subscription> wants_;
  Subscription wanted_;                // all of them together
  QSet<QString> retired_topics_;       // no longer wanted: messages still arriving are ignored
  QStringList wanted_topics_;          // all topics that may carry it
  std::set<const MapSlot*> outdated_;  // their source has changed since
  std::map<const MapSlot*, map::MapKey> live_places_;  // whose waypoints were requested last
  std::optional<std::chrono::milliseconds>
      listed_at_;  // when the catalogue last arrived; nullopt if it failed since
  Catalogue catalogue_;
  MapSlot whole_map_, compared_map_, map_for_checks_, overview_;
  const std::unique_ptr<LayerGrids> layer_grids_;
  PoseGraphSlot pose_graph_;
  QTimer problems_timer_, no_live_map_timer_;
};

}  // namespace mapwright::session
