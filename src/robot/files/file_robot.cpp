#include "robot/files/file_robot.h"

#include <QFileInfo>

#include "grids/rewrite_picture.h"

namespace mapwright::robot::files {
namespace {

Q_LOGGING_CATEGORY(lcFiles, "mapwright.files", QtWarningMsg)

}  // namespace

std::optional<PictureObstacle> FilePictureStore::obstacle(const map::WholeMap& map) const {
  if (map.key.kind != map::MapKind::File || map.path.empty()) return PictureObstacle::NotStored;
  if (!grids::canRewrite(map.path)) return PictureObstacle::FormatNotWritten;
  return std::nullopt;
}

bool FilePictureStore::holdsUnknown(const map::WholeMap& map) const {
  // A gray picture has unknown shades or has not, which its code tells to whoever paints.
  return map.reading.mode == map::CellReading::Mode::Picture ||
         grids::holdsUnknown(map.reading, grids::CellCode::Occupancy, map.path);
}

// What is asked of the disk cannot be taken back: cancelled, it tells how it went all the same.
Call FilePictureStore::write(const PictureChange& change, OutcomeTo<PictureReceipt> reply) {
  return files_.change(map::subjectOf(change.map), std::move(reply), &MapFiles::writePicture, change);
}

FileWaypointStore::FileWaypointStore(WaypointFiles* files) : files_(files) {
  connect(files, &WaypointFiles::changed, this, &WaypointStore::changed);
}

Call FileWaypointStore::read(const map::MapKey& key, OutcomeTo<StoredWaypoints> reply) {
  return files_.ask(map::placesOf(key), std::move(reply), &WaypointFiles::read, key);
}

std::vector<WaypointRequest> FileWaypointStore::plan(const StoredWaypoints& now,
                                                     const std::vector<WaypointChange>& changes) const {
  if (changes.empty()) return {};
  return {WaypointRequest{changes, now.revision}};
}

// Disk operations cannot be undone: even if cancelled, it reports the real result.
Call FileWaypointStore::perform(const map::MapKey& key, const WaypointRequest& request,
                                OutcomeTo<WaypointReceipt> reply) {
  return files_.change(map::placesOf(key), std::move(reply), &WaypointFiles::write, key, request);
}

Call FileOverlayStore::read(const map::MapKey& key, OutcomeTo<OverlayText> reply) {
  return files_.ask(map::subjectOf(key), std::move(reply), &OverlayFiles::read, key);
}

Call FileOverlayStore::write(const map::MapKey& key, const std::string& text,
                             OutcomeTo<std::monostate> reply) {
  return files_.change(map::subjectOf(key), std::move(reply), &OverlayFiles::write, key, text);
}

FileRobot::FileRobot(QString address, FileOptions options, QObject* parent)
    : Robot(parent),
      address_(std::move(address)),
      path_(options.path),
      folder_(!isMapFile(path_) && !isOverlayFile(path_)),
      link_log_(lcFiles(), path_.toStdString()),
      files_(new MapFiles(options)),
      catalogue_(files_),
      whole_maps_(files_),
      waypoint_files_(new WaypointFiles(options)),
      waypoints_(waypoint_files_),
      pictures_(files_),
      overlay_files_(new OverlayFiles(std::move(options))),
      overlays_(overlay_files_) {
  files_->moveToThread(&thread_);
  waypoint_files_->moveToThread(&thread_);
  overlay_files_->moveToThread(&thread_);
  thread_.setObjectName(QStringLiteral("map files"));
  connect(&thread_, &QThread::finished, files_, &QObject::deleteLater);
  connect(&thread_, &QThread::finished, waypoint_files_, &QObject::deleteLater);
  connect(&thread_, &QThread::finished, overlay_files_, &QObject::deleteLater);
  connect(files_, &MapFiles::looked, this, [this](bool folder, const Fault& trouble) {
    if (!wanted_) return;
    if (std::exchange(folder_, folder) != folder) Q_EMIT identityChanged();
    enter(!trouble.any() ? ConnectionPhase::Online : ConnectionPhase::Refused, trouble);
  });
  connect(files_, &MapFiles::changed, this, [this] {
    qCDebug(lcFiles, "%s: changed on disk", qUtf8Printable(path_));
    if (wanted_) Q_EMIT mapsChanged();
  });
  thread_.start();
}

FileRobot::~FileRobot() {
  files_->disconnect(this);
  thread_.requestInterruption();
  thread_.quit();
  thread_.wait();
}

RobotIdentity FileRobot::identity() const {
  RobotIdentity identity;
  identity.model = folder_ ? tr("Folder of maps") : tr("Map file");
  identity.name = QFileInfo(path_).fileName();
  return identity;
}

void FileRobot::connectToRobot() {
  wanted_ = true;
  if (state_.phase != ConnectionPhase::Online) enter(ConnectionPhase::Connecting);
  QMetaObject::invokeMethod(files_, &MapFiles::watch);
}

void FileRobot::disconnectFromRobot() {
  wanted_ = false;
  QMetaObject::invokeMethod(files_, &MapFiles::leave);
  enter(ConnectionPhase::Offline);
}

void FileRobot::enter(ConnectionPhase phase, const Fault& reason) {
  const ConnectionState state{phase, reason, 0, {}, {}};
  if (state == state_) return;
  state_ = state;
  link_log_.record(state);
  Q_EMIT connectionChanged();
}

}  // namespace mapwright::robot::files

#include "moc_file_robot.cpp"
