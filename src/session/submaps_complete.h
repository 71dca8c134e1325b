// Whether a picture of the submaps is all that the robot lists.
#pragma once

#include "session/problem_log.h"
#include "session/submap_tally.h"

namespace mapwright::session {

/// The newest list of submaps could not be read: those on screen are of the one before, if there was one.
bool listUnreadable(const ProblemLog& problems);

/// Everything that is listed and has the chosen slice is loaded as it is listed, and no newer version is on
/// its way. Not so: a list, or rows of it, that cannot be read; a submap in an older version than listed
/// because the newer one cannot be loaded, or where it was before its pose became unreadable.
bool submapsComplete(const SubmapCounts& counts, const ProblemLog& problems);

}  // namespace mapwright::session
