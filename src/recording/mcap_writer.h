// Writes recordings as MCAP, version 0: Zstandard chunks with CRC and index, so that a crash loses at most
// the open chunk. Source: MCAP format specification.
// One thread. Nothing is ever overwritten; every chunk is written as soon as it is closed.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "recording/append_file.h"
#include "recording/mcap_records.h"
#include "recording/message.h"

namespace mapwright::recording {

struct WriterOptions {
  enum class Compression : std::uint8_t { None, Zstd };
  std::string profile;  // "ros1", "ros2" or empty
  std::string library = "mapwright";
  Compression compression = Compression::Zstd;
  int level = 1;                                   // of zstd
  std::size_t chunk_bytes = std::size_t(1) << 20;  // a chunk is closed at this unpacked size
  std::int64_t chunk_ns = 1'000'000'000;           // and when its first message is this old
  bool survive_power_loss = false;                 // waits for the disk after every chunk
};

struct Stamp {
  std::int64_t log_time_ns = 0;      // MCAP has no times before its epoch: a negative one is written as 0
  std::int64_t publish_time_ns = 0;  // likewise
  std::uint32_t sequence = 0;
};

using ChannelId = std::uint16_t;

/// A failing call returns the reason and leaves the file intact. While the disk accepts nothing, the pending
/// chunk is kept and retried once a second (by the clock of log times); messages go to the open chunk until
/// that is full, and are refused afterwards. Recording continues as soon as the disk accepts data again.
class McapWriter {
 public:
  static tl::expected<std::unique_ptr<McapWriter>, disk::FileError> create(
      std::unique_ptr<AppendTarget> target, WriterOptions options);
  /// Calls close() if nobody has, ignoring errors.
  ~McapWriter();
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;

  /// The same channel (except `id`) gets the same number again. nullopt: there are already 65,535 channels or
  /// schemas, or its texts exceed 32 MiB.
  std::optional<ChannelId> addChannel(const Channel& channel);
  /// nullopt: all is well. Otherwise the reason: progress() tells whether the message was refused (lost) or
  /// waits in memory. Messages beyond kMostMessageBytes or of an unknown channel are refused.
  std::optional<disk::FileError> write(ChannelId channel, const Stamp& stamp,
                                       std::span<const std::uint8_t> bytes);
  std::optional<disk::FileError> attach(const Attachment& attachment);
  std::optional<disk::FileError> addMetadata(const Metadata& metadata);
  /// Closes the open chunk if it is old enough, by the clock of log times. Call it regularly, otherwise the
  /// last messages before a pause stay in memory.
  std::optional<disk::FileError> tick(std::int64_t now_ns);
  /// Closes the open chunk.
  std::optional<disk::FileError> flush();
  /// Writes the index and the end. Nothing can be written afterwards. May be repeated after a failure.
  std::optional<disk::FileError> close();

  struct Progress {
    std::uint64_t bytes = 0;     // in the file
    std::uint64_t messages = 0;  // taken
    std::uint64_t lost = 0;      // refused
    std::uint64_t chunks = 0;
    std::uint64_t in_chunks = 0;  // accepted messages that are in the file
  };
  Progress progress() const { return progress_; }

  static constexpr std::size_t kMostMessageBytes = std::size_t(128) << 20;

 private:
  struct OpenChunk {
    mcap::RecordWriter records;
    std::int64_t first_ns = 0;  // of the message that came first
    std::uint64_t start = 0, end = 0, messages = 0;
    std::map<ChannelId, std::vector<std::pair<std::uint64_t, std::uint64_t>>> index;  // log time, offset
  };
  /// A chunk waiting to be written.
  struct Due {
    std::vector<std::uint8_t> bytes;  // with its message indexes
    mcap::ChunkIndex index;           // offsets relative to the start of the chunk
    std::uint64_t messages = 0;
    std::map<ChannelId, std::uint64_t> messages_of;
  };
  McapWriter(std::unique_ptr<AppendTarget> target, WriterOptions options);
  std::optional<disk::FileError> append(std::span<const std::uint8_t> bytes);
  std::optional<disk::FileError> closeChunk();
  std::optional<disk::FileError> writeDue();
  void pack();
  void describe(ChannelId channel);
  mcap::RecordWriter summary(std::uint64_t at) const;
  disk::FileError refuse(int error);
  bool mayTry(std::int64_t now_ns) const;
  std::optional<disk::FileError> seen(std::optional<disk::FileError> fault, std::int64_t now_ns);

  std::unique_ptr<AppendTarget> target_;
  WriterOptions options_;
  std::vector<mcap::Schema> schemas_;          // by id, from 1
  std::vector<mcap::ChannelRecord> channels_;  // by id, from 1
  // The same by what they say: there may be many thousands, and each message asks.
  std::map<std::tuple<std::string, std::string, std::string>, std::uint16_t> schema_ids_;
  std::map<std::tuple<std::string, std::uint16_t, std::string, Values>, ChannelId> channel_ids_;
  std::vector<bool> described_schema_, described_channel_;  // written to the file or the open chunk
  OpenChunk open_;
  std::optional<Due> due_;
  std::optional<disk::FileError> fault_;  // why `due_` is not written
  std::int64_t failed_ns_ = 0;            // when
  std::vector<mcap::ChunkIndex> chunk_indexes_;
  std::vector<mcap::AttachmentIndex> attachments_;
  std::vector<mcap::MetadataIndex> metadata_;
  mcap::Statistics statistics_;
  std::map<ChannelId, std::uint64_t> messages_of_;
  std::uint32_t crc_ = 0;  // of everything in the file
  Progress progress_;
  bool data_ended_ = false, closed_ = false;
};

}  // namespace mapwright::recording
