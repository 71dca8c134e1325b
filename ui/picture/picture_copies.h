// Backups of a robot's picture as local maps before it is overwritten: the newest few of each map. Functions
// of the disk; any thread.
#pragma once

#include <optional>

#include <QDateTime>
#include <QString>

#include "fault/fault.h"
#include "grids/grid_pyramid.h"
#include "map/grid_reference.h"

namespace mapwright::window {

/// The oldest beyond this number are deleted.
inline constexpr int kMostCopies = 10;

/// The folder for one map, next to the drafts; empty: no backups. Names are sanitised.
QString copiesFolder(const QString& drafts_folder, const QString& robot, const QString& map);
/// The map.yaml of a backup at that time; its picture is in the same folder.
QString copyPath(const QString& folder, const QDateTime& now);
/// Writes it completely or not at all, and deletes the oldest in its folder; nullopt = success, otherwise why
/// not.
std::optional<Fault> keepCopy(const grids::GridPyramid& cells, const map::GridReference& reference,
                              const QString& path);

}  // namespace mapwright::window
