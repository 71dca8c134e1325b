// Merges several recordings on this computer into one.
#pragma once

#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "excerpt/excerpt.h"
#include "fault/fault.h"

namespace mapwright::excerpt {

/// Writes everything selected by `order` from all of `paths`, by log time, to one MCAP file; messages of
/// equal time come in the order of the files. Equal channels are merged; attachments and metadata of all
/// files are kept. Duplicates between two files are dropped: messages with the same times and bytes on the
/// same channel, attachments with the same name and content, and the initial state of a part. So merging the
/// parts of a recording, even overlapping ones, restores the recording. Duplicates within one file stay.
/// Blocks one thread. The error names a file that cannot be opened.
tl::expected<Written, Fault> mergeRecordings(const std::vector<std::string>& paths, const Order& order);

}  // namespace mapwright::excerpt
