// The port: whole maps on their way from and to a robot, with the data that it positions itself by. Source:
// docs/protocols/autoxing.md, "Requests", "What changes a robot".
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <QString>

#include "map/catalogue.h"
#include "map/grid_reference.h"
#include "robot/call.h"

namespace mapwright::robot {

/// A stored map without its picture and its data. Texts are untrusted.
struct MapFacts {
  map::MapKey key;
  std::string name, uid;
  std::optional<int> map_version, overlays_version;
  map::GridReference grid;  // the size is that of the picture, if known
  std::string overlays;     // GeoJSON as stored; may be empty
  std::optional<std::int64_t> picture_bytes, data_bytes;
  bool operator==(const MapFacts&) const = default;
};

/// A map with its picture (PNG). Null: a map that was added has none that can be loaded.
struct MapParts {
  MapFacts facts;
  std::shared_ptr<const std::string> picture;
};

/// A map to be added to those of a robot.
struct NewMap {
  std::string name, uid;  // an empty uid: the robot makes one
  std::optional<int> map_version, overlays_version;
  map::GridReference grid;
  std::shared_ptr<const std::string> picture;  // PNG
  std::shared_ptr<const std::string> data;     // null: none
  std::string overlays;                        // may be empty
};

/// The data of a map in a file.
struct DataDownload {
  QString path;
  std::int64_t bytes = 0;
  bool resumed = false;  // an earlier part was resumed
};

class MapTransfer {
 public:
  virtual ~MapTransfer() = default;
  /// A stored map as the robot has it now.
  virtual Call parts(const map::MapKey& key, OutcomeTo<MapParts> reply) = 0;
  /// The data of `of` to a file: first next to `path` (".part"), then renamed. Resumes an earlier part of the
  /// same data if the robot supports it, otherwise starts over.
  virtual Call download(const MapFacts& of, const QString& path, OutcomeTo<DataDownload> reply) = 0;
  /// Sent once; the answer is the new map, read back. A FailureKind::Conflict says that the robot has a map
  /// of this uid. If the failure's applied is Maybe, check the catalogue before you repeat it.
  virtual Call add(const NewMap& map, OutcomeTo<MapParts> reply) = 0;
};

}  // namespace mapwright::robot
