// The records of MCAP, as stored in a file. Pure functions, any thread. Source: MCAP format specification,
// version 0, "Records" and "Serialization".
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "recording/byte_reader.h"
#include "recording/message.h"

namespace mapwright::recording::mcap {

inline constexpr std::array<std::uint8_t, 8> kMagic{0x89, 'M', 'C', 'A', 'P', 0x30, '\r', '\n'};

enum class Op : std::uint8_t {
  Header = 0x01,
  Footer,
  Schema,
  Channel,
  Message,
  Chunk,
  MessageIndex,
  ChunkIndex,
  Attachment,
  AttachmentIndex,
  Statistics,
  Metadata,
  MetadataIndex,
  SummaryOffset,
  DataEnd,
};

inline constexpr std::size_t kRecordHead = 9;      // opcode, length
inline constexpr std::size_t kMessageHead = 22;    // of a message, before its data
inline constexpr std::size_t kFooterContent = 20;  // of the only record with a fixed length
inline constexpr std::size_t kFooterRecord = kRecordHead + kFooterContent;

struct Footer {
  std::uint64_t summary_start = 0, summary_offset_start = 0;
  std::uint32_t summary_crc = 0;
};

struct Schema {
  std::uint16_t id = 0;
  std::string name, encoding, data;
};

struct ChannelRecord {
  std::uint16_t schema_id = 0;
  Channel channel;  // without its schema
};

/// The fields of a chunk before its records.
struct ChunkHead {
  std::uint64_t start = 0, end = 0, unpacked_size = 0;
  std::uint32_t crc = 0;
  std::string compression;
  std::uint64_t records_at = 0;  // from the start of the record's content
  std::uint64_t records_size = 0;
};
inline constexpr std::size_t kLongestCompression = 32;
inline constexpr std::size_t kMostChunkHead = 40 + kLongestCompression;

struct ChunkIndex {
  std::uint64_t start = 0, end = 0, offset = 0, length = 0;
  std::vector<std::pair<std::uint16_t, std::uint64_t>> index_offsets;
  std::uint64_t index_length = 0;
  std::string compression;
  std::uint64_t packed_size = 0, unpacked_size = 0;
};

struct Statistics {
  std::uint64_t messages = 0;
  std::uint16_t schemas = 0;
  std::uint32_t channels = 0, attachments = 0, metadata = 0, chunks = 0;
  std::uint64_t start = 0, end = 0;
  std::vector<std::pair<std::uint16_t, std::uint64_t>> messages_of;
};

struct AttachmentIndex {
  std::uint64_t offset = 0, length = 0;
  AttachmentPlace place;
};

/// Parses the content of a record; nullopt: it is invalid. Unknown fields at the end are skipped.
std::optional<Footer> footerIn(std::span<const std::uint8_t> content);
std::optional<std::pair<std::string, std::string>> headerIn(
    std::span<const std::uint8_t> content);  // profile, library
std::optional<Schema> schemaIn(std::span<const std::uint8_t> content);
std::optional<ChannelRecord> channelIn(std::span<const std::uint8_t> content);
/// For a record with `length` bytes of content, from its first kMostChunkHead bytes or all there are. Also
/// nullopt if its lengths are inconsistent, so that random bytes are not mistaken for a chunk.
std::optional<ChunkHead> chunkHeadIn(std::span<const std::uint8_t> content, std::uint64_t length);
std::optional<ChunkIndex> chunkIndexIn(std::span<const std::uint8_t> content);
std::optional<Statistics> statisticsIn(std::span<const std::uint8_t> content);
std::optional<Metadata> metadataIn(std::span<const std::uint8_t> content);

/// Bytes of records, one behind the other.
class RecordWriter {
 public:
  RecordWriter& u8(std::uint8_t value);
  RecordWriter& u16(std::uint16_t value);
  RecordWriter& u32(std::uint32_t value);
  RecordWriter& u64(std::uint64_t value);
  RecordWriter& text(std::string_view text);  // truncated to 4 GiB
  RecordWriter& words(const Words& words);
  RecordWriter& raw(std::span<const std::uint8_t> bytes);

  /// Everything written until end() is the content of the record.
  void begin(Op op);
  void end();

  std::span<const std::uint8_t> bytes() const;
  std::size_t size() const { return bytes_.size(); }
  void clear() { bytes_.clear(); }

 private:
  template <typename T>
  RecordWriter& number(T value);
  std::string bytes_;
  std::size_t begun_ = 0;
};

void write(RecordWriter& out, const Schema& schema);
void write(RecordWriter& out, const ChannelRecord& channel);
void write(RecordWriter& out, const ChunkIndex& index);
void write(RecordWriter& out, const Statistics& statistics);
void write(RecordWriter& out, const AttachmentIndex& index);
void write(RecordWriter& out, const Metadata& metadata);

/// The year 2261: leaves room for arithmetic with seconds.
inline constexpr std::uint64_t kLastTime = 9'200'000'000'000'000'000;
inline bool isTime(std::uint64_t stamp) { return stamp <= kLastTime; }
inline std::int64_t timeOf(std::uint64_t stamp) { return std::int64_t(std::min(stamp, kLastTime)); }

}  // namespace mapwright::recording::mcap
