// The port: where a robot sees things that stand around it, and what it has collected on its way. Source:
// docs/protocols/autoxing.md, "Where the robot sees things".
#pragma once

#include <string>
#include <vector>

#include <QStringList>

#include "geometry/pose.h"
#include "map/live_topics.h"
#include "robot/call.h"

namespace mapwright::robot {

enum class Sight { Charger, Rack, Pallet, Trailer };
/// Which edge of a rack is meant.
enum class SightEdge { AsTheRobotHasIt, Front, Rear };

struct Sighting {
  geometry::Pose2 pose;   // in the map
  std::string reference;  // which place of it that is, as the robot calls it; empty: not told
  bool operator==(const Sighting&) const = default;
};

struct CollectedLandmarks {
  std::vector<map::Landmark> landmarks;
  std::size_t files = 0;  // that they were read from: the newest
  std::size_t older = 0;  // that were not read
};

/// Capability of an OverlayStore: things become overlays where the robot sees them. Requests change nothing.
class SightingSource {
 public:
  virtual ~SightingSource() = default;
  /// From where it stands. That it sees none is a failure with a sentence.
  virtual Call look(Sight what, SightEdge edge, OutcomeTo<Sighting> reply) = 0;
  /// The landmarks that it has collected; of those with the same id the newest.
  virtual Call collectedLandmarks(OutcomeTo<CollectedLandmarks> reply) = 0;
  /// Topics that bring landmarks and barcodes while it drives (map::LandmarksMessage, map::BarcodeMessage).
  virtual QStringList topics() const = 0;
};

}  // namespace mapwright::robot
