// Base64 as robots send it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace mapwright::robot::wire {

/// Decodes base64 (standard or URL alphabet, RFC 4648). Accepts a `data:...;base64,` prefix, white space and
/// missing padding; nullopt for anything else, or if the result exceeds `max_bytes`.
std::optional<std::string> fromBase64(std::string_view text, std::size_t max_bytes);

}  // namespace mapwright::robot::wire
