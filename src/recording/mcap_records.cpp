#include "recording/mcap_records.h"

#include <algorithm>
#include <limits>

namespace mapwright::recording::mcap {
namespace {

constexpr std::size_t kMost32 = std::numeric_limits<std::uint32_t>::max();

Words wordsIn(ByteReader& in, bool& sound) {
  Words words;
  ByteReader pairs(in.piece());
  while (pairs.sound() && pairs.left() > 0) {
    const std::string_view key = pairs.text();
    const std::string_view value = pairs.text();
    if (pairs.sound()) words.emplace(key, value);
  }
  sound = sound && pairs.sound();
  return words;
}

std::vector<std::pair<std::uint16_t, std::uint64_t>> numbersIn(ByteReader& in, bool& sound) {
  ByteReader pairs(in.piece());
  std::vector<std::pair<std::uint16_t, std::uint64_t>> numbers;
  numbers.reserve(pairs.left() / 10);
  while (pairs.sound() && pairs.left() > 0) {
    const auto key = pairs.number<std::uint16_t>();
    const auto value = pairs.number<std::uint64_t>();
    if (pairs.sound()) numbers.emplace_back(key, value);
  }
  sound = sound && pairs.sound();
  return numbers;
}

void writeNumbers(RecordWriter& out, const std::vector<std::pair<std::uint16_t, std::uint64_t>>& numbers) {
  out.u32(std::uint32_t(numbers.size() * 10));
  for (const auto& [key, value] : numbers) out.u16(key).u64(value);
}

}  // namespace

std::optional<Footer> footerIn(std::span<const std::uint8_t> content) {
  ByteReader in(content);
  Footer footer;
  footer.summary_start = in.number<std::uint64_t>();
  footer.summary_offset_start = in.number<std::uint64_t>();
  footer.summary_crc = in.number<std::uint32_t>();
  return in.sound() ? std::optional(footer) : std::nullopt;
}

std::optional<std::pair<std::string, std::string>> headerIn(std::span<const std::uint8_t> content) {
  ByteReader in(content);
  std::pair<std::string, std::string> header;
  header.first = in.text();
  header.second = in.text();
  return in.sound() ? std::optional(std::move(header)) : std::nullopt;
}

std::optional<Schema> schemaIn(std::span<const std::uint8_t> content) {
  ByteReader in(content);
  Schema schema;
  schema.id = in.number<std::uint16_t>();
  schema.name = in.text();
  schema.encoding = in.text();
  schema.data = in.text();
  return in.sound() && schema.id != 0 ? std::optional(std::move(schema)) : std::nullopt;
}

std::optional<ChannelRecord> channelIn(std::span<const std::uint8_t> content) {
  ByteReader in(content);
  ChannelRecord record;
  bool sound = true;
  record.channel.id = in.number<std::uint16_t>();
  record.schema_id = in.number<std::uint16_t>();
  record.channel.topic = in.text();
  record.channel.message_encoding = in.text();
  record.channel.metadata = wordsIn(in, sound);
  return sound && in.sound() ? std::optional(std::move(record)) : std::nullopt;
}

std::optional<ChunkHead> chunkHeadIn(std::span<const std::uint8_t> content, std::uint64_t length) {
  ByteReader in(content);
  ChunkHead head;
  head.start = in.number<std::uint64_t>();
  head.end = in.number<std::uint64_t>();
  head.unpacked_size = in.number<std::uint64_t>();
  head.crc = in.number<std::uint32_t>();
  const auto named = in.number<std::uint32_t>();
  if (named > kLongestCompression) return std::nullopt;
  head.compression = ByteReader::textOf(in.take(named));
  head.records_size = in.number<std::uint64_t>();
  head.records_at = 40 + std::uint64_t(named);
  // Fields added by later versions would come after the records.
  if (!in.sound() || head.records_at > length || head.records_size > length - head.records_at)
    return std::nullopt;
  return head;
}

std::optional<ChunkIndex> chunkIndexIn(std::span<const std::uint8_t> content) {
  ByteReader in(content);
  ChunkIndex index;
  bool sound = true;
  index.start = in.number<std::uint64_t>();
  index.end = in.number<std::uint64_t>();
  index.offset = in.number<std::uint64_t>();
  index.length = in.number<std::uint64_t>();
  index.index_offsets = numbersIn(in, sound);
  index.index_length = in.number<std::uint64_t>();
  index.compression = in.text();
  index.packed_size = in.number<std::uint64_t>();
  index.unpacked_size = in.number<std::uint64_t>();
  return sound && in.sound() ? std::optional(std::move(index)) : std::nullopt;
}

std::optional<Statistics> statisticsIn(std::span<const std::uint8_t> content) {
  ByteReader in(content);
  Statistics statistics;
  bool sound = true;
  statistics.messages = in.number<std::uint64_t>();
  statistics.schemas = in.number<std::uint16_t>();
  statistics.channels = in.number<std::uint32_t>();
  statistics.attachments = in.number<std::uint32_t>();
  statistics.metadata = in.number<std::uint32_t>();
  statistics.chunks = in.number<std::uint32_t>();
  statistics.start = in.number<std::uint64_t>();
  statistics.end = in.number<std::uint64_t>();
  statistics.messages_of = numbersIn(in, sound);
  return sound && in.sound() ? std::optional(std::move(statistics)) : std::nullopt;
}

std::optional<Metadata> metadataIn(std::span<const std::uint8_t> content) {
  ByteReader in(content);
  Metadata metadata;
  bool sound = true;
  metadata.name = in.text();
  metadata.words = wordsIn(in, sound);
  return sound && in.sound() ? std::optional(std::move(metadata)) : std::nullopt;
}

template <typename T>
RecordWriter& RecordWriter::number(T value) {
  bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  return *this;
}

RecordWriter& RecordWriter::u8(std::uint8_t value) { return number(value); }
RecordWriter& RecordWriter::u16(std::uint16_t value) { return number(value); }
RecordWriter& RecordWriter::u32(std::uint32_t value) { return number(value); }
RecordWriter& RecordWriter::u64(std::uint64_t value) { return number(value); }

RecordWriter& RecordWriter::text(std::string_view text) {
  text = text.substr(0, kMost32);
  u32(std::uint32_t(text.size()));
  bytes_.append(text);
  return *this;
}

RecordWriter& RecordWriter::words(const Words& words) {
  RecordWriter pairs;
  for (const auto& [key, value] : words) pairs.text(key).text(value);
  return text(pairs.bytes_);
}

RecordWriter& RecordWriter::raw(std::span<const std::uint8_t> bytes) {
  bytes_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return *this;
}

void RecordWriter::begin(Op op) {
  u8(std::uint8_t(op)).u64(0);
  begun_ = bytes_.size();
}

void RecordWriter::end() {
  const std::uint64_t length = bytes_.size() - begun_;
  std::memcpy(bytes_.data() + begun_ - sizeof length, &length, sizeof length);
}

std::span<const std::uint8_t> RecordWriter::bytes() const {
  return {reinterpret_cast<const std::uint8_t*>(bytes_.data()), bytes_.size()};
}

void write(RecordWriter& out, const Schema& schema) {
  out.begin(Op::Schema);
  out.u16(schema.id).text(schema.name).text(schema.encoding).text(schema.data);
  out.end();
}

void write(RecordWriter& out, const ChannelRecord& channel) {
  out.begin(Op::Channel);
  out.u16(std::uint16_t(channel.channel.id)).u16(channel.schema_id).text(channel.channel.topic);
  out.text(channel.channel.message_encoding).words(channel.channel.metadata);
  out.end();
}

void write(RecordWriter& out, const ChunkIndex& index) {
  out.begin(Op::ChunkIndex);
  out.u64(index.start).u64(index.end).u64(index.offset).u64(index.length);
  writeNumbers(out, index.index_offsets);
  out.u64(index.index_length).text(index.compression).u64(index.packed_size).u64(index.unpacked_size);
  out.end();
}

void write(RecordWriter& out, const Statistics& statistics) {
  out.begin(Op::Statistics);
  out.u64(statistics.messages).u16(statistics.schemas).u32(statistics.channels).u32(statistics.attachments);
  out.u32(statistics.metadata).u32(statistics.chunks).u64(statistics.start).u64(statistics.end);
  writeNumbers(out, statistics.messages_of);
  out.end();
}

void write(RecordWriter& out, const AttachmentIndex& index) {
  out.begin(Op::AttachmentIndex);
  out.u64(index.offset).u64(index.length);
  out.u64(std::uint64_t(index.place.log_time_ns)).u64(std::uint64_t(index.place.create_time_ns));
  out.u64(index.place.size).text(index.place.name).text(index.place.media_type);
  out.end();
}

void write(RecordWriter& out, const Metadata& metadata) {
  out.begin(Op::Metadata);
  out.text(metadata.name).words(metadata.words);
  out.end();
}

}  // namespace mapwright::recording::mcap
