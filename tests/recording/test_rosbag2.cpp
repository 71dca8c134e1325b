// Recordings of rosbag2: SQLite files, folders of several files, what is compressed, definitions in IDL or
// missing.
#include <map>
#include <random>
#include <sqlite3.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "idl_sample.h"
#include "packed/codec.h"
#include "recording/known_definitions.h"
#include "recording/ros_cbor.h"
#include "recording/ros_idl.h"
#include "recordings.h"
#include "test_program.h"

namespace test_rosbag2 {

using namespace recordings;
using namespace mapwright;

namespace {

struct Said {
  int topic = 0;  // from 1
  std::int64_t at_ns = 0;
  std::string bytes;
};

/// A string message as CDR.
std::string cdrText(const std::string& text) {
  std::string cdr("\0\1\0\0", 4);
  const auto size = std::uint32_t(text.size() + 1);
  cdr.append(reinterpret_cast<const char*>(&size), 4);
  return cdr + text + '\0';
}

std::string zstd(const std::string& bytes) {
  const auto packed = packed::packZstd(bytesOf(bytes), 3);
  return {packed.data.get(), packed.data.get() + packed.size};
}

std::string topicName(int topic) { return "/t" + std::to_string(topic); }

class Sql {
 public:
  explicit Sql(const QString& path) { sqlite3_open(path.toUtf8().constData(), &database_); }
  ~Sql() { sqlite3_close(database_); }
  void run(const std::string& sql) {
    if (sqlite3_exec(database_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
      qFatal("%s: %s", sql.c_str(), sqlite3_errmsg(database_));
  }
  void message(const Said& said) {
    sqlite3_stmt* statement = nullptr;
    sqlite3_prepare_v2(database_, "INSERT INTO messages (topic_id, timestamp, data) VALUES (?1, ?2, ?3)", -1,
                       &statement, nullptr);
    sqlite3_bind_int64(statement, 1, said.topic);
    sqlite3_bind_int64(statement, 2, said.at_ns);
    sqlite3_bind_blob64(statement, 3, said.bytes.data(), said.bytes.size(), SQLITE_STATIC);
    sqlite3_step(statement);
    sqlite3_finalize(statement);
  }
  sqlite3* database() { return database_; }

 private:
  sqlite3* database_ = nullptr;
};

/// As rosbag2 of a schema version lays it out; three topics.
void writeDb3(const QString& path, int version, const std::vector<Said>& all) {
  Sql sql(path);
  std::string columns =
      "id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, serialization_format TEXT NOT NULL";
  if (version >= 2) columns += ", offered_qos_profiles TEXT NOT NULL";
  if (version >= 4) columns += ", type_description_hash TEXT NOT NULL";
  sql.run("BEGIN");
  sql.run("CREATE TABLE topics (" + columns + ")");
  sql.run(
      "CREATE TABLE messages (id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL, "
      "data BLOB "
      "NOT NULL)");
  if (version >= 3)
    sql.run("CREATE TABLE schema (schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL)");
  if (version >= 4) {
    sql.run(
        "CREATE TABLE message_definitions (id INTEGER PRIMARY KEY, topic_type TEXT, encoding TEXT, "
        "encoded_message_definition TEXT, type_description_hash TEXT)");
    sql.run(
        "INSERT INTO message_definitions VALUES (1, 'std_msgs/msg/String', 'ros2msg', 'string data', '')");
  }
  for (int topic = 1; topic <= 3; ++topic) {
    std::string row = std::to_string(topic) + ", '" + topicName(topic) + "', 'std_msgs/msg/String', 'cdr'";
    if (version >= 2) row += ", 'qos'";
    if (version >= 4) row += ", ''";
    sql.run("INSERT INTO topics VALUES (" + row + ")");
  }
  for (const Said& said : all) sql.message(said);
  sql.run("COMMIT");
}

std::vector<Said> someMessages(unsigned seed, std::int64_t from_ns, int count) {
  std::mt19937 random(seed);
  std::vector<Said> all;
  for (int i = 0; i < count; ++i) {
    const std::string text = std::to_string(i) + std::string(random() % 2000, 'x');
    all.push_back({int(1 + random() % 3), from_ns + i * 1000 + std::int64_t(random() % 5000), cdrText(text)});
  }
  return all;
}

std::vector<Row> byTime(const std::vector<Said>& all) {
  std::vector<Row> rows;
  for (const Said& said : all) rows.push_back({topicName(said.topic), said.at_ns, 0, said.bytes});
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.log_ns < b.log_ns; });
  return rows;
}

void writeText(const QString& path, const std::string& text) {
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly)) qFatal("no file");
  file.write(text.data(), qint64(text.size()));
}
std::string contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

void writeMetadata(const QString& folder, const std::vector<std::string>& files) {
  std::string yaml =
      "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: sqlite3\n  relative_file_paths:\n";
  for (const std::string& file : files) yaml += "    - " + file + "\n";
  writeText(folder + QStringLiteral("/metadata.yaml"), yaml);
}

Opened opened(const QString& path) { return openRecording(path.toStdString()); }

}  // namespace

class Rosbag2Test : public QObject {
  Q_OBJECT
  QTemporaryDir folder_;
  int made_ = 0;

  QString fresh(const char* suffix) {
    return folder_.filePath(QString::number(++made_) + QLatin1String(suffix));
  }
  QString freshFolder() {
    const QString path = folder_.filePath(QString::number(++made_));
    QDir().mkpath(path);
    return path;
  }

 private Q_SLOTS:
  void everyVersionOfTheTablesIsRead() {
    for (int version = 1; version <= 4; ++version) {
      const std::vector<Said> all = someMessages(unsigned(version), 1'000'000, 3000);
      const QString path = fresh(".db3");
      writeDb3(path, version, all);
      const Opened file = opened(path);
      QVERIFY(file);
      const std::vector<Row> expected = byTime(all);
      QVERIFY(rowsOf(**file) == expected);
      const Summary summary = (*file)->summary();
      QCOMPARE(summary.messages, std::uint64_t(all.size()));
      QCOMPARE(*summary.start_ns, expected.front().log_ns);
      QCOMPARE(*summary.end_ns, expected.back().log_ns);
      QVERIFY(summary.finished && summary.notes.empty());
      for (const ChannelPtr& channel : (*file)->channels()) {
        QCOMPARE(channel->schema_encoding, std::string("ros2msg"));
        QVERIFY(!channel->schema_data.empty());
        QCOMPARE(channel->metadata.count("offered_qos_profiles"), std::size_t(version >= 2));
      }
      // Any range, and what was last before it, as of any recording.
      std::mt19937 random(5);
      for (int i = 0; i < 20; ++i) {
        const std::int64_t at = expected[random() % expected.size()].log_ns;
        std::map<std::string, Row> last;
        std::vector<Row> range;
        for (const Row& row : expected) {
          if (row.log_ns <= at) last[row.topic] = row;
          if (row.log_ns >= at && row.log_ns <= at + 20'000) range.push_back(row);
        }
        QVERIFY(rowsOf(**file, {.first_ns = at, .last_ns = at + 20'000, .topics = {}}) == range);
        for (const Row& row : lastRows(**file, at)) QVERIFY(row == last.at(row.topic));
      }
    }
  }

  void aFolderIsOneRecordingOfItsFiles() {
    const QString folder = freshFolder();
    std::vector<Said> all;
    std::vector<std::string> names;
    for (int part = 0; part < 3; ++part) {
      // They overlap a little.
      const std::vector<Said> said = someMessages(unsigned(10 + part), 1'000'000 + part * 998'000, 1000);
      all.insert(all.end(), said.begin(), said.end());
      const QString name = QStringLiteral("a b_%1.db3").arg(part);
      writeDb3(folder + QLatin1Char('/') + name, 3, said);
      names.push_back((part == 1 ? "old_name/" : "") + name.toStdString());
    }
    writeMetadata(folder, names);
    QVERIFY(isRosbagFolder(folder.toStdString()));
    for (const QString& path : {folder, folder + QStringLiteral("/metadata.yaml")}) {
      const Opened file = opened(path);
      QVERIFY(file);
      const std::vector<Row> expected = byTime(all);
      QVERIFY(rowsOf(**file) == expected);
      std::vector<Row> turned = rowsOf(**file, {.topics = {}, .backwards = true});
      std::reverse(turned.begin(), turned.end());
      QVERIFY(turned == expected);
      QCOMPARE((*file)->channels().size(), std::size_t(3));
      const std::int64_t at = expected[expected.size() / 2].log_ns;
      std::map<std::string, Row> last;
      for (const Row& row : expected) {
        if (row.log_ns <= at) last[row.topic] = row;
      }
      for (const Row& row : lastRows(**file, at)) QVERIFY(row == last.at(row.topic));
    }
  }

  void aFileThatIsMissingIsNamed() {
    const QString folder = freshFolder();
    const std::vector<Said> said = someMessages(3, 1000, 10);
    writeDb3(folder + QStringLiteral("/a.db3"), 3, said);
    writeMetadata(folder, {"a.db3", "b.db3", "../../etc/passwd"});
    const Opened file = opened(folder);
    QVERIFY(file);
    QVERIFY(rowsOf(**file) == byTime(said));
    const std::vector<Note> notes = (*file)->summary().notes;
    QCOMPARE(notes.size(), std::size_t(2));
    QCOMPARE(notes[0].code, NoteCode::FileMissing);
    QCOMPARE(notes[0].name, std::string("b.db3"));
    writeMetadata(folder, {"b.db3"});
    QVERIFY(!opened(folder));
  }

  /// metadata.yaml is written when a recording ends.
  void whatAKilledRecorderLeavesIsPlayed() {
    for (const bool damaged : {false, true}) {
      const QString folder = freshFolder();
      std::vector<Said> all;
      for (const int part : {0, 1, 10}) {
        const std::vector<Said> said = someMessages(unsigned(part), 1'000'000 + part * 1'000'000, 20);
        all.insert(all.end(), said.begin(), said.end());
        writeDb3(folder + QStringLiteral("/drive_%1.db3").arg(part), 3, said);
      }
      if (damaged) writeText(folder + QStringLiteral("/metadata.yaml"), "");
      QVERIFY(isRosbagFolder(folder.toStdString()));
      const Opened file = opened(folder);
      QVERIFY(file);
      QVERIFY(rowsOf(**file) == byTime(all));
      const std::vector<Note> notes = (*file)->summary().notes;
      QCOMPARE(notes.size(), std::size_t(1));
      QCOMPARE(notes[0].code, NoteCode::NoMetadata);
      QCOMPARE(notes[0].count, std::uint64_t(3));
      QVERIFY(!(*file)->summary().finished);
    }
  }

  void recordingsOfTheirOwnAreNotJoined() {
    const std::vector<std::vector<const char*>> folders{
        {"monday_0.db3", "tuesday_0.db3"}, {"a.db3"}, {"a_0.db3", "a.db3"}, {"a_0.db3", "map.yaml"},
        {"a_0.db3", "a_00.db3"},           {},        {"a_.db3"},           {"a_x1.mcap"}};
    for (const auto& names : folders) {
      const QString folder = freshFolder();
      for (const char* const name : names) writeText(folder + QLatin1Char('/') + QLatin1String(name), "");
      QVERIFY2(!isRosbagFolder(folder.toStdString()), names.empty() ? "" : names.back());
    }
  }

  void filesThatAreTooManyAreNoted() {
    const QString folder = freshFolder();
    writeDb3(folder + QStringLiteral("/a.db3"), 3, someMessages(3, 1000, 10));
    std::vector<std::string> names{"a.db3"};
    for (int i = 0; i < 1002; ++i) names.push_back("part_" + std::to_string(i) + ".db3");
    writeMetadata(folder, names);
    const Opened file = opened(folder);
    QVERIFY(file);
    const std::vector<Note> notes = (*file)->summary().notes;
    QCOMPARE(notes.back().code, NoteCode::FilesLeftOut);
    QCOMPARE(notes.back().count, std::uint64_t(3));
  }

  /// As if the .db3 were copied without the -wal beside it.
  void messagesThatTheFolderCountsButAreMissingAreNoted() {
    const QString folder = freshFolder();
    writeDb3(folder + QStringLiteral("/a.db3"), 3, someMessages(3, 1000, 10));
    for (const int counted : {8, 10, 17}) {
      writeMetadata(folder, {"a.db3"});
      writeText(folder + QStringLiteral("/metadata.yaml"),
                contentOf(folder + QStringLiteral("/metadata.yaml")) +
                    "  message_count: " + std::to_string(counted) + "\n");
      const Opened file = opened(folder);
      QVERIFY(file);
      QCOMPARE((*file)->summary().messages, std::uint64_t(10));
      const std::vector<Note> notes = (*file)->summary().notes;
      QCOMPARE(notes.size(), std::size_t(counted > 10 ? 1 : 0));
      if (notes.empty()) continue;
      QCOMPARE(notes[0].code, NoteCode::MessagesMissing);
      QCOMPARE(notes[0].count, std::uint64_t(7));
    }
  }

  void whatIsCompressedAsAWholeIsUnpacked() {
    const std::vector<Said> said = someMessages(4, 1000, 500);
    const QString db3 = fresh(".db3"), folder = freshFolder();
    writeDb3(db3, 3, said);
    const Made made = makeRecording(3, 20, 100, 1);
    for (const bool sqlite : {true, false}) {
      const QString path = fresh(sqlite ? ".db3.zstd" : ".mcap.zstd");
      writeText(path, zstd(sqlite ? contentOf(db3) : *made.bytes));
      const Opened file = opened(path);
      QVERIFY(file);
      QVERIFY(has(**file, NoteCode::Unpacked));
      QVERIFY(rowsOf(**file) == (sqlite ? byTime(said) : made.byTime()));
    }
    writeText(folder + QStringLiteral("/a.db3.zstd"), zstd(contentOf(db3)));
    writeMetadata(folder, {"a.db3.zstd"});
    const Opened whole = opened(folder);
    QVERIFY(whole && rowsOf(**whole) == byTime(said));
    Limits small;
    small.most_unpacked_bytes = 1000;
    const Opened refused = openRecording((folder + QStringLiteral("/a.db3.zstd")).toStdString(), small);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, Failure::Code::NotUnpacked);
    writeText(fresh(".db3.zstd"), zstd("neither"));
  }

  void messagesThatAreCompressedAloneAreUnpacked() {
    std::vector<Said> packed = someMessages(6, 1000, 50);
    const std::vector<Row> expected = byTime(packed);
    for (Said& said : packed) said.bytes = zstd(said.bytes);
    const QString path = fresh(".db3");
    writeDb3(path, 3, packed);
    const Opened file = opened(path);
    QVERIFY(file && rowsOf(**file) == expected);
  }

  void whatIsStillInTheJournalIsRead() {
    const QString path = fresh(".db3");
    const std::vector<Said> said = someMessages(8, 1000, 200);
    writeDb3(path, 3, {said.begin(), said.begin() + 100});
    Sql sql(path);
    sql.run("PRAGMA journal_mode = WAL");
    for (std::size_t i = 100; i < 150; ++i) sql.message(said[i]);
    const Opened file = opened(path);
    QVERIFY(file);
    QVERIFY(!(*file)->summary().finished);
    QVERIFY(rowsOf(**file) == byTime({said.begin(), said.begin() + 150}));
    // It is still being written.
    for (std::size_t i = 150; i < 200; ++i) sql.message(said[i]);
    QVERIFY((*file)->refresh());
    QVERIFY(rowsOf(**file) == byTime(said));
  }

  void otherDatabasesAndViewsAreNoRecordings() {
    const QString other = fresh(".db3"), view = fresh(".db3");
    Sql(other).run("CREATE TABLE versions (id INTEGER)");
    Sql sql(view);
    sql.run("CREATE TABLE topics (id INTEGER PRIMARY KEY, name TEXT, type TEXT, serialization_format TEXT)");
    sql.run(
        "CREATE VIEW messages AS WITH RECURSIVE n(id) AS (SELECT 1 UNION ALL SELECT id + 1 FROM n) SELECT "
        "id, 1 AS "
        "topic_id, 1 AS timestamp, x'00' AS data FROM n");
    for (const QString& path : {other, view}) {
      const Opened file = opened(path);
      QVERIFY(!file);
      QCOMPARE(file.error().code, Failure::Code::Database);
    }
  }

  void aDamagedDatabaseDoesNoHarm() {
    const QString path = fresh(".db3"), broken = fresh(".db3");
    writeDb3(path, 4, someMessages(9, 1000, 300));
    const std::string whole = contentOf(path);
    std::mt19937 random(11);
    int fewer = 0;
    for (int round = 0; round < 200; ++round) {
      std::string bytes = whole;
      if (random() % 4 == 0) bytes.resize(random() % bytes.size());
      for (unsigned n = 0; n < 20 && !bytes.empty(); ++n) bytes[random() % bytes.size()] = char(random());
      writeText(broken, bytes);
      const Opened file = opened(broken);
      if (!file) continue;
      const std::size_t rows = rowsOf(**file).size();
      if (rows < 300) ++fewer;
      // What was lost is said.
      if (rows < 300) QVERIFY(!(*file)->summary().notes.empty() || rows == (*file)->summary().messages);
    }
    QVERIFY(fewer > 0);
  }

  void definitionsOfCommonTypesAreKnown() {
    QVERIFY(knownDefinitions("my_msgs/msg/Thing").empty());
    for (const char* type :
         {"nav_msgs/msg/OccupancyGrid", "tf2_msgs/msg/TFMessage", "sensor_msgs/msg/LaserScan",
          "sensor_msgs/PointCloud2", "nav2_msgs/msg/Costmap", "visualization_msgs/msg/MarkerArray"}) {
      const std::vector<std::string> all = knownDefinitions(type);
      QVERIFY2(!all.empty(), type);
      for (const std::string& text : all) QVERIFY2(parseRosSchema(type, text, RosDialect::Ros2), type);
    }
    // Markers of Galactic and of Humble differ; the message tells which.
    const std::vector<std::string> markers = knownDefinitions("visualization_msgs/msg/Marker");
    QCOMPARE(markers.size(), std::size_t(2));
    std::string empty("\0\1\0\0", 4);
    // stamp, frame, ns, id, type, action, pose, scale, color, lifetime, locked, points, colors, text, mesh,
    // embedded.
    const auto pad = [&](std::size_t to) {
      while ((empty.size() - 4) % to != 0) empty += '\0';
    };
    const auto put = [&](std::size_t bytes, std::size_t align) {
      pad(align);
      empty += std::string(bytes, '\0');
    };
    put(8, 4);
    for (int i = 0; i < 2; ++i) put(4, 4);  // frame, ns
    for (int i = 0; i < 3; ++i) put(4, 4);  // id, type, action
    put(10 * 8, 8);                         // pose, scale
    put(16, 4);                             // color
    put(8, 4);                              // lifetime
    put(1, 1);                              // locked
    for (int i = 0; i < 4; ++i) put(4, 4);  // points, colors, text, mesh
    put(1, 1);
    QVERIFY(!fitsDefinition("visualization_msgs/msg/Marker", markers[0], bytesOf(empty)));
    QVERIFY(fitsDefinition("visualization_msgs/msg/Marker", markers[1], bytesOf(empty)));
  }

  void definitionsInIdlSayTheSame() {
    const std::string rule = std::string(80, '=') + "\n";
    const std::string idl = rule + idl_sample::kThing + rule + idl_sample::kPart + rule + idl_sample::kHeader;
    const std::string msg =
        "std_msgs/Header header\nuint8 level\nfloat64[36] covariance\nPart[2] pair\nPart[] "
        "parts\nfloat32[<=5] floats\n"
        "string<=10 name\nstring<=4[<=3] names\nint64 large\nuint16 s\nuint16 t\nbool yes\nbyte[3] "
        "raw\nbyte[] bytes\n" +
        rule + "MSG: a_msgs/Part\nfloat32 x\nint8 kind\nEmpty nothing\n" + rule + "MSG: a_msgs/Empty\n" +
        rule + "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n";
    const auto made = parseRosIdl("a_msgs/msg/Thing", idl);
    QVERIFY2(made, made ? "" : (made.error().word + " in line " + std::to_string(made.error().line)).c_str());
    const auto wanted = parseRosSchema("a_msgs/msg/Thing", msg, RosDialect::Ros2);
    QVERIFY(wanted);
    // The same bytes are the same message; an empty struct has no byte in either.
    std::mt19937 random(3);
    int read = 0;
    for (int round = 0; round < 2000; ++round) {
      std::string bytes("\0\1\0\0", 4);
      for (unsigned n = 0; n < 600; ++n) bytes += random() % 6 == 0 ? char(random() % 3) : '\0';
      const auto a = rosToCbor(*made, RosWire::Cdr, bytesOf(bytes));
      const auto b = rosToCbor(*wanted, RosWire::Cdr, bytesOf(bytes));
      QCOMPARE(a.has_value(), b.has_value());
      if (a) QCOMPARE(*a, *b);
      read += a.has_value();
    }
    QVERIFY(read > 100);
  }

  /// Ten thousand members in a module of half a megabyte were five gigabytes.
  void namesInIdlAreNoLongerThanAnybodyWrites() {
    const auto inModule = [](const std::string& module) {
      return parseRosIdl(module + "/B", "module " + module + " { struct B { float x; }; };");
    };
    const auto isTooLong = [](const auto& made) {
      return !made && made.error().code == RosSchemaFault::Code::TooLong;
    };
    const std::string half(130, 'm');
    QVERIFY(inModule(std::string(255, 'm')));
    QVERIFY(isTooLong(inModule(std::string(256, 'm'))));
    QVERIFY(isTooLong(inModule(half + " { module " + half)));
    QVERIFY(isTooLong(parseRosIdl("a/B", "module a { struct B { " + half + "::" + half + " x; }; };")));
  }

  void whateverStandsInAnIdlReadingEnds() {
    QVERIFY(!parseRosIdl("a/B", "module a { struct B { B b; }; };"));
    QVERIFY(!parseRosIdl("a/B", "module a { typedef C D; typedef D C; struct B { C c; }; };"));
    std::string deep = "module a { struct B { ";
    for (int i = 0; i < 100'000; ++i) deep += "sequence<";
    QVERIFY(!parseRosIdl("a/B", deep));
    std::string modules;
    for (int i = 0; i < 100'000; ++i) modules += "module a {";
    QVERIFY(!parseRosIdl("a/B", modules));
    const std::vector<std::string> pieces{"module ", "struct ", "a ",    "B ",       "{",         "}",
                                          ";",       "@",       "(",     ")",        "\"",        "/*",
                                          "//",      "\n",      "#",     "typedef ", "const ",    "sequence<",
                                          ">",       "[3]",     "long ", "::",       "=",         "enum ",
                                          "string",  "<",       "3",     ",",        "unsigned ", "double "};
    std::mt19937 random(17);
    for (int round = 0; round < 20'000; ++round) {
      std::string text = random() % 2 ? "module a { struct B { " : "";
      for (auto n = random() % 20; n > 0; --n) text += pieces[random() % pieces.size()];
      (void)parseRosIdl("a/B", text);
    }
  }
};

}  // namespace test_rosbag2

MAPWRIGHT_TEST(test_rosbag2, Rosbag2Test, Nothing)
#include "test_rosbag2.moc"
