// `overlays get|set|plan|validate`: what a script sees, and what the robot holds afterwards.
#include <memory>

#include <QDir>
#include <QTest>

#include "program.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_overlays_command {

using namespace mapwright;
using tests::Ended;

class OverlaysCommandTest : public QObject {
  Q_OBJECT
  std::unique_ptr<simulator::Simulator> robot_;
  std::unique_ptr<tests::Program> program_;

  void start(const simulator::Faults& faults = {}) {
    simulator::Options options;
    options.paused = true;
    options.faults = faults;
    robot_ = std::make_unique<simulator::Simulator>(options);
    QVERIFY(!robot_->start());
  }
  /// Words without blanks in them.
  Ended run(const char* words, const QByteArray& input = {}) const {
    return program_->run(
        QStringList{QStringLiteral("overlays")} + QString::fromLatin1(words).split(QLatin1Char(' ')) +
            QStringList{QStringLiteral("--robot"), QString::fromStdString(robot_->address())},
        input);
  }
  /// What the robot holds, edited.
  QByteArray edited(const QByteArray& from, const QByteArray& to) const {
    QByteArray text = program_->bytes("base.geojson");
    if (!text.contains(from)) qFatal("%s is not in it", from.constData());
    return text.replace(from, to);
  }
  QByteArray held() const { return run("get -o -").out.toUtf8(); }
  int changes() const {
    int changes = 0;
    for (const auto& record : robot_->requestLog()) changes += record.method == "GET" ? 0 : 1;
    return changes;
  }

 private Q_SLOTS:
  void init() {
    start();
    program_ = std::make_unique<tests::Program>();
    QCOMPARE(run("get -o base.geojson").code, 0);
  }

  void whatIsReadIsWhatTheRobotKeeps() {
    const QByteArray text = program_->bytes("base.geojson");
    QVERIFY(text.contains("FeatureCollection") && text == held());
    const Ended again = run("get -o base.geojson");
    QCOMPARE(again.code, 2);
    QVERIFY(again.err.contains(QStringLiteral("--force")));
    QCOMPARE(run("get -o base.geojson --force").code, 0);
  }

  void withoutAnyAnEmptyCollectionIsWrittenThatCanBeSet() {
    program_->put("none.pgm", "P5\n2 2\n255\n" + QByteArray(4, char(254)));
    program_->put("none.yaml",
                  "image: none.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
                  "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
    const auto on_file = [&](const char* words) {
      return program_->run(QString::fromLatin1(words).split(QLatin1Char(' ')));
    };
    const Ended got = on_file("overlays get -o none.geojson --robot none.yaml");
    QCOMPARE(got.code, 0);
    QCOMPARE(got.out, QStringLiteral("none.geojson: 0 features\n"));
    QCOMPARE(program_->bytes("none.geojson"),
             QByteArray("{\"type\":\"FeatureCollection\",\"features\":[]}\n"));
    QCOMPARE(on_file("overlays get -o - --robot none.yaml").out.toUtf8(), program_->bytes("none.geojson"));
    QVERIFY(on_file("overlays set none.geojson --base none.geojson --json --robot none.yaml")
                .object()[QStringLiteral("conflicts")]
                .toArray()
                .isEmpty());
    QByteArray one = program_->bytes("none.geojson");
    one.replace("[]", R"([{"type":"Feature","id":"a","geometry":{"type":"Point","coordinates":[0.05,0.05]},)"
                      R"("properties":{"type":11}}])");
    program_->put("one.geojson", one);
    const Ended set = on_file("overlays set one.geojson --base none.geojson --json --robot none.yaml");
    QVERIFY2(set.code == 0, qPrintable(set.err + set.out));
    QCOMPARE(set.object()[QStringLiteral("theirs")].toInt(), 0);
    QVERIFY(on_file("overlays get -o - --robot none.yaml").out.contains(QStringLiteral("\"id\":\"a\"")));
  }

  void aFileThatCannotBeReadIsExitCodeTwo() {
    program_->put("broken.pgm", "P5\n2 2\n255\n" + QByteArray(4, char(254)));
    program_->put("broken.yaml",
                  "image: broken.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
                  "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
    QVERIFY(QDir().mkdir(program_->path("broken.overlays.geojson")));
    const Ended ended =
        program_->run(QStringLiteral("overlays get -o - --robot broken.yaml").split(QLatin1Char(' ')));
    QVERIFY2(ended.code == 2 && ended.err.contains(QLatin1String("broken.overlays.geojson")),
             qPrintable(ended.err));
  }

  void onlyWhatWasEditedIsChanged() {
    program_->put("mine.geojson", edited("\"Virtual wall\"", "\"Wall <b>17</b> 😀\""));
    const Ended plan = run("plan mine.geojson --base base.geojson --json");
    QCOMPARE(plan.code, 0);
    QCOMPARE(plan.object()[QStringLiteral("applied")], QJsonValue(false));
    QCOMPARE(changes(), 0);
    const Ended set = run("set mine.geojson --base base.geojson --json");
    QVERIFY2(set.code == 0, qPrintable(set.err));
    const QJsonObject done = set.object();
    QCOMPARE(done[QStringLiteral("applied")], QJsonValue(true));
    QCOMPARE(done[QStringLiteral("changes")].toArray().size(), 1);
    QCOMPARE(done[QStringLiteral("changes")][0][QStringLiteral("kind")].toString(), QStringLiteral("change"));
    QCOMPARE(done[QStringLiteral("version")].toInt(), 6);
    QStringList asked;
    for (const auto& record : robot_->requestLog()) {
      if (record.target == "/maps/1") asked << QString::fromStdString(record.method);
    }
    asked = asked.mid(asked.indexOf(QStringLiteral("PATCH")) - 1);
    QCOMPARE(asked, (QStringList{QStringLiteral("GET"), QStringLiteral("PATCH"), QStringLiteral("GET")}));
    QCOMPARE(held(), program_->bytes("mine.geojson"));
    QCOMPARE(changes(), 1);
    const Ended nothing = run("set mine.geojson --base base.geojson");
    QVERIFY2(nothing.code == 0, qPrintable(nothing.err));
    QCOMPARE(changes(), 1);
  }

  void whatStandsAroundTheDocumentStaysWhereAMemberOfItIsChanged() {
    const QByteArray base = "\n {\"type\":\"FeatureCollection\",\"crs\":1.50,\"features\":[ ]}\r\n";
    program_->put("mine.geojson", base);
    QCOMPARE(run("set mine.geojson --replace --yes").code, 0);
    program_->put("base.geojson", base);
    program_->put("mine.geojson", edited("1.50", "9.0"));
    QCOMPARE(run("set mine.geojson --base base.geojson").code, 0);
    QCOMPARE(program_
                 ->run({QStringLiteral("overlays"), QStringLiteral("get"), QStringLiteral("--force"),
                        QStringLiteral("-o"), QStringLiteral("held.geojson"), QStringLiteral("--robot"),
                        QString::fromStdString(robot_->address())})
                 .code,
             0);
    QCOMPARE(program_->bytes("held.geojson"), program_->bytes("mine.geojson"));
  }

  void whatOthersChangedStaysOrIsAConflict() {
    program_->put("theirs.geojson", edited("\"Virtual wall\"", "\"Theirs\""));
    QCOMPARE(run("set theirs.geojson --base base.geojson").code, 0);
    program_->put("mine.geojson", edited("\"Charger\"", "\"Lader\""));
    const Ended merged = run("set mine.geojson --base base.geojson --json");
    QCOMPARE(merged.code, 0);
    QCOMPARE(merged.object()[QStringLiteral("theirs")].toInt(), 1);
    QVERIFY(held().contains("\"Theirs\"") && held().contains("\"Lader\""));
    program_->put("clash.geojson", edited("\"Virtual wall\"", "\"Mine\""));
    const int before = changes();
    const Ended clash = run("set clash.geojson --base base.geojson --json");
    QCOMPARE(clash.code, 4);
    const QJsonObject conflict = clash.object()[QStringLiteral("conflicts")][0].toObject();
    QCOMPARE(conflict[QStringLiteral("property")].toString(), QStringLiteral("properties.name"));
    QCOMPARE(conflict[QStringLiteral("base")].toString(), QStringLiteral("Virtual wall"));
    QCOMPARE(conflict[QStringLiteral("mine")].toString(), QStringLiteral("Mine"));
    QCOMPARE(conflict[QStringLiteral("theirs")].toString(), QStringLiteral("Theirs"));
    QVERIFY(clash.err.contains(QStringLiteral("1 conflict ")));
    QCOMPARE(changes(), before);
  }

  void withoutABaseOnlyOnRequest() {
    const QByteArray none = R"({"type":"FeatureCollection","features":[]})";
    program_->put("mine.geojson", none);
    QCOMPARE(run("set mine.geojson").code, 2);
    QCOMPARE(run("set mine.geojson --base base.geojson --replace").code, 2);
    QCOMPARE(run("set mine.geojson --replace --dry-run").code, 0);
    QCOMPARE(changes(), 0);
    const Ended set = run("set - --replace --yes", none);
    QCOMPARE(set.code, 0);
    QVERIFY(set.out.contains(QStringLiteral("remove")) && set.out.contains(QStringLiteral("Delete charger")));
    QCOMPARE(held(), none);
  }

  void whatDeletesMoreThanItKeepsWantsAYes() {
    const QByteArray none = R"({"type":"FeatureCollection","features":[]})";
    for (const char* words : {"set - --replace", "set - --base base.geojson"}) {
      const Ended refused = run(words, none);
      QCOMPARE(refused.code, 2);
      QVERIFY2(refused.err.contains(QStringLiteral("Nothing was sent: this deletes ")) &&
                   refused.err.contains(QStringLiteral("Pass --yes")),
               qPrintable(refused.err));
    }
    QCOMPARE(run("set - --replace --json", none).object()[QStringLiteral("applied")], QJsonValue(false));
    QCOMPARE(changes(), 0);
    QCOMPARE(run("set - --base base.geojson --dry-run", none).code, 0);
    QCOMPARE(run("set - --base base.geojson --yes", none).code, 0);
    QVERIFY(!held().contains("\"Charger\""));
  }

  void anEmptyOrStrangeFileDeletesNothing() {
    for (const char* text :
         {"", " \n", "null", "{}", "[]", "[{}]", "{\"features\":[]}", "{\"type\":\"FeatureCollection\"}",
          "{\"type\":\"FeatureCollection\",\"features\":null}", "{\"type\":\"Topology\",\"features\":[]}",
          "{\"type\":\"FeatureCollection\",\"features\":[1]}"}) {
      for (const char* words :
           {"set - --base base.geojson", "set - --replace", "plan - --base base.geojson"}) {
        const Ended ended = run(words, text);
        QVERIFY2(ended.code == 2, text);
      }
    }
    QCOMPARE(run("validate -", "").code, 2);
    QCOMPARE(changes(), 0);
  }

  void whatIsNoGeoJsonIsRefusedWithItsPlace() {
    program_->put("mine.geojson", "{\"features\":[\n{]}");
    for (const char* words : {"set mine.geojson --base base.geojson", "set base.geojson --base mine.geojson",
                              "set mine.geojson --replace", "validate mine.geojson"}) {
      const Ended ended = run(words);
      QVERIFY2(ended.code == 2, words);
      QVERIFY2(ended.err.contains(QStringLiteral("line 2, column 2"), Qt::CaseInsensitive),
               qPrintable(ended.err));
    }
    QCOMPARE(changes(), 0);
    QCOMPARE(run("set none.geojson --replace").code, 2);
  }

  void whatSomebodyElseDoesAtTheSameMomentIsSaid() {
    simulator::Faults faults;
    faults.overlay_edit_before_writes = true;
    start(faults);
    program_->put("mine.geojson", edited("\"Charger\"", "\"Lader\""));
    const Ended between = run("set mine.geojson --base base.geojson");
    QCOMPARE(between.code, 1);
    QVERIFY2(between.err.contains(
                 QStringLiteral("Someone else changed the overlays while they were being saved")) &&
                 between.err.contains(QStringLiteral("overwritten")),
             qPrintable(between.err));
    QVERIFY(held().contains("\"Lader\"") && !held().contains("Somebody"));
  }

  void whatTheRobotOnlySaysThatItDidIsNotDone() {
    simulator::Faults faults;
    faults.requests.push_back({simulator::FaultKind::Ignore, simulator::kWrites});
    start(faults);
    program_->put("mine.geojson", edited("\"Charger\"", "\"Lader\""));
    const Ended ignored = run("set mine.geojson --base base.geojson --json");
    QCOMPARE(ignored.code, 1);
    QVERIFY2(ignored.err.contains(QStringLiteral("has something other than what was sent")),
             qPrintable(ignored.err));
    QCOMPARE(ignored.object()[QStringLiteral("applied")], QJsonValue(false));
    // It may do it a moment later.
    QVERIFY2(ignored.err.contains(QStringLiteral("may still make it")), qPrintable(ignored.err));
    QVERIFY(held().contains("\"Charger\""));
  }

  void whatSomebodyElseDidBeforeIsMerged() {
    simulator::Faults faults;
    faults.overlay_edit_every_s = 1;
    start(faults);
    program_->put("mine.geojson", edited("\"Charger\"", "\"Lader\""));
    QTRY_VERIFY_WITH_TIMEOUT(held().contains("Somebody"), 20'000);
    const Ended merged = run("set mine.geojson --base base.geojson");
    QVERIFY2(merged.code == 0 || merged.code == 1, qPrintable(merged.err));  // 1: again at that very moment
    QVERIFY(held().contains("\"Lader\"") && held().contains("Somebody"));
  }

  void whatBecameOfALostChangeIsLookedFor() {
    simulator::Faults faults;
    faults.requests.push_back({simulator::FaultKind::Cut, simulator::kWrites});
    start(faults);
    program_->put("mine.geojson", edited("\"Charger\"", "\"Lader\""));
    const Ended lost = run("set mine.geojson --base base.geojson");
    QVERIFY2(lost.code == 0, qPrintable(lost.err));
    faults.requests = {{simulator::FaultKind::Drop, simulator::kWrites}};
    start(faults);
    const Ended dropped = run("set mine.geojson --base base.geojson --timeout 10");
    QVERIFY2(dropped.code == 1, qPrintable(dropped.err));
    QVERIFY(held().contains("\"Charger\""));
    faults.requests = {{simulator::FaultKind::Refuse, simulator::kWrites}};
    start(faults);
    QCOMPARE(run("set mine.geojson --base base.geojson").code, 1);  // it may have been made all the same
  }

  void flawsAreFoundInAFileAndOnTheRobot() {
    const Ended robot = run("validate --json");
    QCOMPARE(robot.code, 1);
    QCOMPARE(robot.array().size(), 1);  // a polygon without points is among the robot's oddities
    QCOMPARE(robot.array()[0][QStringLiteral("rule")].toString(), QStringLiteral("too_few_points"));
    QCOMPARE(run("validate --off too_few_points").code, 0);
    QCOMPARE(run("validate --off nonsense").code, 2);
    program_->put(
        "mine.geojson",
        R"({"type":"FeatureCollection","features":[{"id":"a","geometry":{"type":"Point","coordinates":[1e6,0]},
                                                   "properties":{"type":25}},{"id":"a"}]})");
    const QJsonArray flaws = run("validate mine.geojson --json").array();
    QCOMPARE(flaws.size(), 2);
    QCOMPARE(flaws[0][QStringLiteral("rule")].toString(), QStringLiteral("outside_map"));
    QCOMPARE(flaws[0][QStringLiteral("at")][0].toDouble(), 1e6);
    QCOMPARE(flaws[1][QStringLiteral("rule")].toString(), QStringLiteral("duplicate_id"));
    const Ended alone = program_->run({QStringLiteral("overlays"), QStringLiteral("validate"),
                                       QStringLiteral("mine.geojson"), QStringLiteral("--json")});
    QCOMPARE(alone.code, 1);
    QCOMPARE(alone.array().size(), 1);
  }

  void onAMapThatBreaksOffWallsAreNotChecked() {
    simulator::Faults faults;
    faults.truncated_maps = true;
    start(faults);
    const Ended ended = run("validate --off too_few_points --report report.json");
    QCOMPARE(ended.code, 1);
    QVERIFY2(ended.err.startsWith(QLatin1String("Incomplete. ")) &&
                 ended.err.contains(QLatin1String("Walls and reachability were not checked.")),
             qPrintable(ended.err));
    const QJsonObject report = QJsonDocument::fromJson(program_->bytes("report.json")).object();
    QCOMPARE(report[QStringLiteral("complete")], QJsonValue(false));
  }

  void versionsAreKeptShownAndBroughtBack() {
    program_->put("mine.geojson", edited("\"Charger\"", "\"Lader\""));
    QCOMPARE(run("set mine.geojson --base base.geojson").code, 0);
    const QJsonArray kept = run("history list --json").array();
    QCOMPARE(kept.size(), 2);  // read and saved; what was read twice is kept once
    QCOMPARE(kept[0][QStringLiteral("kept")].toString(), QStringLiteral("saved"));
    QCOMPARE(kept[0][QStringLiteral("version")].toInt(), 6);
    QCOMPARE(kept[1][QStringLiteral("version")].toInt(), 5);
    robot_->stop();  // all of this needs no robot
    const auto history = [&](const char* words) {
      return program_->run(QStringList{QStringLiteral("overlays"), QStringLiteral("history")} +
                           QString::fromLatin1(words).split(QLatin1Char(' ')));
    };
    QCOMPARE(history("list --json").array().size(), 2);
    QCOMPARE(history("list --map 1 --json").array().size(), 2);
    QCOMPARE(history("list --map 99 --json").array().size(), 0);
    QCOMPARE(history("list --robot axbot+http://10.0.0.1:8090 --json").array().size(), 0);
    const Ended shown = history("show 2");
    QVERIFY2(shown.out.contains(QStringLiteral("Lader")) && !shown.out.contains(QStringLiteral("Table")),
             qPrintable(shown.out));
    QCOMPARE(history("show 1 -o first.geojson").code, 0);
    QCOMPARE(program_->bytes("first.geojson"), program_->bytes("base.geojson"));
    QCOMPARE(history("show 1 -o first.geojson").code, 2);
    for (const char* number : {"show 3", "show x", "show -1", "show 99999999999999999999"})
      QCOMPARE(history(number).code, 2);
    start();
    QCOMPARE(run("set mine.geojson --base base.geojson").code, 0);
    const Ended dry = run("history restore 1 --dry-run --json");
    QCOMPARE(dry.object()[QStringLiteral("changes")].toArray().size(), 1);
    QVERIFY(held().contains("\"Lader\""));
    const Ended back = run("history restore 1");
    QVERIFY2(back.code == 0, qPrintable(back.err));
    QCOMPARE(held(), program_->bytes("base.geojson"));
  }

  void whatCannotBeKeptIsSaidAndStopsNothing() {
    QFile::remove(program_->path("data/mapwright/overlays.sqlite"));
    program_->put("data/mapwright/overlays.sqlite",
                  "no database, but quite long enough to be looked at as one");
    const Ended read = run("get -o again.geojson");
    QCOMPARE(read.code, 0);
    QVERIFY2(read.err.contains(QStringLiteral("overlays.sqlite")), qPrintable(read.err));
    QCOMPARE(program_->bytes("again.geojson"), program_->bytes("base.geojson"));
  }

  void aMapThatIsNotThereIsSaid() {
    QCOMPARE(run("get --map 99 -o x.geojson").code, 4);
    QVERIFY(program_->bytes("x.geojson").isEmpty());
    for (const char* id : {"mapping:1", "../1", "1/", "%31"})
      QVERIFY2(run((QByteArray("get -o x.geojson --map ") + id).constData()).code == 2, id);
    const Ended other = program_->run(
        {QStringLiteral("overlays"), QStringLiteral("get"), QStringLiteral("-o"), QStringLiteral("x.geojson"),
         QStringLiteral("--robot"), QString::fromStdString(robot_->kabamAddress())});
    QCOMPARE(other.code, 4);
    QVERIFY2(other.err.contains(QStringLiteral("overlays")), qPrintable(other.err));
  }
};

}  // namespace test_overlays_command

MAPWRIGHT_TEST(test_overlays_command, OverlaysCommandTest, Core)
#include "test_overlays_command.moc"
