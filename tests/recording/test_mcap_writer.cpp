#include <csignal>
#include <sys/resource.h>

#include <QTemporaryDir>
#include <QtTest>

#include "recordings.h"
#include "test_program.h"

namespace test_mcap_writer {

using namespace recordings;

class TestMcapWriter : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aCrashLosesAtMostTheOpenChunk();
  void chunksAreClosedBySizeAndByTime();
  void aFullDiskIsToldAndLeavesTheFileSound();
  void aFullDiskOfTheSystemLeavesNoHalfRecord();
  void recordingGoesOnWhenThereIsRoomAgain();
  void anEndThatDidNotFitMayBeWrittenLater();
  void whatCannotBeWrittenIsRefused();
  void anotherRecordingIsNotWrittenOver();
  void bytesThatCannotBePackedAreStoredAsTheyAre();
};

namespace {

std::vector<Row> readBack(const std::shared_ptr<std::string>& bytes) {
  const Opened opened = openRecording(heldBytes(std::make_shared<std::string>(*bytes)));
  return opened ? rowsOf(**opened) : std::vector<Row>();
}

std::string noise(std::size_t size, unsigned seed) {
  std::mt19937 random(seed);
  std::string bytes(size, '\0');
  for (char& byte : bytes) byte = char(random());
  return bytes;
}

}  // namespace

void TestMcapWriter::aCrashLosesAtMostTheOpenChunk() {
  const auto bytes = std::make_shared<std::string>();
  WriterOptions options;
  options.chunk_bytes = 4000;
  auto writer = writerInto(bytes, options);
  const ChannelId id = *writer->addChannel(channelOf("/a"));
  for (std::int64_t i = 0; i < 500; ++i) {
    QVERIFY(!writer->write(id, {i, i, 0}, bytesOf(std::string(100, 'x'))));
    const std::vector<Row> rows = readBack(bytes);
    QVERIFY(rows.size() + 4000 / 131 + 2 > std::size_t(i));
  }
}

void TestMcapWriter::chunksAreClosedBySizeAndByTime() {
  const auto bytes = std::make_shared<std::string>();
  WriterOptions options;
  options.chunk_ns = 1000;
  auto writer = writerInto(bytes, options);
  const ChannelId id = *writer->addChannel(channelOf("/a"));
  writer->write(id, {5000, 5000, 1}, bytesOf("x"));
  writer->tick(5999);
  QCOMPARE(writer->progress().chunks, std::uint64_t(0));
  writer->tick(6000);
  QCOMPARE(writer->progress().chunks, std::uint64_t(1));
  writer->tick(9000);
  QCOMPARE(writer->progress().chunks, std::uint64_t(1));
  writer->write(id, {7000, 7000, 1}, bytesOf("x"));
  writer->write(id, {8000, 8000, 1}, bytesOf("x"));
  QCOMPARE(writer->progress().chunks, std::uint64_t(2));
  writer->write(id, {8001, 8001, 1}, bytesOf(std::string(std::size_t(2) << 20, 'x')));
  QCOMPARE(writer->progress().chunks, std::uint64_t(3));
  QCOMPARE(readBack(bytes).size(), std::size_t(4));
}

void TestMcapWriter::aFullDiskIsToldAndLeavesTheFileSound() {
  const auto bytes = std::make_shared<std::string>();
  const auto room = std::make_shared<std::uint64_t>(20'000);
  WriterOptions options;
  options.chunk_bytes = 3000;
  options.compression = WriterOptions::Compression::None;
  auto writer = writerInto(bytes, options, room);
  const ChannelId id = *writer->addChannel(channelOf("/a"));
  int faults = 0;
  for (std::int64_t i = 0; i < 1000; ++i) {
    const auto fault = writer->write(id, {i, i, 0}, bytesOf(std::string(100, 'x')));
    if (fault) {
      ++faults;
      QVERIFY(fault->cause.any());
    }
  }
  QVERIFY(faults > 700);
  const McapWriter::Progress progress = writer->progress();
  QCOMPARE(progress.messages + progress.lost, std::uint64_t(1000));
  QVERIFY(progress.lost > 700);
  QVERIFY(bytes->size() <= 20'000);
  const std::vector<Row> rows = readBack(bytes);
  QVERIFY(rows.size() > 100);
  QVERIFY(writer->close());
  QVERIFY(writer->close());  // and is told again
  writer.reset();
  QCOMPARE(readBack(bytes) == rows, true);
}

void TestMcapWriter::aFullDiskOfTheSystemLeavesNoHalfRecord() {
  std::signal(SIGXFSZ, SIG_IGN);
  QTemporaryDir folder;
  const std::string path = folder.filePath(QStringLiteral("full.mcap")).toStdString();
  auto file = appendFile(path, Existing::Refuse);
  QVERIFY(file);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit small = before;
  small.rlim_cur = 10'000;
  setrlimit(RLIMIT_FSIZE, &small);
  WriterOptions options;
  options.chunk_bytes = 3000;
  auto writer = McapWriter::create(std::move(*file), options);
  const ChannelId id = *(*writer)->addChannel(channelOf("/a"));
  bool told = false;
  for (unsigned i = 0; i < 50; ++i)
    told = (*writer)->write(id, {i, i, 0}, bytesOf(noise(500, i))).has_value() || told;
  const qint64 full = QFileInfo(QString::fromStdString(path)).size();
  setrlimit(RLIMIT_FSIZE, &before);
  QVERIFY(told);
  QCOMPARE(std::uint64_t(full), (*writer)->progress().bytes);
  const Opened opened = openRecording(path);
  QVERIFY(opened);
  QVERIFY(!has(**opened, NoteCode::CutOff));
  QVERIFY(rowsOf(**opened).size() >= 5);
  QVERIFY(!(*writer)->close());
  const Opened closed = openRecording(path);
  QVERIFY((*closed)->summary().finished);
  QCOMPARE(rowsOf(**closed).size(), std::size_t((*writer)->progress().messages));
}

void TestMcapWriter::recordingGoesOnWhenThereIsRoomAgain() {
  const auto bytes = std::make_shared<std::string>();
  const auto room = std::make_shared<std::uint64_t>(5'000);
  WriterOptions options;
  options.chunk_bytes = 2000;
  options.compression = WriterOptions::Compression::None;
  auto writer = writerInto(bytes, options, room);
  const ChannelId id = *writer->addChannel(channelOf("/a"));
  std::vector<Row> taken;
  constexpr std::int64_t kSecond = 1'000'000'000;
  for (std::uint32_t i = 0; i < 300; ++i) {
    if (i == 200) *room = 1'000'000;
    const std::uint64_t lost = writer->progress().lost;
    const Row row{"/a", std::int64_t(i) * kSecond / 10, i, std::string(100, 'x')};
    writer->write(id, {row.log_ns, row.log_ns, i}, bytesOf(row.bytes));
    if (writer->progress().lost == lost) taken.push_back(row);
  }
  QVERIFY(writer->progress().lost > 50);
  QVERIFY(taken.back().sequence == 299);
  QVERIFY(!writer->close());
  QCOMPARE(readBack(bytes) == taken, true);
}

void TestMcapWriter::anEndThatDidNotFitMayBeWrittenLater() {
  const auto bytes = std::make_shared<std::string>();
  const auto room = std::make_shared<std::uint64_t>(1'000'000);
  auto writer = writerInto(bytes, {}, room);
  const ChannelId id = *writer->addChannel(channelOf("/a"));
  writer->write(id, {1, 1, 1}, bytesOf("x"));
  writer->flush();
  *room = bytes->size();
  QVERIFY(writer->close());
  *room = 1'000'000;
  QVERIFY(!writer->close());
  const Opened opened = openRecording(heldBytes(bytes));
  QVERIFY((*opened)->summary().indexed && (*opened)->summary().notes.empty());
}

void TestMcapWriter::whatCannotBeWrittenIsRefused() {
  const auto bytes = std::make_shared<std::string>();
  auto writer = writerInto(bytes);
  QVERIFY(writer->write(1, {1, 1, 1}, bytesOf("x")));
  QVERIFY(writer->write(0, {1, 1, 1}, bytesOf("x")));
  const ChannelId id = *writer->addChannel(channelOf("/a"));
  QVERIFY(!writer->write(id, {-7, -7, 1}, bytesOf("before the epoch")));
  QVERIFY(!writer->close());
  QVERIFY(writer->write(id, {1, 1, 1}, bytesOf("too late")));
  QVERIFY(writer->attach({}) && writer->addMetadata({}));
  QCOMPARE(readBack(bytes).at(0).log_ns, std::int64_t(0));
  QCOMPARE(writer->progress().lost, std::uint64_t(3));
}

void TestMcapWriter::anotherRecordingIsNotWrittenOver() {
  QTemporaryDir folder;
  const std::string path = folder.filePath(QStringLiteral("a.mcap")).toStdString();
  QVERIFY(appendFile(path, Existing::Refuse));
  QVERIFY(!appendFile(path, Existing::Refuse));
  QVERIFY(appendFile(path, Existing::Replace));
  const auto device = appendFile("/dev/full", Existing::Replace);
  QVERIFY(!device && device.error().cause.code == mapwright::disk::fault::NotARegularFile);
}

void TestMcapWriter::bytesThatCannotBePackedAreStoredAsTheyAre() {
  const auto bytes = std::make_shared<std::string>();
  auto writer = writerInto(bytes);
  const ChannelId id = *writer->addChannel(channelOf("/a"));
  const std::string message = noise(100'000, 5);
  writer->write(id, {1, 1, 1}, bytesOf(message));
  writer->close();
  QVERIFY(bytes->find(message) != std::string::npos);
  QCOMPARE(readBack(bytes)[0].bytes == message, true);
}

}  // namespace test_mcap_writer

MAPWRIGHT_TEST(test_mcap_writer, TestMcapWriter, Core)
#include "test_mcap_writer.moc"
