#include "simulator/http_answer.h"

#include <algorithm>
#include <cmath>

#include <QByteArray>

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

}  // namespace

HttpAnswer jsonAnswer(int status, std::string body) {
  return {.status = status, .body = std::make_shared<const std::string>(std::move(body))};
}

HttpAnswer valueAnswer(int status, const Value& value) { return jsonAnswer(status, toJson(value)); }

HttpAnswer errorAnswer(int status, std::string_view sentence) {
  return valueAnswer(status, Value::Object{{"detail", sentence}});
}

HttpAnswer emptyAnswer(int status) { return {.status = status, .content_type = {}}; }

HttpAnswer bytesFrom(const HttpQuestion& question, std::string bytes, std::string_view tag) {
  HttpAnswer answer;
  answer.content_type = "application/octet-stream";
  constexpr std::string_view kUnit = "bytes=";
  const std::string_view range = question.range;
  const bool asked = range.starts_with(kUnit) && range.ends_with('-') &&
                     (question.if_range.empty() || question.if_range == tag);
  const auto from = asked
                        ? numberFrom<std::size_t>(range.substr(kUnit.size(), range.size() - kUnit.size() - 1))
                        : std::nullopt;
  if (from) {
    std::string range_of("bytes ");
    if (*from >= bytes.size()) {
      answer.status = 416;
      range_of.append("*");
    } else {
      answer.status = 206;
      range_of.append(std::to_string(*from)).append("-").append(std::to_string(bytes.size() - 1));
    }
    range_of.append("/").append(std::to_string(bytes.size()));
    answer.headers.emplace_back("Content-Range", range_of);
    bytes.erase(0, std::min(*from, bytes.size()));
  }
  answer.body = std::make_shared<const std::string>(std::move(bytes));
  return answer;
}

Value ownUrl(std::string_view path) { return "http://192.168.25.25:8090" + std::string(path); }

bool isWordCharacter(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_';
}

std::string percentDecoded(std::string_view text) {
  return QByteArray::fromPercentEncoding({text.data(), static_cast<qsizetype>(text.size())}).toStdString();
}

std::string percentEncoded(const std::string& text) {
  return QByteArray::fromStdString(text).toPercentEncoding().toStdString();
}

std::string_view partOf(std::string_view& rest, char separator) {
  const std::string_view part = rest.substr(0, rest.find(separator));
  rest.remove_prefix(std::min(part.size() + 1, rest.size()));
  return part;
}

std::string_view pathOf(std::string_view target) { return target.substr(0, target.find('?')); }

std::string_view queryValue(std::string_view target, std::string_view key) {
  partOf(target, '?');
  while (!target.empty()) {
    std::string_view value = partOf(target, '&');
    if (partOf(value, '=') == key) return value;
  }
  return {};
}

bool matchesTag(std::string_view if_none_match, std::string_view tag) {
  while (!if_none_match.empty()) {
    std::string_view one = partOf(if_none_match, ',');
    one = one.substr(0, one.find_last_not_of(" \t") + 1);
    one.remove_prefix(std::min(one.find_first_not_of(" \t"), one.size()));
    if (one.starts_with("W/")) one.remove_prefix(2);
    if (one == tag || one == "*") return true;
  }
  return false;
}

HttpAnswer Answerer::answer(const HttpQuestion& question) {
  const Verdict verdict = faults_.decide(kindsOf(question), question.method, question.target);
  HttpAnswer answer = verdict.isDone()                ? answered(question, verdict)
                      : verdict.is(FaultKind::Refuse) ? refused(question, verdict)
                      : verdict.is(FaultKind::Ignore) ? ignored(question)
                                                      : HttpAnswer();
  answer.drop = !verdict.isAnswered();
  answer.truncate = verdict.is(FaultKind::Truncate) && answer.body != nullptr;
  answer.delay_ms = verdict.is(FaultKind::Silence) ? FaultPlan::kLongestDelayMs : verdict.delay_ms;
  return answer;
}

std::optional<RequestFields> RequestFields::read(std::string_view content_type, std::string_view body) {
  if (content_type.starts_with("multipart/form-data"))
    return readForm(parameterOf(content_type, "boundary"), body);
  RequestFields fields;
  fields.values_ = fromJson(body).value_or(Value());
  return fields.values_.as<Value::Object>() != nullptr ? std::optional(std::move(fields)) : std::nullopt;
}

std::optional<RequestFields> RequestFields::readForm(std::string_view boundary, std::string_view body) {
  if (boundary.empty()) return std::nullopt;
  const std::string mark = "--" + std::string(boundary);
  RequestFields fields;
  fields.is_form_ = true;
  std::size_t at = body.find(mark), parts = 0;
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
    if (name.empty() || ++parts > kMostParts) return std::nullopt;
    const std::size_t from = head_end + 4;
    fields.values_.set(name, next > from ? body.substr(from, next - from) : std::string_view());
    at = next + 2;
  }
  return std::nullopt;
}

std::optional<std::string> RequestFields::text(std::string_view key) const {
  const auto* text = values_[key].as<std::string>();
  return text == nullptr ? std::nullopt : std::optional(*text);
}

std::optional<double> RequestFields::number(std::string_view key) const {
  const Value& value = values_[key];
  std::optional<double> number;
  if (value.isNumber()) number = value.number();
  if (const auto* text = value.as<std::string>(); text != nullptr && is_form_)
    number = numberFrom<double>(*text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<std::int64_t> RequestFields::integer(std::string_view key) const {
  const Value& value = values_[key];
  if (const auto* whole = value.as<std::int64_t>()) return *whole;
  const auto* text = value.as<std::string>();
  return text != nullptr && is_form_ ? numberFrom<std::int64_t>(*text) : std::nullopt;
}

std::optional<bool> RequestFields::flag(std::string_view key, std::optional<bool> otherwise) const {
  const Value& value = values_[key];
  if (value.isNull()) return otherwise;
  if (const auto* flag = value.as<bool>()) return *flag;
  if (!is_form_ || (value.text() != "true" && value.text() != "false")) return std::nullopt;
  return value.text() == "true";
}

std::optional<std::vector<double>> RequestFields::numbers(std::string_view key) const {
  const auto* list = values_[key].as<Value::List>();
  if (list == nullptr ||
      !std::all_of(list->begin(), list->end(), [](const Value& one) { return one.isNumber(); }))
    return std::nullopt;
  std::vector<double> numbers;
  for (const Value& one : *list) numbers.push_back(one.number());
  return numbers;
}

}  // namespace mapwright::simulator
