#include "net/rosbridge/repair_json.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include <QString>
#include <simdjson.h>

namespace mapwright::net::rosbridge {
namespace {

bool startsToken(char c) {
  return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == 'N' || c == 'n' || c == 'I' || c == 'i';
}

bool inToken(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '+' ||
         c == '.';
}

template <typename Number>
bool holds(std::string_view token) {
  Number value{};
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  return stop == end && error == std::errc();
}

bool unreadable(std::string_view token) {
  if (token == "null" || token.empty()) return false;
  const std::string_view digits = token.starts_with('+') ? token.substr(1) : token;
  double value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (stop != end) return false;  // not a number at all: left for the parser to refuse
  if (error != std::errc() || !std::isfinite(value)) return true;
  const bool whole = token.find_first_of(".eE") == std::string_view::npos;
  return whole && !holds<std::int64_t>(digits) && !holds<std::uint64_t>(digits);
}

/// The code unit of `\uXXXX` at `at`.
std::optional<unsigned> unitAt(std::string_view text, std::size_t at) {
  if (text.substr(at, 2) != "\\u" || text.size() - at < 6) return std::nullopt;
  unsigned unit = 0;
  const char* const end = text.data() + at + 6;
  return std::from_chars(text.data() + at + 2, end, unit, 16).ptr == end ? std::optional(unit) : std::nullopt;
}

/// Appends the string that starts at `i`; answers where it ends.
std::size_t copyString(std::string_view text, std::size_t i, QByteArray& out) {
  const auto copy = [&](std::size_t bytes) {
    bytes = std::min(bytes, text.size() - i);
    out.append(text.data() + i, qsizetype(bytes));
    i += bytes;
  };
  copy(1);
  while (i < text.size() && text[i] != '"') {
    if (text[i] != '\\') {
      const std::size_t next = text.find_first_of("\"\\", i);
      copy(next == std::string_view::npos ? text.size() - i : next - i);
    } else if (const auto unit = unitAt(text, i); unit && *unit >= 0xd800 && *unit < 0xe000) {
      const auto second = unitAt(text, i + 6);
      if (*unit < 0xdc00 && second && *second >= 0xdc00 && *second < 0xe000) {
        copy(12);
      } else {
        out += "\\ufffd";
        i += 6;
      }
    } else {
      copy(2);
    }
  }
  copy(1);
  return i;
}

}  // namespace

QByteArray repairJson(const QByteArray& text) {
  const bool readable = simdjson::validate_utf8(text.constData(), std::size_t(text.size()));
  const QByteArray source = readable ? text : QString::fromUtf8(text).toUtf8();
  const std::string_view all(source.constData(), std::size_t(source.size()));
  QByteArray repaired;
  repaired.reserve(source.size());
  for (std::size_t i = 0; i < all.size();) {
    if (all[i] == '"') {
      i = copyString(all, i, repaired);
    } else if (startsToken(all[i])) {
      std::size_t end = i;
      while (end < all.size() && inToken(all[end])) ++end;
      const std::string_view token = all.substr(i, end - i);
      const std::string_view instead = unreadable(token) ? std::string_view("null") : token;
      repaired.append(instead.data(), qsizetype(instead.size()));
      i = end;
    } else {
      repaired += all[i];
      ++i;
    }
  }
  return repaired;
}

}  // namespace mapwright::net::rosbridge
