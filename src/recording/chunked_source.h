// Common to MCAP and bags: messages in chunks with known time ranges. Merges overlapping chunks, keeps
// recently unpacked ones, finds the last message before a time. Formats derive from it.
#pragma once

#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include <tl/expected.hpp>

#include "recording/source.h"

namespace mapwright::recording {

/// What a chunk contains of one channel.
struct ChannelShare {
  std::uint32_t channel = 0;
  std::uint64_t index_offset = 0;  // offset in the file of the record that lists its messages; 0: unknown
  std::uint64_t count = 0;         // messages; 0: unknown
};

/// Where a chunk is, and what is known of it without unpacking.
struct ChunkPlace {
  std::uint64_t offset = 0;                // of its record in the file, or of the first of the bare records
  std::uint64_t length = 0;                // bytes in the file; 0: stated in its record
  bool bare = false;                       // records outside of any chunk
  std::int64_t first_ns = 0, last_ns = 0;  // log times; first_ns > last_ns: no messages
  bool channels_known = false;
  bool looked_into = false;          // its problems have been noted
  std::vector<ChannelShare> shares;  // by channel

  const ChannelShare* shareOf(std::uint32_t channel) const;
};

/// A message in a chunk.
struct ChunkEntry {
  std::int64_t log_ns = 0;
  std::uint64_t offset = 0;  // of its record in the unpacked chunk
  std::uint32_t channel = 0;
};

struct UnpackedChunk {
  std::shared_ptr<const std::uint8_t[]> bytes;
  std::size_t size = 0;
  std::vector<ChunkEntry> entries;  // by log time, then by offset

  std::span<const std::uint8_t> all() const { return {bytes.get(), size}; }
};
using UnpackedPtr = std::shared_ptr<const UnpackedChunk>;

class ChunkedSource : public Source {
 public:
  Summary summary() const override;
  std::vector<ChannelPtr> channels() const override;
  std::unique_ptr<Cursor> messages(const Query& query) override;
  std::vector<Message> lastBefore(std::int64_t at_ns, const std::vector<std::string>& topics) override;
  std::vector<Packing> packing() const override;
  const std::vector<AttachmentPlace>& attachments() const override { return attachments_; }
  const std::vector<Metadata>& metadata() const override { return metadata_; }

 protected:
  ChunkedSource(std::unique_ptr<Bytes> bytes, const Limits& limits)
      : bytes_(std::move(bytes)), limits_(limits) {}

  /// To be implemented by the format. Returns the bytes of the chunk and its messages in any order; channels
  /// described in it are added with addChannel().
  virtual tl::expected<UnpackedChunk, Note> unpack(const ChunkPlace& place) = 0;
  /// A message of a chunk; the caller sets its channel. The entry comes from unpack().
  virtual Message read(const UnpackedChunk& chunk, const ChunkEntry& entry) const = 0;
  /// Of one chunk, from its header; nullopt: it cannot be read.
  virtual std::optional<Packing> packingOf(const ChunkPlace& place) const = 0;
  /// The latest log time at or before `at_ns`, from the index alone. An unreadable index is `unknown`.
  struct Latest {
    bool unknown = true;
    std::optional<std::int64_t> log_ns;
  };
  virtual Latest latestByIndex(const ChunkPlace& place, const ChannelShare& share, std::int64_t at_ns) = 0;

  void addChannel(Channel channel, std::uint64_t offset);
  bool knowsChannel(std::uint32_t id) const { return channels_.contains(id); }
  /// Must come after all others in the file, otherwise call sortChunks().
  void addChunk(ChunkPlace place);
  ChunkPlace* lastChunk() { return chunks_.empty() ? nullptr : &chunks_.back(); }
  std::vector<ChunkPlace>& chunks() { return chunks_; }
  void sortChunks();
  /// Unpacks it to get its times, channels and counts.
  void lookInto(std::size_t chunk);
  /// Unpacks the chunks that may describe unknown channels.
  void findChannels();
  /// Computes counts and times from what is known of the chunks.
  void countChunks();
  void dropAll();
  /// Bytes of the file; nullopt: missing, or not enough memory.
  std::optional<UnpackedChunk> raw(std::uint64_t at, std::uint64_t count) const;

  std::unique_ptr<Bytes> bytes_;
  Limits limits_;
  Notes notes_;
  Summary about_;  // everything except the counts
  std::vector<AttachmentPlace> attachments_;
  std::vector<Metadata> metadata_;

 private:
  friend class ChunkCursor;
  struct Best {
    std::int64_t log_ns = 0;
    std::size_t chunk = 0;
  };
  UnpackedPtr unpacked(std::size_t chunk);
  void forgetOrder();
  void dropUnknown(UnpackedChunk& chunk, std::uint64_t offset);
  void learn(ChunkPlace& place, const UnpackedChunk& unpacked);
  std::optional<Best> latest(std::uint32_t channel, std::int64_t at_ns, bool trust_index);
  std::optional<Message> lastOf(std::uint32_t channel, std::int64_t at_ns, Best& found);
  const std::vector<std::uint32_t>& latestFirst();
  Message messageAt(const UnpackedChunk& chunk, const ChunkEntry& entry) const;

  std::vector<ChunkPlace> chunks_;  // in file order
  std::map<std::uint32_t, ChannelPtr> channels_;
  std::vector<std::uint32_t> latest_first_;  // chunks by last_ns; empty: not sorted yet

  struct Held {
    std::size_t chunk = 0;
    UnpackedPtr unpacked;
    std::size_t bytes = 0;
  };
  std::list<Held> held_;  // used last in front
  std::unordered_map<std::size_t, std::list<Held>::iterator> held_at_;
  std::size_t held_bytes_ = 0;
};

/// The channels of a query: all, or those on one of its topics.
class ChannelChoice {
 public:
  explicit ChannelChoice(const std::vector<std::string>& topics);
  bool all() const { return topics_.empty(); }
  bool takes(const Channel& channel) const;

 private:
  std::vector<std::string> topics_;  // sorted
};

}  // namespace mapwright::recording
