// The picture that a robot has, kept as a local map before it is overwritten: the newest few of each map.
// Pure functions over the disk; any thread.
#pragma once

#include <optional>

#include <QDateTime>
#include <QString>

#include "fault/fault.h"
#include "grids/grid_pyramid.h"
#include "map/grid_reference.h"

namespace mapwright::window {

/// So many of each map stay; the oldest go.
inline constexpr int kMostCopies = 10;

/// Where those of one map lie, beside the drafts; empty: nothing is kept at all. The names may be anything.
QString copiesFolder(const QString& drafts_folder, const QString& robot, const QString& map);
/// The map.yaml of a copy of that time; its picture lies beside it.
QString copyPath(const QString& folder, const QDateTime& now);
/// Writes it, whole or not at all, and lets the oldest of its folder go; nullopt = it is there, else why not.
std::optional<Fault> keepCopy(const grids::GridPyramid& cells, const map::GridReference& reference,
                              const QString& path);

}  // namespace mapwright::window
