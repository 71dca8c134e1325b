// The submaps of one robot: lists, fetches, decodes, places and counts them. Part of the session; GUI-thread
// object. Decoding, and comparing long lists, uses the thread pool
// (docs/decisions/0008-one-pool-of-threads-one-budget.md).
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include <QObject>
#include <QString>
#include <QTimer>

#include "geometry/rect.h"
#include "robot/robot.h"
#include "session/submap_tally.h"
#include "submap/fetch_scheduler.h"
#include "submap/submap_store.h"
#include "work/workers.h"

namespace mapwright::cells {
class TextureStore;
}

namespace mapwright::session {

/// Only restarts, a new choice of slice and user actions on many submaps cost more with more submaps: lists
/// are compared for differences, counters are updated.
class Submaps : public QObject {
  Q_OBJECT
 public:
  struct Options {
    submap::SchedulerOptions scheduler;
    std::shared_ptr<work::Workers> workers = {};         // null = a thread pool of its own
    std::size_t texture_bytes = std::size_t(256) << 20;  // in memory; the others wait on disk
    std::string texture_folder = {};  // for their file; empty = the system's folder for temporary files
  };
  /// `source` returns the source of submaps, null while there is none.
  Submaps(std::function<robot::SubmapSource*()> source, const Options& options,
          std::function<submap::Millis()> monotonic, QObject* parent = nullptr);
  ~Submaps() override;

  /// A list arrived. Its changes are visible at once or, if it is long, as soon as it has been compared.
  void onList(const map::SubmapList& list);
  /// There is none, as before the first one: drops everything from it.
  void forgetList();
  /// Requests nothing new while offline: the list may belong to another session.
  void setOnline(bool online);
  void retryNow();
  /// Freezes everything. Cannot be undone.
  void standStill();

  const submap::SubmapStore& store() const { return store_; }
  /// Without network traffic.
  SubmapCounts counts() const;
  /// How many pictures the store has lost that have not been reloaded.
  int lost() const { return int(lost_.size()); }
  std::size_t textureBytes() const;
  SubmapStatus status(map::SubmapId id) const;
  Fault reason(map::SubmapId id) const;
  bool settled(int tries) const;
  geometry::WorldRect contentBounds() const { return tally_.contentBounds(); }

  int slice() const { return slice_; }
  void setSlice(int slice);
  void setVisible(const std::vector<map::SubmapId>& ids, bool visible);
  void setView(const geometry::WorldRect& visible_world, const Eigen::Vector2d& center_m);
  /// Schedules touched(), even if no row looks different.
  void notifySoon();

 Q_SIGNALS:
  void restarted();    // a new SLAM session: all pictures were dropped. Emitted first
  void listChanged();  // submaps were added or removed, or the session is new
  void placed(const std::vector<mapwright::map::SubmapId>& ids);
  void removed(const std::vector<mapwright::map::SubmapId>& ids);
  void listTaken(bool new_session);  // a list arrived, and all its changes have been signalled
  void sliceChanged();
  /// At most 10 times a second, and when submaps are added or removed: then before listChanged().
  void touched(const mapwright::session::TouchedRows& rows);
  void problemFound(const mapwright::map::Problem& problem);
  void recovered(const mapwright::map::Recovery& recovery);
  void bodyCame(std::size_t body_bytes, bool from_cache);

 private:
  struct Decoded {
    quint64 generation = 0;
    bool from_cache = false;
    submap::DecodedSubmap submap;
  };
  void compareNext();
  void applyDifference(const submap::ListDifference& difference);
  /// `first`: from the very first list.
  void adopt(const submap::SubmapChange& change, bool first);
  void publish(const submap::SubmapChange& change);
  void pump();
  void onAnswer(map::SubmapAnswer answer);
  void decode(map::SubmapAnswer answer);
  void onDecoded();
  void addDecoded(Decoded decoded, submap::SubmapChange& change);
  /// It cannot be decoded.
  void discard(const map::SubmapKey& key, std::int32_t answered_version, bool from_cache);
  /// The store lost the picture: fetches it again.
  void lose(map::SubmapId id);
  /// Something about the submap has changed: its row, its position in the queue, the counters.
  void refreshRow(map::SubmapId id);
  void reportAllChanged();
  void notifyNow();

  std::function<robot::SubmapSource*()> source_;
  std::function<submap::Millis()> monotonic_;
  submap::SubmapStore store_;
  submap::FetchScheduler scheduler_;
  SubmapTally tally_;
  std::unordered_map<map::SubmapId, Fault> failure_reasons_;
  std::unordered_map<map::SubmapId, int> decoding_;
  std::set<map::SubmapId> lost_;
  std::unordered_map<map::SubmapId, std::int32_t>
      asked_again_;                           // the version requested again after it could not be decoded
  std::size_t decodes_ = 0;                   // in progress
  std::optional<map::SubmapList> next_list_;  // waits to be compared
  bool comparing_ = false;
  quint64 comparison_ = 0;  // results with another number are outdated
  bool online_ = false, still_ = false;
  qint64 still_bytes_ = 0;  // memory of textures when it was frozen
  int slice_ = 0;
  quint64 generation_ = 0;
  TouchedRows touched_;
  QTimer wake_timer_, touched_timer_;
  std::mutex decoded_mutex_;
  std::vector<Decoded> decoded_;  // guarded by decoded_mutex_
  std::shared_ptr<cells::TextureStore> textures_;
  work::Tasks tasks_;  // after everything that its jobs use
};

}  // namespace mapwright::session
