#include "robot/wire/base64.h"

#include <array>
#include <cstdint>

namespace mapwright::robot::wire {
namespace {

constexpr std::uint8_t kBad = 0xff, kSpace = 0xfe, kPadding = 0xfd;

constexpr std::array<std::uint8_t, 256> meanings() {
  std::array<std::uint8_t, 256> table{};
  table.fill(kBad);
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < kAlphabet.size(); ++i) table[std::uint8_t(kAlphabet[i])] = std::uint8_t(i);
  table['-'] = 62;
  table['_'] = 63;
  for (const char space : {' ', '\t', '\r', '\n'}) table[std::uint8_t(space)] = kSpace;
  table['='] = kPadding;
  return table;
}

constexpr std::array<std::uint8_t, 256> kMeanings = meanings();

}  // namespace

std::optional<std::string> fromBase64(std::string_view text, std::size_t max_bytes) {
  if (text.starts_with("data:")) {
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos || !text.substr(0, comma).ends_with("base64")) return std::nullopt;
    text.remove_prefix(comma + 1);
  }
  if (text.size() / 2 > max_bytes) return std::nullopt;
  std::string out;
  out.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int held = 0;  // six-bit groups in `bits`
  bool padded = false;
  for (const char c : text) {
    const std::uint8_t value = kMeanings[std::uint8_t(c)];
    if (value < 64) {
      if (padded) return std::nullopt;
      bits = (bits << 6) | value;
      if (++held == 4) {
        const char bytes[] = {char(bits >> 16), char(bits >> 8), char(bits)};
        out.append(bytes, 3);
        bits = 0;
        held = 0;
      }
    } else if (value == kPadding) {
      padded = true;
    } else if (value == kBad) {
      return std::nullopt;
    }
  }
  if (held == 1) return std::nullopt;
  if (held >= 2) out += char(bits >> (held == 2 ? 4 : 10));
  if (held == 3) out += char(bits >> 2);
  if (out.size() > max_bytes) return std::nullopt;
  return out;
}

}  // namespace mapwright::robot::wire
