// The bags of an Autoxing robot: as answers, and asked of the simulator.
#include <cmath>

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "../net/scripted_server.h"
#include "replay/reading.h"
#include "robot/axbot/axbot_robot.h"
#include "robot/axbot/faults.h"
#include "robot/axbot/parse_bags.h"
#include "robot/map_administration.h"
#include "scripted_robot.h"
#include "sentences/failure_sentence.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_axbot_bags {

using namespace mapwright;
using namespace mapwright::robot;

namespace {

constexpr int kLongMs = 60'000;

struct Bench {
  explicit Bench(simulator::BagOptions bags = {true, false, true}) : sim(options(bags)) {
    if (sim.start()) qFatal("no simulator");
    axbot::LinkOptions link;
    link.base = QUrl(QStringLiteral("http://127.0.0.1:%1").arg(sim.port()));
    link.cache_folder = folder.path();
    link.recording_patience = std::chrono::milliseconds(500);
    robot = std::make_unique<axbot::AxbotRobot>(QStringLiteral("axbot"), link);
  }
  static simulator::Options options(simulator::BagOptions bags) {
    simulator::Options options;
    options.paused = true;
    options.start_at_s = 700;
    options.bags = bags;
    return options;
  }
  BagLibrary& bags() { return *robot->bagLibrary(); }

  template <typename T>
  Outcome<T> ask(const std::function<Call(OutcomeTo<T>)>& question) {
    std::optional<Outcome<T>> outcome;
    question([&](Outcome<T> given) { outcome = std::move(given); });
    if (!QTest::qWaitFor([&] { return outcome.has_value(); }, kLongMs)) qFatal("no outcome");
    return std::move(*outcome);
  }
  Outcome<BagChunkPtr> chunk(const BagKey& key, double from_s, double until_s) {
    return ask<BagChunkPtr>([&](OutcomeTo<BagChunkPtr> reply) {
      return bags().messages(key, {from_s, until_s}, std::move(reply));
    });
  }
  Outcome<BagDownload> download(const BagKey& key, const QString& path) {
    return ask<BagDownload>(
        [&](OutcomeTo<BagDownload> reply) { return bags().download(key, path, std::move(reply)); });
  }

  QTemporaryDir folder;
  simulator::Simulator sim;
  std::unique_ptr<axbot::AxbotRobot> robot;
};

BagKey bag(const char* name) { return {BagKind::Bag, name}; }

std::string words(const map::Failure& failure) { return sentences::sentenceOf(failure); }

/// Everything that the robot has of it, folded message by message.
map::World folded(const BagChunk& all, double at_s) {
  std::vector<const BagMessage*> messages;
  for (const BagMessage& message : all.messages) {
    if (message.known && message.message.received_s <= at_s) messages.push_back(&message);
  }
  std::stable_sort(messages.begin(), messages.end(), [](const BagMessage* a, const BagMessage* b) {
    return a->message.received_s < b->message.received_s;
  });
  map::World world;
  for (const BagMessage* message : messages) world = map::reduce(std::move(world), message->message);
  return world;
}

}  // namespace

class AxbotBagsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  // The shapes of docs/protocols/autoxing.md, "Bags".

  void aRowOfTheListIsRead() {
    const auto rows =
        axbot::parseBagRows(R"([{"filename":"2023-10-31_14-30-00.bag","size":"6.8KB","size_bytes":6922,)"
                            R"("end":"31-Oct-2023 14:36:17","download_url":"http://x/"},{"size":"1KB"}])",
                            BagKind::Bag);
    QVERIFY(rows);
    QCOMPARE(rows->size(), std::size_t(1));
    QCOMPARE(rows->front().key.name, std::string("2023-10-31_14-30-00.bag"));
    QCOMPARE(*rows->front().size_bytes, std::int64_t(6922));
    QCOMPARE(*rows->front().end_s, 1698762977.0);
  }

  void aRangeIsReadMessageByMessage() {
    const std::string json = R"({"total_messages":5,"start_time":10,"end_time":20,"messages":[
      {"topic":"/tracked_pose","pos":[1,2],"ori":0.5,"__stamp":10.123,"__latched":false},
      {"topic":"/no_such_state","state":"up","__stamp":11,"__latched":true},
      {"topic":"/tracked_pose","pos":[NaN,2],"ori":0.5,"__stamp":12},
      {"topic":"/battery_state","percentage":0.5},
      {"topic":"/battery_state","percentage":0.5,"__stamp":NaN},
      7,
      {"topic":"/battery_state","percentage":0.25,"__stamp":"13.5"}]})";
    const auto chunk = axbot::parseBagChunk(json, {10, 20});
    QVERIFY(chunk);
    QCOMPARE(chunk->messages.size(), std::size_t(4));
    QCOMPARE(chunk->without_stamp, std::size_t(2));
    QCOMPARE(chunk->unreadable, std::size_t(1));
    QCOMPARE(chunk->messages[0].message.received_s, 10.123);
    QVERIFY(chunk->messages[0].known && !chunk->messages[0].latched);
    QCOMPARE(chunk->messages[1].message.topic, std::string("/no_such_state"));
    QVERIFY(!chunk->messages[1].known && chunk->messages[1].latched);
    QCOMPARE(std::string(chunk->textOf(chunk->messages[1])),
             std::string(R"({"topic":"/no_such_state","state":"up","__stamp":11,"__latched":true})"));
    QCOMPARE(chunk->messages[3].message.received_s, 13.5);
  }

  // Poses and lists of points are read on the way through the text, unless they are written oddly. Where the
  // stamp stands first they are read like all others.
  void whatIsReadOnTheWayIsWhatIsReadOtherwise_data() {
    QTest::addColumn<QByteArray>("topic");
    QTest::addColumn<QByteArray>("members");
    const auto pose = [](const char* name, const char* members) {
      QTest::newRow(name) << QByteArray("/tracked_pose") << QByteArray(members);
    };
    pose("pose", "\"pos\":[1.25,-2.5],\"ori\":0.5");
    pose("no heading", "\"pos\":[1.25,-2.5]");
    pose("no position", "\"ori\":0.5");
    pose("many digits", "\"pos\":[1.23456789012345678,-0.1234567890123456],\"ori\":-3.1415926535897931");
    pose("fourteen digits", "\"pos\":[123456.78901234,99999999999999],\"ori\":0.3");
    pose("more than any type holds", "\"pos\":[123456789012345678901234567890,1],\"ori\":0");
    pose("exponents", "\"pos\":[1e2,-2.5E-3],\"ori\":1e-7");
    pose("beyond doubles", "\"pos\":[1e999,2],\"ori\":0");
    pose("no numbers", "\"pos\":[NaN,2],\"ori\":0");
    pose("heading that is none", "\"pos\":[1,2],\"ori\":NaN");
    pose("heading null", "\"pos\":[1,2],\"ori\":null");
    pose("numbers in strings", "\"pos\":[\"1\",\"2\"],\"ori\":\"0.5\"");
    pose("zeros in front", "\"pos\":[01,2],\"ori\":0.5");
    pose("nothing behind the point", "\"pos\":[1.,2],\"ori\":0.5");
    pose("minus zero", "\"pos\":[-0.0,0],\"ori\":-0.5");
    pose("spaces", " \"pos\" : [ 1 , 2.5 ] , \"ori\" : 0.5 ");
    pose("three numbers", "\"pos\":[1,2,3],\"ori\":0.5");
    pose("one number", "\"pos\":[1],\"ori\":0.5");
    pose("no list", "\"pos\":{\"x\":1,\"y\":2},\"ori\":0.5");
    pose("other names", "\"x\":1,\"y\":2,\"yaw\":0.5");
    pose("more members", "\"cov\":[[1,2],[3,{\"a\":\"]\"}]],\"pos\":[1,2],\"ori\":0.5,\"z\":null");
    pose("twice", "\"pos\":[1,2],\"ori\":0.5,\"pos\":[3,4]");
    pose("escapes in a key", "\"p\\u006fs\":[1,2],\"pos\":[3,4],\"ori\":0.5");
    pose("seconds", "\"stamp\":1700000000.25,\"pos\":[1,2],\"ori\":0.5");
    pose("milliseconds", "\"stamp\":1700000000250,\"pos\":[1,2],\"ori\":0.5");
    pose("a date", "\"stamp\":\"2024-06-03T09:00:00\",\"pos\":[1,2],\"ori\":0.5");
    pose("no colon", "\"pos\" [1,2],\"ori\":0.5");
    pose("no comma", "\"pos\":[1 2],\"ori\":0.5");
    pose("a word", "\"pos\":[1,two],\"ori\":0.5");
    const auto cloud = [](const char* name, const char* members) {
      QTest::newRow(name) << QByteArray("/scan_matched_points2") << QByteArray(members);
    };
    cloud("points", "\"points\":[[1,2,0.5],[3.125,-4.5],[5,6,7,8,9]]");
    cloud("no points", "\"points\":[]");
    cloud("points far away", "\"points\":[[1e9,2],[3,4]]");
    cloud("empty points", "\"points\":[[],[1],[3,4]]");
    cloud("points that are none", "\"points\":[[1,null],[2,NaN],[\"3\",4],[5,6]]");
    cloud("objects", "\"points\":[{\"x\":1,\"y\":2},[3,4]]");
    cloud("bright points", "\"points\":[[1,2,0,0.5],[3,4,0,1]]");
    cloud("no list of points", "\"points\":7");
    cloud("fields", "\"fields\":[{\"name\":\"x\"}],\"data\":\"\"");
    cloud("points without a comma", "\"points\":[[1,2][3,4]]");
    QTest::newRow("another topic") << QByteArray("/battery_state") << QByteArray("\"percentage\":0.5");
    QTest::newRow("escapes in the topic")
        << QByteArray("\\/tracked_pose") << QByteArray("\"pos\":[1,2],\"ori\":0.5");
  }
  void whatIsReadOnTheWayIsWhatIsReadOtherwise() {
    QFETCH(QByteArray, topic);
    QFETCH(QByteArray, members);
    const std::string after =
        ",\"__latched\":true},\n{\"topic\":\"/tracked_pose\",\"pos\":[7,8],\"ori\":1,\"__stamp\":11}]}";
    const std::string about = "\"topic\":\"" + topic.toStdString() + "\"," + members.toStdString();
    const std::string stamp = "\"__stamp\":10.123";
    const auto usual = axbot::parseBagChunk("{\"messages\":[{" + about + "," + stamp + after, {0, 20});
    const auto odd = axbot::parseBagChunk("{\"messages\":[{" + stamp + "," + about + after, {0, 20});
    QVERIFY(usual && odd);
    QCOMPARE(usual->messages.size(), odd->messages.size());
    QCOMPARE(usual->unreadable, odd->unreadable);
    QCOMPARE(usual->without_stamp, odd->without_stamp);
    for (std::size_t i = 0; i < odd->messages.size(); ++i) {
      const BagMessage &a = usual->messages[i], &b = odd->messages[i];
      QVERIFY(a.message == b.message);
      QCOMPARE(a.known, b.known);
      QCOMPARE(a.latched, b.latched);
      QCOMPARE(usual->textOf(a).size(), odd->textOf(b).size());
      QCOMPARE(usual->textOf(a).back(), '}');
    }
    QCOMPARE(usual->messages.back().message.received_s, 11.0);
  }

  // What a topic says once more is taken from what it said before, unless anything but the time is different.
  // Behind a member that is no plain value, a range is read in another way.
  void whatIsSaidAgainIsWhatIsReadOtherwise_data() {
    QTest::addColumn<QByteArray>("messages");
    const auto row = [](const char* name, std::initializer_list<const char*> messages) {
      QByteArrayList list;
      for (const char* message : messages) list += message;
      QTest::newRow(name) << list.join(",");
    };
    row("the same", {R"({"topic":"/battery_state","percentage":0.5,"__stamp":1,"__latched":true})",
                     R"({"topic":"/battery_state","percentage":0.5,"__stamp":2.25,"__latched":true})",
                     R"({"topic":"/battery_state","percentage":0.5,"__stamp":3,"__latched":true})"});
    row("another value", {R"({"topic":"/battery_state","percentage":0.5,"__stamp":1,"__latched":true})",
                          R"({"topic":"/battery_state","percentage":0.6,"__stamp":2,"__latched":true})",
                          R"({"topic":"/battery_state","percentage":0.5,"__stamp":3,"__latched":true})"});
    row("latched or not", {R"({"topic":"/battery_state","percentage":0.5,"__stamp":1,"__latched":true})",
                           R"({"topic":"/battery_state","percentage":0.5,"__stamp":2,"__latched":false})",
                           R"({"topic":"/battery_state","percentage":0.5,"__stamp":3})"});
    row("more behind", {R"({"topic":"/battery_state","percentage":0.5,"__stamp":1})",
                        R"({"topic":"/battery_state","percentage":0.5,"__stamp":2,"voltage":24})",
                        R"({"topic":"/battery_state","percentage":0.5,"__stamp":3,"voltage":25})"});
    row("a robot's own time", {R"({"topic":"/alerts","stamp":5,"alerts":[],"__stamp":1})",
                               R"({"topic":"/alerts","stamp":6,"alerts":[],"__stamp":2})",
                               R"({"topic":"/alerts","stamp":6,"alerts":[],"__stamp":3})"});
    row("a stamp within", {R"({"topic":"/x","__stamp":1,"in":{"y":1,"__stamp":7}})",
                           R"({"topic":"/x","__stamp":1,"in":{"y":1,"__stamp":8}})",
                           R"({"topic":"/x","in":{"y":1,"__stamp":7},"__stamp":2})",
                           R"({"topic":"/x","in":{"y":1,"__stamp":7},"__stamp":3})"});
    row("a stamp in a text", {"{\"topic\":\"/x\",\"a\":\"\\\"__stamp\\\":7}\",\"__stamp\":1}",
                              "{\"topic\":\"/x\",\"a\":\"\\\"__stamp\\\":8}\",\"__stamp\":2}"});
    row("stamps as texts", {R"({"topic":"/battery_state","percentage":0.5,"__stamp":"1"})",
                            R"({"topic":"/battery_state","percentage":0.5,"__stamp":"2"})"});
    row("two stamps", {R"({"topic":"/battery_state","percentage":0.5,"__stamp":1,"__stamp":9})",
                       R"({"topic":"/battery_state","percentage":0.5,"__stamp":1,"__stamp":8})"});
    row("two stamps, oddly",
        {R"({"topic":"/x","__stamp" :1,"__stamp":1})", R"({"topic":"/x","__stamp" :1,"__stamp":8})"});
    row("no number", {R"({"topic":"/battery_state","percentage":0.5,"__stamp":1})",
                      R"({"topic":"/battery_state","percentage":0.5,"__stamp":NaN})",
                      R"({"topic":"/battery_state","percentage":0.5,"__stamp":null})",
                      R"({"topic":"/battery_state","percentage":0.5,"__stamp":1e999})",
                      R"({"topic":"/battery_state","percentage":0.5,"__stamp":4})"});
    row("brackets and quotes in texts",
        {"{\"topic\":\"/y\",\"a\":\"]}\\\\\",\"b\":\"\\\"{[\",\"__stamp\":1}",
         "{\"topic\":\"/y\",\"a\":\"]}\\\\\",\"b\":\"\\\"{[\",\"__stamp\":2}"});
    row("an unreadable map",
        {R"({"topic":"/map","size":"none","__stamp":1})", R"({"topic":"/map","size":"none","__stamp":2})"});
    row("a map that lies elsewhere",
        {R"({"topic":"/map","data_url":"x/1.png","resolution":0.05,"origin":[0,0],"size":[4,4],"__stamp":1})",
         R"({"topic":"/map","data_url":"x/1.png","resolution":0.05,"origin":[0,0],"size":[4,4],"__stamp":2})"});
    row("other things", {"7", "\"text\"", "[1,[2]]", "null", R"({"topic":"/x","__stamp":1})", "{}"});
  }
  void whatIsSaidAgainIsWhatIsReadOtherwise() {
    QFETCH(QByteArray, messages);
    const std::string list = "\"messages\":[" + messages.toStdString() + "]}";
    const auto usual = axbot::parseBagChunk("{" + list, {0, 20});
    const auto odd = axbot::parseBagChunk("{\"odd\":{}," + list, {0, 20});
    QVERIFY(usual && odd);
    QCOMPARE(usual->messages.size(), odd->messages.size());
    QCOMPARE(usual->unreadable, odd->unreadable);
    QCOMPARE(usual->without_stamp, odd->without_stamp);
    for (std::size_t i = 0; i < odd->messages.size(); ++i) {
      const BagMessage &a = usual->messages[i], &b = odd->messages[i];
      QVERIFY(a.message == b.message);
      QCOMPARE(a.known, b.known);
      QCOMPARE(a.latched, b.latched);
      QCOMPARE(a.picture_url, b.picture_url);
      QCOMPARE(usual->textOf(a), odd->textOf(b));
    }
  }

  void aRangeThatIsCutOffAnywhereIsAnErrorOrTheWhole() {
    const std::string json =
        "{\"messages\":[{\"topic\":\"/a\",\"x\":\"}]\\\"\",\"__stamp\":1},{\"topic\":\"/b\",\"__stamp\":2}]}";
    for (std::size_t length = 0; length < json.size(); ++length)
      QVERIFY(!axbot::parseBagChunk(json.substr(0, length), {0, 9}));
    QCOMPARE(axbot::parseBagChunk(json, {0, 9})->messages.size(), std::size_t(2));
    QVERIFY(!axbot::parseBagChunk("<html>no</html>", {0, 9}));
    QVERIFY(!axbot::parseBagChunk(R"({"messages":7})", {0, 9}));
    QVERIFY(!axbot::parseBagChunk(R"({"total_messages":7})", {0, 9}));
  }

  void bytesThatAreNoTextSpoilTheirOwnMessageOnly() {
    const std::string json =
        "{\"messages\":[{\"topic\":\"/a\",\"t\":\"\xff\",\"__stamp\":1},"
        "{\"topic\":\"/battery_state\",\"percentage\":0.5,\"__stamp\":2}]}";
    const auto chunk = axbot::parseBagChunk(json, {0, 9});
    QVERIFY(chunk);
    QCOMPARE(chunk->messages.size(), std::size_t(2));
    QVERIFY(chunk->messages[1].known);
  }

  // Asked of the simulator.

  void bagsAndRecordingsAreListed() {
    Bench bench;
    const auto rows = bench.ask<std::vector<BagEntry>>(
        [&](OutcomeTo<std::vector<BagEntry>> reply) { return bench.bags().list(std::move(reply)); });
    QVERIFY(rows);
    const auto count = [&](BagKind kind) {
      return std::count_if(rows->begin(), rows->end(),
                           [&](const BagEntry& row) { return row.key.kind == kind; });
    };
    QVERIFY(count(BagKind::Bag) >= 10);
    QCOMPARE(int(count(BagKind::Recording)), 2);
    for (const BagEntry& row : *rows) QVERIFY(row.end_s && row.size_bytes);
  }

  void aBagThatCannotBePlayedSaysWhy() {
    Bench bench;
    const auto missing = bench.chunk(bag("nothing.bag"), 0, 10);
    QVERIFY(!missing);
    QCOMPARE(int(missing.error().kind), int(map::FailureKind::RejectedByRobot));
    QCOMPARE(missing.error().subject.id, std::string("nothing.bag"));
    QVERIFY2(words(missing.error()).find("not found") != std::string::npos, words(missing.error()).c_str());
    const auto bad = bench.chunk(bag("nothing.bag"), 10, 0);
    QCOMPARE(int(bad.error().kind), int(map::FailureKind::Unsupported));
  }

  void theWorldOfATimeIsThatOfEveryMessageBefore_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("end_exclusive");
    for (const char* name : {"clock_set_back.bag", "same_stamps.bag", "gap.bag", "ends_late.bag",
                             "one_message.bag", "empty.bag", "2024-06-03_09-00-00.bag"}) {
      for (const bool exclusive : {false, true})
        QTest::addRow("%s %s", name, exclusive ? "exclusive" : "inclusive")
            << QString::fromLatin1(name) << exclusive;
    }
  }
  void theWorldOfATimeIsThatOfEveryMessageBefore() {
    QFETCH(QString, name);
    QFETCH(bool, end_exclusive);
    Bench bench({true, end_exclusive, true});
    const BagKey key = bag(qPrintable(name));
    const auto all = bench.chunk(key, 0, 4e9);
    QVERIFY(all);
    replay::Reading::Options options;
    options.chunks.messages_per_cell = 400;
    replay::Reading reading(bench.bags(), key, options);
    QSignalSpy opened(&reading, &replay::Reading::opened);
    reading.open();
    QTRY_COMPARE_WITH_TIMEOUT(opened.size(), 1, kLongMs);
    const double start_s = reading.chunks().start_s(), end_s = reading.chunks().end_s();
    for (const double share : {0.9, 0.1, 0.5, 1.2, 0.501, 0.0}) {
      const double at_s = start_s + share * (end_s - start_s) + 0.25;
      reading.want(at_s);
      QVERIFY(QTest::qWaitFor([&] { return reading.chunks().readUntil(at_s); }, kLongMs));
      QVERIFY(
          QTest::qWaitFor([&] { return reading.moment().knowledge == replay::Knowledge::Exact; }, kLongMs));
      QVERIFY(reading.moment().at.world == folded(**all, at_s));
    }
    reading.setWhole(true);
    QVERIFY(QTest::qWaitFor([&] { return reading.chunks().wholeRead(); }, kLongMs));
    QCOMPARE(std::int64_t(reading.chunks().messagesRead()), reading.info()->messages);
    QCOMPARE((*all)->messages.size(), std::size_t(*reading.info()->messages));
  }

  void whatWasReadOnceLiesOnTheDisk() {
    Bench bench;
    const auto first = bench.chunk(bag("gap.bag"), 1717403400, 1717403410);
    const auto again = bench.chunk(bag("gap.bag"), 1717403400, 1717403410);
    QVERIFY(first && again);
    QVERIFY(!(*first)->from_cache);
    QVERIFY((*again)->from_cache);
    QCOMPARE(*(*again)->text, *(*first)->text);
  }

  void aDownloadGoesOnWhereItBrokeOff_data() {
    QTest::addColumn<bool>("ranges");
    QTest::newRow("the robot can") << true;
    QTest::newRow("the robot begins anew") << false;
  }
  void aDownloadGoesOnWhereItBrokeOff() {
    QFETCH(bool, ranges);
    Bench bench({true, false, ranges});
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.bag"));
    const auto whole = bench.download(bag("gap.bag"), path);
    QVERIFY(whole);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    QVERIFY(bytes.startsWith("#ROSBAG") && bytes.size() == whole->bytes && !whole->resumed);
    QFile part(folder.filePath(QStringLiteral("b.bag.part")));
    QVERIFY(part.open(QIODevice::WriteOnly));
    part.write(bytes.left(1000));
    part.close();
    const auto rows = bench.ask<std::vector<BagEntry>>(
        [&](OutcomeTo<std::vector<BagEntry>> reply) { return bench.bags().list(std::move(reply)); });
    QVERIFY(rows);
    const auto row = std::find_if(rows->begin(), rows->end(),
                                  [](const BagEntry& entry) { return entry.key == bag("gap.bag"); });
    QVERIFY(row != rows->end() && row->size_bytes == whole->bytes);
    QFile part_of(folder.filePath(QStringLiteral("b.bag.part.of")));
    QVERIFY(part_of.open(QIODevice::WriteOnly));
    part_of.write(QStringLiteral("\n%1\n%1 %2\n")
                      .arg(QString::number(whole->bytes), QString::fromStdString(row->end_text))
                      .toUtf8());
    part_of.close();
    const auto rest = bench.download(bag("gap.bag"), folder.filePath(QStringLiteral("b.bag")));
    QVERIFY(rest);
    QCOMPARE(rest->resumed, ranges);
    QFile other(folder.filePath(QStringLiteral("b.bag")));
    QVERIFY(other.open(QIODevice::ReadOnly));
    QCOMPARE(other.readAll(), bytes);
    QVERIFY(!part.exists());
  }

  void onlyTheRestOfTheSameFileIsGluedToAPart_data() {
    QTest::addColumn<QByteArray>("range");
    QTest::addColumn<QByteArray>("held");  // what is known of the part: its ETag and the length of the whole
    QTest::addColumn<bool>("resumed");
    const QByteArray right = "Content-Range: bytes 4-9/10\r\n", etag = "ETag: \"new\"\r\n";
    QTest::newRow("the rest") << QByteArray(right + etag) << QByteArray("\"new\"\n10\n") << true;
    QTest::newRow("the row of the list") << right << QByteArray("\n10\n10 now\n") << true;
    QTest::newRow("another of the same size") << right << QByteArray("\n10\n10 then\n") << false;
    QTest::newRow("nothing is known of the part") << right << QByteArray() << false;
    QTest::newRow("what is known is no text of ours") << right << QByteArray(5000, 'x') << false;
    QTest::newRow("another range") << QByteArray("Content-Range: bytes 2-7/10\r\n") << QByteArray() << false;
    QTest::newRow("no word of which") << QByteArray() << QByteArray() << false;
    QTest::newRow("a word that is none")
        << QByteArray("Content-Range: bytes x-/\r\n") << QByteArray() << false;
    QTest::newRow("of a longer file") << right << QByteArray("\n12\n") << false;
    QTest::newRow("of another file") << QByteArray(right + etag) << QByteArray("\"old\"\n10\n") << false;
    QTest::newRow("of one without an ETag")
        << QByteArray(right + etag) << QByteArray("\n10\n10 now\n") << false;
  }
  void onlyTheRestOfTheSameFileIsGluedToAPart() {
    QFETCH(QByteArray, range);
    QFETCH(QByteArray, held);
    QFETCH(bool, resumed);
    const QByteArray whole = "0123456789";
    net::testing::ScriptedServer server([&](const net::testing::SeenRequest& request) {
      using Server = net::testing::ScriptedServer;
      if (request.path == "/bags/")
        return Server::reply(200, {}, R"([{"filename":"a.bag","size_bytes":10,"end":"now"}])");
      if (request.path == "/recording/") return Server::reply(200, {}, "[]");
      if (!request.headers.contains("range")) return Server::reply(200, "ETag: \"new\"\r\n", whole);
      return Server::reply(206, range, resumed ? whole.mid(4) : whole.mid(2, 6));
    });
    QTemporaryDir folder;
    axbot::LinkOptions link;
    link.base = server.url(QString());
    link.cache_folder = folder.filePath(QStringLiteral("cache"));
    axbot::AxbotRobot robot(QStringLiteral("axbot"), link);
    const QString path = folder.filePath(QStringLiteral("a.bag"));
    const auto write = [](const QString& name, const QByteArray& bytes) {
      QFile file(name);
      QVERIFY(file.open(QIODevice::WriteOnly));
      file.write(bytes);
    };
    write(path + QStringLiteral(".part"), resumed ? whole.left(4) : QByteArray("????"));
    if (!held.isEmpty()) write(path + QStringLiteral(".part.of"), held);
    std::optional<Outcome<std::vector<BagEntry>>> rows;
    robot.bagLibrary()->list([&](Outcome<std::vector<BagEntry>> told) { rows = std::move(told); });
    QVERIFY(QTest::qWaitFor([&] { return rows.has_value(); }, kLongMs));
    QVERIFY(rows->has_value() && (*rows)->front().size_bytes == 10);
    std::optional<Outcome<BagDownload>> got;
    robot.bagLibrary()->download(bag("a.bag"), path,
                                 [&](Outcome<BagDownload> told) { got = std::move(told); });
    QVERIFY(QTest::qWaitFor([&] { return got.has_value(); }, kLongMs));
    QVERIFY2(got->has_value(), got->has_value() ? "" : words(got->error()).c_str());
    QCOMPARE((*got)->resumed, resumed);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), whole);
    QVERIFY(!QFile::exists(path + QStringLiteral(".part")));
    QVERIFY(!QFile::exists(path + QStringLiteral(".part.of")));
    const QByteArray asked = server.seen[2].headers.value("if-range");
    QCOMPARE(asked.isEmpty(), !held.startsWith('"'));
  }

  void aDownloadThatEndsEarlyIsNotTheWhole() {
    net::testing::ScriptedServer server([&](const net::testing::SeenRequest& request) {
      using Server = net::testing::ScriptedServer;
      if (request.path == "/bags/")
        return Server::reply(200, {}, R"([{"filename":"a.bag","size_bytes":10,"end":"now"}])");
      if (request.path == "/recording/") return Server::reply(200, {}, "[]");
      return QByteArray("HTTP/1.1 200 OK\r\nConnection: close\r\n\r\n0123");  // its length is not told
    });
    QTemporaryDir folder;
    axbot::LinkOptions link;
    link.base = server.url(QString());
    link.cache_folder = folder.filePath(QStringLiteral("cache"));
    axbot::AxbotRobot robot(QStringLiteral("axbot"), link);
    std::optional<Outcome<std::vector<BagEntry>>> rows;
    robot.bagLibrary()->list([&](Outcome<std::vector<BagEntry>> told) { rows = std::move(told); });
    QVERIFY(QTest::qWaitFor([&] { return rows.has_value(); }, kLongMs));
    const QString path = folder.filePath(QStringLiteral("a.bag"));
    std::optional<Outcome<BagDownload>> got;
    robot.bagLibrary()->download(bag("a.bag"), path,
                                 [&](Outcome<BagDownload> told) { got = std::move(told); });
    QVERIFY(QTest::qWaitFor([&] { return got.has_value(); }, kLongMs));
    QVERIFY(!got->has_value());
    QVERIFY2(words(got->error()).find("10") != std::string::npos, words(got->error()).c_str());
    QVERIFY(!QFile::exists(path));
  }

  void aDownloadReplacesNothingThatAppearedMeanwhile() {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.bag"));
    const auto bytesOf = [](const QString& name) {
      QFile file(name);
      return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    for (const bool there : {false, true}) {
      net::testing::ScriptedServer server([&](const net::testing::SeenRequest& request) {
        using Server = net::testing::ScriptedServer;
        if (request.path == "/bags/")
          return Server::reply(200, {}, R"([{"filename":"a.bag","size_bytes":10,"end":"now"}])");
        if (request.path == "/recording/") return Server::reply(200, {}, "[]");
        QFile other(path);
        (void)(other.open(QIODevice::WriteOnly) && other.write("another's"));
        return Server::reply(200, {}, "0123456789");
      });
      axbot::LinkOptions link;
      link.base = server.url(QString());
      link.cache_folder = folder.filePath(QStringLiteral("cache"));
      axbot::AxbotRobot robot(QStringLiteral("axbot"), link);
      std::optional<Outcome<std::vector<BagEntry>>> rows;
      robot.bagLibrary()->list([&](Outcome<std::vector<BagEntry>> told) { rows = std::move(told); });
      QVERIFY(QTest::qWaitFor([&] { return rows.has_value(); }, kLongMs));
      std::optional<Outcome<BagDownload>> got;
      robot.bagLibrary()->download(bag("a.bag"), path,
                                   [&](Outcome<BagDownload> told) { got = std::move(told); });
      QVERIFY(QTest::qWaitFor([&] { return got.has_value(); }, kLongMs));
      // Whoever downloads over a file was asked.
      QCOMPARE(got->has_value(), there);
      QCOMPARE(bytesOf(path), QByteArray(there ? "0123456789" : "another's"));
      if (there) continue;
      QVERIFY2(words(got->error()).find("a-1.bag") != std::string::npos, words(got->error()).c_str());
      QCOMPARE(bytesOf(folder.filePath(QStringLiteral("a-1.bag"))), QByteArray("0123456789"));
    }
  }

  void aDownloadThatCannotBeWrittenSaysSo() {
    Bench bench;
    const auto nowhere = bench.download(bag("gap.bag"), QStringLiteral("/proc/nothing/a.bag"));
    QVERIFY(!nowhere);
    QVERIFY(words(nowhere.error()).find("/proc/nothing/a.bag") != std::string::npos);
  }

  void recordingsAreMadeAndDeleted() {
    Bench bench;
    const auto made = bench.ask<BagEntry>([&](OutcomeTo<BagEntry> reply) {
      return bench.bags().record({"test", "90s", ""}, std::move(reply));
    });
    QVERIFY(made);
    QVERIFY(made->key.name.find("test") != std::string::npos);
    const auto info = bench.ask<BagInfo>(
        [&](OutcomeTo<BagInfo> reply) { return bench.bags().info(made->key, std::move(reply)); });
    QVERIFY(info && info->messages > 100);
    const auto remove = [&] {
      return bench.ask<BagKey>(
          [&](OutcomeTo<BagKey> reply) { return bench.bags().remove(made->key, std::move(reply)); });
    };
    simulator::Faults ignores;
    ignores.requests.push_back({simulator::FaultKind::Ignore, simulator::kWrites});
    bench.sim.setFaults(ignores);
    const auto ignored = remove();
    QVERIFY(!ignored && ignored.error().cause.code == axbot::fault::StillThere);
    bench.sim.setFaults({});
    QVERIFY(remove());
    const auto again = remove();
    QVERIFY(!again);
    QCOMPARE(int(again.error().asked_for), int(map::AskedFor::Change));
    const auto refused = bench.ask<BagEntry>([&](OutcomeTo<BagEntry> reply) {
      return bench.bags().record({"test", "a week", ""}, std::move(reply));
    });
    QCOMPARE(int(refused.error().kind), int(map::FailureKind::RejectedByRobot));
  }

  void whatIsListedAfterwardsCounts_data() {
    QTest::addColumn<simulator::FaultKind>("kind");
    QTest::addColumn<bool>("done");   // by the robot
    QTest::addColumn<bool>("known");  // what became of a deletion
    QTest::newRow("done") << simulator::FaultKind::Delay << true << true;
    QTest::newRow("an error of its own") << simulator::FaultKind::Refuse << false << false;
    QTest::newRow("nothing, no answer") << simulator::FaultKind::Drop << false << false;
    QTest::newRow("done, no answer") << simulator::FaultKind::Cut << true << true;
    QTest::newRow("nothing, and said that it did") << simulator::FaultKind::Ignore << false << true;
  }
  void whatIsListedAfterwardsCounts() {
    QFETCH(bool, done);
    QFETCH(bool, known);
    Bench bench;
    QFETCH(simulator::FaultKind, kind);
    simulator::Faults faults;
    faults.requests.push_back({kind, simulator::kWrites});
    const auto listed = [&] {
      const auto rows = bench.ask<std::vector<BagEntry>>(
          [&](OutcomeTo<std::vector<BagEntry>> reply) { return bench.bags().list(std::move(reply)); });
      std::set<BagKey> keys;
      for (const BagEntry& row : *rows) keys.insert(row.key);
      return keys;
    };
    const auto record = [&](const char* suffix) {
      return bench.ask<BagEntry>([&](OutcomeTo<BagEntry> reply) {
        return bench.bags().record({suffix, "90s", ""}, std::move(reply));
      });
    };
    const std::set<BagKey> before = listed();
    bench.sim.setFaults(faults);
    const auto made = record("new");
    QCOMPARE(made.has_value(), done);
    QCOMPARE(listed().size(), before.size() + std::size_t(done));
    if (made) QVERIFY(listed().contains(made->key) && !before.contains(made->key));
    if (!made) QCOMPARE(int(made.error().applied), int(map::Applied::Maybe));
    bench.sim.setFaults({});
    const auto other = record("other");
    QVERIFY(other);
    bench.sim.setFaults(faults);
    const auto gone = bench.ask<BagKey>(
        [&](OutcomeTo<BagKey> reply) { return bench.bags().remove(other->key, std::move(reply)); });
    QCOMPARE(gone.has_value(), done);
    QCOMPARE(!listed().contains(other->key), done);
    if (!gone) QCOMPARE(int(gone.error().applied), int(known ? map::Applied::No : map::Applied::Maybe));
  }

  void aRecordingMayBeListedLater() {
    testing::ScriptedRobot scripted;
    scripted.serve("/bags/", "[]");
    scripted.serve("/recording/", "[]");
    axbot::LinkOptions link;
    link.base = scripted.url();
    link.recording_patience = std::chrono::milliseconds(10'000);
    axbot::AxbotRobot robot(QStringLiteral("axbot"), link);
    std::optional<Outcome<BagEntry>> made;
    robot.bagLibrary()->record({}, [&](Outcome<BagEntry> entry) { made = std::move(entry); });
    // Before, the order itself, and afterwards.
    QTRY_VERIFY(scripted.timesAsked("/recording/") >= 3);
    QVERIFY(!made);
    scripted.serve("/recording/", R"([{"filename":"late.bag"}])");
    QTRY_VERIFY_WITH_TIMEOUT(made, kLongMs);
    QVERIFY(*made && (*made)->key.name == "late.bag");
  }

  void nothingIsDeletedThatNoListNames() {
    testing::ScriptedRobot scripted;
    scripted.serve("/bags/", R"([{"filename":"a.bag"}])");
    scripted.serve("/recording/", R"([{"filename":"r.bag"}])");
    scripted.serve("/maps/", R"([{"id":1,"uid":"u","map_name":"Hall"}])");
    scripted.serve("/mappings/", R"([{"id":7,"state":"finished"}])");
    // Some robots take words for ids.
    for (const char* path : {"/maps/all", "/maps/7", "/maps/01", "/bags/*", "/bags/%2A", "/bags/all"})
      scripted.serve(path, R"({"map_name":"Hall"})");
    axbot::LinkOptions link;
    link.base = scripted.url();
    axbot::AxbotRobot robot(QStringLiteral("axbot"), link);
    for (const char* name : {"*", "all", "A.bag", "a.bag ", "?", "r.bag"}) {
      std::optional<Outcome<BagKey>> gone;
      robot.bagLibrary()->remove(bag(name), [&](Outcome<BagKey> key) { gone = std::move(key); });
      QTRY_VERIFY_WITH_TIMEOUT(gone, kLongMs);
      QVERIFY2(!*gone && gone->error().applied == map::Applied::No, name);
    }
    for (const char* id : {"all", "7", "01", "current"}) {
      MapOrder order;
      order.change = MapChange::Delete;
      order.key = {map::MapKind::Stored, id};
      std::optional<Outcome<map::CatalogueEntry>> gone;
      robot.mapAdministration()->carryOut(
          order, [&](Outcome<map::CatalogueEntry> entry) { gone = std::move(entry); });
      QTRY_VERIFY_WITH_TIMEOUT(gone, kLongMs);
      QVERIFY2(!*gone && gone->error().applied == map::Applied::No, id);
    }
    for (const testing::Asked& one : std::as_const(scripted.asked))
      QVERIFY2(one.method != "DELETE", one.path.constData());
  }
};

}  // namespace test_axbot_bags

MAPWRIGHT_TEST(test_axbot_bags, AxbotBagsTest, Core)
#include "test_axbot_bags.moc"
