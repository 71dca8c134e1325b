#include "simulator/value.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <simdjson.h>

namespace mapwright::simulator {
namespace {

/// The code point that begins at `at`, which goes on to the next one. The text is UTF-8.
char32_t nextCodePoint(std::string_view text, std::size_t& at) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : static_cast<unsigned char>(0x80);
  };
  const char32_t first = byte(at);
  const std::size_t more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : first >= 0xC0 ? 1 : 0;
  char32_t code = more == 3 ? first & 0x07 : more == 2 ? first & 0x0F : more == 1 ? first & 0x1F : first;
  for (std::size_t i = 1; i <= more; ++i) code = code << 6 | (byte(at + i) & 0x3FU);
  at += 1 + more;
  return code;
}

void appendUnit(std::string& out, char32_t unit) {
  static constexpr char kDigits[] = "0123456789abcdef";
  out += "\\u";
  for (const int shift : {12, 8, 4, 0}) out += kDigits[(unit >> shift) & 15];
}

void appendWhole(std::string& out, std::int64_t number) {
  std::array<char, 24> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
  out.append(buffer.data(), end);
}

class JsonWriter {
 public:
  JsonWriter(std::string& out, RosWriter writer)
      : out_(out),
        writer_(writer),
        comma_(writer == RosWriter::Spaced ? ", " : ","),
        colon_(writer == RosWriter::Spaced ? ": " : ":") {}

  void write(const Value& value) {
    std::visit([this](const auto& data) { put(data); }, value.data());
  }

 private:
  void put(std::monostate) { out_ += "null"; }
  void put(bool flag) { out_ += flag ? "true" : "false"; }
  void put(std::int64_t number) { appendWhole(out_, number); }
  void put(double number) {
    const std::size_t from = out_.size();
    appendJsonNumber(out_, number);
    // As Python has it: a float is never written as a whole number.
    const bool whole = out_.find_first_not_of("-0123456789", from) == std::string::npos;
    if (writer_ == RosWriter::Spaced && whole) out_ += ".0";
  }
  void put(const std::string& text) { appendJsonText(out_, text, writer_); }
  void put(const Value::Json& json) { out_ += json.text; }
  void put(const Value::Bytes& bytes) { put(base64(bytes.data)); }
  void put(const Value::Object& members) {
    out_ += '{';
    const char* before = "";
    for (const auto& [name, value] : members) {
      out_ += before;
      before = comma_;
      put(name);
      out_ += colon_;
      write(value);
    }
    out_ += '}';
  }
  template <typename T>
  void put(const std::vector<T>& list) {
    out_ += '[';
    const char* before = "";
    for (const T& item : list) {
      out_ += before;
      before = comma_;
      if constexpr (std::is_same_v<T, Value>) {
        write(item);
      } else if constexpr (std::is_integral_v<T>) {
        appendWhole(out_, item);
      } else {
        put(static_cast<double>(item));
      }
    }
    out_ += ']';
  }

  std::string& out_;
  const RosWriter writer_;
  const char *comma_, *colon_;
};

Value valueOf(const simdjson::dom::element& element) {
  bool flag = false;
  std::int64_t whole = 0;
  double real = 0;
  std::string_view text;
  simdjson::dom::array items;
  simdjson::dom::object object;
  if (element.get(flag) == simdjson::SUCCESS) return {flag};
  if (element.get(whole) == simdjson::SUCCESS) return {whole};
  if (element.get(real) == simdjson::SUCCESS) return {real};
  if (element.get(text) == simdjson::SUCCESS) return {text};
  if (element.get(items) == simdjson::SUCCESS) {
    Value::List list;
    for (const simdjson::dom::element item : items) list.push_back(valueOf(item));
    return {std::move(list)};
  }
  if (element.get(object) == simdjson::SUCCESS) {
    Value::Object members;
    for (const auto& [name, item] : object) members.emplace_back(name, valueOf(item));
    return {std::move(members)};
  }
  return {};
}

/// CBOR; `lost` when the message is one that servers lose.
class CborWriter {
 public:
  void write(const Value& value) {
    std::visit([this](const auto& data) { put(data); }, value.data());
  }

  std::string out;
  bool lost = false;

 private:
  enum Major : unsigned { kUnsigned, kNegative, kByteString, kText, kList, kMap, kTag };
  static constexpr std::uint64_t kInt8Tag = 72, kFloat32Tag = 85, kFloat64Tag = 86;

  void head(Major major, std::uint64_t argument) {
    const auto with = [&](unsigned low) { out += static_cast<char>(major << 5 | low); };
    if (argument < 24) {
      with(static_cast<unsigned>(argument));
    } else if (argument <= 0xFF) {
      with(24);
      appendNumber(out, static_cast<std::uint8_t>(argument), true);
    } else if (argument <= 0xFFFF) {
      with(25);
      appendNumber(out, static_cast<std::uint16_t>(argument), true);
    } else if (argument <= 0xFFFF'FFFFUL) {
      with(26);
      appendNumber(out, static_cast<std::uint32_t>(argument), true);
    } else {
      with(27);
      appendNumber(out, argument, true);
    }
  }
  void bytes(Major major, std::string_view bytes) {
    head(major, bytes.size());
    out += bytes;
  }

  void put(std::monostate) { out += '\xF6'; }
  void put(bool flag) { out += flag ? '\xF5' : '\xF4'; }
  void put(std::int64_t number) {
    head(number >= 0 ? kUnsigned : kNegative,
         static_cast<std::uint64_t>(number >= 0 ? number : -(number + 1)));
  }
  void put(double number) {
    out += '\xFB';
    appendNumber(out, number, true);
  }
  void put(const std::string& text) { bytes(kText, text); }
  void put(const Value::List& list) {
    lost = lost || (!list.empty() && list.front().as<std::string>() != nullptr);
    head(kList, list.size());
    for (const Value& item : list) write(item);
  }
  void put(const Value::Object& members) {
    head(kMap, members.size());
    for (const auto& [name, value] : members) {
      bytes(kText, name);
      write(value);
    }
  }
  void put(const Value::Json&) { put(std::monostate()); }
  void put(const Value::Bytes& data) { bytes(kByteString, data.data); }
  template <typename T>
  void put(const std::vector<T>& numbers) {
    head(kTag, std::is_same_v<T, std::int8_t> ? kInt8Tag
               : std::is_same_v<T, float>     ? kFloat32Tag
                                              : kFloat64Tag);
    bytes(kByteString, {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T)});
  }
};

void appendPoint(std::string& out, const Eigen::Vector2d& point) {
  out += '[';
  appendJsonFixed(out, point.x(), 3);
  out += ',';
  appendJsonFixed(out, point.y(), 3);
  out += ']';
}

}  // namespace

// Not in the class: each message is made of dozens of values, and each would be made and unmade in its place.
Value::Value() = default;
Value::Value(double number) : data_(number) {}
Value::Value(std::string text) : data_(std::move(text)) {}
Value::Value(std::string_view text) : data_(std::string(text)) {}
Value::Value(const char* text) : data_(std::string(text)) {}
Value::Value(List list) : data_(std::move(list)) {}
Value::Value(Object members) : data_(std::move(members)) {}
Value::Value(Bytes bytes) : data_(std::move(bytes)) {}
Value::Value(Json json) : data_(std::move(json)) {}
Value::Value(Int8s numbers) : data_(std::move(numbers)) {}
Value::Value(Float32s numbers) : data_(std::move(numbers)) {}
Value::Value(Float64s numbers) : data_(std::move(numbers)) {}
Value::Value(const Value& other) = default;
Value::Value(Value&& other) noexcept = default;
Value& Value::operator=(const Value& other) = default;
Value& Value::operator=(Value&& other) noexcept = default;
Value::~Value() = default;

Value::Member::Member(std::string_view key, Value content) : name(key), value(std::move(content)) {}

const Value* Value::find(std::string_view name) const {
  const Object* members = as<Object>();
  if (members == nullptr) return nullptr;
  const auto found =
      std::find_if(members->begin(), members->end(), [&](const auto& member) { return member.name == name; });
  return found == members->end() ? nullptr : &found->value;
}

const Value& Value::operator[](std::string_view name) const {
  static const Value null;
  const Value* found = find(name);
  return found != nullptr ? *found : null;
}

void Value::set(std::string_view name, Value value) {
  if (as<Object>() == nullptr) data_ = Object{};
  auto& members = std::get<Object>(data_);
  const auto found =
      std::find_if(members.begin(), members.end(), [&](const auto& member) { return member.name == name; });
  if (found != members.end()) {
    found->value = std::move(value);
  } else {
    members.emplace_back(name, std::move(value));
  }
}

const std::string& Value::text() const {
  static const std::string empty;
  const std::string* found = as<std::string>();
  return found != nullptr ? *found : empty;
}

double Value::number() const {
  if (const double* real = as<double>()) return *real;
  const std::int64_t* whole = as<std::int64_t>();
  return whole != nullptr ? static_cast<double>(*whole) : 0;
}

bool Value::flag() const {
  const bool* found = as<bool>();
  return found != nullptr && *found;
}

Value fixed(double number, int digits) {
  Value::Json json;
  appendJsonFixed(json.text, number, digits);
  return {std::move(json)};
}

Value float32(double number) { return {static_cast<double>(static_cast<float>(number))}; }

Value pointOf(const Eigen::Vector2d& point) {
  Value::Json json;
  appendPoint(json.text, point);
  return {std::move(json)};
}

Value pointsOf(const std::vector<Eigen::Vector2d>& points) {
  Value::Json json{"["};
  for (const Eigen::Vector2d& point : points) {
    if (json.text.size() > 1) json.text += ',';
    appendPoint(json.text, point);
  }
  json.text += ']';
  return {std::move(json)};
}

Value placeOf(const geometry::Pose2& pose) {
  return Value::Object{{"pos", pointOf({pose.x_m, pose.y_m})}, {"ori", fixed(pose.yaw_rad, 4)}};
}

std::vector<Eigen::Vector2d> cornersOf(const geometry::Pose2& pose, double length_m, double width_m) {
  const double l = length_m / 2, w = width_m / 2;
  return {pose.apply({-l, -w}), pose.apply({l, -w}), pose.apply({l, w}), pose.apply({-l, w})};
}

void appendJsonText(std::string& out, std::string_view text, RosWriter writer) {
  const bool is_plain = writer == RosWriter::Plain;
  out += '"';
  for (std::size_t at = 0; at < text.size();) {
    const char32_t code = is_plain ? static_cast<unsigned char>(text[at++]) : nextCodePoint(text, at);
    if (code == '"' || code == '\\' || (code == '/' && writer == RosWriter::Escaped)) {
      out += '\\';
      out += static_cast<char>(code);
    } else if (code == '\n' && !is_plain) {
      out += "\\n";
    } else if (code >= 0x20 && (is_plain || code < 0x7F)) {
      out += static_cast<char>(code);
    } else if (code < 0x10000) {
      appendUnit(out, code);
    } else {
      appendUnit(out, 0xD800 + ((code - 0x10000) >> 10));
      appendUnit(out, 0xDC00 + ((code - 0x10000) & 0x3FF));
    }
  }
  out += '"';
}

void appendJsonNumber(std::string& out, double number) {
  if (!std::isfinite(number)) {
    out += "null";
    return;
  }
  std::array<char, 64> buffer;
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
  out.append(buffer.data(), result.ptr);
}

void appendJsonFixed(std::string& out, double number, int digits) {
  std::array<char, 400> buffer;
  const auto result = std::isfinite(number)
                          ? std::to_chars(buffer.data(), buffer.data() + buffer.size(), number,
                                          std::chars_format::fixed, digits)
                          : std::to_chars_result{buffer.data(), std::errc::invalid_argument};
  if (result.ec != std::errc()) {
    out += "null";
    return;
  }
  out.append(buffer.data(), result.ptr);
}

std::string toJson(const Value& value, RosWriter writer) {
  std::string out;
  JsonWriter(out, writer).write(value);
  return out;
}

std::optional<Value> fromJson(std::string_view text) {
  simdjson::dom::parser parser;
  simdjson::dom::element document;
  if (parser.parse(text.data(), text.size()).get(document) != simdjson::SUCCESS) return std::nullopt;
  return valueOf(document);
}

std::optional<std::string> toCbor(const Value& value) {
  CborWriter writer;
  writer.write(value);
  return writer.lost ? std::nullopt : std::optional(std::move(writer.out));
}

std::string base64(std::string_view bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      out += i + k <= bytes.size() ? kDigits[(group >> (18 - 6 * k)) & 63] : '=';
  }
  return out;
}

std::optional<std::string> fromBase64(std::string_view text) {
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  std::string bytes;
  bytes.reserve(text.size() * 3 / 4);
  unsigned group = 0;
  int bits = 0;
  for (const char c : text) {
    const int digit = c >= 'A' && c <= 'Z'   ? c - 'A'
                      : c >= 'a' && c <= 'z' ? c - 'a' + 26
                      : c >= '0' && c <= '9' ? c - '0' + 52
                      : c == '+'             ? 62
                      : c == '/'             ? 63
                                             : -1;
    if (digit < 0) return std::nullopt;
    group = group << 6 | static_cast<unsigned>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>((group >> bits) & 0xFF);
  }
  return bytes;
}

}  // namespace mapwright::simulator
