// Lenient access to the JSON of robots: numbers as strings, alternative member names, null for absent. Values
// are views into their reader; all functions are pure and never throw.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <simdjson.h>

#include "geometry/pose.h"

namespace mapwright::robot::wire {

/// A missing number.
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

using Json = simdjson::dom::element;
using JsonList = simdjson::dom::array;
using Names = std::initializer_list<std::string_view>;

/// Parses one text after the other, reusing its memory. Not thread-safe.
class JsonReader {
 public:
  /// The parsed value of `utf8`, valid until the next read; nullopt if it is not JSON. Literal NaN and
  /// Infinity (not JSON, but sent by robots) and numbers out of range count as null. A byte order mark in
  /// front is passed over, as RFC 8259 allows.
  std::optional<Json> read(std::string_view utf8);
  /// The same; integers of more than 15 digits become strings to keep all digits.
  std::optional<Json> readKeepingDigits(std::string_view utf8);

 private:
  simdjson::dom::parser parser_;
};

/// The first of these members that exists and is not null.
std::optional<Json> member(const Json& object, Names names);

/// A finite number, also one in a string.
std::optional<double> asNumber(const Json& value);
/// A whole number that fits, also as 3.0 or "3".
std::optional<std::int64_t> asInteger(const Json& value);
/// A string, or a number or boolean as written; empty for anything else.
std::string asText(const Json& value);
/// [x, y, ...], {"x", "y"} or {"pos": ...} with finite numbers.
std::optional<Eigen::Vector2d> asPoint(const Json& value);
/// {"pos": [x, y], "ori": rad}, {"x", "y", "yaw"} or [x, y, rad]; a heading that is missing is 0.
std::optional<geometry::Pose2> asPose(const Json& value);
/// A list of points; unreadable ones are skipped.
std::vector<Eigen::Vector2d> asPolyline(const Json& value);
/// A list, by itself or as a member of an object (any of `wrappers`, "results", "data", "items", "list").
std::optional<JsonList> asList(const Json& value, Names wrappers = {});

std::optional<double> number(const Json& object, Names names);
std::optional<std::int64_t> integer(const Json& object, Names names);
std::optional<int> smallInteger(const Json& object, Names names);
std::optional<bool> flag(const Json& object, Names names);
std::string text(const Json& object, Names names);
std::optional<JsonList> list(const Json& object, Names names);
std::vector<Eigen::Vector2d> polyline(const Json& object, Names names);
/// Seconds since the epoch from seconds, milliseconds or an ISO 8601 text.
std::optional<double> epochSeconds(const Json& object, Names names);

}  // namespace mapwright::robot::wire
