// F6: the keyboard goes around the parts of the window.
#pragma once

#include <vector>

#include "ui/shell/window_context.h"

namespace mapwright::ui {

/// The map, what lies over it, the docks in front, the status bar and the tool bar: what of them is visible
/// and can have the focus, in this order.
std::vector<QWidget*> panesOf(const WindowContext& context);
/// Puts the focus where it last was in the next pane (1) or the previous one (-1).
void goToPane(const WindowContext& context, int step);

}  // namespace mapwright::ui
