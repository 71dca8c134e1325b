#include "recording/chunk_cursor.h"

#include <algorithm>
#include <tuple>

namespace mapwright::recording {

bool ChunkCursor::Later::operator()(const Head& a, const Head& b) const {
  const auto key = [](const Head& head) { return std::tie(head.log_ns, head.chunk, head.entry); };
  return backwards ? key(a) < key(b) : key(b) < key(a);
}

ChunkCursor::ChunkCursor(ChunkedSource& source, const Query& query)
    : source_(source), query_(query), choice_(query.topics), heads_(Later{query.backwards}) {
  for (std::size_t i = 0; i < source_.chunks_.size(); ++i) {
    if (mayHold(source_.chunks_[i])) waiting_.push_back(std::uint32_t(i));
  }
  const auto& chunks = source_.chunks_;
  std::sort(waiting_.begin(), waiting_.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (query_.backwards) return std::tie(chunks[a].last_ns, a) < std::tie(chunks[b].last_ns, b);
    return std::tie(chunks[a].first_ns, a) > std::tie(chunks[b].first_ns, b);
  });
}

bool ChunkCursor::wants(std::uint32_t channel) {
  if (const auto found = wanted_.find(channel); found != wanted_.end()) return found->second;
  const auto known = source_.channels_.find(channel);
  if (known == source_.channels_.end()) return false;  // unpacking has noted it
  return wanted_[channel] = choice_.takes(*known->second);
}

bool ChunkCursor::mayHold(const ChunkPlace& place) {
  if (place.first_ns > place.last_ns || place.last_ns < query_.first_ns || place.first_ns > query_.last_ns) {
    return false;
  }
  if (choice_.all() || !place.channels_known) return true;
  return std::any_of(place.shares.begin(), place.shares.end(), [&](const ChannelShare& share) {
    return !source_.knowsChannel(share.channel) || wants(share.channel);
  });
}

void ChunkCursor::push(std::uint32_t chunk, const UnpackedChunk& unpacked, std::size_t entry) {
  const auto& entries = unpacked.entries;
  // Backwards the place before the first one is size_t's highest.
  for (std::size_t i = entry; i < entries.size(); query_.backwards ? --i : ++i) {
    if (query_.backwards ? entries[i].log_ns < query_.first_ns : entries[i].log_ns > query_.last_ns) return;
    if (!wants(entries[i].channel)) continue;
    heads_.push({entries[i].log_ns, chunk, i});
    return;
  }
}

void ChunkCursor::openThose() {
  while (!waiting_.empty()) {
    const std::uint32_t chunk = waiting_.back();
    const ChunkPlace& place = source_.chunks_[chunk];
    if (!heads_.empty()) {
      const std::int64_t now = heads_.top().log_ns;
      if (query_.backwards ? place.last_ns < now : place.first_ns > now) return;
    }
    waiting_.pop_back();
    const UnpackedPtr unpacked = source_.unpacked(chunk);
    const auto& entries = unpacked->entries;
    if (query_.backwards) {
      const auto end =
          std::upper_bound(entries.begin(), entries.end(), query_.last_ns,
                           [](std::int64_t time, const ChunkEntry& entry) { return time < entry.log_ns; });
      if (end != entries.begin()) push(chunk, *unpacked, std::size_t(end - entries.begin()) - 1);
    } else {
      const auto first =
          std::lower_bound(entries.begin(), entries.end(), query_.first_ns,
                           [](const ChunkEntry& entry, std::int64_t time) { return entry.log_ns < time; });
      push(chunk, *unpacked, std::size_t(first - entries.begin()));
    }
  }
}

std::optional<Message> ChunkCursor::next() {
  while (true) {
    openThose();
    if (heads_.empty()) return std::nullopt;
    const Head head = heads_.top();
    heads_.pop();
    const UnpackedPtr unpacked = source_.unpacked(head.chunk);
    // Unpacked again, it may be different: the file was changed meanwhile.
    if (head.entry >= unpacked->entries.size()) continue;
    const ChunkEntry& entry = unpacked->entries[head.entry];
    push(head.chunk, *unpacked, query_.backwards ? head.entry - 1 : head.entry + 1);
    if (entry.log_ns == head.log_ns && wants(entry.channel)) return source_.messageAt(*unpacked, entry);
  }
}

}  // namespace mapwright::recording
