// Warnings about waypoints on their map, as a command reports them: the same as in the window.
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

/// `--radius` in metres; nullopt = not given. The error is a sentence.
tl::expected<std::optional<double>, QString> radiusFrom(const std::string& word);

struct DoubtfulWaypoints {
  std::vector<placing::Warnings> of;  // one entry per waypoint, in the same order
  /// What cannot be checked, and why, as a sentence; empty = everything was checked.
  QString untold;
  /// The map below them was checked.
  bool looked = false;
};
/// Opens the map of `list`, waiting at most some seconds, and checks `points` on it. `radius_m`: warn of
/// walls that are closer; nullopt = the robot's footprint, or else placing::kUsualRadiusM. Do not use the
/// robot for anything else afterwards.
DoubtfulWaypoints doubtsOf(const ListedWaypoints& list, const std::vector<map::Waypoint>& points,
                           std::optional<double> radius_m);

/// [{"kind","sentence"}], and "distance_m" and "radius_m" of near_wall; kinds are in_wall, outside_map,
/// near_wall, on_unknown, name_twice, zero_turn (docs/command-line.md).
QJsonArray warningsJson(const placing::Warnings& warnings);
/// One line with all warnings, most severe first.
QString warningsLine(const placing::Warnings& warnings);

}  // namespace mapwright::app
