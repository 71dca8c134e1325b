// `mapwright waypoints …` on a simulated KABAM robot, with another operator, links that break off and a topic
// that lags.
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "program.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_kabam_waypoints {

using namespace mapwright;

namespace {

using Outcome = tests::Ended;

QJsonValue at(const QJsonValue& row, const char* member) { return row[QLatin1String(member)]; }

}  // namespace

class KabamWaypointsTest : public QObject {
  Q_OBJECT
  std::unique_ptr<tests::Program> program_;
  std::unique_ptr<simulator::Simulator> robot_;

  void start(const std::function<void(simulator::Options&)>& change = {}) {
    simulator::Options options;
    options.paused = true;
    if (change) change(options);
    robot_ = std::make_unique<simulator::Simulator>(options);
    QVERIFY(!robot_->start());
  }
  Outcome run(const QStringList& words) const {
    return program_->run(
        QStringList{QStringLiteral("waypoints")} + words +
        QStringList{QStringLiteral("--robot"), QString::fromStdString(robot_->kabamAddress())});
  }
  Outcome run(const char* words) const { return run(QString::fromLatin1(words).split(QLatin1Char(' '))); }
  QJsonArray listed() const { return run("list --json").array(); }
  void put(const char* name, const QByteArray& bytes) const { program_->put(name, bytes); }
  /// A plan in which the first three go by each other's names.
  void planRing(const QJsonArray& rows) const {
    QByteArray csv = "id,name,x,y,yaw_rad\n";
    for (int i = 0; i < rows.size(); ++i) {
      const QJsonValue named = i < 3 ? rows[(i + 1) % 3] : rows[i];
      csv += at(rows[i], "id").toString().toUtf8() + ',' + at(named, "name").toString().toUtf8() + ',' +
             QByteArray::number(at(rows[i], "x").toDouble(), 'g', 17) + ',' +
             QByteArray::number(at(rows[i], "y").toDouble(), 'g', 17) + ',' +
             QByteArray::number(at(rows[i], "yaw_rad").toDouble(), 'g', 17) + '\n';
    }
    put("ring.csv", csv);
    const Outcome plan = run("plan ring.csv -o plan.json --force");
    QVERIFY2(plan.code == 0, qPrintable(plan.err));
  }
  static QStringList namesOf(const QJsonArray& rows) {
    QStringList names;
    for (const QJsonValue& row : rows) names << at(row, "name").toString();
    return names;
  }
  int timesCalled(const std::string& services) const {
    int times = 0;
    for (const simulator::RequestRecord& one : robot_->requestLog())
      times += one.method == "CALL" && one.target.ends_with(services) ? 1 : 0;
    return times;
  }

 private Q_SLOTS:
  void init() { program_ = std::make_unique<tests::Program>(); }
  void cleanup() { robot_.reset(); }

  // Each call is the last one of its link.
  void aSwapOfNamesThatBreaksOffIsToldAndGoneOnWith() {
    start();
    const QJsonArray before = listed();
    planRing(before);
    const QStringList old = namesOf(before);
    simulator::Faults faults;
    faults.requests.push_back(
        {simulator::FaultKind::Cut, simulator::kServices, 1, 0, "/map_manager/rename_waypoint"});
    robot_->setFaults(faults);
    Outcome applied;
    int attempts = 0;
    for (; attempts < 6 && applied.code != 0; ++attempts) {
      applied = run("apply plan.json --json");
      QVERIFY2(applied.code == 0 || applied.code == 1, qPrintable(applied.err));
      const QJsonArray told = applied.object()[QStringLiteral("temporary_names")].toArray();
      QStringList temporary;
      for (const QString& name : namesOf(listed()))
        if (!old.contains(name)) temporary << name;
      QCOMPARE(namesOf(told), temporary);
      for (const QString& name : temporary) QVERIFY2(applied.err.contains(name), qPrintable(applied.err));
      if (!temporary.isEmpty()) {
        const Outcome list = run("list");
        QVERIFY2(list.code == 0 && list.err.contains(temporary.first()), qPrintable(list.err));
      }
    }
    QCOMPARE(attempts, 4);  // as many as there are calls
    QStringList wanted = old;
    wanted.move(0, 2);
    QCOMPARE(namesOf(listed()), wanted);
  }

  void whatIsAppliedOrImportedTwiceIsNotSentAgain() {
    start();
    const QJsonArray before = listed();
    QByteArray csv = "id,name,x,y,yaw_rad\n";
    for (int i = 0; i < 8; ++i)
      csv += at(before[i], "id").toString().toUtf8() + ",Point " + QByteArray::number(i) + "," +
             QByteArray::number(0.1 * i) + "," + QByteArray::number(i / 3.0, 'g', 17) + "," +
             QByteArray::number(0.3 + i * 0.4, 'g', 17) + "\n";
    put("turned.csv", csv);
    QCOMPARE(run("import turned.csv").code, 0);
    robot_->clearRequestLog();
    const Outcome again = run("import turned.csv");
    QVERIFY2(again.code == 0 && again.out.contains(QStringLiteral("nothing to change")),
             qPrintable(again.out));
    QCOMPARE(timesCalled("rename_waypoint") + timesCalled("reposition_waypoint"), 0);

    put("two.csv", "id,name,x,y,yaw_rad\n" + at(before[0], "id").toString().toUtf8() + ",One,1,1,0.7\n");
    QVERIFY(run("plan two.csv -o plan.json --force").code == 0);
    QCOMPARE(run("apply plan.json").code, 2);  // it deletes nearly all
    QCOMPARE(namesOf(listed()).size(), before.size());
    QCOMPARE(run("apply plan.json --yes").code, 0);
    const Outcome twice = run("apply plan.json");
    QVERIFY2(twice.code == 0, qPrintable(twice.err));
  }

  // What others did and the topic has not told is there before anything is sent over it.
  void whatOthersDidAndTheTopicDoesNotTellYetStays() {
    start([](simulator::Options& options) { options.faults.ros.waypoints_lag_ms = 600'000; });
    const QJsonArray before = listed();
    const QString first = at(before.first(), "id").toString(), last = at(before.last(), "id").toString();
    robot_->otherOperator();      // another name for the first
    robot_->otherOperator();      // another place for the last
    QVERIFY(listed() != before);  // the manager was asked
    const Outcome moved = run({QStringLiteral("move"), first, QStringLiteral("--at"),
                               QStringLiteral("2,3,90"), QStringLiteral("--json")});
    QVERIFY2(moved.code == 0, qPrintable(moved.err));
    QCOMPARE(at(moved.object(), "name").toString(), QStringLiteral("Renamed by others 1"));
    QCOMPARE(at(moved.object(), "x").toDouble(), 2.0);
    const Outcome renamed =
        run({QStringLiteral("rename"), last, QStringLiteral("Mine"), QStringLiteral("--json")});
    QVERIFY2(renamed.code == 0, qPrintable(renamed.err));
    QCOMPARE(at(renamed.object(), "name").toString(), QStringLiteral("Mine"));
    QVERIFY(at(renamed.object(), "x") != at(before.last(), "x"));
    QCOMPARE(at(renamed.object(), "tags"), at(before.last(), "tags"));
  }

  // The topic stands still.
  void thePlanThatWasAppliedIsNotAppliedAgain() {
    start([](simulator::Options& options) { options.faults.ros.waypoints_lag_ms = 600'000; });
    const QJsonArray before = listed();
    QByteArray csv = "id,name,x,y\n";
    for (const QJsonValue& row : before) csv += at(row, "id").toString().toUtf8() + ",,,\n";
    put("more.csv", csv + ",One,1,1\n,Two,2,1\n,Three,3,1\n");
    QCOMPARE(run("plan more.csv -o plan.json --force").code, 0);
    for (int time = 0; time < 3; ++time) {
      const Outcome applied = run("apply plan.json --json");
      QVERIFY2(applied.code == 0, qPrintable(applied.err));
      QCOMPARE(applied.object()[QStringLiteral("applied")].toInt(), time == 0 ? 3 : 0);
      QCOMPARE(timesCalled("create_waypoint"), 3);
    }
    QStringList names = namesOf(before);
    names << QStringLiteral("One") << QStringLiteral("Two") << QStringLiteral("Three");
    QCOMPARE(namesOf(listed()), names);
    // Not by the list that is wanted, either.
    const Outcome imported = run("import more.csv");
    QVERIFY2(imported.out.contains(QStringLiteral("nothing to change")), qPrintable(imported.out));
  }

  void aListThatOnlyTheTopicGaveIsSaidToBePossiblyOld() {
    start([](simulator::Options& options) {
      options.faults.requests.push_back(
          {simulator::FaultKind::Refuse, simulator::kServices, 1, 0, "/map_manager/get_waypoint"});
    });
    const Outcome list = run("list");
    QCOMPARE(list.code, 0);
    QVERIFY2(list.err.contains(QStringLiteral("may be out of date")), qPrintable(list.err));
  }

  void theImageOfTheCurrentMapIsReplaced() {
    start();
    const QStringList robot{QStringLiteral("--robot"), QString::fromStdString(robot_->kabamAddress())};
    const auto maps = [&](QStringList words) {
      return program_->run(QStringList{QStringLiteral("maps")} + words + robot);
    };
    const QString id =
        maps({QStringLiteral("current"), QStringLiteral("--json")}).object()[QStringLiteral("id")].toString();
    QCOMPARE(maps({QStringLiteral("export"), id, QStringLiteral("-o"), QStringLiteral("before.png")}).code,
             0);
    QImage image(program_->path("before.png"));
    QVERIFY(!image.isNull());
    image = image.convertToFormat(QImage::Format_Grayscale8);
    for (int i = 0; i < 10; ++i) image.setPixel(20 + i, 30, qRgb(0, 0, 0));
    QVERIFY(image.save(program_->path("painted.png")));
    const auto set = [&](const char* file) {
      return maps({QStringLiteral("set-image"), id, QLatin1String(file)});
    };
    const Outcome done = set("painted.png");
    QVERIFY2(done.code == 0, qPrintable(done.err));
    QCOMPARE(maps({QStringLiteral("export"), id, QStringLiteral("-o"), QStringLiteral("after.png")}).code, 0);
    const QImage after = QImage(program_->path("after.png")).convertToFormat(QImage::Format_Grayscale8);
    QCOMPARE(after, image);
    // Of another size, of no map, and no picture at all.
    QVERIFY(image.copy(0, 0, 10, 10).save(program_->path("small.png")));
    QCOMPARE(set("small.png").code, 2);
    QCOMPARE(set("none.png").code, 2);
    QCOMPARE(
        maps({QStringLiteral("set-image"), QStringLiteral("nowhere"), QStringLiteral("painted.png")}).code,
        4);
    QCOMPARE(timesCalled("update_map_image"), 1);
  }

  void whatBothChangedIsAConflictAlsoBehindATopicThatLags() {
    start([](simulator::Options& options) { options.faults.ros.waypoints_lag_ms = 600'000; });
    QByteArray csv = "id,name\n";
    const QJsonArray before = listed();
    for (int i = 0; i < before.size(); ++i) {
      const QString name = i == 0 ? QStringLiteral("Mine") : at(before[i], "name").toString();
      csv += at(before[i], "id").toString().toUtf8() + ",\"" + name.toUtf8().replace("\"", "\"\"") + "\"\n";
    }
    put("mine.csv", csv);
    QCOMPARE(run("plan mine.csv -o plan.json --force").code, 0);
    robot_->otherOperator();
    const Outcome renamed = run("apply plan.json");
    QCOMPARE(renamed.code, 4);
    QVERIFY2(renamed.err.contains(QStringLiteral("Nothing was sent")), qPrintable(renamed.err));
    QCOMPARE(timesCalled("rename_waypoint"), 0);
  }
};

}  // namespace test_kabam_waypoints

MAPWRIGHT_TEST(test_kabam_waypoints, KabamWaypointsTest, Core)
#include "test_kabam_waypoints.moc"
