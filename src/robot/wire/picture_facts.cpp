#include "robot/wire/picture_facts.h"

#include <cstdint>

#include <QCryptographicHash>

namespace mapwright::robot::wire {

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
