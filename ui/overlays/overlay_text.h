// Overlays in words (overlays/overlay_sentence.h), as this room calls them.
#pragma once

#include "overlays/overlay_sentence.h"

namespace mapwright::window {

using overlays::changeText;
using overlays::featuresText;
using overlays::overlayCalled;
using overlays::overlayChangesText;
using overlays::overlayKind;
using overlays::overlayName;
using overlays::partName;
using overlays::valueText;

}  // namespace mapwright::window
