// Text that travels as a picture (rosbridge v2, "png compression").
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include <QByteArray>

namespace mapwright::net::rosbridge {

/// The bytes of the pixels of an RGB PNG, row by row, without the newlines at the end that fill up the last
/// row. nullopt: no such picture, or it holds more than `max` bytes. Memory is taken only for as many pixels
/// as the picture's own length can bring about.
std::optional<QByteArray> textOfPng(std::string_view png, std::size_t max);

}  // namespace mapwright::net::rosbridge
