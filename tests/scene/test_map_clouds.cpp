// Clouds on the map: in the scene, cut, written.
#include <QImage>
#include <QPainter>
#include <QTemporaryDir>
#include <QtTest>

#include "clouds/cloud_store.h"
#include "render/tile_renderer.h"
#include "test_program.h"
#include "ui/scene/clouds_layer.h"
#include "ui/scene/map_scene.h"

namespace test_map_clouds {

using namespace mapwright;
using ui::scene::Layer;

namespace {

/// A floor of points 5 cm apart, with a wall of 2 m along its left edge.
std::shared_ptr<const map::SpatialCloud> hall(double width_m, float floor_z = 0) {
  auto cloud = std::make_shared<map::SpatialCloud>();
  cloud->frame = "map";
  for (int x = 0; x < int(width_m * 20); ++x) {
    for (int y = 0; y < int(width_m * 20); ++y) {
      cloud->points.emplace_back(float(x) * 0.05F + 0.025F, float(y) * 0.05F + 0.025F, floor_z);
    }
  }
  for (int y = 0; y < int(width_m * 20); ++y) {
    for (int z = 0; z < 40; ++z)
      cloud->points.emplace_back(0.025F, float(y) * 0.05F + 0.025F, floor_z + float(z) * 0.05F);
  }
  return cloud;
}

struct Stage {
  explicit Stage(bool previews = false) {
    render::TileRenderer::Options options;
    options.previews = previews;
    scene = std::make_unique<ui::scene::MapScene>(options, store);
    for (const Layer layer : ui::scene::allLayers())
      scene->setLayerVisible(layer, layer == Layer::DispatchedCloud);
    geometry::ViewTransform view;
    view.center_m = {5, 5};
    view.scale_m_per_px = 0.05;
    view.width_px = view.height_px = 200;
    scene->setView(view);
  }
  clouds::CloudStore& clouds() { return *store; }
  void add(std::shared_ptr<const map::SpatialCloud> cloud, std::optional<map::CloudRegion> region = {}) {
    clouds().add({std::move(cloud), false, region});
    QTRY_VERIFY(clouds().settled());
  }
  QImage picture() {
    QImage image(200, 200, QImage::Format_ARGB32_Premultiplied);
    if (!QTest::qWaitFor([this] { return scene->picturesSettled(); }, 30'000)) return {};
    image.fill(Qt::white);
    QPainter painter(&image);
    scene->render(&painter, QRectF(0, 0, 200, 200), QRectF(0, 0, 200, 200));
    return image;
  }
  std::shared_ptr<clouds::CloudStore> store = std::make_shared<clouds::CloudStore>();
  std::unique_ptr<ui::scene::MapScene> scene;
};

}  // namespace

class TestMapClouds : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aCloudLiesOnTheMapWhereItIs() {
    Stage stage;
    const QRgb bare = stage.picture().pixel(100, 100);
    stage.add(hall(10));
    const QImage picture = stage.picture();
    QVERIFY(picture.pixel(100, 100) != bare);
    // The wall is higher than the floor.
    QVERIFY(picture.pixel(0, 100) != picture.pixel(100, 100));
    QCOMPARE(stage.clouds().sums().shown, std::uint64_t(200 * 200 + 200 * 40));
    QVERIFY(stage.clouds().bounds().contains({9.9, 9.9}));
  }

  void pictureHasTheSameBytesEveryTime() {
    Stage one, two;
    one.add(hall(10));
    two.add(hall(10));
    const QImage picture = one.picture();
    QVERIFY(!picture.isNull());
    QCOMPARE(picture, two.picture());
    QCOMPARE(picture, one.picture());
  }

  void itCanBeHiddenClearedAndColouredOtherwise() {
    Stage stage;
    const QImage bare = stage.picture();
    stage.add(hall(10));
    const QImage shown = stage.picture();
    stage.scene->setLayerStyle(Layer::DispatchedCloud,
                               {.color = Qt::red, .choice = int(ui::scene::DispatchedCloudChoice::OneColor)});
    const QImage red = stage.picture();
    QVERIFY(red != shown);
    // Few points in a pixel let the ground through.
    const QColor there = red.pixelColor(100, 100);
    QVERIFY(there.red() > 180 && there.green() < 80 && there.blue() < 80);
    stage.scene->setLayerVisible(Layer::DispatchedCloud, false);
    QCOMPARE(stage.picture(), bare);
    stage.scene->setLayerVisible(Layer::DispatchedCloud, true);
    QCOMPARE(stage.picture(), red);
    stage.clouds().clear();
    QCOMPARE(stage.picture(), bare);
    QVERIFY(stage.clouds().empty());
  }

  void onlyTheChosenHeightsAreShownAndCounted() {
    Stage stage;
    const QImage bare = stage.picture();
    stage.add(hall(10));
    stage.clouds().setHeightRange(clouds::HeightRange{0.5, 5});
    QTRY_VERIFY(stage.clouds().settled());
    QCOMPARE(stage.clouds().sums().shown, std::uint64_t(200 * 30));
    const QImage picture = stage.picture();
    QCOMPARE(picture.pixel(100, 100), bare.pixel(100, 100));
    QVERIFY(picture.pixel(0, 100) != bare.pixel(0, 100));
    // The histogram is of all.
    QCOMPARE(stage.clouds().heights().points, std::uint64_t(200 * 200 + 200 * 40));
  }

  void theNewestCloudOfARegionIsShown() {
    Stage stage;
    stage.add(hall(10));
    map::CloudRegion region;
    region.centre_m = {5, 5, 0};
    region.size_m = {4, 4, 10};
    stage.add(std::make_shared<map::SpatialCloud>(), region);
    QVERIFY(stage.clouds().sums().shown < 200 * 200 + 200 * 40);
    Stage bare;
    QCOMPARE(stage.picture().pixel(100, 100), bare.picture().pixel(100, 100));
  }

  void cloudsThatComeWhileOthersArePutInOrderAreAllThereInTheEnd() {
    Stage stage;
    for (int i = 0; i < 5; ++i) {
      map::CloudRegion region;
      region.centre_m = {i * 20.0, 0, 0};
      region.size_m = {1, 1, 1};
      stage.clouds().add({hall(1), i % 2 == 1, region});
    }
    QVERIFY(!stage.clouds().settled());
    QTRY_VERIFY(stage.clouds().settled());
    QCOMPARE(stage.clouds().sums().clouds, std::size_t(5));
    QVERIFY(stage.clouds().sums().voxels);
  }

  void whatIsClearedWhileItIsPutInOrderDoesNotComeBack() {
    Stage stage;
    stage.clouds().add({hall(10)});
    stage.clouds().clear();
    QVERIFY(stage.clouds().settled());
    stage.add(hall(1));
    QCOMPARE(stage.clouds().sums().clouds, std::size_t(1));
    QCOMPARE(stage.clouds().sums().came, std::uint64_t(20 * 20 + 20 * 40));
  }

  void aSectionShowsTheWallFromItsSide() {
    Stage stage;
    stage.add(hall(10));
    std::shared_ptr<const clouds::Section> made;
    stage.clouds().cut({{-1, 5}, {9, 5}, 0.4}, [&](auto section) { made = section; });
    QTRY_VERIFY(made != nullptr);
    QCOMPARE(made->points, std::uint64_t(8 * 180 + 8 * 40));
    QVERIFY(std::abs(made->high_m - 1.95) < 1e-3 && std::abs(made->low_m) < 1e-3);
    const auto nearest = clouds::nearestIn(*made, {1, 1.9}, 0.2);
    QVERIFY(nearest && (*nearest - Eigen::Vector2d(1.025, 1.9)).norm() < 0.01);
    QVERIFY(!clouds::nearestIn(*made, {5, 1.5}, 0.2));
    const render::TilePainter painter = ui::scene::sectionPainter(
        made, stage.clouds(), stage.scene->layerStyle(Layer::DispatchedCloud), stage.scene->theme(), 1);
    render::PixelGrid grid;
    grid.scale_m_per_px = 0.05;
    grid.width_px = grid.height_px = 64;
    grid.first_row = -60;
    const std::atomic<bool> cancelled = false;
    const QImage image = painter(grid, cancelled);
    QCOMPARE(image.size(), QSize(64, 64));
    QVERIFY(qAlpha(image.pixel(20, 40)) > 0);  // the wall, 1 m along and 1 m up
    QCOMPARE(qAlpha(image.pixel(40, 40)), 0);  // the air
    QVERIFY(qAlpha(image.pixel(40, 60)) > 0);  // the floor
  }

  void aLaterCutTakesThePlaceOfOneThatIsNotMadeYet() {
    Stage stage;
    stage.add(hall(10));
    int replies = 0;
    std::shared_ptr<const clouds::Section> last;
    for (int i = 1; i <= 20; ++i) {
      stage.clouds().cut({{-1, 5}, {double(i), 5}, 0.4}, [&](auto section) {
        ++replies;
        last = section;
      });
    }
    QTRY_VERIFY(last && last->cut.to_m.x() == 20);
    QVERIFY(replies < 20);
  }

  void whatIsShownIsWritten() {
    QTemporaryDir folder;
    Stage stage;
    stage.add(hall(10));
    stage.clouds().setHeightRange(clouds::HeightRange{0.5, 5});
    const QString path = folder.filePath(QStringLiteral("wall.ply"));
    std::optional<tl::expected<std::uint64_t, Fault>> outcome;
    stage.clouds().write(path, [&](const auto& given) { outcome = given; });
    QTRY_VERIFY(outcome.has_value());
    QVERIFY(outcome->has_value());
    QCOMPARE(**outcome, std::uint64_t(200 * 30));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().contains("element vertex 6000\n"));
    outcome.reset();
    stage.clouds().write(folder.filePath(QStringLiteral("none/wall.ply")),
                         [&](const auto& given) { outcome = given; });
    QTRY_VERIFY(outcome.has_value());
    QVERIFY(!outcome->has_value());
    QVERIFY(outcome->error().any());
  }

  void aSceneMayGoWhileItsCloudsArePutInOrder() {
    Stage stage(true);
    stage.clouds().add({hall(20)});
    int told = 0;
    stage.clouds().cut({{-1, 5}, {9, 5}, 0.4}, [&](const auto&) { ++told; });
    stage.scene.reset();
    stage.store.reset();
    QCoreApplication::processEvents();
    QCOMPARE(told, 0);
  }
};

}  // namespace test_map_clouds

MAPWRIGHT_TEST(test_map_clouds, TestMapClouds, Widgets)
#include "test_map_clouds.moc"
