#include "robot/files/map_files.h"

#include <QFileInfo>
#include <QSet>
#include <QThread>

#include "disk/folder_lock.h"
#include "grids/rewrite_picture.h"
#include "robot/files/faults.h"

namespace mapwright::robot::files {
namespace {

constexpr qsizetype kMostWatched = 1'000;  // a larger folder is only watched as a folder

QString stamp(const QString& path) { return QString::fromStdString(stampOf(path)); }

bool isWantedNoMore() { return QThread::currentThread()->isInterruptionRequested(); }

}  // namespace

MapFiles::MapFiles(FileOptions options) : options_(std::move(options)) {}

void MapFiles::start() {
  if (watcher_) return;
  watcher_ = std::make_unique<QFileSystemWatcher>();
  settle_ = std::make_unique<QTimer>();
  settle_->setSingleShot(true);
  settle_->setInterval(options_.settle);
  connect(settle_.get(), &QTimer::timeout, this, &MapFiles::tellChange);
  // The watcher loses files that are replaced by renaming; watching their folder helps.
  connect(watcher_.get(), &QFileSystemWatcher::fileChanged, this, [this] { settle_->start(); });
  connect(watcher_.get(), &QFileSystemWatcher::directoryChanged, this, [this] { settle_->start(); });
}

void MapFiles::watch() {
  start();
  stamps_ = watchAndStamp();
  look();
}

void MapFiles::leave() {
  settle_.reset();
  watcher_.reset();
}

bool MapFiles::isFolder() const { return QFileInfo(options_.path).isDir(); }

void MapFiles::look() {
  if (isFolder()) {
    const bool any = !mapFilesIn(options_.path).isEmpty();
    Q_EMIT looked(true, any ? Fault() : Fault(fault::FolderWithoutMaps, {options_.path.toStdString()}));
    return;
  }
  const auto whole = readLocalMap(options_.path, options_.place, yamls_);
  Q_EMIT looked(false, whole ? Fault() : whole.error());
}

QStringList MapFiles::watchAndStamp() {
  QStringList files, folders;
  const PictureYamls beside(isFolder() ? options_.path : QFileInfo(options_.path).absolutePath(), yamls_);
  const auto add = [&](const QString& path) {
    files << path;
    folders << QFileInfo(path).absolutePath();
    // The map.yaml in its folder gives the position of a single picture.
    if (!isFolder()) files << beside.naming(path);
    const auto whole = readLocalMap(path, options_.place, yamls_, &beside);
    if (whole && whole->path != path.toStdString()) {
      files << QString::fromStdString(whole->path);
      folders << QFileInfo(files.last()).absolutePath();
    }
  };
  if (isFolder()) {
    folders << options_.path;
    for (const QString& name : mapFilesIn(options_.path)) {
      if (isWantedNoMore()) return {};
      add(options_.path + QLatin1Char('/') + name);
    }
  } else {
    add(options_.path);
  }
  QStringList stamps;
  QSet<QString> wanted;
  for (const QString& file : std::as_const(files)) {
    if (isWantedNoMore()) return {};
    stamps << stamp(file);
    if (wanted.size() < kMostWatched && QFileInfo::exists(file)) wanted << file;
  }
  folders.removeDuplicates();
  for (const QString& folder : std::as_const(folders)) {
    if (QFileInfo(folder).isDir()) wanted << folder;
  }
  if (!watcher_) return stamps;
  const QStringList now = watcher_->files() + watcher_->directories();
  const QSet<QString> watched(now.begin(), now.end());
  const QSet<QString> missing = wanted - watched, done = watched - wanted;
  if (!missing.isEmpty()) watcher_->addPaths(QStringList(missing.begin(), missing.end()));
  if (!done.isEmpty()) watcher_->removePaths(QStringList(done.begin(), done.end()));
  return stamps;
}

void MapFiles::tellChange() {
  const QStringList stamps = watchAndStamp();
  if (stamps == stamps_ || isWantedNoMore()) return;
  stamps_ = stamps;
  look();
  Q_EMIT changed();
}

QString MapFiles::pathOf(const map::MapKey& key) const { return mapPathOf(options_.path, key); }

map::Failure MapFiles::failure(const map::MapKey& key, map::FailureKind kind) const {
  const std::string name =
      key.id.empty() ? QFileInfo(options_.path).fileName().toStdString() : key.id.substr(0, 200);
  return {.kind = kind, .subject = map::subjectOf(key, name), .reason = map::FailureReason::NotThere};
}

Outcome<std::vector<map::CatalogueEntry>> MapFiles::list() {
  std::vector<map::CatalogueEntry> entries;
  if (isFolder()) {
    const PictureYamls beside(options_.path, yamls_);
    for (const QString& name : mapFilesIn(options_.path)) {
      if (isWantedNoMore()) break;
      entries.push_back(entryOf({map::MapKind::File, name.toStdString()},
                                options_.path + QLatin1Char('/') + name, options_.place, yamls_, &beside));
      entries.back().index = int(entries.size()) - 1;
    }
  } else if (QFileInfo::exists(options_.path)) {
    entries.push_back(entryOf({map::MapKind::File, {}}, options_.path, options_.place, yamls_));
    entries.back().is_current = true;
  }
  return entries;
}

Outcome<map::CatalogueEntry> MapFiles::describe(const map::MapKey& key) {
  const QString path = pathOf(key);
  if (path.isEmpty()) return tl::make_unexpected(failure(key, map::FailureKind::RejectedByRobot));
  return entryOf(key, path, options_.place, yamls_);
}

Outcome<std::string> MapFiles::thumbnail(const map::MapKey& key) {
  map::Failure none = failure(key, map::FailureKind::Unsupported);
  none.asked_for = map::AskedFor::SmallPicture;
  none.reason = map::FailureReason::NotOffered;
  return fail(std::move(none));
}

Outcome<map::WholeMap> MapFiles::fetch(const map::MapKey& key) {
  const QString path = pathOf(key);
  if (path.isEmpty()) return tl::make_unexpected(failure(key, map::FailureKind::RejectedByRobot));
  auto whole = readLocalMap(path, options_.place, yamls_);
  if (!whole) {
    map::Failure unfit = failure(key, map::FailureKind::MalformedAnswer);
    unfit.reason = map::FailureReason::Unfit;
    unfit.cause = whole.error();
    return tl::make_unexpected(std::move(unfit));
  }
  whole->key = key;
  return std::move(*whole);
}

Outcome<PictureReceipt> MapFiles::writePicture(const PictureChange& change) {
  const QString path = pathOf(change.map);
  const auto fails = [&](map::FailureKind kind, Fault cause) {
    return fail({.kind = kind,
                 .subject = map::subjectOf(change.map, QFileInfo(path).fileName().toStdString()),
                 .asked_for = map::AskedFor::Change,
                 .reason = map::FailureReason::Unfit,
                 .cause = std::move(cause)});
  };
  if (path.isEmpty()) return fails(map::FailureKind::RejectedByRobot, fault::NoSuchMap);
  const disk::FolderLock lock(QFileInfo(path).absolutePath().toStdString());
  const auto now = readLocalMap(path, options_.place, yamls_);
  if (!now) return fails(map::FailureKind::MalformedAnswer, now.error());
  if (now->fingerprint != change.revision)
    return fails(map::FailureKind::Conflict, {fault::FileChanged, {now->path}});
  if (auto trouble = grids::rewritePicture(*change.cells, now->path, now->reading))
    return fails(map::FailureKind::RejectedByRobot, std::move(*trouble));
  const auto written = readLocalMap(path, options_.place, yamls_);
  return PictureReceipt{written ? written->fingerprint : std::string()};
}

}  // namespace mapwright::robot::files

#include "moc_map_files.cpp"
