// What the window is used for, and what it shows for that: docks and tools.
#pragma once

#include <QSize>
#include <QString>
#include <QStringList>

#include "ui/kit/panels.h"

namespace mapwright::ui {

enum class Role {
  Operate,  // waypoints, the robot, maps
  Inspect,  // submaps, layers, problems
  Replay,   // the timeline, with events, messages and plots
};
inline constexpr Role kRoles[] = {Role::Operate, Role::Inspect, Role::Replay};

/// "operate": for settings and names of actions.
QString idOf(Role role);

/// The docks in a window of this size. On a small screen the map keeps most of it.
Layout layoutFor(Role role, const QSize& window_px);

/// Whether the tool bar has the action. Those that are not known here are always there.
bool isOnBar(Role role, const QString& action);
/// The actions that have their text beside the icon as far as there is room, the most useful first.
QStringList withTextOnBar(Role role);

}  // namespace mapwright::ui
