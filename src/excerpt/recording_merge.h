// Several recordings on this computer as one.
#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "excerpt/excerpt.h"
#include "fault/fault.h"

namespace mapwright::excerpt {

/// What lies in `order` of all of `paths`, by log time, in one MCAP file; of the same time what the first one
/// says comes first. Channels that are the same become one; files and metadata of all are in it. What two
/// files hold is in it once: messages with the same times and bytes on the same channel, files of one name
/// whose content stands already, and what a part says had been said before it. So the parts of a recording,
/// also overlapping ones, make that recording. What one file holds twice stays twice. One thread, until it is
/// done. The error of one that cannot be opened names it.
tl::expected<Written, Fault> mergeRecordings(const std::vector<std::string>& paths, const Order& order);

}  // namespace mapwright::excerpt
