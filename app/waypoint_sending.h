// Sends changes of waypoints and finds out the result of each.
#pragma once

#include <optional>
#include <vector>

#include <QJsonObject>
#include <QString>

#include "app/waypoint_list.h"
#include "edit/open_waypoints.h"
#include "exchange/waypoint_steps.h"

namespace mapwright::app {

using StepState = exchange::SentState;

struct SentStep {
  exchange::WaypointStep step;
  exchange::SentOutcome outcome = {};
};

/// A waypoint left with a temporary name by an interrupted swap of names.
struct LeftName {
  std::string id, before, name, wanted;
  bool certain = true;  // false: possibly; it could not be checked
};

struct SentWaypoints {
  std::vector<SentStep> steps;  // without changes that were already in place
  /// Changes by others that conflict with ours: nothing of these was sent.
  exchange::WaypointConflicts conflicts = {};
  std::optional<map::Failure> failure = {};  // why it was stopped
  exchange::WaypointItems kept = {};         // under our keys, as far as known
  std::vector<LeftName> left_names = {};

  std::size_t count(StepState state) const;
  bool complete() const { return conflicts.empty() && count(StepState::Applied) == steps.size(); }
  /// 0 all, 1 some (or unknown), 3 none, because the robot is unreachable, 4 none.
  int exitCode() const;
  /// What to print if it is incomplete.
  QString sentence() const;

 private:
  QString whatBecame() const;
};

using edit::AtFailure;
/// Reads the current waypoints, merges, sends one request after the other, and checks the result. Sends
/// nothing if there is a conflict. When the command's time runs out, requests in progress are given up.
CommandResult<SentWaypoints> sendWaypoints(const ListedWaypoints& list,
                                           std::vector<exchange::WaypointEdit> edits, AtFailure at_failure);

/// {"applied","failed":[{"id","name","kind","sentence"}],"unknown":[…],"remaining","complete","conflicts",
/// "temporary_names":[{"id","before","name","wanted","certain"}]}.
QJsonObject sentJson(const SentWaypoints& sent, const std::string& map);
/// For a report: the map, and the result of every change. `changes` are as in a plan, each with a "state"
/// (applied, failed, unknown, not_sent) and, if it is not applied, the "sentence" that says why.
QJsonObject sentReport(const SentWaypoints& sent, const std::string& map);
/// Prints a table.
void printSent(const SentWaypoints& sent);

}  // namespace mapwright::app
