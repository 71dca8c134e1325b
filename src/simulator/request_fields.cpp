#include "simulator/request_fields.h"

#include <cmath>

#include <simdjson.h>

#include "simulator/whole_text.h"

namespace mapwright::simulator {
namespace {

constexpr std::size_t kMostParts = 64;

/// The value of `key` in a header field such as: form-data; name="map_name"; filename="a.png".
std::string_view parameterOf(std::string_view field, std::string_view key) {
  std::size_t at = 0;
  while ((at = field.find(';', at)) != std::string_view::npos) {
    ++at;
    while (at < field.size() && field[at] == ' ') ++at;
    std::string_view rest = field.substr(at);
    if (!rest.starts_with(key) || rest.size() <= key.size() || rest[key.size()] != '=') continue;
    rest.remove_prefix(key.size() + 1);
    if (!rest.starts_with('"')) return rest.substr(0, rest.find_first_of("; \r\n"));
    rest.remove_prefix(1);
    return rest.substr(0, rest.find('"'));
  }
  return {};
}

std::optional<std::vector<double>> numbersOf(simdjson::dom::array list) {
  std::vector<double> numbers;
  for (const simdjson::dom::element one : list) {
    double number = 0;
    if (one.get(number) != simdjson::SUCCESS) return std::nullopt;
    numbers.push_back(number);
  }
  return numbers;
}

}  // namespace

std::optional<RequestFields> RequestFields::read(std::string_view content_type, std::string_view body) {
  if (content_type.starts_with("multipart/form-data"))
    return readForm(parameterOf(content_type, "boundary"), body);
  return readJson(body);
}

std::optional<RequestFields> RequestFields::readJson(std::string_view body) {
  simdjson::dom::parser parser;
  simdjson::dom::object object;
  if (parser.parse(body.data(), body.size()).get(object) != simdjson::SUCCESS) return std::nullopt;
  RequestFields fields;
  for (const auto [key, element] : object) {
    Value value;
    simdjson::dom::array list;
    if (std::string_view text; element.get(text) == simdjson::SUCCESS) {
      value = std::string(text);
    } else if (bool flag = false; element.get(flag) == simdjson::SUCCESS) {
      value = flag;
    } else if (std::int64_t integer = 0; element.get(integer) == simdjson::SUCCESS) {
      value = integer;
    } else if (double number = 0; element.get(number) == simdjson::SUCCESS) {
      value = number;
    } else if (element.is_null()) {
      continue;
    } else if (element.get(list) == simdjson::SUCCESS) {
      if (auto numbers = numbersOf(list)) value = std::move(*numbers);
    }
    fields.values_.insert_or_assign(std::string(key), std::move(value));
  }
  return fields;
}

std::optional<RequestFields> RequestFields::readForm(std::string_view boundary, std::string_view body) {
  if (boundary.empty()) return std::nullopt;
  const std::string mark = "--" + std::string(boundary);
  RequestFields fields;
  fields.is_form_ = true;
  std::size_t at = body.find(mark);
  while (at != std::string_view::npos) {
    at += mark.size();
    if (body.substr(at, 2) == "--") return fields;
    const std::size_t head_end = body.find("\r\n\r\n", at);
    const std::size_t next = body.find("\r\n" + mark, at);
    if (head_end == std::string_view::npos || next == std::string_view::npos || head_end + 4 > next + 2)
      return std::nullopt;
    const std::string_view head = body.substr(at, head_end - at);
    const std::size_t disposition = head.find("form-data");
    const std::string_view name = disposition == std::string_view::npos
                                      ? std::string_view()
                                      : parameterOf(head.substr(disposition), "name");
    if (name.empty() || fields.values_.size() >= kMostParts) return std::nullopt;
    const std::size_t from = head_end + 4;
    fields.values_.insert_or_assign(
        std::string(name), std::string(next > from ? body.substr(from, next - from) : std::string_view()));
    at = next + 2;
  }
  return std::nullopt;
}

const RequestFields::Value* RequestFields::find(std::string_view key) const {
  const auto found = values_.find(key);
  return found == values_.end() ? nullptr : &found->second;
}

bool RequestFields::has(std::string_view key) const { return find(key) != nullptr; }

std::optional<std::string> RequestFields::text(std::string_view key) const {
  const Value* value = find(key);
  const auto* text = value == nullptr ? nullptr : std::get_if<std::string>(value);
  return text == nullptr ? std::nullopt : std::optional(*text);
}

std::optional<double> RequestFields::number(std::string_view key) const {
  const Value* value = find(key);
  std::optional<double> number;
  if (value == nullptr) return number;
  if (const auto* real = std::get_if<double>(value)) number = *real;
  if (const auto* whole = std::get_if<std::int64_t>(value)) number = static_cast<double>(*whole);
  if (const auto* text = std::get_if<std::string>(value); text != nullptr && is_form_)
    number = numberFrom<double>(*text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<std::int64_t> RequestFields::integer(std::string_view key) const {
  const Value* value = find(key);
  if (value == nullptr) return std::nullopt;
  if (const auto* whole = std::get_if<std::int64_t>(value)) return *whole;
  const auto* text = std::get_if<std::string>(value);
  return text != nullptr && is_form_ ? numberFrom<std::int64_t>(*text) : std::nullopt;
}

std::optional<bool> RequestFields::flag(std::string_view key) const {
  const Value* value = find(key);
  if (value == nullptr) return std::nullopt;
  if (const auto* flag = std::get_if<bool>(value)) return *flag;
  const auto* text = std::get_if<std::string>(value);
  if (text == nullptr || !is_form_ || (*text != "true" && *text != "false")) return std::nullopt;
  return *text == "true";
}

std::optional<std::vector<double>> RequestFields::numbers(std::string_view key) const {
  const Value* value = find(key);
  const auto* list = value == nullptr ? nullptr : std::get_if<std::vector<double>>(value);
  return list == nullptr ? std::nullopt : std::optional(*list);
}

}  // namespace mapwright::simulator
