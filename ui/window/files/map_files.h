// Map files and recordings as people open them: which ones there are, and their addresses. Pure but for a
// look at the disk.
#pragma once

#include <optional>

#include <QList>
#include <QString>
#include <QUrl>

#include "geometry/pose.h"

namespace mapwright::window {

/// How a bare picture lies in the world.
struct PicturePlacement {
  double resolution_m = 0.05;  // metres per cell
  geometry::Pose2 origin;      // of the lower-left corner
};

bool isMapYaml(const QString& path);
bool isBarePicture(const QString& path);
/// By its name: MCAP, or a bag of ROS 1.
bool isRecordingFile(const QString& path);
/// "file:/maps/a.yaml", "file:/maps/a.png?resolution=0.05&origin=-1,2,0".
QString fileAddress(const QString& path, const std::optional<PicturePlacement>& placement = {});
/// The one thing among what was dropped that can be opened: a map.yaml, a recording, a picture or a folder.
/// Empty = none.
QString droppedMap(const QList<QUrl>& urls);
/// For file dialogs: maps and recordings.
QString mapFileFilter();

}  // namespace mapwright::window
