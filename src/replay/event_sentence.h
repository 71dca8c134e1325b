// Texts for the events of a bag.
#pragma once

#include <QString>

#include "replay/events.h"

namespace mapwright::replay {

/// "Alert 1001: blocked", "The position jumped by 2.3 m". One line of plain text.
QString eventText(const Event& event);

}  // namespace mapwright::replay
