#include "robot/files/waypoint_files.h"

#include <QCryptographicHash>
#include <QFileInfo>

#include "disk/file_error.h"
#include "disk/folder_lock.h"
#include "disk/read_file.h"
#include "disk/written_file.h"
#include "robot/files/faults.h"

namespace mapwright::robot::files {
namespace {

std::string revisionOf(const std::string& bytes) {
  return QCryptographicHash::hash({bytes.data(), qsizetype(bytes.size())}, QCryptographicHash::Sha256)
      .toHex()
      .toStdString();
}

QString folderOf(const QString& path) { return QFileInfo(path).absolutePath(); }

}  // namespace

WaypointFiles::WaypointFiles(FileOptions options) : options_(std::move(options)) {}

Outcome<WaypointFiles::Place> WaypointFiles::placeOf(const map::MapKey& key) const {
  Place place{key, mapPathOf(options_.path, key), {}};
  if (place.map.isEmpty())
    return tl::make_unexpected(failure(place, map::FailureKind::RejectedByRobot, fault::NoSuchMap));
  // A picture and the map.yaml that describes it are one map.
  const QStringList described_by = yamlsNaming(place.map);
  const QString& named = described_by.size() == 1 ? described_by.front() : place.map;
  place.path = QString::fromStdString(waypointPathOf(named.toStdString()));
  return place;
}

map::Failure WaypointFiles::failure(const Place& place, map::FailureKind kind, Fault cause) const {
  map::Failure failure{kind, map::placesOf(place.key, QFileInfo(place.map).fileName().toStdString())};
  failure.cause = std::move(cause);
  failure.reason = map::FailureReason::Unfit;
  return failure;
}

Outcome<WaypointFiles::Content> WaypointFiles::look(const Place& place) const {
  const std::string path = place.path.toStdString();
  Content content;
  const auto unreadable = [&](Fault why) {
    return tl::make_unexpected(
        failure(place, map::FailureKind::MalformedAnswer,
                {fault::WaypointFileNotRead, {path}, {std::move(why)}, Consequence::LeftAsItIs}));
  };
  if (QFileInfo::exists(place.path) || QFileInfo(place.path).isSymLink()) {
    auto bytes = disk::readFile(path, kMaxWaypointBytes + 1);
    if (!bytes) return unreadable(bytes.error().cause);
    if (bytes->size() > kMaxWaypointBytes) return unreadable({fault::FileTooLarge, {"64 MiB"}});
    if (bytes->empty()) return unreadable(fault::FileEmpty);
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
  const auto place = placeOf(key);
  if (!place) return tl::make_unexpected(place.error());
  watch(place->path);
  auto content = look(*place);
  if (!content) return tl::make_unexpected(content.error());
  return std::move(content->waypoints);
}

Outcome<WaypointReceipt> WaypointFiles::write(const map::MapKey& key, const WaypointRequest& request) {
  const auto place = placeOf(key);
  if (!place) return tl::make_unexpected(place.error());
  const disk::FolderLock lock(folderOf(place->path).toStdString());
  const auto content = look(*place);
  if (!content) return tl::make_unexpected(content.error());
  if (content->waypoints.revision != request.revision) {
    return tl::make_unexpected(
        failure(*place, map::FailureKind::Conflict, {fault::FileChanged, {place->path.toStdString()}}));
  }
  const auto bytes = patchWaypoints(content->bytes, request.changes);
  if (!bytes) return tl::make_unexpected(failure(*place, map::FailureKind::MalformedAnswer, bytes.error()));
  if (const auto fault = disk::writeFile(place->path.toStdString(), *bytes))
    return tl::make_unexpected(failure(*place, map::FailureKind::RejectedByRobot, disk::notWritten(*fault)));
  watch(place->path);
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

#include "moc_waypoint_files.cpp"
