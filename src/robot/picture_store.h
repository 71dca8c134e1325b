// The port: pictures of maps that can be changed. Source: docs/protocols/kabam-map-manager.md, "Pictures".
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

/// Why the picture of one map cannot be changed.
enum class PictureObstacle {
  NotStored,         // it is what the robot sends now, or the like: nothing that is kept
  FormatNotWritten,  // its picture is of a kind that can only be read
};

/// A picture as it is to be. Its place, size and resolution stay.
struct PictureChange {
  map::MapKey map;
  std::shared_ptr<const grids::GridPyramid>
      cells;             // complete; of the size and code that the picture came with
  std::string revision;  // WholeMap::fingerprint of what it was made of
};

struct PictureReceipt {
  std::string revision;  // WholeMap::fingerprint of what is kept now
};

/// Capability: the picture of a map, written anew. Called on the thread that made the robot; what it hands
/// out comes there, too. See robot/call.h for how a request ends.
class PictureStore : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;
  /// nullopt: it can be changed. `map`: as it came. Asks nobody.
  virtual std::optional<PictureObstacle> obstacle(const map::WholeMap& map) const = 0;
  /// Unknown ground can be written into the picture of this map. Asks nobody.
  virtual bool holdsUnknown(const map::WholeMap& map) const = 0;
  /// A cell with this byte, of the code that the map has, can be written. Asks nobody.
  virtual bool holdsCell(const map::WholeMap& /*map*/, std::uint8_t /*cell*/) const { return true; }
  /// Writes it whole or not at all, reads it back and compares. FailureKind::Conflict: what is kept is no
  /// longer of that revision; nothing is written then.
  virtual Call write(const PictureChange& change, OutcomeTo<PictureReceipt> reply) = 0;

 Q_SIGNALS:
  /// What is kept of that map may be another picture: ask for the map again. Stores whose maps tell that by
  /// Robot::mapsChanged() need not say it.
  void changed(const mapwright::map::MapKey& map);
};

}  // namespace mapwright::robot
