// Reads ROS 1 bags, version 2.0, with uncompressed, bzip2 or LZ4 chunks. Source: "ROS bag format 2.0":
// <header_len><header><data_len><data>, headers of <len>name=value.
// Our own reader, not Debian's librosbag-storage: that one throws on a bag without an index (.bag.active
// files of `rosbag record`, and every truncated bag), while we want everything intact; it trusts the lengths
// in the file, and depends on a plug-in loader, GnuPG and five Boost libraries.
#include <algorithm>
#include <array>
#include <utility>

#include "packed/codec.h"
#include "recording/chunked_source.h"

namespace mapwright::recording {
namespace {

constexpr std::string_view kBagMagic = "#ROSBAG V2.0\n";
constexpr std::uint32_t kMostHeader = 1 << 20;  // bytes: the longest field is a topic

enum class BagOp : std::uint8_t {
  Message = 2,
  BagHeader = 3,
  Index = 4,
  Chunk = 5,
  ChunkInfo = 6,
  Connection = 7
};

std::int64_t bagTimeOf(std::uint64_t stamp) {
  return std::int64_t(stamp & 0xffffffff) * 1'000'000'000 + std::int64_t(stamp >> 32);
}

std::span<const std::uint8_t> spanOf(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// The fields of a record's header, views into its bytes.
class BagFields {
 public:
  /// nullopt: they do not fill the bytes exactly, or one has no name.
  static std::optional<BagFields> in(std::span<const std::uint8_t> header) {
    BagFields fields;
    ByteReader in(header);
    while (in.left() > 0) {
      const std::string_view field = in.text();
      const std::size_t equals = field.find('=');
      if (!in.sound() || equals == std::string_view::npos || equals == 0) return std::nullopt;
      fields.all_.emplace_back(field.substr(0, equals), field.substr(equals + 1));
    }
    return fields;
  }

  std::optional<std::string_view> find(std::string_view name) const {
    for (const auto& [known, value] : all_) {
      if (known == name) return value;
    }
    return std::nullopt;
  }
  /// nullopt if it is missing or of another size.
  template <typename T>
  std::optional<T> number(std::string_view name) const {
    const auto value = find(name);
    if (!value || value->size() != sizeof(T)) return std::nullopt;
    return ByteReader(spanOf(*value)).number<T>();
  }
  std::optional<BagOp> op() const {
    const auto op = number<std::uint8_t>("op");
    return op ? std::optional(BagOp(*op)) : std::nullopt;
  }
  /// A ROS time in nanoseconds: seconds and nanoseconds, 32 bits each.
  std::optional<std::int64_t> time(std::string_view name) const {
    const auto stamp = number<std::uint64_t>(name);
    return stamp ? std::optional(bagTimeOf(*stamp)) : std::nullopt;
  }
  std::string text(std::string_view name) const { return std::string(find(name).value_or("")); }
  const std::vector<std::pair<std::string_view, std::string_view>>& all() const { return all_; }

 private:
  std::vector<std::pair<std::string_view, std::string_view>> all_;
};

/// What a Connection record describes.
std::optional<Channel> channelIn(const BagFields& header, std::span<const std::uint8_t> data) {
  const auto id = header.number<std::uint32_t>("conn");
  const std::optional<BagFields> about = BagFields::in(data);
  if (!id || !about) return std::nullopt;
  Channel channel;
  channel.id = *id;
  channel.topic = header.text("topic");  // as recorded; remapped ones differ from the other's
  if (channel.topic.empty()) channel.topic = about->text("topic");
  channel.message_encoding = "ros1";
  channel.schema_name = about->text("type");
  channel.schema_encoding = "ros1msg";
  channel.schema_data = about->text("message_definition");
  for (const auto& [name, value] : about->all()) {
    if (name != "topic" && name != "type" && name != "message_definition")
      channel.metadata.emplace(name, value);
  }
  return channel;
}

/// A record of the file, without its data.
struct BagRecord {
  BagOp op = BagOp::Message;
  std::uint64_t at = 0, data_at = 0, data_size = 0;
  std::string header;  // its bytes, which were checked when it was made
  std::uint64_t end() const { return data_at + data_size; }
  BagFields fields() const { return *BagFields::in(spanOf(header)); }
};

class Ros1Bag final : public ChunkedSource {
 public:
  using ChunkedSource::ChunkedSource;

  std::string format() const override { return "ROS bag 2.0"; }
  /// Bags have no attachments.
  std::optional<Attachment> attachment(const AttachmentLocation&) override { return std::nullopt; }

  std::optional<Failure> open();

 protected:
  std::optional<Packing> packingOf(const ChunkLocation& location) const override;
  tl::expected<UnpackedChunk, Note> unpack(const ChunkLocation& location) override;
  Message read(const UnpackedChunk& chunk, const ChunkEntry& entry) const override;
  Step readRecord(Window& window, std::uint64_t from, std::uint64_t to, std::uint64_t& past) override;
  std::uint64_t nextChunk(Window& window, std::uint64_t from, std::uint64_t to) const override;

 private:
  /// nullopt: there is none; `cut`: because `end` lies inside it.
  std::optional<BagRecord> recordAt(Window& window, std::uint64_t at, std::uint64_t end, bool& cut) const;
  bool openByIndex();
  std::optional<ChunkLocation> infoIn(const BagRecord& record) const;
  Step handleRecord(const BagRecord& record);
  Step readMessage(const BagRecord& record);
  Step readIndex(const BagRecord& record);
  Step readConnection(const BagRecord& record);
  void listRecords(UnpackedChunk& chunk, const ChunkLocation& location);

  std::uint64_t start_ = kBagMagic.size();  // after the header of the bag
  std::uint64_t index_at_ = 0;              // 0: there is none
  std::uint32_t connections_ = 0, chunk_count_ = 0;
};

std::optional<Failure> Ros1Bag::open() {
  // If the header of the bag is truncated or damaged the bag has no index.
  Window window(*bytes_);
  bool cut = false;
  const std::optional<BagRecord> record = recordAt(window, start_, bytes_->size(), cut);
  if (record && record->op == BagOp::BagHeader) {
    const BagFields fields = record->fields();
    if (!fields.text("encryptor").empty()) return Failure{Failure::Code::Encrypted, {}};
    index_at_ = fields.number<std::uint64_t>("index_pos").value_or(0);
    connections_ = fields.number<std::uint32_t>("conn_count").value_or(0);
    chunk_count_ = fields.number<std::uint32_t>("chunk_count").value_or(0);
    // Padding fills it up to 4096 bytes: a larger length is invalid, and the first chunk is searched.
    constexpr std::uint64_t kMostPadding = 4096;
    start_ = record->data_size <= kMostPadding ? record->end() : record->data_at;
  }
  if (!openByIndex()) scanAll(start_);
  return std::nullopt;
}

std::optional<BagRecord> Ros1Bag::recordAt(Window& window, std::uint64_t at, std::uint64_t end,
                                           bool& cut) const {
  BagRecord record;
  record.at = at;
  ByteReader length(window.look(at, 4, end));
  const auto header_size = length.number<std::uint32_t>();
  cut = !length.sound();
  if (cut || header_size > kMostHeader || header_size == 0) return std::nullopt;
  if (header_size + 8 > end - at) {
    cut = true;
    return std::nullopt;
  }
  record.header.resize(header_size);
  if (header_size <= Window::kMostInView / 2) {
    const auto seen = window.look(at + 4, header_size, end);
    if (seen.size() != header_size) return std::nullopt;
    record.header = ByteReader::textOf(seen);
  } else if (!bytes_->read({reinterpret_cast<std::uint8_t*>(record.header.data()), header_size}, at + 4)) {
    return std::nullopt;
  }
  const auto fields = BagFields::in(spanOf(record.header));
  if (!fields || !fields->op()) return std::nullopt;
  record.op = *fields->op();
  ByteReader data(window.look(at + 4 + header_size, 4, end));
  record.data_size = data.number<std::uint32_t>();
  record.data_at = at + 8 + header_size;
  cut = !data.sound() || record.data_size > end - record.data_at;
  return cut ? std::nullopt : std::optional(std::move(record));
}

std::optional<ChunkLocation> Ros1Bag::infoIn(const BagRecord& record) const {
  const BagFields fields = record.fields();
  const auto offset = fields.number<std::uint64_t>("chunk_pos");
  const auto first = fields.time("start_time");
  const auto last = fields.time("end_time");
  if (fields.number<std::uint32_t>("ver") != 1u || !offset || !first || !last) return std::nullopt;
  if (*offset < start_ || *offset >= index_at_ || record.data_size > limits_.most_record_bytes)
    return std::nullopt;
  const std::optional<UnpackedChunk> rows = raw(record.data_at, record.data_size);
  if (!rows) return std::nullopt;
  ChunkLocation location;
  location.offset = *offset;
  location.first_ns = *first;
  location.last_ns = *last;
  location.channels_known = true;
  ByteReader row(rows->all());
  while (row.left() >= 8) {
    ChannelShare share;
    share.channel = row.number<std::uint32_t>();
    share.count = row.number<std::uint32_t>();
    if (share.count > 0) location.shares.push_back(share);
  }
  if (location.shares.empty()) location.forgetTimes();
  return location;
}

bool Ros1Bag::openByIndex() {
  const std::uint64_t size = bytes_->size();
  const auto unusable = [&] {
    notes_.add(NoteCode::IndexUnusable, index_at_);
    return false;
  };
  if (index_at_ == 0) return false;  // the scan finds out whether it is finished
  if (index_at_ < start_ || index_at_ > size) return unusable();
  Window window(*bytes_);
  std::vector<ChunkLocation> locations;
  std::uint32_t connections = 0;
  for (std::uint64_t at = index_at_; at < size;) {
    bool cut = false;
    const std::optional<BagRecord> record = recordAt(window, at, size, cut);
    if (!record) return unusable();
    if (record->op == BagOp::Connection) {
      if (readConnection(*record) != Step::Taken) return unusable();
      ++connections;
    } else if (record->op == BagOp::ChunkInfo) {
      std::optional<ChunkLocation> location = infoIn(*record);
      if (!location) return unusable();
      locations.push_back(std::move(*location));
    }
    at = record->end();
  }
  if (locations.size() != chunk_count_ || connections != connections_) return unusable();
  std::sort(locations.begin(), locations.end(),
            [](const auto& a, const auto& b) { return a.offset < b.offset; });
  const auto twice = [](const ChunkLocation& a, const ChunkLocation& b) { return a.offset == b.offset; };
  if (std::adjacent_find(locations.begin(), locations.end(), twice) != locations.end()) return unusable();
  for (ChunkLocation& location : locations) addChunk(std::move(location));
  about_.bytes = size;
  findChannels();
  countChunks();
  return true;
}

tl::expected<UnpackedChunk, Note> Ros1Bag::unpack(const ChunkLocation& location) {
  const auto failed = [&](NoteCode code, std::string_view name = {}) {
    return tl::unexpected(Note{code, location.offset, 1, std::string(name)});
  };
  if (location.bare) {
    if (location.length > limits_.most_chunk_bytes) return failed(NoteCode::ChunkTooLarge);
    std::optional<UnpackedChunk> stored = raw(location.offset, location.length);
    if (!stored) return failed(NoteCode::Unreadable);
    listRecords(*stored, location);
    return std::move(*stored);
  }
  Window window(*bytes_);
  bool cut = false;
  const std::optional<BagRecord> record = recordAt(window, location.offset, bytes_->size(), cut);
  if (!record || record->op != BagOp::Chunk)
    return failed(cut ? NoteCode::Unreadable : NoteCode::ChunkCorrupt);
  const BagFields fields = record->fields();
  const auto size = fields.number<std::uint32_t>("size");
  if (!size) return failed(NoteCode::ChunkCorrupt);
  if (record->data_size > limits_.most_chunk_bytes || *size > limits_.most_chunk_bytes)
    return failed(NoteCode::ChunkTooLarge);
  std::optional<UnpackedChunk> stored = raw(record->data_at, record->data_size);
  if (!stored) return failed(NoteCode::Unreadable);
  const std::string compression = fields.text("compression");
  if (compression != "none" && !compression.empty()) {
    const bool bzip2 = compression == "bz2";
    if (!bzip2 && compression != "lz4") return failed(NoteCode::ChunkCompression, compression);
    auto unpacked =
        packed::unpackExactly(bzip2 ? packed::Codec::Bzip2 : packed::Codec::Lz4, stored->all(), *size);
    if (!unpacked) return failed(NoteCode::ChunkCorrupt);
    stored->size = unpacked->size;
    stored->bytes = std::move(unpacked->data);
  }
  listRecords(*stored, location);
  return std::move(*stored);
}

std::optional<Packing> Ros1Bag::packingOf(const ChunkLocation& location) const {
  Window window(*bytes_);
  bool cut = false;
  const std::optional<BagRecord> record = recordAt(window, location.offset, bytes_->size(), cut);
  if (!record || record->op != BagOp::Chunk) return std::nullopt;
  const BagFields fields = record->fields();
  std::string compression = fields.text("compression");
  if (compression == "none") compression.clear();
  return Packing{std::move(compression), 1, record->data_size,
                 fields.number<std::uint32_t>("size").value_or(0)};
}

void Ros1Bag::listRecords(UnpackedChunk& chunk, const ChunkLocation& location) {
  ByteReader in(chunk.all());
  while (in.left() > 0) {
    const std::uint64_t at = chunk.size - in.left();
    const auto header = in.piece();
    const auto data = in.piece();
    const bool whole = in.sound() && header.size() <= kMostHeader;
    const auto fields = whole ? BagFields::in(header) : std::nullopt;
    if (!fields || !fields->op()) {
      notes_.add(NoteCode::ChunkCorrupt, location.offset);  // everything before that is intact
      return;
    }
    if (fields->op() == BagOp::Message) {
      const auto channel = fields->number<std::uint32_t>("conn");
      const auto time = fields->time("time");
      if (channel && time) {
        chunk.entries.push_back({*time, at, *channel});
      } else {
        notes_.add(NoteCode::RecordCorrupt, location.offset);
      }
    } else if (fields->op() == BagOp::Connection) {
      if (std::optional<Channel> channel = channelIn(*fields, data)) {
        addChannel(std::move(*channel), location.offset);
      } else {
        notes_.add(NoteCode::RecordCorrupt, location.offset);
      }
    }
  }
}

Message Ros1Bag::read(const UnpackedChunk& chunk, const ChunkEntry& entry) const {
  ByteReader in(chunk.all().subspan(std::size_t(entry.offset)));
  Message message;
  message.publish_time_ns = entry.log_ns;
  in.piece();
  message.bytes = in.piece();
  return message;
}

ChunkedSource::Step Ros1Bag::readRecord(Window& window, std::uint64_t from, std::uint64_t to,
                                        std::uint64_t& past) {
  bool cut = false;
  const std::optional<BagRecord> record = recordAt(window, from, to, cut);
  if (record && (record->op != BagOp::Index || indexedChunk() == nullptr)) settleChunk(false);
  Step step = record ? handleRecord(*record) : cut ? Step::CutOff : Step::NoRecord;
  if (record) past = record->end();
  // A length beyond the end belongs to the last, truncated record, or is invalid.
  if (step == Step::CutOff && nextChunk(window, from + 1, to) != to) step = Step::NoRecord;
  return step;
}

ChunkedSource::Step Ros1Bag::handleRecord(const BagRecord& record) {
  switch (record.op) {
    case BagOp::Message:
      return readMessage(record);
    case BagOp::Index:
      return readIndex(record);
    case BagOp::Connection:
      return readConnection(record);
    case BagOp::Chunk: {
      ChunkLocation location;
      location.offset = record.at;
      location.length = record.end() - record.at;
      location.forgetTimes();  // known from its indexes, or its content
      addScanned(std::move(location));
      return Step::Taken;
    }
    case BagOp::ChunkInfo:
      about_.finished = true;  // this is written last
      return Step::Taken;
    case BagOp::BagHeader:
      return Step::Taken;
  }
  return Step::NoRecord;
}

ChunkedSource::Step Ros1Bag::readConnection(const BagRecord& record) {
  if (record.data_size > limits_.most_record_bytes) {
    notes_.add(NoteCode::RecordTooLarge, record.at);
    return Step::Taken;
  }
  const std::optional<UnpackedChunk> data = raw(record.data_at, record.data_size);
  if (!data) return Step::CutOff;
  std::optional<Channel> channel = channelIn(record.fields(), data->all());
  if (!channel) return Step::NoRecord;
  addChannel(std::move(*channel), record.at);
  return Step::Taken;
}

ChunkedSource::Step Ros1Bag::readIndex(const BagRecord& record) {
  const BagFields fields = record.fields();
  const auto channel = fields.number<std::uint32_t>("conn");
  const auto count = fields.number<std::uint32_t>("count");
  if (!channel || !count || fields.number<std::uint32_t>("ver") != 1u) return Step::NoRecord;
  if (std::uint64_t(*count) * 12 != record.data_size) return Step::NoRecord;
  ChunkLocation* const chunk = indexedChunk();
  if (chunk == nullptr || *count == 0) return Step::Taken;
  if (chunk->shareOf(*channel) != nullptr) return Step::Taken;           // it was counted before
  if (record.data_size > limits_.most_record_bytes) return Step::Taken;  // it will be unpacked
  const std::optional<UnpackedChunk> rows = raw(record.data_at, record.data_size);
  if (!rows) return Step::CutOff;
  chunk->share(*channel).count = *count;
  ByteReader row(rows->all());
  while (row.left() >= 12) {
    chunk->include(bagTimeOf(row.number<std::uint64_t>()));
    row.number<std::uint32_t>();
  }
  return Step::Taken;
}

/// Messages outside of chunks: nobody writes them, but the format allows it.
ChunkedSource::Step Ros1Bag::readMessage(const BagRecord& record) {
  const BagFields fields = record.fields();
  const auto channel = fields.number<std::uint32_t>("conn");
  const auto time = fields.time("time");
  if (!channel || !time) return Step::NoRecord;
  addBare(record.at, record.end() - record.at, *channel, *time);
  return Step::Taken;
}

/// A header of three fields, "compression", "op" and "size", in any order.
std::uint64_t Ros1Bag::nextChunk(Window& window, std::uint64_t from, std::uint64_t to) const {
  constexpr std::size_t kStart = 256;
  while (from < to) {
    const auto view = window.rest(from, kStart, to);
    if (view.empty()) return to;
    // The length of such a header is below 256, so its second and later bytes are zero.
    const std::string_view text = ByteReader::textOf(view);
    const std::size_t zeros = text.find(std::string_view("\0\0\0", 3));
    if (zeros == std::string_view::npos) {
      from += view.size() > 2 && from + view.size() < to ? view.size() - 2 : view.size();
      continue;
    }
    if (zeros == 0) {
      ++from;
      continue;
    }
    from += zeros - 1;
    bool cut = false;
    const std::optional<BagRecord> record = recordAt(window, from, to, cut);
    if (record && record->op == BagOp::Chunk && record->fields().number<std::uint32_t>("size") &&
        record->fields().find("compression")) {
      return from;
    }
    ++from;
  }
  return to;
}

}  // namespace

bool looksLikeBag(std::span<const std::uint8_t> start) {
  const std::string_view text = ByteReader::textOf(start);
  return text.starts_with("#ROSBAG V") || text.starts_with("#ROSRECORD V") || text.starts_with("#ROSLOG V");
}

Opened openBag(std::unique_ptr<Bytes> bytes, const Limits& limits) {
  std::array<std::uint8_t, kBagMagic.size()> magic{};
  if (!bytes->read(magic, 0)) return tl::unexpected(Failure{Failure::Code::NotOne, {}});
  if (ByteReader::textOf(magic) != kBagMagic) return tl::unexpected(Failure{Failure::Code::Version, {}});
  auto reader = std::make_unique<Ros1Bag>(std::move(bytes), limits);
  if (const std::optional<Failure> failure = reader->open()) return tl::unexpected(*failure);
  return reader;
}

}  // namespace mapwright::recording
