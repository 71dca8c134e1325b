// Pending writes of the HTTP cache: a slow disk or SD card blocks nobody.
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

/// Changes a CacheFolder on a thread of its own, created on demand. Requests for one name are done in order;
/// of those still waiting only the last counts. Owned by one thread.
class CacheWriter {
 public:
  /// A store beyond this much waiting data blocks, unless it is the only one.
  static constexpr qint64 kMostWaitingBytes = qint64(64) << 20;

  /// A request that is not done yet.
  struct Errand {
    std::optional<CacheRecord> record;  // nullopt = remove the file
    qint64 now_ms = 0;                  // since the epoch, when it was requested
  };

  /// `folder` must outlive it and must not be used otherwise, except for what any thread may do. `failed` is
  /// called on the writer's thread.
  CacheWriter(CacheFolder& folder, std::function<void(const Fault& why)> failed);
  /// Does what waits.
  ~CacheWriter();
  CacheWriter(const CacheWriter&) = delete;
  CacheWriter& operator=(const CacheWriter&) = delete;

  void keep(const QByteArray& name, CacheRecord record, qint64 now_ms);
  void remove(const QByteArray& name);
  /// The last pending request for `name`.
  std::optional<Errand> waiting(const QByteArray& name) const;
  /// Returns when all requests are done; `failed` has been called by then.
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
