// Formats numbers for sentences.
#pragma once

#include <cstdint>
#include <string>

namespace mapwright::words {

/// 51200 -> "51,200".
std::string grouped(std::int64_t number);
/// "400 x 300".
std::string dimensions(std::int64_t width, std::int64_t height);

}  // namespace mapwright::words
