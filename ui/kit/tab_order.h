// The order in which Tab goes through a panel: that of the eye.
#pragma once

class QWidget;

namespace mapwright::ui {

/// Tab goes through `panel` as it is laid out: rows from top to bottom, in each in the direction of reading.
void orderTabsAsLaidOut(QWidget& panel);

}  // namespace mapwright::ui
