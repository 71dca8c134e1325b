#include "robot/axbot/plain_messages.h"

#include <cmath>
#include <optional>
#include <string_view>

#include "robot/axbot/cloud_points.h"
#include "robot/axbot/topic_subjects.h"

namespace mapwright::robot::axbot {
namespace {

namespace ondemand = simdjson::ondemand;

constexpr double kLatestSeconds = 1e11;  // as in wire::epochSeconds(): beyond it, it is milliseconds

enum class Member { Topic, Recorded, Robots, Latched, Position, Heading, Points, Other, Odd };

/// Keys are compared as they are written: one with an escape in it may be any.
Member memberOf(ondemand::raw_json_string key) {
  const auto is = [&](std::string_view name) { return key.unsafe_is_equal(name); };
  switch (key.raw()[0]) {
    case 't':
      if (is("topic")) return Member::Topic;
      break;
    case '_':
      if (is("__stamp")) return Member::Recorded;
      if (is("__latched")) return Member::Latched;
      break;
    case 's':
      if (is("stamp")) return Member::Robots;
      break;
    case 'p':
      if (is("pos")) return Member::Position;
      if (is("points")) return Member::Points;
      break;
    case 'o':
      if (is("ori")) return Member::Heading;
      break;
    default:
      break;
  }
  for (const char* at = key.raw(); *at != '"'; ++at) {
    if (*at == '\\') return Member::Odd;
  }
  return Member::Other;
}

/// A string without escapes; the topic of all messages that are read here.
std::optional<std::string_view> plainText(ondemand::value value) {
  std::string_view token = value.raw_json_token();
  if (!token.starts_with('"')) return std::nullopt;
  token.remove_prefix(1);
  const std::size_t end = token.rfind('"');
  if (end == std::string_view::npos) return std::nullopt;
  token = token.substr(0, end);
  return token.find('\\') == std::string_view::npos ? std::optional(token) : std::nullopt;
}

/// Numbers of a few digits, as robots write positions, are what they are as a whole number by a power of ten:
/// both are doubles, so the quotient is the double next to what is written. nullopt: not that short.
std::optional<double> shortNumber(const char* at) {
  constexpr double kPowers[] = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14};
  constexpr int kMostDigits = 14;
  const bool negative = *at == '-';
  at += negative;
  const char* const start = at;
  std::int64_t whole = 0;
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  const auto take = [&] {
    const char* const first = at;
    for (; isDigit(*at) && at - start <= kMostDigits; ++at) whole = whole * 10 + (*at - '0');
    return int(at - first);
  };
  const int before = take();
  if (before == 0 || (before > 1 && *start == '0')) return std::nullopt;
  int after = 0;
  if (*at == '.') {
    ++at;
    after = take();
    if (after == 0) return std::nullopt;
  }
  const bool ends = *at == ',' || *at == ']' || *at == '}' || *at == ' ' || *at == '\n';
  if (!ends || before + after > kMostDigits) return std::nullopt;
  const double size = after == 0 ? double(whole) : double(whole) / kPowers[after];
  return negative ? -size : size;
}

bool number(ondemand::value value, double& out) {
  const std::string_view token = value.raw_json_token();
  if (const auto quick = shortNumber(token.data())) {
    out = *quick;
    return true;
  }
  // Whole numbers beyond any type count as null.
  constexpr std::size_t kDigits = 18;
  if (token.size() > kDigits && token.find_first_of(".eE") == std::string_view::npos) return false;
  return !value.get_double().get(out);
}

bool position(ondemand::value value, geometry::Pose2& pose) {
  ondemand::array row;
  if (value.get_array().get(row)) return false;
  double numbers[2] = {0, 0};
  std::size_t count = 0;
  for (auto each : row) {
    ondemand::value one;
    if (each.get(one)) return false;
    if (count < 2 && !number(one, numbers[count])) return false;
    ++count;
  }
  pose.x_m = numbers[0];
  pose.y_m = numbers[1];
  return count >= 2;
}

bool points(ondemand::value value, CloudPoints& cloud) {
  ondemand::array rows;
  if (value.get_array().get(rows)) return false;
  for (auto each : rows) {
    ondemand::array row;
    if (each.get_array().get(row)) return false;
    double numbers[4] = {std::nan(""), std::nan(""), 0, 0};
    std::size_t count = 0;
    for (auto cell : row) {
      ondemand::value one;
      if (cell.get(one)) return false;
      if (count < 4 && !number(one, numbers[count])) return false;
      ++count;
    }
    if (cloud.full()) return false;
    cloud.add(numbers[0], numbers[1], numbers[2], numbers[3]);
  }
  return true;
}

}  // namespace

bool PlainMessages::read(ondemand::object& object, BagMessage& message) {
  enum class Kind { None, Pose, Cloud };
  Kind kind = Kind::None;
  geometry::Pose2 pose;
  CloudPoints cloud;
  unsigned seen = 0;
  for (auto field : object) {
    ondemand::raw_json_string key;
    ondemand::value value;
    if (field.key().get(key) || field.value().get(value)) return false;
    const Member member = memberOf(key);
    if (member == Member::Odd) return false;
    if (member == Member::Other) continue;
    // Of two of the same name the first counts.
    const unsigned bit = 1u << unsigned(member);
    if ((seen & bit) != 0) return false;
    seen |= bit;
    // Which members matter, and how, the topic says: it comes first.
    if (kind == Kind::None && member != Member::Topic) return false;
    switch (member) {
      case Member::Topic: {
        const auto topic = plainText(value);
        if (!topic) return false;
        message.message.topic = *topic;
        kind = *topic == "/tracked_pose"             ? Kind::Pose
               : isCloudTopic(message.message.topic) ? Kind::Cloud
                                                     : Kind::None;
        if (kind == Kind::None) return false;
        if (kind == Kind::Cloud) cloud.reserve(last_count_);
        break;
      }
      case Member::Recorded:
        if (!number(value, message.message.received_s)) return false;
        break;
      case Member::Robots: {
        double stamp = 0;
        if (!number(value, stamp)) return false;
        message.message.recorded_s = std::abs(stamp) > kLatestSeconds ? stamp / 1000 : stamp;
        break;
      }
      case Member::Latched:
        if (value.get_bool().get(message.latched)) return false;
        break;
      case Member::Position:
        if (kind == Kind::Pose && !position(value, pose)) return false;
        break;
      case Member::Heading:
        if (kind == Kind::Pose && !number(value, pose.yaw_rad)) return false;
        break;
      case Member::Points:
        if (kind == Kind::Cloud && !points(value, cloud)) return false;
        break;
      case Member::Other:
      case Member::Odd:
        break;
    }
  }
  const auto has = [&](Member member) { return (seen & (1u << unsigned(member))) != 0; };
  if (!has(Member::Recorded)) return false;
  if (kind == Kind::Pose && has(Member::Position) && has(Member::Heading)) {
    message.message.message = map::TrackedPose{pose};
  } else if (kind == Kind::Cloud && has(Member::Points)) {
    last_count_ = cloud.count();
    message.message.message = cloud.message(message.message.topic);
  } else {
    return false;
  }
  message.known = true;
  return true;
}

}  // namespace mapwright::robot::axbot
