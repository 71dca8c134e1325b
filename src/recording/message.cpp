#include "recording/message.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace mapwright::recording {
namespace {

constexpr std::size_t kMostNotes = 200;  // names come from the file
constexpr double kMostS = 9.2e9;         // the maximum for nanoseconds in 63 bits
constexpr int kDigits = 9;               // of nanoseconds

}  // namespace

void Notes::add(NoteCode code, std::uint64_t offset, std::string_view name, std::uint64_t count) {
  const auto same = [&](const Note& note) { return note.code == code && note.name == name; };
  const auto found = std::find_if(notes_.begin(), notes_.end(), same);
  if (found != notes_.end()) {
    found->count += count;
    return;
  }
  if (notes_.size() < kMostNotes) notes_.push_back({code, offset, count, std::string(name)});
}

void Notes::drop(NoteCode code) {
  std::erase_if(notes_, [&](const Note& note) { return note.code == code; });
}

std::int64_t nanosecondsOf(double s) {
  const double within = std::clamp(std::isnan(s) ? 0 : s, -kMostS, kMostS);
  std::array<char, 400> text{};  // of the smallest double
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), std::abs(within), std::chars_format::fixed).ptr;
  const std::string_view digits(text.data(), std::size_t(end - text.data()));
  const std::size_t point = std::min(digits.find('.'), digits.size());
  std::int64_t ns = 0;
  for (const char digit : digits.substr(0, point)) ns = ns * 10 + (digit - '0');
  for (std::size_t decimal = 1; decimal <= kDigits; ++decimal) {
    const bool there = point + decimal < digits.size();
    ns = ns * 10 + (there ? digits[point + decimal] - '0' : 0);
  }
  const std::size_t next = point + kDigits + 1;
  if (next < digits.size() && digits[next] >= '5') ++ns;
  return within < 0 ? -ns : ns;
}

}  // namespace mapwright::recording
