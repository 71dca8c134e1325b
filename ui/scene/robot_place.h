// Where on the screen the robot belongs: in the maps that it is in, and nowhere else.
#pragma once

#include <optional>

#include "map/whereabouts.h"
#include "scene/layer.h"

namespace mapwright::session {
class Session;
}

namespace mapwright::scene {

enum class ScreenPart { All, Left, Right, None };

struct RobotPlace {
  /// As to what is on screen. With two maps side by side: Here when it is in one of them.
  map::Whereabouts where = map::Whereabouts::Here;
  /// Where it is drawn, with its submaps, points, paths and costmaps.
  ScreenPart drawn = ScreenPart::All;
  /// The overlays of the map that the robot works with lie where the robot is. Not so while it makes a new
  /// one.
  bool overlays_fit = true;
  bool by_choice = false;  // the user decided, against what is known
  bool operator==(const RobotPlace&) const = default;
};

struct MapsOnScreen {
  bool whole = false;     // as the only one, or as one of two
  bool compared = false;  // a second whole map
  CompareMode mode = CompareMode::Off;
  bool submaps_left = false;  // they are set against the whole map
};

/// `choice`: draw it or not, whatever is known; nullopt = as is known.
RobotPlace robotPlace(const session::Session& session, const MapsOnScreen& on_screen,
                      std::optional<bool> choice);

}  // namespace mapwright::scene
