#include "net/rosbridge/field.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

#include <QByteArray>
#include <QString>
#include <simdjson.h>

#include "net/rosbridge/access.h"

namespace mapwright::net::rosbridge {
namespace {

using Type = CborItem::Type;

constexpr std::size_t kCountedByJson = 0xffffff;  // simdjson stores 24 bits of the length of a list

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

template <typename Number>
std::optional<Number> numberIn(std::string_view text) {
  Number value{};
  text = trimmed(text);
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return !text.empty() && stop == end && error == std::errc() ? std::optional(value) : std::nullopt;
}

std::optional<std::int64_t> wholeOf(double value) {
  constexpr double kBeyond = 9223372036854775808.0;  // 2^63
  if (!(value >= -kBeyond && value < kBeyond) || value != std::trunc(value)) return std::nullopt;
  return std::int64_t(value);
}

/// The raw bytes: text in JSON is UTF-8, that in CBOR may be anything.
std::optional<std::string_view> rawText(const Field& field) {
  if (Access::isJson(field)) {
    std::string_view text;
    if (Access::json(field).get(text)) return std::nullopt;
    return text;
  }
  if (Access::isCbor(field)) {
    const CborItem item = Access::cbor(field);
    if (item.type == Type::Text) return item.text;
  }
  return std::nullopt;
}

/// With or without line breaks and padding.
std::optional<std::string> fromBase64(std::string_view text, std::size_t max) {
  if (text.size() / 2 > max) return std::nullopt;
  std::string dense;
  if (text.find_first_of(" \t\r\n") != std::string_view::npos) {
    dense = text;
    std::erase_if(dense, [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; });
    text = dense;
  }
  const std::size_t digits = text.find_last_not_of('=') + 1;  // npos + 1 is 0
  if (digits % 4 == 1) return std::nullopt;
  const auto result = QByteArray::fromBase64Encoding(
      QByteArray::fromRawData(text.data(), qsizetype(text.size())), QByteArray::AbortOnBase64DecodingErrors);
  if (!result || std::size_t((*result).size()) > max) return std::nullopt;
  return (*result).toStdString();
}

/// A typed array of bytes, or a byte string.
bool holdsBytes(const std::optional<CborNumbers>& numbers, CborNumbers::Of of) {
  return numbers && numbers->width == 1 && numbers->of == of;
}

/// Integers between `least` and `most`, at most `max` of them.
template <typename Out>
std::optional<Out> wholes(const Field& list, std::size_t max, std::int64_t least, std::int64_t most) {
  using Cell = typename Out::value_type;
  const std::size_t size = list.size();
  if (!list.isList() || size > max) return std::nullopt;
  Out out;
  out.reserve(size);
  bool fine = true;
  Access::eachUntil(list, [&](const Field& item) {
    std::int64_t value = 0;
    if (!Access::isJson(item) || Access::json(item).get(value) != simdjson::SUCCESS) {
      const std::optional<std::int64_t> whole = item.isNumber() ? item.integer() : std::nullopt;
      fine = whole.has_value();
      value = whole.value_or(0);
    }
    fine = fine && value >= least && value <= most;
    if (fine) out.push_back(Cell(value));
    return fine;
  });
  return fine ? std::optional(std::move(out)) : std::nullopt;
}

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
    } else if (const auto numbers = field.typedArray();
               bounds_.whole && holdsBytes(numbers, CborNumbers::Of::Unsigned)) {
      writeBytes(*numbers);
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
  void writeBytes(const CborNumbers& numbers) {
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

bool Field::isObject() const {
  return kind_ == Kind::Json ? Access::json(*this).is_object()
                             : kind_ == Kind::Cbor && Access::cbor(*this).type == Type::Object;
}

bool Field::isList() const {
  if (kind_ == Kind::Json) return Access::json(*this).is_array();
  if (kind_ != Kind::Cbor) return false;
  const Type type = Access::cbor(*this).type;
  return type == Type::List || type == Type::Numbers;
}

bool Field::isText() const { return rawText(*this).has_value(); }

bool Field::isNumber() const {
  return kind_ == Kind::Json ? Access::json(*this).is_number()
                             : kind_ == Kind::Integer || kind_ == Kind::Real;
}

Field Field::operator[](std::string_view name) const {
  Field found;
  if (kind_ == Kind::Json) {
    simdjson::dom::object object;
    simdjson::dom::element member;
    if (!Access::json(*this).get(object) && !object.at_key(name).get(member)) found = Access::ofJson(member);
  } else if (kind_ == Kind::Cbor) {
    const CborItem item = Access::cbor(*this);
    if (item.type != Type::Object) return found;
    const std::uint8_t* const end = Access::cborEnd(*this);
    eachMember(item, end, [&](std::string_view key, const std::uint8_t* value) {
      if (key != name) return true;
      found = Access::ofCbor(value, end);
      return false;
    });
  }
  return found;
}

std::size_t Field::size() const {
  std::size_t size = 0;
  if (kind_ == Kind::Json) {
    simdjson::dom::array items;
    if (Access::json(*this).get(items)) return 0;
    size = items.size();
    if (size < kCountedByJson) return size;
  } else if (kind_ == Kind::Cbor) {
    const CborItem item = Access::cbor(*this);
    if (item.type == Type::Numbers) return item.numbers.count;
    if (item.type != Type::List) return 0;
    if (item.count) return std::size_t(*item.count);
  }
  size = 0;
  Access::eachUntil(*this, [&](const Field&) {
    ++size;
    return true;
  });
  return size;
}

void Field::each(const std::function<void(const Field&)>& visit) const {
  Access::eachUntil(*this, [&](const Field& item) {
    visit(item);
    return true;
  });
}

void Field::members(const std::function<void(std::string_view, const Field&)>& visit) const {
  if (kind_ == Kind::Json) {
    simdjson::dom::object object;
    if (Access::json(*this).get(object)) return;
    for (const auto& [key, value] : object) visit(key, Access::ofJson(value));
  } else if (kind_ == Kind::Cbor) {
    const CborItem item = Access::cbor(*this);
    if (item.type != Type::Object) return;
    const std::uint8_t* const end = Access::cborEnd(*this);
    eachMember(item, end, [&](std::string_view key, const std::uint8_t* value) {
      if (simdjson::validate_utf8(key.data(), key.size())) visit(key, Access::ofCbor(value, end));
      return true;
    });
  }
}

std::optional<double> Field::number() const {
  switch (kind_) {
    case Kind::Integer:
      return double(Access::whole(*this));
    case Kind::Real:
      return Access::real(*this);
    case Kind::Json: {
      double value = 0;
      if (!Access::json(*this).get(value)) return value;
      break;
    }
    default:
      break;
  }
  const std::optional<std::string_view> text = rawText(*this);
  const std::optional<double> value = text ? numberIn<double>(*text) : std::nullopt;
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<double> Field::real() const {
  if (kind_ == Kind::NotFinite) return Access::real(*this);
  if (kind_ == Kind::Null) return std::numeric_limits<double>::quiet_NaN();
  return isNumber() ? number() : std::nullopt;
}

std::optional<CborNumbers> Field::typedArray() const {
  if (kind_ != Kind::Cbor) return std::nullopt;
  const CborItem item = Access::cbor(*this);
  return item.type == Type::Numbers ? std::optional(item.numbers) : std::nullopt;
}

std::optional<std::int64_t> Field::integer() const {
  std::int64_t exact = 0;
  if (kind_ == Kind::Integer) return Access::whole(*this);
  if (kind_ == Kind::Json && !Access::json(*this).get(exact)) return exact;
  if (const std::optional<std::string_view> text = rawText(*this)) {
    if (const auto value = numberIn<std::int64_t>(*text)) return value;
  }
  const std::optional<double> value = number();
  return value ? wholeOf(*value) : std::nullopt;
}

std::optional<std::uint64_t> Field::natural() const {
  if (const auto beyond = Access::natural(*this)) return beyond;
  const std::optional<std::int64_t> whole = integer();
  return whole && *whole >= 0 ? std::optional(std::uint64_t(*whole)) : std::nullopt;
}

std::optional<bool> Field::flag() const {
  bool value = false;
  if (kind_ == Kind::Json && !Access::json(*this).get(value)) return value;
  if (kind_ == Kind::Cbor) {
    const CborItem item = Access::cbor(*this);
    if (item.type == Type::Flag) return item.flag;
  }
  const std::optional<std::int64_t> whole = isNumber() ? integer() : std::nullopt;
  return whole == 0 || whole == 1 ? std::optional(*whole == 1) : std::nullopt;
}

std::string Field::text() const {
  const std::optional<std::string_view> raw = rawText(*this);
  if (!raw) return {};
  if (kind_ == Kind::Cbor && !simdjson::validate_utf8(raw->data(), raw->size())) {
    return QString::fromUtf8(raw->data(), qsizetype(raw->size())).toStdString();
  }
  return std::string(*raw);
}

std::optional<std::string> Field::bytes(std::size_t max) const {
  if (const std::optional<std::string_view> text = rawText(*this)) return fromBase64(*text, max);
  const std::optional<CborNumbers> numbers = typedArray();
  if (holdsBytes(numbers, CborNumbers::Of::Unsigned)) {
    if (numbers->count > max) return std::nullopt;
    return std::string(reinterpret_cast<const char*>(numbers->data), numbers->count);
  }
  return wholes<std::string>(*this, max, 0, 255);
}

std::optional<std::vector<std::int8_t>> Field::int8s(std::size_t max) const {
  const std::optional<CborNumbers> numbers = typedArray();
  if (holdsBytes(numbers, CborNumbers::Of::Signed)) {
    if (numbers->count > max) return std::nullopt;
    const auto* const first = reinterpret_cast<const std::int8_t*>(numbers->data);
    return std::vector<std::int8_t>(first, first + numbers->count);
  }
  return wholes<std::vector<std::int8_t>>(*this, max, -128, 127);
}

std::optional<std::vector<double>> Field::numbers(std::size_t max) const {
  const std::size_t size = this->size();
  if (!isList() || size > max) return std::nullopt;
  std::vector<double> out;
  out.reserve(size);
  bool fine = true;
  Access::eachUntil(*this, [&](const Field& item) {
    const std::optional<double> value = item.number();
    fine = value || item.isNull();
    out.push_back(value.value_or(std::numeric_limits<double>::quiet_NaN()));
    return fine;
  });
  return fine ? std::optional(std::move(out)) : std::nullopt;
}

std::optional<double> Field::time() const {
  for (const auto& [whole, part] : {std::pair{"secs", "nsecs"}, std::pair{"sec", "nanosec"}}) {
    const std::optional<double> seconds = (*this)[whole].number();
    const Field nanoseconds = (*this)[part];
    if (seconds && (!nanoseconds || nanoseconds.number()))
      return *seconds + nanoseconds.number().value_or(0) * 1e-9;
  }
  return std::nullopt;
}

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
