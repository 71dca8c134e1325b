// Changes of waypoints on their way to where they are kept, until it is known what became of each.
#pragma once

#include <optional>
#include <vector>

#include <QJsonObject>
#include <QString>

#include "app/waypoint_list.h"
#include "edit/open_waypoints.h"
#include "exchange/sent_outcome.h"

namespace mapwright::app {

using StepState = exchange::SentState;

struct SentStep {
  exchange::WaypointStep step;
  exchange::SentOutcome outcome = {};
};

/// A swap of names that broke off has left a waypoint with a temporary name.
struct LeftName {
  std::string id, before, name, wanted;
  bool certain = true;  // false: it may have it, nobody could look
};

struct SentWaypoints {
  std::vector<SentStep> steps;  // what was so already is none of them
  /// What others have changed meanwhile and does not go together: of that nothing was sent.
  exchange::WaypointConflicts conflicts = {};
  std::optional<map::Failure> failure = {};  // why it was stopped
  exchange::WaypointItems kept = {};         // under our keys, as far as is known
  std::vector<LeftName> left_names = {};

  std::size_t count(StepState state) const;
  bool complete() const { return conflicts.empty() && count(StepState::Applied) == steps.size(); }
  /// 0 all, 1 some (or not known), 3 none, because the robot is out of reach, 4 none.
  int exitCode() const;
  /// What is to be said when it is not complete.
  QString sentence() const;

 private:
  QString whatBecame() const;
};

using edit::AtFailure;
/// Looks how they are kept now, merges, sends one request after the other, and looks what has become of them.
/// With a conflict nothing is sent. The time of the command bounds it: what is under way then is given up.
CommandResult<SentWaypoints> sendWaypoints(const ListedWaypoints& list,
                                           std::vector<exchange::WaypointEdit> edits, AtFailure at_failure);

/// {"applied","failed":[{"id","name","kind","sentence"}],"unknown":[…],"remaining","complete","conflicts",
/// "temporary_names":[{"id","before","name","wanted","certain"}]}.
QJsonObject sentJson(const SentWaypoints& sent, const std::string& map);
/// The same for a report: the map, and of every change what became of it: `changes` are as in a plan, each
/// with a "state" (applied, failed, unknown, not_sent) and, where it is not applied, the "sentence" that says
/// why.
QJsonObject sentReport(const SentWaypoints& sent, const std::string& map);
/// A table for people.
void printSent(const SentWaypoints& sent);

}  // namespace mapwright::app
