#include "robot/wire/repair_json.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace mapwright::robot::wire {
namespace {

constexpr std::size_t kExactDigits = 15;  // a double holds every whole number of so many digits

bool startsToken(char c) {
  return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == 'N' || c == 'n' || c == 'I' || c == 'i';
}

bool inToken(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '+' ||
         c == '.';
}

bool unreadable(const std::string& token) {
  if (token == "null") return false;
  char* end = nullptr;
  const double value = std::strtod(token.c_str(), &end);
  if (end != token.c_str() + token.size())
    return false;  // not a number at all: left for the parser to refuse
  if (!std::isfinite(value)) return true;
  const bool whole = token.find_first_of(".eE") == std::string::npos;
  return whole && token.size() > 18;
}

bool isLongNumber(const std::string& token) {
  const std::size_t first = token.find_first_not_of('-');
  return first <= 1 && token.size() - first > kExactDigits &&
         token.find_first_not_of("0123456789", first) == std::string::npos;
}

/// Hands every token outside of strings to `replace`, which appends what is to stand there.
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
      replace(std::string(text.substr(i, end - i)), rewritten);
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
  return rewriteTokens(text, [](const std::string& token, std::string& out) {
    out += unreadable(token) ? std::string_view("null") : std::string_view(token);
  });
}

std::string quoteLongNumbers(std::string_view text) {
  return rewriteTokens(text, [](const std::string& token, std::string& out) {
    out += isLongNumber(token) ? '"' + token + '"' : token;
  });
}

}  // namespace mapwright::robot::wire
