// Names of the features of an overlay. Source: docs/protocols/autoxing.md, "Overlays".
#pragma once

#include <vector>

#include <QString>

#include "map/overlay.h"

namespace mapwright::sentences {

/// "Charger", "Virtual wall", "Forbidden region"; "Point 77" for an unknown number.
QString nameOf(map::OverlayShape shape, int type);
/// The numbers that have a name of their own.
std::vector<int> knownTypes(map::OverlayShape shape);

}  // namespace mapwright::sentences
