#include "net/json_numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace mapwright::net {
namespace {

constexpr std::size_t kExactDigits = 15;  // a double holds every integer of so many digits

bool startsToken(char c) {
  return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == 'N' || c == 'n' || c == 'I' || c == 'i';
}

bool inToken(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '+' ||
         c == '.';
}

template <typename Number>
bool holds(std::string_view token) {
  Number value{};
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  return stop == end && error == std::errc();
}

bool unreadable(std::string_view token) {
  const std::string_view digits = token.starts_with('+') ? token.substr(1) : token;
  double value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (stop != end) return false;  // not a number at all: the parser will reject it
  const bool tiny =
      digits.find("e-") != std::string_view::npos || digits.find("E-") != std::string_view::npos;
  if (error != std::errc()) return !tiny;
  const bool whole = digits.find_first_of(".eE") == std::string_view::npos;
  return !std::isfinite(value) || (whole && !holds<std::int64_t>(digits) && !holds<std::uint64_t>(digits));
}

bool isLongNumber(std::string_view token) {
  const std::size_t first = token.find_first_not_of('-');
  return first <= 1 && token.size() - first > kExactDigits &&
         token.find_first_not_of("0123456789", first) == std::string_view::npos;
}

/// Passes every token outside of strings to `replace`, which appends the replacement.
template <typename Replace>
std::string rewriteTokens(std::string_view text, Replace replace) {
  std::string rewritten;
  rewritten.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"') {
      std::size_t end = i + 1;
      while (end < text.size() && text[end] != '"') end += text[end] == '\\' ? 2 : 1;
      end = std::min(end + 1, text.size());
      rewritten.append(text.substr(i, end - i));
      i = end;
    } else if (startsToken(c)) {
      std::size_t end = i;
      while (end < text.size() && inToken(text[end])) ++end;
      replace(text.substr(i, end - i), rewritten);
      i = end;
    } else {
      rewritten += c;
      ++i;
    }
  }
  return rewritten;
}

}  // namespace

std::string repairNumbers(std::string_view text) {
  return rewriteTokens(text, [](std::string_view token, std::string& out) {
    out += unreadable(token) ? std::string_view("null") : token;
  });
}

std::string quoteLongNumbers(std::string_view text) {
  return rewriteTokens(text, [](std::string_view token, std::string& out) {
    if (isLongNumber(token)) {
      out.append("\"").append(token).append("\"");
    } else {
      out += token;
    }
  });
}

}  // namespace mapwright::net
