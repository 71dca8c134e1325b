#include "robot/files/picture_files.h"

#include <QFileInfo>

#include "disk/folder_lock.h"
#include "grids/rewrite_picture.h"
#include "robot/files/faults.h"

namespace mapwright::robot::files {
namespace {

map::Failure failure(const map::MapKey& key, const QString& path, map::FailureKind kind, Fault cause) {
  map::Failure failed;
  failed.kind = kind;
  failed.subject = map::subjectOf(key, QFileInfo(path).fileName().toStdString());
  failed.asked_for = map::AskedFor::Change;
  failed.cause = std::move(cause);
  failed.reason = map::FailureReason::Unfit;
  return failed;
}

}  // namespace

PictureFiles::PictureFiles(FileOptions options) : options_(std::move(options)) {}

Outcome<PictureReceipt> PictureFiles::write(const PictureChange& change) {
  const QString path = mapPathOf(options_.path, change.map);
  const auto fails = [&](map::FailureKind kind, Fault cause) {
    return tl::make_unexpected(failure(change.map, path, kind, std::move(cause)));
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

FilePictureStore::FilePictureStore(PictureFiles* files, QObject* parent)
    : PictureStore(parent), files_(files) {}

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
  return files_.change(map::subjectOf(change.map), std::move(reply), &PictureFiles::write, change);
}

}  // namespace mapwright::robot::files

#include "moc_picture_files.cpp"
