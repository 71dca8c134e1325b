// Where on the screen the robot is drawn: only in the maps that it is in.
#pragma once

#include <optional>

#include "map/whereabouts.h"
#include "ui/scene/layer.h"

namespace mapwright::session {
class Session;
}

namespace mapwright::ui::scene {

enum class ScreenPart { All, Left, Right, None };

struct RobotPlace {
  /// For what is on screen. With two maps side by side: Here if it is in one of them.
  map::Whereabouts where = map::Whereabouts::Here;
  /// Where to draw it, with its submaps, points, paths and costmaps.
  ScreenPart drawn = ScreenPart::All;
  /// The overlays of the robot's current map match its position. Not while it makes a new map.
  bool overlays_fit = true;
  bool by_choice = false;  // the user's choice overrides the automatic one
  bool operator==(const RobotPlace&) const = default;
};

struct MapsOnScreen {
  bool whole = false;     // alone or as one of two
  bool compared = false;  // a second whole map
  CompareMode mode = CompareMode::Off;
  bool submaps_left = false;  // they are compared with the whole map
};

/// `choice`: draw it or not in any case; nullopt = automatic.
RobotPlace robotPlace(session::Session& session, const MapsOnScreen& on_screen, std::optional<bool> choice);

}  // namespace mapwright::ui::scene
