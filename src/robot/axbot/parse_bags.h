// What a robot says of its bags, and the messages in them. Pure functions, any thread.
// Source: docs/protocols/autoxing.md, "Bags".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "fault/fault.h"
#include "robot/bag_library.h"

namespace mapwright::robot::axbot {

/// The rows of /bags/ or /recording/; those without a name are left out.
tl::expected<std::vector<BagEntry>, Fault> parseBagRows(std::string_view utf8, BagKind kind);
/// What a robot answers when it has begun a recording; nullopt where it does not name it.
std::optional<BagEntry> parseBagRow(std::string_view utf8, BagKind kind);

tl::expected<BagInfo, Fault> parseBagInfo(std::string_view utf8);

/// A range of a bag. The messages are read one after the other, by the readers of live ones; literal NaN and
/// Infinity in them count as null. One that cannot be read is counted and left out; an answer that is no JSON
/// as a whole, or that is cut off, is an error.
tl::expected<BagChunk, Fault> parseBagChunk(std::string_view utf8, const BagRange& range);

}  // namespace mapwright::robot::axbot
