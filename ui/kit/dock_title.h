// The title of a dock: its name and a close button in the window's style.
#pragma once

#include <QWidget>

class QDockWidget;

namespace mapwright::window {

/// Replaces the title bar of `dock`. Dragging and double-clicking still work.
void giveTitle(QDockWidget* dock);

}  // namespace mapwright::window
