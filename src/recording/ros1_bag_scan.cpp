// Opens bags: by their index, or record by record.
#include <algorithm>
#include <cstring>
#include <utility>

#include "recording/ros1_bag.h"

namespace mapwright::recording {

namespace {
constexpr std::uint64_t kMostScannedBare = std::uint64_t(1) << 20;
}

std::optional<ChunkPlace> Ros1Bag::infoIn(const Head& head) const {
  const bag::Fields fields = head.fields();
  const auto offset = fields.number<std::uint64_t>("chunk_pos");
  const auto first = fields.time("start_time");
  const auto last = fields.time("end_time");
  if (fields.number<std::uint32_t>("ver") != 1u || !offset || !first || !last) return std::nullopt;
  if (*offset < start_ || *offset >= index_at_ || head.data_size > limits_.most_record_bytes)
    return std::nullopt;
  const std::optional<UnpackedChunk> rows = raw(head.data_at, head.data_size);
  if (!rows) return std::nullopt;
  ChunkPlace place;
  place.offset = *offset;
  place.first_ns = *first;
  place.last_ns = *last;
  place.channels_known = true;
  ByteReader row(rows->all());
  while (row.left() >= 8) {
    ChannelShare share;
    share.channel = row.number<std::uint32_t>();
    share.count = row.number<std::uint32_t>();
    share.index_offset = *offset;  // behind it
    if (share.count > 0) place.shares.push_back(share);
  }
  if (place.shares.empty()) {
    place.first_ns = 1;
    place.last_ns = 0;
  }
  return place;
}

bool Ros1Bag::openByIndex() {
  const std::uint64_t size = bytes_->size();
  const auto unusable = [&] {
    notes_.add(NoteCode::IndexUnusable, index_at_);
    return false;
  };
  if (index_at_ == 0) return false;  // the scan finds out whether it is finished
  if (index_at_ < start_ || index_at_ > size) return unusable();
  Window window(*bytes_);
  std::vector<ChunkPlace> places;
  std::uint32_t connections = 0;
  for (std::uint64_t at = index_at_; at < size;) {
    bool cut = false;
    const std::optional<Head> head = headAt(window, at, size, cut);
    if (!head) return unusable();
    if (head->op == bag::Op::Connection) {
      if (takeConnection(*head) != Step::Taken) return unusable();
      ++connections;
    } else if (head->op == bag::Op::ChunkInfo) {
      std::optional<ChunkPlace> place = infoIn(*head);
      if (!place) return unusable();
      places.push_back(std::move(*place));
    }
    at = head->end();
  }
  if (places.size() != chunk_count_ || connections != connections_) return unusable();
  std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.offset < b.offset; });
  const auto twice = [](const ChunkPlace& a, const ChunkPlace& b) { return a.offset == b.offset; };
  if (std::adjacent_find(places.begin(), places.end(), twice) != places.end()) return unusable();
  for (ChunkPlace& place : places) addChunk(std::move(place));
  about_.bytes = size;
  findChannels();
  countChunks();
  return true;
}

void Ros1Bag::scanAll() {
  dropAll();
  about_.indexed = false;
  about_.finished = false;
  scanned_to_ = start_;
  refresh();
}

bool Ros1Bag::refresh() {
  if (about_.finished) return false;
  const std::uint64_t size = bytes_->size();
  if (size <= about_.bytes) return false;
  const std::uint64_t before = scanned_to_;
  const bool first = about_.bytes == 0;
  notes_.drop(NoteCode::CutOff);
  notes_.drop(NoteCode::NotFinished);
  about_.bytes = size;
  const ChunkPlace* const last = lastChunk();
  indexes_follow_ = last != nullptr && !last->bare && last->offset + last->length == scanned_to_;
  scanned_to_ = scan(scanned_to_, size);
  if (scanned_to_ < size) notes_.add(NoteCode::CutOff, scanned_to_);
  if (!about_.finished) notes_.add(NoteCode::NotFinished, size);
  countChunks();
  return !first && scanned_to_ > before;
}

std::uint64_t Ros1Bag::scan(std::uint64_t from, std::uint64_t to) {
  Window window(*bytes_);
  while (from < to) {
    bool cut = false;
    const std::optional<Head> head = headAt(window, from, to, cut);
    if (head && (head->op != bag::Op::Index || !indexes_follow_)) settleChunk(false);
    const Step step = head ? take(*head) : Step::NoRecord;
    if (step == Step::Taken) {
      from = head->end();
      continue;
    }
    settleChunk(true);
    const std::uint64_t next = nextChunk(window, from + 1, to);
    if ((cut || step == Step::CutOff) && next == to) break;
    notes_.add(NoteCode::BytesSkipped, from, {}, next - from);
    from = next;
  }
  settleChunk(true);
  return from;
}

Ros1Bag::Step Ros1Bag::take(const Head& head) {
  switch (head.op) {
    case bag::Op::Message:
      return takeMessage(head);
    case bag::Op::Index:
      return takeIndex(head);
    case bag::Op::Connection:
      return takeConnection(head);
    case bag::Op::Chunk: {
      ChunkPlace place;
      place.offset = head.at;
      place.length = head.end() - head.at;
      place.first_ns = 1;  // known from its indexes, or its content
      addChunk(std::move(place));
      indexes_follow_ = true;
      return Step::Taken;
    }
    case bag::Op::ChunkInfo:
      about_.finished = true;  // this is written last
      return Step::Taken;
    case bag::Op::BagHeader:
      return Step::Taken;
  }
  return Step::NoRecord;
}

Ros1Bag::Step Ros1Bag::takeConnection(const Head& head) {
  if (head.data_size > limits_.most_record_bytes) {
    notes_.add(NoteCode::RecordTooLarge, head.at);
    return Step::Taken;
  }
  const std::optional<UnpackedChunk> data = raw(head.data_at, head.data_size);
  if (!data) return Step::CutOff;
  std::optional<Channel> channel = bag::channelIn({head.fields(), data->all()});
  if (!channel) return Step::NoRecord;
  addChannel(std::move(*channel), head.at);
  return Step::Taken;
}

Ros1Bag::Step Ros1Bag::takeIndex(const Head& head) {
  const bag::Fields fields = head.fields();
  const auto channel = fields.number<std::uint32_t>("conn");
  const auto count = fields.number<std::uint32_t>("count");
  if (!channel || !count || fields.number<std::uint32_t>("ver") != 1u) return Step::NoRecord;
  if (std::uint64_t(*count) * 12 != head.data_size) return Step::NoRecord;
  ChunkPlace* const chunk = lastChunk();
  if (!indexes_follow_ || chunk == nullptr || *count == 0) return Step::Taken;
  const auto at = std::lower_bound(
      chunk->shares.begin(), chunk->shares.end(), *channel,
      [](const ChannelShare& share, std::uint32_t wanted) { return share.channel < wanted; });
  if (at != chunk->shares.end() && at->channel == *channel) {
    at->index_offset = chunk->offset;
    return Step::Taken;
  }
  if (head.data_size > limits_.most_record_bytes) return Step::Taken;  // it will be unpacked
  const std::optional<UnpackedChunk> rows = raw(head.data_at, head.data_size);
  if (!rows) return Step::CutOff;
  chunk->shares.insert(at, {*channel, chunk->offset, *count});
  ByteReader row(rows->all());
  while (row.left() >= 12) {
    const std::int64_t time = bag::timeOf(row.number<std::uint64_t>());
    row.number<std::uint32_t>();
    const bool first = chunk->first_ns > chunk->last_ns;
    chunk->first_ns = first ? time : std::min(chunk->first_ns, time);
    chunk->last_ns = first ? time : std::max(chunk->last_ns, time);
  }
  return Step::Taken;
}

void Ros1Bag::settleChunk(bool doubtful) {
  if (!std::exchange(indexes_follow_, false)) return;
  ChunkPlace& chunk = *lastChunk();
  if (chunk.channels_known) return;
  const bool known = std::all_of(chunk.shares.begin(), chunk.shares.end(),
                                 [&](const ChannelShare& share) { return knowsChannel(share.channel); });
  if (!chunk.shares.empty() && known && !doubtful) {
    chunk.channels_known = true;
    return;
  }
  chunk.first_ns = 1;
  chunk.last_ns = 0;
  lookInto(std::size_t(&chunk - chunks().data()));
}

/// Messages outside of chunks: nobody writes them, but the format allows it.
Ros1Bag::Step Ros1Bag::takeMessage(const Head& head) {
  const bag::Fields fields = head.fields();
  const auto channel = fields.number<std::uint32_t>("conn");
  const auto time = fields.time("time");
  if (!channel || !time) return Step::NoRecord;
  ChunkPlace* last = lastChunk();
  const std::uint64_t bytes = head.end() - head.at;
  const bool goes_on = last != nullptr && last->bare && last->offset + last->length == head.at &&
                       last->length + bytes <= kMostScannedBare;
  if (!goes_on) {
    ChunkPlace place;
    place.offset = head.at;
    place.bare = true;
    place.first_ns = place.last_ns = *time;
    place.channels_known = true;
    addChunk(std::move(place));
    last = lastChunk();
  }
  last->length += bytes;
  last->first_ns = std::min(last->first_ns, *time);
  last->last_ns = std::max(last->last_ns, *time);
  const auto at = std::lower_bound(
      last->shares.begin(), last->shares.end(), *channel,
      [](const ChannelShare& share, std::uint32_t wanted) { return share.channel < wanted; });
  if (at != last->shares.end() && at->channel == *channel) {
    ++at->count;
  } else {
    last->shares.insert(at, {*channel, 0, 1});
  }
  return Step::Taken;
}

/// A header of three fields, "compression", "op" and "size", in any order.
std::uint64_t Ros1Bag::nextChunk(Window& window, std::uint64_t from, std::uint64_t to) const {
  constexpr std::size_t kStart = 256;
  while (from < to) {
    const auto view = window.rest(from, kStart, to);
    if (view.empty()) return to;
    // The length of such a header is below 256, so its second and later bytes are zero.
    const std::string_view text = ByteReader::textOf(view);
    const std::size_t zeros = text.find(std::string_view("\0\0\0", 3));
    if (zeros == std::string_view::npos) {
      from += view.size() > 2 && from + view.size() < to ? view.size() - 2 : view.size();
      continue;
    }
    if (zeros == 0) {
      ++from;
      continue;
    }
    from += zeros - 1;
    bool cut = false;
    const std::optional<Head> head = headAt(window, from, to, cut);
    if (head && head->op == bag::Op::Chunk && head->fields().number<std::uint32_t>("size") &&
        head->fields().find("compression")) {
      return from;
    }
    ++from;
  }
  return to;
}

}  // namespace mapwright::recording
