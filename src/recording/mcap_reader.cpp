// Reads MCAP, version 0. Source: MCAP format specification.
// A file with an index is opened by the index; everything between its chunks is scanned, so messages outside
// of chunks are found, too. A file without an index, or with a damaged one, is scanned from start to end:
// chunks are unpacked only if their message indexes do not tell what they contain. After invalid bytes,
// reading continues with the next intact chunk.
#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <utility>

#include "packed/codec.h"
#include "recording/chunked_source.h"
#include "recording/mcap_records.h"

namespace mapwright::recording {
namespace {

using mcap::Op;

bool isKnownOp(std::uint8_t op) { return op >= std::uint8_t(Op::Header) && op <= std::uint8_t(Op::DataEnd); }

/// A record of the file, without its content.
struct McapRecord {
  Op op = Op::Header;
  std::uint64_t at = 0;
  std::uint64_t length = 0;  // of its content
  std::uint64_t content() const { return at + mcap::kRecordHead; }
  std::uint64_t end() const { return content() + length; }
};

class McapReader final : public ChunkedSource {
 public:
  using ChunkedSource::ChunkedSource;

  std::string format() const override { return "MCAP"; }
  std::optional<Attachment> attachment(const AttachmentLocation& location) override;

  void open() {
    const std::uint64_t size = bytes_->size();
    const std::optional<mcap::Footer> footer = findFooter(size);
    if (footer && openByIndex(*footer, size - mcap::kMagic.size() - mcap::kFooterRecord)) return;
    schemas_.clear();
    scanAll(mcap::kMagic.size());
    noteWhatFollows(size);
    // If the index was cut off, nothing says so.
    if (about_.finished && notes_.all().empty()) notes_.add(NoteCode::IndexUnusable, scanned_to_);
  }

 protected:
  std::optional<Packing> packingOf(const ChunkLocation& location) const override;
  tl::expected<UnpackedChunk, Note> unpack(const ChunkLocation& location) override;
  Message read(const UnpackedChunk& chunk, const ChunkEntry& entry) const override;
  Step readRecord(Window& window, std::uint64_t from, std::uint64_t to, std::uint64_t& past) override;
  std::uint64_t nextChunk(Window& window, std::uint64_t from, std::uint64_t to) const override;

 private:
  std::optional<mcap::Footer> findFooter(std::uint64_t size) const;
  /// False: there is no usable index, which is noted.
  bool openByIndex(const mcap::Footer& footer, std::uint64_t footer_at);
  bool sumFits(const mcap::Footer& footer, std::uint64_t footer_at) const;
  bool readChunkIndexes(std::vector<mcap::ChunkIndex>& indexes, std::uint64_t data_end);

  /// After a scan: what lies behind the end, such as another file.
  void noteWhatFollows(std::uint64_t size);
  Step handleRecord(Window& window, const McapRecord& record, std::uint64_t to);
  Step readChunk(Window& window, const McapRecord& record, std::uint64_t to);
  Step readMessage(Window& window, const McapRecord& record);
  Step readIndex(Window& window, const McapRecord& record);
  Step readAttachment(Window& window, const McapRecord& record);
  Step readSmall(const McapRecord& record);
  void readSchema(std::span<const std::uint8_t> content, std::uint64_t at);
  void readChannel(std::span<const std::uint8_t> content, std::uint64_t at);
  void add(mcap::ChannelRecord record, std::uint64_t at);
  /// Of the messages that the statistics count.
  void noteMissing(std::uint64_t stated);
  void listRecords(UnpackedChunk& chunk, const ChunkLocation& location);

  std::map<std::uint16_t, mcap::Schema> schemas_;
  std::uint64_t data_end_ = 0;  // where the scan ended; 0: not at the end of the data
};

void McapReader::noteWhatFollows(std::uint64_t size) {
  Window window(*bytes_);
  for (std::uint64_t at = data_end_; at != 0 && at < size;) {
    ByteReader in(window.look(at, mcap::kRecordHead, size));
    const auto op = Op(in.number<std::uint8_t>());
    const auto length = in.number<std::uint64_t>();
    if (!in.sound() || length > size - at - mcap::kRecordHead) return;
    at += mcap::kRecordHead + length;
    if (op != Op::Footer) continue;
    at += mcap::kMagic.size();
    if (at < size) notes_.add(NoteCode::BytesSkipped, at, {}, size - at);
    return;
  }
}

std::optional<mcap::Footer> McapReader::findFooter(std::uint64_t size) const {
  std::array<std::uint8_t, mcap::kFooterRecord + mcap::kMagic.size()> end{};
  if (size < mcap::kMagic.size() + end.size() || !bytes_->read(end, size - end.size())) return std::nullopt;
  const auto magic = std::span(end).last(mcap::kMagic.size());
  if (!std::equal(magic.begin(), magic.end(), mcap::kMagic.begin())) return std::nullopt;
  ByteReader in(std::span<const std::uint8_t>(end).first(mcap::kFooterRecord));
  const auto op = in.number<std::uint8_t>();
  const auto length = in.number<std::uint64_t>();
  if (op != std::uint8_t(Op::Footer) || length != mcap::kFooterContent) return std::nullopt;
  return mcap::read<mcap::Footer>(in.rest());
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
  std::vector<std::pair<mcap::ChannelRecord, std::uint64_t>> without_schema;
  std::optional<mcap::Statistics> statistics;
  ByteReader in(summary->all());
  while (in.left() > 0) {
    const std::uint64_t at = start + summary->size - in.left();
    const auto op = Op(in.number<std::uint8_t>());
    const auto content = in.take(in.number<std::uint64_t>());
    if (!in.sound()) return unusable();
    if (op == Op::Schema) {
      readSchema(content, at);
    } else if (op == Op::Channel) {
      auto channel = mcap::read<mcap::ChannelRecord>(content);
      if (channel && channel->schema_id != 0 && !schemas_.contains(channel->schema_id)) {
        without_schema.emplace_back(std::move(*channel), at);
      } else {
        readChannel(content, at);
      }
    } else if (op == Op::Statistics) {
      statistics = mcap::read<mcap::Statistics>(content);
    } else if (op == Op::ChunkIndex) {
      auto index = mcap::read<mcap::ChunkIndex>(content);
      if (!index) return unusable();
      indexes.push_back(std::move(*index));
    }
  }
  if (indexes.empty() && (!statistics || statistics->messages != 0)) {
    notes_.add(NoteCode::NoIndex, start);
    return false;
  }
  if (!readChunkIndexes(indexes, start)) return unusable();
  findChannels();
  // The chunks have described those whose schemas only they hold.
  const auto known = channels();
  for (auto& [channel, at] : without_schema) {
    const auto isIt = [id = channel.id](const ChannelPtr& one) { return one->id == id; };
    if (std::none_of(known.begin(), known.end(), isIt)) add(std::move(channel), at);
  }
  for (std::size_t i = 0; i < chunks().size(); ++i) {
    if (chunks()[i].first_ns > chunks()[i].last_ns) lookInto(i);
  }
  about_.bytes = bytes_->size();
  countChunks();
  const auto uncounted = [](const ChannelShare& share) { return share.count == 0; };
  about_.counted = std::none_of(chunks().begin(), chunks().end(), [&](const ChunkLocation& chunk) {
    return std::any_of(chunk.shares.begin(), chunk.shares.end(), uncounted);
  });
  if (!about_.counted) {
    about_.messages_of.clear();
    about_.messages = statistics ? statistics->messages : 0;
    about_.counted = statistics && (!statistics->messages_of.empty() || statistics->messages == 0);
    if (!about_.counted) return true;
    about_.messages = 0;
    for (const auto& [channel, count] : statistics->messages_of) {
      about_.messages_of[channel] = count;
      about_.messages += count;
    }
  }
  if (statistics) noteMissing(statistics->messages);
  return true;
}

void McapReader::noteMissing(std::uint64_t stated) {
  std::uint64_t found = 0;
  for (const ChannelPtr& channel : channels()) {
    const auto of = about_.messages_of.find(channel->id);
    if (of != about_.messages_of.end()) found += of->second;
  }
  for (const Note& note : notes_.all()) {
    if (note.code == NoteCode::UnknownChannel || note.code == NoteCode::TimeUnusable) found += note.count;
  }
  if (stated > found) notes_.add(NoteCode::MessagesMissing, 0, {}, stated - found);
}

/// Also scans what lies between the chunks: attachments, metadata, and messages outside of any chunk.
bool McapReader::readChunkIndexes(std::vector<mcap::ChunkIndex>& indexes, std::uint64_t data_end) {
  std::sort(indexes.begin(), indexes.end(), [](const auto& a, const auto& b) { return a.offset < b.offset; });
  std::vector<std::pair<std::uint64_t, std::uint64_t>> gaps;
  std::uint64_t past = mcap::kMagic.size();
  for (const mcap::ChunkIndex& index : indexes) {
    if (index.offset < past || index.offset > data_end || index.length < mcap::kRecordHead + 40 ||
        index.length > data_end - index.offset ||
        index.index_length > data_end - index.offset - index.length) {
      return false;
    }
    if (index.offset > past) gaps.emplace_back(past, index.offset);
    past = index.offset + index.length + index.index_length;
    for (const auto& [channel, offset] : index.index_offsets) {
      if (offset < index.offset + index.length || offset >= past) return false;
    }
  }
  if (past < data_end) gaps.emplace_back(past, data_end);
  for (const mcap::ChunkIndex& index : indexes) {
    ChunkLocation location;
    location.offset = index.offset;
    location.length = index.length;
    location.first_ns = mcap::timeOf(index.start);
    location.last_ns = mcap::timeOf(index.end);
    location.channels_known = !index.index_offsets.empty();
    // A chunk without messages, or without indexes, may state 0 and 0; some writers state nothing else.
    if (location.first_ns > location.last_ns || !mcap::isTime(index.end) ||
        (index.start == 0 && index.end == 0)) {
      location.channels_known = false;
      location.forgetTimes();
    }
    location.shares.reserve(index.index_offsets.size());
    for (const auto& [channel, offset] : index.index_offsets) location.shares.push_back({channel, 0});
    addChunk(std::move(location));
  }
  for (const auto& [from, to] : gaps) {
    const std::uint64_t read = scan(from, to);
    if (read < to) notes_.add(NoteCode::BytesSkipped, read, {}, to - read);
  }
  if (chunks().size() != indexes.size()) sortChunks();
  scanned_to_ = data_end;
  return true;
}

void McapReader::readSchema(std::span<const std::uint8_t> content, std::uint64_t at) {
  auto schema = mcap::read<mcap::Schema>(content);
  if (!schema || schema->id == 0) {
    notes_.add(NoteCode::RecordCorrupt, at);
    return;
  }
  const std::uint16_t id = schema->id;
  schemas_.emplace(id, std::move(*schema));
}

void McapReader::readChannel(std::span<const std::uint8_t> content, std::uint64_t at) {
  auto record = mcap::read<mcap::ChannelRecord>(content);
  if (!record) {
    notes_.add(NoteCode::RecordCorrupt, at);
    return;
  }
  add(std::move(*record), at);
}

void McapReader::add(mcap::ChannelRecord record, std::uint64_t at) {
  const auto schema = schemas_.find(record.schema_id);
  const mcap::Schema of = schema == schemas_.end() ? mcap::Schema() : schema->second;
  addChannel({record.id, std::move(record.topic), std::move(record.message_encoding), of.name, of.encoding,
              of.data, std::move(record.metadata)},
             at);
}

tl::expected<UnpackedChunk, Note> McapReader::unpack(const ChunkLocation& location) {
  const auto failed = [&](NoteCode code, std::string_view name = {}) {
    return tl::unexpected(Note{code, location.offset, 1, std::string(name)});
  };
  if (location.length > limits_.most_chunk_bytes + mcap::kMostChunkHead)
    return failed(NoteCode::ChunkTooLarge);
  std::optional<UnpackedChunk> stored = raw(location.offset, location.length);
  if (!stored) return failed(NoteCode::Unreadable);
  if (location.bare) {
    listRecords(*stored, location);
    return std::move(*stored);
  }
  ByteReader in(stored->all());
  const bool is_chunk = in.number<std::uint8_t>() == std::uint8_t(Op::Chunk);
  const auto length = in.number<std::uint64_t>();
  const auto content = in.rest();
  const std::optional<mcap::ChunkHead> head = mcap::chunkHeadIn(content, content.size());
  if (!is_chunk || length != content.size() || !head) return failed(NoteCode::ChunkCorrupt);
  if (head->unpacked_size > limits_.most_chunk_bytes) return failed(NoteCode::ChunkTooLarge);
  const auto records = content.subspan(std::size_t(head->records_at), std::size_t(head->records_size));
  UnpackedChunk chunk;
  if (head->compression.empty()) {
    if (head->unpacked_size != records.size()) return failed(NoteCode::ChunkCorrupt);
    chunk.bytes = std::shared_ptr<const std::uint8_t[]>(stored->bytes, records.data());
    chunk.size = records.size();
  } else {
    const bool zstd = head->compression == "zstd";
    if (!zstd && head->compression != "lz4") return failed(NoteCode::ChunkCompression, head->compression);
    auto unpacked = packed::unpackExactly(zstd ? packed::Codec::Zstd : packed::Codec::Lz4, records,
                                          std::size_t(head->unpacked_size));
    if (!unpacked) return failed(NoteCode::ChunkCorrupt);
    chunk.size = unpacked->size;
    chunk.bytes = std::move(unpacked->data);
  }
  if (head->crc != 0 && packed::crc32(0, chunk.all()) != head->crc) return failed(NoteCode::ChunkChecksum);
  listRecords(chunk, location);
  return chunk;
}

std::optional<Packing> McapReader::packingOf(const ChunkLocation& location) const {
  if (location.length < mcap::kRecordHead) return std::nullopt;
  const std::uint64_t length = location.length - mcap::kRecordHead;
  const std::optional<UnpackedChunk> start =
      raw(location.offset + mcap::kRecordHead, std::min<std::uint64_t>(length, mcap::kMostChunkHead));
  const auto head = start ? mcap::chunkHeadIn(start->all(), length) : std::nullopt;
  if (!head) return std::nullopt;
  return Packing{head->compression, 1, head->records_size, head->unpacked_size};
}

void McapReader::listRecords(UnpackedChunk& chunk, const ChunkLocation& location) {
  ByteReader in(chunk.all());
  while (in.left() > 0) {
    const std::uint64_t at = chunk.size - in.left();
    const auto op = Op(in.number<std::uint8_t>());
    const auto content = in.take(in.number<std::uint64_t>());
    if (!in.sound()) {
      notes_.add(NoteCode::ChunkCorrupt, location.offset);  // everything before that is intact
      return;
    }
    if (op == Op::Message) {
      ByteReader message(content);
      const auto channel = message.number<std::uint16_t>();
      message.number<std::uint32_t>();
      const auto stamp = message.number<std::uint64_t>();
      message.number<std::uint64_t>();
      if (!message.sound()) {
        notes_.add(NoteCode::RecordCorrupt, location.offset);
      } else if (mcap::isTime(stamp)) {
        chunk.entries.push_back({mcap::timeOf(stamp), at, channel});
      } else {
        notes_.add(NoteCode::TimeUnusable, location.offset);
      }
    } else if (op == Op::Schema) {
      readSchema(content, location.offset);
    } else if (op == Op::Channel) {
      readChannel(content, location.offset);
    }
  }
}

Message McapReader::read(const UnpackedChunk& chunk, const ChunkEntry& entry) const {
  ByteReader in(chunk.all().subspan(std::size_t(entry.offset)));
  in.number<std::uint8_t>();
  ByteReader content(in.take(in.number<std::uint64_t>()));
  content.number<std::uint16_t>();
  Message message;
  message.sequence = content.number<std::uint32_t>();
  content.number<std::uint64_t>();
  message.publish_time_ns = mcap::timeOf(content.number<std::uint64_t>());
  message.bytes = content.rest();
  return message;
}

std::optional<Attachment> McapReader::attachment(const AttachmentLocation& location) {
  const auto failed = [&](NoteCode code) {
    notes_.add(code, location.offset, location.name);
    return std::nullopt;
  };
  const std::optional<UnpackedChunk> head = raw(location.offset, mcap::kRecordHead);
  if (!head) return failed(NoteCode::AttachmentCorrupt);
  ByteReader start(head->all());
  const bool is_one = start.number<std::uint8_t>() == std::uint8_t(Op::Attachment);
  const auto length = start.number<std::uint64_t>();
  if (!is_one) return failed(NoteCode::AttachmentCorrupt);
  if (length > limits_.most_chunk_bytes) return failed(NoteCode::RecordTooLarge);
  const std::optional<UnpackedChunk> content = raw(location.offset + mcap::kRecordHead, length);
  if (!content) return failed(NoteCode::AttachmentCorrupt);
  ByteReader in(content->all());
  Attachment attachment;
  attachment.log_time_ns = mcap::timeOf(in.number<std::uint64_t>());
  attachment.create_time_ns = mcap::timeOf(in.number<std::uint64_t>());
  attachment.name = in.text();
  attachment.media_type = in.text();
  attachment.bytes = ByteReader::textOf(in.take(in.number<std::uint64_t>()));
  const std::size_t summed = content->size - in.left();
  const auto crc = in.number<std::uint32_t>();
  const bool sound = in.sound() && (crc == 0 || packed::crc32(0, content->all().first(summed)) == crc);
  if (!sound) return failed(NoteCode::AttachmentCorrupt);
  return attachment;
}

/// An unknown record may be skipped if another one follows it. Source: MCAP format specification, "Records"
/// (opcodes 0x10 to 0x7F are for later versions, 0x80 and above are private).
bool leadsOn(Window& window, const McapRecord& record, std::uint64_t to) {
  if (std::uint8_t(record.op) == 0) return false;
  if (record.length > to - record.content()) return true;  // handleRecord() detects whether it was cut off
  ByteReader in(window.look(record.end(), mcap::kRecordHead, to));
  const auto op = in.number<std::uint8_t>();
  const auto length = in.number<std::uint64_t>();
  if (!in.sound()) return true;                  // the file ends here
  if (Op(op) == Op::MessageIndex) return false;  // it was a chunk, so this is damage
  return isKnownOp(op) || (op != 0 && length <= to - record.end() - mcap::kRecordHead);
}

ChunkedSource::Step McapReader::readRecord(Window& window, std::uint64_t from, std::uint64_t to,
                                           std::uint64_t& past) {
  const auto start = window.look(from, mcap::kRecordHead, to);
  if (start.size() != mcap::kRecordHead) return Step::CutOff;
  ByteReader in(start);
  const auto op = in.number<std::uint8_t>();
  const McapRecord record{Op(op), from, in.number<std::uint64_t>()};
  past = record.end();
  return isKnownOp(op) || leadsOn(window, record, to) ? handleRecord(window, record, to) : Step::NoRecord;
}

ChunkedSource::Step McapReader::handleRecord(Window& window, const McapRecord& record, std::uint64_t to) {
  const bool whole = record.length <= to - record.content();
  if (record.op != Op::MessageIndex) settleChunk(false);
  if (record.op == Op::Chunk) return readChunk(window, record, to);
  if (!whole) {
    // A length beyond the end belongs to the last, truncated record, or is invalid. An attachment or a
    // message may be large, but not larger than the reading limit.
    const bool may_be_long =
        record.op == Op::Attachment || record.op == Op::Message || record.op == Op::MessageIndex;
    const bool likely = record.length <= (may_be_long ? limits_.most_chunk_bytes : limits_.most_record_bytes);
    return likely && nextChunk(window, record.at + 1, to) == to ? Step::CutOff : Step::NoRecord;
  }
  switch (record.op) {
    case Op::Message:
      return readMessage(window, record);
    case Op::MessageIndex:
      return readIndex(window, record);
    case Op::Attachment:
      return readAttachment(window, record);
    case Op::Header:
    case Op::Schema:
    case Op::Channel:
    case Op::Metadata:
      return readSmall(record);
    case Op::DataEnd:
      if (record.length < 4 || record.length > 64) return Step::NoRecord;
      data_end_ = record.end();
      return Step::DataEnds;
    case Op::Footer:
      if (record.length != mcap::kFooterContent) return Step::NoRecord;
      data_end_ = record.at;
      return Step::DataEnds;
    default:
      return Step::Taken;  // part of a summary, or private
  }
}

ChunkedSource::Step McapReader::readChunk(Window& window, const McapRecord& record, std::uint64_t to) {
  const auto least = std::min<std::uint64_t>(record.length, mcap::kMostChunkHead);
  const auto content = window.look(record.content(), std::size_t(least), to);
  const std::optional<mcap::ChunkHead> head = mcap::chunkHeadIn(content, record.length);
  if (!head) return content.size() == least ? Step::NoRecord : Step::CutOff;
  if (record.length > to - record.content()) {
    // Truncated, if both of its lengths agree; otherwise one of them is wrong.
    return head->records_at + head->records_size == record.length ? Step::CutOff : Step::NoRecord;
  }
  ChunkLocation location;
  location.offset = record.at;
  location.length = record.end() - record.at;
  location.first_ns = mcap::timeOf(head->start);
  location.last_ns = mcap::timeOf(head->end);
  // It will be unpacked.
  if (!mcap::isTime(head->end) || (head->start == 0 && head->end == 0)) location.forgetTimes();
  addScanned(std::move(location));
  return Step::Taken;
}

ChunkedSource::Step McapReader::readIndex(Window& window, const McapRecord& record) {
  ByteReader in(window.look(record.content(), 6, record.end()));
  const auto channel = in.number<std::uint16_t>();
  const auto bytes = in.number<std::uint32_t>();
  if (!in.sound() || std::uint64_t(bytes) + 6 > record.length) return Step::NoRecord;
  ChunkLocation* const chunk = indexedChunk();
  if (chunk == nullptr || bytes == 0) return Step::Taken;
  ChannelShare& share = chunk->share(channel);
  if (share.count == 0) share.count = bytes / 16;  // it was counted if the file ended here before
  return Step::Taken;
}

ChunkedSource::Step McapReader::readMessage(Window& window, const McapRecord& record) {
  ByteReader in(window.look(record.content(), mcap::kMessageHead, record.end()));
  const auto channel = in.number<std::uint16_t>();
  in.number<std::uint32_t>();
  const auto stamp = in.number<std::uint64_t>();
  in.number<std::uint64_t>();
  if (!in.sound()) return Step::NoRecord;
  if (mcap::isTime(stamp)) {
    addBare(record.at, record.end() - record.at, channel, mcap::timeOf(stamp));
  } else {
    notes_.add(NoteCode::TimeUnusable, record.at);
  }
  return Step::Taken;
}

ChunkedSource::Step McapReader::readAttachment(Window& window, const McapRecord& record) {
  // Names are short; one that does not fit into the window is ignored.
  ByteReader in(window.look(record.content(),
                            std::size_t(std::min<std::uint64_t>(record.length, Window::kMostInView)),
                            record.end()));
  AttachmentLocation location;
  location.offset = record.at;
  location.log_time_ns = mcap::timeOf(in.number<std::uint64_t>());
  location.create_time_ns = mcap::timeOf(in.number<std::uint64_t>());
  location.name = in.text();
  location.media_type = in.text();
  location.size = in.number<std::uint64_t>();
  if (!in.sound() || location.size > record.length) return Step::NoRecord;
  attachments_.push_back(std::move(location));
  return Step::Taken;
}

ChunkedSource::Step McapReader::readSmall(const McapRecord& record) {
  if (record.length > limits_.most_record_bytes) {
    notes_.add(NoteCode::RecordTooLarge, record.at);
    return Step::Taken;
  }
  const std::optional<UnpackedChunk> content = raw(record.content(), record.length);
  if (!content) return Step::CutOff;
  if (record.op == Op::Schema) {
    readSchema(content->all(), record.at);
  } else if (record.op == Op::Channel) {
    readChannel(content->all(), record.at);
  } else if (record.op == Op::Header) {
    const auto header = mcap::read<mcap::Header>(content->all());
    if (!header) return Step::NoRecord;
    about_.profile = header->profile;
    about_.library = header->library;
  } else if (auto read = mcap::read<mcap::MetadataRecord>(content->all())) {
    metadata_.push_back(std::move(read->metadata));
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

}  // namespace

bool looksLikeMcap(std::span<const std::uint8_t> start) {
  constexpr std::size_t kName = 5;  // the byte after it is the version
  return start.size() >= mcap::kMagic.size() &&
         std::equal(start.begin(), start.begin() + kName, mcap::kMagic.begin());
}

Opened openMcap(std::unique_ptr<Bytes> bytes, const Limits& limits) {
  std::array<std::uint8_t, mcap::kMagic.size()> magic{};
  if (!bytes->read(magic, 0)) return tl::unexpected(Failure{Failure::Code::NotOne, {}});
  if (magic != mcap::kMagic) return tl::unexpected(Failure{Failure::Code::Version, {}});
  auto reader = std::make_unique<McapReader>(std::move(bytes), limits);
  reader->open();
  return reader;
}

}  // namespace mapwright::recording
