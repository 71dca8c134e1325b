// Parses a robot's bags and their messages. Pure functions, any thread. Source: docs/protocols/autoxing.md,
// "Bags".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "fault/fault.h"
#include "robot/bag_library.h"

namespace mapwright::robot::axbot {

/// The rows of /bags/ or /recording/; those without a name are skipped.
tl::expected<std::vector<BagEntry>, Fault> parseBagRows(std::string_view utf8, BagKind kind);
/// The answer to starting a recording; nullopt if it contains no name.
std::optional<BagEntry> parseBagRow(std::string_view utf8, BagKind kind);

tl::expected<BagInfo, Fault> parseBagInfo(std::string_view utf8);

/// A range of a bag. The messages are parsed one by one, like live ones; literal NaN and Infinity count as
/// null. Unreadable messages are counted and skipped; an answer that is not JSON as a whole, or is cut off,
/// is an error.
tl::expected<BagChunk, Fault> parseBagChunk(std::string_view utf8, const BagRange& range);

}  // namespace mapwright::robot::axbot
