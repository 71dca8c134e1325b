#include "simulator/json_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace mapwright::simulator {

void appendJsonText(std::string& out, std::string_view text) {
  static constexpr char kDigits[] = "0123456789abcdef";
  out += '"';
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte < 0x20) {
      out += "\\u00";
      out += kDigits[byte >> 4];
      out += kDigits[byte & 15];
    } else {
      out += c;
    }
  }
  out += '"';
}

void appendJsonNumber(std::string& out, double number) {
  if (!std::isfinite(number)) {
    out += "null";
    return;
  }
  std::array<char, 64> buffer;
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
  out.append(buffer.data(), result.ptr);
}

void appendJsonFixed(std::string& out, double number, int digits) {
  std::array<char, 400> buffer;
  const auto result = std::isfinite(number)
                          ? std::to_chars(buffer.data(), buffer.data() + buffer.size(), number,
                                          std::chars_format::fixed, digits)
                          : std::to_chars_result{buffer.data(), std::errc::invalid_argument};
  if (result.ec != std::errc()) {
    out += "null";
    return;
  }
  out.append(buffer.data(), result.ptr);
}

}  // namespace mapwright::simulator
