// Reads ROS 1 bags, version 2.0, with uncompressed, bzip2 or LZ4 chunks. Source: "ROS bag format 2.0".
// Our own reader, not Debian's librosbag-storage: that one throws on a bag without an index (.bag.active
// files of `rosbag record`, and every truncated bag), while we want everything intact; it trusts the lengths
// in the file, and depends on a plug-in loader, GnuPG and five Boost libraries.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "recording/bag_records.h"
#include "recording/chunked_source.h"

namespace mapwright::recording {

/// Whether the first bytes are those of a bag, of any version.
bool looksLikeBag(std::span<const std::uint8_t> start);

class Ros1Bag final : public ChunkedSource {
 public:
  static Opened open(std::unique_ptr<Bytes> bytes, const Limits& limits = {});

  /// Bags have no attachments.
  std::optional<Attachment> attachment(const AttachmentPlace&) override { return std::nullopt; }
  bool refresh() override;
  std::string format() const override { return "ROS bag 2.0"; }

 protected:
  std::optional<Packing> packingOf(const ChunkPlace& place) const override;
  tl::expected<UnpackedChunk, Note> unpack(const ChunkPlace& place) override;
  Message read(const UnpackedChunk& chunk, const ChunkEntry& entry) const override;
  Latest latestByIndex(const ChunkPlace& place, const ChannelShare& share, std::int64_t at_ns) override;

 private:
  /// A record of the file, without its data.
  struct Head {
    bag::Op op = bag::Op::Message;
    std::uint64_t at = 0, data_at = 0, data_size = 0;
    std::string header;  // its bytes
    std::uint64_t end() const { return data_at + data_size; }
    bag::Fields fields() const;
  };
  enum class Step : std::uint8_t { Taken, NoRecord, CutOff };
  using ChunkedSource::ChunkedSource;

  std::optional<Failure> readStart();
  std::optional<Head> headAt(Window& window, std::uint64_t at, std::uint64_t end, bool& cut) const;
  bool openByIndex();
  void scanAll();
  std::uint64_t scan(std::uint64_t from, std::uint64_t to);
  Step take(const Head& head);
  Step takeMessage(const Head& head);
  Step takeIndex(const Head& head);
  Step takeConnection(const Head& head);
  std::optional<ChunkPlace> infoIn(const Head& head) const;
  std::uint64_t nextChunk(Window& window, std::uint64_t from, std::uint64_t to) const;
  void settleChunk(bool doubtful);
  void listRecords(UnpackedChunk& chunk, const ChunkPlace& place);

  std::uint64_t start_ = 0;     // after the header of the bag
  std::uint64_t index_at_ = 0;  // 0: there is none
  std::uint32_t connections_ = 0, chunk_count_ = 0;
  std::uint64_t scanned_to_ = 0;
  bool indexes_follow_ = false;
};

}  // namespace mapwright::recording
