// The files of the HTTP cache: one per answer, whole or not at all, the longest unused removed first.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>

#include <QByteArray>
#include <QHash>
#include <QString>

#include "net/faults.h"

namespace mapwright::net {

/// An answer as it is kept. Copies share the body.
struct CacheRecord {
  QByteArray url;  // without user, password and fragment
  QByteArray content_type;
  QByteArray etag;
  qint64 stored_ms = 0;  // since the epoch
  qint64 fresh_s = 0;    // kForever, or seconds from stored_ms on
  QByteArray body;
};

inline constexpr qint64 kForever = -1;

/// How many bytes the file of `record` has.
qint64 fileBytes(const CacheRecord& record);

/// Writes a file whole or not at all, with `now_ms` (since the epoch) as its time, for this user alone. The
/// result is an errno, 0 = it is in its place. Not QSaveFile: that waits for the disk at every file, and the
/// checksum in it already tells a file that a power cut has torn.
using WriteFile =
    std::function<int(const std::string& path, const std::array<QByteArray, 3>& parts, qint64 now_ms)>;
int writeWhole(const std::string& path, const std::array<QByteArray, 3>& parts, qint64 now_ms);

/// The folder and what is known of its files. Other processes may use it at the same time. read() and
/// pathOf() on any thread, the others on one at a time. A Fault without a code says that all is well.
class CacheFolder {
 public:
  /// `budget_bytes` bounds the folder.
  CacheFolder(QString folder, qint64 budget_bytes, WriteFile write);

  QString path() const { return folder_; }
  qint64 budgetBytes() const { return budget_bytes_; }

  struct Read {
    std::optional<CacheRecord> record;
    bool broken = false;  // something lies there, and it is not what was kept for that address
  };
  /// What lies under `name` for the address `url`; `now_ms` becomes the time of its last use.
  Read read(const QByteArray& name, const QByteArray& url, qint64 now_ms) const;

  /// At most budgetBytes() long (fileBytes). Makes room.
  Fault keep(const QByteArray& name, const CacheRecord& record, qint64 now_ms);
  Fault remove(const QByteArray& name);
  /// Of all files.
  qint64 bytes();

 private:
  QString pathOf(const QByteArray& name) const;
  Fault makeFolder(const QString& path) const;
  void scan();
  Fault evict(const QByteArray& keep);

  struct Entry {
    qint64 bytes = 0;
    qint64 last_use_ms = 0;  // since the epoch; the file's modification time carries it over restarts
  };

  const QString folder_;
  const qint64 budget_bytes_;
  const WriteFile write_;
  // What the folder holds, read when it is first needed and again now and then, for other processes write
  // there too.
  QHash<QByteArray, Entry> index_;
  qint64 bytes_ = -1;  // -1 = not read yet
  int stores_since_scan_ = 0;
};

}  // namespace mapwright::net
