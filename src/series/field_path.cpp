#include "series/field_path.h"

#include <algorithm>
#include <charconv>

namespace mapwright::series {
namespace {

bool isPlain(std::string_view name) {
  return !name.empty() && std::none_of(name.begin(), name.end(), [](char c) {
    return std::string_view(".[]\"\\").find(c) != std::string_view::npos || (c >= 0 && c <= ' ');
  });
}

std::string quoted(std::string_view name) {
  std::string out = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

/// Takes a text in quotes from the front of `rest`.
std::optional<std::string> takeQuoted(std::string_view& rest) {
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

std::string takePlain(std::string_view& rest) {
  const std::size_t end = std::min(rest.find_first_of(".["), rest.size());
  std::string out(rest.substr(0, end));
  rest.remove_prefix(end);
  return out;
}

std::optional<FieldPath::Step> takeStep(std::string_view& rest) {
  if (rest.front() == '.') {
    rest.remove_prefix(1);
    std::string name = takePlain(rest);
    if (!isPlain(name)) return std::nullopt;
    return name;
  }
  rest.remove_prefix(1);  // "["
  FieldPath::Step step;
  if (!rest.empty() && rest.front() == '"') {
    auto name = takeQuoted(rest);
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

}  // namespace

std::optional<FieldPath> FieldPath::parse(std::string_view text) {
  if (text.empty() || text.size() > kLongest) return std::nullopt;
  FieldPath path;
  if (text.front() == '"') {
    auto topic = takeQuoted(text);
    if (!topic || topic->empty()) return std::nullopt;
    path.topic = std::move(*topic);
  } else {
    path.topic = takePlain(text);
    if (!isPlain(path.topic)) return std::nullopt;
  }
  while (!text.empty()) {
    if (path.steps.size() >= kMostSteps || (text.front() != '.' && text.front() != '[')) return std::nullopt;
    auto step = takeStep(text);
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
      out += '[' + quoted(name) + ']';
    }
  }
  return out;
}

std::string FieldPath::text() const {
  const std::string rest = textOfSteps();
  const bool joined = rest.empty() || rest.front() == '[';
  return (isPlain(topic) ? topic : quoted(topic)) + (joined ? "" : ".") + rest;
}

}  // namespace mapwright::series
