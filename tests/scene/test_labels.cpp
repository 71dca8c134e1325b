// The labels of a scene, in pixels.
#include <algorithm>
#include <cstdlib>
#include <malloc.h>
#include <random>

#include <QFontMetricsF>
#include <QImage>
#include <QPainter>
#include <QTest>

#include "fake_robot.h"
#include "map/live_topics.h"
#include "render/tile_renderer.h"
#include "session/session_options.h"
#include "test_program.h"
#include "ui/scene/drawing.h"
#include "ui/scene/label_ink.h"
#include "ui/scene/map_scene.h"

namespace test_labels {

using namespace mapwright;
using session::Session;
using test::FakeRobot;
using ui::scene::Layer;
using ui::scene::MapScene;

namespace {

constexpr int kWidth = 500, kHeight = 400;

/// Several in a small room: most have a label that had to move aside.
map::LandmarksMessage landmarks() {
  std::mt19937 random{7};
  std::uniform_real_distribution<double> at(-6, 6);
  map::LandmarksMessage message;
  for (int i = 0; i < 120; ++i)
    message.landmarks.push_back({"landmark " + std::to_string(i), {at(random), at(random)}, i % 3 > 0});
  return message;
}

/// But for the soft edges of lines, which are rounded otherwise where they are cut off.
bool alike(const QImage& a, const QImage& b) {
  if (a.size() != b.size()) return false;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const QRgb one = a.pixel(x, y), other = b.pixel(x, y);
      if (std::max({std::abs(qRed(one) - qRed(other)), std::abs(qGreen(one) - qGreen(other)),
                    std::abs(qBlue(one) - qBlue(other))}) > 4)
        return false;
    }
  }
  return true;
}

/// Nothing else is drawn there.
void sameWithin(const QImage& a, const QImage& b, const QRect& area) {
  for (int y = area.top(); y <= area.bottom(); ++y) {
    for (int x = area.left(); x <= area.right(); ++x)
      QVERIFY2(std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) < 8,
               qPrintable(QStringLiteral("%1, %2").arg(x).arg(y)));
  }
}

}  // namespace

class LabelsTest : public QObject {
  Q_OBJECT
  FakeRobot* robot_ = nullptr;
  std::unique_ptr<Session> session_;

  std::unique_ptr<MapScene> sceneOf(bool previews, const geometry::ViewTransform& view) {
    render::TileRenderer::Options options;
    options.previews = previews;
    auto scene = std::make_unique<MapScene>(options);
    for (const Layer layer : ui::scene::allLayers()) {
      scene->setLayerVisible(layer, layer == Layer::Landmarks || layer == Layer::Doors);
    }
    scene->setView(view);
    scene->setSession(session_.get());
    return scene;
  }
  static QImage painted(MapScene& scene) {
    QImage image(kWidth, kHeight, QImage::Format_RGB32);
    QPainter painter(&image);
    scene.render(&painter, QRectF(0, 0, kWidth, kHeight), QRectF(0, 0, kWidth, kHeight));
    return image;
  }

 private Q_SLOTS:
  void whatWasDrawnBeforeChangesNoLabel() {
    const ui::scene::MapTheme theme = ui::scene::lightMapTheme();
    const auto drawn = [&theme](const char* text, bool struck_through = false) {
      QImage image(200, 40, QImage::Format_ARGB32_Premultiplied);
      image.fill(Qt::white);
      QPainter painter(&image);
      ui::scene::drawLabel(painter, {10, 25}, QString::fromUtf8(text), theme, theme.text, struck_through);
      return image;
    };
    const auto width = [&theme] {
      return QFontMetricsF(theme.label_font).horizontalAdvance(QString::fromUtf8("\U0001F680 x"));
    };
    const QImage plain = drawn("Waypoint 12"), emoji = drawn("\U0001F680 x");
    const double wide = width();
    for (int again = 0; again < 3; ++again) {
      QCOMPARE(drawn("\U0001F680 x"), emoji);
      QCOMPARE(drawn("Waypoint 12"), plain);
      QCOMPARE(width(), wide);
      QVERIFY(drawn("Waypoint 12", true) != plain);
    }
  }

  void init() {
    auto robot = std::make_unique<FakeRobot>();
    robot_ = robot.get();
    robot_->has_topics = true;
    session_ = std::make_unique<Session>(std::move(robot), Session::Options{});
    robot_->setPhase(robot::ConnectionPhase::Online);
    robot_->say(landmarks());
  }
  void cleanup() { session_.reset(); }

  void theyMoveWithTheMapAsOnePicture() {
    geometry::ViewTransform view{{0, 0}, 0.015625, 0, kWidth, kHeight};
    const auto scene = sceneOf(true, view);
    QImage before = painted(*scene);
    for (int step = 0; step < 25; ++step) {
      const QPoint by(step % 2 ? 13 : 9, step % 3 ? -7 : 4);
      view = view.pannedBy({double(by.x()), double(by.y())});
      scene->setView(view);
      const QImage now = painted(*scene);
      const QRect both = now.rect() & now.rect().translated(by);
      QVERIFY2(alike(now.copy(both), before.copy(both.translated(-by))), qPrintable(QString::number(step)));
      before = now;
    }
  }

  void thereAreNamesFromFarAwayToo() {
    map::NearbyRobotsMessage robots;
    robots.robots.push_back({});
    robots.robots[0].uid = "R2";
    robots.robots[0].pose = {3, 20, 0};
    robot_->say(robots);
    const geometry::ViewTransform far{{0, 0}, 0.4, 0, kWidth, kHeight};
    const auto scene = sceneOf(false, far);
    scene->setLayerVisible(Layer::Landmarks, false);
    const QImage without = painted(*scene);
    scene->setLayerVisible(Layer::NearbyRobots, true);
    const QImage image = painted(*scene);
    int different = 0;  // beyond the symbol
    const Eigen::Vector2d at = far.pixelFromWorld({3, 20});
    for (int y = -10; y <= 10; ++y) {
      for (int x = 22; x < 40; ++x) {
        const QPoint px(int(at.x()) + x - 14, int(at.y()) + y);
        different += image.pixel(px) != without.pixel(px);
      }
    }
    QVERIFY2(different > 10, qPrintable(QString::number(different)));
  }

  void namesKeepClearOfTheScaleBarAndOfButtons() {
    // A label to the right of each would lie on one of them.
    robot_->say(map::LandmarksMessage{{{"mmmmmmmm", {-4.2, -3.1}, true}, {"nnnnnnnn", {-1.3, -3.6}, true}}});
    const geometry::ViewTransform view{{0, 0}, 0.02, 0, kWidth, kHeight};
    const auto scene = sceneOf(false, view);
    const QRect bar(8, kHeight - 40, 100, 32), buttons(200, kHeight - 40, 120, 40);
    scene->setLayerVisible(Layer::ScaleBar, true);
    scene->setLayerVisible(Layer::Landmarks, false);
    const QImage without = painted(*scene);
    scene->setCovered({QRectF(buttons)});
    scene->setLayerVisible(Layer::Landmarks, true);
    const QImage image = painted(*scene);
    for (const QRect& area : {bar, buttons}) sameWithin(image, without, area.adjusted(3, 3, -2, 0));
  }

  void namesKeepClearOfSmallRegions() {
    const geometry::ViewTransform view{{0, 0}, 0.149, 0, kWidth, kHeight};
    // One that is smaller than a name, to the right of a thing that is named.
    map::MapInfo info;
    map::OverlayFeature region;
    region.shape = map::OverlayShape::Polygon;
    region.name = "a region whose name is longer than itself";
    region.parts = {{{2, -2}, {6, -2}, {6, 2}, {2, 2}}};
    info.overlays = {region};
    robot_->say(info);
    robot_->say(map::LandmarksMessage{{{"mmmmmmmmmm", {0, 0}, true}}});
    const auto scene = sceneOf(false, view);
    scene->setLayerVisible(Layer::Overlays, true);
    scene->setLayerVisible(Layer::Landmarks, false);
    const QImage without = painted(*scene);
    scene->setLayerVisible(Layer::Landmarks, true);
    sameWithin(painted(*scene), without, QRect(265, 187, 24, 26));
  }

  void namesKeepClearOfThoseOfASwipe() {
    const geometry::ViewTransform view{{0, 0}, 0.02, 0, kWidth, kHeight};
    // To the left of both names.
    robot_->say(map::LandmarksMessage{{{"mmmmmmmmmmmmmmmm", {-3.6, 3.52}, true}}});
    const auto scene = sceneOf(false, view);
    scene->setCompareMode(ui::scene::CompareMode::Swipe);
    scene->setHalfNames(QStringLiteral("the first map, with a long name"), QStringLiteral("the second map"));
    scene->setLayerVisible(Layer::Landmarks, false);
    const QImage without = painted(*scene);
    scene->setLayerVisible(Layer::Landmarks, true);
    const QImage image = painted(*scene);
    QVERIFY(image != without);
    sameWithin(image, without, QRect(90, 14, 140, 20));
  }

  void aSnapshotDoesNotDependOnWhatWasBefore() {
    const geometry::ViewTransform view{{0.3, 0.1}, 0.02, 0, kWidth, kHeight};
    const auto fresh = sceneOf(false, view);
    const auto used = sceneOf(false, {{5, 3}, 0.01, 0.4, kWidth, kHeight});
    painted(*used);
    for (int step = 0; step < 5; ++step) {
      used->setView({{0.3 * step, 0.2}, 0.01 + 0.004 * step, 0.1 * step, kWidth, kHeight});
      painted(*used);
    }
    used->setView(view);
    QVERIFY(painted(*used) == painted(*fresh));
    QVERIFY(painted(*used) == painted(*used));
  }

  void keptLabelsHoldLittleMoreThanTheirPixels() {
    constexpr int kMany = 400;
    const auto heap = [] { return mallinfo2().uordblks; };
    if (heap() == 0) QSKIP("this allocator does not say how much is in use");
    const ui::scene::MapTheme theme = ui::scene::lightMapTheme();
    QImage screen(400, 50, QImage::Format_ARGB32_Premultiplied);
    QPainter painter(&screen);
    ui::scene::LabelInk ink;
    const auto draw = [&](int i) {
      ink.draw(painter, {10, 10}, QString::number(1000 + i), theme, Qt::darkBlue);
    };
    draw(0);  // the letters
    const std::size_t before = heap();
    for (int i = 1; i <= kMany; ++i) draw(i);
    const QSizeF size = ink.sizeOf(QStringLiteral("1000"), theme) + QSizeF(5, 5);
    const double pixels = size.width() * size.height() * 4, each = double(heap() - before) / kMany;
    QVERIFY2(each > pixels / 2, "they are kept");
    QVERIFY2(each < 2 * pixels + 1000, qPrintable(QString::number(each)));
  }
};

}  // namespace test_labels

MAPWRIGHT_TEST(test_labels, LabelsTest, Widgets)
#include "test_labels.moc"
