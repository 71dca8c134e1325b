// The title of a dock: its name and a close button in the style of the window.
#pragma once

#include <QWidget>

class QDockWidget;

namespace mapwright::window {

/// Replaces the title bar of `dock`. Dragging and double clicking stay the dock's own.
void giveTitle(QDockWidget* dock);

}  // namespace mapwright::window
