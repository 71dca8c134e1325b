#include <QtTest>

#include "bags.h"
#include "test_program.h"

namespace test_ros1_bag {

using namespace recordings;

class TestRos1Bag : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void bagsOfEveryCompressionAreRead();
  void bagsWithoutAnIndexAreReadAllTheSame();
  void theLastBeforeATimeIsTheOneThatPlayingGives();
  void aBagThatWasCutHoldsItsWholeChunks();
  void aFlippedByteCostsAtMostAChunk();
  void aBagThatGrowsIsFollowed();
  void emptyBagsAndBagsOfOneMessageAreRead();
  void otherVersionsAreNamed();
  void lengthsThatLieTakeNoMemory();
  void garbageNeverDoesHarm();
};

namespace {
const std::vector<std::string> kCompressions{"none", "bz2", "lz4"};
}

void TestRos1Bag::bagsOfEveryCompressionAreRead() {
  for (const std::string& compression : kCompressions) {
    const Made made = makeBag({.compression = compression});
    const Opened opened = made.open();
    QVERIFY(opened);
    QCOMPARE(rowsOf(**opened) == made.byTime(), true);
    const Summary summary = (*opened)->summary();
    QVERIFY(summary.notes.empty() && summary.indexed && summary.finished);
    QCOMPARE(summary.messages, std::uint64_t(made.rows.size()));
    QCOMPARE(summary.start_ns, made.byTime().front().log_ns);
    const Channel& channel = *(*opened)->channels()[1];
    QCOMPARE(channel.topic, std::string("/map"));
    QCOMPARE(channel.message_encoding, std::string("ros1"));
    QCOMPARE(channel.schema_name, std::string("test/Number"));
    QCOMPARE(channel.schema_data, std::string("int32 n\n"));
    QCOMPARE(channel.metadata.at("callerid"), std::string("/node"));
  }
}

void TestRos1Bag::bagsWithoutAnIndexAreReadAllTheSame() {
  for (const std::string& compression : kCompressions) {
    const Made made = makeBag({.compression = compression, .indexed = false});
    const Opened opened = made.open();
    QVERIFY(opened);
    QCOMPARE(rowsOf(**opened) == made.byTime(), true);
    QVERIFY(!(*opened)->summary().indexed && has(**opened, NoteCode::NotFinished));
    QCOMPARE((*opened)->summary().messages, std::uint64_t(made.rows.size()));
  }
}

void TestRos1Bag::theLastBeforeATimeIsTheOneThatPlayingGives() {
  for (const bool indexed : {true, false}) {
    const Made made = makeBag({.compression = "lz4", .chunks = 10, .indexed = indexed, .seed = 4});
    const Opened opened = made.open();
    const std::vector<Row> all = made.byTime();
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::int64_t at = all[i].log_ns + std::int64_t(i % 3) - 1;
      std::map<std::string, Row> expected;
      for (const Row& row : all) {
        if (row.log_ns <= at) expected[row.topic] = row;
      }
      const std::vector<Row> found = lastRows(**opened, at);
      QCOMPARE(found.size(), expected.size());
      for (const Row& row : found) QCOMPARE(row == expected[row.topic], true);
    }
  }
}

void TestRos1Bag::aBagThatWasCutHoldsItsWholeChunks() {
  for (const std::string& compression : kCompressions) {
    const Made made = makeBag({.compression = compression, .chunks = 3, .each = 5});
    for (std::size_t cut = 0; cut < made.bytes->size(); cut += cut < 4000 ? 97 : 1) {
      const Opened opened =
          openRecording(heldBytes(std::make_shared<std::string>(made.bytes->substr(0, cut))));
      QCOMPARE(bool(opened), cut >= 13);
      if (!opened) continue;
      std::size_t whole = 0;
      for (const auto& [end, rows] : made.chunks) whole = end <= cut ? rows : whole;
      const std::vector<Row> found = rowsOf(**opened);
      QVERIFY(found.size() == whole || found.size() == whole + 5);
      Made part;
      part.rows.assign(made.rows.begin(), made.rows.begin() + std::ptrdiff_t(found.size()));
      QCOMPARE(found == part.byTime(), true);
      QVERIFY(!(*opened)->summary().notes.empty());
    }
  }
}

void TestRos1Bag::aFlippedByteCostsAtMostAChunk() {
  // A bag has no checksums: of plain chunks a changed byte may be a changed message. bzip2 sees it.
  const Made made = makeBag({.compression = "bz2", .chunks = 4, .each = 5});
  for (std::size_t at = 13; at<made.bytes->size(); at += at> 100 && at < 4000 ? 97 : 1) {
    const auto bytes = std::make_shared<std::string>(*made.bytes);
    (*bytes)[at] = char((*bytes)[at] ^ 0x15);
    const Opened opened = openRecording(heldBytes(bytes));
    QVERIFY(opened);
    const std::vector<Row> found = rowsOf(**opened);
    if (found.size() + 5 < made.rows.size()) QFAIL(qPrintable(QString::number(at)));
    const auto written = [&](const Row& row) {
      return std::any_of(made.rows.begin(), made.rows.end(), [&](const Row& known) {
        return known.bytes == row.bytes && known.log_ns == row.log_ns;
      });
    };
    QVERIFY(std::all_of(found.begin(), found.end(), written));
  }
}

void TestRos1Bag::aBagThatGrowsIsFollowed() {
  const Made made = makeBag({.compression = "lz4", .indexed = false});
  for (const std::size_t step : {13, 300}) {
    const auto growing = std::make_shared<std::string>(made.bytes->substr(0, 4200));
    const Opened opened = openRecording(heldBytes(growing));
    QVERIFY(opened);
    for (std::size_t size = 4200; size < made.bytes->size();) {
      size = std::min(size + step, made.bytes->size());
      growing->assign(*made.bytes, 0, size);
      (*opened)->refresh();
      for (const auto& [end, rows] : made.chunks) {
        if (end <= size) QVERIFY(rowsOf(**opened).size() >= rows);
      }
    }
    QCOMPARE(rowsOf(**opened) == made.byTime(), true);
    QVERIFY(!has(**opened, NoteCode::CutOff));
    QCOMPARE(lastRows(**opened, made.byTime().back().log_ns).size(), std::size_t(3));
  }
}

void TestRos1Bag::emptyBagsAndBagsOfOneMessageAreRead() {
  for (const std::size_t chunks : {0, 1}) {
    const Made made = makeBag({.chunks = chunks, .each = 1});
    const Opened opened = made.open();
    QVERIFY(opened);
    QCOMPARE(rowsOf(**opened).size(), chunks);
    QCOMPARE(bool((*opened)->summary().start_ns), chunks == 1);
  }
}

void TestRos1Bag::otherVersionsAreNamed() {
  const auto failureOf = [](const std::string& text) {
    return openRecording(heldBytes(std::make_shared<std::string>(text))).error().code;
  };
  QCOMPARE(failureOf("#ROSRECORD V1.2\n and so on"), Failure::Code::Version);
  QCOMPARE(failureOf("#ROSBAG V3.0\n and so on"), Failure::Code::Version);
  const std::string header =
      field("encryptor", "rosbag/AesCbcEncryptor") + field("index_pos", number64(0)) + op(3);
  QCOMPARE(failureOf("#ROSBAG V2.0\n" + record(header, "")), Failure::Code::Encrypted);
}

void TestRos1Bag::lengthsThatLieTakeNoMemory() {
  const std::string start = "#ROSBAG V2.0\n" + record(field("index_pos", number64(0)) + op(3), "");
  const std::string chunk = field("compression", "bz2") + op(5) + field("size", number32(0xfffffff0));
  for (const std::string& bytes :
       {start + record(chunk, "BZh9 is not"), start + number32(0xffffffff) + "x",
        start + record(op(7) + field("conn", number32(1)), "") + number32(5) + "12345" + number32(0xffffffff),
        start + record(field("compression", "none") + op(5) + field("size", number32(4)),
                       number32(0xffffffff))}) {
    const Opened opened = openRecording(heldBytes(std::make_shared<std::string>(bytes)));
    QVERIFY(opened);
    QVERIFY(rowsOf(**opened).empty());
    QVERIFY(!(*opened)->summary().notes.empty());
  }
}

void TestRos1Bag::garbageNeverDoesHarm() {
  const int rounds =
      qEnvironmentVariableIsSet("MAPWRIGHT_FUZZ") ? qEnvironmentVariableIntValue("MAPWRIGHT_FUZZ") : 300;
  std::vector<Made> files;
  for (const std::string& compression : kCompressions) files.push_back(makeBag({.compression = compression}));
  files.push_back(makeBag({.indexed = false}));
  Limits limits;
  limits.most_chunk_bytes = std::size_t(1) << 20;
  std::mt19937 random(78);
  for (int round = 0; round < rounds; ++round) {
    auto bytes = std::make_shared<std::string>(*files[random() % files.size()].bytes);
    for (std::size_t i = 1 + random() % 8; i > 0 && bytes->size() > 4200; --i) {
      const std::size_t at =
          random() % 10 == 0 ? 13 + random() % 80 : 4109 + random() % (bytes->size() - 4110);
      const std::size_t length = std::min<std::size_t>(random() % 40, bytes->size() - at);
      switch (random() % 4) {
        case 0:
          (*bytes)[at] = char(random());
          break;
        case 1:
          bytes->erase(at, length);
          break;
        case 2:
          bytes->insert(at, bytes->substr(4109 + random() % (bytes->size() - 4109), length));
          break;
        default:
          std::fill_n(bytes->begin() + std::ptrdiff_t(at), length, random() % 2 == 0 ? '\0' : '\xff');
      }
    }
    const Opened opened = openRecording(heldBytes(bytes), limits);
    if (opened) readEverything(**opened);
  }
}

}  // namespace test_ros1_bag

MAPWRIGHT_TEST(test_ros1_bag, TestRos1Bag, Core)
#include "test_ros1_bag.moc"
