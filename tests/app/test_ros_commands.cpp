// A ROS robot on the command line: the simulated one, seen from outside.
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "program.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_ros_commands {

using namespace mapwright;

namespace {

using Ran = tests::EndedBytes;

Ran run(const QStringList& words) { return tests::Program().runForBytes(words); }

QByteArray bytesOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class RosCommandsTest : public QObject {
  Q_OBJECT

  std::unique_ptr<simulator::Simulator> robot_;

  void start(bool kabam = true, bool rosapi = true) {
    simulator::Options options;
    options.paused = true;
    options.ros.kabam = kabam;
    options.ros.rosapi = rosapi;
    robot_ = std::make_unique<simulator::Simulator>(options);
    QVERIFY(!robot_->start());
  }
  QString ros() const { return QString::fromStdString(robot_->rosAddress()); }
  QString kabam() const { return QString::fromStdString(robot_->kabamAddress()); }
  QJsonArray maps() const {
    return QJsonDocument::fromJson(run({QStringLiteral("maps"), QStringLiteral("list"),
                                        QStringLiteral("--json"), QStringLiteral("--robot"), ros()})
                                       .out)
        .array();
  }
  static QString idOf(const QJsonArray& maps, bool current) {
    for (const QJsonValue& map : maps) {
      if (map[QLatin1String("current")].toBool() == current &&
          map[QLatin1String("kind")] == QLatin1String("map"))
        return map[QLatin1String("id")].toString();
    }
    return {};
  }

 private Q_SLOTS:
  void cleanup() { robot_.reset(); }

  void twoSnapshotsAreTheSameBytes_data() {
    QTest::addColumn<bool>("rosapi");
    QTest::newRow("by rosapi") << true;
    QTest::newRow("by the usual names") << false;
  }
  void twoSnapshotsAreTheSameBytes() {
    QFETCH(bool, rosapi);
    start(true, rosapi);
    QTemporaryDir folder;
    QList<QByteArray> pictures;
    for (const char* name : {"a.png", "b.png"}) {
      const QString path = folder.filePath(QLatin1String(name));
      const Ran ran = run({QStringLiteral("snapshot"), QStringLiteral("--mode"), QStringLiteral("whole"),
                           QStringLiteral("--robot"), ros(), QStringLiteral("-o"), path});
      QVERIFY2(ran.code == 0, ran.err.constData());
      pictures << bytesOf(path);
    }
    QVERIFY(!pictures[0].isEmpty());
    QCOMPARE(pictures[0], pictures[1]);
    const QImage picture = QImage::fromData(pictures[0]);
    QSet<QRgb> colours;
    for (int x = 0; x < picture.width(); ++x) colours << picture.pixel(x, picture.height() / 2);
    QVERIFY(colours.size() > 2);
  }

  void mapsAreListedShownRenamedAndLoaded() {
    start();
    const QJsonArray before = maps();
    const QString current = idOf(before, true), other = idOf(before, false);
    QVERIFY2(!current.isEmpty() && !other.isEmpty(), QJsonDocument(before).toJson().constData());
    const Ran shown = run({QStringLiteral("maps"), QStringLiteral("show"), current, QStringLiteral("--json"),
                           QStringLiteral("--robot"), kabam()});
    QVERIFY2(shown.code == 0, shown.err.constData());
    QCOMPARE(QJsonDocument::fromJson(shown.out)[QLatin1String("waypoints")].toArray().size(), 12);
    // Of the others the robot sends no picture: the rest is told, and that one is missing.
    const Ran bare = run({QStringLiteral("maps"), QStringLiteral("show"), other, QStringLiteral("--json"),
                          QStringLiteral("--robot"), kabam()});
    QCOMPARE(bare.code, 1);
    QCOMPARE(bare.err.count('\n'), 1);
    QVERIFY2(bare.err.contains("only sends its current map"), bare.err.constData());
    const QJsonObject told = QJsonDocument::fromJson(bare.out).object();
    QCOMPARE(told[QLatin1String("id")].toString(), other);
    QVERIFY(!told[QLatin1String("name")].toString().isEmpty());
    QVERIFY(told[QLatin1String("grid")].isNull() && told.contains(QLatin1String("grid")));
    const Ran listed = run({QStringLiteral("waypoints"), QStringLiteral("list"), QStringLiteral("--map"),
                            other, QStringLiteral("--json"), QStringLiteral("--robot"), kabam()});
    QCOMPARE(told[QLatin1String("waypoints")].toArray().size(),
             QJsonDocument::fromJson(listed.out).array().size());
    const Ran for_people =
        run({QStringLiteral("maps"), QStringLiteral("show"), other, QStringLiteral("--robot"), kabam()});
    QVERIFY(for_people.code == 1 && for_people.out.contains("picture"));
    // The live map has the waypoints of the one that the robot works with.
    const Ran live = run({QStringLiteral("maps"), QStringLiteral("show"), QStringLiteral("--json"),
                          QStringLiteral("--robot"), kabam()});
    QVERIFY2(live.code == 0, live.err.constData());
    QCOMPARE(QJsonDocument::fromJson(live.out)[QLatin1String("waypoints")].toArray().size(), 12);
    const Ran renamed = run({QStringLiteral("maps"), QStringLiteral("rename"), other, QStringLiteral("Attic"),
                             QStringLiteral("--robot"), kabam()});
    QVERIFY2(renamed.code == 0, renamed.err.constData());
    const Ran loaded =
        run({QStringLiteral("maps"), QStringLiteral("load"), other, QStringLiteral("--robot"), kabam()});
    QVERIFY2(loaded.code == 0, loaded.err.constData());
    const Ran now = run({QStringLiteral("maps"), QStringLiteral("current"), QStringLiteral("--json"),
                         QStringLiteral("--robot"), ros()});
    QCOMPARE(QJsonDocument::fromJson(now.out)[QLatin1String("name")].toString(), QStringLiteral("Attic"));
  }

  void topicsAreListedEchoedAndCounted() {
    simulator::Options options;
    robot_ = std::make_unique<simulator::Simulator>(options);
    QVERIFY(!robot_->start());
    const auto topics = [this](const QStringList& words) {
      return run(QStringList{QStringLiteral("topics")} + words +
                 QStringList{QStringLiteral("--robot"), ros()});
    };
    const Ran listed = topics({QStringLiteral("list"), QStringLiteral("--json")});
    QVERIFY2(listed.code == 0, listed.err.constData());
    QMap<QString, QJsonObject> rows;
    for (const QJsonValue& row : QJsonDocument::fromJson(listed.out).array())
      rows[row[QLatin1String("topic")].toString()] = row.toObject();
    const QJsonObject map = rows[QStringLiteral("/map")];
    const QString type = map[QLatin1String("type")].toString();
    QVERIFY2(type == QLatin1String("nav_msgs/msg/OccupancyGrid") ||
                 type == QLatin1String("nav_msgs/OccupancyGrid"),
             listed.out.constData());
    QCOMPARE(map[QLatin1String("layers")].toArray(), QJsonArray{QStringLiteral("whole")});

    const Ran echoed = topics(
        {QStringLiteral("echo"), QStringLiteral("/odom"), QStringLiteral("--count"), QStringLiteral("3")});
    QVERIFY2(echoed.code == 0, echoed.err.constData());
    const QList<QByteArray> lines = echoed.out.trimmed().split('\n');
    QCOMPARE(lines.size(), 3);
    for (const QByteArray& line : lines)
      QVERIFY2(QJsonDocument::fromJson(line)[QLatin1String("pose")].isObject(), line.constData());
    const Ran silent = topics({QStringLiteral("echo"), QStringLiteral("/cmd_vel"), QStringLiteral("--count"),
                               QStringLiteral("1"), QStringLiteral("--timeout"), QStringLiteral("2")});
    QCOMPARE(silent.code, 1);
    QVERIFY2(silent.err.contains("/cmd_vel"), silent.err.constData());

    // What is counted is not held back to spare the network: /tf comes fifty times a second.
    const Ran counted = topics({QStringLiteral("hz"), QStringLiteral("/tf"), QStringLiteral("/cmd_vel"),
                                QStringLiteral("--seconds"), QStringLiteral("3"), QStringLiteral("--json")});
    QCOMPARE(counted.code, 1);
    const QJsonArray rates = QJsonDocument::fromJson(counted.out).array();
    QCOMPARE(rates.size(), 2);
    QVERIFY2(rates[0][QLatin1String("hz")].toDouble() > 15, counted.out.constData());
    QVERIFY(rates[0][QLatin1String("max_s")].toDouble() >= rates[0][QLatin1String("min_s")].toDouble());
    QVERIFY(rates[1][QLatin1String("hz")].isNull() && rates[1][QLatin1String("messages")].toInt() == 0);
  }

  void withoutRosapiTheListOfTopicsSaysWhatItIs() {
    start(false, false);
    const Ran listed =
        run({QStringLiteral("topics"), QStringLiteral("list"), QStringLiteral("--robot"), ros()});
    QCOMPARE(listed.code, 1);
    QVERIFY(listed.out.contains("/map"));
    QVERIFY2(listed.err.contains("rosapi"), listed.err.constData());
  }

  void aLayerIsTakenFromTheTopicThatIsNamed() {
    start(false);
    QTemporaryDir folder;
    const auto picture = [&](const QString& layers) {
      const QString path = folder.filePath(QStringLiteral("a.png"));
      const Ran ran = run({QStringLiteral("snapshot"), QStringLiteral("--mode"), QStringLiteral("whole"),
                           QStringLiteral("--robot"), ros(), QStringLiteral("-o"), path,
                           QStringLiteral("--layers"), layers});
      return std::pair(ran, bytesOf(path));
    };
    const auto [usual, usual_bytes] = picture(QStringLiteral("costmap"));
    QVERIFY2(usual.code == 0, usual.err.constData());
    const auto [chosen, chosen_bytes] = picture(QStringLiteral("costmap=/local_costmap/costmap"));
    QVERIFY2(chosen.code == 0, chosen.err.constData());
    QVERIFY(chosen_bytes != usual_bytes);
    const auto [absent, absent_bytes] = picture(QStringLiteral("costmap=/nowhere"));
    QCOMPARE(absent.code, 1);
    QVERIFY2(absent.err.contains("/local_costmap/costmap"), absent.err.constData());
    const auto [wrong, wrong_bytes] = picture(QStringLiteral("grid=/map"));
    QCOMPARE(wrong.code, 2);
    QVERIFY2(wrong.err.contains("costmap"), wrong.err.constData());
    // A layer that no topic fills says so.
    const auto [empty, empty_bytes] = picture(QStringLiteral("trajectory"));
    QCOMPARE(empty.code, 0);
    QVERIFY2(empty.err.contains("trajectory"), empty.err.constData());
  }

  // Transforms come in any order: none of it makes another frame of the map.
  void noWaypointIsLeftOutOfAPictureOfAllLayers() {
    start();
    QTemporaryDir folder;
    const QString report = folder.filePath(QStringLiteral("r.json"));
    const Ran ran = run({QStringLiteral("snapshot"), QStringLiteral("--mode"), QStringLiteral("whole"),
                         QStringLiteral("--layers"), QStringLiteral("all"), QStringLiteral("--robot"),
                         kabam(), QStringLiteral("-o"), folder.filePath(QStringLiteral("a.png")),
                         QStringLiteral("--report"), report});
    QVERIFY2(ran.code == 0, ran.err.constData());
    const QByteArray told = bytesOf(report);
    QVERIFY2(!told.isEmpty() && !told.contains("was left out"), told.constData());
  }

  void waypointsAreCreatedPlannedAndApplied() {
    start();
    const auto waypoints = [&](const QString& line) {
      return run(QStringList{QStringLiteral("waypoints")} + line.split(QLatin1Char(' ')) +
                 QStringList{QStringLiteral("--robot"), kabam()});
    };
    const auto json = [](const Ran& ran) { return QJsonDocument::fromJson(ran.out).object(); };
    const Ran preview = waypoints(QStringLiteral("create New --at 1,2 --dry-run --json"));
    const QJsonObject call = json(preview)[QLatin1String("calls")].toArray().first().toObject();
    QCOMPARE(call[QLatin1String("service")].toString(), QStringLiteral("create_waypoint"));
    QVERIFY(call[QLatin1String("args")].toObject().contains(QLatin1String("waypoint_info")));
    // It has no turn: the robot makes one of zero of that.
    const Ran made = waypoints(QStringLiteral("create New --at 1,2 --json"));
    QVERIFY2(made.code == 0, made.err.constData());
    QCOMPARE(json(made)[QLatin1String("x")].toDouble(), 1.0);
    // What others change meanwhile goes together with a plan.
    QTemporaryDir folder;
    const QString csv = folder.filePath(QStringLiteral("w.csv")),
                  plan = folder.filePath(QStringLiteral("p.json"));
    QVERIFY(waypoints(QStringLiteral("export -o ") + csv).code == 0);
    QFile file(csv);
    QVERIFY(file.open(QIODevice::Append));
    file.write(",Last,5,5,,,map,\r\n");
    file.close();
    QVERIFY(waypoints(QStringLiteral("plan %1 -o %2").arg(csv, plan)).code == 0);
    QVERIFY(waypoints(QStringLiteral("move New --at 3,4,90")).code == 0);
    const Ran applied = waypoints(QStringLiteral("apply --json ") + plan);
    QVERIFY2(applied.code == 0, applied.err.constData());
    QCOMPARE(json(applied)[QLatin1String("applied")].toInt(), 1);
    QCOMPARE(json(waypoints(QStringLiteral("get New --json")))[QLatin1String("x")].toDouble(), 3.0);
    const Ran twice = waypoints(QStringLiteral("create Last --at 1,2"));
    QVERIFY2(twice.code == 4 && twice.err.contains("was not changed"), twice.err.constData());
    QVERIFY(waypoints(QStringLiteral("delete New Last --yes")).code == 0);
  }

  void whatItDoesNotKeepIsLeftOutWithAWordAndNotSentAgain() {
    start();
    const auto waypoints = [&](const QString& line) {
      return run(QStringList{QStringLiteral("waypoints")} + line.split(QLatin1Char(' ')) +
                 QStringList{QStringLiteral("--robot"), kabam()});
    };
    const auto json = [](const Ran& ran) { return QJsonDocument::fromJson(ran.out).object(); };
    QTemporaryDir folder;
    const QString csv = folder.filePath(QStringLiteral("w.csv")),
                  plan = folder.filePath(QStringLiteral("p.json"));
    QFile file(csv);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("name,x,y,yaw_rad,type\r\nShelf,5,5,,rack\r\n");
    file.close();
    const Ran planned = waypoints(QStringLiteral("import %1 --dry-run --json").arg(csv));
    const QJsonObject change = json(planned)[QLatin1String("changes")].toArray().first().toObject();
    QVERIFY2(!change.contains(QLatin1String("type")), planned.out.constData());
    QCOMPARE(change[QLatin1String("yaw_rad")], QJsonValue(0.0));
    for (const char* word : {"Waypoint types cannot be stored here", "Every waypoint needs a heading here"})
      QVERIFY2(planned.err.contains(word), planned.err.constData());
    const Ran imported = waypoints(QStringLiteral("import --json ") + csv);
    QVERIFY2(imported.code == 0, (imported.out + imported.err).constData());
    QCOMPARE(json(imported)[QLatin1String("applied")].toInt(), 1);
    const Ran again = waypoints(QStringLiteral("import --json ") + csv);
    QCOMPARE(json(again)[QLatin1String("applied")].toInt(-1), 0);
    QCOMPARE(again.code, 0);
  }

  void aNameTwiceIsNotSent() {
    start();
    const auto waypoints = [&](const QString& line) {
      return run(QStringList{QStringLiteral("waypoints")} + line.split(QLatin1Char(' ')) +
                 QStringList{QStringLiteral("--robot"), kabam()});
    };
    QCOMPARE(waypoints(QStringLiteral("create Twice --at 1,2")).code, 0);
    const Ran shown = waypoints(QStringLiteral("create Twice --at 3,4 --dry-run --json"));
    QCOMPARE(QJsonDocument::fromJson(shown.out)[QLatin1String("calls")].toArray().size(), 0);
    const QJsonArray refused = QJsonDocument::fromJson(shown.out)[QLatin1String("refused")].toArray();
    QCOMPARE(refused.first()[QLatin1String("name")].toString(), QStringLiteral("Twice"));
    const Ran told = waypoints(QStringLiteral("create Twice --at 3,4 --dry-run"));
    QVERIFY2(told.out.contains("1 waypoint is not sent"), told.out.constData());
    QTemporaryDir folder;
    const QString csv = folder.filePath(QStringLiteral("w.csv"));
    QFile file(csv);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("id,name,x,y\r\n,Fresh,5,5\r\nnone,Twice,6,6\r\n");
    file.close();
    const QString plan = folder.filePath(QStringLiteral("p.json"));
    const Ran whole = waypoints(QStringLiteral("import ") + csv);
    QCOMPARE(whole.code, 0);  // it is found by its name
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("id,name,x,y\r\n,Fresh 2,5,5\r\n,Fresh 3,6,6\r\n,Fresh 3,7,7\r\n");
    file.close();
    const Ran none = waypoints(QStringLiteral("import --json ") + csv);
    QCOMPARE(none.code, 4);
    const QJsonObject sent = QJsonDocument::fromJson(none.out).object();
    QCOMPARE(sent[QLatin1String("applied")].toInt(-1), 0);
    QCOMPARE(sent[QLatin1String("failed")].toArray().size(), 2);
    QCOMPARE(sent[QLatin1String("remaining")].toInt(-1), 1);
    const Ran others = waypoints(QStringLiteral("import --go-on --json ") + csv);
    QCOMPARE(QJsonDocument::fromJson(others.out)[QLatin1String("applied")].toInt(-1), 1);
  }

  void aRobotWhoseOnlyMapDoesNotComeSaysSo() {
    simulator::Options options;
    options.paused = true;
    options.ros.kabam = false;
    options.faults.silent = {"/map"};
    options.faults.requests.push_back(
        {simulator::FaultKind::Refuse, simulator::kServices, 1, 0, "/static_map"});
    robot_ = std::make_unique<simulator::Simulator>(options);
    QVERIFY(!robot_->start());
    QTemporaryDir folder;
    const Ran ran =
        run({QStringLiteral("snapshot"), QStringLiteral("--timeout"), QStringLiteral("20"),
             QStringLiteral("--robot"), ros(), QStringLiteral("-o"), folder.filePath(QStringLiteral("a.png")),
             QStringLiteral("--report"), folder.filePath(QStringLiteral("r.json"))});
    QCOMPARE(ran.code, 4);
    QVERIFY2(ran.err.contains("It is sending no map at the moment. Topic /static_map: "),
             ran.err.constData());
    QVERIFY(bytesOf(folder.filePath(QStringLiteral("r.json"))).size() < 10'000);
  }

  void aPictureOfWhatCameInTimeIsComplete() {
    start(false);
    QTemporaryDir folder;
    const Ran ran = run({QStringLiteral("snapshot"), QStringLiteral("--settle"), QStringLiteral("3"),
                         QStringLiteral("--robot"), ros(), QStringLiteral("-o"),
                         folder.filePath(QStringLiteral("a.png"))});
    QVERIFY2(ran.code == 0, ran.err.constData());
  }

  void aRobotWithoutAMapManagerHasItsLiveMap() {
    start(false);
    const QJsonArray list = maps();
    QCOMPARE(list.size(), 1);
    QCOMPARE(list.first()[QLatin1String("id")].toString(), QStringLiteral("live"));
    const Ran renamed = run({QStringLiteral("maps"), QStringLiteral("rename"), QStringLiteral("m1"),
                             QStringLiteral("x"), QStringLiteral("--robot"), ros()});
    QVERIFY(renamed.code != 0 && renamed.err.contains("KABAM"));
    const Ran insisting =
        run({QStringLiteral("maps"), QStringLiteral("list"), QStringLiteral("--robot"), kabam()});
    QCOMPARE(insisting.code, 3);
    QVERIFY(insisting.err.contains("/map_manager"));
  }
};

}  // namespace test_ros_commands

MAPWRIGHT_TEST(test_ros_commands, RosCommandsTest, Core)
#include "test_ros_commands.moc"
