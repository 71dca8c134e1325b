#include "replay/silences.h"

#include <algorithm>
#include <utility>

namespace mapwright::replay {
namespace {

// A bag of few messages has pauses between all of them.
constexpr double kTimesUsual = 10;

}  // namespace

std::vector<Silence> silencesIn(const Chunks& chunks, const std::map<Tick, Digest>& digests) {
  std::size_t messages = 0;
  double read_s = 0;
  for (const auto& [from, cell] : chunks.cells()) {
    if (cell.state != CellState::Read || cell.beyond) continue;
    messages += cell.messages;
    read_s += secondsOf(cell.until) - secondsOf(cell.from);
  }
  const double least_s =
      std::max(kSilenceS, messages > 0 ? kTimesUsual * read_s / double(messages) : kSilenceS);
  std::vector<Silence> silences;
  double since_s = chunks.start_s();  // the last message
  bool known = true;                  // everything in between has been read
  const auto endAt = [&](double at_s) {
    if (known && at_s - since_s >= least_s) silences.push_back({since_s, at_s});
  };
  for (const auto& [from, cell] : chunks.cells()) {
    if (cell.beyond) continue;
    const auto digest = digests.find(from);
    if (cell.state != CellState::Read || digest == digests.end()) {
      endAt(secondsOf(cell.from));
      known = false;
      continue;
    }
    if (!std::exchange(known, true)) since_s = std::max(secondsOf(cell.from), chunks.start_s());
    if (digest->second.messages == 0) continue;
    endAt(digest->second.first_s);
    for (const auto& [before_s, after_s] : digest->second.silences) {
      since_s = before_s;
      endAt(after_s);
    }
    since_s = digest->second.last_s;
  }
  endAt(chunks.end_s());
  return silences;
}

}  // namespace mapwright::replay
