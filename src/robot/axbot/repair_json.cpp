#include "robot/axbot/repair_json.h"

#include <cmath>
#include <cstdlib>

namespace mapwright::robot::axbot {
namespace {

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

}  // namespace

std::string repairNumbers(std::string_view text) {
  std::string repaired;
  repaired.reserve(text.size());
  bool in_string = false;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (in_string) {
      repaired += c;
      if (c == '\\' && i + 1 < text.size()) repaired += text[++i];
      if (c == '"') in_string = false;
      ++i;
    } else if (startsToken(c)) {
      std::size_t end = i;
      while (end < text.size() && inToken(text[end])) ++end;
      const std::string token(text.substr(i, end - i));
      repaired += unreadable(token) ? "null" : token;
      i = end;
    } else {
      in_string = c == '"';
      repaired += c;
      ++i;
    }
  }
  return repaired;
}

}  // namespace mapwright::robot::axbot
