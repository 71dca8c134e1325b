// Opens MCAP by its summary section.
#include <algorithm>
#include <array>

#include "packed/codec.h"
#include "recording/mcap_reader.h"

namespace mapwright::recording {

using mcap::Op;

std::optional<mcap::Footer> McapReader::findFooter(std::uint64_t size) const {
  std::array<std::uint8_t, mcap::kFooterRecord + mcap::kMagic.size()> end{};
  if (size < mcap::kMagic.size() + end.size() || !bytes_->read(end, size - end.size())) return std::nullopt;
  const auto magic = std::span(end).last(mcap::kMagic.size());
  if (!std::equal(magic.begin(), magic.end(), mcap::kMagic.begin())) return std::nullopt;
  ByteReader in(std::span<const std::uint8_t>(end).first(mcap::kFooterRecord));
  const auto op = in.number<std::uint8_t>();
  const auto length = in.number<std::uint64_t>();
  if (op != std::uint8_t(Op::Footer) || length != mcap::kFooterContent) return std::nullopt;
  return mcap::footerIn(in.take(in.left()));
}

/// The summary and the first fields of the footer.
bool McapReader::sumFits(const mcap::Footer& footer, std::uint64_t footer_at) const {
  if (footer.summary_crc == 0) return true;
  const std::uint64_t end = footer_at + mcap::kFooterRecord - sizeof footer.summary_crc;
  Window window(*bytes_);
  std::uint32_t crc = 0;
  for (std::uint64_t at = footer.summary_start; at < end;) {
    const auto piece = window.look(at, Window::kMostInView, end);
    if (piece.empty()) return false;
    crc = packed::crc32(crc, piece);
    at += piece.size();
  }
  return crc == footer.summary_crc;
}

bool McapReader::openByIndex(const mcap::Footer& footer, std::uint64_t footer_at) {
  const auto unusable = [&] {
    notes_.add(NoteCode::IndexUnusable, footer.summary_start);
    return false;
  };
  if (footer.summary_start == 0) {
    notes_.add(NoteCode::NoIndex, footer_at);
    return false;
  }
  const std::uint64_t start = footer.summary_start;
  const std::uint64_t end = footer.summary_offset_start == 0 ? footer_at : footer.summary_offset_start;
  if (start < mcap::kMagic.size() || start > end || end > footer_at || !sumFits(footer, footer_at))
    return unusable();
  if (footer_at - start > 16 * limits_.most_record_bytes) return unusable();
  const std::optional<UnpackedChunk> summary = raw(start, end - start);
  if (!summary) return unusable();

  std::vector<mcap::ChunkIndex> indexes;
  std::optional<mcap::Statistics> statistics;
  ByteReader in(summary->all());
  while (in.left() > 0) {
    const std::uint64_t at = start + summary->size - in.left();
    const auto op = Op(in.number<std::uint8_t>());
    const auto content = in.take(in.number<std::uint64_t>());
    if (!in.sound()) return unusable();
    if (op == Op::Schema) {
      takeSchema(content, at);
    } else if (op == Op::Channel) {
      takeChannel(content, at);
    } else if (op == Op::Statistics) {
      statistics = mcap::statisticsIn(content);
    } else if (op == Op::ChunkIndex) {
      std::optional<mcap::ChunkIndex> index = mcap::chunkIndexIn(content);
      if (!index) return unusable();
      indexes.push_back(std::move(*index));
    }
  }
  if (indexes.empty() && (!statistics || statistics->messages != 0)) {
    notes_.add(NoteCode::NoIndex, start);
    return false;
  }
  if (!takeChunkIndexes(indexes, start)) return unusable();
  lookBetween(start);
  findChannels();
  for (std::size_t i = 0; i < chunks().size(); ++i) {
    if (chunks()[i].first_ns > chunks()[i].last_ns) lookInto(i);
  }
  about_.bytes = bytes_->size();
  countChunks();
  const auto uncounted = [](const ChannelShare& share) { return share.count == 0; };
  about_.counted = std::none_of(chunks().begin(), chunks().end(), [&](const ChunkPlace& chunk) {
    return std::any_of(chunk.shares.begin(), chunk.shares.end(), uncounted);
  });
  if (about_.counted) return true;
  about_.messages_of.clear();
  about_.messages = statistics ? statistics->messages : 0;
  about_.counted = statistics && (!statistics->messages_of.empty() || statistics->messages == 0);
  if (!about_.counted) return true;
  for (const auto& [channel, count] : statistics->messages_of) about_.messages_of[channel] = count;
  return true;
}

bool McapReader::takeChunkIndexes(std::vector<mcap::ChunkIndex>& indexes, std::uint64_t data_end) {
  std::sort(indexes.begin(), indexes.end(), [](const auto& a, const auto& b) { return a.offset < b.offset; });
  std::uint64_t past = mcap::kMagic.size();
  for (const mcap::ChunkIndex& index : indexes) {
    if (index.offset < past || index.offset > data_end || index.length < mcap::kRecordHead + 40 ||
        index.length > data_end - index.offset ||
        index.index_length > data_end - index.offset - index.length) {
      return false;
    }
    past = index.offset + index.length + index.index_length;
    for (const auto& [channel, offset] : index.index_offsets) {
      if (offset < index.offset + index.length || offset >= past) return false;
    }
  }
  for (const mcap::ChunkIndex& index : indexes) {
    ChunkPlace place;
    place.offset = index.offset;
    place.length = index.length;
    place.first_ns = mcap::timeOf(index.start);
    place.last_ns = mcap::timeOf(index.end);
    place.channels_known = !index.index_offsets.empty();
    // A chunk without messages, or without indexes, may state 0 and 0.
    if (place.first_ns > place.last_ns || !mcap::isTime(index.end) ||
        (!place.channels_known && index.start == 0 && index.end == 0)) {
      place.channels_known = false;
      place.first_ns = 1;
      place.last_ns = 0;
    }
    place.shares.reserve(index.index_offsets.size());
    for (const auto& [channel, offset] : index.index_offsets) place.shares.push_back({channel, offset, 0});
    addChunk(std::move(place));
  }
  // Where the next thing after each chunk is expected: lookBetween() needs it.
  gaps_.clear();
  past = mcap::kMagic.size();
  for (const mcap::ChunkIndex& index : indexes) {
    if (index.offset > past) gaps_.emplace_back(past, index.offset);
    past = index.offset + index.length + index.index_length;
  }
  if (past < data_end) gaps_.emplace_back(past, data_end);
  return true;
}

/// Attachments, metadata and anything else outside the indexed chunks.
void McapReader::lookBetween(std::uint64_t data_end) {
  const std::size_t indexed = chunks().size();
  for (const auto& [from, to] : gaps_) {
    const std::uint64_t read = scan(from, to);
    if (read < to) notes_.add(NoteCode::BytesSkipped, read, {}, to - read);
  }
  gaps_.clear();
  if (chunks().size() != indexed) sortChunks();
  scanned_to_ = data_end;
}

}  // namespace mapwright::recording
