// A message as a value, whatever it will be written as, and its bytes: JSON, CBOR, base64.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "geometry/pose.h"
#include "simulator/simulator.h"

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

  Value() = default;  // null
  template <std::integral Number>
  Value(Number number)
      : data_(static_cast<std::conditional_t<std::is_same_v<Number, bool>, bool, std::int64_t>>(number)) {}
  template <typename T>
  requires(!std::integral<T> && std::constructible_from<Data, T>) Value(T data) : data_(std::move(data)) {}
  Value(std::string_view text);

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
/// [x,y] in millimetres
Value pointOf(const Eigen::Vector2d& point);
/// [[x,y],...]
Value pointsOf(const std::vector<Eigen::Vector2d>& points);
/// {"pos":[x,y],"ori":rad}
Value placeOf(const geometry::Pose2& pose);
/// The corners of a rectangle around a pose, not closed.
std::vector<Eigen::Vector2d> cornersOf(const geometry::Pose2& pose, double length_m, double width_m);

/// What is not finite becomes null.
std::string toJson(const Value& value, RosWriter writer = RosWriter::Plain);
/// Whole numbers and others are told apart (2 and 2.0). nullopt when the text is no JSON.
std::optional<Value> fromJson(std::string_view text);
/// Typed arrays are tagged little-endian byte strings. nullopt when a list of texts is not empty: servers
/// lose such messages (docs/protocols/rosbridge.md, "Compression").
std::optional<std::string> toCbor(const Value& value);

// JSON piece by piece, for what is too large to be a value.
void appendJsonText(std::string& out, std::string_view text, RosWriter writer = RosWriter::Plain);
/// Appends `number` with so many decimals, or the shortest text that reads back as it; null if it is not
/// finite.
void appendJsonNumber(std::string& out, double number, int digits = -1);

std::string base64(std::string_view bytes);
/// nullopt when it is no base64.
std::optional<std::string> fromBase64(std::string_view text);

/// Appends the bytes of a number.
template <typename Number>
void appendNumber(std::string& out, Number number, bool big_endian = false) {
  const auto bytes = std::bit_cast<std::array<char, sizeof(Number)>>(number);
  static_assert(std::endian::native == std::endian::little);
  if (big_endian) {
    out.append(bytes.rbegin(), bytes.rend());
  } else {
    out.append(bytes.begin(), bytes.end());
  }
}

}  // namespace mapwright::simulator
