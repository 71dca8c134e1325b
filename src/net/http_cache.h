// Answers kept on disk under HTTP's own rules: immutable, max-age, no-cache, no-store, ETag, 304 (RFC 9111).
#pragma once

#include <functional>
#include <optional>

#include <QByteArray>
#include <QDateTime>
#include <QHash>
#include <QString>
#include <QUrl>

#include "net/reason.h"

namespace mapwright::net {

/// A body with the headers that govern its reuse.
struct CachedAnswer {
  QByteArray body;
  QByteArray content_type;
  QByteArray etag;
  bool fresh = false;  // may be used without asking; otherwise ask with If-None-Match when there is an etag
};

/// A private cache in one folder, one file per URL, written atomically (a torn file reads as a miss and is
/// removed). Not thread-safe: owned by one thread; several processes may share the folder. Never fails
/// loudly: a full or read-only disk turns it into a cache that forgets, and lastError() says why.
class HttpCache {
 public:
  using Now = std::function<QDateTime()>;
  using Trouble = std::function<void(const Reason& why)>;
  /// `budget_bytes` bounds the folder; the files used longest ago are removed first.
  HttpCache(QString folder, qint64 budget_bytes, Now now = &QDateTime::currentDateTimeUtc);

  std::optional<CachedAnswer> find(const QUrl& url);
  /// Keeps the answer if its Cache-Control allows it. With neither Cache-Control nor ETag it is kept only
  /// when `content_addressed` (the URL names a version, so its body never changes), then as if immutable.
  void store(const QUrl& url, const QByteArray& body, const QByteArray& content_type,
             const QByteArray& cache_control, const QByteArray& etag, bool content_addressed);
  /// A 304 came: the stored body is fresh again under these headers.
  void refresh(const QUrl& url, const QByteArray& cache_control, const QByteArray& etag);
  void remove(const QUrl& url);
  /// Keeps what is stored for `from` under `to` as well, with the same headers; nothing happens when it is
  /// not stored.
  void copy(const QUrl& from, const QUrl& to);

  qint64 bytes() const;
  Reason lastError() const;
  /// Told once, the first time that something cannot be kept or removed.
  void setTrouble(Trouble trouble) { trouble_ = std::move(trouble); }
  QString folder() const { return folder_; }

 private:
  struct Entry {
    qint64 bytes = 0;
    qint64 last_use_ms = 0;  // since the epoch; the file's modification time carries it over restarts
  };
  struct Record;

  QString pathOf(const QByteArray& name) const;
  std::optional<Record> read(const QByteArray& name, const QUrl& url);
  void write(const QByteArray& name, const Record& record);
  void forget(const QByteArray& name);
  void scan() const;
  void evict(const QByteArray& keep);
  bool makeFolder(const QString& path);
  void fail(Reason what);

  QString folder_;
  qint64 budget_bytes_;
  Now now_;
  // What the folder holds, read when it is first needed and again now and then, for other processes write
  // there too.
  mutable QHash<QByteArray, Entry> index_;
  mutable qint64 bytes_ = -1;  // -1 = not read yet
  mutable int stores_since_scan_ = 0;
  Reason last_error_;
  Trouble trouble_;
};

}  // namespace mapwright::net
