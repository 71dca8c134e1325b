#include <QtTest>

#include "recordings.h"
#include "test_program.h"

namespace test_mcap {

using namespace recordings;

class TestMcap : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whatIsWrittenIsRead();
  void anEmptyRecordingIsOne();
  void oneMessageIsFound();
  void messagesComeInTheOrderOfTheirTimes();
  void aRangeHoldsBothItsEnds();
  void backwardsIsForwardsTurnedRound();
  void onlyChosenTopicsCome();
  void theLastBeforeATimeIsTheOneThatPlayingGives();
  void theOutermostOfEachChannelAreFound();
  void topicsThatShareANameAreOneTopic();
  void messagesOutsideOfChunksAreFound();
  void messagesStayWhenTheSourceIsGone();
  void littleMemoryIsEnoughForChunksThatAllOverlap();
  void attachmentsAndMetadataComeBack();
  void channelsWithoutMessagesAreListed();
  void otherFilesAreNoRecordings();
};

void TestMcap::whatIsWrittenIsRead() {
  for (const auto compression : {WriterOptions::Compression::None, WriterOptions::Compression::Zstd}) {
    WriterOptions options;
    options.compression = compression;
    options.profile = "ros2";
    const Made made = makeRecording(3, 50, 0, 1, options);
    const Opened opened = made.open();
    QVERIFY(opened);
    Source& source = **opened;
    QCOMPARE(rowsOf(source) == made.byTime(), true);
    const Summary summary = source.summary();
    QVERIFY(summary.notes.empty() && summary.finished && summary.indexed && summary.counted);
    QCOMPARE(summary.messages, std::uint64_t(150));
    QCOMPARE(summary.chunks, std::size_t(3));
    QCOMPARE(summary.profile, std::string("ros2"));
    QCOMPARE(summary.library, std::string("mapwright"));
    QCOMPARE(summary.start_ns, made.byTime().front().log_ns);
    QCOMPARE(summary.end_ns, made.byTime().back().log_ns);
    std::uint64_t counted = 0;
    for (const auto& [channel, count] : summary.messages_of) counted += count;
    QCOMPARE(counted, std::uint64_t(150));
    QCOMPARE(source.channels().size(), std::size_t(3));
    Channel pose = channelOf("/pose");
    pose.id = 1;
    QCOMPARE(*source.channels()[0] == pose, true);
  }
}

void TestMcap::anEmptyRecordingIsOne() {
  const auto bytes = std::make_shared<std::string>();
  QVERIFY(!writerInto(bytes)->close());
  const Opened opened = openRecording(heldBytes(bytes));
  QVERIFY(opened);
  const Summary summary = (*opened)->summary();
  QVERIFY(rowsOf(**opened).empty() && lastRows(**opened, 0).empty());
  QVERIFY(!summary.start_ns && !summary.end_ns && summary.messages == 0 && summary.notes.empty());
  QCOMPARE(summary.durationNs(), std::int64_t(0));
}

void TestMcap::oneMessageIsFound() {
  const Made made = makeRecording(1, 1, 0, 3);
  const Opened opened = made.open();
  QVERIFY(opened);
  QCOMPARE(rowsOf(**opened) == made.rows, true);
  QCOMPARE(lastRows(**opened, made.rows[0].log_ns) == made.rows, true);
  QVERIFY(lastRows(**opened, made.rows[0].log_ns - 1).empty());
}

void TestMcap::messagesComeInTheOrderOfTheirTimes() {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Made made = makeRecording(12, 30, 60'000, seed);  // a chunk is 20 µs long: many overlap
    const Opened opened = made.open();
    QVERIFY(opened);
    QCOMPARE(rowsOf(**opened) == made.byTime(), true);
  }
}

void TestMcap::aRangeHoldsBothItsEnds() {
  const Made made = makeRecording(8, 40, 30'000, 5);
  const Opened opened = made.open();
  const std::vector<Row> all = made.byTime();
  std::mt19937 random(9);
  for (int i = 0; i < 200; ++i) {
    Query query;
    query.first_ns = all[random() % all.size()].log_ns + std::int64_t(random() % 3) - 1;
    query.last_ns = all[random() % all.size()].log_ns + std::int64_t(random() % 3) - 1;
    query.backwards = random() % 2 == 0;
    std::vector<Row> expected;
    for (const Row& row : all) {
      if (row.log_ns >= query.first_ns && row.log_ns <= query.last_ns) expected.push_back(row);
    }
    if (query.backwards) std::reverse(expected.begin(), expected.end());
    QCOMPARE(rowsOf(**opened, query) == expected, true);
  }
}

void TestMcap::backwardsIsForwardsTurnedRound() {
  const Made made = makeRecording(12, 30, 60'000, 11);
  const Opened opened = made.open();
  Query query;
  query.backwards = true;
  std::vector<Row> rows = rowsOf(**opened, query);
  std::reverse(rows.begin(), rows.end());
  QCOMPARE(rows == made.byTime(), true);
}

void TestMcap::onlyChosenTopicsCome() {
  const Made made = makeRecording(6, 40, 20'000, 12);
  const Opened opened = made.open();
  Query query;
  query.topics = {"/scan", "/none", "/map"};
  std::vector<Row> expected = made.byTime();
  std::erase_if(expected, [](const Row& row) { return row.topic == "/pose"; });
  QCOMPARE(rowsOf(**opened, query) == expected, true);
  query.topics = {"/none"};
  QVERIFY(rowsOf(**opened, query).empty());
}

void TestMcap::theLastBeforeATimeIsTheOneThatPlayingGives() {
  for (unsigned seed = 20; seed < 30; ++seed) {
    const Made made = makeRecording(10, 25, 40'000, seed);
    const Opened opened = made.open();
    const std::vector<Row> all = made.byTime();
    std::mt19937 random(seed);
    for (int i = 0; i < 40; ++i) {
      const std::int64_t at = all[random() % all.size()].log_ns + std::int64_t(random() % 3) - 1;
      std::map<std::string, Row> expected;
      for (const Row& row : all) {
        if (row.log_ns <= at) expected[row.topic] = row;
      }
      const std::vector<Row> found = lastRows(**opened, at);
      QCOMPARE(found.size(), expected.size());
      for (const Row& row : found) QCOMPARE(row == expected[row.topic], true);
      QCOMPARE(lastRows(**opened, at, {"/map"}).size(), expected.count("/map"));
    }
  }
}

void TestMcap::theOutermostOfEachChannelAreFound() {
  for (unsigned seed = 40; seed < 60; ++seed) {
    // Many channels, most of them in few chunks, and none at all on one.
    std::mt19937 random(seed);
    const auto bytes = std::make_shared<std::string>();
    WriterOptions options;
    options.chunk_bytes = std::size_t(1) << 30;
    options.chunk_ns = std::numeric_limits<std::int64_t>::max();
    const auto writer = writerInto(bytes, options);
    std::map<std::uint32_t, std::vector<std::int64_t>> times;
    std::vector<ChannelId> ids;
    for (int i = 0; i < 30; ++i) ids.push_back(*writer->addChannel(channelOf("/t" + std::to_string(i))));
    for (std::int64_t i = 0; i < 400; ++i) {
      const ChannelId id = ids[std::min<std::size_t>(random() % 29, random() % 29)];
      const std::int64_t at = i * 10 + std::int64_t(random() % 300);
      writer->write(id, {at, at, 0}, bytesOf("x"));
      times[id].push_back(at);
      if (random() % 20 == 0) writer->flush();
    }
    writer->close();
    const Opened opened = openRecording(heldBytes(bytes));
    std::set<std::uint32_t> wanted;
    for (const ChannelId id : ids) {
      if (random() % 2 == 0) wanted.insert(id);
    }
    for (const bool last : {false, true}) {
      std::map<std::uint32_t, std::int64_t> expected;
      for (const auto& [id, all] : times) {
        if (wanted.contains(id))
          expected[id] =
              last ? *std::max_element(all.begin(), all.end()) : *std::min_element(all.begin(), all.end());
      }
      QVERIFY((*opened)->outermostTimes(wanted, last) == expected);
    }
  }
}

void TestMcap::topicsThatShareANameAreOneTopic() {
  const auto bytes = std::make_shared<std::string>();
  auto writer = writerInto(bytes);
  Channel other = channelOf("/tf");
  other.metadata["callerid"] = "/two";
  const ChannelId one = *writer->addChannel(channelOf("/tf")), two = *writer->addChannel(other);
  QVERIFY(one != two);
  QCOMPARE(*writer->addChannel(channelOf("/tf")), one);
  for (std::int64_t i = 0; i < 10; ++i) {
    writer->write(i % 3 == 0 ? one : two, {i, i, std::uint32_t(i)}, bytesOf("x"));
    writer->flush();
  }
  writer->close();
  const Opened opened = openRecording(heldBytes(bytes));
  QVERIFY(opened);
  Query query;
  query.topics = {"/tf"};
  QCOMPARE(rowsOf(**opened, query).size(), std::size_t(10));
  for (std::int64_t at = 0; at < 10; ++at) {
    const std::vector<Row> last = lastRows(**opened, at);
    QCOMPARE(last.size(), std::size_t(1));
    QCOMPARE(last[0].log_ns, at);
  }
}

void TestMcap::messagesOutsideOfChunksAreFound() {
  RawMcap raw;
  RawMcap::channel(raw.out, 1, "/a");
  for (std::uint64_t i = 0; i < 5; ++i) RawMcap::message(raw.out, 1, 100 - i, std::string(i, 'x'));
  raw.end();
  const Opened opened = raw.open();
  QVERIFY(opened);
  const std::vector<Row> rows = rowsOf(**opened);
  QCOMPARE(rows.size(), std::size_t(5));
  QCOMPARE(rows[0].bytes, std::string("xxxx"));
  QCOMPARE(lastRows(**opened, 98)[0].bytes, std::string("xx"));
  QVERIFY(has(**opened, NoteCode::NoIndex));
  QVERIFY((*opened)->summary().finished);
  QCOMPARE((*opened)->summary().messages, std::uint64_t(5));
}

void TestMcap::messagesStayWhenTheSourceIsGone() {
  const Made made = makeRecording(2, 20, 0, 13);
  std::vector<Message> kept;
  {
    const Opened opened = made.open();
    const auto cursor = (*opened)->messages({});
    while (auto message = cursor->next()) kept.push_back(std::move(*message));
  }
  for (std::size_t i = 0; i < kept.size(); ++i) QCOMPARE(rowOf(kept[i]) == made.byTime()[i], true);
}

void TestMcap::littleMemoryIsEnoughForChunksThatAllOverlap() {
  const Made made = makeRecording(30, 10, 1'000'000, 14);
  Limits limits;
  limits.held_bytes = 1;  // one chunk
  const Opened opened = made.open(limits);
  QVERIFY(opened);
  QCOMPARE(rowsOf(**opened) == made.byTime(), true);
}

void TestMcap::attachmentsAndMetadataComeBack() {
  const auto bytes = std::make_shared<std::string>();
  auto writer = writerInto(bytes);
  const ChannelId id = *writer->addChannel(channelOf("/a"));
  writer->write(id, {5, 5, 1}, bytesOf("x"));
  const Attachment map{"office.png", "image/png", 10, 9, std::string(100'000, '\x7f')};
  QVERIFY(!writer->attach(map));
  QVERIFY(!writer->addMetadata({"robot", {{"sn", "42"}, {"model", "K"}}}));
  writer->write(id, {6, 6, 2}, bytesOf("y"));
  writer->close();
  const Opened opened = openRecording(heldBytes(bytes));
  QVERIFY(opened);
  Source& source = **opened;
  QCOMPARE(rowsOf(source).size(), std::size_t(2));
  QCOMPARE(source.attachments().size(), std::size_t(1));
  QCOMPARE(source.attachments()[0].size, std::uint64_t(100'000));
  const std::optional<Attachment> read = source.attachment(source.attachments()[0]);
  QVERIFY(read);
  QVERIFY(read->bytes == map.bytes && read->name == map.name && read->media_type == map.media_type);
  QVERIFY(read->log_time_ns == 10 && read->create_time_ns == 9);
  QCOMPARE(source.metadata() == (std::vector<Metadata>{{"robot", {{"sn", "42"}, {"model", "K"}}}}), true);

  const std::size_t inside = bytes->find("\x7f\x7f\x7f");
  (*bytes)[inside + 50'000] = 'x';
  const Opened damaged = openRecording(heldBytes(bytes));
  QVERIFY(!(*damaged)->attachment((*damaged)->attachments()[0]));
  QVERIFY(has(**damaged, NoteCode::AttachmentCorrupt));
}

void TestMcap::channelsWithoutMessagesAreListed() {
  const auto bytes = std::make_shared<std::string>();
  auto writer = writerInto(bytes);
  writer->addChannel(channelOf("/silent"));
  writer->close();
  const Opened opened = openRecording(heldBytes(bytes));
  QVERIFY(opened);
  QCOMPARE((*opened)->channels().size(), std::size_t(1));
  QCOMPARE((*opened)->channels()[0]->schema_data, channelOf("/silent").schema_data);
}

void TestMcap::otherFilesAreNoRecordings() {
  const auto failureOf = [](const std::string& text) {
    return openRecording(heldBytes(std::make_shared<std::string>(text))).error().code;
  };
  QCOMPARE(failureOf(""), Failure::Code::NotOne);
  QCOMPARE(failureOf("\x89MCA"), Failure::Code::NotOne);
  QCOMPARE(failureOf("SQLite format 3 and so on"), Failure::Code::NotOne);
  QCOMPARE(failureOf("\x89MCAP9\r\n and what that is nobody knows"), Failure::Code::Version);
  const Opened absent = openRecording(std::string("/nowhere/a.mcap"));
  QVERIFY(!absent && absent.error().code == Failure::Code::File && absent.error().file.cause.any());
  const Opened folder = openRecording(std::string("/"));
  QVERIFY(!folder && folder.error().file.cause.code == mapwright::disk::fault::IsAFolder);
}

}  // namespace test_mcap

MAPWRIGHT_TEST(test_mcap, TestMcap, Core)
#include "test_mcap.moc"
