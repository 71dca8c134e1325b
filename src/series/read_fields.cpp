#include "series/read_fields.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include <simdjson.h>

namespace mapwright::series {
namespace {

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

}  // namespace mapwright::series
