#include "series/fields.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include <simdjson.h>

namespace mapwright::series {
namespace {

bool isPlain(std::string_view name) {
  return !name.empty() && std::none_of(name.begin(), name.end(), [](char c) {
    return std::string_view(".[]\"\\").find(c) != std::string_view::npos || (c >= 0 && c <= ' ');
  });
}

std::string inQuotes(std::string_view name) {
  std::string out = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

/// Takes a text in quotes from the front of `rest`.
std::optional<std::string> readQuoted(std::string_view& rest) {
  std::string out;
  for (std::size_t i = 1; i < rest.size(); ++i) {
    if (rest[i] == '"') {
      rest.remove_prefix(i + 1);
      return out;
    }
    if (rest[i] == '\\' && ++i >= rest.size()) break;
    out += rest[i];
  }
  return std::nullopt;
}

std::string readPlain(std::string_view& rest) {
  const std::size_t end = std::min(rest.find_first_of(".["), rest.size());
  std::string out(rest.substr(0, end));
  rest.remove_prefix(end);
  return out;
}

std::optional<FieldPath::Step> readStep(std::string_view& rest) {
  if (rest.front() == '.') {
    rest.remove_prefix(1);
    std::string name = readPlain(rest);
    if (!isPlain(name)) return std::nullopt;
    return name;
  }
  rest.remove_prefix(1);  // "["
  FieldPath::Step step;
  if (!rest.empty() && rest.front() == '"') {
    auto name = readQuoted(rest);
    if (!name) return std::nullopt;
    step = std::move(*name);
  } else {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), index);
    if (error != std::errc()) return std::nullopt;
    rest.remove_prefix(std::size_t(end - rest.data()));
    step = index;
  }
  if (rest.empty() || rest.front() != ']') return std::nullopt;
  rest.remove_prefix(1);
  return step;
}

using simdjson::dom::element;
using simdjson::dom::element_type;

constexpr std::size_t kDeepest = 8, kElements = 16;
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

std::optional<double> numberIn(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || text.size() > 100) return std::nullopt;
  text = text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
  if (text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end != text.data() + text.size() || error == std::errc::invalid_argument) return std::nullopt;
  return error == std::errc() && std::isfinite(value) ? value : kNoNumber;
}

std::optional<double> numberOf(const element& value) {
  switch (value.type()) {
    case element_type::DOUBLE:
    case element_type::INT64:
    case element_type::UINT64: {
      const double number = value.get_double().value_unsafe();
      return std::isfinite(number) ? number : kNoNumber;
    }
    case element_type::BOOL:
      return value.get_bool().value_unsafe() ? 1 : 0;
    case element_type::STRING:
      return numberIn(value.get_string().value_unsafe());
    case element_type::NULL_VALUE:
      return kNoNumber;
    default:
      return std::nullopt;
  }
}

std::optional<double> numberAt(element value, const std::vector<FieldPath::Step>& steps) {
  for (const FieldPath::Step& step : steps) {
    if (const auto* index = std::get_if<std::size_t>(&step)) {
      simdjson::dom::array array;
      if (value.get_array().get(array) || array.at(*index).get(value)) return std::nullopt;
    } else {
      simdjson::dom::object object;
      if (value.get_object().get(object) || object.at_key(std::get<std::string>(step)).get(value))
        return std::nullopt;
    }
  }
  return numberOf(value);
}

void addFields(std::vector<FieldPath>& found, FieldPath& path, const element& value, std::size_t most) {
  if (found.size() >= most || path.steps.size() > kDeepest) return;
  simdjson::dom::object object;
  simdjson::dom::array array;
  if (!value.get_object().get(object)) {
    for (const auto& member : object) {
      path.steps.emplace_back(std::string(member.key));
      addFields(found, path, member.value, most);
      path.steps.pop_back();
    }
  } else if (!value.get_array().get(array)) {
    std::size_t index = 0;
    for (const element each : array) {
      if (index >= kElements) break;
      path.steps.emplace_back(index++);
      addFields(found, path, each, most);
      path.steps.pop_back();
    }
  } else if (value.is_number() || value.is_bool()) {
    found.push_back(path);
  }
}

}  // namespace

std::optional<FieldPath> FieldPath::parse(std::string_view text) {
  if (text.empty() || text.size() > kLongest) return std::nullopt;
  FieldPath path;
  if (text.front() == '"') {
    auto topic = readQuoted(text);
    if (!topic || topic->empty()) return std::nullopt;
    path.topic = std::move(*topic);
  } else {
    path.topic = readPlain(text);
    if (!isPlain(path.topic)) return std::nullopt;
  }
  while (!text.empty()) {
    if (path.steps.size() >= kMostSteps || (text.front() != '.' && text.front() != '[')) return std::nullopt;
    auto step = readStep(text);
    if (!step) return std::nullopt;
    path.steps.push_back(std::move(*step));
  }
  if (path.steps.empty()) return std::nullopt;
  return path;
}

std::string FieldPath::textOfSteps() const {
  std::string out;
  for (const Step& step : steps) {
    if (const auto* index = std::get_if<std::size_t>(&step)) {
      out += '[' + std::to_string(*index) + ']';
    } else if (const auto& name = std::get<std::string>(step); isPlain(name)) {
      out += (out.empty() ? "" : ".") + name;
    } else {
      out += '[' + inQuotes(name) + ']';
    }
  }
  return out;
}

std::string FieldPath::text() const {
  const std::string rest = textOfSteps();
  const bool joined = rest.empty() || rest.front() == '[';
  return (isPlain(topic) ? topic : inQuotes(topic)) + (joined ? "" : ".") + rest;
}

struct FieldReader::Parsing {
  simdjson::dom::parser parser;
};

FieldReader::FieldReader(std::vector<FieldPath> paths)
    : paths_(std::move(paths)), values_(paths_.size()), parsing_(std::make_unique<Parsing>()) {}
FieldReader::~FieldReader() = default;
FieldReader::FieldReader(FieldReader&&) noexcept = default;

bool FieldReader::wants(std::string_view topic) const {
  return std::any_of(paths_.begin(), paths_.end(),
                     [&](const FieldPath& path) { return path.topic == topic; });
}

const std::vector<std::optional<double>>& FieldReader::read(std::string_view topic, std::string_view json) {
  std::fill(values_.begin(), values_.end(), std::nullopt);
  element message;
  if (!wants(topic) || parsing_->parser.parse(json.data(), json.size()).get(message)) return values_;
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    if (paths_[i].topic == topic) values_[i] = numberAt(message, paths_[i].steps);
  }
  return values_;
}

std::vector<FieldPath> numericFields(const std::string& topic, std::string_view json, std::size_t most) {
  simdjson::dom::parser parser;
  element message;
  std::vector<FieldPath> found;
  if (parser.parse(json.data(), json.size()).get(message) || !message.is_object()) return found;
  FieldPath path{topic, {}};
  addFields(found, path, message, most);
  return found;
}

std::optional<double> valueOf(Quantity quantity, const geometry::Pose2& pose) {
  switch (quantity) {
    case Quantity::X:
      return pose.x_m;
    case Quantity::Y:
      return pose.y_m;
    case Quantity::Yaw:
      return geometry::degreesFromRadians(geometry::normalizeAngle(pose.yaw_rad));
    default:
      return std::nullopt;
  }
}

std::optional<double> valueOf(Quantity quantity, const map::TopicMessage& message) {
  if (const auto* tracked = std::get_if<map::TrackedPose>(&message)) return valueOf(quantity, tracked->pose);
  if (const auto* slam = std::get_if<map::SlamStatus>(&message)) {
    if (quantity == Quantity::MatchingScore) return slam->lidar_matching_score;
    if (quantity == Quantity::PositionQuality && slam->position_quality)
      return double(*slam->position_quality);
  }
  if (const auto* battery = std::get_if<map::BatteryState>(&message)) {
    if (quantity == Quantity::Battery && battery->level) return *battery->level * 100;
  }
  return std::nullopt;
}

bool isOfPose(Quantity quantity) {
  return quantity == Quantity::X || quantity == Quantity::Y || quantity == Quantity::Yaw ||
         quantity == Quantity::Speed;
}

bool isStepped(Quantity quantity) { return quantity == Quantity::PositionQuality; }

}  // namespace mapwright::series
