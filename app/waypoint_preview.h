// A preview of changes to waypoints, for people and programs, before anything is sent.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/waypoint_list.h"
#include "exchange/waypoint_plan.h"
#include "placing/warnings.h"

namespace mapwright::app {

/// A warning about a waypoint as it will be.
struct DoubtAhead {
  std::string id, name;  // the id is empty if it has none yet
  placing::Warnings warnings;
};
using DoubtsAhead = std::vector<DoubtAhead>;

/// The same for a report, with the map.
QJsonObject previewReport(const ListedWaypoints& list, const exchange::MergedEdits& edits,
                          const std::optional<DoubtsAhead>& doubts = {});
/// {"changes","calls","conflicts"}, "refused" [{"id"|null,"name"}] if a name would be refused, and "warnings"
/// [{"id"|null,"name","warnings"}] if they were checked; or a table.
void printPreview(const ListedWaypoints& list, const exchange::MergedEdits& edits, bool json,
                  const std::optional<DoubtsAhead>& doubts = {});
/// The requests that would be sent to the store, without those that it is certain to refuse.
QJsonArray callsOf(const ListedWaypoints& list, const std::vector<exchange::WaypointEdit>& edits);

}  // namespace mapwright::app
