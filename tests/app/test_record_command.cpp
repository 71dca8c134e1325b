// `mapwright record` as people run it.
#include <csignal>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QtTest>

#include "program.h"
#include "recording/source.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_record_command {

using namespace mapwright;

namespace {

using Ended = tests::EndedBytes;

}  // namespace

class RecordCommandTest : public QObject {
  Q_OBJECT
  tests::Program program_;
  std::unique_ptr<simulator::Simulator> simulator_;

  QString path(const char* name) const { return program_.path(name); }
  QStringList words(const QString& file, const QStringList& more = {}) const {
    return QStringList{QStringLiteral("record"),
                       QStringLiteral("--robot"),
                       QString::fromStdString(simulator_->address()),
                       QStringLiteral("-o"),
                       file,
                       QStringLiteral("--json")} +
           more;
  }
  static Ended ended(QProcess& process) {
    if (!process.waitForFinished(60'000)) process.kill();
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            process.readAllStandardOutput(), process.readAllStandardError()};
  }
  Ended run(const QStringList& words) const { return program_.runForBytes(words); }
  /// Runs until messages can be read in its file, and then gets `signal`.
  Ended runUntilRead(const QString& file, int signal) {
    QProcess process;
    process.start(QStringLiteral(MAPWRIGHT_PROGRAM), words(file));
    const bool grown = QTest::qWaitFor([&] { return read(file).messages > 0; }, 60'000);
    if (!grown) qWarning("%s stays without messages", qPrintable(file));
    ::kill(pid_t(process.processId()), signal);
    return ended(process);
  }
  struct Film {
    bool opened = false, finished = false;
    std::size_t messages = 0, notes = 0;
  };
  static Film read(const QString& file) {
    Film film;
    auto source = recording::openRecording(file.toStdString());
    if (!source) return film;
    film.opened = true;
    film.finished = (*source)->summary().finished;
    film.notes = (*source)->summary().notes.size();
    const auto cursor = (*source)->messages({});
    while (cursor->next()) ++film.messages;
    return film;
  }

 private Q_SLOTS:
  void initTestCase() {
    simulator_ = std::make_unique<simulator::Simulator>(simulator::Options());
    QVERIFY(!simulator_->start());
  }
  void cleanupTestCase() { simulator_.reset(); }

  void itEndsByItselfAndSaysWhatIsInTheFile() {
    const QString file = path("one.mcap");
    const Ended done = run(words(file, {QStringLiteral("--duration"), QStringLiteral("6s")}));
    QCOMPARE(done.code, 0);
    const QJsonObject said = QJsonDocument::fromJson(done.out).object();
    const Film film = read(file);
    QVERIFY(film.finished);
    QCOMPARE(film.notes, std::size_t(0));
    QCOMPARE(said[QStringLiteral("messages")].toInt(), int(film.messages));
    QVERIFY(film.messages > 10);
    QVERIFY(said[QStringLiteral("complete")].toBool());
    QCOMPARE(said[QStringLiteral("bytes")].toInteger(), QFileInfo(file).size());
  }

  void aTopicThatSaysNothingIsNamed() {
    const Ended done =
        run(words(path("silent.mcap"), {QStringLiteral("--duration"), QStringLiteral("2"),
                                        QStringLiteral("--submaps"), QStringLiteral("none"),
                                        QStringLiteral("--topics"), QStringLiteral("/nope,/tracked_pose")}));
    QCOMPARE(done.code, 1);
    QVERIFY2(done.err.contains("/nope") && !done.err.contains("/tracked_pose"), done.err.constData());
    const QJsonArray silent = QJsonDocument::fromJson(done.out)[QStringLiteral("silent_topics")].toArray();
    QCOMPARE(silent, QJsonArray{QStringLiteral("/nope")});
  }

  void aSignalFinishesTheFile_data() {
    QTest::addColumn<int>("signal");
    QTest::newRow("Ctrl+C") << SIGINT;
    QTest::newRow("told to end") << SIGTERM;
  }
  void aSignalFinishesTheFile() {
    QFETCH(int, signal);
    const QString file = path("stopped.mcap");
    QFile::remove(file);
    const Ended done = runUntilRead(file, signal);
    // What was still on its way when it was told to end could not be had: then it says so.
    const bool complete = QJsonDocument::fromJson(done.out).object()[QStringLiteral("complete")].toBool();
    QCOMPARE(done.code, complete ? 0 : 1);
    QVERIFY(read(file).finished);
  }

  void aRobotThatGoesIsToldOf() {
    const QString file = path("gone.mcap");
    simulator::Simulator robot{simulator::Options()};
    QVERIFY(!robot.start());
    QProcess process;
    process.start(QStringLiteral(MAPWRIGHT_PROGRAM),
                  {QStringLiteral("record"), QStringLiteral("--robot"),
                   QString::fromStdString(robot.address()), QStringLiteral("-o"), file,
                   QStringLiteral("--duration"), QStringLiteral("12"), QStringLiteral("--json")});
    QVERIFY(QTest::qWaitFor([&] { return read(file).messages > 0; }, 60'000));
    robot.stop();
    const Ended done = ended(process);
    QCOMPARE(done.code, 1);
    QVERIFY2(done.err.contains("The connection was lost"), done.err.constData());
    const QJsonObject said = QJsonDocument::fromJson(done.out).object();
    QVERIFY(said[QStringLiteral("interruptions")].toInt() >= 1);
    QVERIFY(!said[QStringLiteral("complete")].toBool(true));
    QVERIFY(read(file).finished);
  }

  void oneThatIsKilledLeavesWhatWasSound() {
    const QString file = path("killed.mcap");
    const Ended done = runUntilRead(file, SIGKILL);
    QCOMPARE(done.code, -1);
    const Film film = read(file);
    QVERIFY(film.opened);
    QVERIFY(!film.finished);
    QVERIFY(film.messages > 0);
  }

  void aFileThatIsThereStaysUnlessItMayGo() {
    const QString file = path("there.mcap");
    QFile there(file);
    QVERIFY(there.open(QIODevice::WriteOnly) && there.write("precious") == 8);
    there.close();
    const QStringList shortly{QStringLiteral("--duration"), QStringLiteral("1")};
    const Ended refused = run(words(file, shortly));
    QCOMPARE(refused.code, 2);
    QVERIFY(refused.err.contains("--force"));
    QVERIFY(there.open(QIODevice::ReadOnly));
    QCOMPARE(there.readAll(), QByteArray("precious"));
    QCOMPARE(run(words(file, shortly + QStringList{QStringLiteral("--force")})).code, 0);
    QVERIFY(read(file).finished);
  }

  void withoutARobotThereIsNoFile() {
    const QString file = path("none.mcap");
    const Ended done =
        run({QStringLiteral("record"), QStringLiteral("--robot"), QStringLiteral("axbot+http://127.0.0.1:1"),
             QStringLiteral("-o"), file, QStringLiteral("--timeout"), QStringLiteral("1")});
    QCOMPARE(done.code, 3);
    QVERIFY(!done.err.isEmpty());
    QVERIFY(!QFile::exists(file));
  }

  void whatIsWrongWithTheWordsIsSaid_data() {
    QTest::addColumn<QStringList>("more");
    QTest::newRow("no such kind of data")
        << QStringList{QStringLiteral("--streams"), QStringLiteral("pose,odd")};
    QTest::newRow("no such choice") << QStringList{QStringLiteral("--submaps"), QStringLiteral("some")};
    QTest::newRow("no time at all") << QStringList{QStringLiteral("--duration"), QStringLiteral("0")};
    QTest::newRow("a unit that is none") << QStringList{QStringLiteral("--duration"), QStringLiteral("5x")};
    QTest::newRow("a time that is none") << QStringList{QStringLiteral("--duration"), QStringLiteral("-1")};
    QTest::newRow("no file") << QStringList{QStringLiteral("-o"), QStringLiteral("-")};
  }
  void whatIsWrongWithTheWordsIsSaid() {
    QFETCH(QStringList, more);
    QStringList all = words(path("wrong.mcap"));
    if (more.first() == QLatin1String("-o")) {
      all[all.indexOf(QStringLiteral("-o")) + 1] = more.last();
    } else {
      all += more;
    }
    const Ended done = run(all);
    QCOMPARE(done.code, 2);
    QCOMPARE(done.err.count('\n'), 1);
    QVERIFY(!QFile::exists(path("wrong.mcap")));
  }

  void aFullDiskIsToldAndLeavesWhatWasWritten() {
    const QString file = path("full.mcap");
    QProcess process;
    // Files of more than 128 KiB are refused by the system.
    process.start(QStringLiteral("/bin/bash"),
                  QStringList{QStringLiteral("-c"), QStringLiteral("ulimit -f 128; exec \"$0\" \"$@\""),
                              QStringLiteral(MAPWRIGHT_PROGRAM)} +
                      words(file, {QStringLiteral("--duration"), QStringLiteral("6"),
                                   QStringLiteral("--submaps"), QStringLiteral("none"),
                                   QStringLiteral("--streams"), QStringLiteral("pose,cloud,costmap-low")}));
    const Ended done = ended(process);
    QCOMPARE(done.code, 1);
    QVERIFY2(done.err.contains("full.mcap"), done.err.constData());
    QVERIFY(!QJsonDocument::fromJson(done.out).object()[QStringLiteral("complete")].toBool(true));
    const Film film = read(file);
    QVERIFY(film.opened);
    QVERIFY(film.messages > 0);
    QVERIFY(!film.finished);
  }
};

}  // namespace test_record_command

MAPWRIGHT_TEST(test_record_command, RecordCommandTest, Core)
#include "test_record_command.moc"
