// What would be done to waypoints, for people and programs, before anything is sent.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/waypoint_list.h"
#include "exchange/waypoint_plan.h"
#include "placing/warnings.h"

namespace mapwright::app {

/// What would be doubtful about one, were it so.
struct DoubtAhead {
  std::string id, name;  // the id is empty where it has none yet
  placing::Warnings warnings;
};
using DoubtsAhead = std::vector<DoubtAhead>;

/// The same for a report, with the map.
QJsonObject previewReport(const ListedWaypoints& list, const exchange::MergedEdits& edits,
                          const std::optional<DoubtsAhead>& doubts = {});
/// {"changes","calls","conflicts"}, "refused" [{"id"|null,"name"}] where a name would be, and "warnings"
/// [{"id"|null,"name","warnings"}] where they were looked for; or a table.
void printPreview(const ListedWaypoints& list, const exchange::MergedEdits& edits, bool json,
                  const std::optional<DoubtsAhead>& doubts = {});
/// The requests that the store would be sent: those that it would refuse for sure are not.
QJsonArray callsOf(const ListedWaypoints& list, const std::vector<exchange::WaypointEdit>& edits);

}  // namespace mapwright::app
