// One connected robot as the window and the command line see it: the live state, the submaps, their fetches,
// the problems. Ties the robot port to the submap cache. GUI-thread object; decoding runs on a pool
// (architecture, decision 4).
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
#include <QThreadPool>
#include <QTimer>

#include "geometry/rect.h"
#include "map/live_state.h"
#include "robot/robot.h"
#include "session/catalogue.h"
#include "session/layer_grids.h"
#include "session/map_slot.h"
#include "session/problem_log.h"
#include "session/safety_watch.h"
#include "submap/fetch_scheduler.h"
#include "submap/submap_book.h"

namespace mapwright::session {

/// How one submap stands, for a row of the inspector.
enum class SubmapStatus {
  OnScreen,  // the listed version is held and drawn (or would be, were it visible)
  Updating,  // an older version is on screen, the listed one is queued or being fetched
  Queued,
  Fetching,
  NoSlice,   // held, but it has no slice of the chosen number
  Missing,   // 404
  Waiting,   // failed; will be tried again
  Corrupt,   // came, but cannot be drawn
  Unplaced,  // no usable pose
};

/// Counters over all listed submaps. shown + pending + without_slice + missing + failed + corrupt == listed.
struct SubmapCounts {
  bool list_received = false;
  int listed = 0;
  int shown = 0;    // have a drawable chosen slice (OnScreen, or an older version while Updating)
  int pending = 0;  // nothing held yet: queued, being fetched or being decoded
  int without_slice = 0;
  int missing = 0;
  int failed = 0;    // waiting for another try, nothing held
  int corrupt = 0;   // corrupt chosen slice, or no usable pose
  int hidden = 0;    // by the user's choice (independent of the above)
  int updating = 0;  // a newer version than the one on screen is on its way
  int trajectories = 0;
  int fetching = 0, queued = 0;  // fetch work
  qint64 texture_bytes = 0;
  quint64 fetches = 0;        // submaps and pictures whose body travelled over the network
  quint64 cache_hits = 0;     // those whose body was on disk
  quint64 bytes_fetched = 0;  // of the bodies that travelled
  bool operator==(const SubmapCounts&) const = default;
};

class Session : public QObject {
  Q_OBJECT
 public:
  struct Options {
    submap::SchedulerOptions scheduler;
    int decode_threads = 0;       // 0 = one per core
    QString sidecar_folder = {};  // finished pyramids of large maps are kept there; empty = nowhere
    bool overview = true;         // ask for a picture of the whole SLAM map while submaps are still loading
    /// What the robot is asked for without a wish of anybody. Without `submaps` none is listed or fetched.
    robot::LiveTopics::Basics basics = {};
    bool maps = true;         // the catalogue is asked for and the first whole map opened without being told
    bool log_safety = false;  // what is wrong with the robot itself is a problem, too
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
  const submap::SubmapBook& book() const { return book_; }
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
  SubmapStatus status(map::SubmapId id) const;
  QString reason(map::SubmapId id) const;  // why Missing, Waiting, Corrupt or Unplaced; plain text
  /// True when nothing more can be expected of the present list without waiting for another try of a failed
  /// one: every listed submap is on screen, missing, corrupt, unplaced, or has failed at least `tries` times.
  bool settled(int tries) const;

  int slice() const { return slice_; }
  void setSlice(int slice);
  void setVisible(const std::vector<map::SubmapId>& ids, bool visible);
  /// What the user looks at, to fetch that first.
  void setView(const geometry::WorldRect& visible_world, const Eigen::Vector2d& center_m);

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
  /// Shows a map without loading it on the robot. MapKind::Live: what the robot sends, from now on.
  void openMap(const map::MapKey& key);
  /// The second map of a comparison; nullopt ends it.
  void compareWith(std::optional<map::MapKey> key);
  /// Keeps the map on screen as it is now as the second of a comparison, however it changes later.
  void keepForComparing();
  /// Topics that `owner` (a layer list, a panel) wants; replaces what it wanted before.
  void want(const QString& owner, const QStringList& topics);

  /// Bounds of everything drawn and visible; while nothing is held, of the poses. Empty without submaps.
  geometry::WorldRect contentBounds() const;

 Q_SIGNALS:
  void connectionChanged();
  void identityChanged();
  /// Something of live(); `what` is the TopicMessage alternative that came (map::topicIndex).
  void liveChanged(int what);
  void listChanged();  // submaps were added or removed, or the session is new
  /// The world's coordinates begin anew (see map::LiveState): much of live() is gone.
  void frameChanged();
  void sessionRestarted();  // new uuid: every picture is gone. Comes before listChanged()
  void submapsPlaced(
      const std::vector<mapwright::map::SubmapId>& ids);  // picture, pose, flags or visibility: draw again
  void submapsRemoved(const std::vector<mapwright::map::SubmapId>& ids);
  void sliceChanged();     // every picture: draw again
  void rowsChanged();      // some status or counter; coalesced to 10 times a second
  void problemsChanged();  // coalesced likewise

 private:
  void takeTopic(const map::TopicMessage& message);
  void takeList(const map::SubmapList& list);
  void takeAnswer(map::SubmapAnswer answer);
  void takeDecoded(submap::DecodedSubmap decoded, bool from_cache);
  /// It cannot be decoded.
  void discard(const map::SubmapKey& key, std::int32_t answered_version, bool from_cache);
  void tellProblems();
  void publish(const submap::BookChange& change);
  void pump();
  void noteConnection();
  double priorityOf(map::SubmapId id) const;
  void touchRows();
  void countFetch(std::size_t body_bytes, bool from_cache);
  void wireMaps();
  void wireSafety(bool log);
  void discardPicture(const std::string& fingerprint);
  void takeGrid(const map::GridMessage& message);
  bool listensTo(const std::string& topic) const;
  void takeFrame();
  void forgetUnwanted();
  void openInto(MapSlot& slot, const map::MapKey& key);
  void openFirstMap();
  void retryMaps();  // those that could not be had
  void askForOverview();
  void sendWants();
  submap::Millis now() const { return monotonic_(); }

  std::unique_ptr<robot::Robot> robot_;
  std::function<submap::Millis()> monotonic_;
  map::LiveState live_;
  SafetyWatch safety_;
  submap::SubmapBook book_;
  submap::FetchScheduler scheduler_;
  ProblemLog problems_;
  std::unordered_map<map::SubmapId, std::string> failure_reasons_;
  std::unordered_map<map::SubmapId, int> decoding_;
  std::unordered_map<map::SubmapId, std::int32_t> asked_again_;  // the version, after it could not be decoded
  std::optional<QDateTime> stale_since_;
  bool was_online_ = false;
  int slice_ = 0;
  geometry::WorldRect view_;
  Eigen::Vector2d view_center_{0, 0};
  quint64 generation_ = 0;
  quint64 fetches_ = 0, cache_hits_ = 0, bytes_fetched_ = 0;
  bool overview_wanted_, submaps_wanted_, maps_by_itself_;
  bool still_ = false;
  bool live_wanted_ = true;  // the whole map on screen is the one that the robot sends
  bool map_chosen_ = false;  // by the user
  std::map<QString, QStringList> wants_;
  QSet<QString> retired_topics_;  // wanted once and no more: what still comes of them is not taken
  QStringList wanted_topics_;     // all of them together
  std::set<QString> waited_for_;  // topics that gave nothing in time: their older names are tried too
  std::optional<submap::Millis> listed_at_;  // when the catalogue came last; nullopt when it failed since
  Catalogue catalogue_;
  MapSlot whole_map_, compared_map_, overview_;
  LayerGrids layer_grids_;
  QThreadPool decode_pool_;
  QTimer wake_timer_, rows_timer_, problems_timer_, fallback_timer_, no_live_map_timer_;
};

}  // namespace mapwright::session
