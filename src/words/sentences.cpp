#include "words/sentences.h"

#include <string_view>
#include <utility>

namespace mapwright::words {
namespace {

void trimEnd(std::string& words) {
  while (!words.empty() &&
         (words.back() == ' ' || words.back() == '\n' || words.back() == '\r' || words.back() == '\t')) {
    words.pop_back();
  }
}

bool hasEnd(const std::string& words) {
  constexpr std::string_view kEllipsis = "…";
  const std::string_view view(words);
  return view.ends_with('.') || view.ends_with('!') || view.ends_with('?') || view.ends_with(kEllipsis);
}

}  // namespace

std::string withoutStop(std::string words) {
  trimEnd(words);
  while (!words.empty() && words.back() == '.') {
    words.pop_back();
    trimEnd(words);
  }
  return words;
}

std::string asSentence(std::string words) {
  trimEnd(words);
  const std::size_t first = words.find_first_not_of(" \n\r\t");
  if (first == std::string::npos) return {};
  words.erase(0, first);
  // "reason.." is one sentence; "reason..." is left open on purpose.
  if (words.ends_with("..") && !words.ends_with("...")) words = withoutStop(std::move(words));
  if (words.empty()) return words;
  if (!hasEnd(words)) words += '.';
  // A path stays as it is.
  const bool path = words.substr(0, words.find(' ')).find('/') != std::string::npos;
  if (!path && words[0] >= 'a' && words[0] <= 'z') words[0] = char(words[0] - 'a' + 'A');
  return words;
}

std::string because(std::string what, std::string reason) {
  what = withoutStop(std::move(what));
  while (what.ends_with(':')) what = withoutStop(what.substr(0, what.size() - 1));
  reason = withoutStop(std::move(reason));
  if (reason.empty()) return what + '.';
  what += ": " + reason;
  if (!hasEnd(what)) what += '.';
  return what;
}

}  // namespace mapwright::words
