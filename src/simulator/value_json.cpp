#include "simulator/value_json.h"

#include <array>
#include <charconv>
#include <cmath>

#include <simdjson.h>

#include "simulator/json_text.h"
#include "simulator/png_writing.h"

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

void appendAscii(std::string& out, std::string_view text, bool escapes_slash) {
  out += '"';
  for (std::size_t at = 0; at < text.size();) {
    const char32_t code = nextCodePoint(text, at);
    if (code == '"' || code == '\\' || (code == '/' && escapes_slash)) {
      out += '\\';
      out += static_cast<char>(code);
    } else if (code == '\n') {
      out += "\\n";
    } else if (code >= 0x20 && code < 0x7F) {
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
  void put(const std::string& text) {
    if (writer_ == RosWriter::Plain) {
      appendJsonText(out_, text);
    } else {
      appendAscii(out_, text, writer_ == RosWriter::Escaped);
    }
  }
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

}  // namespace

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
