// Names of the features of an overlay. Source: docs/protocols/autoxing.md, "Overlays".
#pragma once

#include <QString>

#include "map/overlay.h"

namespace mapwright::sentences {

/// "Charger", "Virtual wall", "Forbidden region"; "Point 77" for an unknown number.
QString nameOf(map::OverlayShape shape, int type);

}  // namespace mapwright::sentences
