// The `bbox` of features and of their collection: RFC 7946, section 5. Pure.
#pragma once

#include <optional>

#include "overlays/overlay_document.h"

namespace mapwright::overlays {

/// `moved` is `before` in another place or shape. A box that was right is so again, with all else of it as it
/// was; one that was not is removed. So are the boxes of its geometry, and of those in a collection. One that
/// differs from that of `before` stays. nullopt: there is none.
struct Reboxed {
  Feature feature;
  bool removed = false;  // at least one
};
std::optional<Reboxed> reboxed(const Feature& moved, const Feature& before);
/// The feature of it; `moved` if its geometry is the same.
Feature withItsBoxes(const Feature& moved, const Feature& before);

/// Whether the box of its collection is right, or it has none.
bool boxFits(const OverlayDocument& document);
/// `after` has other features than `before`, and the box of their collection follows. False: it was not right
/// before, and stays as it is.
bool rebox(OverlayDocument& after, const OverlayDocument& before);

}  // namespace mapwright::overlays
