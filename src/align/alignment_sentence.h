// What an alignment says, in words: the same for the commands and the window.
#pragma once

#include <QString>

#include "align/align.h"

namespace mapwright::align {

/// Whether a place was found, and why not, with what to do.
QString alignmentText(const Alignment& alignment);
/// "x 12.34 m, y -5.60 m, turned by 90.3°".
QString transformText(const geometry::Pose2& transform);

}  // namespace mapwright::align
