// A map by regions, in pixels.
#include <QImage>
#include <QPainter>
#include <QtTest>

#include "../test_timeouts.h"
#include "fake_dispatch.h"
#include "fake_robot.h"
#include "regions/region_map.h"
#include "render/tile_renderer.h"
#include "test_program.h"
#include "ui/scene/map_scene.h"

namespace test_regions_layer {

using namespace mapwright;
using regions::FakeDispatch;
using regions::RegionMap;
using ui::scene::Layer;
using ui::scene::MapScene;

namespace {

constexpr QRgb kUnknown = 0xff778899, kOccupied = 0xff15181c, kFree = 0xffffffff;
constexpr int kEdge = 200;

}  // namespace

class RegionsLayerTest : public QObject {
  Q_OBJECT
  std::unique_ptr<FakeDispatch> dispatch_;
  std::unique_ptr<RegionMap> map_;
  std::unique_ptr<MapScene> scene_;

  QImage painted() {
    QImage image(kEdge, kEdge, QImage::Format_RGB32);
    QPainter painter(&image);
    scene_->render(&painter, QRectF(0, 0, kEdge, kEdge), QRectF(0, 0, kEdge, kEdge));
    return image;
  }
  /// How many pixels around a point are neither of the three colours of cells.
  static int odd(const QImage& image, const QRect& within) {
    int count = 0;
    for (int y = within.top(); y <= within.bottom(); ++y) {
      for (int x = within.left(); x <= within.right(); ++x) {
        const QRgb pixel = image.pixel(x, y);
        count += pixel != kUnknown && pixel != kOccupied && pixel != kFree;
      }
    }
    return count;
  }
  void look(double scale) {
    scene_->setView({{0, 0}, scale, 0, kEdge, kEdge});
    map_->setView(scene_->view().visibleWorld(), {0, 0});
  }
  void answerAll() {
    while (dispatch_->answerOne()) {
    }
    QTRY_VERIFY(scene_->picturesSettled());
  }

 private Q_SLOTS:
  void init() {
    dispatch_ = std::make_unique<FakeDispatch>();
    // 100 x 100 m: free in the west, occupied in the east, unknown in the south.
    dispatch_->ground.width = dispatch_->ground.height = 2000;
    dispatch_->ground.origin = {-50, -50, 0};
    dispatch_->ground.cell = [](int x, int y) { return std::int8_t(y < 1000 ? -1 : x < 1000 ? 0 : 100); };
    map_ = std::make_unique<RegionMap>(*dispatch_, RegionMap::Options{});
    render::TileRenderer::Options options;
    options.previews = false;
    scene_ = std::make_unique<MapScene>(options);
    for (const Layer layer : ui::scene::allLayers()) scene_->setLayerVisible(layer, layer == Layer::Regions);
    scene_->setRegions(map_.get());
  }
  void cleanup() {
    scene_.reset();
    map_.reset();
    dispatch_.reset();
  }

  void whatIsNotFetchedIsHatchedAndWhatCameIsDrawn() {
    look(0.05);
    const QImage before = painted();
    QVERIFY(odd(before, {0, 0, kEdge, kEdge}) > kEdge * kEdge / 20);
    answerAll();
    const QImage after = painted();
    QCOMPARE(after.pixel(50, 50), kFree);
    QCOMPARE(after.pixel(150, 50), kOccupied);
    QCOMPARE(after.pixel(50, 150), kUnknown);
    QCOMPARE(odd(after, {0, 0, kEdge, kEdge}), 0);
    QCOMPARE(*scene_->occupancyAt({1, 1}), 100);
    QCOMPARE(*scene_->occupancyAt({-1, 1}), 0);
    QVERIFY(!scene_->occupancyAt({1, -1}));
  }
  void beyondTheMapThereIsNothingAndNoHatching() {
    look(0.8);  // 160 m: the map has 100
    answerAll();
    QVERIFY(!map_->regions().plan().tooFar());
    const QImage image = painted();
    QCOMPARE(image.pixel(80, 80), kFree);
    QCOMPARE(image.pixel(120, 80), kOccupied);
    QCOMPARE(odd(image, {4, 4, 12, 12}), 0);  // answered: nothing
  }
  void whatFailedIsMarked() {
    look(0.05);
    dispatch_->answerOne();
    dispatch_->answer = [](const map::GridRegion&) -> robot::Outcome<map::GridPart> {
      return tl::unexpected(map::Failure{.kind = map::FailureKind::TimedOut});
    };
    answerAll();
    QVERIFY(map_->regions().counts().failed > 0);
    QVERIFY(odd(painted(), {0, 0, kEdge, kEdge}) > kEdge * kEdge / 20);
  }
  void theOldIsSeenUntilTheNewIsThere() {
    look(0.05);
    answerAll();
    dispatch_->ground.cell = [](int, int) { return std::int8_t(100); };
    map_->refresh();
    QCOMPARE(painted().pixel(50, 50), kFree);
    answerAll();
    QCOMPARE(painted().pixel(50, 50), kOccupied);
    QCOMPARE(painted().pixel(50, 150), kOccupied);
  }
  void turnedMapsLieAsTheySay() {
    dispatch_->ground.origin = geometry::Pose2{0, 0, 0.5} * geometry::Pose2{-50, -50, 0};
    look(0.05);
    answerAll();
    const QImage image = painted();
    for (const auto& [x, y] :
         {std::pair(40, 60), std::pair(160, 60), std::pair(60, 170), std::pair(20, 100)}) {
      const Eigen::Vector2d world = scene_->view().worldFromPixel({x + 0.5, y + 0.5});
      const Eigen::Vector2d cell = dispatch_->ground.origin.inverse().apply(world) / 0.05;
      const int value = dispatch_->ground.cell(int(cell.x()), int(cell.y()));
      QCOMPARE(image.pixel(x, y), value < 0 ? kUnknown : value == 0 ? kFree : kOccupied);
    }
  }
  void fromFarAwayAWallStaysVisible() {
    dispatch_->ground.cell = [](int x, int) { return std::int8_t(x == 1000 ? 100 : 0); };
    look(0.4);
    answerAll();
    QCOMPARE(painted().pixel(100, 100), kOccupied);
    QCOMPARE(painted().pixel(80, 100), kFree);
  }
  void withoutAMapByRegionsNothingIsDrawn() {
    look(0.05);
    scene_->setRegions(nullptr);
    QCOMPARE(odd(painted(), {0, 0, kEdge, kEdge}), 0);
    scene_->setRegions(map_.get());
    map_.reset();
    QVERIFY(!scene_->regions());
    QCOMPARE(odd(painted(), {0, 0, kEdge, kEdge}), 0);
  }
  void aHiddenLayerIsHidden() {
    look(0.05);
    answerAll();
    scene_->setLayerVisible(Layer::Regions, false);
    QCOMPARE(painted().pixel(50, 50), kUnknown);
    QVERIFY(!scene_->occupancyAt({1, 1}));
  }
};

}  // namespace test_regions_layer

MAPWRIGHT_TEST(test_regions_layer, RegionsLayerTest, Widgets)
#include "test_regions_layer.moc"
