#include "robot/files/overlay_file.h"

#include <utility>

#include <QFileInfo>

#include "disk/file_error.h"
#include "disk/folder_lock.h"
#include "disk/read_file.h"
#include "disk/written_file.h"
#include "overlays/drawn_parts.h"
#include "robot/files/faults.h"

namespace mapwright::robot::files {

QString overlayPathOf(const QString& map_path) {
  if (isOverlayFile(map_path)) return map_path;
  const QFileInfo map(map_path);
  const QString stem = map.absolutePath() + QLatin1Char('/') + map.completeBaseName();
  const QString own = stem + QStringLiteral(".overlays.geojson"), plain = stem + QStringLiteral(".geojson");
  return !QFileInfo::exists(own) && QFileInfo::exists(plain) ? plain : own;
}

namespace {

/// A picture and the map.yaml that describes it are one map.
QString overlayPathOfMap(const QString& map_path) {
  const QStringList described_by = yamlsNaming(map_path);
  return overlayPathOf(described_by.size() == 1 ? described_by.front() : map_path);
}

/// Empty if there is no such file.
tl::expected<std::string, Fault> textIn(const QString& path) {
  if (!QFileInfo::exists(path) && !QFileInfo(path).isSymLink()) return std::string();
  auto bytes = disk::readFile(path.toStdString(), kMaxOverlayBytes + 1);
  if (!bytes) return tl::make_unexpected(bytes.error().cause);
  if (bytes->size() > kMaxOverlayBytes) return tl::make_unexpected(Fault(fault::FileTooLarge, {"256 MiB"}));
  // Nobody means to say "no overlays" so: it is being written, or the disk was full.
  if (bytes->empty()) return tl::make_unexpected(Fault(fault::FileEmpty));
  return std::move(*bytes);
}

}  // namespace

tl::expected<OverlaysBeside, Fault> overlaysBeside(const QString& map_path) {
  const QString path = overlayPathOfMap(map_path);
  const auto unreadable = [&path](Fault why) {
    return tl::make_unexpected(Fault(fault::WaypointFileNotRead, {path.toStdString()}, {std::move(why)}));
  };
  auto text = textIn(path);
  if (!text) return unreadable(text.error());
  const auto document = overlays::OverlayDocument::read(std::move(*text));
  if (!document) return unreadable(document.error());
  OverlaysBeside beside;
  for (const overlays::Feature& feature : document->features()) {
    for (map::OverlayFeature& part : overlays::partsToDraw(feature)) beside.drawn.push_back(std::move(part));
    if (auto broken = overlays::notDrawn(feature)) beside.broken.push_back(std::move(*broken));
  }
  return beside;
}

OverlayFiles::OverlayFiles(FileOptions options) : options_(std::move(options)) {}

Outcome<OverlayFiles::Location> OverlayFiles::locationOf(const map::MapKey& key) const {
  Location location{key, mapPathOf(options_.path, key), {}};
  if (location.map.isEmpty())
    return fail(failure(location, map::FailureKind::RejectedByRobot, fault::NoSuchMap));
  location.path = overlayPathOfMap(location.map);
  return location;
}

map::Failure OverlayFiles::failure(const Location& location, map::FailureKind kind, Fault cause) const {
  map::Failure failure{kind, map::subjectOf(location.key, QFileInfo(location.map).fileName().toStdString())};
  failure.cause = std::move(cause);
  failure.reason = map::FailureReason::Unfit;
  return failure;
}

Outcome<std::string> OverlayFiles::textOf(const Location& location) const {
  auto text = textIn(location.path);
  if (!text)
    return fail(failure(location, map::FailureKind::MalformedAnswer,
                        {fault::WaypointFileNotRead,
                         {location.path.toStdString()},
                         {std::move(text.error())},
                         Consequence::LeftAsItIs}));
  return std::move(*text);
}

OverlayText OverlayFiles::remember(const Location& location, std::string text) {
  Known& known = known_[location.path];
  if (known.version == 0 || known.text != text) ++known.version;
  known.text = std::move(text);
  return {known.text, known.version, {}, QFileInfo(location.path).fileName().toStdString()};
}

Outcome<OverlayText> OverlayFiles::read(const map::MapKey& key) {
  const auto location = locationOf(key);
  if (!location) return fail(location.error());
  auto text = textOf(*location);
  if (!text) return fail(text.error());
  return remember(*location, std::move(*text));
}

Outcome<std::monostate> OverlayFiles::write(const map::MapKey& key, const std::string& text) {
  const auto location = locationOf(key);
  if (!location) return fail(location.error());
  const disk::FolderLock lock(QFileInfo(location->path).absolutePath().toStdString());
  const auto now = textOf(*location);
  if (!now) return fail(now.error());
  const auto known = known_.find(location->path);
  const auto conflict = [&] {
    map::Failure changed =
        failure(*location, map::FailureKind::Conflict, {fault::FileChanged, {location->path.toStdString()}});
    changed.asked_for = map::AskedFor::Change;
    changed.applied = map::Applied::No;
    return changed;
  };
  if (known == known_.end() || known->second.text != *now) return fail(conflict());
  if (const auto trouble = disk::writeFile(location->path.toStdString(), text)) {
    map::Failure refused = failure(*location, map::FailureKind::RejectedByRobot, disk::notWritten(*trouble));
    refused.asked_for = map::AskedFor::Change;
    refused.applied = map::Applied::No;
    return fail(std::move(refused));
  }
  remember(*location, text);
  return std::monostate();
}

}  // namespace mapwright::robot::files

#include "moc_overlay_file.cpp"
