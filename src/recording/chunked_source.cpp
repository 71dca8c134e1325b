#include "recording/chunked_source.h"

#include <algorithm>
#include <limits>
#include <new>
#include <tuple>
#include <utility>

#include "recording/chunk_cursor.h"

namespace mapwright::recording {
namespace {

bool byTime(const ChunkEntry& a, const ChunkEntry& b) {
  return std::tie(a.log_ns, a.offset) < std::tie(b.log_ns, b.offset);
}

}  // namespace

const ChannelShare* ChunkPlace::shareOf(std::uint32_t channel) const {
  const auto found = std::lower_bound(
      shares.begin(), shares.end(), channel,
      [](const ChannelShare& share, std::uint32_t wanted) { return share.channel < wanted; });
  return found != shares.end() && found->channel == channel ? &*found : nullptr;
}

ChannelChoice::ChannelChoice(const std::vector<std::string>& topics) : topics_(topics) {
  std::sort(topics_.begin(), topics_.end());
}

bool ChannelChoice::takes(const Channel& channel) const {
  return topics_.empty() || std::binary_search(topics_.begin(), topics_.end(), channel.topic);
}

Summary ChunkedSource::summary() const {
  Summary summary = about_;
  summary.chunks = std::size_t(
      std::count_if(chunks_.begin(), chunks_.end(), [](const ChunkPlace& chunk) { return !chunk.bare; }));
  summary.notes = notes_.all();
  return summary;
}

std::vector<ChannelPtr> ChunkedSource::channels() const {
  std::vector<ChannelPtr> all;
  all.reserve(channels_.size());
  for (const auto& [id, channel] : channels_) all.push_back(channel);
  return all;
}

std::unique_ptr<Cursor> ChunkedSource::messages(const Query& query) {
  return std::make_unique<ChunkCursor>(*this, query);
}

void ChunkedSource::addChannel(Channel channel, std::uint64_t offset) {
  const auto found = channels_.find(channel.id);
  if (found == channels_.end()) {
    const std::uint32_t id = channel.id;
    channels_.emplace(id, std::make_shared<const Channel>(std::move(channel)));
  } else if (*found->second != channel) {
    notes_.add(NoteCode::ChannelChanged, offset, channel.topic);
  }
}

void ChunkedSource::addChunk(ChunkPlace place) {
  const auto byChannel = [](const ChannelShare& a, const ChannelShare& b) { return a.channel < b.channel; };
  if (!std::is_sorted(place.shares.begin(), place.shares.end(), byChannel)) {
    std::sort(place.shares.begin(), place.shares.end(), byChannel);
  }
  chunks_.push_back(std::move(place));
  latest_first_.clear();
}

void ChunkedSource::sortChunks() {
  std::sort(chunks_.begin(), chunks_.end(),
            [](const ChunkPlace& a, const ChunkPlace& b) { return a.offset < b.offset; });
  forgetOrder();
}

void ChunkedSource::dropAll() {
  chunks_.clear();
  channels_.clear();
  forgetOrder();
}

/// Data by chunk number, since the numbers have changed.
void ChunkedSource::forgetOrder() {
  latest_first_.clear();
  held_.clear();
  held_at_.clear();
  held_bytes_ = 0;
}

std::optional<UnpackedChunk> ChunkedSource::raw(std::uint64_t at, std::uint64_t count) const {
  const std::uint64_t size = bytes_->size();
  if (at > size || count > size - at) return std::nullopt;
  auto* const taken = new (std::nothrow) std::uint8_t[std::size_t(std::max<std::uint64_t>(count, 1))];
  if (taken == nullptr) return std::nullopt;
  UnpackedChunk chunk;
  chunk.bytes = std::shared_ptr<const std::uint8_t[]>(taken);
  chunk.size = std::size_t(count);
  if (!bytes_->read({taken, chunk.size}, at)) return std::nullopt;
  return chunk;
}

UnpackedPtr ChunkedSource::unpacked(std::size_t chunk) {
  if (const auto found = held_at_.find(chunk); found != held_at_.end()) {
    held_.splice(held_.begin(), held_, found->second);
    return found->second->unpacked;
  }
  auto made = std::make_shared<UnpackedChunk>();
  const bool again = std::exchange(chunks_[chunk].looked_into, true);
  const Notes before = again ? notes_ : Notes();
  if (tl::expected<UnpackedChunk, Note> got = unpack(chunks_[chunk])) {
    *made = std::move(*got);
    dropUnknown(*made, chunks_[chunk].offset);
    if (!std::is_sorted(made->entries.begin(), made->entries.end(), byTime)) {
      std::sort(made->entries.begin(), made->entries.end(), byTime);
    }
    learn(chunks_[chunk], *made);
  } else {
    notes_.add(got.error().code, got.error().offset,
               got.error().name);  // and is treated as empty
  }
  if (again) notes_ = before;  // it was noted when it was first unpacked
  const std::size_t bytes = made->size + made->entries.capacity() * sizeof(ChunkEntry) + 64;
  held_.push_front({chunk, made, bytes});
  held_at_[chunk] = held_.begin();
  held_bytes_ += bytes;
  while (held_bytes_ > limits_.held_bytes && held_.size() > 1) {
    held_bytes_ -= held_.back().bytes;
    held_at_.erase(held_.back().chunk);
    held_.pop_back();
  }
  return made;
}

/// Messages of undescribed channels are useless.
void ChunkedSource::dropUnknown(UnpackedChunk& chunk, std::uint64_t offset) {
  const std::size_t gone = std::erase_if(
      chunk.entries, [&](const ChunkEntry& entry) { return !channels_.contains(entry.channel); });
  if (gone != 0) notes_.add(NoteCode::UnknownChannel, offset, {}, gone);
}

/// The stated facts of a chunk may be wrong: replaces them by the real ones.
void ChunkedSource::learn(ChunkPlace& place, const UnpackedChunk& unpacked) {
  const auto& entries = unpacked.entries;
  if (!entries.empty()) {
    const std::int64_t first = entries.front().log_ns;
    const std::int64_t last = entries.back().log_ns;
    if (first < place.first_ns || last > place.last_ns) {
      if (place.first_ns <= place.last_ns) notes_.add(NoteCode::ChunkTimes, place.offset);
      place.first_ns = first;
      place.last_ns = last;
      latest_first_.clear();
    }
  }
  if (place.channels_known) return;
  std::map<std::uint32_t, std::uint64_t> counts;
  for (const ChunkEntry& entry : entries) ++counts[entry.channel];
  std::vector<ChannelShare> shares;
  for (const auto& [channel, count] : counts) {
    const ChannelShare* const before = place.shareOf(channel);
    shares.push_back({channel, before ? before->index_offset : 0, count});
  }
  place.shares = std::move(shares);
  place.channels_known = true;
}

void ChunkedSource::lookInto(std::size_t chunk) {
  chunks_[chunk].channels_known = false;
  if (const auto found = held_at_.find(chunk); found != held_at_.end()) {
    learn(chunks_[chunk], *found->second->unpacked);
  } else {
    const UnpackedPtr done = unpacked(chunk);
    if (done->entries.empty()) {  // nothing in it is readable
      chunks_[chunk].shares.clear();
      chunks_[chunk].channels_known = true;
    }
  }
}

void ChunkedSource::findChannels() {
  for (std::size_t i = 0; i < chunks_.size(); ++i) {
    const auto unknown = [&](const ChannelShare& share) { return !channels_.contains(share.channel); };
    const auto& shares = chunks_[i].shares;
    if (!chunks_[i].channels_known || std::any_of(shares.begin(), shares.end(), unknown)) unpacked(i);
  }
}

void ChunkedSource::countChunks() {
  about_.messages = 0;
  about_.messages_of.clear();
  about_.start_ns.reset();
  about_.end_ns.reset();
  for (const ChunkPlace& chunk : chunks_) {
    for (const ChannelShare& share : chunk.shares) {
      about_.messages += share.count;
      about_.messages_of[share.channel] += share.count;
    }
    if (chunk.first_ns > chunk.last_ns) continue;
    about_.start_ns = std::min(about_.start_ns.value_or(chunk.first_ns), chunk.first_ns);
    about_.end_ns = std::max(about_.end_ns.value_or(chunk.last_ns), chunk.last_ns);
  }
}

Message ChunkedSource::messageAt(const UnpackedChunk& chunk, const ChunkEntry& entry) const {
  Message message = read(chunk, entry);
  message.channel = channels_.at(entry.channel);
  message.log_time_ns = entry.log_ns;
  message.keeps = chunk.bytes;
  return message;
}

const std::vector<std::uint32_t>& ChunkedSource::latestFirst() {
  if (latest_first_.size() != chunks_.size()) {
    latest_first_.resize(chunks_.size());
    for (std::size_t i = 0; i < chunks_.size(); ++i) latest_first_[i] = std::uint32_t(i);
    std::sort(latest_first_.begin(), latest_first_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::tie(chunks_[a].last_ns, a) > std::tie(chunks_[b].last_ns, b);
    });
  }
  return latest_first_;
}

std::optional<ChunkedSource::Best> ChunkedSource::latest(std::uint32_t channel, std::int64_t at_ns,
                                                         bool trust_index) {
  std::optional<Best> best;
  const std::vector<std::uint32_t> order = latestFirst();  // what is learned below may sort it again
  for (const std::uint32_t i : order) {
    const ChunkPlace& place = chunks_[i];
    if (place.first_ns > place.last_ns || place.first_ns > at_ns) continue;
    if (best && best->log_ns > std::min(place.last_ns, at_ns)) break;
    const ChannelShare* const share = place.shareOf(channel);
    if (place.channels_known && share == nullptr) continue;
    Latest found;
    if (trust_index && share != nullptr && share->index_offset != 0) {
      found = latestByIndex(place, *share, at_ns);
    }
    if (found.unknown) {
      for (const ChunkEntry& entry : unpacked(i)->entries) {
        if (entry.log_ns > at_ns) break;
        if (entry.channel == channel) found.log_ns = entry.log_ns;
      }
    }
    if (!found.log_ns) continue;
    if (!best || std::pair(*found.log_ns, std::size_t(i)) > std::pair(best->log_ns, best->chunk)) {
      best = Best{*found.log_ns, i};
    }
  }
  return best;
}

std::optional<Message> ChunkedSource::lastOf(std::uint32_t channel, std::int64_t at_ns, Best& found) {
  for (const bool trust : {true, false}) {
    const std::optional<Best> best = latest(channel, at_ns, trust);
    if (!best) {
      if (trust) continue;
      return std::nullopt;
    }
    const UnpackedPtr chunk = unpacked(best->chunk);
    auto at =
        std::upper_bound(chunk->entries.begin(), chunk->entries.end(), best->log_ns,
                         [](std::int64_t time, const ChunkEntry& entry) { return time < entry.log_ns; });
    while (at != chunk->entries.begin() && (at - 1)->log_ns == best->log_ns) {
      --at;
      if (at->channel != channel) continue;
      found = *best;
      return messageAt(*chunk, *at);
    }
    notes_.add(NoteCode::IndexLies, chunks_[best->chunk].offset);
  }
  return std::nullopt;
}

std::vector<Packing> ChunkedSource::packing() const {
  std::map<std::string, Packing> by_name;
  for (const ChunkPlace& place : chunks_) {
    const std::optional<Packing> one = place.bare ? std::nullopt : packingOf(place);
    if (!one) continue;
    Packing& all = by_name[one->compression];
    all.compression = one->compression;
    ++all.chunks;
    all.packed_bytes += one->packed_bytes;
    all.unpacked_bytes += one->unpacked_bytes;
  }
  std::vector<Packing> packing;
  for (auto& [name, all] : by_name) packing.push_back(std::move(all));
  return packing;
}

std::vector<Message> ChunkedSource::lastBefore(std::int64_t at_ns, const std::vector<std::string>& topics) {
  const ChannelChoice choice(topics);
  // Of channels that share a topic, the one that messages() would give last.
  std::map<std::string, std::pair<std::tuple<std::int64_t, std::size_t, const std::uint8_t*>, Message>>
      of_topic;
  for (const auto& [id, channel] : std::map(channels_)) {
    if (!choice.takes(*channel)) continue;
    Best found;
    std::optional<Message> message = lastOf(id, at_ns, found);
    if (!message) continue;
    const auto key = std::tuple(found.log_ns, found.chunk, message->bytes.data());
    const auto held = of_topic.find(channel->topic);
    if (held == of_topic.end()) {
      of_topic.emplace(channel->topic, std::pair(key, std::move(*message)));
    } else if (held->second.first < key) {
      held->second = std::pair(key, std::move(*message));
    }
  }
  std::vector<Message> messages;
  for (auto& [topic, held] : of_topic) messages.push_back(std::move(held.second));
  return messages;
}

}  // namespace mapwright::recording
