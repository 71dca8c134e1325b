// The port: the overlays of a map as the text that a robot keeps. Source: docs/protocols/autoxing.md,
// "Overlays".
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "map/catalogue.h"
#include "robot/call.h"

namespace mapwright::robot {

class SightingSource;  // robot/sighting_source.h

struct OverlayText {
  std::string text;            // GeoJSON as the robot keeps it, to the byte; may be empty
  std::optional<int> version;  // goes up with every change; nullopt: not told
  std::string map_uid, map_name;
  std::string map_id = {};  // as the robot spells it; empty: not told
};

/// Capability: read the overlays of a map, and replace them. Call it on the thread that made the robot;
/// results arrive there, too.
class OverlayStore {
 public:
  virtual ~OverlayStore() = default;
  /// Of a stored map, of a map file, or of the one that the robot is in (MapKind::Live).
  virtual Call read(const map::MapKey& key, OutcomeTo<OverlayText> reply) = 0;
  /// Replaces all of them with one request, which is not sent twice. Whoever changed them since they were
  /// read is overwritten, so read them just before; and what the robot answers is no proof, so read them
  /// afterwards (jobs/change_overlays.h does both).
  virtual Call write(const map::MapKey& key, const std::string& text, OutcomeTo<std::monostate> reply) = 0;
  /// Null: this robot sees nothing that could become an overlay.
  virtual SightingSource* sightings() { return nullptr; }
};

}  // namespace mapwright::robot
