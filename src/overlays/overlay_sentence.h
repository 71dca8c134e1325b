// Overlays and what changes of them in words: the same in the list, the review, conflicts, the history and
// the commands. Pure functions.
#pragma once

#include <QString>

#include "overlays/overlay_document.h"
#include "overlays/overlay_merge.h"

namespace mapwright::overlays {

/// "Virtual wall", "Charger"; "Feature" for what has no place.
QString overlayKind(const Feature& feature);
/// Its name as one line of plain text; "(no name)" if it has none.
QString overlayName(const Feature& feature);
/// "virtual wall W17", "charger".
QString overlayCalled(const Feature& feature);
/// "1 feature", "1,204 features".
QString featuresText(qsizetype count);
/// What people call a feature where only this is known: its name, else its id.
QString featureCalled(const std::string& id, const std::string& name);
/// A few of them, separated by commas.
QString featuresCalled(const std::vector<OverlayChange>& changes);
/// "3 changes".
QString overlayChangesText(qsizetype count);

/// As what is to be done ("Move virtual wall W17 by 0.40 m"), or as what happened ("virtual wall W17 moved by
/// 0.40 m").
enum class Telling { Deed, Event };
/// A change between the two.
QString changeText(const OverlayChange& change, const OverlayDocument& before, const OverlayDocument& after,
                   Telling telling = Telling::Deed);
/// "place", "name", "heading", "type", or the name of a property.
QString partName(const Part& part);
/// JSON as one short line of plain text; "deleted" or "none" where there is nothing.
QString valueText(const Part& part, const std::optional<std::string>& value);

}  // namespace mapwright::overlays
