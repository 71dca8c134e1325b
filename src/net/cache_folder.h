// The files of the HTTP cache: one per answer, complete or absent, least recently used removed first.
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

/// A stored answer. Copies share the body.
struct CacheRecord {
  QByteArray url;  // without user, password and fragment
  QByteArray content_type;
  QByteArray etag;
  qint64 stored_ms = 0;  // since the epoch
  qint64 fresh_s = 0;    // kForever, or seconds from stored_ms on
  QByteArray body;
};

inline constexpr qint64 kForever = -1;

/// The file size of `record` in bytes.
qint64 fileBytes(const CacheRecord& record);

/// Writes a file completely or not at all, with `now_ms` (since the epoch) as its time, readable only by this
/// user. Returns an errno, 0 = success. Not QSaveFile: that waits for the disk at every file, while the
/// checksum inside already detects a file torn by a power cut.
using WriteFile =
    std::function<int(const std::string& path, const std::array<QByteArray, 3>& parts, qint64 now_ms)>;
int writeWhole(const std::string& path, const std::array<QByteArray, 3>& parts, qint64 now_ms);

/// The folder and an index of its files. Other processes may use it at the same time. read() and pathOf() may
/// be called on any thread, the others on one at a time. A Fault without a code means success.
class CacheFolder {
 public:
  /// `budget_bytes` limits the folder's size.
  CacheFolder(QString folder, qint64 budget_bytes, WriteFile write);

  QString path() const { return folder_; }
  qint64 budgetBytes() const { return budget_bytes_; }

  struct Read {
    std::optional<CacheRecord> record;
    bool broken = false;  // there is a file, but it is not the answer for that address
  };
  /// Reads the file `name` for the address `url` and sets its last use to `now_ms`.
  Read read(const QByteArray& name, const QByteArray& url, qint64 now_ms) const;

  /// At most budgetBytes() long (fileBytes). Removes others if needed.
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
    qint64 last_use_ms = 0;  // since the epoch; stored as the file's modification time
  };

  const QString folder_;
  const qint64 budget_bytes_;
  const WriteFile write_;
  // The folder's content, read on first use and again now and then, since other processes write there, too.
  QHash<QByteArray, Entry> index_;
  qint64 bytes_ = -1;  // -1 = not read yet
  int stores_since_scan_ = 0;
};

}  // namespace mapwright::net
