#include "simulator/value.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <QByteArray>
#include <QCborStreamWriter>
#include <QString>
#include <simdjson.h>

namespace mapwright::simulator {
namespace {

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
  void put(std::int64_t number) { out_ += std::to_string(number); }
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
        out_ += std::to_string(item);
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

  QByteArray bytes;
  bool lost = false;

 private:
  static constexpr QCborTag kInt8Tag{72}, kFloat32Tag{85}, kFloat64Tag{86};

  void put(std::monostate) { out_.appendNull(); }
  void put(const Value::Json&) { out_.appendNull(); }
  void put(bool flag) { out_.append(flag); }
  void put(std::int64_t number) { out_.append(qint64{number}); }
  void put(double number) { out_.append(number); }
  void put(const std::string& text) {
    out_.appendTextString(text.data(), static_cast<qsizetype>(text.size()));
  }
  void put(const Value::Bytes& bytes) { putBytes(bytes.data.data(), bytes.data.size()); }
  void put(const Value::List& list) {
    lost = lost || (!list.empty() && list.front().as<std::string>() != nullptr);
    out_.startArray(list.size());
    for (const Value& item : list) write(item);
    out_.endArray();
  }
  void put(const Value::Object& members) {
    out_.startMap(members.size());
    for (const auto& [name, value] : members) {
      put(name);
      write(value);
    }
    out_.endMap();
  }
  template <typename T>
  void put(const std::vector<T>& numbers) {
    out_.append(std::is_same_v<T, std::int8_t> ? kInt8Tag
                : std::is_same_v<T, float>     ? kFloat32Tag
                                               : kFloat64Tag);
    putBytes(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T));
  }
  void putBytes(const char* data, std::size_t size) {
    out_.appendByteString(data, static_cast<qsizetype>(size));
  }

  QCborStreamWriter out_{&bytes};
};

QByteArray viewed(std::string_view bytes) {
  return QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(bytes.size()));
}

void appendPoint(std::string& out, const Eigen::Vector2d& point) {
  out += '[';
  appendJsonNumber(out, point.x(), 3);
  out += ',';
  appendJsonNumber(out, point.y(), 3);
  out += ']';
}

}  // namespace

Value::Value(std::string_view text) : data_(std::string(text)) {}

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
  appendJsonNumber(json.text, number, digits);
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
  const auto append = [&](char16_t unit) {
    if (unit == '"' || unit == '\\' || (unit == '/' && writer == RosWriter::Escaped)) {
      out += '\\';
      out += static_cast<char>(unit);
    } else if (unit == '\n' && !is_plain) {
      out += "\\n";
    } else if (unit >= 0x20 && (is_plain || unit < 0x7F)) {
      out += static_cast<char>(unit);
    } else {
      static constexpr char kDigits[] = "0123456789abcdef";
      out += "\\u";
      for (const int shift : {12, 8, 4, 0}) out += kDigits[(unit >> shift) & 15];
    }
  };
  out += '"';
  if (is_plain) {
    for (const char byte : text) append(static_cast<unsigned char>(byte));
  } else {
    for (const QChar unit : QString::fromUtf8(viewed(text))) append(unit.unicode());
  }
  out += '"';
}

void appendJsonNumber(std::string& out, double number, int digits) {
  if (!std::isfinite(number)) {
    out += "null";
    return;
  }
  std::array<char, 400> buffer;
  char *const from = buffer.data(), *const to = from + buffer.size();
  const auto end = digits < 0 ? std::to_chars(from, to, number)
                              : std::to_chars(from, to, number, std::chars_format::fixed, digits);
  out.append(from, end.ptr);
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
  return writer.lost ? std::nullopt : std::optional(writer.bytes.toStdString());
}

std::string base64(std::string_view bytes) { return viewed(bytes).toBase64().toStdString(); }

std::optional<std::string> fromBase64(std::string_view text) {
  while (text.ends_with('=')) text.remove_suffix(1);
  const auto read = QByteArray::fromBase64Encoding(viewed(text), QByteArray::AbortOnBase64DecodingErrors);
  return read && text.size() % 4 != 1 ? std::optional(read.decoded.toStdString()) : std::nullopt;
}

}  // namespace mapwright::simulator
