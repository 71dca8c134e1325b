#include "robot/wire/json_cursor.h"

namespace mapwright::robot::wire {

bool JsonCursor::takeLongNumber(double& number) {
  constexpr std::ptrdiff_t kMostWholeDigits = 18;
  const char* const begin = at_;
  if (*at_ == '-') ++at_;
  const auto takeDigits = [&] {
    const char* const first = at_;
    while (isDigit(*at_)) ++at_;
    return at_ > first;
  };
  if (!takeDigits()) return false;
  bool whole = true;
  if (*at_ == '.') {
    whole = false;
    ++at_;
    if (!takeDigits()) return false;
  }
  if (*at_ == 'e' || *at_ == 'E') {
    whole = false;
    ++at_;
    if (*at_ == '+' || *at_ == '-') ++at_;
    if (!takeDigits()) return false;
  }
  if (whole && at_ - begin > kMostWholeDigits) return false;
  const auto [end, error] = std::from_chars(begin, at_, number);
  return error == std::errc() && end == at_;
}

bool JsonCursor::takeScalar() {
  std::string_view text;
  double number = 0;
  switch (*at_) {
    case '"':
      return takeString(text);
    case 't':
      return takeText("true");
    case 'f':
      return takeText("false");
    case 'n':
      return takeText("null");
    default:
      return takeNumber(number);
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

}  // namespace mapwright::robot::wire
