// A fast path for the most common messages of a bag, poses and lists of points, and for repetitions of a
// topic's previous message, without building a tree. Only handles the usual formatting: everything else is
// left to readFrame(), and the results are identical (tests/robot/test_axbot_bags.cpp). With simdjson on
// demand instead of JsonCursor a range of mixed messages takes a third longer, poses alone twice as long.
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <system_error>
#include <unordered_map>

#include "robot/bag_library.h"

namespace mapwright::robot::axbot {

/// Scans simply formatted JSON, faster than building a tree. It repairs and guesses nothing: anything but the
/// plainest form of the grammar (RFC 8259) ends the scan, and the caller uses a parser instead. A position in
/// a text that ends with a zero byte outside of any value. After false the position is
/// undefined, at most at that byte.
class JsonCursor {
 public:
  explicit JsonCursor(const char* at) : at_(at) {}

  const char* at() const { return at_; }
  char peek() const { return *at_; }
  void skipSpace() {
    while (*at_ == ' ' || *at_ == '\n' || *at_ == '\r' || *at_ == '\t') ++at_;
  }
  /// `c` with surrounding white space.
  bool consume(char c) {
    skipSpace();
    if (*at_ != c) return false;
    ++at_;
    skipSpace();
    return true;
  }
  bool readText(std::string_view text) {
    if (std::strncmp(at_, text.data(), text.size()) != 0) return false;
    at_ += text.size();
    return true;
  }
  /// A string without escapes and control characters.
  bool readString(std::string_view& text) {
    if (*at_ != '"') return false;
    const char* const start = ++at_;
    while (*at_ != '"' && *at_ != '\\' && static_cast<unsigned char>(*at_) >= 0x20) ++at_;
    if (*at_ != '"') return false;
    text = {start, std::size_t(at_ - start)};
    ++at_;
    return true;
  }
  bool readBoolean(bool& truth) {
    truth = *at_ == 't';
    return readText(truth ? "true" : "false");
  }
  /// The nearest double; false for numbers that are too large, and for integers with too many digits.
  bool readNumber(double& number);
  /// A string, number, boolean or null.
  bool readScalar();

 private:
  static bool isDigit(char c) { return c >= '0' && c <= '9'; }
  bool ends() const { return *at_ == ',' || *at_ == ']' || *at_ == '}' || *at_ == ' ' || *at_ == '\n'; }
  bool readLongNumber(double& number);

  const char* at_;
};

/// The end of the list or object that begins at `at`: after its last bracket. Ignores brackets in strings and
/// does not validate the rest. nullptr: it does not end before `end`.
const char* endOfNested(const char* at, const char* end);

inline bool JsonCursor::readNumber(double& number) {
  // With few digits, as robots write positions, it is an integer divided by a power of ten: both are exact
  // doubles, so the quotient is the nearest double.
  constexpr double kPowers[] = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14};
  constexpr int kMostDigits = 14;
  const char* const begin = at_;
  const bool negative = *at_ == '-';
  at_ += negative;
  const char* const digits = at_;
  std::uint64_t whole = 0;
  for (; isDigit(*at_); ++at_) whole = whole * 10 + std::uint64_t(*at_ - '0');
  const auto before = at_ - digits;
  if (before == 0 || (before > 1 && *digits == '0')) return false;
  std::ptrdiff_t after = 0;
  if (*at_ == '.') {
    const char* const fraction = ++at_;
    for (; isDigit(*at_); ++at_) whole = whole * 10 + std::uint64_t(*at_ - '0');
    after = at_ - fraction;
    if (after == 0) return false;
  }
  if (before + after > kMostDigits || !ends()) {
    at_ = begin;
    return readLongNumber(number);
  }
  const double size = after == 0 ? double(whole) : double(whole) / kPowers[after];
  number = negative ? -size : size;
  return true;
}

/// Reads the messages of one text, which ends with a zero byte and must outlive it.
class PlainMessages {
 public:
  /// Reads the message that begins at `at`, except its position in the text; returns its end. nullptr: use
  /// the normal reader; `message` is then unchanged or partly filled.
  const char* read(const char* at, BagMessage& message);
  /// `message`, with the JSON `json`, was read by the normal reader: the next one of its topic may be the
  /// same. `index`: its index among all messages.
  void remember(std::string_view json, const BagMessage& message, std::size_t index);
  /// If the message only repeats its topic's last one at a later time: its end, with that one's index in
  /// `of`. nullptr: it does not.
  const char* readAgain(const char* at, std::size_t& of, double& stamp_s) const;

 private:
  struct Said {
    std::string_view before, behind;  // the text around its stamp
    std::size_t index = 0;
  };

  std::size_t last_count_ = 0;                       // of points: the next cloud usually has the same size
  std::unordered_map<std::string_view, Said> said_;  // by topic
};

}  // namespace mapwright::robot::axbot
