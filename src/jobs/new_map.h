// A map that is added to those of a robot: what is checked before, and what the robot holds of it afterwards.
#pragma once

#include <memory>
#include <string>

#include <QString>
#include <QStringList>
#include <tl/expected.hpp>

#include "robot/map_transfer.h"

namespace mapwright::jobs {

/// The resolutions (metres per cell) that maps of robots have.
inline constexpr double kFinestMapM = 0.005, kCoarsestMapM = 1;

/// A map made of a picture: a PNG file, its resolution, and where its lower left corner lies.
struct PictureMap {
  QString path, name;
  double resolution_m = 0;
  double x_m = 0, y_m = 0;
};

/// Why it cannot be a map, without the picture; empty if it can.
QString noPlaceOfMapReason(double resolution_m, double x_m, double y_m);
struct MapFromPicture {
  robot::NewMap map;
  /// The picture had transparent pixels. They are sent as opaque gray: robots may look at the colour only,
  /// and a transparent pixel may have any.
  bool made_opaque = false;
};
/// Ready to be sent; the error is a sentence. Blocks while it reads the picture.
tl::expected<MapFromPicture, QString> newMapFrom(const PictureMap& picture);
/// A picture file as it is, within the size that can be sent; the error is a sentence. Blocks.
tl::expected<std::shared_ptr<const std::string>, QString> readMapPicture(const QString& path);
/// The size of a picture that can be a map: checked to its last row.
struct PictureSize {
  int width = 0, height = 0;
};
tl::expected<PictureSize, QString> sizeOfMapPicture(const std::shared_ptr<const std::string>& png);

/// What the robot holds otherwise than it was sent: sentences; none if it is the same. Blocks while it reads
/// a picture that is not the same file any more.
QStringList differences(const robot::NewMap& sent, const robot::MapParts& held);

}  // namespace mapwright::jobs
