#include "recording/mcap_records.h"

#include <limits>

namespace mapwright::recording::mcap {

std::optional<ChunkHead> chunkHeadIn(std::span<const std::uint8_t> content, std::uint64_t length) {
  ByteReader in(content);
  ChunkHead head;
  in.numbers(head.start, head.end, head.unpacked_size, head.crc);
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

RecordWriter& RecordWriter::text(std::string_view text) {
  text = text.substr(0, std::numeric_limits<std::uint32_t>::max());
  u32(std::uint32_t(text.size()));
  bytes_.append(text);
  return *this;
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

}  // namespace mapwright::recording::mcap
