#include "recording/mcap_reader.h"

#include <algorithm>

#include "packed/codec.h"

namespace mapwright::recording {
namespace {

using mcap::Op;

Note noteOf(NoteCode code, const ChunkPlace& place, std::string_view name = {}) {
  return {code, place.offset, 1, std::string(name)};
}

}  // namespace

bool looksLikeMcap(std::span<const std::uint8_t> start) {
  constexpr std::size_t kName = 5;  // the byte after it is the version
  return start.size() >= mcap::kMagic.size() &&
         std::equal(start.begin(), start.begin() + kName, mcap::kMagic.begin());
}

Opened McapReader::open(std::unique_ptr<Bytes> bytes, const Limits& limits) {
  std::array<std::uint8_t, mcap::kMagic.size()> magic{};
  if (!bytes->read(magic, 0) || !looksLikeMcap(magic))
    return tl::unexpected(Failure{Failure::Code::NotOne, {}});
  if (magic != mcap::kMagic) return tl::unexpected(Failure{Failure::Code::Version, {}});
  std::unique_ptr<McapReader> reader(new McapReader(std::move(bytes), limits));
  const std::uint64_t size = reader->bytes_->size();
  const std::optional<mcap::Footer> footer = reader->findFooter(size);
  const std::uint64_t footer_at = footer ? size - mcap::kMagic.size() - mcap::kFooterRecord : 0;
  if (!footer || !reader->openByIndex(*footer, footer_at)) reader->scanAll();
  return reader;
}

void McapReader::takeSchema(std::span<const std::uint8_t> content, std::uint64_t at) {
  std::optional<mcap::Schema> schema = mcap::schemaIn(content);
  if (!schema) {
    notes_.add(NoteCode::RecordCorrupt, at);
    return;
  }
  const std::uint16_t id = schema->id;
  schemas_.emplace(id, std::move(*schema));
}

void McapReader::takeChannel(std::span<const std::uint8_t> content, std::uint64_t at) {
  std::optional<mcap::ChannelRecord> record = mcap::channelIn(content);
  if (!record) {
    notes_.add(NoteCode::RecordCorrupt, at);
    return;
  }
  if (const auto schema = schemas_.find(record->schema_id); schema != schemas_.end()) {
    record->channel.schema_name = schema->second.name;
    record->channel.schema_encoding = schema->second.encoding;
    record->channel.schema_data = schema->second.data;
  }
  addChannel(std::move(record->channel), at);
}

tl::expected<UnpackedChunk, Note> McapReader::unpack(const ChunkPlace& place) {
  const auto failed = [&](NoteCode code, std::string_view name = {}) {
    return tl::unexpected(noteOf(code, place, name));
  };
  if (place.length > limits_.most_chunk_bytes + mcap::kMostChunkHead) return failed(NoteCode::ChunkTooLarge);
  std::optional<UnpackedChunk> stored = raw(place.offset, place.length);
  if (!stored) return failed(NoteCode::Unreadable);
  if (place.bare) {
    listRecords(*stored, place);
    return std::move(*stored);
  }
  ByteReader in(stored->all());
  const bool is_chunk = in.number<std::uint8_t>() == std::uint8_t(Op::Chunk);
  const auto length = in.number<std::uint64_t>();
  const auto content = in.take(in.left());
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
  listRecords(chunk, place);
  return chunk;
}

std::optional<Packing> McapReader::packingOf(const ChunkPlace& place) const {
  if (place.length < mcap::kRecordHead) return std::nullopt;
  const std::uint64_t length = place.length - mcap::kRecordHead;
  const std::optional<UnpackedChunk> start =
      raw(place.offset + mcap::kRecordHead, std::min<std::uint64_t>(length, mcap::kMostChunkHead));
  const std::optional<mcap::ChunkHead> head =
      start ? mcap::chunkHeadIn(start->all(), length) : std::optional<mcap::ChunkHead>();
  if (!head) return std::nullopt;
  return Packing{head->compression, 1, head->records_size, head->unpacked_size};
}

void McapReader::listRecords(UnpackedChunk& chunk, const ChunkPlace& place) {
  ByteReader in(chunk.all());
  while (in.left() > 0) {
    const std::uint64_t at = chunk.size - in.left();
    const auto op = Op(in.number<std::uint8_t>());
    const auto content = in.take(in.number<std::uint64_t>());
    if (!in.sound()) {
      notes_.add(NoteCode::ChunkCorrupt, place.offset);  // everything before that is intact
      return;
    }
    if (op == Op::Message) {
      ByteReader message(content);
      ChunkEntry entry;
      entry.channel = message.number<std::uint16_t>();
      message.number<std::uint32_t>();
      const auto stamp = message.number<std::uint64_t>();
      message.number<std::uint64_t>();
      entry.log_ns = mcap::timeOf(stamp);
      entry.offset = at;
      if (!message.sound()) {
        notes_.add(NoteCode::RecordCorrupt, place.offset);
      } else if (mcap::isTime(stamp)) {
        chunk.entries.push_back(entry);
      } else {
        notes_.add(NoteCode::TimeUnusable, place.offset);
      }
    } else if (op == Op::Schema) {
      takeSchema(content, place.offset);
    } else if (op == Op::Channel) {
      takeChannel(content, place.offset);
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
  message.bytes = content.take(content.left());
  return message;
}

ChunkedSource::Latest McapReader::latestByIndex(const ChunkPlace&, const ChannelShare& share,
                                                std::int64_t at_ns) {
  const std::optional<UnpackedChunk> start = raw(share.index_offset, mcap::kRecordHead + 6);
  if (!start) return {};
  ByteReader in(start->all());
  const bool is_index = in.number<std::uint8_t>() == std::uint8_t(Op::MessageIndex);
  const auto length = in.number<std::uint64_t>();
  const auto channel = in.number<std::uint16_t>();
  const auto bytes = in.number<std::uint32_t>();
  if (!is_index || channel != share.channel || length != std::uint64_t(bytes) + 6) return {};
  if (bytes > limits_.most_record_bytes) return {};
  const std::optional<UnpackedChunk> rows = raw(share.index_offset + mcap::kRecordHead + 6, bytes);
  if (!rows) return {};
  Latest latest{false, std::nullopt};
  ByteReader row(rows->all());
  while (row.left() >= 16) {
    const auto stamp = row.number<std::uint64_t>();
    const std::int64_t time = mcap::timeOf(stamp);
    row.number<std::uint64_t>();
    if (mcap::isTime(stamp) && time <= at_ns && (!latest.log_ns || time > *latest.log_ns))
      latest.log_ns = time;
  }
  return latest;
}

std::optional<Attachment> McapReader::attachment(const AttachmentPlace& place) {
  const auto failed = [&](NoteCode code) {
    notes_.add(code, place.offset, place.name);
    return std::nullopt;
  };
  const std::optional<UnpackedChunk> head = raw(place.offset, mcap::kRecordHead);
  if (!head) return failed(NoteCode::AttachmentCorrupt);
  ByteReader start(head->all());
  const bool is_one = start.number<std::uint8_t>() == std::uint8_t(Op::Attachment);
  const auto length = start.number<std::uint64_t>();
  if (!is_one) return failed(NoteCode::AttachmentCorrupt);
  if (length > limits_.most_chunk_bytes) return failed(NoteCode::RecordTooLarge);
  const std::optional<UnpackedChunk> content = raw(place.offset + mcap::kRecordHead, length);
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
  if (!in.sound()) return failed(NoteCode::AttachmentCorrupt);
  if (crc != 0 && packed::crc32(0, content->all().first(summed)) != crc)
    return failed(NoteCode::AttachmentCorrupt);
  return attachment;
}

}  // namespace mapwright::recording
