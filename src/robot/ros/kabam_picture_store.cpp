#include "robot/ros/kabam_picture_store.h"

#include <utility>

#include "robot/ros/kabam_picture.h"

namespace mapwright::robot::ros {

KabamPictureStore::KabamPictureStore(RosLink* link, QObject* parent) : PictureStore(parent), link_(link) {
  connect(link_, &RosLink::pictureChanged, this, [this](const QString& map_id) {
    Q_EMIT changed({map::MapKind::Stored, map_id.toStdString()});
  });
}

std::optional<PictureObstacle> KabamPictureStore::obstacle(const map::WholeMap& map) const {
  if (map.key.kind != map::MapKind::Stored) return PictureObstacle::NotStored;
  return std::nullopt;
}

bool KabamPictureStore::holdsCell(const map::WholeMap&, std::uint8_t cell) const {
  return shadeOf(cell).has_value();
}

Call KabamPictureStore::write(const PictureChange& change, OutcomeTo<PictureReceipt> reply) {
  return wire::askAcross(
      this, link_, writes_, map::subjectOf(change.map), std::move(reply),
      [change](RosLink& link, auto errand, auto answer) {
        link.writePicture(errand, change, std::move(answer));
      },
      wire::Stopping::AsItStands);
}

}  // namespace mapwright::robot::ros

#include "moc_kabam_picture_store.cpp"
