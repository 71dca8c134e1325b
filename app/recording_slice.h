// A part of a recording on this computer as an MCAP file of its own: its messages as they are, what had been
// said by then, and all that lies beside them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "app/bag_reading.h"
#include "map/reason.h"

namespace mapwright::app {

struct SlicedRecording {
  std::int64_t messages = 0;     // of the span
  std::int64_t said_before = 0;  // the last ones before it
  std::int64_t attachments = 0;
  std::vector<map::Reason> losses;  // of what is damaged in it, or cut off
};

/// Of `path` into `output`, which gets its name when all of it is there ("….part" until then). `topic`: of
/// this one alone; "" = all. What had been said before the span stands at its beginning, on channels with the
/// metadata said=before (recorder/layout.h): the last message of each topic, every transform that stays, and
/// the patches since the last whole grid. One thread, until it is done. The error has no name of a file where
/// it is about `path`.
tl::expected<SlicedRecording, map::Reason> sliceRecording(const std::string& path, const std::string& output,
                                                          const TimeSpan& span, const std::string& topic);

}  // namespace mapwright::app
