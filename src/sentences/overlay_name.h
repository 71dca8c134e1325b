// What people call the features of an overlay. Source: docs/protocols/autoxing.md, "Overlays".
#pragma once

#include <QString>

#include "map/overlay.h"

namespace mapwright::sentences {

/// "Charger", "Virtual wall", "Forbidden region"; "Point 77" for a number that nobody explained.
QString nameOf(map::OverlayShape shape, int type);

}  // namespace mapwright::sentences
