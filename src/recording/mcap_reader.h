// Reads MCAP, version 0. Source: MCAP format specification.
// A file with an index is opened by the index; everything between its chunks is scanned, so messages outside
// of chunks are found, too. A file without an index, or with a damaged one, is scanned from start to end:
// chunks are unpacked only if their message indexes do not tell what they contain. After invalid bytes,
// reading continues with the next intact chunk.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>

#include "recording/chunked_source.h"
#include "recording/mcap_records.h"

namespace mapwright::recording {

/// Whether the first bytes are those of MCAP, of any version.
bool looksLikeMcap(std::span<const std::uint8_t> start);

class McapReader final : public ChunkedSource {
 public:
  static Opened open(std::unique_ptr<Bytes> bytes, const Limits& limits = {});

  std::optional<Attachment> attachment(const AttachmentPlace& place) override;
  bool refresh() override;
  std::string format() const override { return "MCAP"; }

 protected:
  std::optional<Packing> packingOf(const ChunkPlace& place) const override;
  tl::expected<UnpackedChunk, Note> unpack(const ChunkPlace& place) override;
  Message read(const UnpackedChunk& chunk, const ChunkEntry& entry) const override;
  Latest latestByIndex(const ChunkPlace& place, const ChannelShare& share, std::int64_t at_ns) override;

 private:
  struct RecordHead {
    mcap::Op op = mcap::Op::Header;
    std::uint64_t at = 0;      // of the record
    std::uint64_t length = 0;  // of its content
    std::uint64_t content() const { return at + mcap::kRecordHead; }
    std::uint64_t end() const { return content() + length; }
  };
  using ChunkedSource::ChunkedSource;

  // mcap_index.cpp
  std::optional<mcap::Footer> findFooter(std::uint64_t size) const;
  /// False: there is no usable index, which is noted.
  bool openByIndex(const mcap::Footer& footer, std::uint64_t footer_at);
  bool sumFits(const mcap::Footer& footer, std::uint64_t footer_at) const;
  bool takeChunkIndexes(std::vector<mcap::ChunkIndex>& indexes, std::uint64_t data_end);
  void lookBetween(std::uint64_t data_end);

  // mcap_scan.cpp
  /// Reads all records in [from, to); returns the position of the first incomplete one, or `to`.
  std::uint64_t scan(std::uint64_t from, std::uint64_t to);
  enum class Step : std::uint8_t { Taken, NoRecord, CutOff, DataEnds };
  /// An unknown record may be skipped if another one follows it. Source: MCAP format specification, "Records"
  /// (opcodes 0x10 to 0x7F are for later versions, 0x80 and above are private).
  static bool leadsOn(Window& window, const RecordHead& head, std::uint64_t to);
  Step take(Window& window, const RecordHead& head, std::uint64_t to);
  Step takeChunk(Window& window, const RecordHead& head, std::uint64_t to);
  Step takeMessage(Window& window, const RecordHead& head);
  Step takeIndex(Window& window, const RecordHead& head);
  Step takeAttachment(Window& window, const RecordHead& head);
  Step takeSmall(const RecordHead& head);
  std::uint64_t nextChunk(Window& window, std::uint64_t from, std::uint64_t to) const;
  /// The previous chunk is complete: looks up in it what its indexes do not tell.
  void settleChunk(bool doubtful);
  void scanAll();

  void takeSchema(std::span<const std::uint8_t> content, std::uint64_t at);
  void takeChannel(std::span<const std::uint8_t> content, std::uint64_t at);
  void listRecords(UnpackedChunk& chunk, const ChunkPlace& place);

  std::map<std::uint16_t, mcap::Schema> schemas_;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> gaps_;  // between the indexed chunks
  std::uint64_t scanned_to_ = 0;                               // of a file without an end
  bool indexes_follow_ = false;  // the preceding records were a chunk and its message indexes
};

}  // namespace mapwright::recording
