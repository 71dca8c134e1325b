#include <array>
#include <charconv>

#include <QByteArray>

#include "net/rosbridge/access.h"
#include "net/rosbridge/field.h"

namespace mapwright::net::rosbridge {
namespace {

constexpr std::size_t kShownItems = 32, kShownText = 512;
const QByteArray kMore = QByteArrayLiteral("\xe2\x80\xa6");  // …

/// The longest beginning of UTF-8 `text` with at most `bytes` bytes that cuts no character.
std::size_t wholeCharacters(std::string_view text, std::size_t bytes) {
  if (bytes >= text.size()) return text.size();
  while (bytes > 0 && (std::uint8_t(text[bytes]) & 0xc0) == 0x80) --bytes;
  return bytes;
}

class Writer {
 public:
  explicit Writer(qsizetype max) : max_(max) {}

  bool full() const { return out_.size() > max_; }

  void write(const Field& field) {
    if (full()) return;
    if (field.isObject()) {
      writeObject(field);
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
    out_.truncate(qsizetype(wholeCharacters(all, std::size_t(std::max<qsizetype>(max_, 0)))));
    return std::move(out_);
  }

 private:
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
      if (shown == kShownItems || full()) return false;
      if (shown > 0) out_ += ',';
      ++shown;
      write(item);
      return true;
    });
    if (const std::size_t size = full() ? shown : field.size(); size > shown) {
      out_ += ",\"" + kMore + ' ' + QByteArray::number(qulonglong(size - shown)) + '"';
    }
    out_ += ']';
  }

  void writeText(std::string_view text) {
    constexpr char kHex[] = "0123456789abcdef";
    const std::size_t shown = wholeCharacters(text, kShownText);
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
    if (const std::optional<std::int64_t> whole = field.integer()) {
      out_ += QByteArray::number(qlonglong(*whole));
      return;
    }
    std::array<char, 32> digits{};
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), field.number().value_or(0)).ptr;
    out_.append(digits.data(), end - digits.data());
  }

  qsizetype max_;
  QByteArray out_;
};

}  // namespace

QByteArray Field::toJson(qsizetype max) const {
  Writer writer(max);
  writer.write(*this);
  return writer.taken();
}

}  // namespace mapwright::net::rosbridge
