// What is in the picture and in its report: what was asked for, as it was when the picture was begun.
#include <utility>

#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonObject>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>

#include "../session/fake_robot.h"
#include "app/exit_code.h"
#include "app/snapshot_run.h"
#include "app/suite_quality.h"
#include "robot/pose_graph_source.h"
#include "test_program.h"
#include "ui/scene/layer.h"
#include "ui/scene/map_theme.h"

namespace test_snapshot_content {

using namespace mapwright;
using app::SnapshotRun;
using test::FakeRobot;
using Outcome = map::SubmapAnswer::Outcome;

namespace {

map::SubmapList listOf(int submaps, const std::string& uuid, double x = 0) {
  map::SubmapList list;
  list.uuid = uuid;
  for (int i = 0; i < submaps; ++i) {
    map::SubmapEntry entry;
    entry.id = {0, i};
    entry.version = 1;
    entry.pose = geometry::poseFromYaw(x + 0.2 * i, 0, 0);
    list.entries.push_back(entry);
  }
  return list;
}

map::GridMessage liveMap(int gray) {
  map::GridMessage message;
  message.topic = "/map_v2";
  message.grid = {40, 40, 0.05, {-1, -1, 0}};
  message.png = test::grayPicture(40, 40, gray);
  return message;
}

/// A pose graph with a loop closure of 3 m, that comes when it is told to.
class Graph : public robot::PoseGraphSource {
 public:
  robot::Call fetch(robot::OutcomeTo<std::shared_ptr<const map::PoseGraph>> reply) override {
    reply_ = std::move(reply);
    return {};
  }
  bool asked() const { return bool(reply_); }
  void come() {
    map::PoseGraph graph;
    graph.submaps = {{{0, 0}, {}}};
    graph.trajectories = {{0, {{{0, 0}, 1.7e9, {}}}}};
    graph.constraints = {{{0, 0}, {0, 0}, geometry::poseFromYaw(3, 0, 0), map::ConstraintKind::Inter, 1, 1}};
    std::exchange(reply_, {})(std::make_shared<const map::PoseGraph>(graph));
  }
  void fail() { std::exchange(reply_, {})(tl::make_unexpected(map::Failure{map::FailureKind::TimedOut})); }

 private:
  robot::OutcomeTo<std::shared_ptr<const map::PoseGraph>> reply_;
};

struct RobotWithGraph : FakeRobot {
  robot::PoseGraphSource* poseGraphSource() override { return graph; }
  robot::PoseGraphSource* graph = nullptr;
};

}  // namespace

class SnapshotContentTest : public QObject {
  Q_OBJECT
  QTemporaryDir folder_;
  FakeRobot* robot_ = nullptr;
  std::unique_ptr<SnapshotRun> run_;
  std::unique_ptr<QSignalSpy> finished_;

  app::SnapshotArguments words(const char* name) const {
    app::SnapshotArguments words;
    words.robot = "axbot+http://192.0.2.1";
    words.output = folder_.filePath(QLatin1String(name)).toStdString();
    words.size = "200x200";
    words.layers = "none";
    words.center = "0,0";
    words.scale = 0.01;
    return words;
  }
  void begin(const app::SnapshotArguments& words, const suite::Quality& quality = {},
             robot::PoseGraphSource* graph = nullptr) {
    auto robot = std::make_unique<RobotWithGraph>();
    robot->graph = graph;
    robot_ = robot.get();
    robot_->has_maps = true;
    robot_->has_topics = true;
    auto options = app::parseSnapshotOptions(words);
    QVERIFY2(options, options ? "" : qPrintable(options.error()));
    options->quality = quality;
    run_ = std::make_unique<SnapshotRun>(*options, std::move(robot));
    finished_ = std::make_unique<QSignalSpy>(run_.get(), &SnapshotRun::finished);
    run_->start();
    robot_->setPhase(robot::ConnectionPhase::Online);
    // No layer waits for what this robot does not have.
    for (const auto& [stream, topics] : test::topicNames())
      robot_->say(map::BatteryState{}, topics.first().toStdString());
  }
  int exitCode() const { return finished_->at(0).at(0).toInt(); }
  int grayInTheMiddle(const char* name) const {
    const QImage picture(folder_.filePath(QLatin1String(name)));
    return picture.isNull() ? -1 : qGray(picture.pixel(100, 100));
  }
  QByteArray bytesOf(const char* name) const {
    QFile file(folder_.filePath(QLatin1String(name)));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  QString mapId() const {
    return run_->report()[QLatin1String("map")].toObject()[QLatin1String("id")].toString();
  }
  void answerEverySubmap() {
    while (!robot_->open.empty()) robot_->answer(Outcome::Ok, 0, 90);
  }
  bool answeredAndFinished() {
    answerEverySubmap();
    return !finished_->isEmpty();
  }

 private Q_SLOTS:
  void cleanup() {
    finished_.reset();
    run_.reset();
  }

  void theMapThatWasAskedForIsDrawnWhateverComesFirst_data() {
    QTest::addColumn<QByteArray>("first");
    for (const char* first : {"live map", "list of maps", "map info", "nothing"})
      QTest::newRow(first) << QByteArray(first);
  }
  void theMapThatWasAskedForIsDrawnWhateverComesFirst() {
    QFETCH(QByteArray, first);
    app::SnapshotArguments asked = words("seven.png");
    asked.mode = "whole";
    asked.map = "7";
    asked.raw = true;
    begin(asked);
    if (first == "live map") {
      robot_->say(liveMap(10));
      robot_->say(liveMap(20));
    }
    if (first == "list of maps") robot_->answerList({FakeRobot::entry("8", true), FakeRobot::entry("7")});
    if (first == "map info") robot_->say(map::MapInfo{});
    // Long enough for a picture to be made of the wrong one.
    for (int turn = 0; turn < 50 && finished_->isEmpty(); ++turn) {
      bool turned = false;
      QTimer::singleShot(1, this, [&] { turned = true; });
      QTRY_VERIFY(turned);
    }
    QVERIFY(finished_->isEmpty());
    QCOMPARE(robot_->map_fetches.size(), std::size_t(1));
    QVERIFY(robot_->map_fetches[0].first == (map::MapKey{map::MapKind::Stored, "7"}));
    robot_->map_fetches[0].second(FakeRobot::wholeMap("7", 200));
    QTRY_VERIFY(!finished_->isEmpty());
    QCOMPARE(exitCode(), int(app::kDone));
    QCOMPARE(mapId(), QStringLiteral("7"));
    QCOMPARE(grayInTheMiddle("seven.png"), 200);
  }

  void namingALayerNeverTakesTheMapAway_data() {
    QTest::addColumn<QString>("layers");
    QTest::addColumn<QString>("mode");
    for (const char* mode : {"submaps", "whole"}) {
      for (const ui::scene::Layer layer : ui::scene::allLayers()) {
        // A map above the map hides it.
        if (ui::scene::specOf(layer).in_all && layer != ui::scene::Layer::Submaps &&
            layer != ui::scene::Layer::WholeMap)
          QTest::newRow(qPrintable(QLatin1String(mode) + QLatin1Char(' ') + ui::scene::layerName(layer)))
              << ui::scene::layerName(layer) << QString::fromLatin1(mode);
      }
    }
  }
  void namingALayerNeverTakesTheMapAway() {
    QFETCH(QString, layers);
    QFETCH(QString, mode);
    QList<int> grays;
    for (const QString& named : {QStringLiteral("none"), layers}) {
      app::SnapshotArguments asked = words("layer.png");
      asked.mode = mode.toStdString();
      asked.layers = named.toStdString();
      begin(asked);
      robot_->say(liveMap(70));
      robot_->say(listOf(1, "u"));
      answerEverySubmap();
      QTRY_VERIFY_WITH_TIMEOUT(answeredAndFinished(), 60'000);
      const QImage picture(folder_.filePath(QStringLiteral("layer.png")));
      QVERIFY(!picture.isNull());
      grays << qGray(picture.pixel(92, 108));  // beside the lines of the grid
    }
    QVERIFY2(std::abs(grays[1] - grays[0]) <= 3, qPrintable(layers));  // a label may blend in
  }

  void aRobotThatIsGoneLeavesTimeToDrawWhatHasCome() {
    app::SnapshotArguments asked = words("gone.png");
    asked.timeout_s = 2;
    begin(asked);
    robot_->say(listOf(3, "u"));
    QTRY_VERIFY(!robot_->open.empty());
    robot_->answer(Outcome::Ok, 0, 90);
    robot_->setPhase(robot::ConnectionPhase::Interrupted);
    QTRY_VERIFY(!finished_->isEmpty());
    QCOMPARE(exitCode(), int(app::kIncomplete));
    const QJsonObject report = run_->report();
    QVERIFY(!report[QLatin1String("complete")].toBool());
    QCOMPARE(report[QLatin1String("submaps")].toObject()[QLatin1String("drawn")].toInt(), 1);
    QVERIFY(report[QLatin1String("painted")].toDouble() == 1);
    QVERIFY(grayInTheMiddle("gone.png") >= 0);
    QVERIFY(
        run_->warnings().join(QLatin1Char(' ')).contains(QLatin1String("connection to the robot was lost")));
    QVERIFY(!run_->warnings().join(QLatin1Char(' ')).contains(QLatin1String("--timeout")));
  }

  void aMapThatDoesNotComeIsNotReplacedByAnother_data() {
    QTest::addColumn<bool>("raw");
    QTest::newRow("scene") << false;
    QTest::newRow("raw") << true;
  }
  void aMapThatDoesNotComeIsNotReplacedByAnother() {
    QFETCH(bool, raw);
    app::SnapshotArguments asked = words("none.png");
    asked.mode = "whole";
    asked.map = "7";
    asked.raw = raw;
    asked.timeout_s = 0.2;
    begin(asked);
    robot_->say(liveMap(10));
    QTRY_VERIFY(!finished_->isEmpty());
    QCOMPARE(exitCode(), int(app::kUnreachable));
    QVERIFY(!run_->report()[QLatin1String("complete")].toBool());
    QVERIFY(!run_->report().contains(QLatin1String("map")));
    QVERIFY(!QFile::exists(run_->options().output));  // there is nothing to draw
  }

  void whatHappensWhileThePictureIsMadeIsNotInIt_data() {
    QTest::addColumn<QByteArray>("what");
    QTest::addColumn<bool>("raw");
    for (const bool raw : {false, true}) {
      for (const char* what :
           {"a new session", "a moved pose", "a robot pose", "a live map", "a lost link"}) {
        QTest::newRow(qPrintable(QStringLiteral("%1, %2").arg(
            QLatin1String(what), raw ? QLatin1String("raw") : QLatin1String("scene"))))
            << QByteArray(what) << raw;
      }
    }
  }
  void whatHappensWhileThePictureIsMadeIsNotInIt() {
    QFETCH(QByteArray, what);
    QFETCH(bool, raw);
    QByteArray undisturbed;
    for (const bool disturb : {false, true}) {
      app::SnapshotArguments asked = words("busy.png");
      asked.size = "1500x1100";
      asked.raw = raw;
      asked.layers = raw ? "none" : "submaps,whole,robot,trail";
      begin(asked);
      connect(run_.get(), &SnapshotRun::contentChosen, this, [&] {
        if (!disturb) return;
        if (what == "a new session") robot_->say(listOf(6, "other"));
        if (what == "a moved pose") robot_->say(listOf(6, "u", 0.3));
        if (what == "a robot pose") robot_->say(map::TrackedPose{{-0.5, 0.5, 2}});
        if (what == "a live map") robot_->say(liveMap(5));
        if (what == "a lost link") robot_->setPhase(robot::ConnectionPhase::Interrupted);
      });
      robot_->say(map::TrackedPose{{0.1, 0.1, 0}});
      if (!raw) robot_->say(liveMap(180));
      robot_->say(listOf(6, "u"));
      answerEverySubmap();
      QTRY_VERIFY_WITH_TIMEOUT(!finished_->isEmpty(), 60'000);
      QCOMPARE(exitCode(), int(app::kDone));
      const QJsonObject report = run_->report();
      QVERIFY(report[QLatin1String("complete")].toBool());
      QCOMPARE(report[QLatin1String("uuid")].toString(), QStringLiteral("u"));
      const QJsonObject submaps = report[QLatin1String("submaps")].toObject();
      QCOMPARE(submaps[QLatin1String("drawn")].toInt(), 6);
      QCOMPARE(submaps[QLatin1String("listed")].toInt(), 6);
      if (!disturb) undisturbed = bytesOf("busy.png");
    }
    QVERIFY(undisturbed.size() > 100);
    QVERIFY(bytesOf("busy.png") == undisturbed);
  }

  void coloursChangeNothingElse() {
    const QRgb unknown = ui::scene::lightMapTheme().map.unknown;
    QImage normal;
    for (const char* colors : {"normal", "trajectory", "age", "version"}) {
      app::SnapshotArguments asked = words("colours.png");
      asked.mode = "submaps";
      asked.colors = colors;
      begin(asked);
      robot_->say(listOf(2, "u"));
      QTRY_VERIFY(answeredAndFinished());
      QCOMPARE(exitCode(), int(app::kDone));
      const QImage picture(folder_.filePath(QStringLiteral("colours.png")));
      if (normal.isNull()) normal = picture;
      QCOMPARE(picture.size(), normal.size());
      int observed = 0, tinted = 0;
      for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
          QCOMPARE(picture.pixel(x, y) == unknown, normal.pixel(x, y) == unknown);
          observed += picture.pixel(x, y) != unknown;
          tinted += picture.pixel(x, y) != normal.pixel(x, y);
        }
      }
      QVERIFY(observed > 100);
      QCOMPARE(tinted, QByteArray(colors) == "normal" ? 0 : observed);
    }
  }

  void aPictureThatIsNotFinishedInTimeIsWrittenAsFarAsItIs_data() {
    aMapThatDoesNotComeIsNotReplacedByAnother_data();
  }
  void aPictureThatIsNotFinishedInTimeIsWrittenAsFarAsItIs() {
    QFETCH(bool, raw);
    app::SnapshotArguments asked = words("cut.png");
    asked.size = "9000x9000";
    asked.raw = raw;
    asked.scale = 0.0005;
    asked.timeout_s = 1;
    begin(asked);
    // The main thread does nothing else until the time is over: the picture has hardly been begun then.
    connect(run_.get(), &SnapshotRun::contentChosen, this, [] { QThread::msleep(1'300); });
    robot_->say(listOf(6, "u"));
    answerEverySubmap();
    QTRY_VERIFY_WITH_TIMEOUT(!finished_->isEmpty(), 60'000);
    QVERIFY(run_->report()[QLatin1String("painted")].toDouble() < 1);
    QCOMPARE(exitCode(), int(app::kIncomplete));
    QVERIFY(!run_->report()[QLatin1String("complete")].toBool());
    QVERIFY(run_->warnings().join(QLatin1Char(' ')).contains(QStringLiteral("--timeout")));
    QVERIFY(!bytesOf("cut.png").isEmpty());
  }

  void thePoseGraphIsAwaitedWhereItIsJudged_data() {
    QTest::addColumn<bool>("comes");
    QTest::newRow("it comes") << true;
    QTest::newRow("it fails") << false;
  }
  void thePoseGraphIsAwaitedWhereItIsJudged() {
    QFETCH(bool, comes);
    const suite::Quality quality{.closures_over_m = 0.5, .disagreement_over = {}};
    Graph graph;
    begin(words("judged.png"), quality, &graph);
    robot_->say(listOf(1, "u"));
    answerEverySubmap();
    QTRY_VERIFY(graph.asked());
    QVERIFY(finished_->isEmpty());
    // A list of submaps makes the session ask again.
    const auto answered = [&] {
      if (graph.asked()) comes ? graph.come() : graph.fail();
      return answeredAndFinished();
    };
    QTRY_VERIFY_WITH_TIMEOUT(answered(), 60'000);
    QCOMPARE(exitCode(), int(app::kDone));
    std::optional<suite::Examined> examined;
    app::examine(quality, run_->session(), {}, this, [&](suite::Examined found) { examined = found; });
    QVERIFY(examined);
    QCOMPARE(bool(examined->closures), comes);
    if (comes) {
      QCOMPARE(examined->closures->ranked.at(0).residual_m, 3.0);
    } else {
      QVERIFY2(examined->lacks.join(QString()).startsWith(
                   QStringLiteral("Loop closures could not be judged: the pose graph was not read. ")),
               qPrintable(examined->lacks.join(QString())));
    }
  }

  void onlyWhatIsDrawnIsAskedFor_data() {
    QTest::addColumn<std::string>("mode");
    QTest::addColumn<std::string>("map");
    QTest::addColumn<std::string>("layers");
    QTest::addColumn<bool>("submaps");
    QTest::addColumn<bool>("pose");
    QTest::addColumn<QStringList>("topics");
    const QStringList none, live = test::topicsOf(map::Stream::WholeMap);
    const std::string no;
    QTest::newRow("a stored map") << std::string("whole") << std::string("7") << std::string("none") << false
                                  << false << none;
    QTest::newRow("the live map") << std::string("whole") << no << std::string("none") << false << false
                                  << live;
    QTest::newRow("the live map by name")
        << std::string("whole") << std::string("live") << std::string("none") << false << false << live;
    QTest::newRow("submaps") << std::string("submaps") << no << std::string("none") << true << false << none;
    QTest::newRow("submaps and robot")
        << std::string("submaps") << no << std::string("submaps,robot") << true << true << none;
    QTest::newRow("a stored map and the path")
        << std::string("whole") << std::string("7") << std::string("path") << false << false
        << QStringList{QStringLiteral("/path")};
  }
  void onlyWhatIsDrawnIsAskedFor() {
    QFETCH(std::string, mode);
    QFETCH(std::string, map);
    QFETCH(std::string, layers);
    QFETCH(bool, submaps);
    QFETCH(bool, pose);
    app::SnapshotArguments asked = words("asked.png");
    asked.mode = mode;
    asked.map = map;
    asked.layers = layers;
    begin(asked);
    robot_->say(listOf(3, "u"));
    robot_->say(map::MapInfo{});
    QCOMPARE(robot_->basics.submaps, submaps);
    QCOMPARE(robot_->basics.pose, pose);
    QVERIFY(!robot_->basics.state);
    QTEST(robot_->wanted, "topics");
    QCOMPARE(!robot_->asked.empty(), submaps);
    QVERIFY(robot_->thumbnails.empty() && robot_->overviews.empty());
    // What follows the robot is drawn on the map that it is in: its list tells which one that is.
    QCOMPARE(robot_->lists.empty(), map != "7" || layers != "path");
  }
};

}  // namespace test_snapshot_content

MAPWRIGHT_TEST(test_snapshot_content, SnapshotContentTest, Widgets)
#include "test_snapshot_content.moc"
