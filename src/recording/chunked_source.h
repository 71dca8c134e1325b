// Common to MCAP and bags: messages in chunks with known time ranges. Merges overlapping chunks, keeps
// recently unpacked ones, finds the last message before a time, scans files without an index. Formats derive
// from it.
#pragma once

#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <tl/expected.hpp>

#include "recording/source.h"

namespace mapwright::recording {

/// What a chunk contains of one channel.
struct ChannelShare {
  std::uint32_t channel = 0;
  std::uint64_t count = 0;  // messages; 0: unknown
};

/// Where a chunk is, and what is known of it without unpacking.
struct ChunkLocation {
  std::uint64_t offset = 0;                // of its record in the file, or of the first of the bare records
  std::uint64_t length = 0;                // bytes in the file; 0: stated in its record
  bool bare = false;                       // records outside of any chunk
  std::int64_t first_ns = 0, last_ns = 0;  // log times; first_ns > last_ns: no messages
  bool channels_known = false;
  bool looked_into = false;          // its problems have been noted
  std::vector<ChannelShare> shares;  // by channel

  const ChannelShare* shareOf(std::uint32_t channel) const;
  /// The share of a channel; a new one is empty.
  ChannelShare& share(std::uint32_t channel);
  /// They are found out when it is unpacked.
  void forgetTimes();
  void include(std::int64_t time_ns);
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
  ChunkedSource(std::unique_ptr<Bytes> bytes, const Limits& limits)
      : bytes_(std::move(bytes)), limits_(limits) {}
  Summary summary() const override;
  std::vector<ChannelPtr> channels() const override;
  std::unique_ptr<Cursor> messages(const Query& query) override;
  std::vector<Message> lastBefore(std::int64_t at_ns, const std::vector<std::string>& topics) override;
  std::map<std::uint32_t, std::int64_t> outermostTimes(const std::set<std::uint32_t>& channels,
                                                       bool last) override;
  std::vector<Packing> packing() const override;
  const std::vector<AttachmentLocation>& attachments() const override { return attachments_; }
  const std::vector<Metadata>& metadata() const override { return metadata_; }
  bool refresh() override;

 protected:
  /// To be implemented by the format. Returns the bytes of the chunk and its messages in any order; channels
  /// described in it are added with addChannel().
  virtual tl::expected<UnpackedChunk, Note> unpack(const ChunkLocation& location) = 0;
  /// A message of a chunk; the caller sets its channel. The entry comes from unpack().
  virtual Message read(const UnpackedChunk& chunk, const ChunkEntry& entry) const = 0;
  /// Of one chunk, from its header; nullopt: it cannot be read.
  virtual std::optional<Packing> packingOf(const ChunkLocation& location) const = 0;

  enum class Step : std::uint8_t {
    Taken,
    NoRecord,
    CutOff,    // `to` lies inside the record
    DataEnds,  // and the file is complete
  };
  /// While scanning: takes the record at `from`, which ends at `past`.
  virtual Step readRecord(Window& window, std::uint64_t from, std::uint64_t to, std::uint64_t& past) = 0;
  /// Where the next intact chunk begins; `to`: nowhere.
  virtual std::uint64_t nextChunk(Window& window, std::uint64_t from, std::uint64_t to) const = 0;
  /// Forgets everything and scans the file from `start` on.
  void scanAll(std::uint64_t start);
  /// Reads all records in [from, to); returns the position of the first incomplete one, or `to`.
  std::uint64_t scan(std::uint64_t from, std::uint64_t to);
  /// A chunk that was scanned; its message indexes follow.
  void addScanned(ChunkLocation location);
  /// The chunk whose message indexes are being scanned; null: none.
  ChunkLocation* indexedChunk() { return indexes_follow_ && !chunks_.empty() ? &chunks_.back() : nullptr; }
  /// That chunk is complete: looks up in it what its indexes do not tell.
  void settleChunk(bool doubtful);
  /// A message outside of any chunk.
  void addBare(std::uint64_t at, std::uint64_t bytes, std::uint32_t channel, std::int64_t time_ns);

  void addChannel(Channel channel, std::uint64_t offset);
  /// Must come after all others in the file, otherwise call sortChunks().
  void addChunk(ChunkLocation location);
  std::vector<ChunkLocation>& chunks() { return chunks_; }
  void sortChunks();
  /// Unpacks it to get its times, channels and counts.
  void lookInto(std::size_t chunk);
  /// Unpacks the chunks that may describe unknown channels.
  void findChannels();
  /// Computes counts and times from what is known of the chunks.
  void countChunks();
  /// Bytes of the file; nullopt: missing, or not enough memory.
  std::optional<UnpackedChunk> raw(std::uint64_t at, std::uint64_t count) const;

  std::unique_ptr<Bytes> bytes_;
  Limits limits_;
  Notes notes_;
  Summary about_;  // everything except the counts
  std::vector<AttachmentLocation> attachments_;
  std::vector<Metadata> metadata_;
  std::uint64_t scanned_to_ = 0;  // of a file without an end

 private:
  friend class ChunkCursor;
  /// A message by its position in the order of messages.
  struct Position {
    std::int64_t log_ns = 0;
    std::size_t chunk = 0, entry = 0;
    auto operator<=>(const Position&) const = default;
  };
  using Positions = std::unordered_map<std::uint32_t, Position>;  // by channel
  struct Held {
    std::size_t chunk = 0;
    UnpackedPtr unpacked;
    std::size_t bytes = 0;
  };
  std::list<Held>::iterator heldAt(std::size_t chunk);
  UnpackedPtr unpacked(std::size_t chunk);
  void forgetOrder();
  void dropUnknown(UnpackedChunk& chunk, std::uint64_t offset);
  void learn(ChunkLocation& location, const UnpackedChunk& unpacked);
  /// The first of each of these channels, or (backwards) the last at or before `at_ns`. All of them in one
  /// walk over the chunks: there may be as many channels as messages. `found` is called for each, before its
  /// chunk is forgotten; again where a better one turns up.
  template <typename OnFound>
  void outermost(const std::set<std::uint32_t>& channels, bool backwards, std::int64_t at_ns, OnFound found);
  const std::vector<std::uint32_t>& latestFirst();
  std::vector<std::uint32_t> earliestFirst() const;
  Message messageAt(const UnpackedChunk& chunk, const ChunkEntry& entry) const;

  std::vector<ChunkLocation> chunks_;  // in file order
  std::map<std::uint32_t, ChannelPtr> channels_;
  std::set<std::uint32_t> channels_in_chunks_;
  bool indexes_follow_ = false;              // the preceding records were a chunk and its message indexes
  std::vector<std::uint32_t> latest_first_;  // chunks by last_ns; empty: not sorted yet

  std::list<Held> held_;  // used last in front
  std::size_t held_bytes_ = 0;
};

/// Whether the first bytes are those of the format, of any version.
bool looksLikeMcap(std::span<const std::uint8_t> start);
bool looksLikeBag(std::span<const std::uint8_t> start);
Opened openMcap(std::unique_ptr<Bytes> bytes, const Limits& limits);
Opened openBag(std::unique_ptr<Bytes> bytes, const Limits& limits);

}  // namespace mapwright::recording
