// Scans MCAP record by record.
#include <algorithm>
#include <cstring>
#include <tuple>
#include <utility>

#include "recording/mcap_reader.h"

namespace mapwright::recording {
namespace {

using mcap::Op;

// Bytes of bare records that are read as one chunk.
constexpr std::uint64_t kMostBare = std::uint64_t(1) << 20;

bool isKnownOp(std::uint8_t op) { return op >= std::uint8_t(Op::Header) && op <= std::uint8_t(Op::DataEnd); }

}  // namespace

void McapReader::scanAll() {
  dropAll();
  attachments_.clear();
  metadata_.clear();
  about_.indexed = false;
  about_.counted = true;
  about_.finished = false;
  scanned_to_ = mcap::kMagic.size();
  schemas_.clear();
  refresh();
  // If the index was cut off, nothing says so.
  if (about_.finished && notes_.all().empty()) notes_.add(NoteCode::IndexUnusable, scanned_to_);
}

bool McapReader::refresh() {
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
  if (!about_.finished) {
    if (scanned_to_ < size) notes_.add(NoteCode::CutOff, scanned_to_);
    notes_.add(NoteCode::NotFinished, size);
  }
  countChunks();
  return !first && scanned_to_ > before;
}

std::uint64_t McapReader::scan(std::uint64_t from, std::uint64_t to) {
  Window window(*bytes_);
  while (from < to) {
    const auto start = window.look(from, mcap::kRecordHead, to);
    Step step = Step::CutOff;
    RecordHead head;
    if (start.size() == mcap::kRecordHead) {
      ByteReader in(start);
      const auto op = in.number<std::uint8_t>();
      head = {Op(op), from, in.number<std::uint64_t>()};
      const bool sound = isKnownOp(op) || leadsOn(window, head, to);
      step = !sound ? Step::NoRecord : take(window, head, to);
    }
    if (step == Step::DataEnds) {
      settleChunk(false);
      about_.finished = true;
      return to;
    }
    if (step == Step::CutOff) break;
    if (step == Step::Taken) {
      from = head.end();
      continue;
    }
    settleChunk(true);
    const std::uint64_t next = nextChunk(window, from + 1, to);
    notes_.add(NoteCode::BytesSkipped, from, {}, next - from);
    from = next;
  }
  settleChunk(true);
  return from;
}

bool McapReader::leadsOn(Window& window, const RecordHead& head, std::uint64_t to) {
  if (std::uint8_t(head.op) == 0) return false;
  if (head.length > to - head.content()) return true;  // take() detects whether it was cut off
  ByteReader in(window.look(head.end(), mcap::kRecordHead, to));
  const auto op = in.number<std::uint8_t>();
  const auto length = in.number<std::uint64_t>();
  if (!in.sound()) return true;                  // the file ends here
  if (Op(op) == Op::MessageIndex) return false;  // it was a chunk, so this is damage
  return isKnownOp(op) || (op != 0 && length <= to - head.end() - mcap::kRecordHead);
}

McapReader::Step McapReader::take(Window& window, const RecordHead& head, std::uint64_t to) {
  const bool whole = head.length <= to - head.content();
  if (head.op != Op::MessageIndex) settleChunk(false);
  if (head.op == Op::Chunk) return takeChunk(window, head, to);
  if (!whole) {
    // A length beyond the end belongs to the last, truncated record, or is invalid. An attachment or a
    // message may be large, but not larger than the reading limit.
    const bool may_be_long =
        head.op == Op::Attachment || head.op == Op::Message || head.op == Op::MessageIndex;
    const bool likely =
        may_be_long ? head.length <= limits_.most_chunk_bytes : head.length <= limits_.most_record_bytes;
    return likely && nextChunk(window, head.at + 1, to) == to ? Step::CutOff : Step::NoRecord;
  }
  switch (head.op) {
    case Op::Message:
      return takeMessage(window, head);
    case Op::MessageIndex:
      return takeIndex(window, head);
    case Op::Attachment:
      return takeAttachment(window, head);
    case Op::Header:
    case Op::Schema:
    case Op::Channel:
    case Op::Metadata:
      return takeSmall(head);
    case Op::DataEnd:
      return head.length >= 4 && head.length <= 64 ? Step::DataEnds : Step::NoRecord;
    case Op::Footer:
      return head.length == mcap::kFooterContent ? Step::DataEnds : Step::NoRecord;
    default:
      return Step::Taken;  // part of a summary, or private
  }
}

McapReader::Step McapReader::takeChunk(Window& window, const RecordHead& head, std::uint64_t to) {
  const auto content = window.look(
      head.content(), std::size_t(std::min<std::uint64_t>(head.length, mcap::kMostChunkHead)), to);
  const std::optional<mcap::ChunkHead> chunk = mcap::chunkHeadIn(content, head.length);
  if (!chunk) {
    const bool all = content.size() == std::min<std::uint64_t>(head.length, mcap::kMostChunkHead);
    return all ? Step::NoRecord : Step::CutOff;
  }
  if (head.length > to - head.content()) {
    // Truncated, if both of its lengths agree; otherwise one of them is wrong.
    return chunk->records_at + chunk->records_size == head.length ? Step::CutOff : Step::NoRecord;
  }
  ChunkPlace place;
  place.offset = head.at;
  place.length = head.end() - head.at;
  place.first_ns = mcap::timeOf(chunk->start);
  place.last_ns = mcap::timeOf(chunk->end);
  if (!mcap::isTime(chunk->end)) {  // it will be unpacked
    place.first_ns = 1;
    place.last_ns = 0;
  }
  addChunk(std::move(place));
  indexes_follow_ = true;
  return Step::Taken;
}

McapReader::Step McapReader::takeIndex(Window& window, const RecordHead& head) {
  ByteReader in(window.look(head.content(), 6, head.end()));
  const auto channel = in.number<std::uint16_t>();
  const auto bytes = in.number<std::uint32_t>();
  if (!in.sound() || std::uint64_t(bytes) + 6 > head.length) return Step::NoRecord;
  ChunkPlace* const chunk = lastChunk();
  if (!indexes_follow_ || chunk == nullptr || bytes == 0) return Step::Taken;
  const auto at = std::lower_bound(
      chunk->shares.begin(), chunk->shares.end(), channel,
      [](const ChannelShare& share, std::uint16_t wanted) { return share.channel < wanted; });
  const ChannelShare share{channel, head.at, bytes / 16};
  if (at == chunk->shares.end() || at->channel != channel) {
    chunk->shares.insert(at, share);
  } else if (at->index_offset == 0) {
    at->index_offset = head.at;  // it was counted when the file ended here
  }
  return Step::Taken;
}

void McapReader::settleChunk(bool doubtful) {
  if (!std::exchange(indexes_follow_, false)) return;
  ChunkPlace& chunk = *lastChunk();
  if (chunk.channels_known) return;
  const bool known = std::all_of(chunk.shares.begin(), chunk.shares.end(),
                                 [&](const ChannelShare& share) { return knowsChannel(share.channel); });
  if (!chunk.shares.empty() && known && !doubtful && chunk.first_ns <= chunk.last_ns) {
    chunk.channels_known = true;
    return;
  }
  // It may lack some or all indexes; its content counts.
  chunk.first_ns = 1;
  chunk.last_ns = 0;
  lookInto(std::size_t(&chunk - chunks().data()));
}

McapReader::Step McapReader::takeMessage(Window& window, const RecordHead& head) {
  ByteReader in(window.look(head.content(), mcap::kMessageHead, head.end()));
  const auto channel = in.number<std::uint16_t>();
  in.number<std::uint32_t>();
  const auto stamp = in.number<std::uint64_t>();
  const std::int64_t time = mcap::timeOf(stamp);
  in.number<std::uint64_t>();
  if (!in.sound()) return Step::NoRecord;
  if (!mcap::isTime(stamp)) {
    notes_.add(NoteCode::TimeUnusable, head.at);
    return Step::Taken;
  }
  ChunkPlace* last = lastChunk();
  const std::uint64_t bytes = head.end() - head.at;
  const bool goes_on = last != nullptr && last->bare && last->offset + last->length == head.at &&
                       last->length + bytes <= kMostBare;
  if (!goes_on) {
    ChunkPlace place;
    place.offset = head.at;
    place.bare = true;
    place.first_ns = place.last_ns = time;
    place.channels_known = true;
    addChunk(std::move(place));
    last = lastChunk();
  }
  last->length += bytes;
  last->first_ns = std::min(last->first_ns, time);
  last->last_ns = std::max(last->last_ns, time);
  const auto at = std::lower_bound(
      last->shares.begin(), last->shares.end(), channel,
      [](const ChannelShare& share, std::uint16_t wanted) { return share.channel < wanted; });
  if (at != last->shares.end() && at->channel == channel) {
    ++at->count;
  } else {
    last->shares.insert(at, {channel, 0, 1});
  }
  return Step::Taken;
}

McapReader::Step McapReader::takeAttachment(Window& window, const RecordHead& head) {
  // Names are short; one that does not fit into the window is ignored.
  ByteReader in(window.look(
      head.content(), std::size_t(std::min<std::uint64_t>(head.length, Window::kMostInView)), head.end()));
  AttachmentPlace place;
  place.offset = head.at;
  place.log_time_ns = mcap::timeOf(in.number<std::uint64_t>());
  place.create_time_ns = mcap::timeOf(in.number<std::uint64_t>());
  place.name = in.text();
  place.media_type = in.text();
  place.size = in.number<std::uint64_t>();
  if (!in.sound() || place.size > head.length) return Step::NoRecord;
  attachments_.push_back(std::move(place));
  return Step::Taken;
}

McapReader::Step McapReader::takeSmall(const RecordHead& head) {
  if (head.length > limits_.most_record_bytes) {
    notes_.add(NoteCode::RecordTooLarge, head.at);
    return Step::Taken;
  }
  const std::optional<UnpackedChunk> content = raw(head.content(), head.length);
  if (!content) return Step::CutOff;
  if (head.op == Op::Schema) {
    takeSchema(content->all(), head.at);
  } else if (head.op == Op::Channel) {
    takeChannel(content->all(), head.at);
  } else if (head.op == Op::Header) {
    const auto header = mcap::headerIn(content->all());
    if (!header) return Step::NoRecord;
    std::tie(about_.profile, about_.library) = *header;
  } else if (auto metadata = mcap::metadataIn(content->all())) {
    metadata_.push_back(std::move(*metadata));
  } else {
    return Step::NoRecord;
  }
  return Step::Taken;
}

std::uint64_t McapReader::nextChunk(Window& window, std::uint64_t from, std::uint64_t to) const {
  constexpr std::size_t kStart = mcap::kRecordHead + mcap::kMostChunkHead;
  while (from < to) {
    const auto view = window.rest(from, kStart, to);
    if (view.empty()) return to;
    const void* const found = std::memchr(view.data(), int(Op::Chunk), view.size());
    if (found == nullptr) {
      from += view.size();
      continue;
    }
    from += std::uint64_t(static_cast<const std::uint8_t*>(found) - view.data());
    ByteReader in(window.look(from, kStart, to));
    in.number<std::uint8_t>();
    const auto length = in.number<std::uint64_t>();
    const auto content = in.take(std::min<std::uint64_t>(in.left(), length));
    const std::optional<mcap::ChunkHead> head = mcap::chunkHeadIn(content, length);
    const bool known =
        head && (head->compression.empty() || head->compression == "zstd" || head->compression == "lz4");
    if (known && head->records_at + head->records_size == length && length <= to - from - mcap::kRecordHead &&
        head->start <= head->end) {
      return from;
    }
    ++from;
  }
  return to;
}

}  // namespace mapwright::recording
