#include "robot/axbot/plain_messages.h"

#include <cmath>
#include <cstring>

#include "robot/axbot/parse_clouds.h"

namespace mapwright::robot::axbot {
namespace {

constexpr double kLatestSeconds = 1e11;  // as in wire::epochSeconds(): larger values are milliseconds
constexpr std::string_view kStamp = "\"__stamp\"";

enum class Member { Topic, Recorded, Robots, Latched, Position, Heading, Points, Other };

Member memberOf(std::string_view key) {
  if (key == "topic") return Member::Topic;
  if (key == "__stamp") return Member::Recorded;
  if (key == "__latched") return Member::Latched;
  if (key == "stamp") return Member::Robots;
  if (key == "pos") return Member::Position;
  if (key == "ori") return Member::Heading;
  if (key == "points") return Member::Points;
  return Member::Other;
}

/// [x, y, …]: the count of numbers, of which the first `room` are stored; only numbers.
bool addRow(JsonCursor& json, double* numbers, std::size_t room, std::size_t& count) {
  count = 0;
  if (!json.consume('[')) return false;
  if (json.peek() == ']') return json.consume(']');
  double beyond = 0;
  do {
    if (!json.readNumber(count < room ? numbers[count] : beyond)) return false;
    ++count;
  } while (json.consume(','));
  return json.consume(']');
}

bool readPosition(JsonCursor& json, geometry::Pose2& pose) {
  double numbers[2] = {0, 0};
  std::size_t count = 0;
  if (!addRow(json, numbers, 2, count)) return false;
  pose.x_m = numbers[0];
  pose.y_m = numbers[1];
  return count >= 2;
}

bool readPoints(JsonCursor& json, CloudPoints& cloud) {
  if (!json.consume('[')) return false;
  if (json.peek() == ']') return json.consume(']');
  do {
    double numbers[4] = {std::nan(""), std::nan(""), 0, 0};
    std::size_t count = 0;
    if (!addRow(json, numbers, 4, count) || cloud.full()) return false;
    cloud.add(numbers[0], numbers[1], numbers[2], numbers[3]);
  } while (json.consume(','));
  return json.consume(']');
}

/// The topic of a message that begins with it.
bool readTopic(JsonCursor& json, std::string_view& topic) {
  std::string_view key;
  return json.consume('{') && json.readString(key) && key == "topic" && json.consume(':') &&
         json.readString(topic);
}

}  // namespace

const char* PlainMessages::read(const char* at, BagMessage& message) {
  JsonCursor json(at);
  std::string_view topic;
  if (!readTopic(json, topic)) return nullptr;
  message.message.topic = topic;
  const bool is_pose = topic == "/tracked_pose";
  if (!is_pose && !isCloudTopic(message.message.topic)) return nullptr;
  geometry::Pose2 pose;
  CloudPoints cloud;
  if (!is_pose) cloud.reserve(last_count_);
  unsigned seen = 1u << unsigned(Member::Topic);
  while (json.consume(',')) {
    std::string_view key;
    if (!json.readString(key) || !json.consume(':')) return nullptr;
    Member member = memberOf(key);
    if (member == (is_pose ? Member::Points : Member::Position)) member = Member::Other;
    if (!is_pose && member == Member::Heading) member = Member::Other;
    // Of duplicate names the first counts.
    const unsigned bit = 1u << unsigned(member);
    if (member != Member::Other && (seen & bit) != 0) return nullptr;
    seen |= bit;
    bool read = false;
    switch (member) {
      case Member::Recorded:
        read = json.readNumber(message.message.received_s);
        break;
      case Member::Robots: {
        double stamp = 0;
        read = json.readNumber(stamp);
        message.message.recorded_s = std::abs(stamp) > kLatestSeconds ? stamp / 1000 : stamp;
        break;
      }
      case Member::Latched:
        read = json.readBoolean(message.latched);
        break;
      case Member::Position:
        read = readPosition(json, pose);
        break;
      case Member::Heading:
        read = json.readNumber(pose.yaw_rad);
        break;
      case Member::Points:
        read = readPoints(json, cloud);
        break;
      case Member::Topic:
      case Member::Other:
        read = json.readScalar();
        break;
    }
    if (!read) return nullptr;
  }
  json.skipSpace();
  if (json.peek() != '}') return nullptr;
  const auto has = [&](Member member) { return (seen & (1u << unsigned(member))) != 0; };
  if (!has(Member::Recorded)) return nullptr;
  if (is_pose && has(Member::Position) && has(Member::Heading)) {
    message.message.message = map::TrackedPose{pose};
  } else if (!is_pose && has(Member::Points)) {
    last_count_ = cloud.count();
    message.message.message = cloud.message(message.message.topic);
  } else {
    return nullptr;
  }
  message.known = true;
  return json.at() + 1;
}

void PlainMessages::remember(std::string_view json, const BagMessage& message, std::size_t index) {
  JsonCursor topic_of(json.data());
  std::string_view topic;
  if (!readTopic(topic_of, topic) || topic != message.message.topic) return;
  said_.erase(topic);
  // The stamp must be the message's own, not a nested one: only the end of the message, or one more member,
  // may follow.
  const std::size_t stamp = json.rfind(kStamp);
  if (stamp == std::string_view::npos || json.find(kStamp) != stamp) return;
  JsonCursor number(json.data() + stamp + kStamp.size());
  if (!number.consume(':')) return;
  const std::string_view before = json.substr(0, std::size_t(number.at() - json.data()));
  double stamp_s = 0;
  if (!number.readNumber(stamp_s) || stamp_s != message.message.received_s) return;
  const std::string_view behind = json.substr(std::size_t(number.at() - json.data()));
  const bool own = behind == "}" || behind == ",\"__latched\":false}" || behind == ",\"__latched\":true}";
  if (own) said_.emplace(topic, Said{before, behind, index});
}

const char* PlainMessages::readAgain(const char* at, std::size_t& of, double& stamp_s) const {
  JsonCursor json(at);
  std::string_view topic;
  if (!readTopic(json, topic)) return nullptr;
  const auto said = said_.find(topic);
  if (said == said_.end()) return nullptr;
  JsonCursor again(at);
  if (!again.readText(said->second.before) || !again.readNumber(stamp_s) ||
      !again.readText(said->second.behind))
    return nullptr;
  of = said->second.index;
  return again.at();
}

bool JsonCursor::readLongNumber(double& number) {
  constexpr std::ptrdiff_t kMostWholeDigits = 18;
  const char* const begin = at_;
  if (*at_ == '-') ++at_;
  const auto readDigits = [&] {
    const char* const first = at_;
    while (isDigit(*at_)) ++at_;
    return at_ > first;
  };
  if (!readDigits()) return false;
  bool whole = true;
  if (*at_ == '.') {
    whole = false;
    ++at_;
    if (!readDigits()) return false;
  }
  if (*at_ == 'e' || *at_ == 'E') {
    whole = false;
    ++at_;
    if (*at_ == '+' || *at_ == '-') ++at_;
    if (!readDigits()) return false;
  }
  if (whole && at_ - begin > kMostWholeDigits) return false;
  const auto [end, error] = std::from_chars(begin, at_, number);
  return error == std::errc() && end == at_;
}

bool JsonCursor::readScalar() {
  std::string_view text;
  double number = 0;
  switch (*at_) {
    case '"':
      return readString(text);
    case 't':
      return readText("true");
    case 'f':
      return readText("false");
    case 'n':
      return readText("null");
    default:
      return readNumber(number);
  }
}

const char* endOfNested(const char* at, const char* end) {
  std::size_t depth = 0;
  for (; at < end; ++at) {
    switch (*at) {
      case '"':
        // To the quote that is not escaped.
        for (++at; at < end && *at != '"'; ++at) {
          if (*at == '\\') ++at;
        }
        break;
      case '{':
      case '[':
        ++depth;
        break;
      case '}':
      case ']':
        if (depth <= 1) return depth == 1 ? at + 1 : nullptr;
        --depth;
        break;
      default:
        break;
    }
  }
  return nullptr;
}

}  // namespace mapwright::robot::axbot
