// A value in a rosbridge message, in any encoding (rosbridge v2, "Protocol": JSON, png, CBOR).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <QByteArray>

namespace mapwright::net::rosbridge {

struct CborNumbers;  // cbor_item.h

/// A value of a message: a view into its Frame, valid as long as that lives, on any thread. A cheap value
/// type. Reading is lenient and never throws; missing values or those of another type are a null field or
/// nullopt. A number that is not finite is null, as in JSON. Texts and names are untrusted, but always valid
/// UTF-8.
class Field {
 public:
  Field() = default;  // null

  bool isNull() const { return kind_ == Kind::Null || kind_ == Kind::NotFinite; }
  bool isObject() const;
  bool isList() const;  // also typed arrays and byte strings of CBOR
  bool isText() const;
  bool isNumber() const;
  explicit operator bool() const { return !isNull(); }

  /// The member of an object; null if there is none.
  Field operator[](std::string_view name) const;
  /// Of a list; otherwise 0.
  std::size_t size() const;
  void each(const std::function<void(const Field&)>& visit) const;                       // items of a list
  void members(const std::function<void(std::string_view, const Field&)>& visit) const;  // of an object

  std::optional<double> number() const;  // finite; also a number in a text
  /// A number as sent: null is NaN, and CBOR has infinities.
  std::optional<double> real() const;
  std::optional<std::int64_t> integer() const;   // whole and in range; also 3.0 and "3"
  std::optional<std::uint64_t> natural() const;  // the same from 0 on, including what does not fit integer()
  std::optional<bool> flag() const;              // true/false, 0/1
  std::string text() const;                      // of a text; otherwise empty

  /// uint8[]: base64 text, a list of numbers 0..255, or a byte string or typed array of CBOR. nullopt: none
  /// of these, or longer than `max` bytes.
  std::optional<std::string> bytes(std::size_t max) const;
  /// int8[]: numbers or a typed array; nullopt if a number is outside -128..127 or there are more than `max`.
  std::optional<std::vector<std::int8_t>> int8s(std::size_t max) const;
  /// float32[] and float64[]: numbers or a typed array; null (NaN, infinities) is NaN. nullopt: none of
  /// these, or more than `max`.
  std::optional<std::vector<double>> numbers(std::size_t max) const;
  /// The bytes of the numbers in a typed array of CBOR, or of a byte string.
  std::optional<CborNumbers> typedArray() const;
  /// Seconds since the epoch of a ROS time, {secs,nsecs} or {sec,nanosec}.
  std::optional<double> time() const;

  /// For display: JSON of at most `max` bytes, truncated if longer. Lists show their first items and the text
  /// "… n" with the number of omitted ones; long texts end in "…".
  QByteArray toJson(qsizetype max) const;
  /// For programs: the complete JSON, as rosbridge writes it. Byte strings of CBOR (uint8[]) are base64, all
  /// other lists are JSON lists.
  QByteArray toWholeJson() const;

 private:
  friend class Frame;
  friend struct Access;  // private functions for the readers of this folder
  enum class Kind : std::uint8_t { Null, NotFinite, Json, Cbor, Integer, Real };
  Kind kind_ = Kind::Null;
  std::array<std::uint64_t, 2> raw_{};  // an element of simdjson, the address of a CBOR item, or a number
};

}  // namespace mapwright::net::rosbridge
