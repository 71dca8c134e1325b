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
  // Whether a gray picture has unknown gray levels is known from its code.
  return map.reading.mode == map::CellReading::Mode::Picture ||
         grids::holdsUnknown(map.reading, grids::CellCode::Occupancy, map.path);
}

// Disk operations cannot be undone: even if cancelled, it reports the real result.
Call FilePictureStore::write(const PictureChange& change, OutcomeTo<PictureReceipt> reply) {
  return wire::askAcross(
      this, files_, writes_, map::subjectOf(change.map), std::move(reply),
      [change](PictureFiles& files, const auto&, auto answer) { answer(files.write(change)); },
      wire::Stopping::AsItStands);
}

}  // namespace mapwright::robot::files

#include "moc_picture_files.cpp"
