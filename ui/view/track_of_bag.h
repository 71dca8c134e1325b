// The robot's path through a bag, as the scene draws it: for the window and for snapshots.
#pragma once

#include <memory>

#include "replay/reading.h"
#include "ui/scene/track.h"

namespace mapwright::ui {

/// As far as it has been read.
std::shared_ptr<const scene::Track> trackOfBag(const replay::Reading& reading);

}  // namespace mapwright::ui
