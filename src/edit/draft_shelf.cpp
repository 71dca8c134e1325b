#include "edit/draft_shelf.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLoggingCategory>
#include <QUuid>

#include "disk/file_error.h"
#include "disk/read_file.h"
#include "disk/written_file.h"
#include "edit/faults.h"

namespace mapwright::edit {
namespace {

Q_LOGGING_CATEGORY(lcEdit, "mapwright.edit", QtWarningMsg)

constexpr std::size_t kLongestDraft = std::size_t(256) << 20;

QString stemOf(const DraftIdentity& of) {
  const QByteArray text = of.kind.toUtf8() + '\n' + of.map.toUtf8() + '\n' + of.address.toUtf8();
  return QString::fromLatin1(QCryptographicHash::hash(text, QCryptographicHash::Sha256).toHex().left(24));
}

std::unique_ptr<QLockFile> lockOf(const QString& path) {
  auto lock = std::make_unique<QLockFile>(path + QStringLiteral(".lock"));
  lock->setStaleLockTime(0);  // held as long as the program runs
  return lock;
}

Fault notRemoved(const QString& path) { return {fault::DraftNotRemoved, {path.toStdString()}}; }

}  // namespace

DraftFile::DraftFile(QString folder, const DraftIdentity& of)
    : folder_(std::move(folder)),
      path_(folder_ + QLatin1Char('/') + stemOf(of) + QLatin1Char('-') +
            QUuid::createUuid().toString(QUuid::Id128) + QStringLiteral(".json")) {}

std::optional<Fault> DraftFile::write(const QByteArray& bytes) {
  if (!QDir().mkpath(folder_)) return Fault(fault::DraftFolderNotMade, {folder_.toStdString()});
  if (!lock_) {
    auto lock = lockOf(path_);
    if (!lock->tryLock()) return Fault(fault::DraftFileNotMade, {folder_.toStdString()});
    lock_ = std::move(lock);
  }
  const auto fault = disk::writeFile(path_.toStdString(), {bytes.constData(), std::size_t(bytes.size())});
  if (!fault) {
    qCDebug(lcEdit, "draft %s: %lld bytes written", qUtf8Printable(path_), qint64(bytes.size()));
    return std::nullopt;
  }
  qCInfo(lcEdit, "draft %s: %s", qUtf8Printable(path_), inEnglish(disk::notWritten(*fault)).c_str());
  return disk::notWritten(*fault);
}

std::optional<Fault> DraftFile::remove() {
  const bool gone = !QFile::exists(path_) || QFile::remove(path_);
  lock_.reset();
  return gone ? std::nullopt : std::optional(notRemoved(path_));
}

LeftDrafts leftDrafts(const QString& folder, const DraftIdentity& of) {
  LeftDrafts left;
  const QStringList names =
      QDir(folder).entryList({stemOf(of) + QStringLiteral("-*.json")}, QDir::Files, QDir::Time);
  for (const QString& name : names) {
    LeftDraft draft{folder + QLatin1Char('/') + name, {}, lockOf(folder + QLatin1Char('/') + name)};
    // In a read-only folder nothing can be locked, but drafts there can still be restored.
    if (!draft.lock->tryLock() && draft.lock->error() == QLockFile::LockFailedError) continue;
    if (!QFile::exists(draft.path)) continue;
    auto bytes = disk::readFile(draft.path.toStdString(), kLongestDraft);
    if (!bytes) {
      left.notes.push_back({fault::DraftNotRead, {draft.path.toStdString()}, {bytes.error().cause}});
      continue;
    }
    draft.bytes = QByteArray::fromStdString(*bytes);
    qCInfo(lcEdit, "draft %s: left by another run, %lld bytes", qUtf8Printable(draft.path),
           qint64(draft.bytes.size()));
    left.drafts.push_back(std::move(draft));
  }
  return left;
}

std::optional<Fault> removeDraft(LeftDraft draft) {
  if (!QFile::exists(draft.path) || QFile::remove(draft.path)) return std::nullopt;
  return notRemoved(draft.path);
}

Fault setAside(LeftDraft draft) {
  qCInfo(lcEdit, "draft %s: cannot be understood, set aside", qUtf8Printable(draft.path));
  const QString aside = draft.path + QStringLiteral(".broken");
  QFile::remove(aside);
  const std::string path = draft.path.toStdString();
  if (!QFile::rename(draft.path, aside)) return {fault::DraftBroken, {path}};
  return {fault::DraftSetAside, {path, aside.toStdString()}};
}

}  // namespace mapwright::edit
