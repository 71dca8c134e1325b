#include "recording/mcap_writer.h"

#include <algorithm>
#include <cerrno>
#include <limits>

#include "packed/codec.h"

namespace mapwright::recording {
namespace {

constexpr std::size_t kMostIds = 65'535;
constexpr std::size_t kMostText = std::size_t(32) << 20;
constexpr std::int64_t kRetryEveryNs = 1'000'000'000;

std::uint64_t stampOf(std::int64_t time_ns) { return std::uint64_t(std::max<std::int64_t>(time_ns, 0)); }

std::size_t textOf(const Channel& channel) {
  std::size_t bytes = channel.topic.size() + channel.message_encoding.size() + channel.schema_name.size() +
                      channel.schema_encoding.size() + channel.schema_data.size();
  for (const auto& [key, value] : channel.metadata) bytes += key.size() + value.size();
  return bytes;
}

}  // namespace

McapWriter::McapWriter(std::unique_ptr<AppendTarget> target, WriterOptions options)
    : target_(std::move(target)), options_(std::move(options)) {}

tl::expected<std::unique_ptr<McapWriter>, disk::FileError> McapWriter::create(
    std::unique_ptr<AppendTarget> target, WriterOptions options) {
  std::unique_ptr<McapWriter> writer(new McapWriter(std::move(target), std::move(options)));
  mcap::RecordWriter start;
  start.raw(mcap::kMagic);
  mcap::write(start, mcap::Header{writer->options_.profile, writer->options_.library});
  if (std::optional<disk::FileError> fault = writer->append(start.bytes())) {
    writer->closed_ = true;
    return tl::unexpected(std::move(*fault));
  }
  return writer;
}

McapWriter::~McapWriter() { close(); }

disk::FileError McapWriter::refuse(int error) {
  ++progress_.lost;
  return disk::systemError({}, error);
}

std::optional<disk::FileError> McapWriter::append(std::span<const std::uint8_t> bytes) {
  if (std::optional<disk::FileError> fault = target_->append(bytes)) return fault;
  crc_ = packed::crc32(crc_, bytes);
  progress_.bytes += bytes.size();
  return options_.survive_power_loss ? target_->settle() : std::nullopt;
}

std::optional<ChannelId> McapWriter::addChannel(const Channel& channel) {
  mcap::ChannelRecord record{0, 0, channel.topic, channel.message_encoding, channel.metadata};
  const bool has_schema = !channel.schema_name.empty() || !channel.schema_encoding.empty();
  if (textOf(channel) > kMostText) return std::nullopt;
  const auto schema = std::tuple(channel.schema_name, channel.schema_encoding, channel.schema_data);
  if (has_schema) {
    const auto same = schema_ids_.find(schema);
    if (same == schema_ids_.end() && schemas_.size() == kMostIds) return std::nullopt;
    record.schema_id = same == schema_ids_.end() ? std::uint16_t(schemas_.size() + 1) : same->second;
  }
  const auto same = std::tuple(record.topic, record.schema_id, record.message_encoding, record.metadata);
  if (const auto known = channel_ids_.find(same); known != channel_ids_.end()) return known->second;
  if (channels_.size() == kMostIds) return std::nullopt;
  if (record.schema_id > schemas_.size()) {
    schema_ids_[schema] = record.schema_id;
    schemas_.push_back({record.schema_id, channel.schema_name, channel.schema_encoding, channel.schema_data});
    described_schema_.push_back(false);
  }
  record.id = ChannelId(channels_.size() + 1);
  channel_ids_[same] = record.id;
  channels_.push_back(std::move(record));
  described_channel_.push_back(false);
  return ChannelId(channels_.size());
}

void McapWriter::describe(ChannelId channel) {
  const std::size_t at = std::size_t(channel) - 1;
  if (described_channel_[at]) return;
  described_channel_[at] = true;
  if (const std::size_t schema = channels_[at].schema_id; schema != 0 && !described_schema_[schema - 1]) {
    described_schema_[schema - 1] = true;
    mcap::write(open_.records, schemas_[schema - 1]);
  }
  mcap::write(open_.records, channels_[at]);
}

bool McapWriter::mayTry(std::int64_t now_ns) const {
  // A clock that was set back must not cause a wait.
  return !fault_ || now_ns < failed_ns_ || now_ns - failed_ns_ >= kRetryEveryNs;
}

std::optional<disk::FileError> McapWriter::seen(std::optional<disk::FileError> fault, std::int64_t now_ns) {
  fault_ = fault;
  failed_ns_ = now_ns;
  return fault;
}

std::optional<disk::FileError> McapWriter::write(ChannelId channel, const Stamp& stamp,
                                                 std::span<const std::uint8_t> bytes) {
  if (data_ended_ || channel == 0 || channel > channels_.size()) return refuse(EINVAL);
  if (bytes.size() > kMostMessageBytes) return refuse(EMSGSIZE);
  const std::int64_t now_ns = stamp.log_time_ns;
  const bool full = open_.records.size() >= options_.chunk_bytes;
  const bool old = open_.messages > 0 && now_ns - open_.first_ns >= options_.chunk_ns;
  std::optional<disk::FileError> fault = fault_;
  if ((full || old || due_) && mayTry(now_ns)) fault = seen(full || old ? closeChunk() : writeDue(), now_ns);
  if (fault && open_.records.size() >= options_.chunk_bytes) {
    ++progress_.lost;
    return fault;
  }
  describe(channel);
  const std::uint64_t log_time = stampOf(stamp.log_time_ns);
  if (open_.messages == 0) {
    open_.first_ns = now_ns;
    open_.start = open_.end = log_time;
  }
  open_.start = std::min(open_.start, log_time);
  open_.end = std::max(open_.end, log_time);
  ++open_.messages;
  open_.index[channel].emplace_back(log_time, open_.records.size());
  open_.records.u8(std::uint8_t(mcap::Op::Message)).u64(mcap::kMessageHead + bytes.size());
  open_.records.u16(channel).u32(stamp.sequence).u64(log_time).u64(stampOf(stamp.publish_time_ns)).raw(bytes);
  ++progress_.messages;
  if (!fault && open_.records.size() >= options_.chunk_bytes) fault = seen(closeChunk(), now_ns);
  return fault;
}

std::optional<disk::FileError> McapWriter::tick(std::int64_t now_ns) {
  const bool old = open_.messages > 0 && now_ns - open_.first_ns >= options_.chunk_ns;
  if (!mayTry(now_ns)) return fault_;
  if (!old && !due_) return std::nullopt;
  return seen(old ? closeChunk() : writeDue(), now_ns);
}

std::optional<disk::FileError> McapWriter::flush() { return seen(closeChunk(), failed_ns_); }

std::optional<disk::FileError> McapWriter::closeChunk() {
  if (std::optional<disk::FileError> fault = writeDue()) return fault;
  if (open_.messages == 0) return std::nullopt;
  pack();
  return writeDue();
}

void McapWriter::pack() {
  const std::span<const std::uint8_t> records = open_.records.bytes();
  packed::ByteBuffer packed;
  if (options_.compression == WriterOptions::Compression::Zstd)
    packed = packed::packZstd(records, options_.level);
  // Data that does not get smaller, or if there is not enough memory, is written uncompressed.
  const bool smaller = packed.data && packed.size < records.size();
  const std::span<const std::uint8_t> stored = smaller ? packed.bytes() : records;

  Due due;
  due.index.start = open_.start;
  due.index.end = open_.end;
  due.index.compression = smaller ? "zstd" : "";
  due.index.packed_size = stored.size();
  due.index.unpacked_size = records.size();
  due.messages = open_.messages;
  mcap::RecordWriter head;
  head.u8(std::uint8_t(mcap::Op::Chunk)).u64(40 + due.index.compression.size() + stored.size());
  head.u64(open_.start).u64(open_.end).u64(records.size()).u32(packed::crc32(0, records));
  head.text(due.index.compression).u64(stored.size());
  due.index.length = head.size() + stored.size();

  mcap::RecordWriter indexes;
  for (auto& [channel, entries] : open_.index) {
    std::stable_sort(entries.begin(), entries.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    due.index.index_offsets.emplace_back(channel, due.index.length + indexes.size());
    due.messages_of[channel] = entries.size();
    mcap::write(indexes, mcap::MessageIndex{channel, entries});
  }
  due.index.index_length = indexes.size();
  due.bytes.reserve(std::size_t(due.index.length) + indexes.size());
  for (const auto part : {head.bytes(), stored, indexes.bytes()}) {
    due.bytes.insert(due.bytes.end(), part.begin(), part.end());
  }
  due_ = std::move(due);
  open_.records.clear();
  open_.index.clear();
  open_.messages = 0;
}

std::optional<disk::FileError> McapWriter::writeDue() {
  if (!due_) return std::nullopt;
  const std::uint64_t at = progress_.bytes;
  std::optional<disk::FileError> fault = append(due_->bytes);
  if (progress_.bytes == at) return fault;
  due_->index.offset = at;
  for (auto& [channel, offset] : due_->index.index_offsets) offset += at;
  statistics_.start =
      statistics_.messages == 0 ? due_->index.start : std::min(statistics_.start, due_->index.start);
  statistics_.end = std::max(statistics_.end, due_->index.end);
  statistics_.messages += due_->messages;
  progress_.in_chunks = statistics_.messages;
  for (const auto& [channel, count] : due_->messages_of) messages_of_[channel] += count;
  chunk_indexes_.push_back(std::move(due_->index));
  ++progress_.chunks;
  due_.reset();
  return fault;  // it is in the file, but was not flushed to disk
}

std::optional<disk::FileError> McapWriter::attach(const Attachment& attachment) {
  if (data_ended_) return disk::systemError({}, EINVAL);
  const auto data =
      std::span(reinterpret_cast<const std::uint8_t*>(attachment.bytes.data()), attachment.bytes.size());
  mcap::RecordWriter record;
  record.begin(mcap::Op::Attachment);
  record.u64(stampOf(attachment.log_time_ns)).u64(stampOf(attachment.create_time_ns));
  record.text(attachment.name).text(attachment.media_type).u64(data.size()).raw(data);
  record.u32(packed::crc32(0, record.bytes().subspan(mcap::kRecordHead)));
  record.end();
  const std::uint64_t at = progress_.bytes;
  std::optional<disk::FileError> fault = append(record.bytes());
  if (progress_.bytes == at) return fault;
  const AttachmentLocation location{attachment.name,
                                    attachment.media_type,
                                    std::int64_t(stampOf(attachment.log_time_ns)),
                                    std::int64_t(stampOf(attachment.create_time_ns)),
                                    data.size(),
                                    at};
  attachments_.push_back({at, record.size(), location});
  return fault;
}

std::optional<disk::FileError> McapWriter::addMetadata(const Metadata& metadata) {
  if (data_ended_) return disk::systemError({}, EINVAL);
  mcap::RecordWriter record;
  mcap::write(record, mcap::MetadataRecord{metadata});
  const std::uint64_t at = progress_.bytes;
  std::optional<disk::FileError> fault = append(record.bytes());
  if (progress_.bytes != at) metadata_.push_back({at, record.size(), metadata.name});
  return fault;
}

mcap::RecordWriter McapWriter::summary(std::uint64_t at) const {
  mcap::RecordWriter out, offsets;
  const auto group = [&]<typename Record>(const std::vector<Record>& records) {
    const std::size_t start = out.size();
    for (const Record& record : records) mcap::write(out, record);
    if (records.empty()) return;
    offsets.begin(mcap::Op::SummaryOffset);
    offsets.u8(std::uint8_t(Record::kOp)).u64(at + start).u64(out.size() - start);
    offsets.end();
  };
  mcap::Statistics all = statistics_;
  all.schemas = std::uint16_t(schemas_.size());
  all.channels = std::uint32_t(channels_.size());
  all.attachments = std::uint32_t(attachments_.size());
  all.metadata = std::uint32_t(metadata_.size());
  all.chunks = std::uint32_t(chunk_indexes_.size());
  all.messages_of.assign(messages_of_.begin(), messages_of_.end());
  group(schemas_);
  group(channels_);
  group(std::vector{all});
  group(chunk_indexes_);
  group(attachments_);
  group(metadata_);
  const std::uint64_t offsets_start = at + out.size();
  out.raw(offsets.bytes());
  out.u8(std::uint8_t(mcap::Op::Footer)).u64(mcap::kFooterContent).u64(at).u64(offsets_start);
  out.u32(packed::crc32(0, out.bytes())).raw(mcap::kMagic);
  return out;
}

std::optional<disk::FileError> McapWriter::close() {
  if (closed_) return std::nullopt;
  if (std::optional<disk::FileError> fault = closeChunk()) return fault;
  // Channels without messages.
  for (std::size_t i = 0; i < channels_.size(); ++i) describe(ChannelId(i + 1));
  mcap::RecordWriter end = open_.records;
  std::uint32_t crc = packed::crc32(crc_, end.bytes());
  end.begin(mcap::Op::DataEnd);
  end.u32(crc);
  end.end();
  end.raw(summary(progress_.bytes + end.size()).bytes());
  const std::uint64_t before = progress_.bytes;
  std::optional<disk::FileError> fault = append(end.bytes());
  if (progress_.bytes == before) return fault;
  data_ended_ = closed_ = true;
  open_.records.clear();
  return options_.survive_power_loss ? fault : target_->settle();
}

}  // namespace mapwright::recording
