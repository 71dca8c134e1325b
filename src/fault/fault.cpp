#include "fault/fault.h"

#include <locale>
#include <sstream>

namespace mapwright {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

bool isWordChar(char c) {
  return isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (c & 0x80);
}

/// The end of the number that begins at `at`: digits, with grouping or a fraction, and an exponent.
std::size_t endOfNumber(const std::string& text, std::size_t at) {
  const auto digitAt = [&](std::size_t i) { return i < text.size() && isDigit(text[i]); };
  while (digitAt(at) || (at < text.size() && (text[at] == '.' || text[at] == ',') && digitAt(at + 1))) ++at;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    const std::size_t sign = at + 1 < text.size() && (text[at + 1] == '+' || text[at + 1] == '-') ? 1 : 0;
    if (digitAt(at + 1 + sign)) {
      at += 1 + sign;
      while (digitAt(at)) ++at;
    }
  }
  return at;
}

std::string textOf(const FaultArgument& argument) {
  if (const auto* const text = std::get_if<std::string>(&argument)) return *text;
  if (const auto* const status = std::get_if<HttpStatus>(&argument)) return std::to_string(status->code);
  if (const auto* const whole = std::get_if<std::int64_t>(&argument)) return std::to_string(*whole);
  std::ostringstream number;
  number.imbue(std::locale::classic());
  number << std::get<double>(argument);
  return number.str();
}

}  // namespace

std::string withoutNumbers(const std::string& text) {
  std::string pattern;
  pattern.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const bool minus =
        text[i] == '-' && i + 1 < text.size() && isDigit(text[i + 1]) && (i == 0 || !isWordChar(text[i - 1]));
    if (!minus && !isDigit(text[i])) {
      pattern += text[i++];
      continue;
    }
    pattern += '#';
    i = endOfNumber(text, i + (minus ? 1 : 0));
  }
  return pattern;
}

std::string patternOf(const Fault& fault) {
  std::string pattern =
      std::string(fault.code.room) + "/" + fault.code.text + '/' + std::to_string(int(fault.then));
  for (const FaultArgument& argument : fault.arguments) {
    const auto* const text = std::get_if<std::string>(&argument);
    pattern += '|' + (text ? withoutNumbers(*text) : std::string("#"));
  }
  for (const Fault& cause : fault.because) pattern += '(' + patternOf(cause) + ')';
  return pattern;
}

std::string inEnglish(const Fault& fault) {
  const std::string_view text = fault.code.text;
  std::string english;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%' || i + 1 == text.size() || !isDigit(text[i + 1])) {
      english += text[i];
      continue;
    }
    const auto number = std::size_t(text[++i] - '0');
    if (number >= 1 && number <= fault.arguments.size()) english += textOf(fault.arguments[number - 1]);
  }
  const char* between = english.empty() ? "" : ": ";
  for (const Fault& cause : fault.because) {
    english += between + inEnglish(cause);
    between = "; ";
  }
  return english;
}

}  // namespace mapwright
