// What `mapwright overlays` prints of changes, conflicts and flaws: tables for people, JSON for scripts.
#pragma once

#include <string>
#include <vector>

#include <QJsonArray>
#include <QString>

#include "overlays/overlay_check.h"
#include "overlays/overlay_merge.h"

namespace mapwright::app {

/// null for an empty one.
QJsonValue textOrNull(const std::string& plain);
/// [{"id"|null,"name"|null,"kind":"add|change|remove","parts"}]
QJsonArray changesJson(const std::vector<overlays::OverlayChange>& changes);
/// [{"id","name","property"|null,"base","mine","theirs"}]
QJsonArray conflictsJson(const std::vector<overlays::OverlayConflict>& conflicts);

/// In words; the changes are those between the two. Nothing is printed of none.
void printChanges(const std::vector<overlays::OverlayChange>& changes,
                  const overlays::OverlayDocument& before, const overlays::OverlayDocument& after);
void printConflicts(const std::vector<overlays::OverlayConflict>& conflicts);
/// [{"rule","id"|null,"name"|null,"at"|null,"sentence"}], or a table.
void printFlaws(const overlays::OverlayDocument& document, const std::vector<overlays::Flaw>& flaws,
                bool json);

}  // namespace mapwright::app
