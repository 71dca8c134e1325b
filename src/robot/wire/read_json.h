// Reading what robots call JSON, leniently: numbers as strings, members under several names, null for absent.
// Values are views into their reader; all functions are pure and never throw.
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

/// A number that is missing.
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

using Json = simdjson::dom::element;
using JsonList = simdjson::dom::array;
using Names = std::initializer_list<std::string_view>;

/// Reads one text after the other, keeping its memory. Not thread-safe.
class JsonReader {
 public:
  /// The value that `utf8` holds, valid until the next read; nullopt when it is not JSON. Literal NaN and
  /// Infinity (no JSON, but sent by robots) and numbers beyond any type count as null.
  std::optional<Json> read(std::string_view utf8);
  /// The same; whole numbers of more than 15 digits come as strings that keep them all.
  std::optional<Json> readKeepingDigits(std::string_view utf8);

 private:
  simdjson::dom::parser parser_;
};

/// The first member of these names that is there and not null.
std::optional<Json> member(const Json& object, Names names);

/// A finite number, also one in a string.
std::optional<double> asNumber(const Json& value);
/// A whole number that fits, also as 3.0 or "3".
std::optional<std::int64_t> asInteger(const Json& value);
/// A string, or a number or truth value as it is written; empty for anything else.
std::string asText(const Json& value);
/// [x, y, ...], {"x", "y"} or {"pos": ...} with finite numbers.
std::optional<Eigen::Vector2d> asPoint(const Json& value);
/// {"pos": [x, y], "ori": rad}, {"x", "y", "yaw"} or [x, y, rad]; a heading that is missing is 0.
std::optional<geometry::Pose2> asPose(const Json& value);
/// A list of points; those that cannot be read are left out.
std::vector<Eigen::Vector2d> asPolyline(const Json& value);
/// A list, bare or as the member of an object (any of `wrappers`, "results", "data", "items", "list").
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
