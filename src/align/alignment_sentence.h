// What an alignment says, in words: the same for the commands and the window.
#pragma once

#include <QString>

#include "align/align.h"

namespace mapwright::align {

/// Whether a place was found, and why not, with what to do.
QString alignmentText(const Alignment& alignment);
/// "In 3 of 41 squares of 3 m the walls are off by more than 10 cm, most at (12.0, -3.0): 0.42 m."; empty if
/// they are nowhere.
QString offText(const Agreement& agreement);
/// "x 12.34 m, y -5.60 m, turned by 90.3°".
QString transformText(const geometry::Pose2& transform);
/// "0.87".
QString scoreText(const Candidate& candidate);
/// "83 % of the smaller map".
QString overlapText(const Agreement& agreement);
/// "97.1 % within 10 cm, median 0.012 m, 95 % within 0.06 m, largest 0.3 m (88 % compared)".
QString distancesText(const WallDistances& distances);

}  // namespace mapwright::align
