// Copies of the pictures of robots' maps, kept on this computer before they are overwritten: local maps in a
// folder for each robot and map. Any thread; reads and writes the disk.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include <QDateTime>
#include <QString>
#include <QStringList>
#include <tl/expected.hpp>

#include "fault/fault.h"
#include "grids/grid_pyramid.h"
#include "map/grid_reference.h"

namespace mapwright::edit {

/// Of each map the newest ones are kept, the others deleted.
inline constexpr int kMostCopies = 10;
/// Beyond this sum of all maps the oldest are deleted, but never the newest of a map.
inline constexpr qint64 kMostCopyBytes = 2'000'000'000;

/// The folder of all copies, next to the drafts, and the one for a map; empty: none are kept. Names are
/// sanitised.
QString allCopiesFolder(const QString& drafts_folder);
QString copiesFolder(const QString& drafts_folder, const QString& robot, const QString& map);
/// The map.yaml of a copy at that time; its picture is in the same folder.
QString copyPath(const QString& folder, const QDateTime& now);
/// Writes it completely or not at all, and deletes those that are too many; nullopt = success, otherwise why
/// not.
std::optional<Fault> keepCopy(const grids::GridPyramid& cells, const map::GridReference& reference,
                              const QString& path);

struct PictureCopy {
  QString path;        // of its map.yaml
  QString robot, map;  // as in the names of its folders
  QDateTime made;
  QString called = {};        // the robot; empty: it is not known
  int width = 0, height = 0;  // cells; 0: unreadable
  qint64 bytes = 0;

  QString folder() const;
};
/// Below the folder of all copies, the newest first.
std::vector<PictureCopy> copiesKept(const QString& all_folder);
/// Which of them are to be deleted.
std::vector<PictureCopy> copiesTooMany(const std::vector<PictureCopy>& newest_first,
                                       qint64 most_bytes = kMostCopyBytes);

struct ReadCopy {
  std::shared_ptr<const grids::GridPyramid> cells;
  map::GridReference place;
};
/// The error is a sentence.
tl::expected<ReadCopy, QString> readCopy(const QString& path, const std::atomic<bool>& cancelled);

}  // namespace mapwright::edit
