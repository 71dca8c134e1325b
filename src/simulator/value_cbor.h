// Values as CBOR, and JSON as a picture.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "simulator/value.h"

namespace mapwright::simulator {

/// Typed arrays are tagged little-endian byte strings. nullopt when a list of texts is not empty: servers
/// lose such messages (docs/protocols/rosbridge.md, "Compression").
std::optional<std::string> toCbor(const Value& value);

/// {"op":"png","data":...}: the bytes of `json`, padded with newlines, are the pixels of an RGB picture.
std::string toPng(std::string_view json);

}  // namespace mapwright::simulator
