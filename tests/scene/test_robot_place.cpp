// The robot, and all that belongs to it, on the maps that it is in and on no other: in pixels.
#include <QImage>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>

#include "fake_robot.h"
#include "render/tile_renderer.h"
#include "session/layer_grids.h"
#include "session/session_options.h"
#include "test_program.h"
#include "ui/scene/map_scene.h"

namespace test_robot_place {

using namespace mapwright;
using map::Whereabouts;
using session::Session;
using test::FakeRobot;
using ui::scene::CompareMode;
using ui::scene::Layer;
using ui::scene::MapScene;
using ui::scene::ScreenPart;

namespace {

const map::MapKey kHere{map::MapKind::Stored, "1"}, kElsewhere{map::MapKind::Stored, "2"};
const map::Polyline kLine{{-0.4, 0}, {0.4, 0}};

std::vector<Layer> robotsLayers() {
  std::vector<Layer> layers = ui::scene::allLayers();
  std::erase_if(layers, [](Layer layer) { return !ui::scene::specOf(layer).follows_robot; });
  return layers;
}

map::GridMessage grid(map::GridKind kind) {
  map::GridMessage message;
  message.topic = "/grid";
  message.kind = kind;
  message.grid = {0, 0, 0.01, {-0.4, -0.4, 0}};
  // Not of one gray: the commonest one says nothing in some of them.
  auto picture = std::make_shared<std::string>(*test::grayPicture(80, 80, 0));
  for (std::size_t i = picture->size() - 80 * 30; i < picture->size(); ++i) (*picture)[i] = char(254);
  message.png = picture;
  return message;
}

map::MapInfo mapInfo(const char* uid, const char* name) {
  map::MapInfo info;
  info.uid = uid;
  info.name = name;
  map::OverlayFeature wall;
  wall.shape = map::OverlayShape::Line;
  wall.type = 2;
  wall.parts = {kLine};
  info.overlays = {wall};
  return info;
}

}  // namespace

class RobotPlaceTest : public QObject {
  Q_OBJECT
  FakeRobot* robot_ = nullptr;
  std::unique_ptr<Session> session_;
  std::unique_ptr<MapScene> scene_;

  QImage painted() {
    QImage image(100, 100, QImage::Format_RGB32);
    QPainter painter(&image);
    scene_->render(&painter, QRectF(0, 0, 100, 100), QRectF(0, 0, 100, 100));
    return image;
  }
  void showOnly(const std::vector<Layer>& layers) {
    for (const Layer layer : ui::scene::allLayers()) {
      scene_->setLayerVisible(layer, std::find(layers.begin(), layers.end(), layer) != layers.end());
    }
  }
  void open(const map::MapKey& key) {
    session_->openMap(key);
    answerFetches();
    QTRY_VERIFY(session_->wholeMap().phase() == session::MapSlot::Phase::Ready);
    QTRY_VERIFY(scene_->picturesSettled());
  }
  void answerFetches() {
    for (auto& [key, reply] : std::exchange(robot_->map_fetches, {})) {
      map::WholeMap whole = FakeRobot::wholeMap(key.id, 254, 100);
      whole.grid = {0, 0, 0.01, {-0.5, -0.5, 0}};
      reply(whole);
    }
  }
  void listMaps() {
    auto here = FakeRobot::entry("1", true), elsewhere = FakeRobot::entry("2");
    here.uid = "u1";
    elsewhere.uid = "u2";
    robot_->answerList({here, elsewhere});
  }
  /// Everything that a robot can say, all of it in the middle of the picture.
  void sayEverything() {
    for (int i = 0; i < 5; ++i) robot_->say(map::TrackedPose{{-0.3 + i * 0.1, 0.1, 0}});
    map::RobotModel model;
    model.footprint = {{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.2}, {-0.2, 0.2}};
    model.expanded_footprint = model.footprint;
    robot_->say(model);
    robot_->say(map::PathMessage{kLine});
    map::LocalPathMessage local;
    local.points = kLine;
    robot_->say(local);
    robot_->say(map::TrajectoryMessage{kLine});
    map::PlanningState planning;
    planning.targets = {{0, 0, 1}};
    robot_->say(planning);
    robot_->say(map::NearbyRobotsMessage{{{"other", {0, 0, 0}, kLine, "aa"}}});
    robot_->say(map::LandmarksMessage{{{"l", {0, 0}, true}}});
    robot_->say(map::AutoDoorsMessage{{{"d", "mac", "closed", {{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.2}}}}});
    robot_->say(map::PalletsMessage{{{"p", {0, 0, 0}, 0.3, 0.2, false}}});
    map::ConstraintsMessage constraints;
    constraints.by_name["Inter residuals"] = {{{-0.3, 0.0}, {0.3, 0.0}}};
    robot_->say(constraints);
    map::PointCloudMessage cloud;
    cloud.topic = "/points";
    cloud.points = std::make_shared<const std::vector<map::CloudPoint>>(
        std::vector<map::CloudPoint>{{0.1, 0.1, 0, 0}, {-0.1, 0.1, 0, 0}});
    robot_->say(cloud);
    for (const auto kind : {map::GridKind::CostmapLow, map::GridKind::CostmapHigh, map::GridKind::Incremental,
                            map::GridKind::EnvMatch, map::GridKind::EnvSymmetry}) {
      robot_->say(grid(kind));
    }
    map::SubmapList list;
    list.uuid = "u";
    map::SubmapEntry entry;
    entry.id = {0, 0};
    entry.version = 1;
    entry.pose = geometry::poseFromYaw(0.2, 0.2, 0);
    entry.is_frozen = true;
    list.entries = {entry};
    robot_->say(list);
    robot_->answer(map::SubmapAnswer::Outcome::Ok, 0, 127);
    scene_->setTrack(std::make_shared<ui::scene::Track>(
        ui::scene::Track{{{-0.3, -0.3}, 0, 1, 10, true}, {{0.3, 0.3}, 1, 1, 10, false}}));
    QTRY_COMPARE(session_->counts().shown, 1);
    QTRY_VERIFY(session_->layerGrids().find(map::GridKind::EnvSymmetry));
    QTRY_VERIFY(session_->layerGrids().find(map::GridKind::CostmapHigh));
    QTRY_VERIFY(session_->layerGrids().find(map::GridKind::CostmapLow));
    QTRY_VERIFY(session_->layerGrids().find(map::GridKind::Incremental));
    QTRY_VERIFY(session_->layerGrids().find(map::GridKind::EnvMatch));
  }

 private Q_SLOTS:
  void init() {
    auto robot = std::make_unique<FakeRobot>();
    robot_ = robot.get();
    robot_->has_topics = robot_->has_maps = true;
    session_ = std::make_unique<Session>(std::move(robot), Session::Options{});
    robot_->setPhase(robot::ConnectionPhase::Online);
    render::TileRenderer::Options options;
    options.previews = false;
    scene_ = std::make_unique<MapScene>(options);
    scene_->setView({{0, 0}, 0.01, 0, 100, 100});
    scene_->setSession(session_.get());
    showOnly({Layer::WholeMap});
    listMaps();
  }
  void cleanup() {
    scene_.reset();
    session_.reset();
  }

  void everyLayerOfTheRobotKeepsToItsMap_data() {
    QTest::addColumn<int>("layer");
    for (const Layer layer : robotsLayers()) {
      QTest::addRow("%s", qPrintable(ui::scene::layerName(layer))) << int(layer);
    }
  }
  void everyLayerOfTheRobotKeepsToItsMap() {
    QFETCH(int, layer);
    open(kElsewhere);
    const QImage empty = painted();
    sayEverything();
    showOnly({Layer::WholeMap, Layer(layer)});
    QTRY_VERIFY(scene_->picturesSettled());
    QCOMPARE(painted(), empty);
    scene_->setRobotWanted(true);
    QTRY_VERIFY(scene_->picturesSettled() && painted() != empty);
    scene_->setRobotWanted(std::nullopt);
    QTRY_COMPARE(painted(), empty);
    open(kHere);
    QTRY_VERIFY(scene_->picturesSettled() && painted() != empty);
  }

  void thereIsNoFurtherLayerThatFollowsTheRobot() {
    open(kElsewhere);
    const QImage empty = painted();
    sayEverything();
    robot_->say(mapInfo("u1", "Map 1"));
    std::vector<Layer> all = ui::scene::allLayers();
    std::erase(all, Layer::Grid);
    std::erase(all, Layer::ScaleBar);
    showOnly(all);
    QTRY_VERIFY(scene_->picturesSettled());
    QCOMPARE(painted(), empty);
    QVERIFY(!scene_->submapAt({0.1, 0.1}));
  }

  void aChoiceIsAboutTheMapOnScreen() {
    open(kElsewhere);
    scene_->setRobotWanted(true);
    QVERIFY(scene_->robotPlace().drawn == ScreenPart::All);
    QVERIFY(scene_->robotPlace().by_choice);
    open(kHere);
    QVERIFY(!scene_->robotPlace().by_choice);
    open(kElsewhere);
    QVERIFY(scene_->robotPlace().drawn == ScreenPart::None);
  }

  void itFollowsTheRobotsWord() {
    open(kElsewhere);
    QSignalSpy moved(scene_.get(), &MapScene::robotPlaceChanged);
    robot_->say(mapInfo("u2", "Map 2"));
    QCOMPARE(moved.size(), 1);
    QVERIFY(scene_->robotPlace().where == Whereabouts::Here);
    robot_->say(mapInfo("u1", "Map 1"));
    QVERIFY(scene_->robotPlace().where == Whereabouts::Elsewhere);
    robot_->say(mapInfo("u1", "Map 1"));
    QCOMPARE(moved.size(), 2);
  }

  void submapsAloneAreTheRobotsOwn() {
    sayEverything();
    open(kElsewhere);
    showOnly({Layer::Submaps, Layer::Path});
    QVERIFY(scene_->robotPlace().drawn == ScreenPart::All);
  }

  void besideAnotherMapItStaysOnItsOwnSide() {
    open(kHere);
    session_->compareWith(kElsewhere);
    answerFetches();
    QTRY_VERIFY(session_->comparedMap().phase() == session::MapSlot::Phase::Ready);
    scene_->setCompareMode(CompareMode::Swipe);
    showOnly({Layer::WholeMap, Layer::Path});
    QTRY_VERIFY(scene_->picturesSettled());
    const QImage empty = painted();
    robot_->say(map::PathMessage{kLine});
    QVERIFY(scene_->robotPlace().drawn == ScreenPart::Left);
    QVERIFY(painted().pixel(30, 50) != empty.pixel(30, 50));
    QCOMPARE(painted().pixel(70, 50), empty.pixel(70, 50));
    open(kElsewhere);
    QVERIFY(scene_->robotPlace().drawn == ScreenPart::None);
    scene_->setCompareMode(CompareMode::Off);
    session_->compareWith(std::nullopt);
  }

  void anEarlierStateOfItsMapIsItsMap() {
    open(kHere);
    session_->keepForComparing();
    QTRY_VERIFY(session_->comparedMap().phase() == session::MapSlot::Phase::Ready);
    scene_->setCompareMode(CompareMode::Swipe);
    QVERIFY(scene_->robotPlace().drawn == ScreenPart::All);
  }

  void besideTheSubmapsItStaysWithThem() {
    sayEverything();
    open(kElsewhere);
    scene_->setCompareMode(CompareMode::Swipe);  // submaps at the left
    QVERIFY(scene_->robotPlace().drawn == ScreenPart::Left);
    open(kHere);
    QVERIFY(scene_->robotPlace().drawn == ScreenPart::All);
  }

  void bothMapsOfASwipeShowTheirOwnOverlays() {
    showOnly({Layer::WholeMap, Layer::Overlays});
    const auto with = [&](const map::MapKey& key, double y) {
      auto replies = std::exchange(robot_->map_fetches, {});
      map::WholeMap whole = FakeRobot::wholeMap(key.id, 254, 100);
      whole.grid = {0, 0, 0.01, {-0.5, -0.5, 0}};
      map::OverlayFeature wall;
      wall.shape = map::OverlayShape::Line;
      wall.type = 2;
      wall.parts = {{{-0.5, y}, {0.5, y}}};
      whole.overlays = {wall};
      for (auto& [asked, reply] : replies) reply(whole);
    };
    session_->openMap(kHere);
    with(kHere, 0.2);
    session_->compareWith(kElsewhere);
    with(kElsewhere, -0.2);
    scene_->setCompareMode(CompareMode::Swipe);
    QTRY_VERIFY(session_->wholeMap().phase() == session::MapSlot::Phase::Ready &&
                session_->comparedMap().phase() == session::MapSlot::Phase::Ready &&
                scene_->picturesSettled());
    const auto wallAt = [&](int x, int y) {
      const QRgb pixel = painted().pixel(x, y);
      return qRed(pixel) > qGreen(pixel) + 60;
    };
    QVERIFY(wallAt(25, 30));
    QVERIFY(!wallAt(75, 30));
    QVERIFY(wallAt(75, 70));
    QVERIFY(!wallAt(25, 70));
  }

  void overlaysOfItsLastMapDoNotLieOnANewOne() {
    showOnly({Layer::Submaps, Layer::Overlays});
    robot_->say(mapInfo("u1", "Map 1"));
    map::SubmapList list;
    list.uuid = "new";
    map::SubmapEntry entry;
    entry.id = {0, 0};
    entry.version = 1;
    entry.pose = geometry::poseFromYaw(5, 5, 0);
    list.entries = {entry};
    robot_->say(list);
    const QImage with = painted();
    map::SlamStatus slam;
    slam.state = "slam";
    robot_->say(slam);
    QVERIFY(!scene_->robotPlace().overlays_fit);
    QVERIFY(painted() != with);
    scene_->setRobotWanted(true);
    QCOMPARE(painted(), with);
  }

  void aRobotThatTellsNothingIsShown() {
    robot_->answerList({});
    session_->catalogue().refresh();
    robot_->answerList({FakeRobot::entry("1"), FakeRobot::entry("2")});
    open(kElsewhere);
    QVERIFY(scene_->robotPlace().where == Whereabouts::Unknown);
    QVERIFY(scene_->robotPlace().drawn == ScreenPart::All);
    scene_->setRobotWanted(false);
    QVERIFY(scene_->robotPlace().drawn == ScreenPart::None);
  }
};

}  // namespace test_robot_place

MAPWRIGHT_TEST(test_robot_place, RobotPlaceTest, Widgets)
#include "test_robot_place.moc"
