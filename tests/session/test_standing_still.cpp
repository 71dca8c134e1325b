// A session that stands still: whoever draws it and then says what he drew is right, whatever the robot does.
#include <cmath>

#include <QMetaMethod>
#include <QSignalSpy>
#include <QTest>

#include "fake_robot.h"
#include "grids/grid_pyramid.h"
#include "map/live_state.h"
#include "session/layer_grids.h"
#include "session/session_options.h"
#include "submap/submap_store.h"
#include "test_program.h"

namespace test_standing_still {

using namespace mapwright;
using Outcome = map::SubmapAnswer::Outcome;
using session::Session;
using test::FakeRobot;

namespace {

map::SubmapList listOf(int submaps, const std::string& uuid, int version, double x = 0) {
  map::SubmapList list;
  list.uuid = uuid;
  for (int i = 0; i < submaps; ++i) {
    map::SubmapEntry entry;
    entry.id = {0, i};
    entry.version = version;
    entry.pose = geometry::poseFromYaw(x + i, 0, 0);
    list.entries.push_back(entry);
  }
  return list;
}

map::GridMessage picture(map::GridKind kind, int gray) {
  map::GridMessage message;
  message.topic = kind == map::GridKind::WholeMap ? "/map_v2" : "/maps/5cm/1hz";
  message.kind = kind;
  message.grid = {40, 40, 0.05, {-1, -1, 0}};
  message.png = test::grayPicture(40, 40, gray);
  return message;
}

}  // namespace

class StandingStillTest : public QObject {
  Q_OBJECT
  FakeRobot* robot_ = nullptr;
  std::unique_ptr<Session> session_;

  int shownGray() const {
    const auto cells = session_->wholeMap().cells();
    return cells ? cells->at(5, 5) : -1;
  }
  int costmapByte() const {
    const session::LayerGrid* const grid = session_->layerGrids().find(map::GridKind::CostmapLow);
    return grid ? grid->picture.indices->at(3, 3) : -1;
  }

 private Q_SLOTS:
  void init() {
    auto robot = std::make_unique<FakeRobot>();
    robot_ = robot.get();
    robot_->has_maps = true;
    robot_->has_topics = true;
    session_ = std::make_unique<Session>(std::move(robot), Session::Options{});
    robot_->setPhase(robot::ConnectionPhase::Online);
    robot_->say(listOf(3, "u", 1));
    robot_->answer(Outcome::Ok);
    robot_->answer(Outcome::Ok);
    robot_->say(map::TrackedPose{{1, 2, 0}});
    robot_->say(picture(map::GridKind::WholeMap, 200));
    robot_->say(picture(map::GridKind::CostmapLow, 7));
    QTRY_COMPARE(session_->counts().shown, 2);
    QTRY_COMPARE(shownGray(), 200);
    QTRY_COMPARE(costmapByte(), 7);
  }
  void cleanup() { session_.reset(); }

  void nothingThatComesChangesIt_data() {
    QTest::addColumn<QByteArray>("what");
    for (const char* what : {"an answer", "a new session", "a moved pose", "a newer version", "no submaps",
                             "a robot pose", "a live map", "a costmap", "a lost link", "a stored map"}) {
      QTest::newRow(what) << QByteArray(what);
    }
  }
  void nothingThatComesChangesIt() {
    QFETCH(QByteArray, what);
    if (what == "a stored map") session_->openMap({map::MapKind::Stored, "7"});
    // What has been answered but not taken in yet comes too late as well.
    if (what == "an answer") robot_->answer(Outcome::Ok);
    const std::vector<QMetaMethod> signals_of_session = [] {
      std::vector<QMetaMethod> all;
      const QMetaObject& meta = Session::staticMetaObject;
      for (int i = meta.methodOffset(); i < meta.methodCount(); ++i) {
        const QMetaMethod method = meta.method(i);
        const QByteArray name = method.name();
        // Told a while after, of what was before.
        const bool coalesced = name == "rowsChanged" || name == "rowsTouched" || name == "problemsChanged";
        if (method.methodType() == QMetaMethod::Signal && !coalesced) all.push_back(method);
      }
      return all;
    }();
    session_->standStill();
    const session::SubmapCounts before = session_->counts();
    std::vector<std::unique_ptr<QSignalSpy>> spies;
    for (const QMetaMethod& signal : signals_of_session)
      spies.push_back(std::make_unique<QSignalSpy>(session_.get(), signal));

    if (what == "a new session") robot_->say(listOf(5, "v", 1));
    if (what == "a moved pose") robot_->say(listOf(3, "u", 1, 30));
    if (what == "a newer version") robot_->say(listOf(3, "u", 2));
    if (what == "no submaps") robot_->say(listOf(0, "u", 1));
    if (what == "a robot pose") robot_->say(map::TrackedPose{{50, 60, 1}});
    if (what == "a live map") robot_->say(picture(map::GridKind::WholeMap, 3));
    if (what == "a costmap") robot_->say(picture(map::GridKind::CostmapLow, 9));
    if (what == "a lost link") robot_->setPhase(robot::ConnectionPhase::Interrupted);
    if (what == "a stored map") robot_->map_fetches.back().second(FakeRobot::wholeMap("7", 30));
    if (!robot_->open.empty()) robot_->answer(Outcome::Ok);

    // Whatever was on its way to the session from a thread has come before this has.
    bool turned = false;
    QMetaObject::invokeMethod(
        this, [&] { turned = true; }, Qt::QueuedConnection);
    QTRY_VERIFY(turned);
    QVERIFY(session_->counts() == before);
    QCOMPARE(session_->submaps().uuid(), std::string("u"));
    QCOMPARE(session_->submaps().find({0, 0})->entry.pose.x, 0.0);
    QCOMPARE(session_->live().robot_pose->x_m, 1.0);
    QCOMPARE(shownGray(), 200);
    QCOMPARE(costmapByte(), 7);
    for (const auto& spy : spies) QVERIFY2(spy->isEmpty(), spy->signal().constData());
  }

  void nothingIsAskedForAnyMore() {
    const std::size_t asked = robot_->asked.size(), lists = robot_->lists.size();
    session_->standStill();
    robot_->say(listOf(9, "w", 4));
    session_->setView({-5, -5, 5, 5}, {0, 0});
    session_->want(QStringLiteral("layers"), {map::Stream::Path});
    robot_->setPhase(robot::ConnectionPhase::Interrupted);
    robot_->setPhase(robot::ConnectionPhase::Online);
    QCOMPARE(robot_->asked.size(), asked);
    QCOMPARE(robot_->lists.size(), lists);
    QVERIFY(robot_->wanted.isEmpty());
  }

  void aMapThatIsBeingReadEndsWhereItIs() {
    session_->openMap({map::MapKind::Stored, "large"});
    robot_->map_fetches.back().second(FakeRobot::wholeMap("large", 90, 6000));
    QTRY_VERIFY(session_->wholeMap().cells() && session_->wholeMap().cells()->width() == 6000);
    session_->standStill();
    const int rows = session_->wholeMap().cells()->rowsReady();
    bool turned = false;
    QMetaObject::invokeMethod(
        this, [&] { turned = true; }, Qt::QueuedConnection);
    QTRY_VERIFY(turned);
    QCOMPARE(session_->wholeMap().cells()->rowsReady(), rows);
  }
};

}  // namespace test_standing_still

MAPWRIGHT_TEST(test_standing_still, StandingStillTest, Core)
#include "test_standing_still.moc"
