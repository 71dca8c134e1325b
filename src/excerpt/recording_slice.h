// A part of a recording on this computer as an MCAP file of its own: its messages unchanged, the state before
// it, and all attachments.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "excerpt/excerpt.h"
#include "fault/fault.h"

namespace mapwright::excerpt {

/// Copies the part of the recording `path` selected by `order` (an MCAP file). The state before the span is
/// written first, on channels with the metadata said=before (recorder/layout.h): the last message of each
/// topic, all static transforms, and the patches since the last whole grid. Blocks one thread; calls
/// `goes_on` now and then with the share done (0..1); if that returns false it stops and nothing is left. An
/// error about `path` does not contain its name; nullopt: stopped by `goes_on`.
using GoesOn = std::function<bool(double share)>;
tl::expected<std::optional<Written>, Fault> sliceRecording(const std::string& path, const Order& order,
                                                           const GoesOn& goes_on = {});

}  // namespace mapwright::excerpt
