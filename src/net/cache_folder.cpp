#include "net/cache_folder.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>
#include <vector>

#include <QDataStream>
#include <QDateTime>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileInfo>
#include <QtEndian>
#include <libdeflate.h>

#include "disk/read_file.h"

namespace mapwright::net {

namespace {

constexpr char kMagic[] = "MWCACHE2";
constexpr qsizetype kMagicBytes = 8;
constexpr qsizetype kChecksumBytes = 4;        // CRC-32: detects torn files, as fast as the bytes can be read
constexpr int kStoresBetweenScans = 512;       // or as many as there are files, if there are more
constexpr qint64 kUnfinishedMs = 3600 * 1000;  // a temporary file of another process this old was abandoned
constexpr qint64 kTouchEveryMs = 60 * 1000;
constexpr QFileDevice::Permissions kPrivateFolder =
    QFileDevice::ReadOwner | QFileDevice::WriteOwner | QFileDevice::ExeOwner;
const QLatin1String kSuffix(".answer");

QByteArray checksumOf(const QByteArray& content) {
  const std::uint32_t sum = libdeflate_crc32(0, content.constData(), std::size_t(content.size()));
  QByteArray bytes(kChecksumBytes, Qt::Uninitialized);
  qToBigEndian(sum, bytes.data());
  return bytes;
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

}  // namespace

int writeWhole(const std::string& path, const std::array<QByteArray, 3>& parts, qint64 now_ms) {
  std::string aside = path + ".XXXXXX";
  const int file = ::mkostemp(aside.data(), O_CLOEXEC);  // readable only by this user
  if (file < 0) return errno;
  int failure = 0;
  for (const QByteArray& part : parts) {
    for (qsizetype at = 0; at < part.size() && failure == 0;) {
      const ssize_t written = ::write(file, part.constData() + at, std::size_t(part.size() - at));
      if (written < 0 && errno != EINTR) failure = errno;
      if (written > 0) at += written;
    }
  }
  if (failure == 0 && ::futimens(file, timesOf(now_ms).data()) != 0) failure = errno;
  if (::close(file) != 0 && failure == 0) failure = errno;
  if (failure == 0 && std::rename(aside.c_str(), path.c_str()) != 0) failure = errno;
  if (failure != 0) ::unlink(aside.c_str());
  return failure;
}

qint64 fileBytes(const CacheRecord& record) {
  constexpr qint64 kLengths = 4 * 4,
                   kNumbers = 2 * 8;  // as QDataStream writes four byte arrays and two numbers
  return kMagicBytes + kChecksumBytes + kLengths + kNumbers + record.url.size() + record.content_type.size() +
         record.etag.size() + record.body.size();
}

CacheFolder::CacheFolder(QString folder, qint64 budget_bytes, WriteFile write)
    : folder_(std::move(folder)), budget_bytes_(budget_bytes), write_(std::move(write)) {}

QString CacheFolder::pathOf(const QByteArray& name) const {
  return folder_ + u'/' + QString::fromLatin1(name.left(2)) + u'/' + QString::fromLatin1(name.mid(2)) +
         kSuffix;
}

CacheFolder::Read CacheFolder::read(const QByteArray& name, const QByteArray& url, qint64 now_ms) const {
  const std::string path = QFile::encodeName(pathOf(name)).toStdString();
  if (::access(path.c_str(), F_OK) != 0) return {};
  // Whatever is there: a named pipe must not block.
  const auto read = disk::readFile(path, std::size_t(std::max<qint64>(budget_bytes_, 0)) + 1);
  const bool plausible =
      read && qint64(read->size()) <= budget_bytes_ && qint64(read->size()) >= kMagicBytes + kChecksumBytes;
  if (!plausible) return {std::nullopt, true};
  const QByteArray bytes = QByteArray::fromRawData(read->data(), qsizetype(read->size()));
  const QByteArray content = QByteArray::fromRawData(read->data() + kMagicBytes + kChecksumBytes,
                                                     bytes.size() - kMagicBytes - kChecksumBytes);
  if (!bytes.startsWith(kMagic) || bytes.mid(kMagicBytes, kChecksumBytes) != checksumOf(content)) {
    return {std::nullopt, true};
  }
  CacheRecord record;
  QDataStream stream(content);
  stream.setVersion(QDataStream::Qt_6_4);
  stream >> record.url >> record.content_type >> record.etag >> record.stored_ms >> record.fresh_s >>
      record.body;
  if (stream.status() != QDataStream::Ok || record.url != url) return {std::nullopt, true};
  touch(path, now_ms);
  return {std::move(record), false};
}

Fault CacheFolder::remove(const QByteArray& name) {
  QFile file(pathOf(name));
  if (file.exists() && !file.remove()) {
    return faultOf(fault::FileNotRemoved, {file.fileName(), file.errorString()});
  }
  if (const auto entry = index_.find(name); entry != index_.end()) {
    bytes_ -= entry->bytes;
    index_.erase(entry);
  }
  return {};
}

Fault CacheFolder::makeFolder(const QString& path) const {
  if (QFileInfo(path).isDir()) return {};
  if (QDir().mkpath(path) && QFile::setPermissions(path, kPrivateFolder)) return {};
  return faultOf(fault::FolderNotMade, {path});
}

Fault CacheFolder::keep(const QByteArray& name, const CacheRecord& record, qint64 now_ms) {
  QByteArray content;
  content.reserve(qsizetype(fileBytes(record)));
  QDataStream stream(&content, QIODevice::WriteOnly);
  stream.setVersion(QDataStream::Qt_6_4);
  stream << record.url << record.content_type << record.etag << record.stored_ms << record.fresh_s
         << record.body;
  const QString path = pathOf(name);
  // Now and then, since other processes write here, too; rarely if there are many files.
  if (bytes_ < 0 || ++stores_since_scan_ >= std::max(kStoresBetweenScans, int(index_.size()))) scan();
  const std::array parts{QByteArray(kMagic, kMagicBytes), checksumOf(content), content};
  const auto tryIt = [&] { return write_(QFile::encodeName(path).toStdString(), parts, now_ms); };
  int failure = tryIt();
  if (failure == ENOENT) {
    for (const QString& folder : {folder_, QFileInfo(path).path()}) {
      if (Fault why = makeFolder(folder); why.any()) return why;
    }
    failure = tryIt();
  }
  if (failure != 0) {
    return faultOf(fault::FileNotKept, {path, QString::fromLocal8Bit(std::strerror(failure))});
  }
  Entry& entry = index_[name];
  const qint64 size = kMagicBytes + kChecksumBytes + content.size();
  bytes_ += size - entry.bytes;
  entry = {size, now_ms};
  return bytes_ > budget_bytes_ ? evict(name) : Fault();
}

void CacheFolder::scan() {
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

Fault CacheFolder::evict(const QByteArray& keep) {
  scan();  // another process may have removed or added files
  std::vector<std::pair<qint64, QByteArray>> oldest_first;
  oldest_first.reserve(std::size_t(index_.size()));
  for (auto entry = index_.constBegin(); entry != index_.constEnd(); ++entry) {
    if (entry.key() != keep) oldest_first.emplace_back(entry->last_use_ms, entry.key());
  }
  std::sort(oldest_first.begin(), oldest_first.end());
  const qint64 goal = budget_bytes_ - budget_bytes_ / 10;  // so that not every store has to remove files
  Fault trouble;
  for (const auto& [last_use_ms, name] : oldest_first) {
    if (bytes_ <= goal) break;
    if (Fault why = remove(name); why.any()) trouble = std::move(why);
  }
  return trouble;
}

qint64 CacheFolder::bytes() {
  if (bytes_ < 0) scan();
  return bytes_;
}

}  // namespace mapwright::net
