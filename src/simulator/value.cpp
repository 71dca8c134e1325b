#include "simulator/value.h"

#include <algorithm>

#include "simulator/json_text.h"

namespace mapwright::simulator {

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

}  // namespace mapwright::simulator
