// Why a map of a robot cannot be changed at present, for tooltips and errors.
#pragma once

#include <QString>

#include "robot/map_administration.h"

namespace mapwright::sentences {

/// "It is archived: restore it from the archive first." Plain text.
QString whyNotNow(robot::MapChange change, robot::Obstacle obstacle);

}  // namespace mapwright::sentences
