#include "recording/chunked_source.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <new>
#include <tuple>
#include <utility>

#include <queue>

#include "disk/read_file.h"
#include "packed/codec.h"

namespace mapwright::recording {
namespace {

constexpr std::uint64_t kMostBare = std::uint64_t(1) << 20;  // bytes of bare records read as one chunk

bool byTime(const ChunkEntry& a, const ChunkEntry& b) {
  return std::tie(a.log_ns, a.offset) < std::tie(b.log_ns, b.offset);
}

bool byChannel(const ChannelShare& a, const ChannelShare& b) { return a.channel < b.channel; }

/// rosbag2 can compress messages one by one, and says so in another file only. CDR begins with a zero.
bool isPackedAlone(const Message& message) {
  constexpr std::array<std::uint8_t, 4> kZstd{0x28, 0xB5, 0x2F, 0xFD};
  return message.channel->message_encoding == "cdr" && message.bytes.size() > kZstd.size() &&
         std::equal(kZstd.begin(), kZstd.end(), message.bytes.begin());
}

void unpackAlone(Message& message, std::uint64_t most_bytes) {
  const auto stated = packed::zstdContentSize(message.bytes);
  if (!stated || *stated > most_bytes) return;
  auto unpacked = packed::unpackExactly(packed::Codec::Zstd, message.bytes, std::size_t(*stated));
  if (!unpacked) return;
  const std::shared_ptr<const std::uint8_t[]> kept(std::move(unpacked->data));
  message.bytes = {kept.get(), unpacked->size};
  message.keeps = kept;
}

/// The channels of a query: all, or those on one of its topics.
class ChannelChoice {
 public:
  explicit ChannelChoice(const std::vector<std::string>& topics) : topics_(topics) {
    std::sort(topics_.begin(), topics_.end());
  }
  bool all() const { return topics_.empty(); }
  bool takes(const Channel& channel) const {
    return all() || std::binary_search(topics_.begin(), topics_.end(), channel.topic);
  }

 private:
  std::vector<std::string> topics_;  // sorted
};

}  // namespace

/// The messages of chunks that may overlap, merged by time. Opens a chunk only when it may be needed, and
/// keeps none: unpacked chunks are in the source's bounded store, so many overlapping chunks cost time but no
/// memory.
class ChunkCursor final : public Cursor {
 public:
  ChunkCursor(ChunkedSource& source, const Query& query);
  std::optional<Message> next() override;

 private:
  /// The next message of a chunk. Order: log time, chunk in the file, position in the chunk.
  struct Head {
    std::int64_t log_ns = 0;
    std::uint32_t chunk = 0;
    std::size_t entry = 0;  // of UnpackedChunk::entries
  };
  struct Later {
    bool backwards = false;
    bool operator()(const Head& a, const Head& b) const;
  };
  bool wants(std::uint32_t channel);
  bool mayHold(const ChunkLocation& location);
  void openThose();
  /// Adds the first matching message from `entry` on (in reading direction) to the heads.
  void push(std::uint32_t chunk, const UnpackedChunk& unpacked, std::size_t entry);

  ChunkedSource& source_;
  Query query_;
  ChannelChoice choice_;
  std::unordered_map<std::uint32_t, bool> wanted_;
  std::vector<std::uint32_t> waiting_;  // chunks not opened yet, the next one at the back
  std::priority_queue<Head, std::vector<Head>, Later> heads_;
};

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

bool ChunkCursor::mayHold(const ChunkLocation& location) {
  if (location.first_ns > location.last_ns || location.last_ns < query_.first_ns ||
      location.first_ns > query_.last_ns) {
    return false;
  }
  if (choice_.all() || !location.channels_known) return true;
  return std::any_of(location.shares.begin(), location.shares.end(), [&](const ChannelShare& share) {
    return !source_.channels_.contains(share.channel) || wants(share.channel);
  });
}

void ChunkCursor::push(std::uint32_t chunk, const UnpackedChunk& unpacked, std::size_t entry) {
  const auto& entries = unpacked.entries;
  // Backwards the index before the first one is size_t's highest.
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
    const ChunkLocation& location = source_.chunks_[chunk];
    if (!heads_.empty()) {
      const std::int64_t now = heads_.top().log_ns;
      if (query_.backwards ? location.last_ns < now : location.first_ns > now) return;
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

const ChannelShare* ChunkLocation::shareOf(std::uint32_t channel) const {
  const auto found = std::lower_bound(shares.begin(), shares.end(), ChannelShare{channel}, byChannel);
  return found != shares.end() && found->channel == channel ? &*found : nullptr;
}

ChannelShare& ChunkLocation::share(std::uint32_t channel) {
  const auto found = std::lower_bound(shares.begin(), shares.end(), ChannelShare{channel}, byChannel);
  return found != shares.end() && found->channel == channel ? *found : *shares.insert(found, {channel});
}

void ChunkLocation::forgetTimes() {
  first_ns = 1;
  last_ns = 0;
}

void ChunkLocation::include(std::int64_t time_ns) {
  const bool first = first_ns > last_ns;
  first_ns = first ? time_ns : std::min(first_ns, time_ns);
  last_ns = first ? time_ns : std::max(last_ns, time_ns);
}

Summary ChunkedSource::summary() const {
  Summary summary = about_;
  summary.chunks = std::size_t(
      std::count_if(chunks_.begin(), chunks_.end(), [](const ChunkLocation& chunk) { return !chunk.bare; }));
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
    return;
  }
  channel.metadata = found->second->metadata;  // does not change how messages are read
  if (*found->second != channel) {
    notes_.add(NoteCode::ChannelChanged, offset, channel.topic);
  }
}

void ChunkedSource::addChunk(ChunkLocation location) {
  if (!std::is_sorted(location.shares.begin(), location.shares.end(), byChannel)) {
    std::sort(location.shares.begin(), location.shares.end(), byChannel);
  }
  chunks_.push_back(std::move(location));
  latest_first_.clear();
}

void ChunkedSource::sortChunks() {
  std::sort(chunks_.begin(), chunks_.end(),
            [](const ChunkLocation& a, const ChunkLocation& b) { return a.offset < b.offset; });
  forgetOrder();
}

void ChunkedSource::scanAll(std::uint64_t start) {
  chunks_.clear();
  channels_.clear();
  forgetOrder();
  attachments_.clear();
  metadata_.clear();
  about_.indexed = false;
  about_.counted = true;
  about_.finished = false;
  scanned_to_ = start;
  refresh();
}

bool ChunkedSource::refresh() {
  if (about_.finished) return false;
  const std::uint64_t size = bytes_->size();
  if (size <= about_.bytes) return false;
  const std::uint64_t before = scanned_to_;
  const bool first = about_.bytes == 0;
  notes_.drop(NoteCode::CutOff);
  notes_.drop(NoteCode::NotFinished);
  about_.bytes = size;
  const ChunkLocation* const last = chunks_.empty() ? nullptr : &chunks_.back();
  indexes_follow_ = last != nullptr && !last->bare && last->offset + last->length == scanned_to_;
  scanned_to_ = scan(scanned_to_, size);
  if (scanned_to_ < size) notes_.add(NoteCode::CutOff, scanned_to_);
  if (!about_.finished) notes_.add(NoteCode::NotFinished, size);
  countChunks();
  return !first && scanned_to_ > before;
}

std::uint64_t ChunkedSource::scan(std::uint64_t from, std::uint64_t to) {
  Window window(*bytes_);
  while (from < to) {
    std::uint64_t past = from;
    const Step step = readRecord(window, from, to, past);
    if (step == Step::CutOff) break;
    if (step == Step::DataEnds) {
      settleChunk(false);
      about_.finished = true;
      return to;
    }
    if (step == Step::NoRecord) {
      settleChunk(true);
      past = nextChunk(window, from + 1, to);
      notes_.add(NoteCode::BytesSkipped, from, {}, past - from);
    }
    from = past;
  }
  settleChunk(true);
  return from;
}

void ChunkedSource::addScanned(ChunkLocation location) {
  addChunk(std::move(location));
  indexes_follow_ = true;
}

void ChunkedSource::settleChunk(bool doubtful) {
  if (!std::exchange(indexes_follow_, false)) return;
  ChunkLocation& chunk = chunks_.back();
  if (chunk.channels_known) return;
  chunk.channels_known =
      !chunk.shares.empty() && !doubtful && chunk.first_ns <= chunk.last_ns &&
      std::all_of(chunk.shares.begin(), chunk.shares.end(),
                  [&](const ChannelShare& share) { return channels_.contains(share.channel); });
  if (chunk.channels_known) return;
  // It may lack some or all indexes; its content counts.
  chunk.forgetTimes();
  lookInto(chunks_.size() - 1);
}

void ChunkedSource::addBare(std::uint64_t at, std::uint64_t bytes, std::uint32_t channel,
                            std::int64_t time_ns) {
  const bool goes_on = !chunks_.empty() && chunks_.back().bare &&
                       chunks_.back().offset + chunks_.back().length == at &&
                       chunks_.back().length + bytes <= kMostBare;
  if (!goes_on) {
    ChunkLocation location;
    location.offset = at;
    location.bare = true;
    location.forgetTimes();
    location.channels_known = true;
    addChunk(std::move(location));
  }
  ChunkLocation& last = chunks_.back();
  last.length += bytes;
  last.include(time_ns);
  ++last.share(channel).count;
}

/// Data by chunk number, since the numbers have changed.
void ChunkedSource::forgetOrder() {
  latest_first_.clear();
  held_.clear();
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

std::list<ChunkedSource::Held>::iterator ChunkedSource::heldAt(std::size_t chunk) {
  return std::find_if(held_.begin(), held_.end(), [&](const Held& one) { return one.chunk == chunk; });
}

UnpackedPtr ChunkedSource::unpacked(std::size_t chunk) {
  if (const auto found = heldAt(chunk); found != held_.end()) {
    held_.splice(held_.begin(), held_, found);
    return found->unpacked;
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
  held_bytes_ += bytes;
  while (held_bytes_ > limits_.held_bytes && held_.size() > 1) {
    held_bytes_ -= held_.back().bytes;
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
void ChunkedSource::learn(ChunkLocation& location, const UnpackedChunk& unpacked) {
  const auto& entries = unpacked.entries;
  if (!entries.empty()) {
    const std::int64_t first = entries.front().log_ns;
    const std::int64_t last = entries.back().log_ns;
    if (first < location.first_ns || last > location.last_ns) {
      if (location.first_ns <= location.last_ns) notes_.add(NoteCode::ChunkTimes, location.offset);
      location.first_ns = first;
      location.last_ns = last;
      latest_first_.clear();
    }
  }
  if (location.channels_known) return;
  std::map<std::uint32_t, std::uint64_t> counts;
  for (const ChunkEntry& entry : entries) ++counts[entry.channel];
  std::vector<ChannelShare> shares;
  for (const auto& [channel, count] : counts) shares.push_back({channel, count});
  location.shares = std::move(shares);
  location.channels_known = true;
}

void ChunkedSource::lookInto(std::size_t chunk) {
  chunks_[chunk].channels_known = false;
  if (const auto found = heldAt(chunk); found != held_.end()) {
    learn(chunks_[chunk], *found->unpacked);
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
  channels_in_chunks_.clear();
  about_.start_ns.reset();
  about_.end_ns.reset();
  for (const ChunkLocation& chunk : chunks_) {
    for (const ChannelShare& share : chunk.shares) {
      about_.messages += share.count;
      about_.messages_of[share.channel] += share.count;
    }
    if (chunk.first_ns > chunk.last_ns) continue;
    about_.start_ns = std::min(about_.start_ns.value_or(chunk.first_ns), chunk.first_ns);
    about_.end_ns = std::max(about_.end_ns.value_or(chunk.last_ns), chunk.last_ns);
  }
  for (const auto& [channel, count] : about_.messages_of) channels_in_chunks_.insert(channel);
}

Message ChunkedSource::messageAt(const UnpackedChunk& chunk, const ChunkEntry& entry) const {
  Message message = read(chunk, entry);
  message.channel = channels_.at(entry.channel);
  message.log_time_ns = entry.log_ns;
  message.keeps = chunk.bytes;
  if (isPackedAlone(message)) unpackAlone(message, limits_.most_chunk_bytes);
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

std::vector<std::uint32_t> ChunkedSource::earliestFirst() const {
  std::vector<std::uint32_t> order(chunks_.size());
  for (std::size_t i = 0; i < chunks_.size(); ++i) order[i] = std::uint32_t(i);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tie(chunks_[a].first_ns, a) < std::tie(chunks_[b].first_ns, b);
  });
  return order;
}

template <typename OnFound>
void ChunkedSource::outermost(const std::set<std::uint32_t>& channels, bool backwards, std::int64_t at_ns,
                              OnFound found) {
  Positions best;
  // Those that are in no chunk would keep the walk from ending early.
  std::set<std::uint32_t> missing;
  std::set_intersection(channels.begin(), channels.end(), channels_in_chunks_.begin(),
                        channels_in_chunks_.end(), std::inserter(missing, missing.end()));
  std::int64_t farthest = 0;  // of the best ones
  bool measured = false;
  const auto better = [&](const Position& a, const Position& b) { return backwards ? b < a : a < b; };
  // What is learned below may sort it again.
  const std::vector<std::uint32_t> order = backwards ? latestFirst() : earliestFirst();
  for (const std::uint32_t i : order) {
    const ChunkLocation& location = chunks_[i];
    if (location.first_ns > location.last_ns || (backwards && location.first_ns > at_ns)) continue;
    const std::int64_t edge = backwards ? std::min(location.last_ns, at_ns) : location.first_ns;
    const auto mayImprove = [&](std::uint32_t channel) {
      if (!channels.contains(channel)) return false;
      const auto known = best.find(channel);
      return known == best.end() || !(backwards ? known->second.log_ns > edge : known->second.log_ns < edge);
    };
    if (missing.empty()) {
      if (!std::exchange(measured, true)) {
        farthest = edge;
        for (const auto& [channel, at] : best)
          farthest = backwards ? std::min(farthest, at.log_ns) : std::max(farthest, at.log_ns);
      }
      if (backwards ? farthest > edge : farthest < edge) break;
    }
    std::size_t open = std::numeric_limits<std::size_t>::max();  // channels to be found in this chunk
    if (location.channels_known) {
      open = std::size_t(std::count_if(location.shares.begin(), location.shares.end(),
                                       [&](const ChannelShare& share) { return mayImprove(share.channel); }));
      if (open == 0) continue;
    }
    const UnpackedPtr chunk = unpacked(i);
    const auto& entries = chunk->entries;
    const auto past =
        std::upper_bound(entries.begin(), entries.end(), at_ns,
                         [](std::int64_t time, const ChunkEntry& entry) { return time < entry.log_ns; });
    const std::size_t count = backwards ? std::size_t(past - entries.begin()) : entries.size();
    std::set<std::uint32_t> seen;
    for (std::size_t n = 0; n < count && open > 0; ++n) {
      const std::size_t at = backwards ? count - 1 - n : n;
      const std::uint32_t channel = entries[at].channel;
      if (!mayImprove(channel) || !seen.insert(channel).second) continue;
      --open;
      const Position here{entries[at].log_ns, i, at};
      const auto [known, is_new] = best.try_emplace(channel, here);
      if (!is_new && !better(here, known->second)) continue;
      known->second = here;
      measured = false;
      missing.erase(channel);
      found(channel, here, *chunk);
    }
  }
}

std::map<std::uint32_t, std::int64_t> ChunkedSource::outermostTimes(const std::set<std::uint32_t>& channels,
                                                                    bool last) {
  std::map<std::uint32_t, std::int64_t> times;
  outermost(
      channels, last, std::numeric_limits<std::int64_t>::max(),
      [&](std::uint32_t channel, const Position& at, const UnpackedChunk&) { times[channel] = at.log_ns; });
  return times;
}

std::vector<Packing> ChunkedSource::packing() const {
  std::map<std::string, Packing> by_name;
  for (const ChunkLocation& location : chunks_) {
    const std::optional<Packing> one = location.bare ? std::nullopt : packingOf(location);
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
  std::set<std::uint32_t> wanted;
  for (const auto& [id, channel] : channels_) {
    if (choice.takes(*channel)) wanted.insert(id);
  }
  std::map<std::uint32_t, std::pair<Position, Message>> of_channel;
  outermost(wanted, true, at_ns, [&](std::uint32_t channel, const Position& at, const UnpackedChunk& chunk) {
    of_channel[channel] = {at, messageAt(chunk, chunk.entries[at.entry])};
  });
  // Of channels that share a topic, the one that messages() would give last.
  std::map<std::string, std::pair<Position, Message>> of_topic;
  for (auto& [id, found] : of_channel) {
    auto& held = of_topic[found.second.channel->topic];
    if (!held.second.channel || held.first < found.first) held = std::move(found);
  }
  std::vector<Message> messages;
  messages.reserve(of_topic.size());
  for (auto& [topic, held] : of_topic) messages.push_back(std::move(held.second));
  return messages;
}

bool looksLikeRecording(std::span<const std::uint8_t> start) {
  return looksLikeMcap(start) || looksLikeBag(start);
}

Opened openRecording(std::unique_ptr<Bytes> bytes, const Limits& limits) {
  std::array<std::uint8_t, kLookedAt> start{};
  const auto there =
      std::span(start).first(std::size_t(std::min<std::uint64_t>(start.size(), bytes->size())));
  if (bytes->read(there, 0)) {
    if (looksLikeMcap(there)) return openMcap(std::move(bytes), limits);
    if (looksLikeBag(there)) return openBag(std::move(bytes), limits);
  }
  std::array<std::uint8_t, 60> text{};
  const auto pointer =
      std::span(text).first(std::size_t(std::min<std::uint64_t>(text.size(), bytes->size())));
  const bool is_pointer =
      bytes->read(pointer, 0) &&
      disk::isGitLfsPointer({reinterpret_cast<const char*>(pointer.data()), pointer.size()});
  return tl::unexpected(Failure{is_pointer ? Failure::Code::Pointer : Failure::Code::NotOne, {}});
}

}  // namespace mapwright::recording
