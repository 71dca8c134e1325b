// What a recorded way crosses on a new map, in words.
#pragma once

#include <QString>

#include "carry/rehearsal.h"

namespace mapwright::carry {

/// "in an obstacle", "too close to a wall".
QString crossingText(Crossing crossing);
/// One line of sentences: "41.2 m. Not free: 0.70 m in an obstacle, 1.20 m unknown. Its end can be reached."
QString rehearsedText(const Rehearsed& way);

}  // namespace mapwright::carry
