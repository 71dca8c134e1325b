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
  ContinueMapping,  // maps more of the current map
  StopMapping,
  CancelMapping,  // what was mapped is lost
  Save,           // stores the result of mapping under a name
};

/// Without a map.
inline bool isOfMapping(MapChange change) {
  return change == MapChange::StartMapping || change == MapChange::ContinueMapping ||
         change == MapChange::StopMapping || change == MapChange::CancelMapping || change == MapChange::Save;
}

/// A mapping in progress, whoever started it.
struct MappingProgress {
  map::MapKey key;
  std::optional<double> lasts_s;  // by the robot's own clock; nullopt: it is not known
  std::optional<bool> continues;  // more of a map that was there before
  bool operator==(const MappingProgress&) const = default;
};

/// A requested change.
struct MapOrder {
  MapChange change = MapChange::Rename;
  map::MapKey key = {};    // none if isOfMapping()
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
  EndsBySaving,  // it ends a mapping by saving it, or by discarding it
  NotKnownYet,   // the present state of the robot is unknown
  NothingToSave,
};

/// Capability: rename, archive or switch stored maps. Nothing is sent twice: if the failure's applied is
/// Maybe, check the catalogue before you request it again.
class MapAdministration {
 public:
  virtual ~MapAdministration() = default;
  /// nullopt: it can be requested now. `map`: its catalogue entry; null for changes without a map. May change
  /// after Robot::mapsChanged() or capabilitiesChanged().
  virtual std::optional<Obstacle> obstacle(MapChange change, const map::CatalogueEntry* map) const = 0;
  /// What the robot's map manager calls its present state; empty: it does not say. Untrusted plain text.
  virtual std::string managerState() const { return {}; }
  /// Save stores the finished mapping that the catalogue lists.
  virtual bool savesListed() const { return false; }
  /// Load needs to know where the robot stands.
  virtual bool loadAsksForPlace() const { return false; }
  /// The answer is the map as the robot reports it afterwards, including its name; for Delete the former
  /// entry; for the start, stop and cancelling of mapping that mapping if the robot lists mappings, else its
  /// current map (without an id if there is none).
  virtual Call carryOut(const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply) = 0;
  /// Whether progress() can be requested.
  virtual bool tellsProgress() const { return false; }
  /// The mapping in progress; nullopt: none. Only if tellsProgress().
  virtual Call progress(OutcomeTo<std::optional<MappingProgress>> /*reply*/) { return {}; }
};

}  // namespace mapwright::robot
