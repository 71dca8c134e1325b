#include "robot/files/file_picture_store.h"

#include "grids/rewrite_picture.h"

namespace mapwright::robot::files {

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

}  // namespace mapwright::robot::files

#include "moc_file_picture_store.cpp"
