// Regions of maps on the command line. Source: docs/protocols/rep130-map-dispatcher.md.
#pragma once

#include <string>

#include <QString>
#include <tl/expected.hpp>

#include "map/map_part.h"
#include "robot/robot.h"

namespace mapwright::app {

/// "X,Y,LX,LY": the centre and the lengths, metres. The error is a sentence.
tl::expected<map::GridRegion, QString> gridRegionFrom(const std::string& typed);

/// Its live map comes from a map dispatcher only, which can also send it whole on request.
bool givesMapWhenAsked(robot::Robot& robot);

}  // namespace mapwright::app
