// Text sent as a picture (rosbridge v2, "png compression").
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include <QByteArray>

namespace mapwright::net::rosbridge {

/// The bytes of the pixels of an RGB PNG, row by row, without the newlines that pad the last row. nullopt:
/// not such a picture, or more than `max` bytes. Allocates memory only for as many pixels as the picture's
/// length can contain.
std::optional<QByteArray> textOfPng(std::string_view png, std::size_t max);

}  // namespace mapwright::net::rosbridge
