// A whole map in a folder, with the data that a robot positions itself by: downloaded, and read to be added
// to a robot. The folder is whole once it holds map.json, which is written last and has the size and the
// SHA-256 of the others: map.png, map.pbstream (if the robot has it) and overlays.geojson (if there are any).
#pragma once

#include <cstdint>

#include <QString>
#include <tl/expected.hpp>

#include "robot/map_transfer.h"

namespace mapwright::jobs {

struct DownloadedMap {
  QString folder;
  robot::MapFacts facts;
  std::int64_t bytes = 0;  // of all files
  bool resumed = false;    // an earlier part was resumed
  bool has_data = false;   // false: the robot has none
};

/// Why nothing is downloaded into this folder; empty if it is. `force`: a map that is there is replaced.
QString noMapFolderReason(const QString& folder, bool force);
/// Downloads a stored map; what is left of an earlier try is gone on with. Cancelled or interrupted, the
/// folder keeps the part, without a map.json. No result if `transfer` is destroyed first. A failure that is
/// about this computer has isAboutFiles().
robot::Call downloadMap(robot::MapTransfer& transfer, const map::MapKey& key, const QString& folder,
                        robot::OutcomeTo<DownloadedMap> reply);
bool isAboutFiles(const map::Failure& failure);

/// The map of a folder; the error is a sentence. Blocks while it reads. `as_new`: without its uid and its
/// versions.
tl::expected<robot::NewMap, QString> readMapFolder(const QString& folder, bool as_new);

}  // namespace mapwright::jobs
