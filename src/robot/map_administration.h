// The port: the maps that a robot keeps, changed. Source: docs/protocols/autoxing.md, "Requests",
// docs/protocols/kabam-map-manager.md, "Services".
#pragma once

#include <optional>
#include <string>

#include "map/catalogue.h"
#include "robot/call.h"

namespace mapwright::robot {

enum class MapChange {
  Rename,
  Load,  // the robot works with it from then on
  Archive,
  Unarchive,
  Delete,
  StartMapping,
  StopMapping,
  Save,  // what has been mapped, under a name
};

/// One change, as it is asked for.
struct MapOrder {
  MapChange change = MapChange::Rename;
  map::MapKey key = {};    // of StartMapping, StopMapping and Save: none
  std::string name = {};   // Rename, Save: what it is called from now on
  std::string place = {};  // Load: the name of the waypoint where the robot stands; empty = not said
};

/// Why a change cannot be asked for.
enum class Obstacle {
  NotOffered,  // robots of this kind have nothing of the sort, or this one has not
  NotOfThisMap,
  WhileMapping,
  NotMapping,
  IsArchived,
  IsNotArchived,
  IsLoaded,
  NotKnownYet,  // what the robot does now has not been told
};

/// Capability: the stored maps called otherwise, put away, or another one worked with. Nothing is sent twice:
/// where the failure's applied is Maybe, whoever asked looks into the catalogue before asking again.
class MapAdministration {
 public:
  virtual ~MapAdministration() = default;
  /// nullopt: it may be asked for now. `map`: which one, as the catalogue tells it; null for changes of none.
  /// May be another one after Robot::mapsChanged() or capabilitiesChanged().
  virtual std::optional<Obstacle> obstacle(MapChange change, const map::CatalogueEntry* map) const = 0;
  /// Load wants to be told where the robot stands.
  virtual bool loadAsksForPlace() const { return false; }
  /// The answer is the map as the robot tells it afterwards, its name as well; of Delete as it was, of
  /// StartMapping and StopMapping the one that the robot works with (without an id where there is none).
  virtual Call carryOut(const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply) = 0;
};

}  // namespace mapwright::robot
