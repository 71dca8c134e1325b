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

/// Its live map comes by a map dispatcher, whole when that is asked for, and by nothing else.
bool givesMapWhenAsked(robot::Robot& robot);

}  // namespace mapwright::app
