// The port: changes of the maps stored on a robot. Source: docs/protocols/autoxing.md, "Requests",
// docs/protocols/kabam-map-manager.md, "Services".
#pragma once

#include <optional>
#include <string>

#include "map/catalogue.h"
#include "robot/call.h"

namespace mapwright::robot {

enum class MapChange {
  Rename,
  Load,  // the robot uses it from then on
  Archive,
  Unarchive,
  Delete,
  StartMapping,
  StopMapping,
  Save,  // stores the result of mapping under a name
};

/// A requested change.
struct MapOrder {
  MapChange change = MapChange::Rename;
  map::MapKey key = {};    // none for StartMapping, StopMapping and Save
  std::string name = {};   // Rename, Save: the new name
  std::string place = {};  // Load: the name of the waypoint where the robot stands; empty = not given
};

/// Why a change cannot be requested.
enum class Obstacle {
  NotOffered,  // robots of this kind do not offer it, or this one does not
  NotOfThisMap,
  WhileMapping,
  NotMapping,
  IsArchived,
  IsNotArchived,
  IsLoaded,
  NotKnownYet,  // the present state of the robot is unknown
};

/// Capability: rename, archive or switch stored maps. Nothing is sent twice: if the failure's applied is
/// Maybe, check the catalogue before you request it again.
class MapAdministration {
 public:
  virtual ~MapAdministration() = default;
  /// nullopt: it can be requested now. `map`: its catalogue entry; null for changes without a map. May change
  /// after Robot::mapsChanged() or capabilitiesChanged().
  virtual std::optional<Obstacle> obstacle(MapChange change, const map::CatalogueEntry* map) const = 0;
  /// Load needs to know where the robot stands.
  virtual bool loadAsksForPlace() const { return false; }
  /// The answer is the map as the robot reports it afterwards, including its name; for Delete the former
  /// entry, for StartMapping and StopMapping the robot's current map (without an id if there is none).
  virtual Call carryOut(const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply) = 0;
};

}  // namespace mapwright::robot
