#include "history/version_store.h"

#include <fcntl.h>
#include <filesystem>
#include <sqlite3.h>
#include <string_view>
#include <unistd.h>
#include <utility>

#include "disk/private_folder.h"
#include "history/faults.h"

namespace mapwright::history {
namespace {

constexpr int kBusyMs = 5'000;  // another program may be writing

constexpr const char* kMake = R"(
  CREATE TABLE IF NOT EXISTS versions (
    number INTEGER PRIMARY KEY AUTOINCREMENT, robot TEXT NOT NULL, uid TEXT NOT NULL, id TEXT NOT NULL, name TEXT NOT NULL,
    version INTEGER, saved INTEGER NOT NULL, kept REAL NOT NULL, text BLOB NOT NULL,
    sum INTEGER);
  CREATE INDEX IF NOT EXISTS versions_of_map ON versions (robot, uid, number);
)";
constexpr const char* kColumns =
    "SELECT number,robot,uid,id,name,version,saved,kept,length(text) FROM versions ";

/// FNV-1a: what the disk makes of a text is noticed.
std::int64_t sumOf(const std::string& text) {
  std::uint64_t sum = 14695981039346656037U;
  for (const char byte : text) sum = (sum ^ std::uint8_t(byte)) * 1099511628211U;
  return std::int64_t(sum);
}

}  // namespace

MapName mapName(std::string robot, std::string id, std::string uid, std::string name) {
  if (uid.empty()) uid = id;
  return {std::move(robot), std::move(uid), std::move(id), std::move(name)};
}

bool isSameMap(const MapName& a, const MapName& b) {
  return a.uid == b.uid && (a.robot == b.robot || a.uid != a.id || b.uid != b.id);
}

void VersionStore::Close::operator()(sqlite3* database) const { sqlite3_close(database); }

/// A prepared statement with its values.
class VersionStore::Question {
 public:
  Question(sqlite3* database, const std::string& sql) {
    sqlite3_prepare_v2(database, sql.c_str(), int(sql.size()), &statement_, nullptr);
  }
  ~Question() { sqlite3_finalize(statement_); }
  Question(const Question&) = delete;
  Question& operator=(const Question&) = delete;

  Question& with(std::string_view text) {
    sqlite3_bind_text64(statement_, ++bound_, text.data(), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
    return *this;
  }
  Question& withBytes(std::string_view bytes) {
    sqlite3_bind_blob64(statement_, ++bound_, bytes.empty() ? "" : bytes.data(), bytes.size(),
                        SQLITE_TRANSIENT);
    return *this;
  }
  Question& with(std::int64_t number) {
    sqlite3_bind_int64(statement_, ++bound_, number);
    return *this;
  }
  Question& with(double number) {
    sqlite3_bind_double(statement_, ++bound_, number);
    return *this;
  }
  Question& with(std::optional<int> number) {
    if (number) return with(std::int64_t(*number));
    sqlite3_bind_null(statement_, ++bound_);
    return *this;
  }

  /// SQLITE_ROW, SQLITE_DONE, or what went wrong.
  int step() { return statement_ ? sqlite3_step(statement_) : SQLITE_ERROR; }
  std::int64_t number(int column) { return sqlite3_column_int64(statement_, column); }
  double real(int column) { return sqlite3_column_double(statement_, column); }
  bool none(int column) { return sqlite3_column_type(statement_, column) == SQLITE_NULL; }
  std::string text(int column) {
    const void* const bytes = sqlite3_column_blob(statement_, column);
    const int count = sqlite3_column_bytes(statement_, column);
    return bytes ? std::string(static_cast<const char*>(bytes), std::size_t(count)) : std::string();
  }
  KeptVersion row() {
    return {number(0),
            {text(1), text(2), text(3), text(4)},
            none(5) ? std::nullopt : std::optional(int(number(5))),
            number(6) ? Origin::Saved : Origin::Read,
            real(7),
            number(8)};
  }

 private:
  sqlite3_stmt* statement_ = nullptr;
  int bound_ = 0;
};

VersionStore::VersionStore(std::unique_ptr<sqlite3, Close> database, std::string path, Limits limits)
    : database_(std::move(database)), path_(std::move(path)), limits_(limits) {}
VersionStore::VersionStore(VersionStore&&) noexcept = default;
VersionStore& VersionStore::operator=(VersionStore&&) noexcept = default;
VersionStore::~VersionStore() = default;

tl::expected<VersionStore, Fault> VersionStore::open(const std::string& path, Limits limits) {
  disk::makePrivateFolder(std::filesystem::path(path).parent_path());  // SQLite says what is wrong
  // SQLite gives its journals the rights of the file.
  if (const int fd = ::open(path.c_str(), O_RDONLY | O_CREAT | O_NONBLOCK | O_CLOEXEC, 0600); fd >= 0)
    ::close(fd);
  for (const char* journal : {"", "-wal", "-shm", "-journal"}) disk::makePrivate(path + journal);
  sqlite3* opened = nullptr;
  sqlite3_open_v2(path.c_str(), &opened, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
  VersionStore store(std::unique_ptr<sqlite3, Close>(opened), path, limits);
  if (!opened || sqlite3_errcode(opened) != SQLITE_OK) return tl::make_unexpected(store.problem());
  sqlite3_busy_timeout(opened, kBusyMs);
  if (auto why = store.run(kMake)) return tl::make_unexpected(std::move(*why));
  // Versions of older programs have no checksum.
  if (Question(opened, "SELECT sum FROM versions LIMIT 0").step() != SQLITE_DONE) {
    if (auto why = store.run("ALTER TABLE versions ADD COLUMN sum INTEGER"))
      return tl::make_unexpected(std::move(*why));
  }
  return store;
}

Fault VersionStore::problem() const {
  return {faultText("history", "The versions kept in %1 cannot be read or written"),
          {path_},
          {fault::said(sqlite3_errmsg(database_.get()))}};
}

std::optional<Fault> VersionStore::run(const char* sql) const {
  if (sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr) == SQLITE_OK) return std::nullopt;
  return problem();
}

std::optional<Fault> VersionStore::keep(const MapName& map, std::optional<int> version, Origin origin,
                                        const std::string& text, double now_s) {
  // Whoever looks and writes at the same time waits for us.
  if (auto why = run("BEGIN IMMEDIATE")) return why;
  const auto undone = [&](std::optional<Fault> why) {
    run("ROLLBACK");
    return why;
  };
  {
    Question newest(database_.get(),
                    "SELECT text FROM versions WHERE robot = ? AND uid = ? ORDER BY number DESC LIMIT 1");
    const int found = newest.with(map.robot).with(map.uid).step();
    if (found == SQLITE_ROW && newest.text(0) == text) return undone(std::nullopt);
    if (found != SQLITE_ROW && found != SQLITE_DONE) return undone(problem());
  }
  Question put(
      database_.get(),
      "INSERT INTO versions (robot,uid,id,name,version,saved,kept,text,sum) VALUES (?,?,?,?,?,?,?,?,?)");
  put.with(map.robot).with(map.uid).with(map.id).with(map.name).with(version).with(
      std::int64_t(origin == Origin::Saved));
  if (put.with(now_s).withBytes(text).with(sumOf(text)).step() != SQLITE_DONE) return undone(problem());
  if (auto why = forget(map, sqlite3_last_insert_rowid(database_.get()))) return undone(std::move(why));
  if (auto why = run("COMMIT")) return undone(std::move(why));
  return std::nullopt;
}

std::optional<Fault> VersionStore::forget(const MapName& map, std::int64_t kept) {
  Question of_map(
      database_.get(),
      "DELETE FROM versions WHERE robot = ?1 AND uid = ?2 AND number NOT IN (SELECT number FROM versions "
      "WHERE robot = ?1 AND uid = ?2 ORDER BY number DESC LIMIT ?3)");
  if (of_map.with(map.robot).with(map.uid).with(std::int64_t(limits_.of_map)).step() != SQLITE_DONE)
    return problem();
  // The newest that fit stay.
  Question of_all(database_.get(),
                  "DELETE FROM versions WHERE number <> ?1 AND number IN (SELECT number FROM (SELECT number, "
                  "sum(length(text)) OVER (ORDER BY number DESC) AS bytes FROM versions) WHERE bytes > ?2)");
  if (of_all.with(kept).with(limits_.bytes).step() != SQLITE_DONE) return problem();
  return std::nullopt;
}

tl::expected<std::vector<KeptVersion>, Fault> VersionStore::list(const std::string& robot,
                                                                 const std::string& uid) const {
  Question all(
      database_.get(),
      std::string(kColumns) + "WHERE (?1 = '' OR robot = ?1) AND (?2 = '' OR uid = ?2) ORDER BY number DESC");
  all.with(robot).with(uid);
  std::vector<KeptVersion> versions;
  for (;;) {
    const int found = all.step();
    if (found == SQLITE_DONE) return versions;
    if (found != SQLITE_ROW) return tl::make_unexpected(problem());
    versions.push_back(all.row());
  }
}

tl::expected<std::optional<KeptVersion>, Fault> VersionStore::find(std::int64_t number) const {
  Question one(database_.get(), std::string(kColumns) + "WHERE number = ?");
  const int found = one.with(number).step();
  if (found == SQLITE_ROW) return one.row();
  if (found == SQLITE_DONE) return std::nullopt;
  return tl::make_unexpected(problem());
}

tl::expected<std::string, Fault> VersionStore::text(std::int64_t number) const {
  Question one(database_.get(), "SELECT text,sum FROM versions WHERE number = ?");
  const int found = one.with(number).step();
  if (found == SQLITE_ROW) {
    std::string text = one.text(0);
    if (one.none(1) || one.number(1) == sumOf(text)) return text;
    return tl::make_unexpected(
        Fault(faultText("history", "Version %1 is damaged on the disk. Nothing is done with it."), {number}));
  }
  if (found == SQLITE_DONE)
    return tl::make_unexpected(Fault(faultText("history", "There is no version %1 here."), {number}));
  return tl::make_unexpected(problem());
}

}  // namespace mapwright::history
