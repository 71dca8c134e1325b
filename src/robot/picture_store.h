// The port: editable pictures of maps. Source: docs/protocols/kabam-map-manager.md, "Pictures".
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <QObject>

#include "grids/grid_pyramid.h"
#include "map/catalogue.h"
#include "robot/call.h"

namespace mapwright::robot {

/// Why the picture of a map cannot be changed.
enum class PictureObstacle {
  NotStored,         // it is not a stored map but, for example, the live one
  FormatNotWritten,  // the format of its picture is read-only
};

/// The new picture. Position, size and resolution stay the same.
struct PictureChange {
  map::MapKey map;
  std::shared_ptr<const grids::GridPyramid> cells;  // complete; of the picture's size and code
  std::string revision;                             // WholeMap::fingerprint of the version it is based on
};

struct PictureReceipt {
  std::string revision;  // WholeMap::fingerprint of the stored version
};

/// Capability: replace the picture of a map. Call it on the thread that made the robot; results arrive there,
/// too. See robot/call.h for how a request ends.
class PictureStore : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  /// nullopt: it can be changed. `map`: as received. Sends nothing.
  virtual std::optional<PictureObstacle> obstacle(const map::WholeMap& map) const = 0;
  /// Unknown cells can be written to the picture of this map. Sends nothing.
  virtual bool holdsUnknown(const map::WholeMap& map) const = 0;
  /// Cells with this byte, in the code of the map, can be written. Sends nothing.
  virtual bool holdsCell(const map::WholeMap& /*map*/, std::uint8_t /*cell*/) const { return true; }
  /// Writes it completely or not at all, reads it back and compares. FailureKind::Conflict: the stored
  /// version is another one, and nothing was written.
  virtual Call write(const PictureChange& change, OutcomeTo<PictureReceipt> reply) = 0;

 Q_SIGNALS:
  /// The stored picture of that map may have changed: request the map again. Not needed if
  /// Robot::mapsChanged() already reports it.
  void changed(const mapwright::map::MapKey& map);
};

}  // namespace mapwright::robot
