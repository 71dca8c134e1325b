#include "robot/wire/picture_bytes.h"

#include <cstdint>

#include <QByteArray>
#include <QCryptographicHash>

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

std::optional<std::pair<int, int>> pngSize(std::string_view bytes) {
  using namespace std::string_view_literals;
  constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n"sv;
  if (bytes.size() < 24 || !bytes.starts_with(kSignature) || bytes.substr(12, 4) != "IHDR")
    return std::nullopt;
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = (value << 8) | std::uint8_t(bytes[at + i]);
    return value;
  };
  const std::uint32_t width = number(16), height = number(20);
  if (width == 0 || height == 0 || width > 0x7fffffff || height > 0x7fffffff) return std::nullopt;
  return std::pair{int(width), int(height)};
}

std::string fingerprint(std::string_view bytes) {
  QCryptographicHash hash(QCryptographicHash::Sha1);
  hash.addData(QByteArrayView(bytes.data(), qsizetype(bytes.size())));
  return hash.result().toHex().toStdString();
}

}  // namespace mapwright::robot::wire
