// The messages of chunks that may overlap, merged by time.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include <queue>

#include "recording/chunked_source.h"

namespace mapwright::recording {

/// Opens a chunk only when it may be needed, and keeps none: unpacked chunks are in the source's bounded
/// store, so many overlapping chunks cost time but no memory.
class ChunkCursor final : public Cursor {
 public:
  ChunkCursor(ChunkedSource& source, const Query& query);
  std::optional<Message> next() override;

 private:
  /// The next message of a chunk. Order: log time, chunk in the file, position in the chunk.
  struct Head {
    std::int64_t log_ns = 0;
    std::uint32_t chunk = 0;
    std::size_t entry = 0;  // of UnpackedChunk::entries
  };
  struct Later {
    bool backwards = false;
    bool operator()(const Head& a, const Head& b) const;
  };
  bool wants(std::uint32_t channel);
  bool mayHold(const ChunkPlace& place);
  void openThose();
  /// Adds the first matching message from `entry` on (in reading direction) to the heads.
  void push(std::uint32_t chunk, const UnpackedChunk& unpacked, std::size_t entry);

  ChunkedSource& source_;
  Query query_;
  ChannelChoice choice_;
  std::unordered_map<std::uint32_t, bool> wanted_;
  std::vector<std::uint32_t> waiting_;  // chunks not opened yet, the next one at the back
  std::priority_queue<Head, std::vector<Head>, Later> heads_;
};

}  // namespace mapwright::recording
