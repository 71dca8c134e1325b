// The records of MCAP, as stored in a file. Pure functions, any thread. Source: MCAP format specification,
// version 0, "Records" and "Serialization".
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "recording/bytes.h"
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

// Each record has its opcode and, for reading and writing alike, its fields in the order of the file.

struct Header {
  static constexpr Op kOp = Op::Header;
  std::string profile, library;
  static auto fields(auto& of) { return std::tie(of.profile, of.library); }
};

struct Footer {
  static constexpr Op kOp = Op::Footer;
  std::uint64_t summary_start = 0, summary_offset_start = 0;
  std::uint32_t summary_crc = 0;
  static auto fields(auto& of) { return std::tie(of.summary_start, of.summary_offset_start, of.summary_crc); }
};

struct Schema {
  static constexpr Op kOp = Op::Schema;
  std::uint16_t id = 0;
  std::string name, encoding, data;
  static auto fields(auto& of) { return std::tie(of.id, of.name, of.encoding, of.data); }
};

struct ChannelRecord {
  static constexpr Op kOp = Op::Channel;
  std::uint16_t id = 0, schema_id = 0;
  std::string topic, message_encoding;
  Values metadata;
  static auto fields(auto& of) {
    return std::tie(of.id, of.schema_id, of.topic, of.message_encoding, of.metadata);
  }
  bool operator==(const ChannelRecord&) const = default;
};

/// Log time and offset in the unpacked chunk of each message.
struct MessageIndex {
  static constexpr Op kOp = Op::MessageIndex;
  std::uint16_t channel = 0;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> rows;
  static auto fields(auto& of) { return std::tie(of.channel, of.rows); }
};

struct ChunkIndex {
  static constexpr Op kOp = Op::ChunkIndex;
  std::uint64_t start = 0, end = 0, offset = 0, length = 0;
  std::vector<std::pair<std::uint16_t, std::uint64_t>> index_offsets;
  std::uint64_t index_length = 0;
  std::string compression;
  std::uint64_t packed_size = 0, unpacked_size = 0;
  static auto fields(auto& of) {
    return std::tie(of.start, of.end, of.offset, of.length, of.index_offsets, of.index_length, of.compression,
                    of.packed_size, of.unpacked_size);
  }
};

struct Statistics {
  static constexpr Op kOp = Op::Statistics;
  std::uint64_t messages = 0;
  std::uint16_t schemas = 0;
  std::uint32_t channels = 0, attachments = 0, metadata = 0, chunks = 0;
  std::uint64_t start = 0, end = 0;
  std::vector<std::pair<std::uint16_t, std::uint64_t>> messages_of;
  static auto fields(auto& of) {
    return std::tie(of.messages, of.schemas, of.channels, of.attachments, of.metadata, of.chunks, of.start,
                    of.end, of.messages_of);
  }
};

struct AttachmentIndex {
  static constexpr Op kOp = Op::AttachmentIndex;
  std::uint64_t offset = 0, length = 0;
  AttachmentLocation location;
  static auto fields(auto& of) {
    return std::tie(of.offset, of.length, of.location.log_time_ns, of.location.create_time_ns,
                    of.location.size, of.location.name, of.location.media_type);
  }
};

struct MetadataRecord {
  static constexpr Op kOp = Op::Metadata;
  Metadata metadata;
  static auto fields(auto& of) { return std::tie(of.metadata.name, of.metadata.values); }
};

struct MetadataIndex {
  static constexpr Op kOp = Op::MetadataIndex;
  std::uint64_t offset = 0, length = 0;
  std::string name;
  static auto fields(auto& of) { return std::tie(of.offset, of.length, of.name); }
};

/// Numbers, texts, and maps or lists of pairs, which are preceded by their length in bytes.
template <typename Field>
void readField(ByteReader& in, Field& field) {
  if constexpr (std::is_arithmetic_v<Field>) {
    field = in.number<Field>();
  } else if constexpr (std::is_same_v<Field, std::string>) {
    field = in.text();
  } else {
    ByteReader pairs(in.piece());
    if constexpr (requires { field.reserve(1); })
      field.reserve(pairs.left() / (sizeof(field.begin()->first) + sizeof(field.begin()->second)));
    while (pairs.sound() && pairs.left() > 0) {
      std::remove_const_t<typename Field::value_type::first_type> key{};
      typename Field::value_type::second_type value{};
      readField(pairs, key);
      readField(pairs, value);
      if (pairs.sound())
        field.insert(field.end(), typename Field::value_type(std::move(key), std::move(value)));
    }
    if (!pairs.sound()) in.fail();
  }
}

/// Parses the content of a record; nullopt: it is invalid. Unknown fields at the end are skipped.
template <typename Record>
std::optional<Record> read(std::span<const std::uint8_t> content) {
  ByteReader in(content);
  Record record;
  std::apply([&](auto&... fields) { (readField(in, fields), ...); }, Record::fields(record));
  return in.sound() ? std::optional(std::move(record)) : std::nullopt;
}

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
/// For a record with `length` bytes of content, from its first kMostChunkHead bytes or all there are. Also
/// nullopt if its lengths are inconsistent, so that random bytes are not mistaken for a chunk.
std::optional<ChunkHead> chunkHeadIn(std::span<const std::uint8_t> content, std::uint64_t length);

/// Bytes of records, one behind the other.
class RecordWriter {
 public:
  RecordWriter& u8(std::uint8_t value) { return number(value); }
  RecordWriter& u16(std::uint16_t value) { return number(value); }
  RecordWriter& u32(std::uint32_t value) { return number(value); }
  RecordWriter& u64(std::uint64_t value) { return number(value); }
  RecordWriter& text(std::string_view text);  // truncated to 4 GiB
  RecordWriter& raw(std::span<const std::uint8_t> bytes);
  /// As readField() reads it.
  template <typename Field>
  RecordWriter& field(const Field& field) {
    if constexpr (std::is_arithmetic_v<Field>) {
      return number(field);
    } else if constexpr (std::is_same_v<Field, std::string>) {
      return text(field);
    } else {
      RecordWriter pairs;
      for (const auto& [key, value] : field) pairs.field(key).field(value);
      return text(pairs.bytes_);
    }
  }

  /// Everything written until end() is the content of the record.
  void begin(Op op);
  void end();

  std::span<const std::uint8_t> bytes() const;
  std::size_t size() const { return bytes_.size(); }
  void clear() { bytes_.clear(); }

 private:
  template <typename T>
  RecordWriter& number(T value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    return *this;
  }
  std::string bytes_;
  std::size_t begun_ = 0;
};

template <typename Record>
void write(RecordWriter& out, const Record& record) {
  out.begin(Record::kOp);
  std::apply([&](const auto&... fields) { (out.field(fields), ...); }, Record::fields(record));
  out.end();
}

/// The year 2261: leaves room for arithmetic with seconds.
inline constexpr std::uint64_t kLastTime = 9'200'000'000'000'000'000;
inline bool isTime(std::uint64_t stamp) { return stamp <= kLastTime; }
inline std::int64_t timeOf(std::uint64_t stamp) { return std::int64_t(std::min(stamp, kLastTime)); }

}  // namespace mapwright::recording::mcap
