#include "robot/wire/read_json.h"

#include <charconv>
#include <cmath>
#include <limits>

#include <QDateTime>

#include "net/json_numbers.h"

namespace mapwright::robot::wire {
namespace {

// Longer texts get a parser of their own, so that one huge message does not keep its memory for good.
constexpr std::size_t kKept = std::size_t(16) << 20;
constexpr double kLatestSeconds = 1e11;  // the year 5138; beyond it, it is milliseconds

std::optional<double> numberIn(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '+')) text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

std::optional<Json> JsonReader::read(std::string_view utf8) {
  if (parser_.capacity() > kKept) parser_ = simdjson::dom::parser();
  if (utf8.starts_with("\xEF\xBB\xBF")) utf8.remove_prefix(3);
  Json root;
  if (!parser_.parse(utf8.data(), utf8.size()).get(root)) return root;
  const std::string repaired = net::repairNumbers(utf8);
  if (!parser_.parse(repaired.data(), repaired.size()).get(root)) return root;
  return std::nullopt;
}

std::optional<Json> JsonReader::readKeepingDigits(std::string_view utf8) {
  return read(net::quoteLongNumbers(utf8));
}

std::optional<Json> member(const Json& object, Names names) {
  for (const std::string_view name : names) {
    Json value;
    if (!object[name].get(value) && !value.is_null()) return value;
  }
  return std::nullopt;
}

std::optional<double> asNumber(const Json& value) {
  double result = 0;
  if (!value.get(result)) return std::isfinite(result) ? std::optional(result) : std::nullopt;
  std::string_view text;
  return value.get(text) ? std::nullopt : numberIn(text);
}

std::optional<std::int64_t> asInteger(const Json& value) {
  std::int64_t exact = 0;
  if (!value.get(exact)) return exact;
  const auto rounded = asNumber(value);
  if (!rounded || *rounded != std::floor(*rounded) || std::abs(*rounded) > 9e15) return std::nullopt;
  return std::int64_t(*rounded);
}

std::string asText(const Json& value) {
  std::string_view text;
  if (!value.get(text)) return std::string(text);
  if (value.is_number() || value.is_bool()) return simdjson::minify(value);
  return {};
}

std::optional<Eigen::Vector2d> asPoint(const Json& value) {
  JsonList pair;
  std::optional<double> x, y;
  if (!value.get(pair)) {
    auto it = pair.begin();
    if (it == pair.end()) return std::nullopt;
    x = asNumber(*it);
    if (++it == pair.end()) return std::nullopt;
    y = asNumber(*it);
  } else if (const auto inner = member(value, {"pos", "position", "coordinates"})) {
    return asPoint(*inner);
  } else {
    x = number(value, {"x"});
    y = number(value, {"y"});
  }
  if (!x || !y) return std::nullopt;
  return Eigen::Vector2d(*x, *y);
}

std::optional<geometry::Pose2> asPose(const Json& value) {
  const auto xy = asPoint(value);
  if (!xy) return std::nullopt;
  JsonList row;
  double yaw = 0;
  if (!value.get(row)) {
    Json third;
    if (row.size() >= 3 && !row.at(2).get(third)) yaw = asNumber(third).value_or(0);
  } else {
    yaw = number(value, {"ori", "yaw", "theta", "orientation"}).value_or(0);
  }
  return geometry::Pose2{xy->x(), xy->y(), yaw};
}

std::vector<Eigen::Vector2d> asPolyline(const Json& value) {
  std::vector<Eigen::Vector2d> points;
  JsonList rows;
  if (value.get(rows)) return points;
  points.reserve(rows.size());
  for (const Json row : rows) {
    if (const auto xy = asPoint(row)) points.push_back(*xy);
  }
  return points;
}

std::optional<JsonList> asList(const Json& value, Names wrappers) {
  JsonList rows;
  if (!value.get(rows)) return rows;
  auto inner = member(value, wrappers);
  if (!inner) inner = member(value, {"results", "data", "items", "list"});
  // {"data": {"results": [...]}}
  return inner ? asList(*inner, wrappers) : std::nullopt;
}

std::optional<double> number(const Json& object, Names names) {
  const auto value = member(object, names);
  return value ? asNumber(*value) : std::nullopt;
}

std::optional<std::int64_t> integer(const Json& object, Names names) {
  const auto value = member(object, names);
  return value ? asInteger(*value) : std::nullopt;
}

std::optional<int> smallInteger(const Json& object, Names names) {
  const auto value = integer(object, names);
  if (!value || std::abs(double(*value)) > double(std::numeric_limits<int>::max())) return std::nullopt;
  return int(*value);
}

std::optional<bool> flag(const Json& object, Names names) {
  const auto value = member(object, names);
  bool truth = false;
  if (!value) return std::nullopt;
  if (!value->get(truth)) return truth;
  const std::string text = asText(*value);
  if (text == "true" || text == "True") return true;
  if (text == "false" || text == "False") return false;
  const auto as_number = asNumber(*value);
  return as_number ? std::optional(*as_number > 0) : std::nullopt;
}

std::string text(const Json& object, Names names) {
  const auto value = member(object, names);
  return value ? asText(*value) : std::string();
}

std::optional<JsonList> list(const Json& object, Names names) {
  const auto value = member(object, names);
  JsonList rows;
  return value && !value->get(rows) ? std::optional(rows) : std::nullopt;
}

std::vector<Eigen::Vector2d> polyline(const Json& object, Names names) {
  const auto value = member(object, names);
  return value ? asPolyline(*value) : std::vector<Eigen::Vector2d>();
}

std::optional<double> epochSeconds(const Json& object, Names names) {
  const auto value = member(object, names);
  if (!value) return std::nullopt;
  if (const auto seconds = asNumber(*value)) {
    return std::abs(*seconds) > kLatestSeconds ? *seconds / 1000 : *seconds;
  }
  const QDateTime time = QDateTime::fromString(QString::fromStdString(asText(*value)), Qt::ISODateWithMs);
  return time.isValid() ? std::optional(double(time.toMSecsSinceEpoch()) / 1000) : std::nullopt;
}

}  // namespace mapwright::robot::wire
