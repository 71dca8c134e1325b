// Copies text and reports it.
#pragma once

#include <QString>

namespace mapwright::window {

class MapOverlay;

/// `text` may come from a robot: invisible characters are removed. `said`: for the toast.
void copyText(MapOverlay& overlay, const QString& text, const QString& said);

}  // namespace mapwright::window
