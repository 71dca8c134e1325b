// What the tile renderer makes of views: panning, zooming, turning, from near and from afar, and snapshots.
#include <algorithm>
#include <cmath>

#include <QSignalSpy>
#include <QtTest>

#include "painted.h"
#include "render/tile_renderer.h"
#include "scenes.h"
#include "test_program.h"
#include "work/workers.h"

namespace test_tile_views {

using namespace mapwright;
using render::Composition;
using render::DrawnTile;
using render::TileRenderer;
using testing::countNothing;
using testing::exactOf;
using testing::field;
using testing::hasStandIns;
using testing::meanDifference;
using testing::paintedPicture;
using testing::square;
using testing::viewAt;

namespace {

constexpr int kPatience = 60'000;

#define WAIT_UNTIL_SETTLED(renderer) QTRY_VERIFY_WITH_TIMEOUT((renderer).settled(), kPatience)

}  // namespace

class TestTileViews : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void tilesLieAtWholePixels();
  void panningReusesTiles();
  void noHolesAfterZoomAndTurn();
  void standInsAreBounded();
  void standInsLieWhereTheContentIs();
  void theCentreComesFirst();
  void whatIsNoLongerWantedIsDropped();
  void snapshotsEqualTheCompositor_data();
  void snapshotsEqualTheCompositor();
  void snapshotsShowNoPreviews();
  void zoomedOutItIsTheReducedExactPicture_data();
  void zoomedOutItIsTheReducedExactPicture();
  void zoomedOutAPreviewComesFirst();
  void zoomedOutOnlyWhatChangedIsMadeAgain();
  void zoomedOutAMoveShowsUpEverywhere();
  void survivesAbsurdViews();
};

void TestTileViews::tilesLieAtWholePixels() {
  TileRenderer renderer({});
  renderer.upsert(field(12, 20));
  for (int step = 0; step < 5; ++step) {
    renderer.setView(viewAt(0.0173 * step, -0.0311 * step, 0.05, 500, 400, 0.3));
    WAIT_UNTIL_SETTLED(renderer);
    const auto tiles = renderer.drawnTiles();
    QVERIFY(!tiles.empty());
    for (const DrawnTile& tile : tiles) {
      QVERIFY(!tile.stand_in);
      QVERIFY(tile.to_viewport.type() <= QTransform::TxTranslate);
      QCOMPARE(tile.to_viewport.dx(), std::round(tile.to_viewport.dx()));
      QCOMPARE(tile.to_viewport.dy(), std::round(tile.to_viewport.dy()));
      QCOMPARE(tile.image.format(), QImage::Format_RGB32);
    }
  }
}

void TestTileViews::panningReusesTiles() {
  TileRenderer renderer({});
  renderer.upsert(field(30, 40));
  renderer.setView(viewAt(0, 0, 0.05, 800, 600));
  WAIT_UNTIL_SETTLED(renderer);
  const auto composed = renderer.counts().composed;
  QVERIFY(composed > 9);
  renderer.setView(viewAt(0.3, 0.2, 0.05, 800, 600));  // 6 and 4 pixels
  WAIT_UNTIL_SETTLED(renderer);
  const auto few = renderer.counts().composed - composed;
  QVERIFY(few <= 9);  // at most a row and a column of tiles came into view
  renderer.setView(viewAt(0, 0, 0.05, 800, 600));
  QVERIFY(renderer.settled());  // back again: all is still there
}

void TestTileViews::noHolesAfterZoomAndTurn() {
  TileRenderer renderer({});
  std::vector<render::PlacedTexture> ground;
  for (int i = 0; i < 64; ++i) ground.push_back(square(i, 4.9 * (i % 8 - 4), 4.9 * (i / 8 - 4), 5, {60, 0}));
  renderer.upsert(ground);
  auto view = viewAt(-2, -2, 0.03, 600, 400);
  renderer.setView(view);
  WAIT_UNTIL_SETTLED(renderer);
  QCOMPARE(countNothing(paintedPicture(renderer, view)), 0);
  for (int step = 0; step < 12; ++step) {
    // Zooming in and turning: all of the new view was shown before, so there is never a hole.
    view = view.zoomedAt({300, 200}, 1.15).rotatedAt({300, 200}, 0.02);
    renderer.setView(view);
    QCOMPARE(countNothing(paintedPicture(renderer, view)), 0);
    QCoreApplication::processEvents();
    QCOMPARE(countNothing(paintedPicture(renderer, view)), 0);
  }
  WAIT_UNTIL_SETTLED(renderer);
  QVERIFY(!hasStandIns(renderer));
  QCOMPARE(countNothing(paintedPicture(renderer, view)), 0);
}

void TestTileViews::standInsAreBounded() {
  TileRenderer renderer({.workers = std::make_shared<work::Workers>(1)});
  renderer.upsert(field(200, 60));
  auto view = viewAt(0, 0, 0.02, 900, 700);
  renderer.setView(view);
  WAIT_UNTIL_SETTLED(renderer);
  std::size_t most = 0;
  for (int step = 0; step < 40; ++step) {
    view = view.zoomedAt({450, 350}, step % 2 == 0 ? 0.97 : 1.05);
    renderer.setView(view);
    QCoreApplication::processEvents(QEventLoop::AllEvents, 3);
    most = std::max(most, renderer.drawnTiles().size());
  }
  QVERIFY(most > 0);
  QVERIFY(most <= 150);  // five screens' worth of tiles at the very most
  WAIT_UNTIL_SETTLED(renderer);
}

void TestTileViews::standInsLieWhereTheContentIs() {
  // One small bright square on dark ground, seen through a stand-in right after zooming and turning.
  TileRenderer renderer({});
  renderer.upsert({square(0, 0, 0, 40, {0, 100}), square(1, 3, 2, 1, {127, 0})});
  const auto before = viewAt(1, 1, 0.02, 500, 400, 0.2);
  renderer.setView(before);
  WAIT_UNTIL_SETTLED(renderer);
  const auto after = before.zoomedAt({100, 80}, 0.8).rotatedAt({250, 250}, -0.7);
  renderer.setView(after);
  QVERIFY(hasStandIns(renderer));
  const QImage image = paintedPicture(renderer, after);
  const Eigen::Vector2d pixel = after.pixelFromWorld({3, 2});
  const Eigen::Vector2d beside = after.pixelFromWorld({4, 2});
  QVERIFY(qRed(image.pixel(int(pixel.x()), int(pixel.y()))) > 150);
  QVERIFY(qRed(image.pixel(int(beside.x()), int(beside.y()))) < 110);
}

void TestTileViews::theCentreComesFirst() {
  TileRenderer renderer({.workers = std::make_shared<work::Workers>(1)});
  const auto view = viewAt(6.4, 6.4, 0.05, 1280, 1280);  // the middle of a tile is in the middle of the view
  renderer.setView(view);
  renderer.upsert(field(150, 80));
  int partial = 0;
  connect(&renderer, &TileRenderer::tilesChanged, this, [&] {
    const auto tiles = renderer.drawnTiles();
    if (tiles.empty() || renderer.settled()) return;
    ++partial;
    // While some are missing, none of the drawn is farther than three tiles' reach beyond what a full disc
    // would be.
    double farthest = 0;
    for (const DrawnTile& tile : tiles) {
      const QPointF middle = tile.to_viewport.map(QPointF(128, 128)) - QPointF(640, 640);
      farthest = std::max(farthest, std::hypot(middle.x(), middle.y()));
    }
    QVERIFY(farthest <= 256 * (std::sqrt(double(tiles.size()) / 2) + 1));
  });
  WAIT_UNTIL_SETTLED(renderer);
  QVERIFY(partial > 0);
}

void TestTileViews::whatIsNoLongerWantedIsDropped() {
  // Snapshots of huge pixels take long per tile, so that work is certainly in progress when the view changes.
  TileRenderer renderer({.workers = std::make_shared<work::Workers>(1), .previews = false});
  const auto placed = field(300, 200);
  renderer.upsert(placed);
  renderer.setView(viewAt(0, 0, 0.8, 256, 256));
  QCoreApplication::sendPostedEvents();
  const auto view = viewAt(10, 5, 0.05, 200, 150, 0.4);
  renderer.setView(view);
  QVERIFY(!renderer.settled());
  WAIT_UNTIL_SETTLED(renderer);
  QTRY_VERIFY_WITH_TIMEOUT(renderer.counts().dropped_stale > 0, kPatience);
  QVERIFY(renderer.composition().intensity == exactOf(view, placed).intensity);
  // The same for content: what was begun before a change is not shown after it.
  renderer.setView(viewAt(0, 0, 0.8, 256, 256));
  QCoreApplication::sendPostedEvents();
  const auto dropped = renderer.counts().dropped_stale;
  auto moved = placed;
  for (auto& texture : moved) texture.world_from_texture.y_m += 3;
  renderer.upsert(moved);
  WAIT_UNTIL_SETTLED(renderer);
  QVERIFY(renderer.counts().dropped_stale > dropped);
  QVERIFY(renderer.composition().intensity == exactOf(viewAt(0, 0, 0.8, 256, 256), moved).intensity);
}

void TestTileViews::snapshotsEqualTheCompositor_data() {
  QTest::addColumn<double>("scale");
  QTest::addColumn<double>("rotation");
  for (const double scale : {0.009, 0.05, 0.0731, 0.25, 1.0}) {
    for (const double rotation : {0.0, 1.1})
      QTest::addRow("%g m, turned %g", scale, rotation) << scale << rotation;
  }
}

void TestTileViews::snapshotsEqualTheCompositor() {
  QFETCH(double, scale);
  QFETCH(double, rotation);
  const auto placed = field(40, 30);
  const auto view = viewAt(1.2345, -0.777, scale, 611, 347, rotation);
  TileRenderer renderer({.workers = std::make_shared<work::Workers>(2), .previews = false});
  renderer.upsert(placed);
  renderer.setView(view);
  WAIT_UNTIL_SETTLED(renderer);
  const Composition expected = exactOf(view, placed);
  const Composition actual = renderer.composition();
  QCOMPARE(actual.width_px, 611);
  QCOMPARE(actual.height_px, 347);
  QVERIFY(actual.intensity == expected.intensity);
  QVERIFY(actual.flags == expected.flags);
  QVERIFY(std::any_of(actual.flags.begin(), actual.flags.end(), [](auto flags) { return flags != 0; }));
  const auto tiles = renderer.drawnTiles();
  QVERIFY(!tiles.empty());
  for (const DrawnTile& tile : tiles) {
    QVERIFY(tile.to_viewport.dx() >= 0 && tile.to_viewport.dx() + tile.image.width() <= 611);
  }
}

void TestTileViews::snapshotsShowNoPreviews() {
  TileRenderer renderer({.previews = false});
  renderer.upsert(field(100, 100));
  bool seen = false;
  connect(&renderer, &TileRenderer::tilesChanged, this, [&] {
    seen = true;
    QCOMPARE(renderer.counts().preview, 0);
  });
  renderer.setView(viewAt(0, 0, 0.3, 600, 400));
  WAIT_UNTIL_SETTLED(renderer);
  QTRY_VERIFY(seen);
}

void TestTileViews::zoomedOutItIsTheReducedExactPicture_data() {
  QTest::addColumn<double>("scale");
  QTest::addColumn<double>("rotation");
  const std::pair<double, double> views[] = {{0.11, 0.6}, {0.2, 0},   {0.27, 0.6},
                                             {0.5, 0},    {1.3, 0.6}, {3.2, 0}};
  for (const auto& [scale, rotation] : views)
    QTest::addRow("%g m, turned %g", scale, rotation) << scale << rotation;
}

void TestTileViews::zoomedOutItIsTheReducedExactPicture() {
  QFETCH(double, scale);
  QFETCH(double, rotation);
  const auto placed = field(50, 30);
  const auto view = viewAt(0, 0, scale, 200, 150, rotation);
  TileRenderer renderer({});
  renderer.setView(view);
  renderer.upsert(placed);
  WAIT_UNTIL_SETTLED(renderer);
  const Composition actual = renderer.composition(), expected = exactOf(view, placed);
  int observed = 0, differs = 0, worst = 0;
  double sum = 0;
  for (std::size_t i = 0; i < actual.flags.size(); ++i) {
    if ((actual.flags[i] != 0) != (expected.flags[i] != 0)) ++differs;
    if (expected.flags[i] == 0) continue;
    ++observed;
    const int off = std::abs(int(actual.intensity[i]) - int(expected.intensity[i]));
    sum += off;
    worst = std::max(worst, off);
  }
  QVERIFY(observed > 50);
  QVERIFY2(sum / observed <= 4, qPrintable(QStringLiteral("%1").arg(sum / observed)));
  QVERIFY2(worst <= 60, qPrintable(QStringLiteral("%1").arg(worst)));
  QVERIFY(differs <= observed / 10 + 20);
  // Aligned powers of two are the exact picture itself.
  if (scale == 0.2 && rotation == 0) QVERIFY(worst <= 1 && differs == 0);
}

void TestTileViews::zoomedOutAPreviewComesFirst() {
  TileRenderer renderer({.workers = std::make_shared<work::Workers>(1)});
  const auto view = viewAt(0, 0, 0.5, 800, 600);
  renderer.setView(view);
  int most_previews = 0;
  connect(&renderer, &TileRenderer::tilesChanged, this,
          [&] { most_previews = std::max(most_previews, renderer.counts().preview); });
  renderer.upsert(field(100, 300));
  WAIT_UNTIL_SETTLED(renderer);
  QCOMPARE(renderer.counts().preview, 0);
  QVERIFY(most_previews >= 6);
}

void TestTileViews::zoomedOutOnlyWhatChangedIsMadeAgain() {
  TileRenderer renderer({});
  auto placed = field(200, 200);
  renderer.setView(viewAt(0, 0, 0.4, 600, 600));
  renderer.upsert(placed);
  WAIT_UNTIL_SETTLED(renderer);
  const auto all = renderer.counts().composed;
  placed[0].world_from_texture.x_m += 0.5;
  renderer.upsert({placed[0]});
  QVERIFY(!renderer.settled());
  WAIT_UNTIL_SETTLED(renderer);
  const auto again = renderer.counts().composed - all;
  QVERIFY(again > 0);
  QVERIFY(again * 4 <= all);
  const auto view = viewAt(0, 0, 0.4, 600, 600);
  QVERIFY(meanDifference(renderer.composition(), exactOf(view, placed)) < 1);
}

void TestTileViews::zoomedOutAMoveShowsUpEverywhere() {
  // At every level of the pyramid the old place has to go and the new one to come.
  TileRenderer renderer({});
  auto placed = square(0, -20, 0, 10, {100, 0});
  renderer.upsert({placed});
  const double scales[] = {0.11, 0.3, 0.9, 2.0};
  for (const double scale : scales) {
    renderer.setView(viewAt(0, 0, scale, 800, 300));
    WAIT_UNTIL_SETTLED(renderer);
    QCOMPARE(renderer.intensityAt({-20, 0}), std::optional<int>(228));
  }
  placed.world_from_texture.x_m += 40;
  renderer.upsert({placed});
  for (const double scale : scales) {
    renderer.setView(viewAt(0, 0, scale, 800, 300));
    WAIT_UNTIL_SETTLED(renderer);
    QCOMPARE(renderer.intensityAt({-20, 0}), std::nullopt);
    QCOMPARE(renderer.intensityAt({20, 0}), std::optional<int>(228));
  }
}

void TestTileViews::survivesAbsurdViews() {
  TileRenderer renderer({});
  renderer.upsert(field(20, 20));
  auto far = square(100, 0, 0, 5, {50, 0});
  far.world_from_texture.x_m = 1e300;
  renderer.upsert({far});
  const double nan = std::nan("");
  for (const auto& view :
       {viewAt(0, 0, 0, 300, 200), viewAt(nan, 0, 0.05, 300, 200), viewAt(0, 0, nan, 300, 200),
        viewAt(0, 0, 0.05, 300, 200, nan), viewAt(0, 0, 0.05, 0, 0), viewAt(0, 0, 0.05, -5, 10),
        viewAt(1e300, 0, 0.05, 300, 200), viewAt(0, 0, 1e-300, 300, 200), viewAt(0, 0, 1e-4, 300, 200),
        viewAt(1e9, -1e9, 0.05, 300, 200), viewAt(0, 0, 1e5, 300, 200)}) {
    renderer.setView(view);
    renderer.drawnTiles();
    renderer.composition();
    WAIT_UNTIL_SETTLED(renderer);
  }
}

}  // namespace test_tile_views

MAPWRIGHT_TEST(test_tile_views, TestTileViews, Core)
#include "test_tile_views.moc"
