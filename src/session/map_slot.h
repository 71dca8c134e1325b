// One whole map, loading or on screen: read off the GUI thread, and visible while it loads.
#pragma once

#include <atomic>
#include <memory>
#include <optional>

#include <QObject>
#include <QString>

#include "map/catalogue.h"
#include "map/waypoint.h"
#include "work/workers.h"

namespace mapwright::grids {
class GridPyramid;
struct GridOptions;
struct Resources;
}  // namespace mapwright::grids

namespace mapwright::session {

/// GUI-thread object; pictures are read on a thread of their own
/// (docs/decisions/0008-one-pool-of-threads-one-budget.md).
class MapSlot : public QObject {
  Q_OBJECT
 public:
  enum class Phase { Empty, Fetching, Reading, Ready, Failed };

  /// Smaller pictures are read as fast as a side-car is opened.
  static constexpr std::int64_t kLargeCells = 4'000'000;

  /// `sidecar_folder`: cache for finished pyramids of large pictures; empty = none. Live maps are not cached:
  /// the next one replaces them, and they would displace useful ones.
  MapSlot(QString sidecar_folder, const grids::Resources& resources, QObject* parent = nullptr);
  ~MapSlot() override;

  /// The map is being fetched; what is shown stays.
  void expect(const map::MapKey& key, const QString& name);
  /// Reads and shows `map`; a newer version of the map that is being read waits until that is done. A map
  /// with the same key stays on screen until the new picture is complete; one with another key, until its
  /// header is read.
  void show(map::WholeMap map);
  /// It cannot be loaded. A shown map with the same key stays.
  void fail(map::Problem problem);
  void clear();
  /// Freezes what is shown: reading stops, and later data is ignored.
  void standStill();
  /// Whether coarser levels show the average of their cells; if not, occupied ones win. Reads the picture
  /// again.
  void setAveraged(bool averaged);

  Phase phase() const { return phase_; }
  /// Read to the end (or until it failed), or there is nothing to read.
  bool settled() const { return phase_ != Phase::Fetching && phase_ != Phase::Reading; }
  /// The picture is truncated or could not be read completely: part of it is missing.
  bool broken() const;
  /// The picture on screen was read to its end, and no part of it is missing. Of one that breaks off the
  /// rest is unknown, and cells() is complete() all the same.
  bool isWhole() const;
  double progress() const;  // 0..1 of the rows, while Reading
  /// What was requested last, and what is on screen (they differ while one replaces the other).
  const map::MapKey& key() const { return key_; }
  QString name() const { return name_; }
  /// Why it is Failed, or a warning about a Ready one; nullopt = nothing.
  const std::optional<map::Problem>& remark() const { return remark_; }
  map::FailureKind failure() const { return failure_; }  // if it is Failed

  std::shared_ptr<const grids::GridPyramid> cells() const { return shown_cells_; }
  /// Width and height are the picture's own. Only valid if cells() is not null.
  const map::GridReference& reference() const { return shown_.grid; }
  /// The data that came with the picture on screen (trajectories, landmarks, overlays); `bytes` and `cells`
  /// are not kept.
  const map::WholeMap& shown() const { return shown_; }
  /// It shows an earlier state of a map (Session::keepForComparing).
  bool showsEarlierState() const { return cells() && shown_.state_of.has_value(); }

  /// The map on screen as received, to show it elsewhere; nullopt if there is none.
  const std::optional<map::WholeMap>& source() const { return shown_source_; }

  /// The waypoints of the shown map, if the robot has them. Those of a map that is still loading wait for it.
  const map::WaypointList& waypoints() const { return waypoints_; }
  void setWaypoints(map::WaypointList waypoints);
  /// They were requested, and have neither arrived nor failed yet.
  bool waypointsAwaited() const { return waypoints_awaited_; }
  void awaitWaypoints(bool awaited) { waypoints_awaited_ = awaited; }

 Q_SIGNALS:
  void changed();      // phase, name, cells, reference, waypoints
  void rowsArrived();  // more of cells()
  void problemFound(const mapwright::map::Problem& problem);
  void recovered(const mapwright::map::Recovery& recovery);
  /// Its picture cannot be read completely.
  void unreadable(const std::string& fingerprint);

 private:
  struct Opened;
  struct Listener;
  void start();
  static std::shared_ptr<Opened> open(const map::WholeMap& map, const grids::GridOptions& options,
                                      quint64 generation);
  void onDamage(quint64 generation, bool mended);
  void onOpened(quint64 generation, const std::shared_ptr<Opened>& opened);
  void onRows(quint64 generation);
  void onEnd(quint64 generation, const std::optional<Fault>& error);
  void put(const std::shared_ptr<Opened>& opened, bool whole);
  void cancel();
  map::Subject subject() const;

  QString sidecar_folder_;
  bool averaged_ = false;
  Phase phase_ = Phase::Empty;
  map::MapKey key_;
  QString name_;
  std::optional<map::Problem> remark_;
  map::FailureKind failure_ = map::FailureKind::None;
  std::optional<map::WholeMap> source_;  // to read it again
  std::optional<map::WholeMap> next_;    // a newer version of the map that is being read
  map::WholeMap shown_;
  std::optional<map::WholeMap> shown_source_;  // with its bytes
  std::shared_ptr<const grids::GridPyramid> shown_cells_;
  map::WaypointList waypoints_;
  std::optional<map::WaypointList> coming_waypoints_;  // for the map that is loading
  std::shared_ptr<Opened> reading_;                    // opened, not on screen yet or still growing
  std::shared_ptr<std::atomic<bool>> cancelled_;
  quint64 generation_ = 0;
  quint64 shown_generation_ = 0;        // of the map on screen
  std::shared_ptr<Listener> listener_;  // pyramids may outlive the slot
  bool broken_ = false, waypoints_awaited_ = false;
  bool shown_whole_ = false;  // isWhole(), but for its file
  bool cache_told_ = false;   // reported that nothing can be cached on disk
  const std::unique_ptr<const grids::Resources> resources_;
  work::Tasks tasks_;
};

}  // namespace mapwright::session
