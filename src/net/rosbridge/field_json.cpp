#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include <QByteArray>

#include "net/rosbridge/access.h"
#include "net/rosbridge/field.h"

namespace mapwright::net::rosbridge {
namespace {

constexpr std::size_t kShownItems = 32, kShownText = 512;
const QByteArray kMore = QByteArrayLiteral("\xe2\x80\xa6");  // …

/// How much of it to include.
struct Bounds {
  qsizetype text = std::numeric_limits<qsizetype>::max();
  std::size_t items = std::numeric_limits<std::size_t>::max();
  std::size_t letters = std::numeric_limits<std::size_t>::max();  // bytes of each text in it
  bool whole = true;
};

/// The longest prefix of the UTF-8 `text` with at most `bytes` bytes that splits no character.
std::size_t wholeCharacters(std::string_view text, std::size_t bytes) {
  if (bytes >= text.size()) return text.size();
  while (bytes > 0 && (std::uint8_t(text[bytes]) & 0xc0) == 0x80) --bytes;
  return bytes;
}

class Writer {
 public:
  explicit Writer(const Bounds& bounds) : bounds_(bounds) {}

  bool full() const { return out_.size() > bounds_.text; }

  void write(const Field& field) {
    if (full()) return;
    if (field.isObject()) {
      writeObject(field);
    } else if (bounds_.whole && isByteString(field)) {
      writeBytes(field);
    } else if (field.isList()) {
      writeList(field);
    } else if (field.isText()) {
      writeText(field.text());
    } else if (field.isNumber()) {
      writeNumber(field);
    } else if (const std::optional<bool> flag = field.flag()) {
      out_ += *flag ? "true" : "false";
    } else {
      out_ += "null";
    }
  }

  QByteArray taken() {
    const std::string_view all(out_.constData(), std::size_t(out_.size()));
    out_.truncate(qsizetype(wholeCharacters(all, std::size_t(std::max<qsizetype>(bounds_.text, 0)))));
    return std::move(out_);
  }

 private:
  static bool isByteString(const Field& field) {
    if (!Access::isCbor(field)) return false;
    const CborItem item = Access::cbor(field);
    return item.type == CborItem::Type::Numbers && item.numbers.of == CborNumbers::Of::Unsigned &&
           item.numbers.width == 1;
  }

  void writeBytes(const Field& field) {
    const CborNumbers numbers = Access::cbor(field).numbers;
    out_ += '"';
    out_ += QByteArray::fromRawData(reinterpret_cast<const char*>(numbers.data), qsizetype(numbers.count))
                .toBase64();
    out_ += '"';
  }

  void writeObject(const Field& field) {
    out_ += '{';
    bool first = true;
    field.members([&](std::string_view name, const Field& value) {
      if (full()) return;
      if (!first) out_ += ',';
      first = false;
      writeText(name);
      out_ += ':';
      write(value);
    });
    out_ += '}';
  }

  void writeList(const Field& field) {
    out_ += '[';
    std::size_t shown = 0;
    Access::eachUntil(field, [&](const Field& item) {
      if (shown == bounds_.items || full()) return false;
      if (shown > 0) out_ += ',';
      ++shown;
      write(item);
      return true;
    });
    if (bounds_.whole) {
      // It is complete; counting again would take as long.
    } else if (const std::size_t size = full() ? shown : field.size(); size > shown) {
      out_ += ",\"" + kMore + ' ' + QByteArray::number(qulonglong(size - shown)) + '"';
    }
    out_ += ']';
  }

  void writeText(std::string_view text) {
    constexpr char kHex[] = "0123456789abcdef";
    const std::size_t shown = wholeCharacters(text, bounds_.letters);
    out_ += '"';
    for (const char c : text.substr(0, shown)) {
      if (c == '"' || c == '\\') {
        out_ += '\\';
        out_ += c;
      } else if (c == '\n') {
        out_ += "\\n";
      } else if (std::uint8_t(c) < 0x20 || c == 0x7f) {
        out_ += "\\u00";
        out_ += kHex[std::uint8_t(c) >> 4];
        out_ += kHex[c & 15];
      } else {
        out_ += c;
      }
    }
    if (shown < text.size()) out_ += kMore;
    out_ += '"';
  }

  void writeNumber(const Field& field) {
    if (const std::optional<std::uint64_t> natural = Access::natural(field)) {
      out_ += QByteArray::number(qulonglong(*natural));
      return;
    }
    if (const std::optional<std::int64_t> whole = field.integer()) {
      out_ += QByteArray::number(qlonglong(*whole));
      return;
    }
    std::array<char, 32> digits{};
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), field.number().value_or(0)).ptr;
    out_.append(digits.data(), end - digits.data());
  }

  Bounds bounds_;
  QByteArray out_;
};

}  // namespace

QByteArray Field::toJson(qsizetype max) const {
  Writer writer({max, kShownItems, kShownText, false});
  writer.write(*this);
  return writer.taken();
}

QByteArray Field::toWholeJson() const {
  Writer writer({});
  writer.write(*this);
  return writer.taken();
}

}  // namespace mapwright::net::rosbridge
