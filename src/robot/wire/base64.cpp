#include "robot/wire/base64.h"

#include <QByteArray>

namespace mapwright::robot::wire {

std::optional<std::string> fromBase64(std::string_view text, std::size_t max_bytes) {
  if (text.starts_with("data:")) {
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos || !text.substr(0, comma).ends_with("base64")) return std::nullopt;
    text.remove_prefix(comma + 1);
  }
  if (text.size() / 2 > max_bytes) return std::nullopt;
  // Without what Qt does not take: both alphabets in one text, white space, padding of another length.
  QByteArray plain;
  plain.reserve(qsizetype(text.size()));
  for (const char c : text) {
    if (c == ' ' || c == '\t' || c == '\r' || c == '\n') continue;
    plain.append(c == '-' ? '+' : c == '_' ? '/' : c);
  }
  while (plain.endsWith('=')) plain.chop(1);
  if (plain.size() % 4 == 1) return std::nullopt;
  const auto decoded =
      QByteArray::fromBase64Encoding(std::move(plain), QByteArray::AbortOnBase64DecodingErrors);
  if (!decoded || std::size_t(decoded.decoded.size()) > max_bytes) return std::nullopt;
  return decoded.decoded.toStdString();
}

}  // namespace mapwright::robot::wire
