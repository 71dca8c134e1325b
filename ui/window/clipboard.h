// What is copied, and the word that it was.
#pragma once

#include <QString>

namespace mapwright::window {

class MapOverlay;

/// `text` may come from a robot: what is invisible in it stays behind. `said`: for the toast.
void copyText(MapOverlay& overlay, const QString& text, const QString& said);

}  // namespace mapwright::window
