// What is doubtful about waypoints on the map under them, as a command tells it: the same as in the window.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QJsonArray>
#include <QString>
#include <QStringList>

#include "app/waypoint_list.h"
#include "placing/warnings.h"

namespace mapwright::app {

/// `--radius` in metres; nullopt = it is not given. The error is a sentence.
tl::expected<std::optional<double>, QString> radiusFrom(const std::string& word);

struct DoubtfulWaypoints {
  std::vector<placing::Warnings> of;  // each waypoint's, in their order; as long as they are
  /// What cannot be told, and why: a sentence; empty = all can.
  QString untold;
  /// The map under them was looked at.
  bool looked = false;
};
/// Opens the map of `list`, for some seconds at most, and looks at `points` on it. `radius_m`: walls that are
/// closer are warned of; nullopt = as the robot tells its shape, else placing::kUsualRadiusM. Nothing else is
/// asked of the robot afterwards.
DoubtfulWaypoints doubtsOf(const ListedWaypoints& list, const std::vector<map::Waypoint>& points,
                           std::optional<double> radius_m);

/// [{"kind","sentence"}], and "distance_m" and "radius_m" of near_wall; kinds are in_wall, outside_map,
/// near_wall, on_unknown, name_twice, zero_turn (docs/command-line.md).
QJsonArray warningsJson(const placing::Warnings& warnings);
/// A line: all sentences, the gravest first.
QString warningsLine(const placing::Warnings& warnings);

}  // namespace mapwright::app
