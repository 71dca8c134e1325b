#include "words/sentences.h"

#include <cstddef>
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

constexpr std::string_view kChineseStop = "。";

bool hasEnd(std::string_view words) {
  for (const std::string_view end :
       {std::string_view("."), std::string_view("!"), std::string_view("?"), std::string_view("…"),
        kChineseStop, std::string_view("！"), std::string_view("？")}) {
    if (words.ends_with(end)) return true;
  }
  return false;
}

/// Where Chinese is spoken, every sentence with Chinese in it: "无法读取 a.png" ends with a name. Elsewhere
/// its last letter is Chinese, and not only that of a name: "始于 07:36" is. In UTF-8 these characters have
/// three bytes.
bool isChinese(std::string_view words, bool spoken) {
  std::size_t chinese = 0, latin = 0;
  bool last = false;
  for (const char each : words) {
    const auto byte = static_cast<unsigned char>(each);
    const bool begins = (byte >= 0xe3 && byte <= 0xe9) || byte == 0xef;
    chinese += begins;
    const bool letter = (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z');
    latin += letter;
    if (letter || byte >= 0xc0) last = begins;
  }
  return chinese > 0 && (spoken || (last && chinese > latin));
}

void stop(std::string& words, bool chinese) {
  words += isChinese(words, chinese) ? kChineseStop : std::string_view(".");
}

}  // namespace

std::string withoutStop(std::string words) {
  trimEnd(words);
  while (words.ends_with('.') || words.ends_with(kChineseStop)) {
    words.resize(words.size() - (words.ends_with('.') ? 1 : kChineseStop.size()));
    trimEnd(words);
  }
  return words;
}

std::string asSentence(std::string words, bool chinese) {
  trimEnd(words);
  const std::size_t first = words.find_first_not_of(" \n\r\t");
  if (first == std::string::npos) return {};
  words.erase(0, first);
  // "reason.." is one sentence; "reason..." is left open on purpose.
  if (words.ends_with("..") && !words.ends_with("...")) words = withoutStop(std::move(words));
  if (words.empty()) return words;
  if (!hasEnd(words)) stop(words, chinese);
  // A path stays as it is.
  const bool path = words.substr(0, words.find(' ')).find('/') != std::string::npos;
  if (!path && words[0] >= 'a' && words[0] <= 'z') words[0] = char(words[0] - 'a' + 'A');
  return words;
}

std::string because(std::string what, std::string reason, bool chinese) {
  what = withoutStop(std::move(what));
  while (what.ends_with(':')) what = withoutStop(what.substr(0, what.size() - 1));
  reason = withoutStop(std::move(reason));
  if (reason.empty()) {
    stop(what, chinese);
    return what;
  }
  what += (isChinese(what, chinese) ? "：" : ": ") + reason;
  if (!hasEnd(what)) stop(what, chinese);
  return what;
}

}  // namespace mapwright::words
