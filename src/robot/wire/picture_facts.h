// Facts about a picture file that need no decoding.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace mapwright::robot::wire {

/// Width and height in pixels from the header of a PNG (PNG specification, IHDR); nullopt for anything else
/// and for sizes of 0 or beyond 2^31 - 1.
std::optional<std::pair<int, int>> pngSize(std::string_view bytes);

/// Identifies exactly these bytes: their SHA-1 in hexadecimal.
std::string fingerprint(std::string_view bytes);

}  // namespace mapwright::robot::wire
