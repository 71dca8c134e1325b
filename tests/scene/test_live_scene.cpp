// Whole maps, live layers, order and comparison, in pixels.
#include <cmath>
#include <set>

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

namespace test_live_scene {

using namespace mapwright;
using session::Session;
using test::FakeRobot;
using ui::scene::CompareMode;
using ui::scene::Layer;
using ui::scene::MapScene;

namespace {

constexpr QRgb kUnknown = 0xff778899, kOccupied = 0xff15181c;
constexpr QRgb kNearlyFree = 0xfffefefe;  // gray 254

/// 100 x 100 pixels of one centimetre about the origin; the picture covers x, y in -0.4..0.4.
map::GridMessage grid(map::GridKind kind, int gray) {
  map::GridMessage message;
  message.topic = "/grid";
  message.kind = kind;
  message.grid = {0, 0, 0.01, {-0.4, -0.4, 0}};
  message.png = test::grayPicture(80, 80, gray);
  return message;
}

}  // namespace

class LiveSceneTest : public QObject {
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
  QRgb at(int x, int y) { return painted().pixel(x, y); }
  void showOnly(std::vector<Layer> layers) {
    for (const Layer layer : ui::scene::allLayers()) {
      scene_->setLayerVisible(layer, std::find(layers.begin(), layers.end(), layer) != layers.end());
    }
  }
  void showWhole(int gray) {
    const auto before = session_->wholeMap().cells();
    robot_->say(grid(map::GridKind::WholeMap, gray));
    // It is seen while it is read: all of it has to be there.
    QTRY_VERIFY(session_->wholeMap().cells() && session_->wholeMap().cells() != before &&
                session_->wholeMap().phase() == session::MapSlot::Phase::Ready && scene_->picturesSettled());
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
    map::Streams all;
    for (const Layer layer : ui::scene::allLayers()) all.merge(ui::scene::layerStreams(layer));
    session_->want(QStringLiteral("bench"), all);  // such a scene asks for nothing
    showOnly({Layer::WholeMap});
  }
  void cleanup() {
    scene_.reset();
    session_.reset();
  }

  void theWholeMapLiesWhereItsOriginSays() {
    showWhole(254);
    QCOMPARE(at(50, 50), kNearlyFree);
    QCOMPARE(at(11, 11), kNearlyFree);
    QCOMPARE(at(5, 50), kUnknown);
    QCOMPARE(*scene_->occupancyAt({0, 0}), 0);
    QVERIFY(!scene_->occupancyAt({0.45, 0}));
  }

  void theTrailIsNotDrawnAcrossAJump() {
    showOnly({Layer::Trail});
    const QRgb ground = at(40, 20);
    robot_->say(map::TrackedPose{{-0.45, 0.3, 0}});
    robot_->say(map::TrackedPose{{-0.25, 0.3, 0}});
    QTRY_VERIFY(at(15, 20) != ground);
    robot_->say(map::TrackedPose{{0.4, 0.3, 0}});
    robot_->say(map::TrackedPose{{0.2, 0.3, 0}});
    QTRY_VERIFY(at(80, 20) != ground);
    QCOMPARE(at(50, 20), ground);
  }

  void unknownCellsShowTheGroundOfTheTheme() {
    showWhole(128);
    QCOMPARE(at(50, 50), kUnknown);
  }

  void submapsLieOnTheWholeMapAndLetItShine() {
    showWhole(0);
    showOnly({Layer::WholeMap, Layer::Submaps});
    map::SubmapList list;
    list.uuid = "u";
    map::SubmapEntry entry;
    entry.id = {0, 0};
    entry.version = 1;
    entry.pose = geometry::poseFromYaw(0.2, 0.2, 0);
    list.entries = {entry};
    robot_->say(list);
    robot_->answer(map::SubmapAnswer::Outcome::Ok, 0, 127);
    QTRY_VERIFY(session_->counts().shown == 1 && scene_->settled());
    QVERIFY(at(60, 40) != kOccupied);  // the submap
    QCOMPARE(at(20, 70), kOccupied);   // the whole map beside it
    scene_->setLayerVisible(Layer::WholeMap, false);
    QTRY_VERIFY(scene_->settled());
    QCOMPARE(at(20, 70), kUnknown);
  }

  void aCostmapLiesOverTheMap() {
    showWhole(254);
    showOnly({Layer::WholeMap, Layer::CostmapLow});
    map::GridMessage costs = grid(map::GridKind::CostmapLow, 0);
    auto picture = std::make_shared<std::string>(*costs.png);
    for (std::size_t i = picture->size() - 80 * 10; i < picture->size(); ++i) (*picture)[i] = char(254);
    costs.png = picture;
    costs.topic = "/maps/5cm/1hz";
    robot_->say(costs);
    QTRY_VERIFY(session_->layerGrids().find(map::GridKind::CostmapLow) && scene_->picturesSettled());
    QTRY_VERIFY(qRed(at(50, 85)) > 2 * qGreen(at(50, 85)));  // obstacles in the lowest ten rows
    QCOMPARE(at(50, 50), kNearlyFree);                       // no cost, no colour
  }

  void aCostmapOfOccupancyIsDrawnByItsCosts() {
    showWhole(254);
    showOnly({Layer::WholeMap, Layer::CostmapLow});
    map::GridMessage costs = grid(map::GridKind::CostmapLow, 0);
    costs.topic = "/local_costmap/costmap";
    costs.reading.mode = map::CellReading::Mode::Raw;
    // Bands of 16 rows: free, dear, inscribed, lethal, unknown.
    auto picture = std::make_shared<std::string>("P5\n80 80\n255\n");
    for (const int cost : {0, 60, 99, 100, 255}) *picture += std::string(80 * 16, char(cost));
    costs.png = picture;
    robot_->say(costs);
    QTRY_VERIFY(session_->layerGrids().find(map::GridKind::CostmapLow) && scene_->picturesSettled());
    const auto band = [this](int n) { return at(50, 10 + n * 16 + 8); };
    QTRY_VERIFY(band(3) != kNearlyFree);
    QCOMPARE(band(0), kNearlyFree);
    QCOMPARE(band(4), kNearlyFree);
    QVERIFY(qRed(band(1)) > qBlue(band(1)) + 30);
    const std::set<QRgb> colours{band(0), band(1), band(2), band(3)};
    QCOMPARE(colours.size(), std::size_t(4));
  }

  void lidarPointsAppearAndMove() {
    showOnly({Layer::Cloud});
    const auto points = [](double x) {
      map::PointCloudMessage message;
      message.topic = "/scan_matched_points2";
      message.points = std::make_shared<const std::vector<map::CloudPoint>>(
          std::vector<map::CloudPoint>{{x, 0.1, 0, 0}, {1e9, 1e9, 0, 0}});
      return message;
    };
    robot_->say(points(0.2));
    QVERIFY(at(70, 40) != kUnknown);
    robot_->say(points(-0.2));
    QCOMPARE(at(70, 40), kUnknown);
    QVERIFY(at(30, 40) != kUnknown);
    ui::scene::LayerStyle style;
    style.color = Qt::green;
    style.size = 5;
    scene_->setLayerStyle(Layer::Cloud, style);
    QCOMPARE(at(28, 38), QColor(Qt::green).rgb());
  }

  void nothingOfAnOldFrameIsDrawn() {
    showOnly({Layer::Cloud, Layer::Path, Layer::Robot, Layer::Trail, Layer::Landmarks, Layer::Doors});
    map::SubmapList list;
    list.uuid = "u";
    robot_->say(list);
    const QImage before = painted();
    const map::Polyline line{{-0.3, 0}, {0.3, 0}};
    const auto draw = [&](const map::TopicMessage& message) {
      const QImage without = painted();
      robot_->say(message);
      QVERIFY(painted() != without);
    };
    draw(map::PathMessage{line});
    draw(
        map::PointCloudMessage{"/scan_matched_points2", std::make_shared<const std::vector<map::CloudPoint>>(
                                                            std::vector<map::CloudPoint>{{0.2, 0.1, 0, 0}})});
    draw(map::LandmarksMessage{{{"l", {-0.2, -0.2}, true}}});
    draw(map::TrackedPose{{0, 0.3, 0}});
    list.uuid = "v";
    robot_->say(list);
    QVERIFY(painted() == before);
  }

  void livePartsAreDrawnFromTheLiveState_data() {
    QTest::addColumn<int>("layer");
    for (const Layer layer :
         {Layer::Path, Layer::LocalPath, Layer::Trajectory, Layer::Target, Layer::NearbyRobots,
          Layer::Landmarks, Layer::Doors, Layer::Boxes, Layer::Constraints, Layer::Overlays}) {
      QTest::addRow("%s", qPrintable(ui::scene::layerName(layer))) << int(layer);
    }
  }
  void livePartsAreDrawnFromTheLiveState() {
    QFETCH(int, layer);
    showOnly({Layer(layer)});
    const QImage before = painted();
    const map::Polyline line{{-0.3, 0}, {0.3, 0}};
    robot_->say(map::PathMessage{line});
    map::LocalPathMessage local;
    local.points = line;
    local.width_m = 0.1;
    robot_->say(local);
    robot_->say(map::TrajectoryMessage{line});
    map::PlanningState planning;
    planning.targets = {{0, 0, 1}};
    robot_->say(planning);
    robot_->say(map::NearbyRobotsMessage{{{"robot <b>", {0, 0, 0}, line, "aa"}}});
    robot_->say(map::LandmarksMessage{{{"l", {0, 0}, true}}});
    const map::Polyline square{{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.2}, {-0.2, 0.2}};
    robot_->say(map::AutoDoorsMessage{{{"d", "mac", "closed", square}}});
    robot_->say(map::PalletsMessage{{{"p", {0, 0, 0}, 0.3, 0.2, false}}});
    map::ConstraintsMessage constraints;
    constraints.by_name["Inter residuals"] = {{{-0.3, 0.0}, {0.3, 0.0}}};
    robot_->say(constraints);
    map::MapInfo info;
    map::OverlayFeature wall;
    wall.shape = map::OverlayShape::Line;
    wall.type = 2;
    wall.parts = {line};
    info.overlays = {wall};
    robot_->say(info);
    QVERIFY(painted() != before);
    QVERIFY(painted().pixel(50, 50) != kUnknown || painted().pixel(59, 50) != kUnknown);
  }

  void layersStandInTheOrderThatTheUserGivesThem() {
    showWhole(254);
    showOnly({Layer::WholeMap, Layer::Path});
    robot_->say(map::PathMessage{{{-0.3, 0}, {0.3, 0}}});
    QVERIFY(at(50, 50) != (kNearlyFree));
    std::vector<Layer> order = scene_->layerOrder();
    std::erase(order, Layer::Path);
    order.insert(order.begin(), Layer::Path);
    scene_->setLayerOrder(order);
    QCOMPARE(at(50, 50), kNearlyFree);  // hidden under the map
    QVERIFY(scene_->layerOrder().back() == Layer::ScaleBar);
    scene_->setLayerOrder({});
    QCOMPARE(scene_->layerOrder().size(), ui::scene::allLayers().size());
  }

  void aPartOfThePictureIsPaintedLikeTheWhole() {
    showOnly({Layer::WholeMap, Layer::Grid, Layer::ScaleBar, Layer::Trail, Layer::Robot});
    showWhole(254);
    scene_->setView({{0.033, -0.021}, 0.01, 0, 230, 170});
    for (int step = 0; step < 40; ++step) {
      robot_->say(map::TrackedPose{{std::cos(step * 0.3) * 0.8, std::sin(step * 0.3) * 0.6, step * 0.3}});
    }
    QTRY_VERIFY(scene_->picturesSettled());
    const QRect all(0, 0, 230, 170);
    QImage whole(all.size(), QImage::Format_RGB32), parts(all.size(), QImage::Format_RGB32);
    whole.fill(Qt::red);
    parts.fill(Qt::red);
    QPainter on_whole(&whole), on_parts(&parts);
    scene_->render(&on_whole, all, all);
    for (int y = 0; y < all.height(); y += 41) {
      for (int x = 0; x < all.width(); x += 37) {
        const QRect part = QRect(x, y, 37, 41) & all;
        scene_->render(&on_parts, part, part);
      }
    }
    QCOMPARE(parts, whole);
  }

  void swipingShowsOneMapOnEachSide() {
    showWhole(254);
    session_->keepForComparing();
    QTRY_VERIFY(session_->comparedMap().phase() == session::MapSlot::Phase::Ready);
    showWhole(0);
    scene_->setCompareMode(CompareMode::Swipe);
    QTRY_VERIFY(scene_->picturesSettled());
    QTRY_COMPARE(at(20, 50), kOccupied);    // the map as it is
    QTRY_COMPARE(at(80, 50), kNearlyFree);  // as it was
    scene_->setSwipeAt(0.9);
    QCOMPARE(at(80, 50), kOccupied);
    scene_->setCompareMode(CompareMode::Difference);
    QTRY_COMPARE(at(50, 50), QRgb(0xffd93e48));  // new since then
    scene_->setCompareMode(CompareMode::Off);
    QTRY_COMPARE(at(80, 50), kOccupied);
  }

  void visibleLayersAskForTheirTopicsAndHiddenOnesDoNot() {
    session_->want(QStringLiteral("bench"), {});
    scene_ = std::make_unique<MapScene>(render::TileRenderer::Options{});
    scene_->setSession(session_.get());
    showOnly({Layer::Path, Layer::Cloud});
    QVERIFY(robot_->wanted.contains(QStringLiteral("/path")));
    QVERIFY(robot_->wanted.contains(QStringLiteral("/scan_matched_points2")));
    QVERIFY(!robot_->wanted.contains(QStringLiteral("/maps/1cm/1hz")));
    scene_->setLayerVisible(Layer::CostmapHigh, true);
    QVERIFY(robot_->wanted.contains(QStringLiteral("/maps/1cm/1hz")));
    scene_->setLayerVisible(Layer::Path, false);
    QVERIFY(!robot_->wanted.contains(QStringLiteral("/path")));
  }

  void anOpenedMapBringsItsOwnOverlaysAndPoints() {
    showOnly({Layer::WholeMap, Layer::Overlays, Layer::Waypoints});
    session_->openMap({map::MapKind::Stored, "7"});
    map::WholeMap whole = FakeRobot::wholeMap("7", 254, 80);
    whole.grid = {0, 0, 0.01, {-0.4, -0.4, 0}};
    map::OverlayFeature wall;
    wall.shape = map::OverlayShape::Line;
    wall.type = 2;
    wall.parts = {{{-0.3, 0.2}, {0.3, 0.2}}};
    whole.overlays = {wall};
    robot_->map_fetches[0].second(whole);
    map::WaypointList list;
    list.points.push_back({"1", "", "", {0.2, -0.2}, {}});
    robot_->waypoint_asks[0].second(list);
    QTRY_VERIFY(session_->wholeMap().phase() == session::MapSlot::Phase::Ready && scene_->picturesSettled());
    QVERIFY(qRed(at(50, 30)) > qGreen(at(50, 30)) + 60);
    QVERIFY(at(70, 70) != (kNearlyFree));
  }

  void aNewSessionForgetsTheLiveWorldOfTheOld() {
    showOnly({Layer::Path});
    robot_->say(map::PathMessage{{{-0.3, 0}, {0.3, 0}}});
    QVERIFY(at(50, 50) != kUnknown);
    scene_->setSession(nullptr);
    QCOMPARE(at(50, 50), kUnknown);
  }

  void contentBoundsFollowWhatIsShown() {
    QVERIFY(scene_->contentBounds().empty());
    showWhole(254);
    const geometry::WorldRect bounds = scene_->contentBounds();
    QVERIFY(std::abs(bounds.min_x + 0.4) < 1e-9 && std::abs(bounds.max_y - 0.4) < 1e-9);
  }
};

}  // namespace test_live_scene

MAPWRIGHT_TEST(test_live_scene, LiveSceneTest, Widgets)
#include "test_live_scene.moc"
