// Builds menus and tool bar from the registered actions: knows no single action.
#pragma once

#include <Eigen/Core>

class QMenu;
class QMenuBar;
class QToolBar;

namespace mapwright::window {

class Actions;

void fillMenuBar(QMenuBar& bar, const Actions& actions);
void fillToolBar(QToolBar& bar, const Actions& actions);
/// The context menu of the map at a point, world metres.
void fillMapMenu(QMenu& menu, const Actions& actions, const Eigen::Vector2d& world_m);

}  // namespace mapwright::window
