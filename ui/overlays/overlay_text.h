// Overlays in words (sentences/overlay_sentence.h), as this room calls them.
#pragma once

#include "sentences/overlay_sentence.h"

namespace mapwright::window {

using sentences::changeText;
using sentences::featuresText;
using sentences::overlayCalled;
using sentences::overlayChangesText;
using sentences::overlayKind;
using sentences::overlayName;
using sentences::partName;
using sentences::valueText;

}  // namespace mapwright::window
