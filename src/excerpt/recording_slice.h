// A part of a recording on this computer as an MCAP file of its own: its messages as they are, what had been
// said by then, and all that lies beside them.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "excerpt/excerpt.h"
#include "fault/fault.h"

namespace mapwright::excerpt {

/// Of the recording `path`, as `order` (an MCAP file) says. What had been said before the span stands at its
/// beginning, on channels with the metadata said=before (recorder/layout.h): the last message of each topic,
/// every transform that stays, and the patches since the last whole grid. One thread, until it is done;
/// `goes_on` is told now and then how much of it is (0..1), and ends it by false: nothing is left then. The
/// error has no name of a file where it is about `path`; nullopt: ended by `goes_on`.
using GoesOn = std::function<bool(double share)>;
tl::expected<std::optional<Written>, Fault> sliceRecording(const std::string& path, const Order& order,
                                                           const GoesOn& goes_on = {});

}  // namespace mapwright::excerpt
