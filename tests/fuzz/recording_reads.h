// What holds for every recording that can be opened, whatever its format.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "recording/source.h"
#include "target.h"

namespace mapwright::fuzz {

/// Small enough that damage, not size, is what is found.
inline recording::Limits smallLimits() {
  recording::Limits limits;
  limits.most_chunk_bytes = 1 << 20;
  limits.most_record_bytes = 1 << 16;
  limits.held_bytes = 1 << 20;
  return limits;
}

/// The times of the messages, at most `most`.
inline std::vector<std::int64_t> timesOf(recording::Source& source, const recording::Query& query,
                                         std::size_t most) {
  std::vector<std::int64_t> times;
  unsigned sum = 0;
  const auto cursor = source.messages(query);
  while (times.size() < most) {
    const auto message = cursor->next();
    if (!message) break;
    MUST(message->channel);
    for (const std::uint8_t byte : message->bytes) sum += byte;
    times.push_back(message->log_time_ns);
  }
  use(sum);
  return times;
}

inline void readSource(recording::Source& source) {
  constexpr std::size_t kMost = 2000;
  use(source.summary());
  // The first time through may find that a chunk does not hold what it says, and mend the order.
  (void)timesOf(source, {}, kMost);
  const auto there = timesOf(source, {}, kMost);
  for (std::size_t i = 1; i < there.size(); ++i) MUST(there[i - 1] <= there[i]);
  if (there.empty() || there.size() == kMost) return;
  recording::Query query;
  query.backwards = true;
  auto back = timesOf(source, query, kMost);
  MUST(std::equal(there.begin(), there.end(), back.rbegin(), back.rend()));
  const std::int64_t middle = there[there.size() / 2];
  for (const auto& message : source.lastBefore(middle, {})) MUST(message.log_time_ns <= middle);
  recording::Query part;
  part.first_ns = middle;
  if (!source.channels().empty()) part.topics = {source.channels().front()->topic};
  for (const std::int64_t time : timesOf(source, part, kMost)) MUST(time >= middle);
  use(source.packing());
  for (const auto& attachment : source.attachments()) use(source.attachment(attachment));
  use(source.metadata());
  use(source.summary());
}

}  // namespace mapwright::fuzz
