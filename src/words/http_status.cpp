#include "words/http_status.h"

#include <algorithm>
#include <array>
#include <utility>

namespace mapwright::words {

std::string statusWords(int status) {
  constexpr std::array<std::pair<int, const char*>, 19> kWords{{{304, "not modified"},
                                                                {400, "bad request"},
                                                                {401, "not authorised"},
                                                                {403, "forbidden"},
                                                                {404, "not found"},
                                                                {405, "method not allowed"},
                                                                {408, "request timeout"},
                                                                {409, "conflict"},
                                                                {410, "gone"},
                                                                {413, "too large"},
                                                                {415, "unsupported media type"},
                                                                {422, "cannot be processed"},
                                                                {426, "upgrade required"},
                                                                {429, "too many requests"},
                                                                {500, "internal error"},
                                                                {501, "not implemented"},
                                                                {502, "bad gateway"},
                                                                {503, "unavailable"},
                                                                {504, "gateway timeout"}}};
  const auto* found =
      std::find_if(kWords.begin(), kWords.end(), [status](const auto& word) { return word.first == status; });
  if (found == kWords.end()) {
    return std::to_string(status);
  }
  return std::to_string(status) + " (" + found->second + ")";
}

}  // namespace mapwright::words
