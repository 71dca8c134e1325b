// `mapwright bags …` on the simulated robot: what a script sees.
#include <cmath>

#include <QElapsedTimer>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMap>
#include <QRegularExpression>
#include <QSet>
#include <QStandardPaths>
#include <QTest>
#include <QtEndian>

#include "../net/scripted_server.h"
#include "program.h"
#include "recording/append_file.h"
#include "recording/mcap_writer.h"
#include "recording/source.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_bags_command {

using namespace mapwright;

namespace {

struct Outcome : tests::EndedBytes {
  QList<QJsonObject> lines() const {
    QList<QJsonObject> all;
    for (const QByteArray& line : out.split('\n')) {
      if (!line.isEmpty()) all << QJsonDocument::fromJson(line).object();
    }
    return all;
  }
};

double stampOf(const QJsonObject& message) { return message[QStringLiteral("__stamp")].toDouble(); }

}  // namespace

class BagsCommandTest : public QObject {
  Q_OBJECT
  std::unique_ptr<simulator::Simulator> robot_;
  tests::Program program_;

  /// `output`: where its standard output goes; empty = it is read.
  Outcome run(const QString& line, const QString& robot = {}, const QString& output = {}) const {
    return {program_.runForBytes(
        // A ~ stands for a blank within a word.
        QStringList{QStringLiteral("bags")} +
            line.split(QLatin1Char(' ')).replaceInStrings(QStringLiteral("~"), QStringLiteral(" ")),
        {.environment = {{QStringLiteral("MAPWRIGHT_ROBOT"),
                          robot.isEmpty() ? QString::fromStdString(robot_->address()) : robot}},
         .output = output})};
  }
  /// Ten poses a second for a minute, and an alert in the middle.
  QString recording() const {
    const QString path = program_.path(QStringLiteral("drive.mcap"));
    auto target = recording::appendFile(path.toStdString(), recording::Existing::Replace);
    recording::WriterOptions options;
    options.chunk_bytes = 4000;
    const auto writer = recording::McapWriter::create(std::move(*target), options);
    const auto say = [&](double after_s, const char* topic, const std::string& rest) {
      recording::Channel channel;
      channel.topic = topic;
      channel.message_encoding = "json";
      const std::string text = "{\"topic\":\"" + channel.topic + "\"," + rest + "}";
      const std::int64_t at_ns = 1'717'405'200'000'000'000 + std::llround(after_s * 1e9);
      (void)(*writer)->write(*(*writer)->addChannel(channel), {at_ns, at_ns, 0},
                             {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    };
    for (int i = 0; i < 600; ++i) {
      say(i * 0.1, "/tracked_pose", R"("pos":[)" + std::to_string(i * 0.05) + ",1],\"ori\":0");
      if (i == 300) say(i * 0.1, "/alerts", R"("alerts":[{"code":6001,"level":"error","msg":"Hot"}])");
    }
    (void)(*writer)->close();
    return path;
  }
  static QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  /// Where the records of an MCAP file end.
  static QList<qsizetype> recordEnds(const QByteArray& mcap) {
    QList<qsizetype> ends;
    for (qsizetype at = 8; at + 9 <= mcap.size();) {
      at += 9 + qsizetype(qFromLittleEndian<quint64>(mcap.constData() + at + 1));
      ends << at;
    }
    return ends;
  }
  /// Recorded by mapwright, which was killed; somebody has given it an index since. The link was away twice.
  QString withoutEndMark() const {
    const QString path = program_.path(QStringLiteral("killed.mcap"));
    const auto source = recording::openRecording(recording().toStdString());
    auto target = recording::appendFile(path.toStdString(), recording::Existing::Replace);
    const auto writer = recording::McapWriter::create(std::move(*target), {});
    const auto ns = [](double s) {
      return std::to_string(1'717'405'200'000'000'000 + std::llround(s * 1e9));
    };
    (void)(*writer)->addMetadata({"mapwright", {{"version", "1"}, {"kind", "axbot"}}});
    (void)(*writer)->addMetadata({"mapwright.link", {{"lost_ns", ns(20)}}});
    (void)(*writer)->addMetadata({"mapwright.link", {{"lost_ns", ns(20)}, {"back_ns", ns(25)}}});
    (void)(*writer)->addMetadata({"mapwright.link", {{"lost_ns", ns(50)}}});
    const auto cursor = (*source)->messages({});
    while (const auto message = cursor->next())
      (void)(*writer)->write(*(*writer)->addChannel(*message->channel), {message->log_time_ns, 0, 0},
                             message->bytes);
    (void)(*writer)->close();
    return path;
  }
  static QString bag() { return QStringLiteral("2024-06-03_09-00-00.bag"); }
  static QString at(double s) { return QString::number(1717405200 + s, 'f', 3); }

 private Q_SLOTS:
  void initTestCase() {
    simulator::Options options;
    options.paused = true;
    options.start_at_s = 700;
    options.bags.odd = true;
    robot_ = std::make_unique<simulator::Simulator>(options);
    QVERIFY(!robot_->start());
  }

  void aFileIsLookedIntoLikeABag() {
    const QString file = recording();
    const Outcome info = run(QStringLiteral("info --json ") + file);
    QVERIFY2(info.code == 0, info.err.constData());
    QCOMPARE(info.object()[QStringLiteral("messages")].toInt(), 601);
    const Outcome frames = run(QStringLiteral("frames --topic /alerts ") + file);
    QVERIFY2(frames.code == 0, frames.err.constData());
    QCOMPARE(frames.lines().size(), 1);
    const QString state = QStringLiteral("state --json --at %1 %2").arg(at(20), file);
    const Outcome there = run(state), again = run(state);
    QVERIFY2(there.code == 0, there.err.constData());
    QVERIFY(there.out == again.out && there.out.contains("10"));
    const Outcome events = run(QStringLiteral("events --json ") + file);
    QVERIFY2(events.code == 0 && events.out.contains("Hot"), events.err.constData());
    // One that is not there, and one that is none.
    const Outcome nowhere = run(QStringLiteral("info ./nowhere.mcap"));
    QVERIFY2(nowhere.code == 2 && nowhere.err.contains("nowhere.mcap"), nowhere.err.constData());
    QVERIFY(nowhere.err.count('\n') == 1);
  }

  void whatIsLostOfADamagedFileIsNotComplete_data() {
    QTest::addColumn<QString>("command");
    for (const char* command : {"frames", "info", "state --at %1", "export -o lost.jsonl --force",
                                "export -o lost.mcap --force", "track -o lost.csv --force",
                                "snapshot --at %1 --mode submaps --settle 0 --size 100x80 -o lost.png"})
      QTest::newRow(command) << QString::fromLatin1(command);
  }
  void whatIsLostOfADamagedFileIsNotComplete() {
    QFETCH(QString, command);
    const QString path = recording();
    QFile file(path);
    QVERIFY(file.resize(file.size() / 2));
    const QString wish = command.contains(QLatin1Char('%')) ? command.arg(at(5)) : command;
    const Outcome cut = run(wish + QStringLiteral(" --report lost.json ") + path);
    QVERIFY2(cut.code == 1, cut.err.constData());
    QVERIFY2(cut.err.contains("Its end is missing") && cut.err.count('\n') == 1, cut.err.constData());
    QFile report(program_.path(QStringLiteral("lost.json")));
    QVERIFY(report.open(QIODevice::ReadOnly));
    const QJsonObject told = QJsonDocument::fromJson(report.readAll()).object();
    QCOMPARE(told[QStringLiteral("complete")], QJsonValue(false));
    QVERIFY(!told.contains(QStringLiteral("waypoints")));
  }

  /// Topics may be lost with the rest.
  void topicsOfADamagedFileAreNotComplete() {
    const QString path = recording();
    const QStringList line{QStringLiteral("topics"), QStringLiteral("list"), QStringLiteral("--robot"), path};
    QCOMPARE(program_.runForBytes(line).code, 0);
    QFile file(path);
    QVERIFY(file.resize(file.size() / 2));
    const auto cut = program_.runForBytes(line);
    QVERIFY2(cut.code == 1 && cut.err.contains("Its end is missing"), cut.err.constData());
    QVERIFY(cut.out.contains("/tracked_pose"));
  }

  void aReportSaysAllThatIsLostAndOnlyThat() {
    const QString path = recording();
    const QString report = QStringLiteral("report -o lost.html --at %1 %2").arg(at(5), path);
    QFile file(path);
    QVERIFY(file.resize(file.size() - 8));  // of the index, without which everything is still there
    const Outcome whole = run(report);
    QVERIFY2(whole.code == 0 && whole.err.isEmpty(), whole.err.constData());
    QVERIFY(file.resize(file.size() / 2));
    const Outcome cut = run(report);
    QVERIFY2(cut.code == 1 && cut.err.contains("Its end is missing") && cut.err.contains("cut off at byte"),
             cut.err.constData());
  }

  void aRecordingWithoutItsEndIsToldAsInterrupted_data() {
    QTest::addColumn<QString>("command");
    QTest::addColumn<QString>("file");
    const QString whole = recording();
    const QByteArray bytes = contentOf(whole);
    const QList<qsizetype> ends = recordEnds(bytes);
    const auto cut = [&](const char* name, qsizetype at) {
      QFile file(program_.path(QLatin1String(name)));
      if (file.open(QIODevice::WriteOnly)) file.write(bytes.left(at));
      return file.fileName();
    };
    const qsizetype middle = ends[ends.size() / 3];
    const QMap<QString, QString> files{{QStringLiteral("at a record"), cut("at.mcap", middle)},
                                       {QStringLiteral("within a record"), cut("within.mcap", middle + 7)},
                                       {QStringLiteral("recorded here, with an index"), withoutEndMark()}};
    for (auto file = files.begin(); file != files.end(); ++file) {
      for (const char* command : {"frames", "info", "state --at %1", "events", "export -o cut.jsonl --force",
                                  "export -o cut.mcap --force", "track -o cut.csv --force"})
        QTest::addRow("%s: %s", qPrintable(file.key()), command) << QString::fromLatin1(command) << *file;
    }
  }
  void aRecordingWithoutItsEndIsToldAsInterrupted() {
    QFETCH(QString, command);
    QFETCH(QString, file);
    const QString words = command.contains(QLatin1String("%1")) ? command.arg(at(10)) : command;
    const Outcome told = run(words + QLatin1Char(' ') + file);
    QCOMPARE(told.code, 1);
    QVERIFY2(told.err.contains("interrupted after 2024-06-03 09:00:"), told.err.constData());
    QVERIFY(!told.out.isEmpty());
  }
  void aRecordingThatWasCutBeforeItsFirstMessagesHasNoTimes() {
    QFile whole(withoutEndMark()), cut(withoutEndMark() + QStringLiteral(".cut.mcap"));
    QVERIFY(whole.open(QIODevice::ReadOnly) && cut.open(QIODevice::WriteOnly));
    cut.write(whole.read(60));
    cut.close();
    const Outcome told = run(QStringLiteral("info ") + cut.fileName());
    QCOMPARE(told.code, 1);
    QVERIFY2(!told.out.contains("1970"), told.out.constData());
    const QJsonObject facts = run(QStringLiteral("info --json ") + cut.fileName()).object();
    QCOMPARE(facts[QStringLiteral("messages")].toInt(-1), 0);
    QVERIFY(facts[QStringLiteral("start")].isNull() && facts[QStringLiteral("end")].isNull());
  }
  void whenItWasInterruptedAndWhereTheLinkWasAwayStandsInItsFacts() {
    QVERIFY(
        !run(QStringLiteral("info --json ") + recording()).object()[QStringLiteral("interrupted")].toBool());
    const Outcome info = run(QStringLiteral("info --json ") + withoutEndMark());
    QVERIFY(info.object()[QStringLiteral("interrupted")].toBool());
    const QJsonArray away = info.object()[QStringLiteral("away")].toArray();
    QCOMPARE(away.size(), 2);
    QCOMPARE(away[0][QStringLiteral("from")].toDouble(), at(20).toDouble());
    QCOMPARE(away[0][QStringLiteral("to")].toDouble(), at(25).toDouble());
    QCOMPARE(away[1][QStringLiteral("from")].toDouble(), at(50).toDouble());
    QVERIFY(away[1][QStringLiteral("to")].isNull());
    const auto since = [&](double s) {
      return run(QStringLiteral("state --json --at %1 %2").arg(at(s), withoutEndMark()))
          .object()
          .value(QStringLiteral("away_since"));
    };
    QVERIFY(since(10).isNull());
    QCOMPARE(since(22).toDouble(), at(20).toDouble());
    QVERIFY(since(30).isNull());
    // A part that ends before it broke off is whole; one that goes on to there is not.
    QCOMPARE(
        run(QStringLiteral("export --to %1 -o early.mcap --force %2").arg(at(40), withoutEndMark())).code, 1);
    QCOMPARE(run(QStringLiteral("info early.mcap")).code, 0);
    QCOMPARE(run(QStringLiteral("export -o late.mcap --force ") + withoutEndMark()).code, 1);
    QCOMPARE(run(QStringLiteral("info late.mcap")).code, 1);
  }

  void infoTellsWhatAFileHolds() {
    const QJsonObject info = run(QStringLiteral("info --json ") + recording()).object();
    QCOMPARE(info[QStringLiteral("format")].toString(), QStringLiteral("MCAP"));
    QCOMPARE(info[QStringLiteral("written_by")].toString(), QStringLiteral("mapwright"));
    const QJsonArray topics = info[QStringLiteral("topics")].toArray();
    QCOMPARE(topics.size(), 2);
    QCOMPARE(topics[0][QStringLiteral("topic")].toString(), QStringLiteral("/alerts"));
    QCOMPARE(topics[0][QStringLiteral("messages")].toInt(), 1);
    QCOMPARE(topics[1][QStringLiteral("messages")].toInt(), 600);
    QCOMPARE(topics[1][QStringLiteral("encoding")].toString(), QStringLiteral("json"));
    QVERIFY(std::abs(topics[1][QStringLiteral("hz")].toDouble() - 10) < 1e-6);
    QVERIFY(topics[0][QStringLiteral("hz")].isNull());  // one message is no rate
    const QJsonValue packing = info[QStringLiteral("packing")][0];
    QCOMPARE(packing[QStringLiteral("compression")].toString(), QStringLiteral("zstd"));
    QVERIFY(packing[QStringLiteral("chunks")].toInt() > 5);
    QVERIFY(packing[QStringLiteral("stored_bytes")].toInt() <
            packing[QStringLiteral("unpacked_bytes")].toInt());
    const Outcome table = run(QStringLiteral("info ") + recording());
    QVERIFY2(table.out.contains("/tracked_pose") && table.out.contains("10.0"), table.out.constData());
  }

  void aRateIsThatOfTheTimeInWhichATopicSent() {
    const QString path = program_.path(QStringLiteral("rates.mcap"));
    auto target = recording::appendFile(path.toStdString(), recording::Existing::Replace);
    const auto writer = recording::McapWriter::create(std::move(*target), {});
    const auto say = [&](std::int64_t at_s, const char* topic, const char* said = nullptr) {
      recording::Channel channel;
      channel.topic = topic;
      channel.message_encoding = "json";
      if (said) channel.metadata["said"] = said;
      const std::string text = "{}";
      const std::int64_t at_ns = (1'717'405'200 + at_s) * 1'000'000'000;
      (void)(*writer)->write(*(*writer)->addChannel(channel), {at_ns, at_ns, 0},
                             {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    };
    say(0, "/late", "before");
    for (int i = 0; i <= 60; ++i) say(i, "/first_minute");
    for (int i = 0; i <= 600; i += 100) say(i, "/always");
    say(600, "/late");
    say(602, "/late");
    for (int i = 0; i < 3; ++i) say(610, "/at_once");
    (void)(*writer)->close();
    QMap<QString, QJsonValue> rates;
    const QJsonObject info = run(QStringLiteral("info --json ") + path).object();
    for (const QJsonValue& topic : info[QStringLiteral("topics")].toArray())
      rates[topic[QStringLiteral("topic")].toString()] = topic[QStringLiteral("hz")];
    QCOMPARE(rates[QStringLiteral("/first_minute")].toDouble(), 1.0);
    QCOMPARE(rates[QStringLiteral("/always")].toDouble(), 0.01);
    QCOMPARE(rates[QStringLiteral("/late")].toDouble(), 0.5);
    QVERIFY(rates[QStringLiteral("/at_once")].isNull());
  }

  void timesAreTypedAsInTheWindow_data() {
    QTest::addColumn<QString>("time");
    for (const char* time : {"2024-06-03T09:00:20Z", "2024-06-03~09:00:20", "09:00:20", "+20", "+0:20", "20",
                             "-39.9", "1717405220"})
      QTest::newRow(time) << QString::fromLatin1(time);
  }
  void timesAreTypedAsInTheWindow() {
    QFETCH(QString, time);
    const QString file = recording();
    const Outcome state = run(QStringLiteral("state %1 --json --at %2").arg(file, time));
    QVERIFY2(state.code == 0, state.err.constData());
    QCOMPARE(state.object()[QStringLiteral("at")].toDouble(), 1717405220.0);
    const double x = state.object()[QStringLiteral("pose")][QStringLiteral("x")].toDouble();
    QVERIFY2(std::abs(x - 10) < 0.1, state.out.constData());
  }

  void everyCommandTakesSuchTimes_data() {
    QTest::addColumn<QString>("line");
    for (const char* line :
         {"frames %1 --from +1 --to 09:00:02", "export %1 --from +1 --to -50 --force -o t.mcap",
          "export %1 --from +1 --to -50 --force -o t.jsonl", "track %1 --from +1 --to -50 --force -o t.csv",
          "merge %1 --from +1 --to -50 --force -o t.mcap", "report %1 --at +20 -o t.html",
          "report %1 --at +20 --against %1@-10 -o t.html",
          "snapshot %1 --at +20 --mode submaps --size 64x64 -o t.png",
          "film %1 --from +1 --to +2 --mode submaps --size 64x64 -o t%d.png"})
      QTest::newRow(line) << QString::fromLatin1(line);
  }
  void everyCommandTakesSuchTimes() {
    QFETCH(QString, line);
    QString typed = line;
    typed.replace(QStringLiteral("%1"), recording());
    const Outcome done = run(typed);
    QVERIFY2(done.code == 0 || (done.code == 1 && !done.err.contains("1970")), done.err.constData());
    // Beyond the end, and no time at all.
    const QString beyond =
        QString(typed).replace(QRegularExpression(QStringLiteral("\\+\\d+")), QStringLiteral("+900"));
    const Outcome refused = run(beyond);
    QCOMPARE(refused.code, 2);
    QVERIFY2(refused.err.contains("is not within the recording: it lasts from 2024-06-03 09:00:00.000"),
             refused.err.constData());
    const Outcome none =
        run(QString(typed).replace(QRegularExpression(QStringLiteral("\\+\\d+")), QStringLiteral("noon")));
    QCOMPARE(none.code, 2);
    QVERIFY2(none.err.contains("noon is not a time"), none.err.constData());
  }

  void whatIsNotThereIsNamedWhereverItIsAskedFor_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("sentence");
    const auto row = [](const QString& line, const char* sentence) {
      QTest::newRow(qPrintable(line)) << line << QString::fromLatin1(sentence);
    };
    const QString file = recording();
    for (const QString& of : {file, bag()}) {
      for (const char* line : {"frames %1 --topic /nope", "export %1 --topic /nope --force -o n.mcap",
                               "export %1 --topic /nope --force -o n.jsonl"})
        row(QString::fromLatin1(line).arg(of), "No message of /nope was found.");
    }
    row(QStringLiteral("export %1 --topic /alerts --to +1 --force -o n.mcap").arg(file),
        "No message of /alerts was found.");
    row(QStringLiteral("split %1 --topic /nope --force -o n%2.mcap").arg(file, QStringLiteral("%d")),
        "No message of /nope was found.");
    row(QStringLiteral("merge %1 --topic /nope --force -o n.mcap").arg(file),
        "No message of /nope was found.");
    const QString late = QStringLiteral(" --from 2030-01-01T00:00:00Z");
    row(QStringLiteral("frames ") + file + late, "No message was found.");
    row(QStringLiteral("export --force -o n.jsonl ") + file + late, "No message was found.");
    row(QStringLiteral("merge --force -o n.mcap ") + file + late, "No message was found.");
    row(QStringLiteral("track --force -o n.csv ") + file + late, "No position of the robot was found.");
  }
  void whatIsNotThereIsNamedWhereverItIsAskedFor() {
    QFETCH(QString, line);
    QFETCH(QString, sentence);
    (void)recording();
    const Outcome done = run(line);
    QVERIFY2(done.err.contains(sentence.toUtf8()), done.err.constData());
    QCOMPARE(done.code, 1);
  }

  void aFilmIsNoStream() {
    for (const char* output : {"-", "/dev/stdout"}) {
      const Outcome done = run(
          QStringLiteral("film %1 --from +1 --to +2 -o %2").arg(recording(), QString::fromLatin1(output)));
      QCOMPARE(done.code, 2);
      QVERIFY2(done.out.isEmpty() && done.err.contains("a film must be a file"), done.err.constData());
    }
  }

  void severalTopicsAreChosenAndOneThatIsNotThereIsNamed() {
    const QString file = recording();
    const auto count = [&](const char* topics) {
      return run(QStringLiteral("frames --topic %1 %2").arg(QLatin1String(topics), file)).lines().size();
    };
    QCOMPARE(count("/alerts"), 1);
    QCOMPARE(count("/alerts,/tracked_pose"), 601);
    const Outcome none = run(QStringLiteral("frames --topic /alerts,/nope ") + file);
    QCOMPARE(none.lines().size(), 1);
    QVERIFY2(none.code == 1 && none.err.contains("/nope"), none.err.constData());
    QCOMPARE(run(QStringLiteral("export --topic /nope -o nope.mcap --force ") + file).code, 1);
  }

  void aPartOfARecordingIsPackedInFewChunks() {
    QVERIFY(run(QStringLiteral("export -o packed.mcap --force ") + recording()).code == 0);
    const auto opened = recording::openRecording(program_.path(QStringLiteral("packed.mcap")).toStdString());
    QVERIFY(opened);
    QCOMPARE((*opened)->summary().chunks, std::size_t(1));
    QCOMPARE((*opened)->summary().messages, std::uint64_t(601));
  }

  void whatIsSoundOfABrokenRecordingIsMadeAWholeFile() {
    const QByteArray bytes = contentOf(recording());
    const QList<qsizetype> ends = recordEnds(bytes);
    QFile file(program_.path(QStringLiteral("broken.mcap")));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes.left(ends[ends.size() / 2] + 5)) > 0);
    file.close();
    const Outcome made = run(QStringLiteral("repair broken.mcap -o whole.mcap --force --json"));
    QVERIFY2(made.code == 0 && made.err.contains("interrupted"), made.err.constData());
    const auto opened = recording::openRecording(program_.path(QStringLiteral("whole.mcap")).toStdString());
    QVERIFY(opened);
    QVERIFY((*opened)->summary().finished && (*opened)->summary().indexed &&
            (*opened)->summary().notes.empty());
    QVERIFY((*opened)->summary().messages > 100);
    QCOMPARE(made.object()[QStringLiteral("messages")].toInt(), int((*opened)->summary().messages));
    // It says so, and is whole: the commands that read it have nothing to complain of.
    const Outcome info = run(QStringLiteral("info whole.mcap --json"));
    QVERIFY2(info.code == 0 && info.err.isEmpty(), info.err.constData());
    QVERIFY(!info.object()[QStringLiteral("interrupted")].toBool());
    const QJsonValue repaired = info.object()[QStringLiteral("repaired")];
    QVERIFY(repaired.isObject());
    QCOMPARE(repaired[QStringLiteral("broke_off")], info.object()[QStringLiteral("end")]);
    const Outcome table = run(QStringLiteral("info whole.mcap"));
    QVERIFY2(table.code == 0 && table.out.contains("repaired") && table.out.contains("cut off at 2024-06-03"),
             table.out.constData());
    // More than its end is lost.
    QByteArray damaged = bytes;
    damaged[ends[2] - 20] = char(~damaged[ends[2] - 20]);
    for (qsizetype i = 60; i < 90; ++i) damaged[i] = 'x';
    QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate) && file.write(damaged) > 0);
    file.close();
    QCOMPARE(run(QStringLiteral("repair broken.mcap -o whole.mcap --force")).code, 1);
    QCOMPARE(run(QStringLiteral("repair broken.mcap -o broken.mcap --force")).code, 2);
  }

  void aRecordingIsSplitAndPutTogetherAgain() {
    const Outcome split =
        run(QStringLiteral("split %1 --every 20 -o part-%02d.mcap --force --json").arg(recording()));
    QVERIFY2(split.code == 0, split.err.constData());
    QCOMPARE(split.object()[QStringLiteral("files")].toArray().size(), 3);
    QCOMPARE(split.object()[QStringLiteral("messages")].toInt(), 601);
    const Outcome merged =
        run(QStringLiteral("merge part-02.mcap part-00.mcap part-01.mcap -o merged.mcap --force --json"));
    QVERIFY2(merged.code == 0, merged.err.constData());
    const auto opened = recording::openRecording(program_.path(QStringLiteral("merged.mcap")).toStdString());
    const auto whole = recording::openRecording(recording().toStdString());
    QVERIFY(opened && whole);
    const auto a = (*opened)->messages({}), b = (*whole)->messages({});
    while (const auto message = a->next()) {
      const auto same = b->next();
      QVERIFY(same && same->log_time_ns == message->log_time_ns);
      QVERIFY(!message->channel->metadata.contains("said"));
      QVERIFY(
          std::equal(same->bytes.begin(), same->bytes.end(), message->bytes.begin(), message->bytes.end()));
    }
    QVERIFY(!b->next());
    QCOMPARE(run(QStringLiteral("split %1 -o part.mcap").arg(recording())).code, 2);
    QCOMPARE(run(QStringLiteral("merge part-00.mcap nowhere.mcap -o merged.mcap --force")).code, 2);
  }

  void aMessageThatCannotBeReadIsNotHidden() {
    const QString path = program_.path(QStringLiteral("odd.mcap"));
    auto target = recording::appendFile(path.toStdString(), recording::Existing::Replace);
    const auto writer = recording::McapWriter::create(std::move(*target), {});
    recording::Channel channel;
    channel.topic = "/tracked_pose";
    channel.message_encoding = "json";
    for (const std::string text : {R"({"topic":"/tracked_pose","pos":[1,1],"ori":0})", "{broken"})
      (void)(*writer)->write(*(*writer)->addChannel(channel), {1'717'405'200'000'000'000, 0, 0},
                             {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    QVERIFY(!(*writer)->close());
    for (const char* command : {"frames", "state --at 1717405201", "events", "track -o odd.csv --force"})
      QCOMPARE(run(QStringLiteral("%1 %2").arg(QLatin1String(command), path)).code, 1);
  }

  void aDownloadThatIsRefusedLeavesNothing() {
    QCOMPARE(run(QStringLiteral("download nothing.bag -o nothing.bag")).code, 4);
    for (const char* name : {"nothing.bag", "nothing.bag.part", "nothing.bag.part.of"})
      QVERIFY2(!QFile::exists(program_.path(QLatin1String(name))), name);
  }

  void aListWithoutOneOfItsHalvesIsNotComplete() {
    net::testing::ScriptedServer server([](const net::testing::SeenRequest& request) {
      using Server = net::testing::ScriptedServer;
      return request.path.startsWith("/bags/")
                 ? Server::reply(200, {}, R"([{"filename":"a.bag","size_bytes":10}])")
                 : Server::reply(200, {}, R"({"detail":"nope"})");
    });
    const Outcome half =
        run(QStringLiteral("list --json"), QStringLiteral("axbot+") + server.url(QString()).toString());
    QVERIFY2(half.code == 1 && half.err.contains("Recordings"), half.err.constData());
    QCOMPARE(int(half.array().size()), 1);
  }

  void aFullDiskIsNamedWhateverHappenedSince() {
    const QString file = recording();
    for (const QString& line : {QStringLiteral("frames ") + file, QStringLiteral("frames ") + bag(),
                                QStringLiteral("events --json ") + bag()}) {
      const Outcome full = run(line, {}, QStringLiteral("/dev/full"));
      QCOMPARE(full.code, 2);
      QVERIFY2(full.err.contains("No space left on device"), full.err.constData());
      QCOMPARE(full.err.count('\n'), 1);
    }
  }

  void eventsAreChosenByTheirKind() {
    const QString file = recording();
    const auto kinds = [&](const QString& which) {
      QSet<QString> all;
      for (const QJsonValue& event : run(QStringLiteral("events %1 --json%2").arg(file, which)).array())
        all << event[QLatin1String("kind")].toString();
      return all;
    };
    QVERIFY(kinds({}).contains(QStringLiteral("alert_begin")));
    QVERIFY(kinds(QStringLiteral(" --kind alerts,stops")).contains(QStringLiteral("alert_begin")));
    QVERIFY(kinds(QStringLiteral(" --kind planner")).isEmpty());
    const Outcome wrong = run(QStringLiteral("events %1 --kind alerts,birds").arg(file));
    QCOMPARE(wrong.code, 2);
    QVERIFY(wrong.err.contains("birds"));
  }

  void whatABagDoesNotHoldIsNotWaitedFor() {
    const QString file = recording();
    QElapsedTimer clock;
    clock.start();
    const Outcome none =
        run(QStringLiteral("snapshot %1 --at %2 --mode submaps --size 200x150 --timeout 200 -o s.png")
                .arg(file, at(30)));
    QCOMPARE(none.code, 1);
    QVERIFY2(none.err.contains("no submap list"), none.err.constData());
    QVERIFY(QFile::exists(program_.path(QStringLiteral("s.png"))));
    QVERIFY2(clock.elapsed() < 100'000, "it waited for what cannot come");
  }

  void aFileWithoutAMapSaysSoByEveryCommand() {
    const QString path = program_.path(QStringLiteral("nomap.mcap"));
    auto target = recording::appendFile(path.toStdString(), recording::Existing::Replace);
    const auto writer = recording::McapWriter::create(std::move(*target), {});
    const auto say = [&](double at_s, const char* topic, const std::string& rest) {
      recording::Channel channel;
      channel.topic = topic;
      channel.message_encoding = "json";
      const std::string text = "{\"topic\":\"" + channel.topic + "\"," + rest + "}";
      const std::int64_t at_ns = 1'717'405'200'000'000'000 + std::llround(at_s * 1e9);
      (void)(*writer)->write(*(*writer)->addChannel(channel), {at_ns, at_ns, 0},
                             {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    };
    for (int i = 0; i < 100; ++i) say(i * 0.1, "/tracked_pose", R"("pos":[1,1],"ori":0)");
    say(5, "/map/info", R"("name":"Hall","uid":"u1","map_version":1)");
    (void)(*writer)->close();
    const Outcome picture =
        run(QStringLiteral("snapshot %1 --at %2 --mode whole --size 200x150 -o nomap.png").arg(path, at(7)));
    QVERIFY2(picture.code != 0 &&
                 picture.err.contains("There are no maps. Its messages name the map \"Hall\" (u1)."),
             picture.err.constData());
    const Outcome film =
        run(QStringLiteral("film %1 --from %2 --to %3 --mode whole --size 200x150 -o nomap%d.png")
                .arg(path, at(6), at(7)));
    QVERIFY2(film.err.contains("name the map \"Hall\""), film.err.constData());
    const Outcome state = run(QStringLiteral("state %1 --at %2").arg(path, at(7)));
    QVERIFY2(
        state.code == 0 && state.out.contains("There are no maps. Its messages name the map \"Hall\" (u1)."),
        state.out.constData());
    const auto toldAt = [&](double s) {
      return run(QStringLiteral("state %1 --at %2 --json").arg(path, at(s)))
          .object()[QStringLiteral("no_map")]
          .toString();
    };
    QCOMPARE(toldAt(7), QStringLiteral("There are no maps. Its messages name the map \"Hall\" (u1)."));
    QCOMPARE(toldAt(3), QStringLiteral("There are no maps."));
  }

  void aPartOfAnotherProgramStaysWhatItIs() {
    QFile part(program_.path(QStringLiteral("left.mcap.part")));
    QVERIFY(part.open(QIODevice::WriteOnly));
    part.write("half of it");
    part.close();
    for (const QString& of : {recording(), bag()}) {
      const Outcome first =
          run(QStringLiteral("export %1 --from %2 --to %3 -o left.mcap --force").arg(of, at(10), at(20)));
      QVERIFY2(first.code == 0, first.err.constData());
      QVERIFY(part.open(QIODevice::ReadOnly));
      QCOMPARE(part.readAll(), QByteArray("half of it"));
      part.close();
    }
    part.remove();
  }

  void submapsOfABagAreDrawnAsItListsThem() {
    const Outcome made =
        run(QStringLiteral("snapshot %1 --at %2 --mode submaps --size 300x200 -o m.png --json")
                .arg(bag(), at(200)));
    QVERIFY2(made.code == 0, made.err.constData());
    const QJsonObject submaps = made.object()[QStringLiteral("submaps")].toObject();
    QVERIFY(submaps[QStringLiteral("drawn")].toInt() > 0);
    QCOMPARE(submaps[QStringLiteral("drawn")], submaps[QStringLiteral("listed")]);
  }

  void aPictureOfAFileIsTheSameEachTime() {
    const QString file = recording();
    QByteArray first;
    for (const int times : {1, 2}) {
      const QString png = program_.path(QStringLiteral("%1.png").arg(times));
      const Outcome made = run(
          QStringLiteral("snapshot %1 --at %2 --layers robot,trail --mode submaps --settle 0 --center 10,1 "
                         "--scale 0.05 --size 200x100 -o %3")
              .arg(file, at(20), png));
      QVERIFY2(made.code == 0 || made.code == 1, made.err.constData());
      QFile picture(png);
      QVERIFY2(picture.open(QIODevice::ReadOnly), made.err.constData());
      const QByteArray bytes = picture.readAll();
      if (first.isEmpty()) first = bytes;
      QVERIFY(bytes.size() > 100 && bytes == first);
    }
  }

  void theListIsInTheStableShape() {
    const Outcome list = run(QStringLiteral("list --json"));
    QVERIFY2(list.code == 0, list.err.constData());
    QVERIFY(list.array().size() >= 12);
    for (const QJsonValue& row : list.array()) {
      const QStringList members{QStringLiteral("end"), QStringLiteral("kind"), QStringLiteral("name"),
                                QStringLiteral("size_bytes")};
      QCOMPARE(row.toObject().keys(), members);
      QVERIFY(row.toObject()[QStringLiteral("end")].isDouble());
    }
    QVERIFY(run(QStringLiteral("list")).out.contains("recording"));
  }

  void theTrackIsDrawnWithAPicture() {
    const auto picture = [&](const QString& of, const QString& layers) {
      const Outcome made = run(QStringLiteral("snapshot %1 --at %2 --layers %3 --mode submaps --center 10,1 "
                                              "--scale 0.05 --size 200x100 -o track.png --force")
                                   .arg(of, at(20), layers));
      if (made.code != 0 && made.code != 1) qWarning("%d %s", made.code, made.err.constData());
      QFile file(program_.path(QStringLiteral("track.png")));
      return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    for (const QString& of : {recording(), bag()}) {
      const QByteArray with = picture(of, QStringLiteral("robot,track"));
      const QByteArray without = picture(of, QStringLiteral("robot"));
      QVERIFY(with.startsWith("\x89PNG") && without.startsWith("\x89PNG"));
      QVERIFY(with != without);
    }
  }

  void infoTellsWhatTheRobotTells() {
    const Outcome info = run(QStringLiteral("info %1 --json").arg(bag()));
    QVERIFY2(info.code == 0, info.err.constData());
    QVERIFY(info.object()[QStringLiteral("messages")].toInt() > 6000);
    QCOMPARE(info.object()[QStringLiteral("start")].toDouble(), 1717405200.0);
    QCOMPARE(info.object()[QStringLiteral("end")].toDouble(), 1717405799.0);
  }

  void framesAreEachMessageOnce() {
    const Outcome all = run(QStringLiteral("frames %1").arg(bag()));
    QVERIFY2(all.code == 0, all.err.constData());
    const int messages =
        run(QStringLiteral("info %1 --json").arg(bag())).object()[QStringLiteral("messages")].toInt();
    QCOMPARE(int(all.lines().size()), messages);
    const Outcome part =
        run(QStringLiteral("frames %1 --from %2 --to %3 --topic /tracked_pose").arg(bag(), at(100), at(110)));
    QVERIFY(part.lines().size() >= 100);
    for (const QJsonObject& message : part.lines()) {
      QCOMPARE(message[QStringLiteral("topic")].toString(), QStringLiteral("/tracked_pose"));
      QVERIFY(stampOf(message) >= 1717405300 && stampOf(message) <= 1717405310);
    }
  }

  void theStateIsThatOfTheLastMessages() {
    const Outcome all = run(QStringLiteral("frames %1").arg(bag()));
    for (const double s : {333.3, 12.0, 599.0}) {
      QMap<QString, QJsonObject> last;
      for (const QJsonObject& message : all.lines()) {
        if (stampOf(message) <= 1717405200 + s) last[message[QStringLiteral("topic")].toString()] = message;
      }
      const Outcome jumped = run(QStringLiteral("state %1 --at %2 --json").arg(bag(), at(s)));
      QVERIFY2(jumped.code == 0, jumped.err.constData());
      const Outcome played =
          run(QStringLiteral("state %1 --at %2 --from %3 --json").arg(bag(), at(s), at(0)));
      QCOMPARE(played.out, jumped.out);
      const QJsonObject state = jumped.object();
      const QJsonObject topics = state[QStringLiteral("topics")].toObject();
      QCOMPARE(QStringList(topics.keys()), QStringList(last.keys()));
      for (const QString& topic : topics.keys())
        QCOMPARE(topics[topic].toObject()[QStringLiteral("stamp")].toDouble(), stampOf(last[topic]));
      const QJsonArray position = last[QStringLiteral("/tracked_pose")][QStringLiteral("pos")].toArray();
      QCOMPARE(state[QStringLiteral("pose")].toObject()[QStringLiteral("x")].toDouble(),
               position[0].toDouble());
      QCOMPARE(state[QStringLiteral("planning")].toObject()[QStringLiteral("move_state")],
               last[QStringLiteral("/planning_state")][QStringLiteral("move_state")]);
      QCOMPARE(state[QStringLiteral("map")].toObject()[QStringLiteral("uid")],
               last[QStringLiteral("/map/info")][QStringLiteral("uid")]);
    }
  }

  void oddBagsAreReadToo() {
    for (const char* name : {"clock_set_back.bag", "same_stamps.bag", "gap.bag", "ends_late.bag",
                             "one_message.bag", "empty.bag"}) {
      const Outcome info = run(QStringLiteral("info %1 --json").arg(QLatin1String(name)));
      const Outcome frames = run(QStringLiteral("frames %1").arg(QLatin1String(name)));
      QVERIFY2(info.code == 0 && frames.code == 0, frames.err.constData());
      QCOMPARE(int(frames.lines().size()), info.object()[QStringLiteral("messages")].toInt());
      const Outcome events = run(QStringLiteral("events %1 --json").arg(QLatin1String(name)));
      QVERIFY2(events.code == 0, events.err.constData());
    }
  }

  /// One second cannot be read: all else is given, and the second is named.
  void aDamagedBagIsReadButForItsDamage_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("status");
    QTest::newRow("refused") << "damaged.bag"
                             << "400";
    QTest::newRow("fails") << "unreadable.bag"
                           << "500";
  }
  void aDamagedBagIsReadButForItsDamage() {
    QFETCH(QString, name);
    QFETCH(QString, status);
    const auto info = run(QStringLiteral("info %1 --json").arg(name)).object();
    const double start = info[QStringLiteral("start")].toDouble(),
                 end = info[QStringLiteral("end")].toDouble();
    const auto told = [&](const QString& line) {
      const Outcome done = run(line);
      const bool all = done.code == 1 && done.err.contains("is missing") &&
                       done.err.contains("the robot answered " + status.toLatin1());
      if (!all) qWarning("%s: %d %s", qPrintable(line), done.code, done.err.constData());
      return std::pair(all, done);
    };
    const auto [frames_told, frames] = told(QStringLiteral("frames ") + name);
    QVERIFY(frames_told);
    QList<double> stamps;
    for (const QJsonObject& message : frames.lines()) stamps << stampOf(message);
    QVERIFY(stamps.size() > info[QStringLiteral("messages")].toInt() - 60);
    QVERIFY(stamps.first() < start + 1 && stamps.last() > end - 1);
    double longest = 0;
    for (qsizetype i = 1; i < stamps.size(); ++i) longest = std::max(longest, stamps[i] - stamps[i - 1]);
    QVERIFY(longest > 0.9 && longest < 1.6);
    const auto [events_told, events] = told(QStringLiteral("events --json ") + name);
    QVERIFY(events_told && !events.array().isEmpty());
    for (const char* command :
         {"track %1 --force -o t.csv", "export %1 --force -o e.jsonl", "export %1 --force -o e.mcap"}) {
      QVERIFY(told(QString::fromLatin1(command).arg(name)).first);
    }
    QVERIFY(program_.bytes("t.csv").count('\n') > 5000);
    // What lies before the damage has nothing to do with it.
    const QString before = QString::number(start + 100, 'f', 3), after = QString::number(end - 5, 'f', 3);
    QCOMPARE(run(QStringLiteral("frames %1 --to %2").arg(name, before)).code, 0);
    QCOMPARE(run(QStringLiteral("state %1 --at %2").arg(name, before)).code, 0);
    const auto [state_told, state] = told(QStringLiteral("state %1 --json --at %2").arg(name, after));
    QVERIFY(state_told && state.object()[QStringLiteral("pose")].isObject());
    QVERIFY(told(QStringLiteral("report %1 --at %2 -o r.html").arg(name, after)).first);
    QVERIFY(program_.bytes("r.html").contains("is missing"));
    QVERIFY(told(QStringLiteral("snapshot %1 --at %2 --mode whole -o s.png").arg(name, after)).first);
  }

  void whatARobotDoesNotCountIsUnknown() {
    QVERIFY(run(QStringLiteral("info uncounted.bag --json")).object()[QStringLiteral("messages")].isNull());
    QVERIFY(run(QStringLiteral("info uncounted.bag")).out.contains("unknown"));
    QVERIFY(run(QStringLiteral("frames uncounted.bag")).lines().size() > 5000);
    QCOMPARE(run(QStringLiteral("info empty.bag --json")).object()[QStringLiteral("messages")].toInt(-1), 0);
  }

  /// The map that a bag latches is drawn as one that it holds.
  void theLatchedMapIsDrawn() {
    const double end =
        run(QStringLiteral("info latched.bag --json")).object()[QStringLiteral("end")].toDouble();
    const auto drawn =
        run(QStringLiteral("snapshot latched.bag --mode whole --layers grid --report m.json -o m.png --at ") +
            QString::number(end - 10, 'f', 3));
    QVERIFY2(drawn.code == 0, drawn.err.constData());
    const QJsonObject report = QJsonDocument::fromJson(program_.bytes("m.json")).object();
    QCOMPARE(report[QStringLiteral("map")][QStringLiteral("id")].toString(), QStringLiteral("live"));
  }

  void whatABagLatchesIsInItsState() {
    const double end =
        run(QStringLiteral("info latched.bag --json")).object()[QStringLiteral("end")].toDouble();
    const auto state =
        run(QStringLiteral("state latched.bag --json --at %1").arg(QString::number(end, 'f', 3)));
    QVERIFY2(state.code == 0, state.err.constData());
    QCOMPARE(state.object()[QStringLiteral("jack")][QStringLiteral("state")].toString(),
             QStringLiteral("hold"));
    QCOMPARE(state.object()[QStringLiteral("towing")][QStringLiteral("cargo")], QJsonValue(true));
  }

  void errorsAreSentencesWithTheirExitCodes() {
    const Outcome missing = run(QStringLiteral("state nothing.bag --at 5"));
    QCOMPARE(missing.code, 4);
    QVERIFY2(missing.err.contains("not found") && missing.err.count('\n') == 1, missing.err.constData());
    QCOMPARE(run(QStringLiteral("state %1 --at noon").arg(bag())).code, 2);
    QCOMPARE(run(QStringLiteral("frames %1 --from 9 --to 5").arg(bag())).code, 2);
    QCOMPARE(run(QStringLiteral("delete %1").arg(bag())).code, 2);
    QCOMPARE(run(QStringLiteral("list --robot axbot+http://127.0.0.1:1")).code, 3);
  }

  void aChangeWithAnUnknownOutcomeIsExitCodeOne() {
    const auto names = [&] {
      QStringList all;
      for (const QJsonValue& row : run(QStringLiteral("list --json")).array())
        all << row.toObject()[QStringLiteral("name")].toString();
      return all;
    };
    const Outcome made = run(QStringLiteral("record --json"));
    QCOMPARE(made.code, 0);
    const QString name = made.object()[QStringLiteral("name")].toString();
    QString word = name;
    word.replace(QLatin1Char(' '), QLatin1Char('~'));
    const QStringList before = names();
    QVERIFY(before.contains(name));
    simulator::Faults ignores, fails, loses;
    ignores.requests.push_back({simulator::FaultKind::Ignore, simulator::kWrites});
    fails.requests.push_back({simulator::FaultKind::Refuse, simulator::kWrites});
    loses.requests.push_back({simulator::FaultKind::Cut, simulator::kWrites});
    robot_->setFaults(ignores);
    const Outcome ignored = run(QStringLiteral("record"));
    QCOMPARE(ignored.code, 1);
    QVERIFY2(ignored.err.contains("does not list it"), ignored.err.constData());
    robot_->setFaults(fails);
    for (const QString& line : {QStringLiteral("record"), QStringLiteral("delete %1 --yes").arg(word)}) {
      const Outcome unknown = run(line);
      QVERIFY2(unknown.code == 1, unknown.err.constData());
      QVERIFY2(unknown.err.contains("unknown"), unknown.err.constData());
    }
    QCOMPARE(names(), before);
    robot_->setFaults(loses);
    QCOMPARE(run(QStringLiteral("delete %1 --yes").arg(word)).code, 0);
    robot_->setFaults({});
    QVERIFY(!names().contains(name));
    QCOMPARE(run(QStringLiteral("delete * --yes")).code, 4);
    QCOMPARE(names().size(), before.size() - 1);
  }

  void aPartOfABagIsALineForEachMessage() {
    const QString part = QStringLiteral("%1 --from %2 --to %3").arg(bag(), at(100), at(110));
    const Outcome made = run(QStringLiteral("export %1 -o part.jsonl --json").arg(part));
    QVERIFY2(made.code == 0, made.err.constData());
    QFile file(program_.path(QStringLiteral("part.jsonl")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray written = file.readAll();
    QCOMPARE(written, run(QStringLiteral("frames %1").arg(part)).out);
    QCOMPARE(written.count('\n'), made.object()[QStringLiteral("messages")].toInt());
    // What is there is not lost, and what cannot be is a sentence.
    QCOMPARE(run(QStringLiteral("export %1 -o part.jsonl").arg(part)).code, 2);
    QCOMPARE(run(QStringLiteral("export %1 -o part.xyz").arg(part)).code, 2);
    QCOMPARE(run(QStringLiteral("export %1 -o nowhere/part.mcap").arg(part)).code, 2);
    QCOMPARE(run(QStringLiteral("export nothing.bag -o nothing.mcap")).code, 4);
    QVERIFY(!QFile::exists(program_.path(QStringLiteral("nothing.mcap.part"))));
  }

  void aPartOfABagIsAnMcapFileThatBeginsWithWhatHadBeenSaid() {
    const QString part = QStringLiteral("%1 --from %2 --to %3").arg(bag(), at(100), at(110));
    const Outcome made = run(QStringLiteral("export %1 -o part.mcap --json").arg(part));
    QVERIFY2(made.code == 0, made.err.constData());
    QVERIFY(!QFile::exists(program_.path(QStringLiteral("part.mcap.part"))));
    const auto opened = recording::openRecording(program_.path(QStringLiteral("part.mcap")).toStdString());
    QVERIFY(opened.has_value());
    recording::Source& file = **opened;
    QVERIFY(file.summary().finished && file.summary().notes.empty());
    QList<QByteArray> before, said;
    const auto cursor = file.messages({});
    while (const auto message = cursor->next()) {
      const QByteArray text(reinterpret_cast<const char*>(message->bytes.data()),
                            qsizetype(message->bytes.size()));
      const bool is_before = message->channel->metadata.contains("said");
      (is_before ? before : said) << text;
      const QJsonObject json = QJsonDocument::fromJson(text).object();
      QCOMPARE(json[QStringLiteral("topic")].toString().toStdString(), message->channel->topic);
      QVERIFY(std::abs(double(message->publish_time_ns) / 1e9 - stampOf(json)) < 1e-5);
    }
    QCOMPARE(said.join('\n') + '\n', run(QStringLiteral("frames %1").arg(part)).out);
    QCOMPARE(int(before.size()), made.object()[QStringLiteral("said_before")].toInt());
    const QJsonObject topics = run(QStringLiteral("state %1 --at %2 --json").arg(bag(), at(99.999)))
                                   .object()[QStringLiteral("topics")]
                                   .toObject();
    QVERIFY(int(before.size()) >= int(topics.size()));  // of some more than the last one counts
  }

  void aPartOfARecordingShowsTheSameWorldAndIsThereAlone() {
    QVERIFY(run(QStringLiteral("export %1 -o whole.mcap --force --to %2").arg(bag(), at(200))).code == 0);
    const Outcome made =
        run(QStringLiteral("export whole.mcap -o slice.mcap --from %1 --to %2 --json").arg(at(100), at(110)));
    QVERIFY2(made.code == 0, made.err.constData());
    QVERIFY(made.object()[QStringLiteral("said_before")].toInt() >= 10);
    const auto frames = [&](const char* file) {
      return run(QStringLiteral("frames %1 --from %2 --to %3").arg(QLatin1String(file), at(100.001), at(110)))
          .out;
    };
    QVERIFY(!frames("slice.mcap").isEmpty());
    QCOMPARE(frames("slice.mcap"), frames("whole.mcap"));
    const auto state = [&](const char* file) {
      QJsonObject world =
          run(QStringLiteral("state %1 --at %2 --json").arg(QLatin1String(file), at(105))).object();
      world.remove(QStringLiteral("topics"));  // of those that were said before it knows no earlier time
      return world;
    };
    QVERIFY(state("slice.mcap")[QStringLiteral("pose")].isObject());
    QCOMPARE(state("slice.mcap"), state("whole.mcap"));
    // Never over what it is read from.
    for (const char* over :
         {"export slice.mcap -o slice.mcap --force", "export slice.mcap -o slice.mcap --format jsonl --force",
          "track slice.mcap -o slice.mcap --format csv --force", "repair slice.mcap -o slice.mcap --force"}) {
      const Outcome refused = run(QLatin1String(over));
      QCOMPARE(refused.code, 2);
      QCOMPARE(refused.err, QByteArray("slice.mcap is the recording itself. Choose another name.\n"));
    }
    QVERIFY(!frames("slice.mcap").isEmpty());
    QCOMPARE(run(QStringLiteral("export nowhere.mcap -o no.mcap")).code, 2);
    QVERIFY(!QFile::exists(program_.path(QStringLiteral("no.mcap"))));
  }

  void theTrackIsWrittenForOtherPrograms() {
    const QString part = QStringLiteral("%1 --from %2 --to %3").arg(bag(), at(100), at(110));
    for (const char* format : {"csv", "geojson", "tum"}) {
      const Outcome made =
          run(QStringLiteral("track %1 -o track.%2 --json").arg(part, QLatin1String(format)));
      QVERIFY2(made.code == 0, made.err.constData());
      QVERIFY(made.object()[QStringLiteral("samples")].toInt() >= 100);
      QFile file(program_.path(QStringLiteral("track.%1").arg(QLatin1String(format))));
      QVERIFY(file.open(QIODevice::ReadOnly));
      const Outcome again = run(QStringLiteral("track %1 -o - --format %2").arg(part, QLatin1String(format)));
      QCOMPARE(again.out, file.readAll());
    }
    QVERIFY(run(QStringLiteral("track %1 -o - --format tum").arg(QStringLiteral("empty.bag"))).code == 0);
  }

  void aFilmIsAPictureForEachTime() {
    const QString film = QStringLiteral("film %1 --from %2 --to %3 --size 300x200");
    const Outcome made =
        run(film.arg(bag(), at(100), at(104)) + QStringLiteral(" --every 2 -o f%03d.png --json"));
    QVERIFY2(made.code == 0, made.err.constData());
    QCOMPARE(made.object()[QStringLiteral("pictures")].toInt(), 3);
    QCOMPARE(made.object()[QStringLiteral("file")].toString(), QStringLiteral("f%03d.png"));
    QSet<QByteArray> different;
    for (const char* name : {"f000.png", "f001.png", "f002.png"}) {
      QFile file(program_.path(QLatin1String(name)));
      QVERIFY(file.open(QIODevice::ReadOnly));
      different << file.readAll();
    }
    QVERIFY(different.size() >= 2);  // the robot moves
    QVERIFY(!QFile::exists(program_.path(QStringLiteral("f003.png"))));
    QCOMPARE(run(film.arg(bag(), at(100), at(104)) + QStringLiteral(" -o f.png")).code, 2);
    QCOMPARE(run(film.arg(bag(), at(104), at(100)) + QStringLiteral(" -o f%d.png")).code, 2);
    QCOMPARE(run(film.arg(QStringLiteral("nothing.bag"), at(1), at(2)) + QStringLiteral(" -o n%d.png")).code,
             4);
    QVERIFY(run(film.arg(bag(), at(100), at(100)) + QStringLiteral(" -o f%03d.png"))
                .out.contains("f%03d.png: 1 "));
    // Without ffmpeg, and with it.
    const Outcome moving = run(film.arg(bag(), at(100), at(101)) + QStringLiteral(" -o film.mp4"));
    const bool can = !QStandardPaths::findExecutable(QStringLiteral("ffmpeg")).isEmpty();
    QVERIFY2(moving.code == (can ? 0 : 2), moving.err.constData());
    QCOMPARE(QFile::exists(program_.path(QStringLiteral("film.mp4"))), can);
    QVERIFY(can || moving.err.contains("ffmpeg"));
  }

  void aBagIsFetchedOnce() {
    const Outcome first = run(QStringLiteral("download %1 -o a.bag --json").arg(bag()));
    QVERIFY2(first.code == 0, first.err.constData());
    QFile file(program_.path(QStringLiteral("a.bag")));
    QCOMPARE(file.size(), qint64(first.object()[QStringLiteral("bytes")].toDouble()));
    QCOMPARE(run(QStringLiteral("download %1 -o a.bag").arg(bag())).code, 2);
  }

  void aPictureOfATimeIsTheSameEachTime() {
    const auto picture = [&](const char* name) {
      const Outcome made = run(QStringLiteral("snapshot %1 --at %2 -o %3 --size 400x300")
                                   .arg(bag(), at(200), QLatin1String(name)));
      if (made.code != 0) qWarning("%s", made.err.constData());
      QFile file(program_.path(QLatin1String(name)));
      return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    const QByteArray first = picture("1.png");
    QVERIFY(first.startsWith("\x89PNG"));
    QVERIFY(picture("2.png") == first);
  }
};

}  // namespace test_bags_command

MAPWRIGHT_TEST(test_bags_command, BagsCommandTest, Core)
#include "test_bags_command.moc"
