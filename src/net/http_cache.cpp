#include "net/http_cache.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
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
#include "net/log.h"

namespace mapwright::net {

namespace {

constexpr char kMagic[] = "MWCACHE2";
constexpr qsizetype kMagicBytes = 8;
constexpr qsizetype kHeadBytes = kMagicBytes + 4;  // and a CRC-32, as fast as the bytes can be read
constexpr qint64 kForever = -1;
constexpr qint64 kLongestAge = qint64(1) << 31;  // seconds; RFC 9111: longer ages may be treated as this one
constexpr int kStoresBetweenScans = 512;         // or as many as there are files, if there are more
constexpr qint64 kUnfinishedMs = 3600 * 1000;    // a temporary file of another process this old was abandoned
constexpr qint64 kTouchEveryMs = 60 * 1000;
constexpr QFileDevice::Permissions kPrivateFolder =
    QFileDevice::ReadOwner | QFileDevice::WriteOwner | QFileDevice::ExeOwner;
const QLatin1String kSuffix(".answer");

QByteArray keyOf(const QUrl& url) { return url.toEncoded(QUrl::RemoveFragment | QUrl::RemoveUserInfo); }

QByteArray nameOf(const QUrl& url) {
  return QCryptographicHash::hash(keyOf(url), QCryptographicHash::Sha1).toHex();
}

/// A Cache-Control header for a private cache (RFC 9111, 5.2).
struct CacheControl {
  bool no_store = false;
  std::optional<qint64> fresh_s;  // nullopt = it does not say
};

qint64 parseAge(QByteArray text) {
  text = text.trimmed();
  if (text.size() >= 2 && text.startsWith('"') && text.endsWith('"')) text = text.mid(1, text.size() - 2);
  const bool digits =
      !text.isEmpty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!digits) return 0;
  bool fits = false;
  const qint64 age = text.toLongLong(&fits);
  return fits ? std::min(age, kLongestAge) : kLongestAge;
}

CacheControl parseCacheControl(const QByteArray& header) {
  CacheControl control;
  bool no_cache = false, immutable = false;
  for (const QByteArray& directive : header.split(',')) {
    const auto equals = directive.indexOf('=');
    const QByteArray name = (equals < 0 ? directive : directive.left(equals)).trimmed().toLower();
    control.no_store |= name == "no-store";
    no_cache |= name == "no-cache";
    immutable |= name == "immutable";
    if (name == "max-age") control.fresh_s = equals < 0 ? 0 : parseAge(directive.mid(equals + 1));
  }
  if (no_cache) control.fresh_s = 0;
  if (immutable && !control.fresh_s) control.fresh_s = kForever;
  return control;
}

quint32 checksumOf(const QByteArray& file) {
  return libdeflate_crc32(0, file.constData() + kHeadBytes, std::size_t(file.size() - kHeadBytes));
}

std::array<timespec, 2> timesOf(qint64 ms) {
  const timespec time{time_t(ms / 1000), long(ms % 1000) * 1'000'000};
  return {time, time};
}

/// The time of last use is the file's modification time, so that it survives restarts. It is not updated at
/// every use.
void touch(const std::string& path, qint64 now_ms) {
  struct stat about {};
  if (::lstat(path.c_str(), &about) != 0) return;
  const qint64 before_ms = qint64(about.st_mtim.tv_sec) * 1000 + about.st_mtim.tv_nsec / 1'000'000;
  if (qAbs(now_ms - before_ms) <= kTouchEveryMs) return;
  ::utimensat(AT_FDCWD, path.c_str(), timesOf(now_ms).data(), AT_SYMLINK_NOFOLLOW);
}

Fault makeFolder(const QString& path) {
  if (QFileInfo(path).isDir()) return {};
  if (QDir().mkpath(path) && QFile::setPermissions(path, kPrivateFolder)) return {};
  return faultOf(faultText("net", "the folder %1 cannot be created"), {path});
}

}  // namespace

int writeWhole(const std::string& path, const QByteArray& bytes, qint64 now_ms) {
  std::string aside = path + ".XXXXXX";
  const int file = ::mkostemp(aside.data(), O_CLOEXEC);  // readable only by this user
  if (file < 0) return errno;
  int failure = 0;
  for (qsizetype at = 0; at < bytes.size() && failure == 0;) {
    const ssize_t written = ::write(file, bytes.constData() + at, std::size_t(bytes.size() - at));
    if (written < 0 && errno != EINTR) failure = errno;
    if (written > 0) at += written;
  }
  if (failure == 0 && ::futimens(file, timesOf(now_ms).data()) != 0) failure = errno;
  if (::close(file) != 0 && failure == 0) failure = errno;
  if (failure == 0 && std::rename(aside.c_str(), path.c_str()) != 0) failure = errno;
  if (failure != 0) ::unlink(aside.c_str());
  return failure;
}

qint64 HttpCache::Record::fileBytes() const {
  constexpr qint64 kLengths = 4 * 4, kNumbers = 2 * 8;  // as QDataStream writes byte arrays and numbers
  return kHeadBytes + kLengths + kNumbers + url.size() + content_type.size() + etag.size() + body.size();
}

/// The files, one per answer. Other processes may change them at the same time. read()
/// is for any thread, the others for one at a time. A Fault without a code means success.
class HttpCache::Folder {
 public:
  Folder(QString path, qint64 budget_bytes, WriteFile write)
      : path_(std::move(path)), budget_bytes_(budget_bytes), write_(std::move(write)) {}

  struct Read {
    std::optional<Record> record;
    bool broken = false;  // there is a file, but it is not the answer for that address
  };
  /// Reads the file `name` for the address `url` and sets its last use to `now_ms`.
  Read read(const QByteArray& name, const QByteArray& url, qint64 now_ms) const {
    const std::string path = QFile::encodeName(pathOf(name)).toStdString();
    if (::access(path.c_str(), F_OK) != 0) return {};
    // Whatever is there: a named pipe must not block.
    const auto read = disk::readFile(path, std::size_t(std::max<qint64>(budget_bytes_, 0)) + 1);
    const bool plausible =
        read && qint64(read->size()) <= budget_bytes_ && qint64(read->size()) >= kHeadBytes;
    if (!plausible) return {std::nullopt, true};
    const QByteArray bytes = QByteArray::fromRawData(read->data(), qsizetype(read->size()));
    if (!bytes.startsWith(kMagic) ||
        qFromBigEndian<quint32>(bytes.constData() + kMagicBytes) != checksumOf(bytes)) {
      return {std::nullopt, true};
    }
    Record record;
    QDataStream stream(QByteArray::fromRawData(bytes.constData() + kHeadBytes, bytes.size() - kHeadBytes));
    stream.setVersion(QDataStream::Qt_6_4);
    stream >> record.url >> record.content_type >> record.etag >> record.stored_ms >> record.fresh_s >>
        record.body;
    const bool times = record.stored_ms >= 0 && record.fresh_s >= kForever && record.fresh_s <= kLongestAge;
    if (stream.status() != QDataStream::Ok || record.url != url || !times) return {std::nullopt, true};
    touch(path, now_ms);
    return {std::move(record), false};
  }

  /// At most the budget long. Removes others if needed.
  Fault keep(const QByteArray& name, const Record& record, qint64 now_ms) {
    QByteArray bytes(kMagic, kHeadBytes - 4);
    bytes.reserve(qsizetype(record.fileBytes()));
    QDataStream stream(&bytes, QIODevice::Append);
    stream.setVersion(QDataStream::Qt_6_4);
    stream << quint32(0) << record.url << record.content_type << record.etag << record.stored_ms
           << record.fresh_s << record.body;
    qToBigEndian(checksumOf(bytes), bytes.data() + kMagicBytes);
    // Now and then, since other processes write here, too; rarely if there are many files.
    if (bytes_ < 0 || ++stores_since_scan_ >= std::max(kStoresBetweenScans, files_)) scan();
    const QString path = pathOf(name);
    const qint64 before = QFileInfo(path).size();
    const auto tryIt = [&] { return write_(QFile::encodeName(path).toStdString(), bytes, now_ms); };
    int failure = tryIt();
    if (failure == ENOENT) {
      for (const QString& folder : {path_, QFileInfo(path).path()}) {
        if (Fault why = makeFolder(folder); why.any()) return why;
      }
      failure = tryIt();
    }
    if (failure != 0)
      return faultOf(faultText("net", "%1 cannot be written: %2"),
                     {path, QString::fromLocal8Bit(std::strerror(failure))});
    bytes_ += bytes.size() - before;
    return bytes_ > budget_bytes_ ? evict(path) : Fault();
  }

  Fault remove(const QByteArray& name) { return removeFile(pathOf(name)); }

  /// Of all files.
  qint64 bytes() {
    if (bytes_ < 0) scan();
    return bytes_;
  }

 private:
  struct Kept {
    qint64 last_use_ms = 0;  // since the epoch; stored as the file's modification time
    qint64 bytes = 0;
    QString path;
  };

  QString pathOf(const QByteArray& name) const {
    return path_ + u'/' + QString::fromLatin1(name.left(2)) + u'/' + QString::fromLatin1(name.mid(2)) +
           kSuffix;
  }

  Fault removeFile(const QString& path) {
    QFile file(path);
    const qint64 size = file.size();
    if (file.exists() && !file.remove())
      return faultOf(faultText("net", "%1 cannot be removed: %2"), {path, file.errorString()});
    if (bytes_ >= 0) bytes_ -= size;
    return {};
  }

  /// All files, as other processes may have added or removed some. Removes what they left unfinished.
  std::vector<Kept> scan() {
    std::vector<Kept> all;
    bytes_ = 0;
    stores_since_scan_ = 0;
    QDirIterator files(path_, QDir::Files | QDir::Hidden | QDir::NoSymLinks, QDirIterator::Subdirectories);
    while (files.hasNext()) {
      files.next();
      const QFileInfo info = files.fileInfo();
      const qint64 last_use_ms = info.lastModified().toMSecsSinceEpoch();
      if (info.fileName().endsWith(kSuffix)) {
        all.push_back({last_use_ms, info.size(), info.filePath()});
        bytes_ += info.size();
      } else if (info.fileName().contains(kSuffix) &&
                 QDateTime::currentMSecsSinceEpoch() - last_use_ms > kUnfinishedMs) {
        QFile::remove(info.filePath());
      }
    }
    files_ = int(all.size());
    return all;
  }

  Fault evict(const QString& except) {
    std::vector<Kept> oldest_first = scan();
    std::sort(oldest_first.begin(), oldest_first.end(),
              [](const Kept& a, const Kept& b) { return a.last_use_ms < b.last_use_ms; });
    const qint64 goal = budget_bytes_ - budget_bytes_ / 10;  // so that not every store has to remove files
    Fault trouble;
    for (const Kept& file : oldest_first) {
      if (bytes_ <= goal) break;
      if (file.path == except) continue;
      if (Fault why = removeFile(file.path); why.any()) trouble = std::move(why);
    }
    return trouble;
  }

  const QString path_;
  const qint64 budget_bytes_;
  const WriteFile write_;
  qint64 bytes_ = -1;  // of all files; -1 = not read yet
  int files_ = 0, stores_since_scan_ = 0;
};

HttpCache::HttpCache(QString folder, qint64 budget_bytes, Now now, WriteFile write)
    : now_(std::move(now)),
      budget_bytes_(budget_bytes),
      folder_(std::make_unique<Folder>(std::move(folder), budget_bytes, std::move(write))) {
  writer_.setMaxThreadCount(1);
}

HttpCache::~HttpCache() = default;

std::optional<HttpCache::Record> HttpCache::read(const QUrl& url) {
  const QByteArray name = nameOf(url);
  {
    const std::lock_guard lock(mutex_);
    if (const auto change = changes_.constFind(name); change != changes_.constEnd()) return change->record;
  }
  auto found = folder_->read(name, keyOf(url), nowMs());
  if (found.broken) {
    qCInfo(lcCache, "%s: what was kept is broken", qUtf8Printable(urlForLog(url)));
    change(name, std::nullopt);
  }
  return std::move(found.record);
}

std::optional<CachedAnswer> HttpCache::find(const QUrl& url) {
  const auto record = read(url);
  if (!record) return std::nullopt;
  // An answer from the future means that the clock was set back: its age is unknown.
  const qint64 age_ms = nowMs() - record->stored_ms;
  const bool fresh = record->fresh_s == kForever || (age_ms >= 0 && age_ms < record->fresh_s * 1000);
  return CachedAnswer{record->body, record->content_type, record->etag, fresh};
}

void HttpCache::store(const QUrl& url, const QByteArray& body, const QByteArray& content_type,
                      const QByteArray& cache_control, const QByteArray& etag, bool content_addressed) {
  const CacheControl control = parseCacheControl(cache_control);
  const qint64 fresh_s = control.fresh_s.value_or(content_addressed && etag.isEmpty() ? kForever : 0);
  if (control.no_store || (fresh_s == 0 && etag.isEmpty())) {
    qCDebug(lcCache, "%s: not kept, its headers forbid it", qUtf8Printable(urlForLog(url)));
    change(nameOf(url), std::nullopt);
    return;
  }
  qCDebug(lcCache, "%s: kept, %lld bytes", qUtf8Printable(urlForLog(url)), (long long)(body.size()));
  keep(nameOf(url), {keyOf(url), content_type, etag, nowMs(), fresh_s, body});
}

void HttpCache::refresh(const QUrl& url, const QByteArray& cache_control, const QByteArray& etag) {
  auto record = read(url);
  if (!record) return;
  const CacheControl control = parseCacheControl(cache_control);
  if (control.no_store) return change(nameOf(url), std::nullopt);
  if (control.fresh_s) record->fresh_s = *control.fresh_s;
  if (!etag.isEmpty()) record->etag = etag;
  record->stored_ms = nowMs();
  keep(nameOf(url), std::move(*record));
}

void HttpCache::copy(const QUrl& from, const QUrl& to) {
  auto record = read(from);
  if (!record) return;
  record->url = keyOf(to);
  keep(nameOf(to), std::move(*record));
}

void HttpCache::remove(const QUrl& url) {
  qCDebug(lcCache, "%s: removed", qUtf8Printable(urlForLog(url)));
  change(nameOf(url), std::nullopt);
}

void HttpCache::keep(const QByteArray& name, Record record) {
  const bool fits = record.fileBytes() <= budget_bytes_;
  change(name, fits ? std::optional(std::move(record)) : std::nullopt);
}

void HttpCache::change(const QByteArray& name, std::optional<Record> record) {
  Change wanted{std::move(record), nowMs(), ++last_number_};
  const qint64 bytes = wanted.bytes();
  std::unique_lock lock(mutex_);
  // A removal never waits: it needs no memory, and it is important.
  written_.wait(
      lock, [&] { return bytes == 0 || waiting_bytes_ == 0 || waiting_bytes_ + bytes <= kMostWaitingBytes; });
  const bool waits = changes_.contains(name);
  waiting_bytes_ += bytes - changes_[name].bytes();
  changes_[name] = std::move(wanted);
  lock.unlock();
  if (!waits) writer_.start([this, name] { write(name); });
}

void HttpCache::write(const QByteArray& name) {
  std::unique_lock lock(mutex_);
  Change done;
  // It may change while it is written: then the newer one follows.
  while (changes_[name].number != done.number) {
    done = changes_[name];
    lock.unlock();
    const Fault why = done.record ? folder_->keep(name, *done.record, done.now_ms) : folder_->remove(name);
    if (why.any()) recordFailure(why);
    lock.lock();
  }
  waiting_bytes_ -= done.bytes();
  changes_.remove(name);
  written_.notify_all();
}

void HttpCache::flush() {
  writer_.waitForDone();
  reportFailure();
}

qint64 HttpCache::bytes() {
  flush();
  return folder_->bytes();  // the writer is idle until the next change, which only this thread can make
}

void HttpCache::recordFailure(const Fault& why) {
  qCInfo(lcCache, "%s", inEnglish(why).c_str());
  const std::lock_guard lock(mutex_);
  if (untold_) return;  // already in progress
  untold_ = why;
  QMetaObject::invokeMethod(
      &here_, [this] { reportFailure(); }, Qt::QueuedConnection);
}

void HttpCache::reportFailure() {
  std::optional<Fault> why;
  {
    const std::lock_guard lock(mutex_);
    why = std::exchange(untold_, std::nullopt);
  }
  if (!why) return;
  if (const Trouble report = std::exchange(trouble_, nullptr)) report(*why);
}

}  // namespace mapwright::net
