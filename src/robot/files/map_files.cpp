#include "robot/files/map_files.h"

#include <QFileInfo>
#include <QSet>
#include <QThread>

namespace mapwright::robot::files {
namespace {

constexpr qsizetype kMostWatched = 1'000;  // a folder of more is watched as a folder only

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
  // Files that are replaced by renaming are lost to the watcher; their folder tells.
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
    Q_EMIT looked(
        true, any ? QString() : tr("There are no maps (map.yaml, PNG, PGM, BMP) in %1.").arg(options_.path));
    return;
  }
  const auto whole = readLocalMap(options_.path, options_.place, yamls_);
  Q_EMIT looked(false, whole ? QString() : QString::fromStdString(whole.error()));
}

QStringList MapFiles::watchAndStamp() {
  QStringList files, folders;
  const PictureYamls beside(isFolder() ? options_.path : QFileInfo(options_.path).absolutePath());
  const auto add = [&](const QString& path) {
    files << path;
    folders << QFileInfo(path).absolutePath();
    // A picture alone lies where the map.yaml beside it says.
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

QString MapFiles::pathOf(const map::MapKey& key) const {
  if (key.kind != map::MapKind::File) return {};
  const QString id = QString::fromStdString(key.id);
  if (!isFolder())
    return id.isEmpty() || id == QFileInfo(options_.path).fileName() ? options_.path : QString();
  // Only what the list holds: an id is no way out of the folder.
  const bool plain = isMapFile(id) && !id.contains(QLatin1Char('/')) && !id.contains(QChar::Null);
  const QString path = options_.path + QLatin1Char('/') + id;
  return plain && QFileInfo(path).isFile() ? path : QString();
}

map::Problem MapFiles::problem(const map::MapKey& key, std::string sentence) const {
  const std::string name =
      key.id.empty() ? QFileInfo(options_.path).fileName().toStdString() : key.id.substr(0, 200);
  return {map::Severity::Error, map::subjectOf(key, name), std::move(sentence),
          map::ProblemCode::Unavailable};
}

Answer<std::vector<map::CatalogueEntry>> MapFiles::list() {
  std::vector<map::CatalogueEntry> entries;
  if (isFolder()) {
    const PictureYamls beside(options_.path);
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

Answer<map::CatalogueEntry> MapFiles::describe(const map::MapKey& key) {
  const QString path = pathOf(key);
  if (path.isEmpty()) return tl::make_unexpected(problem(key, "There is no such map."));
  return entryOf(key, path, options_.place, yamls_);
}

Answer<map::WholeMap> MapFiles::fetch(const map::MapKey& key) {
  const QString path = pathOf(key);
  if (path.isEmpty()) return tl::make_unexpected(problem(key, "There is no such map."));
  auto whole = readLocalMap(path, options_.place, yamls_);
  if (!whole) return tl::make_unexpected(problem(key, whole.error()));
  whole->key = key;
  return std::move(*whole);
}

}  // namespace mapwright::robot::files
