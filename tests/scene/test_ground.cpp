// A window that repaints only what changes shows the same as a picture made at once.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <QGraphicsView>
#include <QImage>
#include <QPainter>
#include <QTest>
#include <QWindow>

#include "fake_robot.h"
#include "map/live_topics.h"
#include "render/tile_renderer.h"
#include "session/session_options.h"
#include "test_program.h"
#include "ui/scene/map_scene.h"
#include "ui/scene/map_theme.h"

namespace test_ground {

using namespace mapwright;
using session::Session;
using test::FakeRobot;
using ui::scene::Layer;
using ui::scene::MapScene;

namespace {

class PaintCounter : public QObject {
 public:
  explicit PaintCounter(QObject* of) { of->installEventFilter(this); }
  bool eventFilter(QObject*, QEvent* event) override {
    count += event->type() == QEvent::Paint;
    return false;
  }
  int count = 0;
};

}  // namespace

class GroundTest : public QObject {
  Q_OBJECT
  FakeRobot* robot_ = nullptr;
  std::unique_ptr<Session> session_;
  std::unique_ptr<MapScene> scene_;
  std::unique_ptr<QGraphicsView> view_;

  static constexpr int kWidth = 320, kHeight = 240;

  /// What the window shows by now, without painting it anew.
  QImage shown() {
    QCoreApplication::processEvents();
    QCoreApplication::processEvents();
    return view_->screen()->grabWindow(view_->winId()).toImage().convertToFormat(QImage::Format_RGB32);
  }
  QImage painted() {
    QImage image(kWidth, kHeight, QImage::Format_RGB32);
    QPainter painter(&image);
    scene_->render(&painter, QRectF(0, 0, kWidth, kHeight), QRectF(0, 0, kWidth, kHeight));
    return image;
  }
  QByteArray difference() {
    const QImage shows = shown(), right = painted();
    if (shows.size() != right.size()) return "another size";
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        // Where a part of a line is drawn, its soft edge may be rounded otherwise than with the whole of it.
        const QRgb is = shows.pixel(x, y), should = right.pixel(x, y);
        if (std::max({std::abs(qRed(is) - qRed(should)), std::abs(qGreen(is) - qGreen(should)),
                      std::abs(qBlue(is) - qBlue(should))}) > 4)
          return QStringLiteral("at %1, %2: %3 instead of %4")
              .arg(x)
              .arg(y)
              .arg(is, 0, 16)
              .arg(should, 0, 16)
              .toUtf8();
      }
    }
    return {};
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
    view_ = std::make_unique<QGraphicsView>(scene_.get());
    view_->setFrameShape(QFrame::NoFrame);
    view_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view_->resize(kWidth, kHeight);
    scene_->setView({{0, 0}, 0.01, 0, kWidth, kHeight});
    scene_->setSession(session_.get());
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
  }
  void cleanup() {
    view_.reset();
    scene_.reset();
    session_.reset();
  }

  void whatMovesLeavesNothingBehind() {
    map::RobotModel model;
    model.footprint = {{0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}, {-0.1, -0.1}};
    robot_->say(model);
    robot_->say(map::LandmarksMessage{{{"landmark", {0.1, 0.2}, true}, {"another", {0.15, 0.15}, false}}});
    for (int step = 0; step < 60; ++step) {
      const double turn = step * 0.21, x = std::cos(turn), y = std::sin(turn);
      robot_->say(map::TrackedPose{{x * 0.9, y * 0.7, turn}});
      if (step % 3 == 0) robot_->say(map::PathMessage{{{x, y}, {x / 2, 0.1}, {-0.3, y / 3}}});
      if (step % 4 == 1) {
        map::LocalPathMessage local;
        local.points = {{x, y}, {0, x}};
        local.width_m = 0.08;
        robot_->say(local);
      }
      if (step % 5 == 2) {
        robot_->say(map::NearbyRobotsMessage{{{"robot 7", {-x / 2, y / 2, turn}, {{-x, 0}, {0, y}}, "aa"}}});
        map::PlanningState planning;
        planning.targets = {{-x / 3, -y / 3, 1}};
        robot_->say(planning);
      }
      if (step % 7 == 3) {
        map::PointCloudMessage cloud;
        cloud.topic = "/scan_matched_points2";
        cloud.points = std::make_shared<const std::vector<map::CloudPoint>>(
            std::vector<map::CloudPoint>{{x, 0.1, 0, 0}, {0.3, y, 0, 0}});
        robot_->say(cloud);
      }
      if (step % 11 == 4)
        robot_->say(map::PalletsMessage{{{"box", {0.4, -0.2 * x, turn}, 0.2, 0.1, step % 2 == 0}}});
      if (step == 25) robot_->say(map::PathMessage{{}});
      if (step == 40) robot_->say(map::NearbyRobotsMessage{});
      const QByteArray wrong = difference();
      QVERIFY2(wrong.isEmpty(), QByteArray::number(step) + ": " + wrong);
    }
  }

  void overlaysOfWhichAPartIsPaintedAgainAreTheSame() {
    using map::OverlayShape;
    const auto overlay = [](OverlayShape shape, int type, const char* id,
                            std::vector<std::vector<Eigen::Vector2d>> parts) {
      map::OverlayFeature made;
      made.shape = shape;
      made.type = type;
      made.id = id;
      made.parts = std::move(parts);
      made.yaw_rad = 0.7;
      return made;
    };
    map::MapInfo info;
    info.overlays = {overlay(OverlayShape::Polygon, 1, "forbidden", {{{-1, -0.8}, {0.3, -0.6}, {0, 0.5}}}),
                     overlay(OverlayShape::Line, 1, "dashed", {{{-1.4, 0.9}, {1.5, -1}, {1.5, 1}}}),
                     overlay(OverlayShape::Line, 2, "upright", {{{0.5, -1}, {0.5, 1}}}),
                     overlay(OverlayShape::Point, 9, "charger", {{{0.6, 0.3}}}),
                     overlay(OverlayShape::Point, 0, "place", {{{-0.2, 0.1}}})};
    robot_->say(info);
    QVERIFY2(difference().isEmpty(), difference());
    for (int step = 0; step < 40; ++step) {
      const double turn = step * 0.37;
      robot_->say(
          map::LandmarksMessage{{{"landmark", {std::cos(turn), 0.8 * std::sin(turn)}, step % 2 == 0}}});
      const QByteArray wrong = difference();
      QVERIFY2(wrong.isEmpty(), QByteArray::number(step) + ": " + wrong);
    }
  }

  /// A robot sends its map and the list of its submaps all the time.
  void whatIsTheSameAsBeforeIsNotPaintedAgain() {
    map::MapInfo info;
    info.overlays.resize(1);
    info.overlays[0].parts = {{{0.2, 0.1}}};
    robot_->say(info);
    QVERIFY(!shown().isNull());
    PaintCounter paints(view_->viewport());
    Q_EMIT session_->listChanged();
    shown();
    QCOMPARE(paints.count, 0);
  }

  void whatIsChosenForTheLayersIsSeenAtOnce() {
    robot_->say(map::TrackedPose{{0, 0, 0}});
    robot_->say(map::PathMessage{{{-1, -0.5}, {1, 0.5}}});
    robot_->say(map::AutoDoorsMessage{{{"Door", "mac", "closed", {{0.2, 0.2}, {0.5, 0.2}, {0.5, 0.3}}}}});
    QVERIFY2(difference().isEmpty(), difference());
    const QImage before = painted();
    const auto check = [&](auto change) {
      change();
      const QByteArray wrong = difference();
      QVERIFY2(wrong.isEmpty(), wrong);
      QVERIFY(painted() != before);
    };
    check([&] { scene_->setLayerVisible(Layer::Grid, false); });
    check([&] { scene_->setLayerOpacity(Layer::Path, 0.4); });
    check([&] { scene_->setLayerStyle(Layer::Path, {.color = Qt::green, .size = 7}); });
    check([&] { scene_->setLayerVisible(Layer::Doors, false); });
    check([&] { scene_->setTheme(ui::scene::darkMapTheme()); });
    check([&] { scene_->setMeasurement({{-0.5, 0}, {0.5, 0.4}, {0.6, -0.4}}); });
    check([&] { scene_->setStale(true); });
    check([&] {
      std::vector<Layer> order = scene_->layerOrder();
      std::erase(order, Layer::Robot);
      order.insert(order.begin(), Layer::Robot);
      scene_->setLayerOrder(order);
    });
    check([&] { scene_->setView(scene_->view().pannedBy({13, -7})); });
    check([&] { scene_->setLayerVisible(Layer::Path, false); });
  }

  void aRobotThatMovesRepaintsOnlyItself() {
    robot_->say(map::TrackedPose{{-0.5, 0, 0}});
    QVERIFY(!shown().isNull());
    PaintCounter paints(view_->viewport());
    shown();
    const int idle = paints.count;
    QCOMPARE(idle, 0);
    robot_->say(map::TrackedPose{{-0.5, 0, 0}});  // as before
    shown();
    QCOMPARE(paints.count, 0);
    robot_->say(map::TrackedPose{{-0.45, 0, 0}});
    shown();
    QCOMPARE(paints.count, 1);
  }
};

}  // namespace test_ground

MAPWRIGHT_TEST(test_ground, GroundTest, Widgets)
#include "test_ground.moc"
