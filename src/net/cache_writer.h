// What the HTTP cache is about to write, on its way to the disk: a card or a slow file system holds nobody
// up.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include <QByteArray>
#include <QHash>
#include <QThread>

#include "net/cache_folder.h"
#include "net/faults.h"

namespace mapwright::net {

/// Changes a CacheFolder on a thread of its own, which is made when there is something to do. What concerns
/// one name happens in the order in which it was asked for; of what still waits for a name only the last
/// counts. Owned by one thread.
class CacheWriter {
 public:
  /// Whoever asks to keep more than that at once waits, unless nothing else does.
  static constexpr qint64 kMostWaitingBytes = qint64(64) << 20;

  /// What has been asked for and is not done.
  struct Errand {
    std::optional<CacheRecord> record;  // nullopt = what lies there is removed
    qint64 now_ms = 0;                  // since the epoch, when it was asked for
  };

  /// `folder` outlives it and is left alone by others, but for what may be done on any thread. `failed` is
  /// called on the writer's thread.
  CacheWriter(CacheFolder& folder, std::function<void(const Fault& why)> failed);
  /// Does what waits.
  ~CacheWriter();
  CacheWriter(const CacheWriter&) = delete;
  CacheWriter& operator=(const CacheWriter&) = delete;

  void keep(const QByteArray& name, CacheRecord record, qint64 now_ms);
  void remove(const QByteArray& name);
  /// The last errand for `name` that is not done.
  std::optional<Errand> waiting(const QByteArray& name) const;
  /// Returns when all is done that was asked for; `failed` has been called by then.
  void flush();

 private:
  void ask(const QByteArray& name, Errand errand);
  void work();

  CacheFolder& folder_;
  const std::function<void(const Fault& why)> failed_;
  mutable std::mutex mutex_;
  std::condition_variable asked_, done_;
  QHash<QByteArray, Errand> errands_;  // by name
  std::deque<QByteArray> order_;       // the names of them
  QByteArray name_under_way_;          // empty = none
  std::optional<Errand> under_way_;    // read by both threads, changed by the writer under the lock
  qint64 waiting_bytes_ = 0;           // of all these
  bool closing_ = false;
  std::unique_ptr<QThread> thread_;
};

}  // namespace mapwright::net
