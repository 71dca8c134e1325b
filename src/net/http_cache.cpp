#include "net/http_cache.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>
#include <vector>

#include <QCryptographicHash>
#include <QDataStream>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QtEndian>
#include <libdeflate.h>

#include "disk/read_file.h"
#include "net/cache_control.h"

namespace mapwright::net {

namespace {

constexpr char kMagic[] = "MWCACHE2";
constexpr qsizetype kMagicBytes = 8;
constexpr qsizetype kChecksumBytes = 4;  // CRC-32: tells what is torn, as fast as the bytes can be read
constexpr qint64 kForever = -1;
constexpr int kStoresBetweenScans = 512;  // or as many as there are files, where there are more
constexpr qint64 kUnfinishedMs =
    3600 * 1000;  // a file that another process began to write this long ago is a left-over
constexpr qint64 kTouchEveryMs = 60 * 1000;
constexpr QFileDevice::Permissions kPrivateFolder =
    QFileDevice::ReadOwner | QFileDevice::WriteOwner | QFileDevice::ExeOwner;
const QLatin1String kSuffix(".answer");

QByteArray keyOf(const QUrl& url) { return url.toEncoded(QUrl::RemoveFragment | QUrl::RemoveUserInfo); }

QByteArray checksumOf(const QByteArray& content) {
  const std::uint32_t sum = libdeflate_crc32(0, content.constData(), std::size_t(content.size()));
  QByteArray bytes(kChecksumBytes, Qt::Uninitialized);
  qToBigEndian(sum, bytes.data());
  return bytes;
}

/// Written whole or not at all. Not QSaveFile: it waits for the disk at every file, and the checksum already
/// tells a file that a power cut has torn. The error is errno.
int writeWhole(const std::string& path, const std::array<QByteArray, 3>& parts, qint64 now_ms) {
  std::string aside = path + ".XXXXXX";
  const int file = ::mkostemp(aside.data(), O_CLOEXEC);  // for this user alone
  if (file < 0) return errno;
  int failure = 0;
  for (const QByteArray& part : parts) {
    for (qsizetype at = 0; at < part.size() && failure == 0;) {
      const ssize_t written = ::write(file, part.constData() + at, std::size_t(part.size() - at));
      if (written < 0 && errno != EINTR) failure = errno;
      if (written > 0) at += written;
    }
  }
  const timespec now{time_t(now_ms / 1000), long(now_ms % 1000) * 1'000'000};
  const std::array<timespec, 2> times{now, now};
  if (failure == 0 && ::futimens(file, times.data()) != 0) failure = errno;
  if (::close(file) != 0 && failure == 0) failure = errno;
  if (failure == 0 && std::rename(aside.c_str(), path.c_str()) != 0) failure = errno;
  if (failure != 0) ::unlink(aside.c_str());
  return failure;
}

/// The time of last use is the file's own, so that it outlives the program. It is not written at every use.
void touch(const std::string& path, qint64 now_ms) {
  struct stat about {};
  if (::lstat(path.c_str(), &about) != 0) return;
  const qint64 before_ms = qint64(about.st_mtim.tv_sec) * 1000 + about.st_mtim.tv_nsec / 1'000'000;
  if (qAbs(now_ms - before_ms) <= kTouchEveryMs) return;
  const timespec now{time_t(now_ms / 1000), long(now_ms % 1000) * 1'000'000};
  const std::array<timespec, 2> times{now, now};
  ::utimensat(AT_FDCWD, path.c_str(), times.data(), AT_SYMLINK_NOFOLLOW);
}

QByteArray nameOf(const QUrl& url) {
  return QCryptographicHash::hash(keyOf(url), QCryptographicHash::Sha1).toHex();
}

}  // namespace

struct HttpCache::Record {
  QByteArray url;
  QByteArray content_type;
  QByteArray etag;
  qint64 stored_ms = 0;
  qint64 fresh_s = 0;  // kForever, or seconds from stored_ms on
  QByteArray body;
};

HttpCache::HttpCache(QString folder, qint64 budget_bytes, Now now)
    : folder_(std::move(folder)), budget_bytes_(budget_bytes), now_(std::move(now)) {}

QString HttpCache::pathOf(const QByteArray& name) const {
  return folder_ + u'/' + QString::fromLatin1(name.left(2)) + u'/' + QString::fromLatin1(name.mid(2)) +
         kSuffix;
}

std::optional<HttpCache::Record> HttpCache::read(const QByteArray& name, const QUrl& url) {
  const std::string path = QFile::encodeName(pathOf(name)).toStdString();
  if (::access(path.c_str(), F_OK) != 0) {
    return std::nullopt;
  }
  // Whatever lies there: a named pipe is no answer, and is not waited for.
  const auto read = disk::readFile(path, std::size_t(std::max<qint64>(budget_bytes_, 0)) + 1);
  const bool plausible =
      read && qint64(read->size()) <= budget_bytes_ && qint64(read->size()) >= kMagicBytes + kChecksumBytes;
  const QByteArray bytes =
      plausible ? QByteArray::fromRawData(read->data(), qsizetype(read->size())) : QByteArray();
  const QByteArray content = plausible ? QByteArray::fromRawData(read->data() + kMagicBytes + kChecksumBytes,
                                                                 bytes.size() - kMagicBytes - kChecksumBytes)
                                       : QByteArray();
  const bool whole =
      bytes.startsWith(kMagic) && bytes.mid(kMagicBytes, kChecksumBytes) == checksumOf(content);
  Record record;
  if (whole) {
    QDataStream stream(content);
    stream.setVersion(QDataStream::Qt_6_4);
    stream >> record.url >> record.content_type >> record.etag >> record.stored_ms >> record.fresh_s >>
        record.body;
    if (stream.status() == QDataStream::Ok && record.url == keyOf(url)) {
      const qint64 now_ms = now_().toMSecsSinceEpoch();
      touch(path, now_ms);
      if (const auto entry = index_.find(name); entry != index_.end()) {
        entry->last_use_ms = now_ms;
      }
      return record;
    }
  }
  forget(name);
  return std::nullopt;
}

std::optional<CachedAnswer> HttpCache::find(const QUrl& url) {
  auto record = read(nameOf(url), url);
  if (!record) {
    return std::nullopt;
  }
  // An answer from the future tells that the clock was set back: its age is unknown.
  const qint64 age_ms = now_().toMSecsSinceEpoch() - record->stored_ms;
  const bool fresh = record->fresh_s == kForever || (age_ms >= 0 && age_ms < record->fresh_s * 1000);
  return CachedAnswer{record->body, record->content_type, record->etag, fresh};
}

void HttpCache::store(const QUrl& url, const QByteArray& body, const QByteArray& content_type,
                      const QByteArray& cache_control, const QByteArray& etag, bool content_addressed) {
  const QByteArray name = nameOf(url);
  const CacheControl control = parseCacheControl(cache_control);
  Record record{keyOf(url), content_type, etag, now_().toMSecsSinceEpoch(), 0, body};
  if (control.no_cache) {
    record.fresh_s = 0;
  } else if (control.max_age_s) {
    record.fresh_s = *control.max_age_s;
  } else if (control.immutable || (content_addressed && etag.isEmpty())) {
    record.fresh_s = kForever;
  }
  const bool of_use = record.fresh_s != 0 || !etag.isEmpty();
  if (control.no_store || !of_use) {
    forget(name);
    return;
  }
  write(name, record);
}

void HttpCache::refresh(const QUrl& url, const QByteArray& cache_control, const QByteArray& etag) {
  const QByteArray name = nameOf(url);
  auto record = read(name, url);
  if (!record) {
    return;
  }
  const CacheControl control = parseCacheControl(cache_control);
  if (control.no_store) {
    forget(name);
    return;
  }
  if (control.no_cache) {
    record->fresh_s = 0;
  } else if (control.max_age_s) {
    record->fresh_s = *control.max_age_s;
  } else if (control.immutable) {
    record->fresh_s = kForever;
  }
  if (!etag.isEmpty()) {
    record->etag = etag;
  }
  record->stored_ms = now_().toMSecsSinceEpoch();
  write(name, *record);
}

void HttpCache::copy(const QUrl& from, const QUrl& to) {
  auto record = read(nameOf(from), from);
  if (!record) {
    return;
  }
  record->url = keyOf(to);
  write(nameOf(to), *record);
}

void HttpCache::remove(const QUrl& url) { forget(nameOf(url)); }

void HttpCache::forget(const QByteArray& name) {
  QFile file(pathOf(name));
  if (file.exists() && !file.remove()) {
    fail({ReasonCode::FileNotRemoved, {file.fileName(), file.errorString()}});
    return;
  }
  if (const auto entry = index_.find(name); entry != index_.end()) {
    bytes_ -= entry->bytes;
    index_.erase(entry);
  }
}

bool HttpCache::makeFolder(const QString& path) {
  if (QFileInfo(path).isDir()) {
    return true;
  }
  if (!QDir().mkpath(path) || !QFile::setPermissions(path, kPrivateFolder)) {
    fail({ReasonCode::FolderNotMade, {path}});
    return false;
  }
  return true;
}

void HttpCache::write(const QByteArray& name, const Record& record) {
  QByteArray content;
  QDataStream stream(&content, QIODevice::WriteOnly);
  stream.setVersion(QDataStream::Qt_6_4);
  stream << record.url << record.content_type << record.etag << record.stored_ms << record.fresh_s
         << record.body;
  const qint64 size = kMagicBytes + kChecksumBytes + content.size();
  if (size > budget_bytes_) {
    forget(name);
    return;
  }
  const QString path = pathOf(name);
  // Now and then, for other processes write here too; seldom where there is much to read.
  if (bytes_ < 0 || ++stores_since_scan_ >= std::max(kStoresBetweenScans, int(index_.size()))) {
    scan();
  }
  const std::array parts{QByteArray(kMagic, kMagicBytes), checksumOf(content), content};
  const auto tryIt = [&] {
    return writeWhole(QFile::encodeName(path).toStdString(), parts, now_().toMSecsSinceEpoch());
  };
  int failure = tryIt();
  if (failure == ENOENT) {
    if (!makeFolder(folder_) || !makeFolder(QFileInfo(path).path())) return;
    failure = tryIt();
  }
  if (failure != 0) {
    fail({ReasonCode::FileNotKept, {path, QString::fromLocal8Bit(std::strerror(failure))}});
    return;
  }
  Entry& entry = index_[name];
  bytes_ += size - entry.bytes;
  entry = {size, now_().toMSecsSinceEpoch()};
  if (bytes_ > budget_bytes_) {
    evict(name);
  }
}

void HttpCache::scan() const {
  index_.clear();
  bytes_ = 0;
  stores_since_scan_ = 0;
  QDirIterator files(folder_, QDir::Files | QDir::Hidden | QDir::NoSymLinks, QDirIterator::Subdirectories);
  while (files.hasNext()) {
    files.next();
    const QFileInfo info = files.fileInfo();
    const qint64 last_use_ms = info.lastModified().toMSecsSinceEpoch();
    const QString shard = info.dir().dirName();
    const QString file_name = info.fileName();
    const QByteArray name =
        (shard + file_name.chopped(std::min(file_name.size(), kSuffix.size()))).toLatin1();
    if (file_name.endsWith(kSuffix) && info.filePath() == pathOf(name)) {
      index_.insert(name, {info.size(), last_use_ms});
      bytes_ += info.size();
    } else if (file_name.contains(kSuffix) &&
               QDateTime::currentMSecsSinceEpoch() - last_use_ms > kUnfinishedMs) {
      QFile::remove(info.filePath());
    }
  }
}

void HttpCache::evict(const QByteArray& keep) {
  scan();  // another process may have made room, or used some
  std::vector<std::pair<qint64, QByteArray>> oldest_first;
  oldest_first.reserve(std::size_t(index_.size()));
  for (auto entry = index_.constBegin(); entry != index_.constEnd(); ++entry) {
    if (entry.key() != keep) {
      oldest_first.emplace_back(entry->last_use_ms, entry.key());
    }
  }
  std::sort(oldest_first.begin(), oldest_first.end());
  const qint64 goal = budget_bytes_ - budget_bytes_ / 10;  // so that not every store has to make room
  for (const auto& [last_use_ms, name] : oldest_first) {
    if (bytes_ <= goal) {
      return;
    }
    forget(name);
  }
}

qint64 HttpCache::bytes() const {
  if (bytes_ < 0) {
    scan();
  }
  return bytes_;
}

void HttpCache::fail(Reason what) {
  last_error_ = std::move(what);
  if (const Trouble tell = std::exchange(trouble_, nullptr)) tell(last_error_);
}

Reason HttpCache::lastError() const { return last_error_; }

}  // namespace mapwright::net
