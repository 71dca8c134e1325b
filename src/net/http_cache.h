// Answers kept on disk under HTTP's own rules: immutable, max-age, no-cache, no-store, ETag, 304 (RFC 9111).
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

/// A body with the headers that govern its reuse.
struct CachedAnswer {
  QByteArray body;
  QByteArray content_type;
  QByteArray etag;
  bool fresh = false;  // may be used without asking; otherwise ask with If-None-Match when there is an etag
};

/// A private cache in one folder, one file per URL, written atomically (a torn file reads as a miss and is
/// removed). Not thread-safe: owned by one thread; several processes may share the folder. It writes behind
/// (CacheWriter): what is stored, changed and removed here is seen here at once, and by others a moment
/// later. Never fails loudly: a full or read-only disk turns it into a cache that forgets, and lastError()
/// says why.
class HttpCache {
 public:
  using Now = std::function<QDateTime()>;
  using Trouble = std::function<void(const Fault& why)>;
  /// `budget_bytes` bounds the folder; the files used longest ago are removed first. `now` is called on the
  /// owner's thread, `write` on the writer's.
  HttpCache(QString folder, qint64 budget_bytes, Now now = &QDateTime::currentDateTimeUtc,
            WriteFile write = &writeWhole);
  /// Returns when what waits is on the disk; nobody is told any more when that fails.
  ~HttpCache();

  std::optional<CachedAnswer> find(const QUrl& url);
  /// Keeps the answer if its Cache-Control allows it. With neither Cache-Control nor ETag it is kept only
  /// when `content_addressed` (the URL names a version, so its body never changes), then as if immutable.
  /// Returns at once, unless the disk is very far behind (CacheWriter::kMostWaitingBytes).
  void store(const QUrl& url, const QByteArray& body, const QByteArray& content_type,
             const QByteArray& cache_control, const QByteArray& etag, bool content_addressed);
  /// A 304 came: the stored body is fresh again under these headers.
  void refresh(const QUrl& url, const QByteArray& cache_control, const QByteArray& etag);
  void remove(const QUrl& url);
  /// Keeps what is stored for `from` under `to` as well, with the same headers; nothing happens when it is
  /// not stored.
  void copy(const QUrl& from, const QUrl& to);

  /// Returns when the folder is as it was asked for, for whoever hands it on; trouble is told before.
  void flush();
  /// Of all files, after a flush().
  qint64 bytes();
  Fault lastError() const;
  /// Told once, the first time that something cannot be kept or removed: on the owner's thread, from its
  /// event loop or from flush() and bytes().
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
