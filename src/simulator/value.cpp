#include "simulator/value.h"

#include <algorithm>

namespace mapwright::simulator {

const Value* Value::find(std::string_view name) const {
  const Object* members = as<Object>();
  if (members == nullptr) return nullptr;
  const auto found = std::find_if(members->begin(), members->end(),
                                  [&](const auto& member) { return member.first == name; });
  return found == members->end() ? nullptr : &found->second;
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
      std::find_if(members.begin(), members.end(), [&](const auto& member) { return member.first == name; });
  if (found != members.end()) {
    found->second = std::move(value);
  } else {
    members.emplace_back(std::string(name), std::move(value));
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

Value float32(double number) { return {static_cast<double>(static_cast<float>(number))}; }

}  // namespace mapwright::simulator
