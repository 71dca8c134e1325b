// Pictures as robots send them: base64; facts about a picture file that need no decoding.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace mapwright::robot::wire {

/// Decodes base64 (standard or URL alphabet, RFC 4648). Accepts a `data:...;base64,` prefix, white space and
/// missing padding; nullopt for anything else, or if the result exceeds `max_bytes`.
std::optional<std::string> fromBase64(std::string_view text, std::size_t max_bytes);

/// Width and height in pixels from the header of a PNG (PNG specification, IHDR); nullopt for anything else
/// and for sizes of 0 or beyond 2^31 - 1.
std::optional<std::pair<int, int>> pngSize(std::string_view bytes);

/// Identifies exactly these bytes: their SHA-1 in hexadecimal.
std::string fingerprint(std::string_view bytes);

}  // namespace mapwright::robot::wire
