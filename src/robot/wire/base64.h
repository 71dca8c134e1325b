// Base64 as robots send it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace mapwright::robot::wire {

/// What base64 (standard or URL alphabet, RFC 4648) means. A `data:...;base64,` prefix, white space and
/// missing padding are fine; nullopt for anything else, or when it would be longer than `max_bytes`.
std::optional<std::string> fromBase64(std::string_view text, std::size_t max_bytes);

}  // namespace mapwright::robot::wire
