#include "window/docks/layer_availability.h"

namespace mapwright::window {

using scene::Layer;

QString whyLayerStaysEmpty(Layer layer, session::Session* session) {
  if (!session) return {};
  robot::Robot& robot = session->robot();
  const bool submaps = robot.submapSource() != nullptr;
  const bool live = robot.liveTopics() != nullptr;
  const bool whole = robot.wholeMapSource() != nullptr;
  switch (layer) {
    case Layer::Submaps:
    case Layer::Outlines:
    case Layer::Ids:
      return submaps ? QString() : QStringLiteral("There are no submaps here, only whole maps.");
    case Layer::WholeMap:
      return whole || live ? QString() : QStringLiteral("This robot gives no whole map.");
    case Layer::Overlays:
    case Layer::Landmarks:
    case Layer::Trajectory:
      return whole || live ? QString() : QStringLiteral("This robot tells nothing of the kind.");
    case Layer::Waypoints:
      return robot.waypointSource() ? QString() : QStringLiteral("This robot lists no navigation points.");
    case Layer::Grid:
    case Layer::ScaleBar:
      return {};
    default:
      break;
  }
  // All that is left is seen, planned or driven by the robot just now.
  return live || submaps ? QString()
                         : QStringLiteral("Nothing live comes from here, so this layer stays empty.");
}

}  // namespace mapwright::window
