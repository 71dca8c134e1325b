#include "ui/scene/robot_place.h"

#include <algorithm>

#include "map/live_state.h"
#include "session/lacks_picture.h"
#include "session/makes_new_map.h"
#include "session/session.h"

namespace mapwright::ui::scene {
namespace {

using map::Whereabouts;

ScreenPart partOf(bool left, bool right) {
  if (left && right) return ScreenPart::All;
  return left ? ScreenPart::Left : right ? ScreenPart::Right : ScreenPart::None;
}

}  // namespace

RobotPlace robotPlace(session::Session& session, const MapsOnScreen& on_screen, std::optional<bool> choice) {
  const map::LiveState& live = session.live();
  const bool afresh = session::makesNewMap(session.robot(), live, session.submaps());
  const auto in = [&](const session::MapSlot& slot) {
    if (session::lacksPicture(slot))  // its waypoints are on screen
      return map::whereabouts(slot.key(), slot.name().toStdString(), live, session.catalogue().entries(),
                              afresh);
    if (!slot.cells()) return Whereabouts::Here;  // there is nothing to draw it on wrongly
    const map::WholeMap& shown = slot.shown();
    return map::whereabouts(shown.state_of.value_or(shown.key), shown.name, live,
                            session.catalogue().entries(), afresh);
  };
  RobotPlace place;
  place.overlays_fit = !afresh;
  if (on_screen.whole) {
    const Whereabouts left = in(session.wholeMap());
    const Whereabouts right = on_screen.compared ? in(session.comparedMap()) : Whereabouts::Elsewhere;
    const bool in_left = left != Whereabouts::Elsewhere, in_right = right != Whereabouts::Elsewhere;
    if (on_screen.submaps_left) {
      // The submaps are the robot's own; they are to the left of the whole map.
      place.drawn = partOf(true, in_left);
    } else if (on_screen.mode == CompareMode::Swipe) {
      place.drawn = partOf(in_left, in_right);
      place.where = in_left ? left : right;
    } else {
      place.drawn = partOf(in_left || in_right, in_left || in_right);
      place.where = in_left ? left : right;
    }
  }
  if (choice && *choice != (place.drawn == ScreenPart::All && place.overlays_fit)) {
    place.by_choice = true;
    place.drawn = *choice ? ScreenPart::All : ScreenPart::None;
    place.overlays_fit = place.overlays_fit || *choice;
  }
  return place;
}

}  // namespace mapwright::ui::scene
