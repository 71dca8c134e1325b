#include "ui/layers/layer_availability.h"

#include <algorithm>

#include <QCoreApplication>

#include "robot/map_dispatch.h"
#include "sentences/absence_sentence.h"

namespace mapwright::window {

using scene::Layer;

QString whyLayerStaysEmpty(Layer layer, session::Session* session) {
  if (!session) return {};
  robot::Robot& robot = session->robot();
  const auto why = [&](robot::Capability capability) {
    return sentences::whyAbsent(capability, robot.whyNot(capability));
  };
  const bool submaps = robot.submapSource() != nullptr;
  const bool live = robot.liveTopics() != nullptr;
  const bool whole = robot.wholeMapSource() != nullptr;
  switch (layer) {
    case Layer::Submaps:
    case Layer::Outlines:
    case Layer::Ids:
      return submaps ? QString() : why(robot::Capability::Submaps);
    case Layer::WholeMap:
      return whole || live ? QString() : why(robot::Capability::WholeMaps);
    case Layer::Regions: {
      const robot::MapDispatch* const dispatch = robot.mapDispatch();
      if (!dispatch) return why(robot::Capability::Dispatch);
      // If it has disappeared, received data stays.
      const auto offers = dispatch->offers();
      const bool gone =
          std::none_of(offers.begin(), offers.end(), [](const auto& offer) { return offer.offered; });
      if (gone) return {};
      return dispatch->offered(robot::DispatchService::GridRegion)
                 ? QString()
                 : QCoreApplication::translate("window", "This robot only sends its map as a whole.");
    }
    case Layer::Overlays:
    case Layer::Landmarks:
    case Layer::Trajectory:
      return whole || live ? QString()
                           : QCoreApplication::translate("window", "This robot does not provide this.");
    case Layer::Waypoints:
      return robot.waypointSource() || robot.waypointStore() ? QString() : why(robot::Capability::Waypoints);
    case Layer::DispatchedCloud:
      return robot.mapDispatch() ? QString() : why(robot::Capability::Dispatch);
    case Layer::Grid:
    case Layer::ScaleBar:
      return {};
    default:
      break;
  }
  // Everything else is the robot's present sensor data, plans or motion.
  return live || submaps ? QString()
                         : QCoreApplication::translate(
                               "window", "There is no live data here, so this layer stays empty.");
}

}  // namespace mapwright::window
