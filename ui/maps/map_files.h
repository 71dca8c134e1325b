// Map files and recordings that can be opened, and their addresses. Pure except for a look at the disk.
#pragma once

#include <optional>

#include <QList>
#include <QString>
#include <QUrl>

#include "geometry/pose.h"

namespace mapwright::window {

/// The position of a plain picture in the world.
struct PicturePlacement {
  double resolution_m = 0.05;  // metres per cell
  geometry::Pose2 origin;      // of the lower-left corner
};

bool isMapYaml(const QString& path);
bool isBarePicture(const QString& path);
/// By its extension: MCAP, or ROS 1 bag.
bool isRecordingFile(const QString& path);
/// "file:/maps/a.yaml", "file:/maps/a.png?resolution=0.05&origin=-1,2,0".
QString fileAddress(const QString& path, const std::optional<PicturePlacement>& placement = {});
/// The one dropped file that can be opened: a map.yaml, a recording, a picture or a folder. Empty = none.
QString droppedMap(const QList<QUrl>& urls);
/// For file dialogs: maps and recordings.
QString mapFileFilter();

}  // namespace mapwright::window
