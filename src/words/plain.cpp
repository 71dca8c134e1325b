#include "words/plain.h"

#include <array>
#include <cstdint>
#include <cstdio>

namespace mapwright::words {
namespace {

constexpr std::string_view kReplacement = "\xef\xbf\xbd";  // U+FFFD

struct Character {
  std::uint32_t code = 0;
  std::size_t bytes = 1;
  bool valid = false;
};

/// The character at the beginning of `utf8`, which is not empty. Overlong forms, surrogates and what lies
/// beyond Unicode are no characters.
Character firstOf(std::string_view utf8) {
  const auto byte = [&](std::size_t i) { return std::uint32_t(std::uint8_t(utf8[i])); };
  const std::uint32_t lead = byte(0);
  if (lead < 0x80) return {lead, 1, true};
  const std::size_t bytes = lead >= 0xf0 && lead <= 0xf4  ? 4
                            : lead >= 0xe0 && lead < 0xf0 ? 3
                            : lead >= 0xc2 && lead < 0xe0 ? 2
                                                          : 0;
  if (bytes == 0 || utf8.size() < bytes) return {};
  std::uint32_t code = lead & (0xffu >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {};
    code = (code << 6) | (byte(i) & 0x3f);
  }
  constexpr std::array<std::uint32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
  if (code < kLeast[bytes] || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) return {};
  return {code, bytes, true};
}

bool isControl(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x2028 || code == 0x2029;
}

/// Embeddings, overrides and isolates: they reorder what others wrote after them.
bool isDirection(std::uint32_t code) {
  return (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
}

std::string plain(std::string_view utf8, bool keep_lines) {
  std::string out;
  out.reserve(utf8.size());
  while (!utf8.empty()) {
    const Character c = firstOf(utf8);
    if (!c.valid) {
      out += kReplacement;
    } else if (keep_lines && (c.code == '\n' || c.code == '\t')) {
      out += char(c.code);
    } else if (isControl(c.code)) {
      out += ' ';
    } else if (!isDirection(c.code)) {
      out += utf8.substr(0, c.bytes);
    }
    utf8.remove_prefix(c.bytes);
  }
  return out;
}

}  // namespace

std::string plainLine(std::string_view utf8) { return plain(utf8, false); }

std::string plainText(std::string_view utf8) { return plain(utf8, true); }

std::string escapedJson(std::string_view json) {
  std::string out;
  out.reserve(json.size());
  while (!json.empty()) {
    const Character c = firstOf(json);
    // Between the texts there are blanks and line ends; in them they are escaped already.
    const bool layout = c.code == '\n' || c.code == '\r' || c.code == '\t';
    if (!c.valid) {
      out += kReplacement;
    } else if ((isControl(c.code) && !layout) || isDirection(c.code)) {
      std::array<char, 8> escaped{};
      std::snprintf(escaped.data(), escaped.size(), "\\u%04x", unsigned(c.code));
      out += escaped.data();
    } else {
      out += json.substr(0, c.bytes);
    }
    json.remove_prefix(c.bytes);
  }
  return out;
}

}  // namespace mapwright::words
