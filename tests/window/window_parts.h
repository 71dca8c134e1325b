// The docks, controllers and other parts of a window, for tests.
#pragma once

#include <QWidget>

namespace mapwright::ui {

/// The one of this class; null: there is none.
template <class Part>
Part* part(const QWidget& window) {
  return window.findChild<Part*>();
}

}  // namespace mapwright::ui
