// An HTTP cache on disk: immutable, max-age, no-cache, no-store, ETag, 304 (RFC 9111).
#pragma once

#include <functional>
#include <mutex>
#include <optional>

#include <QByteArray>
#include <QDateTime>
#include <QObject>
#include <QString>
#include <QUrl>

#include "net/cache_folder.h"
#include "net/cache_writer.h"
#include "net/faults.h"

namespace mapwright::net {

/// A body with the headers that control its reuse.
struct CachedAnswer {
  QByteArray body;
  QByteArray content_type;
  QByteArray etag;
  bool fresh =
      false;  // may be used without asking; otherwise revalidate with If-None-Match if there is an etag
};

/// A private cache in one folder, one file per URL, written atomically (a torn file counts as a miss and is
/// removed). Not thread-safe: owned by one thread; several processes may share the folder. It writes in the
/// background (CacheWriter): changes are visible here at once, and to others a moment later. It never fails:
/// with a full or read-only disk it forgets, and lastError() says why.
class HttpCache {
 public:
  using Now = std::function<QDateTime()>;
  using Trouble = std::function<void(const Fault& why)>;
  /// `budget_bytes` limits the folder; the least recently used files are removed first. `now` is called on
  /// the owner's thread, `write` on the writer's.
  HttpCache(QString folder, qint64 budget_bytes, Now now = &QDateTime::currentDateTimeUtc,
            WriteFile write = &writeWhole);
  /// Waits for pending writes; failures are no longer reported.
  ~HttpCache();

  std::optional<CachedAnswer> find(const QUrl& url);
  /// Stores the answer if its Cache-Control allows it. Without Cache-Control and ETag it is only stored if
  /// `content_addressed` (the URL contains a version, so its body never changes), and then as immutable.
  /// Returns at once, unless the disk is very far behind (CacheWriter::kMostWaitingBytes).
  void store(const QUrl& url, const QByteArray& body, const QByteArray& content_type,
             const QByteArray& cache_control, const QByteArray& etag, bool content_addressed);
  /// After a 304: the stored body is fresh again under these headers.
  void refresh(const QUrl& url, const QByteArray& cache_control, const QByteArray& etag);
  void remove(const QUrl& url);
  /// Stores the answer of `from` under `to` as well, with the same headers; does nothing if there is none.
  void copy(const QUrl& from, const QUrl& to);

  /// Returns when all changes are on disk; problems are reported before.
  void flush();
  /// Of all files, after a flush().
  qint64 bytes();
  Fault lastError() const;
  /// Called once, the first time something cannot be stored or removed: on the owner's thread, from its event
  /// loop or from flush() and bytes().
  void setTrouble(Trouble trouble) { trouble_ = std::move(trouble); }
  QString folder() const { return folder_.path(); }

 private:
  std::optional<CacheRecord> read(const QByteArray& name, const QUrl& url);
  void keep(const QByteArray& name, CacheRecord record);
  void noteFailure(const Fault& why);  // on the writer's thread
  void tell();

  const Now now_;
  Trouble trouble_;
  mutable std::mutex mutex_;  // of the two below
  Fault last_error_;
  std::optional<Fault> untold_;
  QObject here_;  // the owner's thread
  CacheFolder folder_;
  CacheWriter writer_;  // goes first
};

}  // namespace mapwright::net
