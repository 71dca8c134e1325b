// Encodes gray pictures as sent by robots.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace mapwright::simulator {

/// Gray levels 0 (black) .. 255 (white), the top row first.
struct GrayPicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> levels;
};

/// A gray PNG with `bits` (1, 2, 4 or 8) per pixel: the highest bits of each level.
std::string writePng(const GrayPicture& picture, int bits);

/// A PNG of 3 * width * height bytes, red, green and blue, the top row first.
std::string writeRgbPng(int width, int height, std::string_view pixels);

/// The same PNG with another size declared in its header (with a correct checksum).
std::string withDeclaredSize(std::string png, std::uint32_t width, std::uint32_t height);

std::string base64(std::string_view bytes);

/// 64 hexadecimal digits derived from the bytes: an identifier without any security.
std::string contentHash(std::string_view bytes);

}  // namespace mapwright::simulator
