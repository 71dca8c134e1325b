// Numbers from texts that must hold nothing else.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace mapwright::simulator {

template <typename Number>
std::optional<Number> numberFrom(std::string_view text) {
  Number number = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || result.ec != std::errc() || result.ptr != text.data() + text.size())
    return std::nullopt;
  return number;
}

}  // namespace mapwright::simulator
