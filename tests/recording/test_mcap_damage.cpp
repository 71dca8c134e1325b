#include <lz4frame.h>

#include <QtTest>

#include "packed/codec.h"
#include "recordings.h"
#include "test_program.h"

namespace test_mcap_damage {

using namespace recordings;

class TestMcapDamage : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aFileThatWasCutHoldsItsWholeChunks();
  void aFlippedByteCostsAtMostAChunk();
  void readingGoesOnBehindWhatIsNoRecord();
  void recordsOfAnotherKindAreNoDamage();
  void aFileThatGrowsIsFollowed();
  void lz4AndOverlongChunksAreRead();
  void aBombTakesNoMemory();
  void aChunkThatLiesAboutItsTimesIsReadInOrder();
  void aChunkThatStatesNoTimesIsRead();
  void timesBeyondAllTimesAreNone();
  void anIndexThatLiesIsFoundOut();
  void messagesOfNobodysChannelAreCounted();
  void anUnknownCompressionIsNamed();
  void schemasThatOnlyTheChunksHoldAreFound();
  void aTopicThatBecomesAnotherIsNoted();
  void whatFollowsTheEndIsNoted();
  void messagesThatAreCountedButMissingAreNoted();
  void garbageNeverDoesHarm();
};

namespace {

bool allWritten(const std::vector<Row>& found, const std::vector<Row>& written) {
  return std::all_of(found.begin(), found.end(), [&](const Row& row) {
    return std::find(written.begin(), written.end(), row) != written.end();
  });
}

}  // namespace

void TestMcapDamage::aFileThatWasCutHoldsItsWholeChunks() {
  for (const auto compression : {WriterOptions::Compression::None, WriterOptions::Compression::Zstd}) {
    WriterOptions options;
    options.compression = compression;
    const Made made = makeRecording(3, 6, 4000, 2, options);
    for (std::size_t cut = 0; cut < made.bytes->size(); ++cut) {
      const Opened opened =
          openRecording(heldBytes(std::make_shared<std::string>(made.bytes->substr(0, cut))));
      QCOMPARE(bool(opened), cut >= 8);
      if (!opened) continue;
      std::size_t whole = 0;
      // Of a chunk the message indexes may be missing.
      for (const auto& [end, rows] : made.chunks) whole = end <= cut ? rows : whole;
      const std::vector<Row> found = rowsOf(**opened);
      const auto next = std::find_if(made.chunks.begin(), made.chunks.end(),
                                     [&](const auto& chunk) { return chunk.second > whole; });
      const std::size_t most = next == made.chunks.end() ? whole : next->second;
      if (found.size() != whole) QCOMPARE(found.size(), most);
      Made part;
      part.rows.assign(made.rows.begin(), made.rows.begin() + std::ptrdiff_t(found.size()));
      QCOMPARE(found == part.byTime(), true);
      QVERIFY(!(*opened)->summary().notes.empty());
      QCOMPARE((*opened)->summary().messages, std::uint64_t(found.size()));
      readEverything(**opened);
    }
  }
}

void TestMcapDamage::aFlippedByteCostsAtMostAChunk() {
  for (const auto compression : {WriterOptions::Compression::None, WriterOptions::Compression::Zstd}) {
    WriterOptions options;
    options.compression = compression;
    const Made made = makeRecording(4, 6, 4000, 4, options);
    for (std::size_t at = 8; at < made.bytes->size(); ++at) {
      for (const int bits : {0x01, 0x80, 0xff}) {
        const auto bytes = std::make_shared<std::string>(*made.bytes);
        (*bytes)[at] = char((*bytes)[at] ^ bits);
        const Opened opened = openRecording(heldBytes(bytes));
        QVERIFY(opened);
        const std::vector<Row> found = rowsOf(**opened);
        QVERIFY(allWritten(found, made.rows));
        if (found.size() + 6 < made.rows.size()) QFAIL(qPrintable(QString::number(at)));
        QVERIFY(std::is_sorted(found.begin(), found.end(),
                               [](const Row& a, const Row& b) { return a.log_ns < b.log_ns; }));
        QVERIFY(allWritten(lastRows(**opened, found.back().log_ns), made.rows));
      }
    }
  }
}

void TestMcapDamage::readingGoesOnBehindWhatIsNoRecord() {
  const Made made = makeRecording(4, 10, 0, 6);
  std::string bytes = made.bytes->substr(0, std::size_t(made.chunks[3].first));
  bytes.insert(std::size_t(made.chunks[1].first), std::string(10'000, '\x06') + "no record at all");
  const Opened opened = openRecording(heldBytes(std::make_shared<std::string>(bytes)));
  QVERIFY(opened);
  QCOMPARE(rowsOf(**opened) == made.byTime(), true);
  QVERIFY(has(**opened, NoteCode::BytesSkipped) && has(**opened, NoteCode::NotFinished));
}

void TestMcapDamage::recordsOfAnotherKindAreNoDamage() {
  const Made made = makeRecording(4, 10, 0, 6);
  for (const int op : {0x10, 0x42, 0x7f, 0x80, 0xff}) {
    for (const std::size_t length : {0, 1, 5000}) {
      mcap::RecordWriter record;
      record.begin(mcap::Op(op));
      record.raw(bytesOf(std::string(length, '\x01')));
      record.end();
      const std::string inserted(record.bytes().begin(), record.bytes().end());
      std::string bytes = made.bytes->substr(0, std::size_t(made.chunks[3].first));
      const auto whole = std::make_shared<std::string>(bytes);
      bytes.insert(std::size_t(made.chunks[1].first), inserted);
      const Opened opened = openRecording(heldBytes(std::make_shared<std::string>(bytes)));
      QVERIFY(opened);
      QCOMPARE(rowsOf(**opened) == made.byTime(), true);
      QVERIFY(!has(**opened, NoteCode::BytesSkipped));
      // Nor is it at the end of what was written.
      const Opened last = openRecording(heldBytes(std::make_shared<std::string>(*whole + inserted)));
      QVERIFY(last && !has(**last, NoteCode::BytesSkipped) && !has(**last, NoteCode::CutOff));
      QCOMPARE(rowsOf(**last) == made.byTime(), true);
    }
  }
}

void TestMcapDamage::aFileThatGrowsIsFollowed() {
  const Made made = makeRecording(5, 8, 5000, 7);
  for (const std::size_t step : {1, 7, 64, 500}) {
    const auto growing = std::make_shared<std::string>(made.bytes->substr(0, 8));
    const Opened opened = openRecording(heldBytes(growing));
    QVERIFY(opened);
    std::size_t seen = 0;
    for (std::size_t size = 8; size < made.bytes->size();) {
      size = std::min(size + step, made.bytes->size());
      growing->assign(*made.bytes, 0, size);
      (*opened)->refresh();
      const std::size_t now = rowsOf(**opened).size();
      QVERIFY(now >= seen);
      seen = now;
      for (const auto& [end, rows] : made.chunks) {
        if (end <= size) QVERIFY(now >= rows);
      }
    }
    QCOMPARE(rowsOf(**opened) == made.byTime(), true);
    QVERIFY((*opened)->summary().finished);
    QVERIFY(!has(**opened, NoteCode::NotFinished) && !has(**opened, NoteCode::CutOff));
    QCOMPARE(lastRows(**opened, made.byTime().back().log_ns).size(), std::size_t(3));
    QVERIFY(!(*opened)->refresh());
  }
}

void TestMcapDamage::lz4AndOverlongChunksAreRead() {
  mcap::RecordWriter records;
  RawMcap::channel(records, 3, "/lz4");
  for (std::uint64_t i = 0; i < 100; ++i) RawMcap::message(records, 3, i, std::string(200, char(i)));
  std::string packed(LZ4F_compressFrameBound(records.size(), nullptr), '\0');
  packed.resize(
      LZ4F_compressFrame(packed.data(), packed.size(), records.bytes().data(), records.size(), nullptr));
  RawMcap raw;
  raw.chunk(0, 99, records.size(), mapwright::packed::crc32(0, records.bytes()), "lz4", bytesOf(packed));
  raw.end();
  {
    const Opened opened = raw.open();
    QVERIFY(opened);
    QCOMPARE(rowsOf(**opened).size(), std::size_t(100));
    QCOMPARE((*opened)->channels()[0]->topic, std::string("/lz4"));
  }
  RawMcap wrong;
  wrong.chunk(0, 99, records.size() + 1, 0, "lz4", bytesOf(packed));
  wrong.chunk(0, 99, records.size() - 1, 0, "lz4", bytesOf(packed));
  wrong.end();
  const Opened opened = wrong.open();
  QVERIFY(rowsOf(**opened).empty());
  QVERIFY(has(**opened, NoteCode::ChunkCorrupt));
}

void TestMcapDamage::aBombTakesNoMemory() {
  const std::vector<std::uint8_t> zeros(std::size_t(64) << 20);
  const auto small = mapwright::packed::packZstd(zeros, 1);
  RawMcap raw;
  raw.chunk(0, 1, zeros.size(), 0, "zstd", small.bytes());            // says it
  raw.chunk(0, 1, 1000, 0, "zstd", small.bytes());                    // hides it
  raw.chunk(0, 1, std::uint64_t(1) << 40, 0, "zstd", small.bytes());  // a terabyte
  raw.chunk(0, 1, std::numeric_limits<std::uint64_t>::max(), 0, "lz4", small.bytes());
  raw.chunk(0, 1, std::uint64_t(1) << 40, 0, "", small.bytes());
  raw.end();
  Limits limits;
  limits.most_chunk_bytes = std::size_t(1) << 20;
  const Opened opened = raw.open(limits);
  QVERIFY(opened);
  QVERIFY(rowsOf(**opened).empty());
  QVERIFY(has(**opened, NoteCode::ChunkTooLarge) && has(**opened, NoteCode::ChunkCorrupt));
}

void TestMcapDamage::aChunkThatLiesAboutItsTimesIsReadInOrder() {
  mcap::RecordWriter records;
  RawMcap::channel(records, 1, "/a");
  RawMcap::message(records, 1, 500, "late");
  RawMcap::message(records, 1, 10, "early");
  RawMcap raw;
  raw.chunk(400, 450, records.size(), 0, "", records.bytes());
  raw.end();
  const Opened opened = raw.open();
  const std::vector<Row> rows = rowsOf(**opened);
  QCOMPARE(rows.size(), std::size_t(2));
  QVERIFY(rows[0].bytes == "early" && rows[1].bytes == "late");
  QCOMPARE((*opened)->summary().start_ns, std::int64_t(10));
}

void TestMcapDamage::timesBeyondAllTimesAreNone() {
  constexpr std::uint64_t kBeyond = std::uint64_t(1) << 63;
  mcap::RecordWriter records;
  RawMcap::channel(records, 1, "/a");
  RawMcap::message(records, 1, 5, "sound");
  RawMcap::message(records, 1, kBeyond, "none");
  RawMcap raw;
  raw.chunk(5, kBeyond, records.size(), 0, "", records.bytes());
  RawMcap::message(raw.out, 1, ~std::uint64_t(0), "none either");
  raw.end();
  const Opened opened = raw.open();
  const std::vector<Row> rows = rowsOf(**opened);
  QCOMPARE(rows.size(), std::size_t(1));
  QCOMPARE((*opened)->summary().end_ns, std::int64_t(5));
  QVERIFY(allWritten(lastRows(**opened, std::numeric_limits<std::int64_t>::max()), rows));
  const std::vector<Note> notes = (*opened)->summary().notes;
  const auto untimed = std::find_if(notes.begin(), notes.end(),
                                    [](const Note& note) { return note.code == NoteCode::TimeUnusable; });
  QVERIFY(untimed != notes.end() && untimed->count == 2);
}

void TestMcapDamage::anIndexThatLiesIsFoundOut() {
  WriterOptions options;
  options.compression = WriterOptions::Compression::None;
  const Made made = makeRecording(1, 4, 0, 8, options);
  // The stamps in the message indexes, not those in the messages or in the summary.
  std::string bytes = *made.bytes;
  const std::size_t index = bytes.find('\x07', std::size_t(made.chunks[0].first) - 200);
  QVERIFY(index != std::string::npos);
  const Opened sound = made.open();
  const std::int64_t end = made.byTime().back().log_ns;
  for (std::size_t at = std::size_t(made.chunks[0].first) - 8; at > std::size_t(made.chunks[0].first) - 80;
       --at) {
    std::string changed = bytes;
    changed[at] = char(changed[at] ^ 0x11);
    const Opened opened = openRecording(heldBytes(std::make_shared<std::string>(changed)));
    QVERIFY(opened);
    QVERIFY(allWritten(lastRows(**opened, end), made.rows));
    QCOMPARE(rowsOf(**opened) == made.byTime(), true);
  }
}

void TestMcapDamage::messagesOfNobodysChannelAreCounted() {
  mcap::RecordWriter records;
  RawMcap::channel(records, 1, "/a");
  RawMcap::message(records, 2, 1, "whose?");
  RawMcap::message(records, 1, 2, "mine");
  RawMcap::message(records, 2, 3, "whose?");
  RawMcap raw;
  raw.chunk(1, 3, records.size(), 0, "", records.bytes());
  raw.end();
  const Opened opened = raw.open();
  QCOMPARE(rowsOf(**opened).size(), std::size_t(1));
  const std::vector<Note> notes = (*opened)->summary().notes;
  const auto note = std::find_if(notes.begin(), notes.end(),
                                 [](const Note& n) { return n.code == NoteCode::UnknownChannel; });
  QVERIFY(note != notes.end());
  QCOMPARE(note->count, std::uint64_t(2));
}

void TestMcapDamage::anUnknownCompressionIsNamed() {
  RawMcap raw;
  raw.chunk(1, 3, 10, 0, "brotli", bytesOf("0123456789"));
  raw.end();
  const Opened opened = raw.open();
  QVERIFY(rowsOf(**opened).empty());
  const std::vector<Note> notes = (*opened)->summary().notes;
  QVERIFY(std::any_of(notes.begin(), notes.end(), [](const Note& note) {
    return note.code == NoteCode::ChunkCompression && note.name == "brotli";
  }));
}

namespace {

/// Ends a file of one chunk with this summary. `index_at`: where the chunk's only message index is, of
/// channel 1; it states no times then.
void endWith(RawMcap& raw, std::uint64_t chunk_at, const mcap::RecordWriter& records,
             const mcap::Statistics& statistics, std::optional<std::uint64_t> index_at = {}) {
  const std::uint64_t end = raw.out.bytes().size(), chunk_end = index_at.value_or(end);
  raw.out.begin(mcap::Op::DataEnd);
  raw.out.u32(0);
  raw.out.end();
  const std::uint64_t start = raw.out.bytes().size();
  raw.out.raw(records.bytes());
  raw.out.begin(mcap::Op::ChunkIndex);
  raw.out.u64(index_at ? 0 : 1).u64(index_at ? 0 : 2).u64(chunk_at).u64(chunk_end - chunk_at);
  if (index_at) raw.out.u32(10).u16(1).u64(*index_at);
  if (!index_at) raw.out.u32(0);
  raw.out.u64(end - chunk_end).text("").u64(0).u64(0);
  raw.out.end();
  mcap::write(raw.out, statistics);
  raw.out.begin(mcap::Op::Footer);
  raw.out.u64(start).u64(0).u32(0);
  raw.out.end();
  raw.out.raw(mcap::kMagic);
}

mcap::ChannelRecord channelOfSchema(std::uint16_t schema) {
  mcap::ChannelRecord record;
  record.id = 1;
  record.schema_id = schema;
  record.topic = "/a";
  record.message_encoding = "json";
  return record;
}

}  // namespace

/// What is asked for by time is there, whatever a chunk says of its times.
void TestMcapDamage::aChunkThatStatesNoTimesIsRead() {
  for (const bool indexed : {true, false}) {
    mcap::RecordWriter records, summary;
    mcap::write(records, channelOfSchema(0));
    const std::uint64_t first = records.size();
    RawMcap::message(records, 1, 1'000, "one");
    const std::uint64_t second = records.size();
    RawMcap::message(records, 1, 2'000, "two");
    RawMcap raw;
    const std::uint64_t at = raw.out.bytes().size();
    raw.chunk(0, 0, records.size(), 0, "", records.bytes());
    const std::uint64_t end = raw.out.bytes().size();
    raw.out.begin(mcap::Op::MessageIndex);
    raw.out.u16(1).u32(32).u64(1'000).u64(first).u64(2'000).u64(second);
    raw.out.end();
    if (!indexed) {
      raw.end();
    } else {
      mcap::write(summary, channelOfSchema(0));
      mcap::Statistics statistics;
      statistics.messages = 2;
      endWith(raw, at, summary, statistics, end);
    }
    const Opened opened = raw.open();
    QVERIFY(opened);
    QCOMPARE((*opened)->summary().start_ns, std::optional<std::int64_t>(1'000));
    const auto cursor = (*opened)->messages({.first_ns = 1'500, .last_ns = 2'500, .topics = {}});
    const auto found = cursor->next();
    QVERIFY(found);
    QCOMPARE(found->log_time_ns, std::int64_t(2'000));
  }
}

/// Writers may leave schemas out of the summary and still repeat the channels there.
void TestMcapDamage::schemasThatOnlyTheChunksHoldAreFound() {
  for (const bool defined : {true, false}) {
    mcap::RecordWriter records, summary;
    if (defined) mcap::write(records, mcap::Schema{3, "test/A", "jsonschema", "{}"});
    mcap::write(records, channelOfSchema(3));
    RawMcap::message(records, 1, 1, "one");
    RawMcap::message(records, 1, 2, "two");
    RawMcap raw;
    const std::uint64_t at = raw.out.bytes().size();
    raw.chunk(1, 2, records.size(), 0, "", records.bytes());
    mcap::write(summary, channelOfSchema(3));
    mcap::Statistics statistics;
    statistics.messages = 2;
    endWith(raw, at, summary, statistics);
    const Opened opened = raw.open();
    QVERIFY(opened && (*opened)->summary().indexed);
    QCOMPARE((*opened)->channels().size(), std::size_t(1));
    QCOMPARE((*opened)->channels().front()->schema_name, std::string(defined ? "test/A" : ""));
    QVERIFY((*opened)->summary().notes.empty());
    QCOMPARE(rowsOf(**opened).size(), std::size_t(2));
  }
}

void TestMcapDamage::aTopicThatBecomesAnotherIsNoted() {
  for (const bool other : {true, false}) {
    mcap::RecordWriter records;
    RawMcap::channel(records, 1, "/a");
    RawMcap::message(records, 1, 1, "one");
    mcap::ChannelRecord again = channelOfSchema(0);
    if (other) again.topic = "/b";
    again.metadata = {{"by", "another node"}};  // which does not change how messages are read
    mcap::write(records, again);
    RawMcap::message(records, 1, 2, "two");
    RawMcap raw;
    raw.chunk(1, 2, records.size(), 0, "", records.bytes());
    raw.end();
    const Opened opened = raw.open();
    QCOMPARE(rowsOf(**opened).size(), std::size_t(2));
    QCOMPARE(has(**opened, NoteCode::ChannelChanged), other);
  }
}

void TestMcapDamage::whatFollowsTheEndIsNoted() {
  const Made made = makeRecording(3, 6, 0, 9);
  for (const std::string& more : {*made.bytes, std::string("garbage")}) {
    const Opened opened = openRecording(heldBytes(std::make_shared<std::string>(*made.bytes + more)));
    QVERIFY(opened);
    QCOMPARE(rowsOf(**opened) == made.byTime(), true);
    const std::vector<Note> notes = (*opened)->summary().notes;
    const auto skipped = std::find_if(notes.begin(), notes.end(),
                                      [](const Note& note) { return note.code == NoteCode::BytesSkipped; });
    QVERIFY(skipped != notes.end());
    QCOMPARE(skipped->offset, std::uint64_t(made.bytes->size()));
    QCOMPARE(skipped->count, std::uint64_t(more.size()));
  }
}

void TestMcapDamage::messagesThatAreCountedButMissingAreNoted() {
  for (const std::uint64_t counted : {2, 5}) {
    for (const bool by_channel : {true, false}) {
      mcap::RecordWriter records, summary;
      RawMcap::channel(records, 1, "/a");
      RawMcap::message(records, 1, 1, "one");
      RawMcap::message(records, 1, 2, "two");
      RawMcap raw;
      const std::uint64_t at = raw.out.bytes().size();
      raw.chunk(1, 2, records.size(), 0, "", records.bytes());
      RawMcap::channel(summary, 1, "/a");
      mcap::Statistics statistics;
      statistics.messages = counted;
      if (by_channel) statistics.messages_of = {{1, 2}, {9, counted - 2}};
      endWith(raw, at, summary, statistics);
      const Opened opened = raw.open();
      QVERIFY(opened);
      const std::vector<Note> notes = (*opened)->summary().notes;
      QCOMPARE(notes.size(), std::size_t(counted == 2 ? 0 : 1));
      QCOMPARE((*opened)->summary().messages, std::uint64_t(2));
      if (notes.empty()) continue;
      QCOMPARE(notes[0].code, NoteCode::MessagesMissing);
      QCOMPARE(notes[0].count, counted - 2);
    }
  }
}

void TestMcapDamage::garbageNeverDoesHarm() {
  const int rounds =
      qEnvironmentVariableIsSet("MAPWRIGHT_FUZZ") ? qEnvironmentVariableIntValue("MAPWRIGHT_FUZZ") : 400;
  WriterOptions plain;
  plain.compression = WriterOptions::Compression::None;
  const std::vector<Made> files{makeRecording(5, 10, 9000, 30, plain), makeRecording(5, 10, 9000, 31)};
  Limits limits;
  limits.most_chunk_bytes = std::size_t(1) << 20;
  std::mt19937 random(77);
  for (int round = 0; round < rounds; ++round) {
    auto bytes = std::make_shared<std::string>(*files[random() % files.size()].bytes);
    const std::size_t wounds = 1 + random() % 8;
    for (std::size_t i = 0; i < wounds; ++i) {
      const std::size_t at = 8 + random() % (bytes->size() - 8);
      const std::size_t length = std::min<std::size_t>(random() % 40, bytes->size() - at);
      switch (random() % 5) {
        case 0:
          (*bytes)[at] = char(random());
          break;
        case 1:
          bytes->erase(at, length);
          break;
        case 2:
          bytes->insert(at, bytes->substr(8 + random() % (bytes->size() - 8), length));
          break;
        case 3:
          std::fill_n(bytes->begin() + std::ptrdiff_t(at), length, random() % 2 == 0 ? '\0' : '\xff');
          break;
        default:
          bytes->resize(std::max<std::size_t>(at, 20));
      }
      if (bytes->size() < 20) break;
    }
    const Opened opened = openRecording(heldBytes(bytes), limits);
    QVERIFY(opened);
    readEverything(**opened);
  }
}

}  // namespace test_mcap_damage

MAPWRIGHT_TEST(test_mcap_damage, TestMcapDamage, Core)
#include "test_mcap_damage.moc"
