// A message as a value, whatever it will be written as.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace mapwright::simulator {

class Value {
 public:
  struct Member;
  using List = std::vector<Value>;
  using Object = std::vector<Member>;  // in the order they are written in
  /// uint8[]: base64 in JSON, a byte string in CBOR.
  struct Bytes {
    std::string data;
  };
  /// JSON as it is to be written; nothing in CBOR.
  struct Json {
    std::string text;
  };
  using Int8s = std::vector<std::int8_t>;
  using Float32s = std::vector<float>;
  using Float64s = std::vector<double>;
  using Data = std::variant<std::monostate, bool, std::int64_t, double, std::string, List, Object, Bytes,
                            Int8s, Float32s, Float64s, Json>;

  Value();  // null
  template <typename T>
  requires std::is_integral_v<T> Value(T number) {
    if constexpr (std::is_same_v<T, bool>) {
      data_ = number;
    } else {
      data_ = static_cast<std::int64_t>(number);
    }
  }
  Value(double number);
  Value(std::string text);
  Value(std::string_view text);
  Value(const char* text);
  Value(List list);
  Value(Object members);
  Value(Bytes bytes);
  Value(Json json);
  Value(Int8s numbers);
  Value(Float32s numbers);
  Value(Float64s numbers);
  Value(const Value& other);
  Value(Value&& other) noexcept;
  Value& operator=(const Value& other);
  Value& operator=(Value&& other) noexcept;
  ~Value();

  const Data& data() const { return data_; }
  template <typename T>
  const T* as() const {
    return std::get_if<T>(&data_);
  }
  template <typename T>
  T* as() {
    return std::get_if<T>(&data_);
  }
  bool isNull() const { return std::holds_alternative<std::monostate>(data_); }
  bool isNumber() const { return as<std::int64_t>() != nullptr || as<double>() != nullptr; }

  /// A member of an object; null where there is none.
  const Value& operator[](std::string_view name) const;
  bool has(std::string_view name) const { return find(name) != nullptr; }
  /// Sets or adds a member; what was no object becomes one.
  void set(std::string_view name, Value value);
  /// The text; empty for what is none.
  const std::string& text() const;
  /// The number; 0 for what is none.
  double number() const;
  bool flag() const;  // false for what is none

 private:
  const Value* find(std::string_view name) const;

  Data data_;
};

struct Value::Member {
  Member(std::string_view name, Value value);

  std::string name;
  Value value;
};

/// A number with so many digits behind the point; null when it is not finite.
Value fixed(double number, int digits);
/// A lone float32, as robots' single precision has it: 0.05000000074505806.
Value float32(double number);

}  // namespace mapwright::simulator
