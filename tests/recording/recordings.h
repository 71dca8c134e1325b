// Recordings in memory for tests, and what is read from them.
#pragma once

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <limits>
#include <memory>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "recording/append_file.h"
#include "recording/mcap_records.h"
#include "recording/mcap_writer.h"
#include "recording/source.h"

namespace recordings {

using namespace mapwright::recording;

inline std::span<const std::uint8_t> bytesOf(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// A message as tests compare it.
struct Row {
  std::string topic;
  std::int64_t log_ns = 0;
  std::uint32_t sequence = 0;
  std::string bytes;
  bool operator==(const Row&) const = default;
};

inline Row rowOf(const Message& message) {
  return {message.channel->topic, message.log_time_ns, message.sequence,
          std::string(message.bytes.begin(), message.bytes.end())};
}

inline std::vector<Row> rowsOf(Source& source, const Query& query = {}) {
  std::vector<Row> rows;
  const std::unique_ptr<Cursor> cursor = source.messages(query);
  while (const std::optional<Message> message = cursor->next()) rows.push_back(rowOf(*message));
  return rows;
}

inline std::vector<Row> lastRows(Source& source, std::int64_t at_ns,
                                 const std::vector<std::string>& topics = {}) {
  std::vector<Row> rows;
  for (const Message& message : source.lastBefore(at_ns, topics)) rows.push_back(rowOf(message));
  return rows;
}

inline bool has(const Source& source, NoteCode code) {
  const std::vector<Note> notes = source.summary().notes;
  return std::any_of(notes.begin(), notes.end(), [&](const Note& note) { return note.code == code; });
}

/// A disk in memory that may be full.
class MemoryDisk final : public AppendTarget {
 public:
  explicit MemoryDisk(std::shared_ptr<std::string> bytes, std::shared_ptr<std::uint64_t> room = nullptr)
      : bytes_(std::move(bytes)), room_(std::move(room)) {}
  std::optional<mapwright::disk::FileError> append(std::span<const std::uint8_t> bytes) override {
    if (room_ && bytes_->size() + bytes.size() > *room_)
      return mapwright::disk::systemError("memory", ENOSPC);
    bytes_->append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return std::nullopt;
  }
  std::optional<mapwright::disk::FileError> settle() override { return std::nullopt; }

 private:
  std::shared_ptr<std::string> bytes_;
  std::shared_ptr<std::uint64_t> room_;
};

inline Channel channelOf(const std::string& topic) {
  Channel channel;
  channel.topic = topic;
  channel.message_encoding = "json";
  channel.schema_name = "test" + topic;
  channel.schema_encoding = "jsonschema";
  channel.schema_data = R"({"type": "object"})";
  return channel;
}

/// Rows in the order in which they are written, and where in the file each chunk ends.
struct Made {
  std::shared_ptr<std::string> bytes = std::make_shared<std::string>();
  std::vector<Row> rows;
  std::vector<std::pair<std::uint64_t, std::size_t>> chunks;  // end in the file, rows until then

  std::vector<Row> byTime() const {
    std::vector<Row> sorted = rows;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Row& a, const Row& b) { return a.log_ns < b.log_ns; });
    return sorted;
  }
  Opened open(const Limits& limits = {}) const { return openRecording(heldBytes(bytes), limits); }
};

inline std::unique_ptr<McapWriter> writerInto(const std::shared_ptr<std::string>& bytes,
                                              WriterOptions options = {},
                                              std::shared_ptr<std::uint64_t> room = nullptr) {
  auto writer = McapWriter::create(std::make_unique<MemoryDisk>(bytes, std::move(room)), std::move(options));
  return writer ? std::move(*writer) : nullptr;
}

/// `chunks` chunks with `each` messages on three topics; stamps go back by up to `disorder_ns`, some are the
/// same.
inline Made makeRecording(std::size_t chunks, std::size_t each, std::int64_t disorder_ns, unsigned seed,
                          WriterOptions options = {}) {
  Made made;
  std::mt19937 random(seed);
  options.chunk_bytes = std::size_t(1) << 30;
  options.chunk_ns = std::numeric_limits<std::int64_t>::max();
  const std::unique_ptr<McapWriter> writer = writerInto(made.bytes, options);
  const std::vector<std::string> topics{"/pose", "/map", "/scan"};
  std::vector<ChannelId> ids;
  for (const std::string& topic : topics) ids.push_back(*writer->addChannel(channelOf(topic)));
  std::int64_t now = 1'000'000;
  std::uint32_t sequence = 0;
  for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
    for (std::size_t i = 0; i < each; ++i) {
      const std::size_t of = random() % 7 == 0 ? 1 : (random() % 2) * 2;
      now += random() % 3 == 0 ? 0 : 1000;
      const std::int64_t back = disorder_ns > 0 ? std::int64_t(random() % std::uint64_t(disorder_ns)) : 0;
      Row row{topics[of], std::max<std::int64_t>(0, now - back), ++sequence,
              "{\"n\": " + std::to_string(sequence) + "}"};
      writer->write(ids[of], {row.log_ns, row.log_ns, row.sequence}, bytesOf(row.bytes));
      made.rows.push_back(std::move(row));
    }
    writer->flush();
    made.chunks.emplace_back(writer->progress().bytes, made.rows.size());
  }
  writer->close();
  return made;
}

/// A file put together record by record.
struct RawMcap {
  mcap::RecordWriter out;
  RawMcap() {
    out.raw(mcap::kMagic);
    out.begin(mcap::Op::Header);
    out.text("").text("test");
    out.end();
  }
  static void channel(mcap::RecordWriter& to, std::uint16_t id, const std::string& topic) {
    mcap::ChannelRecord record;
    record.id = id;
    record.topic = topic;
    record.message_encoding = "json";
    mcap::write(to, record);
  }
  static void message(mcap::RecordWriter& to, std::uint16_t id, std::uint64_t time,
                      const std::string& bytes) {
    to.begin(mcap::Op::Message);
    to.u16(id).u32(7).u64(time).u64(time).raw(bytesOf(bytes));
    to.end();
  }
  void chunk(std::uint64_t start, std::uint64_t end, std::uint64_t size, std::uint32_t crc,
             const std::string& compression, std::span<const std::uint8_t> records) {
    out.begin(mcap::Op::Chunk);
    out.u64(start).u64(end).u64(size).u32(crc).text(compression).u64(records.size()).raw(records);
    out.end();
  }
  void end() {
    out.begin(mcap::Op::DataEnd);
    out.u32(0);
    out.end();
    out.begin(mcap::Op::Footer);
    out.u64(0).u64(0).u32(0);
    out.end();
    out.raw(mcap::kMagic);
  }
  std::shared_ptr<std::string> bytes() const {
    return std::make_shared<std::string>(out.bytes().begin(), out.bytes().end());
  }
  Opened open(const Limits& limits = {}) const { return openRecording(heldBytes(bytes()), limits); }
};

/// What a random reader must never do is crash, hang, or show what was never written.
inline void readEverything(Source& source) {
  rowsOf(source);
  Query query;
  query.topics = {"/map"};
  query.backwards = true;
  rowsOf(source, query);
  const Summary summary = source.summary();
  const std::int64_t start = summary.start_ns.value_or(0), end = summary.end_ns.value_or(0);
  for (const std::int64_t at : {start, start / 2 + end / 2, end}) lastRows(source, at);
  for (const AttachmentLocation& location : source.attachments()) source.attachment(location);
  source.metadata();
  source.refresh();
}

}  // namespace recordings
