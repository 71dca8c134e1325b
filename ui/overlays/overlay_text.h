// Overlays and the words for them (overlays/overlay_sentence.h), as this room calls them.
#pragma once

#include "overlays/editing_document.h"
#include "overlays/overlay_sentence.h"

namespace mapwright::ui {

using overlays::changeText;
using overlays::Feature;
using overlays::FeatureKey;
using overlays::featuresText;
using overlays::kCollectionKey;
using overlays::overlayCalled;
using overlays::overlayChangesText;
using overlays::overlayKind;
using overlays::overlayName;
using overlays::partName;
using overlays::valueText;

}  // namespace mapwright::ui
