// Reads the SQLite3 storage of rosbag2 (.db3), schema versions 1 to 4. Source: rosbag2_storage_sqlite3,
// sqlite_storage.cpp: tables topics (id, name, type, serialization_format, since 2 offered_qos_profiles,
// since 4 type_description_hash), messages (id, topic_id, timestamp, data), since 4 message_definitions
// (topic_type, encoding, encoded_message_definition). Before, files hold no definitions: those of common
// types are known here. Its chunks are runs of rows. The database is only read; its definitions are not
// trusted (no views, no triggers, no functions), values are bounded.
#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <sqlite3.h>
#include <sys/stat.h>
#include <utility>

#include "disk/file_error.h"
#include "recording/chunked_source.h"
#include "recording/known_definitions.h"
#include "recording/opening.h"
#include "recording/ros_cbor.h"

namespace mapwright::recording {
namespace {

constexpr std::uint64_t kRunBytes = std::uint64_t(1) << 20;
constexpr std::uint64_t kRunRows = 4096;
constexpr int kMostTopics = 100'000;
constexpr int kStepsBetweenLooks = 10'000;
constexpr std::size_t kRowHead = sizeof(std::uint64_t);

struct CloseDatabase {
  void operator()(sqlite3* database) const { sqlite3_close(database); }
};
using Database = std::unique_ptr<sqlite3, CloseDatabase>;

class Rows {
 public:
  Rows(sqlite3* database, const char* sql) { sqlite3_prepare_v2(database, sql, -1, &statement_, nullptr); }
  ~Rows() { sqlite3_finalize(statement_); }
  Rows(const Rows&) = delete;
  Rows& operator=(const Rows&) = delete;

  Rows& with(std::int64_t value) {
    sqlite3_bind_int64(statement_, ++bound_, value);
    return *this;
  }
  bool next() {
    result_ = statement_ ? sqlite3_step(statement_) : SQLITE_ERROR;
    return result_ == SQLITE_ROW;
  }
  /// After the last one: nothing went wrong.
  bool ended() const { return result_ == SQLITE_DONE; }
  std::int64_t number(int column) const { return sqlite3_column_int64(statement_, column); }
  bool isNumber(int column) const { return sqlite3_column_type(statement_, column) == SQLITE_INTEGER; }
  std::span<const std::uint8_t> bytes(int column) const {
    const void* const at = sqlite3_column_blob(statement_, column);
    return {static_cast<const std::uint8_t*>(at),
            at ? std::size_t(sqlite3_column_bytes(statement_, column)) : 0};
  }
  std::string text(int column) const {
    const auto raw = bytes(column);
    return {raw.begin(), raw.end()};
  }

 private:
  sqlite3_stmt* statement_ = nullptr;
  int bound_ = 0, result_ = SQLITE_OK;
};

/// "file:…?…" with all that could mean something escaped.
std::string uriOf(const std::string& path, const char* parameters) {
  constexpr char kHex[] = "0123456789ABCDEF";
  std::string uri = "file:";
  for (const char c : path) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '/' || c == '.' || c == '_' || c == '-';
    if (plain) {
      uri += c;
    } else {
      uri += {'%', kHex[std::uint8_t(c) >> 4], kHex[std::uint8_t(c) & 15]};
    }
  }
  return uri + parameters;
}

std::uint64_t sizeOfFile(const std::string& path) {
  struct stat about {};
  return ::stat(path.c_str(), &about) == 0 && about.st_size > 0 ? std::uint64_t(about.st_size) : 0;
}

/// Columns of a real table; empty: there is none of this name. A view could compute for ever.
std::vector<std::string> columnsOf(sqlite3* database, const std::string& table) {
  std::vector<std::string> columns;
  const std::string sql = "PRAGMA table_info(" + table + ")";
  Rows known(database,
             ("SELECT 1 FROM sqlite_master WHERE type = 'table' AND sql LIKE 'CREATE TABLE%' AND name = '" +
              table + "'")
                 .c_str());
  if (!known.next()) return columns;
  Rows rows(database, sql.c_str());
  while (rows.next()) columns.push_back(rows.text(1));
  return columns;
}

bool has(const std::vector<std::string>& columns, const char* name) {
  return std::find(columns.begin(), columns.end(), name) != columns.end();
}

class SqliteBag final : public ChunkedSource {
 public:
  SqliteBag(Database database, std::string path, const Limits& limits, Stop stop)
      : ChunkedSource(heldBytes(std::make_shared<const std::string>()), limits),
        database_(std::move(database)),
        path_(std::move(path)),
        stop_(std::move(stop)) {}

  std::string format() const override { return "SQLite (rosbag2)"; }
  std::optional<Attachment> attachment(const AttachmentLocation&) override { return std::nullopt; }
  std::vector<Packing> packing() const override {
    std::uint64_t bytes = 0;
    for (const auto& [first, run] : run_bytes_) bytes += run;
    return {{"", run_bytes_.size(), bytes, bytes}};
  }

  /// False: it is another database.
  bool open(bool whole) {
    if (stop_) sqlite3_progress_handler(database_.get(), kStepsBetweenLooks, &SqliteBag::isStopped, &stop_);
    sqlite3_db_config(database_.get(), SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(database_.get(), SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_exec(database_.get(), "PRAGMA cell_size_check = ON", nullptr, nullptr, nullptr);
    topic_columns_ = columnsOf(database_.get(), "topics");
    const std::vector<std::string> messages = columnsOf(database_.get(), "messages");
    for (const char* const needed : {"id", "name", "type", "serialization_format"}) {
      if (!has(topic_columns_, needed)) return false;
    }
    for (const char* const needed : {"id", "topic_id", "timestamp", "data"}) {
      if (!has(messages, needed)) return false;
    }
    about_.profile = "ros2";
    about_.library = "rosbag2";
    about_.finished = whole;
    if (!whole) notes_.add(NoteCode::NotFinished, 0);
    readTopics();
    readRows();
    return true;
  }

  /// Rows that were added since.
  bool refresh() override {
    if (about_.finished) return false;
    const std::int64_t before = last_id_;
    readTopics();
    readRows();
    return last_id_ != before;
  }

 protected:
  tl::expected<UnpackedChunk, Note> unpack(const ChunkLocation& location) override {
    UnpackedChunk chunk;
    const std::uint64_t room = run_bytes_[location.offset];
    auto* const taken = new (std::nothrow) std::uint8_t[std::size_t(std::max<std::uint64_t>(room, 1))];
    if (!taken) return tl::unexpected(Note{NoteCode::ChunkTooLarge, location.offset, 1, {}});
    chunk.bytes = std::shared_ptr<const std::uint8_t[]>(taken);
    Rows rows(database_.get(),
              "SELECT topic_id, timestamp, data FROM messages WHERE id BETWEEN ?1 AND ?2 ORDER BY id");
    rows.with(std::int64_t(location.offset)).with(std::int64_t(location.offset + location.length - 1));
    while (rows.next()) {
      const auto data = rows.bytes(2);
      if (!isUsable(rows)) continue;
      if (data.size() + kRowHead > room - chunk.size) break;  // it was changed meanwhile
      const std::uint64_t count = data.size();
      std::memcpy(taken + chunk.size, &count, kRowHead);
      if (count != 0) std::memcpy(taken + chunk.size + kRowHead, data.data(), data.size());
      chunk.entries.push_back({rows.number(1), chunk.size, std::uint32_t(rows.number(0))});
      chunk.size += kRowHead + data.size();
    }
    // A damaged tree may lead past rows that were counted. Everything that came is intact.
    std::uint64_t counted = 0;
    for (const auto& [channel, messages] : location.shares) counted += messages;
    if (!rows.ended() || chunk.entries.size() < counted) notes_.add(NoteCode::ChunkCorrupt, location.offset);
    return chunk;
  }

  Message read(const UnpackedChunk& chunk, const ChunkEntry& entry) const override {
    ByteReader in(chunk.all().subspan(std::size_t(entry.offset)));
    Message message;
    message.publish_time_ns = entry.log_ns;
    message.bytes = in.take(in.number<std::uint64_t>());
    return message;
  }

  std::optional<Packing> packingOf(const ChunkLocation&) const override { return std::nullopt; }
  Step readRecord(Window&, std::uint64_t, std::uint64_t, std::uint64_t&) override { return Step::DataEnds; }
  std::uint64_t nextChunk(Window&, std::uint64_t, std::uint64_t to) const override { return to; }

 private:
  static int isStopped(void* stop) { return (*static_cast<Stop*>(stop))() ? 1 : 0; }

  static bool isUsable(const Rows& rows) {
    return rows.isNumber(0) && rows.isNumber(1) && rows.number(1) >= 0 && rows.number(0) >= 0 &&
           rows.number(0) <= std::numeric_limits<std::uint32_t>::max();
  }

  void readTopics() {
    std::map<std::string, std::pair<std::string, std::string>> definitions;  // encoding and text, by type
    if (has(columnsOf(database_.get(), "message_definitions"), "encoded_message_definition")) {
      Rows rows(database_.get(),
                "SELECT topic_type, encoding, encoded_message_definition FROM message_definitions");
      std::uint64_t bytes = 0;
      while (rows.next()) {
        bytes += rows.bytes(2).size();
        if (bytes > limits_.most_record_bytes) {
          notes_.add(NoteCode::RecordTooLarge, 0);
          break;
        }
        definitions.try_emplace(rows.text(0), rows.text(1), rows.text(2));
      }
    }
    const bool qos = has(topic_columns_, "offered_qos_profiles"),
               hash = has(topic_columns_, "type_description_hash");
    const std::string sql = std::string("SELECT id, name, type, serialization_format, ") +
                            (qos ? "offered_qos_profiles" : "''") + ", " +
                            (hash ? "type_description_hash" : "''") + " FROM topics ORDER BY id";
    Rows rows(database_.get(), sql.c_str());
    for (int count = 0; count < kMostTopics && rows.next(); ++count) {
      const std::int64_t id = rows.number(0);
      if (id < 0 || id > std::numeric_limits<std::uint32_t>::max()) {
        notes_.add(NoteCode::RecordCorrupt, 0);
        continue;
      }
      if (!described_.insert(id).second) continue;
      Channel channel;
      channel.id = std::uint32_t(id);
      channel.topic = rows.text(1);
      channel.schema_name = rows.text(2);
      channel.message_encoding = rows.text(3);
      if (const auto found = definitions.find(channel.schema_name); found != definitions.end()) {
        std::tie(channel.schema_encoding, channel.schema_data) = found->second;
      }
      if (channel.message_encoding == "cdr") findDefinition(channel);
      if (std::string profiles = rows.text(4); !profiles.empty())
        channel.metadata["offered_qos_profiles"] = std::move(profiles);
      if (std::string of = rows.text(5); !of.empty()) channel.metadata["topic_type_hash"] = std::move(of);
      addChannel(std::move(channel), 0);
    }
  }

  /// Those of common types are known, where the file has none or not the whole. Of several releases that one
  /// counts which the first message fits.
  void findDefinition(Channel& channel) {
    std::vector<std::string> known = knownDefinitions(channel.schema_name);
    if (known.empty() || (!channel.schema_data.empty() && channel.schema_encoding != "ros2msg")) return;
    const auto first = firstRows().find(channel.id);
    Rows rows(database_.get(), "SELECT data FROM messages WHERE id = ?1");
    if (first != firstRows().end() && rows.with(first->second).next()) {
      const auto message = rows.bytes(0);
      if (!channel.schema_data.empty() && fitsDefinition(channel.schema_name, channel.schema_data, message))
        return;
      for (std::string& text : known) {
        if (!fitsDefinition(channel.schema_name, text, message)) continue;
        channel.schema_encoding = "ros2msg";
        channel.schema_data = std::move(text);
        return;
      }
    }
    if (!channel.schema_data.empty()) return;
    channel.schema_encoding = "ros2msg";
    channel.schema_data = std::move(known.front());
  }

  const std::map<std::int64_t, std::int64_t>& firstRows() {
    if (first_rows_) return *first_rows_;
    first_rows_.emplace();
    Rows rows(database_.get(), "SELECT topic_id, min(id) FROM messages GROUP BY topic_id");
    while (rows.next()) first_rows_->emplace(rows.number(0), rows.number(1));
    return *first_rows_;
  }

  void readRows() {
    about_.bytes = sizeOfFile(path_) + sizeOfFile(path_ + "-wal");
    Rows rows(database_.get(),
              // The length of a BLOB is known without reading it.
              "SELECT topic_id, timestamp, id, CASE typeof(data) WHEN 'blob' THEN length(data) ELSE "
              "length(CAST(data AS BLOB)) END FROM messages WHERE id > ?1 ORDER BY id");
    rows.with(last_id_);
    ChunkLocation run;
    std::map<std::uint32_t, std::uint64_t> counts;
    std::uint64_t bytes = 0, count = 0, all = 0;
    std::int64_t run_last = 0;
    const auto close = [&] {
      if (count == 0) return;
      run.length = std::uint64_t(run_last) - run.offset + 1;
      run.channels_known = true;
      for (const auto& [channel, messages] : counts) run.shares.push_back({channel, messages});
      run_bytes_[run.offset] = bytes;
      addChunk(std::exchange(run, {}));
      counts.clear();
      bytes = count = 0;
    };
    while (rows.next()) {
      const std::uint64_t size = std::uint64_t(std::max<std::int64_t>(rows.number(3), 0)) + kRowHead;
      if (count > 0 && (bytes + size > kRunBytes || count >= kRunRows)) close();
      last_id_ = rows.number(2);
      ++all;
      const bool described = described_.contains(rows.number(0));
      if (!isUsable(rows)) {
        notes_.add(NoteCode::TimeUnusable, std::uint64_t(last_id_));
      } else if (!described) {
        notes_.add(NoteCode::UnknownChannel, std::uint64_t(last_id_));
      } else if (size > limits_.most_chunk_bytes) {
        notes_.add(NoteCode::ChunkTooLarge, std::uint64_t(last_id_));
        close();  // no run reads over it
      } else {
        if (count == 0) {
          run.offset = std::uint64_t(last_id_);
          run.forgetTimes();
        }
        run.include(rows.number(1));
        ++counts[std::uint32_t(rows.number(0))];
        bytes += size;
        run_last = last_id_;
        ++count;
      }
    }
    close();
    if (!rows.ended()) notes_.add(NoteCode::TableDamaged, 0, {}, all);
    countChunks();
  }

  Database database_;
  std::string path_;
  Stop stop_;
  std::vector<std::string> topic_columns_;
  std::int64_t last_id_ = std::numeric_limits<std::int64_t>::min();
  std::map<std::uint64_t, std::uint64_t> run_bytes_;                // of each chunk, by its first row
  std::set<std::int64_t> described_;                                // topics
  std::optional<std::map<std::int64_t, std::int64_t>> first_rows_;  // by topic
};

Database opened(const std::string& path, const char* parameters) {
  sqlite3* raw = nullptr;
  const int result = sqlite3_open_v2(uriOf(path, parameters).c_str(), &raw,
                                     SQLITE_OPEN_READONLY | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX, nullptr);
  Database database(raw);
  // Reading shows whether the journal beside it can be used.
  if (result != SQLITE_OK || !Rows(raw, "SELECT count(*) FROM sqlite_master").next()) return nullptr;
  return database;
}

}  // namespace

bool looksLikeSqlite(std::span<const std::uint8_t> start) {
  constexpr std::string_view kMagic("SQLite format 3\0", 16);
  return start.size() >= kMagic.size() &&
         std::equal(kMagic.begin(), kMagic.end(), start.begin(),
                    [](char a, std::uint8_t b) { return std::uint8_t(a) == b; });
}

Opened openSqliteBag(const std::string& path, const Limits& limits, Stop stop) {
  // A recorder that was interrupted, or is still writing, leaves its last messages in a journal.
  const bool journal = sizeOfFile(path + "-wal") != 0;
  Database database = journal ? opened(path, "?mode=ro") : nullptr;
  if (!database) database = opened(path, "?mode=ro&immutable=1");
  if (!database) return tl::unexpected(Failure{Failure::Code::Database, {}});
  auto bag = std::make_unique<SqliteBag>(std::move(database), path, limits, std::move(stop));
  if (!bag->open(!journal)) return tl::unexpected(Failure{Failure::Code::Database, {}});
  return bag;
}

}  // namespace mapwright::recording
