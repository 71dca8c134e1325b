// What stands in a message of rosbridge, whichever way it came (rosbridge v2, "Protocol": JSON, png, CBOR).
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
/// type. Reading is lenient and never throws; what is absent or of another type is a null field or nullopt. A
/// number that is not finite is null, as it is in JSON. Texts and names are untrusted, but always valid
/// UTF-8.
class Field {
 public:
  Field() = default;  // null

  bool isNull() const { return kind_ == Kind::Null || kind_ == Kind::NotFinite; }
  bool isObject() const;
  bool isList() const;  // typed arrays and byte strings of CBOR as well
  bool isText() const;
  bool isNumber() const;
  explicit operator bool() const { return !isNull(); }

  /// The member of an object; null where there is none.
  Field operator[](std::string_view name) const;
  /// Of a list; else 0.
  std::size_t size() const;
  void each(const std::function<void(const Field&)>& take) const;                       // items of a list
  void members(const std::function<void(std::string_view, const Field&)>& take) const;  // of an object

  std::optional<double> number() const;  // finite; also a number written as text
  /// A number as the robot has it: null is NaN, and CBOR tells infinities.
  std::optional<double> real() const;
  std::optional<std::int64_t> integer() const;   // whole and fits; 3.0 and "3" are
  std::optional<std::uint64_t> natural() const;  // likewise, from 0 on: what integer() cannot hold, too
  std::optional<bool> flag() const;              // true/false, 0/1
  std::string text() const;                      // of a text; empty for all else

  /// uint8[]: base64 text, a list of numbers 0..255, or a byte string or typed array of CBOR. nullopt: none
  /// of these, or longer than `max` bytes.
  std::optional<std::string> bytes(std::size_t max) const;
  /// int8[]: numbers or a typed array; a number out of -128..127 makes it nullopt, more than `max` likewise.
  std::optional<std::vector<std::int8_t>> int8s(std::size_t max) const;
  /// float32[] and float64[]: numbers or a typed array; null (NaN, infinities) is NaN. nullopt: none of
  /// these, or more than `max`.
  std::optional<std::vector<double>> numbers(std::size_t max) const;
  /// Where the numbers of a typed array of CBOR, or of a byte string, lie.
  std::optional<CborNumbers> typedArray() const;
  /// Seconds since the epoch of a ROS time, {secs,nsecs} or {sec,nanosec}.
  std::optional<double> time() const;

  /// For people: JSON of at most `max` bytes, cut where it would be longer. Of a list the first items stand,
  /// then the text "… n" with the number of those left out; long texts end in "…".
  QByteArray toJson(qsizetype max) const;
  /// For programs: all of it, as rosbridge writes it. Byte strings of CBOR (uint8[]) are base64, all other
  /// lists are lists of JSON.
  QByteArray toWholeJson() const;

 private:
  friend class Frame;
  friend struct Access;  // what only the readers of this folder may do
  enum class Kind : std::uint8_t { Null, NotFinite, Json, Cbor, Integer, Real };
  Kind kind_ = Kind::Null;
  std::array<std::uint64_t, 2> raw_{};  // an element of simdjson, where an item of CBOR lies, or a number
};

}  // namespace mapwright::net::rosbridge
