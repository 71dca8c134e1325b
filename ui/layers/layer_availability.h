// Which layers a robot has data for.
#pragma once

#include <QString>

#include "scene/layer.h"
#include "session/session.h"

namespace mapwright::window {

/// Why the robot of `session` has no data for this layer, as a sentence; empty if it has, or without a robot.
QString whyLayerStaysEmpty(scene::Layer layer, session::Session* session);

}  // namespace mapwright::window
