// `maps rename` and `maps load`: what a script sees of a change that was made, was not, or may have been.
#include <QTest>

#include "program.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_maps_change {

using namespace mapwright;
using Outcome = tests::Ended;

class MapsChangeTest : public QObject {
  Q_OBJECT
  tests::Program program_;

  Outcome run(const QStringList& arguments) const { return program_.run(arguments); }
  Outcome run(const simulator::Simulator& robot, const QStringList& words, bool agibot = false) const {
    const std::string address = agibot ? robot.aimdkAddress() : robot.address();
    return run(QStringList{QStringLiteral("maps")} + words +
               QStringList{QStringLiteral("--robot"), QString::fromStdString(address)});
  }
  static int changesIn(const simulator::Simulator& robot) {
    int changes = 0;
    for (const auto& record : robot.requestLog()) {
      // Agibot's questions are POSTs, too.
      changes += record.method == "GET" || record.target.starts_with("/rpc/") ? 0 : 1;
    }
    return changes;
  }
  static simulator::Options paused(const simulator::Faults& faults = {}) {
    simulator::Options options;
    options.paused = true;
    options.faults = faults;
    return options;
  }

 private Q_SLOTS:
  void aNameIsOneLineOfText() {
    simulator::Simulator robot(paused());
    QVERIFY(!robot.start());
    for (const char* name : {"", "  ", "two\nlines", "bell\x07", "\x1b[31mred"}) {
      const Outcome outcome =
          run(robot, {QStringLiteral("rename"), QStringLiteral("2"), QString::fromUtf8(name)});
      QVERIFY2(outcome.code == 2 && outcome.err.count(QLatin1Char('\n')) == 1, qPrintable(outcome.err));
    }
    QCOMPARE(changesIn(robot), 0);
  }

  void aMapIsCalledOtherwiseAndWorkedWith() {
    simulator::Simulator robot(paused());
    QVERIFY(!robot.start());
    const QString name = QStringLiteral("Halle \"2\"\u202e 🏭");
    const Outcome renamed = run(robot, {QStringLiteral("rename"), QStringLiteral("2"), name});
    QVERIFY2(renamed.code == 0, qPrintable(renamed.err));
    QCOMPARE(renamed.out, QStringLiteral("2  Halle \"2\" 🏭\n"));
    const Outcome loaded =
        run(robot, {QStringLiteral("load"), QStringLiteral("2"), QStringLiteral("--json")});
    QVERIFY2(loaded.code == 0, qPrintable(loaded.err));
    const QJsonObject row = QJsonDocument::fromJson(loaded.out.toUtf8()).object();
    QCOMPARE(row[QLatin1String("id")].toString(), QStringLiteral("2"));
    QCOMPARE(row[QLatin1String("name")].toString(), name);
    QVERIFY(row[QLatin1String("current")].toBool());
    QVERIFY(run(robot, {QStringLiteral("current")}).out.startsWith(QStringLiteral("2 ")));
    QCOMPARE(changesIn(robot), 2);
  }

  void aNameThatAnotherMapHasIsGivenWithAWarning() {
    simulator::Simulator robot(paused());
    QVERIFY(!robot.start());
    for (const char* warning : {"", "Another map has this name: id 2."}) {
      const QString id = *warning ? QStringLiteral("1") : QStringLiteral("2");
      const Outcome renamed = run(robot, {QStringLiteral("rename"), id, QStringLiteral("Lobby")});
      QCOMPARE(renamed.code, 0);
      QVERIFY2(renamed.err.contains(QLatin1String(warning)), qPrintable(renamed.err));
      QCOMPARE(renamed.err.count(QLatin1Char('\n')), *warning ? 1 : 0);
    }
    QCOMPARE(changesIn(robot), 2);
  }

  void aChangeThatFailsSaysWhetherItWasMade_data() {
    QTest::addColumn<QString>("fault");
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* fault, int code, const char* says) {
      QTest::newRow(fault) << QString::fromLatin1(fault) << code << QString::fromLatin1(says);
    };
    row("no such map", 4, "It was not changed: the robot answered 404 (not found)");
    row("it stumbles", 1, "Whether it was changed is unknown: the robot answered 50");
    row("it hangs up", 1, "Whether it was changed is unknown: the robot closed the connection");
    row("it takes its time", 1, "Whether it was changed is unknown: it did not answer within 2 s");
  }
  void aChangeThatFailsSaysWhetherItWasMade() {
    QFETCH(QString, fault);
    QFETCH(int, code);
    QFETCH(QString, says);
    simulator::Faults faults;
    if (fault == QLatin1String("it stumbles"))
      faults.requests.push_back({simulator::FaultKind::Refuse, simulator::kWrites});
    if (fault == QLatin1String("it hangs up"))
      faults.requests.push_back({simulator::FaultKind::Drop, simulator::kWrites});
    if (fault == QLatin1String("it takes its time"))
      faults.requests.push_back({simulator::FaultKind::Delay, simulator::kWrites, 1, 60'000});
    simulator::Simulator robot(paused(faults));
    QVERIFY(!robot.start());
    QStringList words{QStringLiteral("rename"),
                      fault == QLatin1String("no such map") ? QStringLiteral("99") : QStringLiteral("2"),
                      QStringLiteral("Lobby")};
    if (fault == QLatin1String("it takes its time"))
      words << QStringLiteral("--timeout") << QStringLiteral("2");
    const Outcome outcome = run(robot, words);
    QVERIFY2(outcome.code == code, qPrintable(outcome.err));
    QVERIFY2(outcome.err.contains(says), qPrintable(outcome.err));
    QCOMPARE(outcome.err.count(QLatin1Char('\n')), 1);
    QVERIFY(outcome.out.isEmpty());
    QCOMPARE(changesIn(robot), 1);
  }

  void anAnswerThatIsLostIsLookedFor() {
    simulator::Faults faults;
    faults.requests.push_back({simulator::FaultKind::Cut, simulator::kWrites});
    simulator::Simulator robot(paused(faults));
    QVERIFY(!robot.start());
    const Outcome renamed =
        run(robot, {QStringLiteral("rename"), QStringLiteral("2"), QStringLiteral("Lobby")});
    QVERIFY2(renamed.code == 0, qPrintable(renamed.err));
    QCOMPARE(renamed.out, QStringLiteral("2  Lobby\n"));
    const Outcome loaded =
        run(robot, {QStringLiteral("load"), QStringLiteral("2"), QStringLiteral("--json")});
    QVERIFY2(loaded.code == 0, qPrintable(loaded.err));
    QVERIFY(QJsonDocument::fromJson(loaded.out.toUtf8()).object()[QLatin1String("current")].toBool());
    QCOMPARE(changesIn(robot), 2);  // nothing is sent twice
  }

  void whatTheMakerDoesNotConfirmIsDoneAndCalledSo() {
    simulator::Options options = paused();
    options.aimdk.newer = true;
    simulator::Simulator robot(options);
    QVERIFY(!robot.start());
    const auto agibot = [&](const QString& words) { return run(robot, words.split(QLatin1Char(' ')), true); };
    for (const char* words :
         {"rename 1764137567113 Lobby", "load 1764137567113", "delete 1764059676131 --yes", "start-mapping",
          "save Yard", "start-mapping", "stop-mapping --cancel"}) {
      const Outcome done = agibot(QString::fromLatin1(words));
      QVERIFY2(done.code == 0, qPrintable(QString::fromLatin1(words) + done.err));
      QVERIFY2(done.err.count(QLatin1Char('\n')) == 1 && done.err.contains(QStringLiteral("not confirmed")),
               qPrintable(done.err));
    }
    // Stopping without saving would lose what was mapped.
    const Outcome stopped = agibot(QStringLiteral("stop-mapping"));
    QVERIFY2(stopped.code == 4 && stopped.err.contains(QStringLiteral("by saving the map")),
             qPrintable(stopped.err));
    const Outcome listed = agibot(QStringLiteral("list"));
    QVERIFY2(listed.code == 0 && listed.err.isEmpty(), qPrintable(listed.err));
    QVERIFY(listed.out.contains(QStringLiteral("Lobby")) && listed.out.contains(QStringLiteral("Yard")));
    QVERIFY(!listed.out.contains(QStringLiteral("1764059676131")));
  }

  void whatCannotBeChangedIsSaidBeforeAnythingIsSent() {
    simulator::Simulator robot(paused());
    QVERIFY(!robot.start());
    const Outcome agibot = run(
        robot, {QStringLiteral("rename"), QStringLiteral("1764059676131"), QStringLiteral("Lobby")}, true);
    QCOMPARE(agibot.code, 4);
    QVERIFY2(agibot.err.contains(QStringLiteral("offers no editing")), qPrintable(agibot.err));
    for (const QStringList& words : {QStringList{QStringLiteral("archive"), QStringLiteral("2")},
                                     QStringList{QStringLiteral("unarchive"), QStringLiteral("2")}}) {
      const Outcome not_offered = run(robot, words);
      QVERIFY2(not_offered.code == 4, qPrintable(not_offered.err));
      QCOMPARE(not_offered.err.count(QLatin1Char('\n')), 1);
    }
    const Outcome unsure = run(robot, {QStringLiteral("delete"), QStringLiteral("2")});
    QVERIFY2(unsure.code == 2 && unsure.err.contains(QStringLiteral("--yes")), qPrintable(unsure.err));
    for (const char* id : {"mapping:1", "live", ""}) {
      const Outcome wrong =
          run(robot, {QStringLiteral("rename"), QString::fromLatin1(id), QStringLiteral("Lobby")});
      QVERIFY2(wrong.code == 2, qPrintable(wrong.err));
    }
    // A DELETE without an id would delete every map.
    for (const char* id : {"", " ", ".", "..", "../maps", "2/", "2?x", "%2e", "\t"}) {
      const Outcome wrong =
          run(robot, {QStringLiteral("delete"), QString::fromLatin1(id), QStringLiteral("--yes")});
      QVERIFY2(wrong.code == 2, id);
    }
    QCOMPARE(run(robot, {QStringLiteral("rename"), QStringLiteral("2"), QString()}).code, 2);
    QCOMPARE(run(robot, {QStringLiteral("rename"), QStringLiteral("2")}).code, 2);
    QCOMPARE(run(robot, {QStringLiteral("load")}).code, 2);
    QCOMPARE(changesIn(robot), 0);
  }

  void aMapIsDeletedOnce() {
    simulator::Simulator robot(paused());
    QVERIFY(!robot.start());
    const QStringList words{QStringLiteral("delete"), QStringLiteral("7"), QStringLiteral("--yes")};
    const Outcome gone = run(robot, words);
    QVERIFY2(gone.code == 0 && gone.out.startsWith(QStringLiteral("7  ")), qPrintable(gone.err));
    QVERIFY(!run(robot, {QStringLiteral("list")}).out.contains(QStringLiteral("Lager")));
    QCOMPARE(run(robot, words).code, 4);
    QCOMPARE(changesIn(robot), 1);
  }

  void aMapIsMade() {
    simulator::Simulator robot(paused());
    QVERIFY(!robot.start());
    QCOMPARE(run(robot, {QStringLiteral("stop-mapping")}).code, 4);
    QCOMPARE(run(robot, {QStringLiteral("start-mapping")}).code, 0);
    QCOMPARE(run(robot, {QStringLiteral("start-mapping")}).code, 4);
    QCOMPARE(run(robot, {QStringLiteral("stop-mapping")}).code, 0);
    const Outcome saved =
        run(robot, {QStringLiteral("save"), QStringLiteral("Hall 😀"), QStringLiteral("--json")});
    QVERIFY2(saved.code == 0, qPrintable(saved.err));
    QCOMPARE(saved.object()[QStringLiteral("name")].toString(), QStringLiteral("Hall 😀"));
    QVERIFY(run(robot, {QStringLiteral("list")}).out.contains(QStringLiteral("Hall 😀")));
  }

  void whatBecameOfAChangeIsLookedForWhenItsAnswerIsLost() {
    simulator::Faults faults;
    faults.requests.push_back({simulator::FaultKind::Cut, simulator::kWrites});
    simulator::Simulator robot(paused(faults));
    QVERIFY(!robot.start());
    const std::vector<QStringList> all{
        {QStringLiteral("delete"), QStringLiteral("7"), QStringLiteral("--yes")},
        {QStringLiteral("save"), QStringLiteral("Neu")},
        {QStringLiteral("start-mapping")},
        {QStringLiteral("stop-mapping")}};
    for (const QStringList& words : all) {
      const Outcome done = run(robot, words);
      QVERIFY2(done.code == 0, qPrintable(words[0] + done.err));
    }
    QCOMPARE(changesIn(robot), int(all.size()));
  }

  void whatTheRobotDidNotDoIsNotClaimed() {
    simulator::Faults faults;
    faults.requests.push_back({simulator::FaultKind::Drop, simulator::kWrites});
    simulator::Simulator robot(paused(faults));
    QVERIFY(!robot.start());
    const std::vector<QStringList> all{
        {QStringLiteral("delete"), QStringLiteral("7"), QStringLiteral("--yes")},
        {QStringLiteral("save"), QStringLiteral("Neu")},
        {QStringLiteral("start-mapping")}};
    for (const QStringList& words : all) {
      const Outcome unknown =
          run(robot, words + QStringList{QStringLiteral("--timeout"), QStringLiteral("10")});
      QVERIFY2(unknown.code == 1, qPrintable(words[0] + unknown.err));
    }
  }
};

}  // namespace test_maps_change

MAPWRIGHT_TEST(test_maps_change, MapsChangeTest, Core)
#include "test_maps_change.moc"
