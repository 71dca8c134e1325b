// Which layers a robot can fill at all.
#pragma once

#include <QString>

#include "scene/layer.h"
#include "session/session.h"

namespace mapwright::window {

/// Why the robot of `session` can never fill this layer, as a sentence; empty when it can, or without a
/// robot.
QString whyLayerStaysEmpty(scene::Layer layer, session::Session* session);

}  // namespace mapwright::window
