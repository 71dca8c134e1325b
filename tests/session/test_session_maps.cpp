// A session and its whole maps: catalogue, opening, comparing, topics.
#include <QSignalSpy>
#include <QTest>
#include <QTimeZone>
#include <QTimer>

#include "fake_robot.h"
#include "grids/grid_pyramid.h"
#include "map/world.h"
#include "robot/aimdk/faults.h"
#include "robot/map_dispatch.h"
#include "sentences/problem_sentence.h"
#include "session/layer_grids.h"
#include "session/session_options.h"
#include "submap/submap_store.h"
#include "test_program.h"

namespace test_session_maps {

using namespace mapwright;
using session::MapSlot;
using session::Session;
using test::FakeRobot;
using Phase = MapSlot::Phase;

namespace {

map::GridMessage liveGrid(int gray, map::GridKind kind = map::GridKind::WholeMap) {
  map::GridMessage message;
  message.topic = "/map_v2";
  message.kind = kind;
  message.grid = {40, 40, 0.05, {-1, -1, 0}};
  message.png = test::grayPicture(40, 40, gray);
  return message;
}

/// A dispatcher that is never asked.
class RegionsOnly : public robot::MapDispatch {
 public:
  using MapDispatch::MapDispatch;
  std::vector<robot::DispatchOffer> offers() const override {
    robot::DispatchOffer offer;
    offer.service = robot::DispatchService::GridRegion;
    offer.name = "/get_sub_map";
    offer.offered = true;
    return {offer};
  }
  robot::Call grid(const std::optional<map::GridRegion>&, robot::OutcomeTo<map::GridPart>) override {
    return {};
  }
  robot::Call cloud(robot::CloudKind, const std::optional<map::CloudRegion>&,
                    robot::OutcomeTo<std::shared_ptr<const map::SpatialCloud>>) override {
    return {};
  }
  robot::Call save(const std::string&, robot::OutcomeTo<std::string>) override { return {}; }
  robot::Call projections(robot::OutcomeTo<std::vector<map::Projection>>) override { return {}; }
  robot::Call project(const std::vector<map::Projection>&,
                      robot::OutcomeTo<std::vector<map::Projection>>) override {
    return {};
  }
  std::vector<robot::ProjectedPart> projected() const override { return {}; }
};

}  // namespace

class SessionMapsTest : public QObject {
  Q_OBJECT
  FakeRobot* robot_ = nullptr;
  std::unique_ptr<Session> session_;
  submap::Millis monotonic_{1'000'000};

  void make(bool maps, bool topics, bool submaps = true, bool overview = false,
            const Session::Options& options = {}) {
    auto robot = std::make_unique<FakeRobot>();
    robot_ = robot.get();
    robot_->has_maps = maps;
    robot_->has_topics = topics;
    robot_->has_submaps = submaps;
    robot_->offers_overview = overview;
    session_ = std::make_unique<Session>(std::move(robot), options, nullptr, [this] { return monotonic_; });
  }
  void goOnline() { robot_->setPhase(robot::ConnectionPhase::Online); }
  int shownGray() const {
    const auto cells = session_->wholeMap().cells();
    return cells ? cells->at(5, 5) : -1;
  }

 private Q_SLOTS:
  void cleanup() { session_.reset(); }

  void aRobotThatSendsItsMapShowsIt() {
    make(true, true);
    goOnline();
    robot_->say(liveGrid(254));
    QTRY_COMPARE(shownGray(), 254);
    robot_->say(liveGrid(0));
    QTRY_COMPARE(shownGray(), 0);
  }

  void theNameOfTheLiveMapMayComeAfterIt() {
    make(true, true);
    goOnline();
    robot_->say(liveGrid(254));
    QTRY_COMPARE(shownGray(), 254);
    QTRY_VERIFY(session_->wholeMap().settled());  // its rows are seen while it is still being read
    QVERIFY(session_->wholeMap().name().isEmpty());
    map::MapInfo info;
    info.name = "Ground floor";
    robot_->say(info);
    QCOMPARE(session_->wholeMap().name(), QStringLiteral("Ground floor"));
    QVERIFY(session_->wholeMap().cells());  // it stays on screen
    QTRY_COMPARE(session_->wholeMap().shown().name, std::string("Ground floor"));
    // A stored one that was opened has its own.
    session_->openMap({map::MapKind::Stored, "1"});
    const QString stored = session_->wholeMap().name();
    info.name = "Attic";
    robot_->say(info);
    QCOMPARE(session_->wholeMap().name(), stored);
  }

  void aWorldThatIsGivenIsShownAsIfItsMessagesHadCome() {
    // The world of one robot, as a session keeps it ...
    QDateTime now = QDateTime(QDate(2024, 5, 1), QTime(12, 0), QTimeZone::utc()).toUTC();
    Session::Options options;
    options.wall = [&] { return now; };
    make(true, true, true, false, options);
    robot_->wall = [&] { return now; };
    goOnline();
    map::SubmapList list;
    list.uuid = "u";
    list.slam_state = map::SlamState::Positioning;
    list.entries.push_back({{3, 4}, 1, {}, false, false, false});
    robot_->say(list);
    robot_->say(map::TrackedPose{{5, 6, 0.5}});
    now = now.addSecs(60);
    robot_->say(map::AlertsMessage{{{6004, map::AlertLevel::Error, "hot", 0}}});
    robot_->say(liveGrid(200));
    const map::World world = session_->world();
    QCOMPARE(world.at_s, double(now.toSecsSinceEpoch()));
    QCOMPARE(world.live.alerts.front().since_s, world.at_s);
    // ... in another one, in the place of what that one had.
    make(true, true);
    goOnline();
    robot_->say(map::TrackedPose{{100, 100, 0}});
    robot_->say(liveGrid(0));
    QTRY_COMPARE(shownGray(), 0);
    QSignalSpy frames(session_.get(), &Session::frameChanged), told(session_.get(), &Session::liveChanged);
    const QStringList wanted = robot_->wanted;
    robot_->wants.clear();
    const auto fetched = session_->counts().fetches;
    session_->reset(world);
    QVERIFY(session_->world() == world);
    // The whole world is there: nothing is to be sent again.
    QVERIFY(std::all_of(robot_->wants.begin(), robot_->wants.end(),
                        [&](const QStringList& wants) { return wants == wanted; }));
    QCOMPARE(session_->counts().fetches, fetched);
    QCOMPARE(frames.size(), 1);
    for (const int what : {map::topicIndex<map::TrackedPose>(), map::topicIndex<map::AlertsMessage>()}) {
      QVERIFY(std::any_of(told.begin(), told.end(),
                          [&](const auto& one) { return one.first().toInt() == what; }));
    }
    QCOMPARE(session_->submaps().uuid(), std::string("u"));
    QVERIFY(session_->submaps().find({3, 4}));
    QTRY_COMPARE(shownGray(), 200);
    // Of a time before the first list nothing of it stays; as long as one may be found it does.
    map::World before = world;
    before.submaps.reset();
    session_->reset(before, false);
    QVERIFY(session_->submaps().find({3, 4}));
    session_->reset(before);
    QVERIFY(!session_->submaps().listReceived() && session_->submaps().rows().empty());
    QCOMPARE(session_->counts().listed, 0);
    session_->reset(world);
    QVERIFY(session_->submaps().find({3, 4}));
  }

  /// A stop that flapped is held on screen for a while, but not where a jump in a replay lands after its end.
  void whatEndedBeforeAJumpIsNotShownAfterIt() {
    Session::Options options;
    options.wall = [] { return QDateTime::fromSecsSinceEpoch(1001); };
    make(true, true, true, false, options);
    goOnline();
    map::World world;
    for (int i = 0; i < 6; ++i) map::reduceInto(world, map::WheelState{"auto", i % 2 == 0, {}}, 995 + i);
    session_->reset(world);
    QVERIFY(session_->safety().conditions().empty());
    robot_->say(map::WheelState{"auto", false, {}});
    QVERIFY(session_->safety().conditions().empty());
    // One that is there is there.
    map::reduceInto(world, map::WheelState{"auto", true, {}}, 1000.5);
    session_->reset(world);
    QCOMPARE(session_->safety().conditions().size(), std::size_t(1));
  }

  void aRobotThatSendsNoneShowsItsCurrentMap() {
    make(true, false, false);
    goOnline();
    QCOMPARE(robot_->lists.size(), std::size_t(1));
    robot_->answerList({FakeRobot::entry("1"), FakeRobot::entry("1764059676131", true)});
    QCOMPARE(robot_->map_fetches.size(), std::size_t(1));
    QVERIFY(robot_->map_fetches[0].first.id == "1764059676131");
    QVERIFY(session_->wholeMap().phase() == Phase::Fetching);
    robot_->map_fetches[0].second(FakeRobot::wholeMap("1764059676131"));
    QTRY_COMPARE(shownGray(), 254);
    // Another one becomes current: the view follows, for nobody chose.
    Q_EMIT robot_->mapsChanged();
    robot_->answerList({FakeRobot::entry("1", true), FakeRobot::entry("1764059676131")});
    QCOMPARE(robot_->map_fetches.size(), std::size_t(2));
    QVERIFY(robot_->map_fetches[1].first.id == "1");
  }

  void aMapThatTheUserOpenedStays() {
    make(true, true);
    goOnline();
    robot_->answerList({FakeRobot::entry("7"), FakeRobot::entry("8", true)});
    session_->openMap({map::MapKind::Stored, "7"});
    QCOMPARE(session_->wholeMap().name(), QStringLiteral("Map 7"));
    robot_->map_fetches.back().second(FakeRobot::wholeMap("7", 200));
    QTRY_VERIFY(session_->wholeMap().phase() == Phase::Ready);
    QCOMPARE(shownGray(), 200);
    QCOMPARE(session_->counts().fetches, quint64(1));
    QCOMPARE(session_->counts().bytes_fetched, quint64(session_->wholeMap().source()->bytes->size()));
    robot_->say(liveGrid(0));
    // A map that is taken is being read at once.
    QVERIFY(session_->wholeMap().phase() == Phase::Ready);
    QCOMPARE(session_->wholeMap().key(), (map::MapKey{map::MapKind::Stored, "7"}));
    QCOMPARE(shownGray(), 200);
    session_->openMap({map::MapKind::Live, {}});
    QVERIFY(session_->wholeMap().phase() == Phase::Reading);
    QTRY_COMPARE(shownGray(), 0);
  }

  void aPictureThatCannotBeReadToItsEndIsKeptNowhere() {
    make(true, true);
    goOnline();
    const auto broken = [](std::shared_ptr<const std::string> bytes, bool at_once) {
      return std::make_shared<const std::string>(at_once ? "no picture"
                                                         : bytes->substr(0, bytes->size() / 2));
    };
    const auto discarded = [&](const char* fingerprint) {
      const auto& pictures = robot_->discarded_pictures;
      return std::find(pictures.begin(), pictures.end(), fingerprint) != pictures.end();
    };
    for (const bool at_once : {true, false}) {
      robot_->discarded_pictures.clear();
      auto map = FakeRobot::wholeMap("7");
      map.bytes = broken(map.bytes, at_once);
      map.fingerprint = "stored";
      session_->openMap({map::MapKind::Stored, "7"});
      robot_->map_fetches.back().second(map);
      QTRY_VERIFY(discarded("stored"));
      session_->openMap({map::MapKind::Live, {}});
      map::GridMessage live = liveGrid(254);
      live.png = broken(live.png, at_once);
      live.fingerprint = "live";
      robot_->say(live);
      QTRY_VERIFY(discarded("live"));
      live.kind = map::GridKind::Incremental;
      live.fingerprint = "layer";
      robot_->say(live);
      QTRY_VERIFY(discarded("layer"));
    }
  }

  void anAnswerThatNobodyAwaitsAnyMoreIsDropped() {
    make(true, true);
    goOnline();
    session_->openMap({map::MapKind::Stored, "7"});
    session_->openMap({map::MapKind::Stored, "8"});
    robot_->map_fetches[0].second(FakeRobot::wholeMap("7", 200));
    QVERIFY(session_->wholeMap().phase() == Phase::Fetching);
    robot_->map_fetches[1].second(FakeRobot::wholeMap("8", 30));
    QTRY_COMPARE(shownGray(), 30);
  }

  void aMapThatCannotBeHadFailsWithTheRobotsWords() {
    make(true, true);
    goOnline();
    session_->openMap({map::MapKind::Stored, "7"});
    robot_->map_fetches[0].second(tl::make_unexpected(test::failed("The robot has no map 7.")));
    QVERIFY(session_->wholeMap().phase() == Phase::Failed);
    QCOMPARE(sentences::sentenceOf(session_->wholeMap().remark()), QStringLiteral("The robot has no map 7."));
    QCOMPARE(session_->problems().unresolved(), 1);
    session_->openMap({map::MapKind::Stored, "7"});
    robot_->map_fetches[1].second(FakeRobot::wholeMap("7"));
    QTRY_COMPARE(shownGray(), 254);
  }

  void aMapThatCouldNotBeHadIsAskedForAgainWhenTheRobotIsBack() {
    make(true, true);
    goOnline();
    session_->openMap({map::MapKind::Stored, "7"});
    robot_->setPhase(robot::ConnectionPhase::Interrupted);
    robot_->map_fetches[0].second(tl::make_unexpected(test::failed("The connection was lost.")));
    QCOMPARE(robot_->map_fetches.size(), std::size_t(1));
    goOnline();
    QCOMPARE(robot_->map_fetches.size(), std::size_t(2));
    robot_->map_fetches[1].second(FakeRobot::wholeMap("7"));
    QTRY_COMPARE(shownGray(), 254);
  }

  void aMapThatIsReadWellHasItsProblemsBehindIt_data() {
    QTest::addColumn<int>("trouble");
    QTest::newRow("cannot be had") << 0;
    QTest::newRow("called otherwise by whoever tells") << 1;
    QTest::newRow("no picture") << 2;
    QTest::newRow("breaks off") << 3;
    QTest::newRow("no usable grid") << 4;
    QTest::newRow("odd") << 5;
    QTest::newRow("another size") << 6;
  }
  void aMapThatIsReadWellHasItsProblemsBehindIt() {
    QFETCH(int, trouble);
    make(true, true);
    goOnline();
    robot_->answerList({FakeRobot::entry("7")});
    session_->openMap({map::MapKind::Stored, "7"});
    map::WholeMap broken = FakeRobot::wholeMap("7");
    if (trouble == 2) broken.bytes = std::make_shared<const std::string>("garbage");
    if (trouble == 3) broken.bytes = std::make_shared<const std::string>(broken.bytes->substr(0, 500));
    if (trouble == 4) broken.grid.resolution_m = 0;
    if (trouble == 5) broken.notes.push_back({map::Severity::Warning, "Whatever", fault::said("It is odd.")});
    if (trouble == 6) broken.grid.width = 77;
    if (trouble == 0) {
      map::Failure failure = test::failed("No.");
      failure.subject = map::subjectOf({map::MapKind::Stored, "7"});
      robot_->map_fetches[0].second(tl::make_unexpected(failure));
    } else if (trouble == 1) {
      robot_->map_fetches[0].second(tl::make_unexpected(test::failed("No.")));
    } else {
      robot_->map_fetches[0].second(broken);
    }
    QTRY_COMPARE(session_->problems().unresolved(), 1);
    QTRY_VERIFY(session_->wholeMap().settled());
    // It was given another name meanwhile: it is the same map all the same.
    session_->openMap({map::MapKind::Stored, "7"});
    map::WholeMap well = FakeRobot::wholeMap("7");
    well.name = "Another name";
    robot_->map_fetches[1].second(well);
    QTRY_VERIFY(session_->wholeMap().phase() == Phase::Ready);
    QCOMPARE(session_->problems().unresolved(), 0);
  }

  void oneMapThatIsWellSaysNothingOfAnother() {
    make(true, true);
    goOnline();
    session_->openMap({map::MapKind::Stored, "7"});
    robot_->map_fetches[0].second(tl::make_unexpected(test::failed("No.")));
    session_->openMap({map::MapKind::Stored, "8"});
    robot_->map_fetches[1].second(FakeRobot::wholeMap("8"));
    QTRY_VERIFY(session_->wholeMap().phase() == Phase::Ready);
    QCOMPARE(session_->problems().unresolved(), 1);
  }

  void navigationPointsRecoverByThemselves() {
    make(true, true);
    goOnline();
    const auto open = [&](std::size_t round) {
      session_->openMap({map::MapKind::Stored, "7"});
      robot_->map_fetches[round].second(FakeRobot::wholeMap("7"));
      QTRY_VERIFY(session_->wholeMap().phase() == Phase::Ready);
    };
    open(0);
    robot_->waypoint_asks[0].second(tl::make_unexpected(test::failed("No.")));
    QCOMPARE(session_->problems().unresolved(), 1);
    open(1);
    QCOMPARE(session_->problems().unresolved(), 1);  // the map is well, its points are not
    robot_->waypoint_asks[1].second(map::WaypointList{});
    QCOMPARE(session_->problems().unresolved(), 0);
  }

  void navigationPointsComeWithTheMap() {
    make(true, false, false);
    goOnline();
    robot_->answerList({FakeRobot::entry("1", true)});
    map::WaypointList list;
    list.points.push_back({"3", "Door <b>", "NAVI", {1, 2}, 0.5});
    list.notes = {{robot::aimdk::fault::PointOff, {"3", "Door", 4.0}}};
    robot_->waypoint_asks[0].second(list);
    robot_->map_fetches[0].second(FakeRobot::wholeMap("1"));
    QTRY_COMPARE(session_->wholeMap().waypoints().points.size(), std::size_t(1));
    QCOMPARE(session_->problems().unresolved(), 1);
  }

  void anAnswerThatIsAnotherMapIsNotTakenForIt() {
    make(true, true);
    goOnline();
    session_->openMap({map::MapKind::Stored, "7"});
    robot_->map_fetches[0].second(FakeRobot::wholeMap("8", 30));
    QVERIFY(session_->wholeMap().phase() == Phase::Failed);
    QVERIFY(!session_->wholeMap().cells());
    QCOMPARE(session_->problems().unresolved(), 1);
  }

  void whoWantsNothingByItselfGetsNothingByItself() {
    Session::Options options;
    options.maps = false;
    options.overview = false;
    options.basics = {false, false, false};
    make(true, true, true, true, options);
    QVERIFY(robot_->basics == options.basics);
    goOnline();
    map::SubmapList list;
    list.uuid = "u";
    list.entries.resize(3);
    for (int i = 0; i < 3; ++i) {
      list.entries[std::size_t(i)].id = {0, i};
      list.entries[std::size_t(i)].version = 1;
    }
    robot_->say(list);
    robot_->say(liveGrid(254));
    robot_->say(map::MapInfo{});
    Q_EMIT robot_->mapsChanged();
    goOnline();
    QVERIFY(session_->wholeMap().phase() == Phase::Empty);
    QVERIFY(robot_->asked.empty() && robot_->lists.empty() && robot_->overviews.empty());
    QVERIFY(robot_->map_fetches.empty() && robot_->wanted.isEmpty());
    // What it is told to do it does.
    session_->openMap({map::MapKind::Live, {}});
    QTRY_COMPARE(shownGray(), 254);
    session_->catalogue().refresh();
    QCOMPARE(robot_->lists.size(), std::size_t(1));
  }

  void aFileThatChangesWhileItIsReadIsReadAgain() {
    make(true, false);
    goOnline();
    const map::MapKey file{map::MapKind::File, "office.yaml"};
    const auto answer = [&](std::size_t which, int gray) {
      map::WholeMap map = FakeRobot::wholeMap("office.yaml", gray);
      map.key = file;
      robot_->map_fetches[which].second(std::move(map));
    };
    session_->openMap(file);
    Q_EMIT robot_->mapsChanged();  // while it is being fetched
    Q_EMIT robot_->mapsChanged();
    QCOMPARE(robot_->map_fetches.size(), std::size_t(1));
    answer(0, 254);
    QVERIFY(session_->wholeMap().phase() == Phase::Reading);
    Q_EMIT robot_->mapsChanged();  // while it is being read
    QTRY_COMPARE(robot_->map_fetches.size(), std::size_t(2));
    QCOMPARE(shownGray(), 254);
    answer(1, 100);
    QTRY_COMPARE(shownGray(), 100);
    QTRY_VERIFY(session_->wholeMap().settled());
    QCoreApplication::processEvents();
    QCOMPARE(robot_->map_fetches.size(), std::size_t(2));
    // One that cannot be read has perhaps been written in the meantime.
    Q_EMIT robot_->mapsChanged();
    Q_EMIT robot_->mapsChanged();
    robot_->map_fetches[2].second(tl::make_unexpected(test::failed("It is empty.")));
    QTRY_COMPARE(robot_->map_fetches.size(), std::size_t(4));
    robot_->map_fetches[3].second(tl::make_unexpected(test::failed("It is empty.")));
    // So is the one that it is compared with, unless that was kept as it was.
    session_->compareWith(file);
    answer(4, 50);
    QTRY_VERIFY(session_->comparedMap().settled());
    Q_EMIT robot_->mapsChanged();
    QCOMPARE(robot_->map_fetches.size(), std::size_t(7));
    answer(5, 60);
    answer(6, 60);
    QTRY_VERIFY(session_->wholeMap().settled() && session_->comparedMap().settled());
    session_->keepForComparing();
    QTRY_VERIFY(session_->comparedMap().settled());
    Q_EMIT robot_->mapsChanged();
    QCOMPARE(robot_->map_fetches.size(), std::size_t(8));
    answer(7, 70);
    QTRY_VERIFY(session_->wholeMap().settled());
    // Another map that is opened meanwhile needs nothing read again.
    Q_EMIT robot_->mapsChanged();
    Q_EMIT robot_->mapsChanged();
    session_->openMap({map::MapKind::File, "attic.yaml"});
    robot_->map_fetches[9].second(tl::make_unexpected(test::failed("It is empty.")));
    QCoreApplication::processEvents();
    QCOMPARE(robot_->map_fetches.size(), std::size_t(10));
  }

  void bytesCountOnlyWhenTheyTravelled_data() {
    QTest::addColumn<QByteArray>("what");
    QTest::addColumn<quint64>("fetches");
    QTest::addColumn<quint64>("cache_hits");
    QTest::addColumn<quint64>("bytes");
    QTest::newRow("a stored map") << QByteArray("stored") << quint64(1) << quint64(0) << quint64(1000);
    QTest::newRow("a stored map on disk")
        << QByteArray("stored cached") << quint64(0) << quint64(1) << quint64(0);
    QTest::newRow("a local file") << QByteArray("file") << quint64(0) << quint64(0) << quint64(0);
    QTest::newRow("a picture by address")
        << QByteArray("address") << quint64(1) << quint64(0) << quint64(1000);
    QTest::newRow("a picture by address, on disk")
        << QByteArray("address cached") << quint64(0) << quint64(1) << quint64(0);
    QTest::newRow("a picture in its message")
        << QByteArray("inside") << quint64(0) << quint64(0) << quint64(0);
    QTest::newRow("a costmap by address")
        << QByteArray("costmap") << quint64(1) << quint64(0) << quint64(1000);
  }
  void bytesCountOnlyWhenTheyTravelled() {
    QFETCH(QByteArray, what);
    make(true, true);
    goOnline();
    if (what.startsWith("stored") || what == "file") {
      session_->openMap({map::MapKind::Stored, "7"});
      map::WholeMap map = FakeRobot::wholeMap("7");
      map.body_bytes = what == "file" ? 0 : 1000;
      map.from_cache = what.endsWith("cached");
      robot_->map_fetches[0].second(map);
    } else {
      map::GridMessage message =
          liveGrid(9, what == "costmap" ? map::GridKind::CostmapLow : map::GridKind::WholeMap);
      message.body_bytes = what == "inside" ? 0 : 1000;
      message.from_cache = what.endsWith("cached");
      robot_->say(message);
    }
    const session::SubmapCounts counts = session_->counts();
    QTEST(counts.fetches, "fetches");
    QTEST(counts.cache_hits, "cache_hits");
    QTEST(counts.bytes_fetched, "bytes");
  }

  void noOtherMapIsComparedWhileTheChosenOneIsOnItsWay() {
    make(true, true);
    goOnline();
    session_->compareWith(map::MapKey{map::MapKind::Stored, "7"});
    robot_->map_fetches[0].second(FakeRobot::wholeMap("7", 200));
    QTRY_VERIFY(session_->comparedMap().phase() == Phase::Ready);
    session_->compareWith(map::MapKey{map::MapKind::Stored, "8"});
    QVERIFY(!session_->comparedMap().cells());
    robot_->map_fetches[1].second(tl::make_unexpected(test::failed("The robot has no map 8.")));
    QVERIFY(!session_->comparedMap().cells());
  }

  void whatIsKeptForComparingIsWhatIsOnScreen() {
    make(true, true);
    goOnline();
    robot_->say(liveGrid(254));
    QTRY_COMPARE(shownGray(), 254);
    robot_->say(liveGrid(0));  // is being read yet
    QCOMPARE(shownGray(), 254);
    session_->keepForComparing();
    QTRY_VERIFY(session_->comparedMap().phase() == Phase::Ready);
    QCOMPARE(int(session_->comparedMap().cells()->at(5, 5)), 254);
  }

  void thePresentStateCanBeKeptForComparing() {
    make(true, true);
    goOnline();
    robot_->say(liveGrid(254));
    QTRY_COMPARE(shownGray(), 254);
    session_->keepForComparing();
    QTRY_VERIFY(session_->comparedMap().phase() == Phase::Ready);
    robot_->say(liveGrid(0));
    QTRY_COMPARE(shownGray(), 0);
    QCOMPARE(int(session_->comparedMap().cells()->at(5, 5)), 254);
    session_->compareWith(std::nullopt);
    QVERIFY(session_->comparedMap().phase() == Phase::Empty);
  }

  void wantsOfSeveralOwnersAddUp() {
    make(true, true);
    goOnline();
    session_->want(QStringLiteral("layers"), {map::Stream::Path, map::Stream::Alerts});
    session_->want(QStringLiteral("status"), {map::Stream::Alerts, map::Stream::Battery},
                   {QStringLiteral("/x")});
    QStringList wanted = robot_->wanted;
    wanted.sort();
    QCOMPARE(wanted, (QStringList{QStringLiteral("/alerts"), QStringLiteral("/battery_state"),
                                  QStringLiteral("/path"), QStringLiteral("/x")}));
    session_->want(QStringLiteral("status"), {});
    QVERIFY(!robot_->wanted.contains(QStringLiteral("/battery_state")));
    QVERIFY(robot_->wanted.contains(QStringLiteral("/alerts")));
  }

  static map::SubmapList listOf(const std::string& uuid, map::SlamState state = map::SlamState::Slam) {
    map::SubmapList list;
    list.uuid = uuid;
    list.slam_state = state;
    return list;
  }
  static map::PointCloudMessage cloud(const std::string& topic) {
    return {topic, std::make_shared<const std::vector<map::CloudPoint>>(3)};
  }

  void aMapOfOccupancyIsReadAsItSays() {
    make(true, true);
    goOnline();
    for (const map::GridKind kind : {map::GridKind::WholeMap, map::GridKind::CostmapLow}) {
      map::GridMessage message = liveGrid(0, kind);
      message.reading.mode = map::CellReading::Mode::Raw;
      message.png = std::make_shared<const std::string>("P5\n40 40\n255\n" + std::string(1'600, char(42)));
      robot_->say(message);
    }
    QTRY_COMPARE(shownGray(), 42);
    QCOMPARE(session_->wholeMap().cells()->code(), grids::CellCode::Occupancy);
    QTRY_VERIFY(session_->layerGrids().find(map::GridKind::CostmapLow));
    const auto costs = session_->layerGrids().find(map::GridKind::CostmapLow)->picture.indices;
    QCOMPARE(costs->code(), grids::CellCode::Occupancy);
    QCOMPARE(int(costs->at(5, 5)), 42);
  }

  void anotherSessionLeavesNothingOfTheOldFrame() {
    make(true, true);
    goOnline();
    session_->want(QStringLiteral("layers"), {map::Stream::WholeMap, map::Stream::Landmarks});
    robot_->say(listOf("u"));
    robot_->say(liveGrid(254));
    QTRY_COMPARE(shownGray(), 254);
    robot_->say(liveGrid(3, map::GridKind::CostmapLow));
    QTRY_VERIFY(session_->layerGrids().find(map::GridKind::CostmapLow));
    robot_->say(map::TrackedPose{{1, 2, 3}});
    robot_->say(map::LandmarksMessage{{{"l", {1, 2}, true}}});
    QSignalSpy frames(session_.get(), &Session::frameChanged);
    const std::size_t asked = robot_->wants.size();
    robot_->say(listOf("v"));
    QCOMPARE(frames.size(), 1);
    QVERIFY(!session_->live().robot_pose && session_->live().landmarks.empty());
    QCOMPARE(shownGray(), -1);
    QVERIFY(session_->wholeMap().phase() == Phase::Fetching);
    QVERIFY(!session_->layerGrids().find(map::GridKind::CostmapLow));
    // What is sent once only is asked for again, for it may have come before.
    QVERIFY(robot_->wants.size() >= asked + 2);
    QVERIFY(robot_->wants[asked].isEmpty());
    QVERIFY(robot_->wanted.contains(QStringLiteral("/landmarks")));
    robot_->say(liveGrid(7));
    QTRY_COMPARE(shownGray(), 7);
    robot_->say(listOf("v"));
    QCOMPARE(frames.size(), 1);
  }

  void aNewSessionInTheSameMapKeepsItsPicture() {
    make(true, true);
    goOnline();
    robot_->say(listOf("u", map::SlamState::Positioning));
    robot_->say(liveGrid(254));
    QTRY_COMPARE(shownGray(), 254);
    robot_->say(map::TrackedPose{{1, 2, 3}});
    robot_->say(listOf("v", map::SlamState::Positioning));
    QVERIFY(!session_->live().robot_pose);
    QCOMPARE(shownGray(), 254);
  }

  void anotherMapIsAnotherFrameAndAStoredOneStaysOnScreen() {
    make(true, true);
    goOnline();
    robot_->answerList({FakeRobot::entry("7")});
    session_->openMap({map::MapKind::Stored, "7"});
    robot_->map_fetches.back().second(FakeRobot::wholeMap("7", 200));
    QTRY_COMPARE(shownGray(), 200);
    map::MapInfo info;
    info.uid = "a";
    robot_->say(info);
    robot_->say(map::TrackedPose{{1, 2, 3}});
    QSignalSpy frames(session_.get(), &Session::frameChanged);
    info.uid = "b";
    robot_->say(info);
    QCOMPARE(frames.size(), 1);
    QVERIFY(!session_->live().robot_pose);
    QCOMPARE(shownGray(), 200);
  }

  void aCloudGoesWithTheLastWhoWantsItsTopic() {
    make(true, true);
    goOnline();
    const QStringList both{QStringLiteral("/a"), QStringLiteral("/b")};
    session_->want(QStringLiteral("layers"), {}, both);
    session_->want(QStringLiteral("inspector"), {}, {QStringLiteral("/b")});
    robot_->say(cloud("/a"));
    robot_->say(cloud("/b"));
    QCOMPARE(session_->live().clouds.size(), std::size_t(2));
    QSignalSpy changed(session_.get(), &Session::liveChanged);
    session_->want(QStringLiteral("layers"), {});
    QCOMPARE(session_->live().clouds.size(), std::size_t(1));
    QVERIFY(session_->live().clouds.contains("/b"));
    QCOMPARE(changed.size(), 1);
    QCOMPARE(changed.first().first().toInt(), map::topicIndex<map::PointCloudMessage>());
    robot_->say(cloud("/a"));  // was on its way
    QVERIFY(!session_->live().clouds.contains("/a"));
    session_->want(QStringLiteral("inspector"), {});
    QVERIFY(session_->live().clouds.empty());
    session_->want(QStringLiteral("layers"), {}, both);
    QVERIFY2(session_->live().clouds.empty(), "nothing old is shown when its layer is switched on again");
  }

  void aCostmapGoesWithTheLastWhoWantsItsTopic() {
    make(true, true);
    goOnline();
    session_->want(QStringLiteral("layers"), {map::Stream::WholeMap});
    robot_->say(liveGrid(3, map::GridKind::CostmapLow));
    QTRY_VERIFY(session_->layerGrids().find(map::GridKind::CostmapLow));
    session_->want(QStringLiteral("layers"), {});
    QVERIFY(!session_->layerGrids().find(map::GridKind::CostmapLow));
    session_->want(QStringLiteral("layers"), {map::Stream::WholeMap});
    robot_->say(liveGrid(4, map::GridKind::CostmapLow));
    session_->want(QStringLiteral("layers"), {});  // while it is being decoded
    session_->want(QStringLiteral("layers"), {map::Stream::WholeMap});
    robot_->say(liveGrid(5, map::GridKind::CostmapLow));
    QTRY_VERIFY(session_->layerGrids().find(map::GridKind::CostmapLow));
    QCOMPARE(int(session_->layerGrids().find(map::GridKind::CostmapLow)->picture.indices->at(3, 3)), 5);
  }

  void aRobotThatKeepsItsMapToItselfShowsItsCurrentOne() {
    Session::Options options;
    options.live_map_within_ms = 1;
    make(true, true, true, false, options);
    goOnline();
    robot_->answerList({FakeRobot::entry("8", true)});
    QVERIFY(robot_->map_fetches.empty());
    session_->want(QStringLiteral("layers"), {map::Stream::WholeMap});
    QTRY_COMPARE(robot_->map_fetches.size(), std::size_t(1));
    robot_->map_fetches[0].second(FakeRobot::wholeMap("8", 30));
    QTRY_COMPARE(shownGray(), 30);
    robot_->say(liveGrid(254));
    QTRY_COMPARE(shownGray(), 254);
  }

  void aRobotThatBeginsToSendItsMapLaterShowsIt() {
    make(true, true);
    robot_->sends_no_map = true;
    goOnline();
    robot_->answerList({FakeRobot::entry("8", true)});
    QCOMPARE(robot_->map_fetches.size(), std::size_t(1));
    robot_->map_fetches[0].second(
        tl::make_unexpected(test::failed("no picture for it", map::FailureKind::Unsupported)));
    QCOMPARE(session_->wholeMap().phase(), Phase::Failed);
    // It is listed, and no fault of the robot.
    QCOMPARE(session_->problems().rows().size(), std::size_t(1));
    QCOMPARE(session_->problems().unresolved(), 0);
    robot_->sends_no_map = false;
    Q_EMIT robot_->capabilitiesChanged();
    robot_->say(liveGrid(254));
    QTRY_COMPARE(shownGray(), 254);
    QVERIFY(session_->problems().rows().front().resolved);
  }

  void aMapThatTheUserOpenedIsTriedAgainOnceTheRobotSendsOne() {
    make(true, true);
    robot_->sends_no_map = true;
    goOnline();
    robot_->answerList({FakeRobot::entry("8", true)});
    session_->openMap({map::MapKind::Stored, "8"});
    robot_->map_fetches.back().second(
        tl::make_unexpected(test::failed("no picture for it", map::FailureKind::Unsupported)));
    robot_->map_fetches.clear();
    robot_->sends_no_map = false;
    Q_EMIT robot_->capabilitiesChanged();
    QCOMPARE(robot_->map_fetches.size(), std::size_t(1));
    QCOMPARE(robot_->map_fetches[0].first, (map::MapKey{map::MapKind::Stored, "8"}));
  }

  void theMapOfARobotThatGivesItByRegionIsNotFetchedAsAWhole() {
    Session::Options options;
    options.live_map_within_ms = 1;
    make(true, true, true, false, options);
    RegionsOnly dispatch;
    robot_->dispatch = &dispatch;
    goOnline();
    robot_->answerList({FakeRobot::entry("8", true), FakeRobot::entry("9")});
    session_->want(QStringLiteral("layers"), {map::Stream::WholeMap});
    bool over = false;  // the time that it is waited for
    QTimer::singleShot(20, this, [&] { over = true; });
    QTRY_VERIFY(over);
    QVERIFY(robot_->map_fetches.empty());
    QCOMPARE(session_->problems().unresolved(), 0);
    // Its waypoints need no picture.
    QCOMPARE(session_->placesOf(session_->wholeMap()), std::optional(map::MapKey{map::MapKind::Stored, "8"}));
    session_->openMap({map::MapKind::Stored, "9"});
    QCOMPARE(robot_->map_fetches.size(), std::size_t(1));
    session_.reset();
  }

  void anOverviewIsShownUntilEverySubmapIsIn() {
    make(true, true, true, true);
    goOnline();
    map::SubmapList list;
    list.uuid = "u";
    map::SubmapEntry entry;
    entry.id = {0, 0};
    entry.version = 1;
    entry.pose = geometry::poseFromYaw(3, 4, 0);
    list.entries = {entry};
    robot_->say(list);
    QCOMPARE(robot_->overviews.size(), std::size_t(1));
    QCOMPARE(robot_->overview_resolutions[0], 0.1);  // one submap: as fine as overviews get
    robot_->overviews[0](FakeRobot::wholeMap("overview"));
    QTRY_VERIFY(session_->overview().cells() != nullptr);
    robot_->answer(map::SubmapAnswer::Outcome::Ok);
    QTRY_VERIFY(session_->overview().phase() == Phase::Empty);
    robot_->say(list);
    QCOMPARE(robot_->overviews.size(), std::size_t(1));  // once a session
  }

  void costmapsAreDecodedTheNewestLast() {
    make(true, true);
    goOnline();
    session_->want(QStringLiteral("layers"), {map::Stream::WholeMap});
    for (int gray = 0; gray < 10; ++gray) robot_->say(liveGrid(gray, map::GridKind::CostmapLow));
    QTRY_VERIFY(session_->layerGrids().find(map::GridKind::CostmapLow) &&
                session_->layerGrids().find(map::GridKind::CostmapLow)->picture.indices->at(3, 3) == 9);
    map::GridMessage broken = liveGrid(5, map::GridKind::CostmapLow);
    broken.png = std::make_shared<const std::string>("garbage");
    robot_->say(broken);
    QTRY_COMPARE(session_->problems().unresolved(), 1);
    QVERIFY(session_->layerGrids().find(map::GridKind::CostmapLow)->picture.indices->at(3, 3) == 9);
    robot_->say(liveGrid(7, map::GridKind::CostmapLow));
    QTRY_COMPARE(session_->problems().unresolved(), 0);
  }

  void thumbnailsAreAskedForOnceAndAFewAtATime() {
    make(true, true);
    goOnline();
    std::vector<map::CatalogueEntry> rows;
    for (int i = 0; i < 6; ++i) rows.push_back(FakeRobot::entry(std::to_string(i)));
    robot_->answerList(rows);
    session::Catalogue& catalogue = session_->catalogue();
    QSignalSpy arrived(&catalogue, &session::Catalogue::thumbnailArrived);
    for (int round = 0; round < 2; ++round) {
      for (const auto& row : rows) QVERIFY(catalogue.thumbnail(row.key).isEmpty());
    }
    QCOMPARE(robot_->thumbnails.size(), std::size_t(2));
    robot_->thumbnails[0].second(std::string("png"));
    robot_->thumbnails[1].second(tl::make_unexpected(test::failed("too large")));
    QCOMPARE(arrived.size(), 2);
    QCOMPARE(robot_->thumbnails.size(), std::size_t(4));
    QCOMPARE(catalogue.thumbnail(rows[0].key), QByteArray("png"));
    QVERIFY(!catalogue.noThumbnailReason(rows[0].key) && !catalogue.noThumbnailReason(rows[2].key));
    QVERIFY(catalogue.noThumbnailReason(rows[1].key));
    QCOMPARE(catalogue.noThumbnailReason(rows[1].key)->detail, std::string("too large"));
  }

  void thumbnailsThatNobodyLooksAtAreNotFetched() {
    make(true, true);
    goOnline();
    std::vector<map::CatalogueEntry> rows;
    for (int i = 0; i < 4; ++i) rows.push_back(FakeRobot::entry(std::to_string(i)));
    robot_->answerList(rows);
    session::Catalogue& catalogue = session_->catalogue();
    for (const auto& row : rows) QVERIFY(catalogue.thumbnail(row.key).isEmpty());
    catalogue.releaseThumbnails();
    for (int i = 0; i < 2; ++i) {
      robot_->thumbnails[std::size_t(i)].second(
          tl::make_unexpected(map::Failure{.kind = map::FailureKind::Cancelled}));
    }
    QCOMPARE(robot_->thumbnails.size(), std::size_t(2));  // the others have not been asked for
    QVERIFY(!catalogue.noThumbnailReason(rows[0].key));
    QVERIFY(catalogue.thumbnail(rows[0].key).isEmpty());  // seen again: asked for again
    QCOMPARE(robot_->thumbnails.size(), std::size_t(3));
  }

  void aMapThatIsTakenIntoUseIsAskedForAgain() {
    make(true, true);
    goOnline();
    auto row = FakeRobot::entry("1");
    robot_->answerList({row});
    session::Catalogue& catalogue = session_->catalogue();
    QVERIFY(catalogue.thumbnail(row.key).isEmpty());
    robot_->thumbnails[0].second(tl::make_unexpected(test::failed("not in use")));
    QVERIFY(catalogue.thumbnail(row.key).isEmpty());
    QCOMPARE(robot_->thumbnails.size(), std::size_t(1));
    row.is_current = !row.is_current;
    catalogue.refresh();
    robot_->answerList({row});
    QVERIFY(catalogue.thumbnail(row.key).isEmpty());
    QCOMPARE(robot_->thumbnails.size(), std::size_t(2));
  }

  void aFailedListKeepsTheRowsAndSaysWhy() {
    make(true, true);
    goOnline();
    robot_->answerList({FakeRobot::entry("1")});
    session_->catalogue().refresh();
    session_->catalogue().refresh();  // while one is in progress: once more after it
    QCOMPARE(robot_->lists.size(), std::size_t(1));
    auto replies = std::exchange(robot_->lists, {});
    replies[0](tl::make_unexpected(test::failed("The robot answered 500.")));
    QVERIFY(session_->catalogue().failure());
    QCOMPARE(session_->catalogue().failure()->detail, std::string("The robot answered 500."));
    QCOMPARE(session_->catalogue().entries().size(), std::size_t(1));
    QCOMPARE(robot_->lists.size(), std::size_t(1));
  }

  void aShortLossAsksForNoListAgain() {
    make(true, true);
    goOnline();
    QCOMPARE(robot_->lists.size(), std::size_t(1));
    robot_->answerList({FakeRobot::entry("1", true)});
    robot_->say(map::MapInfo{"Map 1", "u", 1, 1, {}});  // comes with every connection
    QVERIFY(robot_->lists.empty());
    for (int i = 0; i < 20; ++i) {
      monotonic_ += submap::Millis(2'500);
      robot_->setPhase(robot::ConnectionPhase::Interrupted);
      goOnline();
      robot_->say(map::MapInfo{"Map 1", "u", 1, 1, {}});
    }
    QVERIFY(robot_->lists.empty());
    // After a while much may have changed, and what the robot says has changed is asked for at once.
    monotonic_ += submap::Millis(60'000);
    robot_->setPhase(robot::ConnectionPhase::Interrupted);
    goOnline();
    QCOMPARE(robot_->lists.size(), std::size_t(1));
    robot_->answerList({FakeRobot::entry("1", true)});
    Q_EMIT robot_->mapsChanged();
    QCOMPARE(robot_->lists.size(), std::size_t(1));
  }

  void aListThatFailedIsAskedForAfterEveryLoss() {
    make(true, true);
    goOnline();
    std::exchange(robot_->lists,
                  {})[0](tl::make_unexpected(test::failed("It broke off.", map::FailureKind::Unreachable)));
    QCOMPARE(session_->catalogue().failure()->kind, map::FailureKind::Unreachable);
    robot_->setPhase(robot::ConnectionPhase::Interrupted);
    goOnline();
    QCOMPARE(robot_->lists.size(), std::size_t(1));
    robot_->answerList({FakeRobot::entry("1", true)});
    QVERIFY(!session_->catalogue().failure());
  }
};

}  // namespace test_session_maps

MAPWRIGHT_TEST(test_session_maps, SessionMapsTest, Widgets)
#include "test_session_maps.moc"
