#include "robot/files/map_files.h"

#include <QCryptographicHash>
#include <QFileInfo>
#include <QSet>
#include <QThread>

#include "disk/file_error.h"
#include "disk/folder_lock.h"
#include "disk/read_file.h"
#include "disk/written_file.h"
#include "grids/rewrite_picture.h"
#include "grids/thumbnail.h"
#include "robot/faults.h"
#include "robot/files/faults.h"
#include "robot/files/overlay_file.h"
#include "robot/files/waypoint_file.h"

namespace mapwright::robot::files {
namespace {

constexpr qsizetype kMostWatched = 1'000;  // a larger folder is only watched as a folder

QString stamp(const QString& path) { return QString::fromStdString(stampOf(path)); }

bool isWantedNoMore() { return QThread::currentThread()->isInterruptionRequested(); }

std::string revisionOf(const std::string& bytes) {
  return QCryptographicHash::hash({bytes.data(), qsizetype(bytes.size())}, QCryptographicHash::Sha256)
      .toHex()
      .toStdString();
}

QString folderOf(const QString& path) { return QFileInfo(path).absolutePath(); }

}  // namespace

MapFiles::MapFiles(FileOptions options) : options_(std::move(options)) {}

void MapFiles::start() {
  if (watcher_) return;
  watcher_ = std::make_unique<QFileSystemWatcher>();
  settle_ = std::make_unique<QTimer>();
  settle_->setSingleShot(true);
  settle_->setInterval(options_.settle);
  connect(settle_.get(), &QTimer::timeout, this, &MapFiles::notifyChanged);
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
    Q_EMIT looked(true, any ? Fault()
                            : Fault(faultText("files", "There are no maps (map.yaml, PNG, PGM, BMP) in %1."),
                                    {options_.path.toStdString()}));
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
    if (!isFolder()) files << beside.naming(path) << overlayPathOf(path);
    const auto whole = readLocalMap(path, options_.place, yamls_, &beside);
    if (whole && !whole->path.empty() && whole->path != path.toStdString()) {
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

void MapFiles::notifyChanged() {
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
      const QString path = options_.path + QLatin1Char('/') + name;
      // A picture and the map.yaml that names it are one map.
      if (isPicture(name) && !beside.naming(path).isEmpty()) continue;
      entries.push_back(
          entryOf({map::MapKind::File, name.toStdString()}, path, options_.place, yamls_, &beside));
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
  if (path.isEmpty()) return fail(failure(key, map::FailureKind::RejectedByRobot));
  return entryOf(key, path, options_.place, yamls_);
}

Outcome<std::string> MapFiles::thumbnail(const map::MapKey& key) {
  auto whole = fetch(key);
  const auto picture = whole ? grids::thumbnailOf(*whole, isWantedNoMore) : tl::make_unexpected(Fault());
  if (picture) return *picture;
  map::Failure none = whole ? failure(key, map::FailureKind::MalformedAnswer) : whole.error();
  none.asked_for = map::AskedFor::SmallPicture;
  none.reason = map::FailureReason::Unfit;
  if (whole) none.cause = picture.error();
  return fail(std::move(none));
}

Outcome<map::WholeMap> MapFiles::fetch(const map::MapKey& key) {
  const QString path = pathOf(key);
  if (path.isEmpty()) return fail(failure(key, map::FailureKind::RejectedByRobot));
  auto whole = readLocalMap(path, options_.place, yamls_);
  if (!whole) {
    map::Failure unfit = failure(key, map::FailureKind::MalformedAnswer);
    unfit.reason = map::FailureReason::Unfit;
    unfit.cause = whole.error();
    return fail(std::move(unfit));
  }
  whole->key = key;
  if (auto overlays = overlaysBeside(path)) {
    whole->overlays = std::move(overlays->drawn);
    whole->broken_overlays = std::move(overlays->broken);
    if (const auto count = std::int64_t(whole->broken_overlays.size()); count > 0)
      whole->notes.push_back({map::Severity::Warning,
                              map::subjectOf(key, whole->name),
                              {robot::fault::FeaturesUnreadable, {count}},
                              map::ProblemCode::Unreadable});
  } else {
    whole->notes.push_back({map::Severity::Warning, map::subjectOf(key, whole->name),
                            std::move(overlays.error()).followedBy(Consequence::ShownWithoutIt),
                            map::ProblemCode::Unreadable});
  }
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

WaypointFiles::WaypointFiles(FileOptions options) : options_(std::move(options)) {}

Outcome<WaypointFiles::Location> WaypointFiles::locationOf(const map::MapKey& key) const {
  Location location{key, mapPathOf(options_.path, key), {}};
  if (location.map.isEmpty())
    return fail(failure(location, map::FailureKind::RejectedByRobot, fault::NoSuchMap));
  // A picture and the map.yaml that describes it are one map.
  const QString beside = isOverlayFile(location.map) ? mapBeside(location.map) : QString();
  const QString map = beside.isEmpty() ? location.map : beside;
  const QStringList described_by = yamlsNaming(map);
  const QString& named = described_by.size() == 1 ? described_by.front() : map;
  location.path = QString::fromStdString(waypointPathOf(named.toStdString()));
  return location;
}

map::Failure WaypointFiles::failure(const Location& location, map::FailureKind kind, Fault cause) const {
  map::Failure failure{kind, map::placesOf(location.key, QFileInfo(location.map).fileName().toStdString())};
  failure.cause = std::move(cause);
  failure.reason = map::FailureReason::Unfit;
  return failure;
}

Outcome<WaypointFiles::Content> WaypointFiles::look(const Location& location) const {
  const std::string path = location.path.toStdString();
  Content content;
  const auto unreadable = [&](Fault why) {
    return tl::make_unexpected(
        failure(location, map::FailureKind::MalformedAnswer,
                {fault::WaypointFileNotRead, {path}, {std::move(why)}, Consequence::LeftAsItIs}));
  };
  if (QFileInfo::exists(location.path) || QFileInfo(location.path).isSymLink()) {
    auto bytes = disk::readFile(path, kMaxWaypointBytes + 1);
    if (!bytes) return unreadable(bytes.error().cause);
    if (bytes->size() > kMaxWaypointBytes) return unreadable({fault::FileTooLarge, {"64 MiB"}});
    if (bytes->empty()) return unreadable({fault::FileEmpty});
    auto waypoints = parseWaypoints(*bytes);
    if (!waypoints) return unreadable(waypoints.error());
    content.bytes = std::move(*bytes);
    content.waypoints = std::move(*waypoints);
  }
  content.waypoints.there = !content.bytes.empty();
  content.waypoints.revision = revisionOf(content.bytes);
  return content;
}

Outcome<StoredWaypoints> WaypointFiles::read(const map::MapKey& key) {
  const auto location = locationOf(key);
  if (!location) return fail(location.error());
  watch(location->path);
  auto content = look(*location);
  if (!content) return fail(content.error());
  return std::move(content->waypoints);
}

Outcome<WaypointReceipt> WaypointFiles::write(const map::MapKey& key, const WaypointRequest& request) {
  const auto location = locationOf(key);
  if (!location) return fail(location.error());
  const disk::FolderLock lock(folderOf(location->path).toStdString());
  const auto content = look(*location);
  if (!content) return fail(content.error());
  if (content->waypoints.revision != request.revision) {
    return tl::make_unexpected(
        failure(*location, map::FailureKind::Conflict, {fault::FileChanged, {location->path.toStdString()}}));
  }
  const auto bytes = patchWaypoints(content->bytes, request.changes);
  if (!bytes) return fail(failure(*location, map::FailureKind::MalformedAnswer, bytes.error()));
  if (const auto fault = disk::writeFile(location->path.toStdString(), *bytes))
    return fail(failure(*location, map::FailureKind::RejectedByRobot, disk::notWritten(*fault)));
  watch(location->path);
  return WaypointReceipt{};
}

void WaypointFiles::watch(const QString& path) {
  if (!watcher_) {
    watcher_ = std::make_unique<QFileSystemWatcher>();
    settle_ = std::make_unique<QTimer>();
    settle_->setSingleShot(true);
    settle_->setInterval(options_.settle);
    connect(settle_.get(), &QTimer::timeout, this, &WaypointFiles::compare);
    for (auto signal : {&QFileSystemWatcher::fileChanged, &QFileSystemWatcher::directoryChanged})
      connect(watcher_.get(), signal, this, [this] { settle_->start(); });
  }
  stamps_[path] = stampOf(path);
  // The watcher loses a file that is replaced by renaming; watching its folder helps.
  watcher_->addPath(folderOf(path));
  if (QFileInfo::exists(path)) watcher_->addPath(path);
}

void WaypointFiles::compare() {
  bool any = false;
  for (auto& [path, stamp] : stamps_) {
    const std::string now = stampOf(path);
    if (std::exchange(stamp, now) == now) continue;
    any = true;
    if (QFileInfo::exists(path)) watcher_->addPath(path);
  }
  if (any) Q_EMIT changed();
}

}  // namespace mapwright::robot::files

#include "moc_map_files.cpp"
