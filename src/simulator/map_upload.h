// A map uploaded by a client: its fields, picture and name (docs/protocols/autoxing.md, "Requests").
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "simulator/request_fields.h"
#include "simulator/stored_map.h"

namespace mapwright::simulator {

inline constexpr std::size_t kLongestMapName = 255;

/// The error is a sentence for the client.
tl::expected<StoredMap, std::string> readMapUpload(const RequestFields& fields);

}  // namespace mapwright::simulator
