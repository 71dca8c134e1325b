#include "net/rosbridge/repair_json.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

#include <QString>
#include <simdjson.h>

#include "net/json_numbers.h"

namespace mapwright::net::rosbridge {
namespace {

/// The code unit of `\uXXXX` at `at`.
std::optional<unsigned> unitAt(std::string_view text, std::size_t at) {
  if (text.substr(at, 2) != "\\u" || text.size() - at < 6) return std::nullopt;
  unsigned unit = 0;
  const char* const end = text.data() + at + 6;
  return std::from_chars(text.data() + at + 2, end, unit, 16).ptr == end ? std::optional(unit) : std::nullopt;
}

/// Appends the string that starts at `i`; returns its end.
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
  const std::string repaired = repairNumbers({source.constData(), std::size_t(source.size())});
  const std::string_view all = repaired;
  QByteArray result;
  result.reserve(qsizetype(all.size()));
  for (std::size_t i = 0; i < all.size();) {
    const std::size_t quote = std::min(all.find('"', i), all.size());
    result.append(all.data() + i, qsizetype(quote - i));
    i = quote < all.size() ? copyString(all, quote, result) : quote;
  }
  return result;
}

}  // namespace mapwright::net::rosbridge
