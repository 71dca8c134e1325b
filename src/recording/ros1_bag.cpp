#include "recording/ros1_bag.h"

#include <algorithm>
#include <array>

#include "packed/codec.h"

namespace mapwright::recording {
namespace {

std::optional<packed::Codec> codecOf(std::string_view compression) {
  if (compression == "bz2") return packed::Codec::Bzip2;
  if (compression == "lz4") return packed::Codec::Lz4;
  return std::nullopt;
}

}  // namespace

bool looksLikeBag(std::span<const std::uint8_t> start) {
  const std::string_view text = ByteReader::textOf(start);
  return text.starts_with("#ROSBAG V") || text.starts_with("#ROSRECORD V") || text.starts_with("#ROSLOG V");
}

bag::Fields Ros1Bag::Head::fields() const {
  // Checked when the head was made.
  return *bag::Fields::in(std::span(reinterpret_cast<const std::uint8_t*>(header.data()), header.size()));
}

Opened Ros1Bag::open(std::unique_ptr<Bytes> bytes, const Limits& limits) {
  std::array<std::uint8_t, bag::kMagic.size()> magic{};
  if (!bytes->read(magic, 0) || !looksLikeBag(magic))
    return tl::unexpected(Failure{Failure::Code::NotOne, {}});
  if (ByteReader::textOf(magic) != bag::kMagic) return tl::unexpected(Failure{Failure::Code::Version, {}});
  std::unique_ptr<Ros1Bag> reader(new Ros1Bag(std::move(bytes), limits));
  if (const std::optional<Failure> failure = reader->readStart()) return tl::unexpected(*failure);
  if (!reader->openByIndex()) reader->scanAll();
  return reader;
}

/// The header of the bag. If it is truncated or damaged the bag has no index.
std::optional<Failure> Ros1Bag::readStart() {
  start_ = bag::kMagic.size();
  const std::uint64_t size = bytes_->size();
  Window window(*bytes_);
  bool cut = false;
  const std::optional<Head> head = headAt(window, start_, size, cut);
  if (!head || head->op != bag::Op::BagHeader) return std::nullopt;
  const bag::Fields fields = head->fields();
  if (!fields.text("encryptor").empty()) return Failure{Failure::Code::Encrypted, {}};
  index_at_ = fields.number<std::uint64_t>("index_pos").value_or(0);
  connections_ = fields.number<std::uint32_t>("conn_count").value_or(0);
  chunk_count_ = fields.number<std::uint32_t>("chunk_count").value_or(0);
  // Padding fills it up to 4096 bytes: a larger length is invalid, and the first chunk is searched.
  constexpr std::uint64_t kMostPadding = 4096;
  start_ = head->data_size <= kMostPadding ? head->end() : head->data_at;
  return std::nullopt;
}

std::optional<Ros1Bag::Head> Ros1Bag::headAt(Window& window, std::uint64_t at, std::uint64_t end,
                                             bool& cut) const {
  cut = false;
  Head head;
  head.at = at;
  ByteReader length(window.look(at, 4, end));
  const auto header_size = length.number<std::uint32_t>();
  cut = !length.sound();
  if (cut || header_size > bag::kMostHeader || header_size == 0) return std::nullopt;
  if (header_size + 8 > end - at) {
    cut = true;
    return std::nullopt;
  }
  head.header.resize(header_size);
  if (header_size <= Window::kMostInView / 2) {
    const auto seen = window.look(at + 4, header_size, end);
    if (seen.size() != header_size) return std::nullopt;
    head.header = ByteReader::textOf(seen);
  } else if (!bytes_->read({reinterpret_cast<std::uint8_t*>(head.header.data()), header_size}, at + 4)) {
    return std::nullopt;
  }
  const auto fields = bag::Fields::in(
      std::span(reinterpret_cast<const std::uint8_t*>(head.header.data()), head.header.size()));
  if (!fields || !fields->op()) return std::nullopt;
  head.op = *fields->op();
  ByteReader data(window.look(at + 4 + header_size, 4, end));
  head.data_size = data.number<std::uint32_t>();
  head.data_at = at + 8 + header_size;
  if (!data.sound() || head.data_size > end - head.data_at) {
    cut = true;
    return std::nullopt;
  }
  return head;
}

tl::expected<UnpackedChunk, Note> Ros1Bag::unpack(const ChunkPlace& place) {
  const auto failed = [&](NoteCode code, std::string_view name = {}) {
    return tl::unexpected(Note{code, place.offset, 1, std::string(name)});
  };
  if (place.bare) {
    if (place.length > limits_.most_chunk_bytes) return failed(NoteCode::ChunkTooLarge);
    std::optional<UnpackedChunk> stored = raw(place.offset, place.length);
    if (!stored) return failed(NoteCode::Unreadable);
    listRecords(*stored, place);
    return std::move(*stored);
  }
  Window window(*bytes_);
  bool cut = false;
  const std::optional<Head> head = headAt(window, place.offset, bytes_->size(), cut);
  if (!head || head->op != bag::Op::Chunk) return failed(cut ? NoteCode::Unreadable : NoteCode::ChunkCorrupt);
  const bag::Fields fields = head->fields();
  const auto size = fields.number<std::uint32_t>("size");
  if (!size) return failed(NoteCode::ChunkCorrupt);
  if (head->data_size > limits_.most_chunk_bytes || *size > limits_.most_chunk_bytes) {
    return failed(NoteCode::ChunkTooLarge);
  }
  std::optional<UnpackedChunk> stored = raw(head->data_at, head->data_size);
  if (!stored) return failed(NoteCode::Unreadable);
  const std::string compression = fields.text("compression");
  if (compression != "none" && !compression.empty()) {
    const std::optional<packed::Codec> codec = codecOf(compression);
    if (!codec) return failed(NoteCode::ChunkCompression, compression);
    auto unpacked = packed::unpackExactly(*codec, stored->all(), *size);
    if (!unpacked) return failed(NoteCode::ChunkCorrupt);
    stored->size = unpacked->size;
    stored->bytes = std::move(unpacked->data);
  }
  listRecords(*stored, place);
  return std::move(*stored);
}

std::optional<Packing> Ros1Bag::packingOf(const ChunkPlace& place) const {
  Window window(*bytes_);
  bool cut = false;
  const std::optional<Head> head = headAt(window, place.offset, bytes_->size(), cut);
  if (!head || head->op != bag::Op::Chunk) return std::nullopt;
  const bag::Fields fields = head->fields();
  std::string compression = fields.text("compression");
  if (compression == "none") compression.clear();
  return Packing{std::move(compression), 1, head->data_size,
                 fields.number<std::uint32_t>("size").value_or(0)};
}

void Ros1Bag::listRecords(UnpackedChunk& chunk, const ChunkPlace& place) {
  ByteReader in(chunk.all());
  while (in.left() > 0) {
    const std::uint64_t at = chunk.size - in.left();
    const std::optional<bag::Record> record = bag::recordIn(in);
    if (!record) {
      notes_.add(NoteCode::ChunkCorrupt, place.offset);  // everything before that is intact
      return;
    }
    if (record->header.op() == bag::Op::Message) {
      const auto channel = record->header.number<std::uint32_t>("conn");
      const auto time = record->header.time("time");
      if (channel && time) {
        chunk.entries.push_back({*time, at, *channel});
      } else {
        notes_.add(NoteCode::RecordCorrupt, place.offset);
      }
    } else if (record->header.op() == bag::Op::Connection) {
      if (std::optional<Channel> channel = bag::channelIn(*record)) {
        addChannel(std::move(*channel), place.offset);
      } else {
        notes_.add(NoteCode::RecordCorrupt, place.offset);
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

ChunkedSource::Latest Ros1Bag::latestByIndex(const ChunkPlace& place, const ChannelShare& share,
                                             std::int64_t at_ns) {
  // The indexes follow the chunk, one for each channel, in any order.
  const std::uint64_t size = bytes_->size();
  Window window(*bytes_);
  bool cut = false;
  std::optional<Head> head = headAt(window, place.offset, size, cut);
  for (std::size_t i = 0; head && i <= place.shares.size(); ++i) {
    if (i > 0) {
      const bag::Fields fields = head->fields();
      if (head->op != bag::Op::Index || fields.number<std::uint32_t>("ver") != 1u) return {};
      if (fields.number<std::uint32_t>("conn") == share.channel) {
        if (head->data_size > limits_.most_record_bytes) return {};
        const std::optional<UnpackedChunk> rows = raw(head->data_at, head->data_size);
        if (!rows) return {};
        Latest latest{false, std::nullopt};
        ByteReader row(rows->all());
        while (row.left() >= 12) {
          const std::int64_t time = bag::timeOf(row.number<std::uint64_t>());
          row.number<std::uint32_t>();
          if (time <= at_ns && (!latest.log_ns || time > *latest.log_ns)) latest.log_ns = time;
        }
        return latest;
      }
    }
    head = headAt(window, head->end(), size, cut);
  }
  return {};
}

}  // namespace mapwright::recording
