// What the tile renderer shows, and when.
#include <algorithm>
#include <cmath>
#include <set>

#include <QPainter>
#include <QSignalSpy>
#include <QtTest>

#include "render/tile_renderer.h"
#include "scenes.h"

using namespace mapwright;
using render::ColorMode;
using render::Composition;
using render::DrawnTile;
using render::MapColors;
using render::TileRenderer;
using testing::field;
using testing::square;
using testing::viewAt;

namespace {

constexpr int kPatience = 60'000;

#define WAIT_UNTIL_SETTLED(renderer) QTRY_VERIFY_WITH_TIMEOUT((renderer).settled(), kPatience)

constexpr QRgb kNothing = 0xff00ff00;

// The picture that a window would show; kNothing where nothing is painted.
QImage paintedPicture(TileRenderer& renderer, const geometry::ViewTransform& view) {
  QImage image(view.width_px, view.height_px, QImage::Format_RGB32);
  image.fill(kNothing);
  QPainter painter(&image);
  for (const DrawnTile& tile : renderer.drawnTiles()) {
    painter.setTransform(tile.to_viewport);
    painter.drawImage(0, 0, tile.image);
  }
  return image;
}

int countNothing(const QImage& image) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) count += image.pixel(x, y) == kNothing;
  }
  return count;
}

Composition exactOf(const geometry::ViewTransform& view, const std::vector<render::PlacedTexture>& placed) {
  render::DenseCache cache;
  return render::compose(testing::gridOf(view), placed, render::Quality::Exact, cache);
}

bool hasStandIns(TileRenderer& renderer) {
  const auto tiles = renderer.drawnTiles();
  return std::any_of(tiles.begin(), tiles.end(), [](const DrawnTile& tile) { return tile.stand_in; });
}

double meanDifference(const Composition& a, const Composition& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.intensity.size(); ++i)
    sum += std::abs(int(a.intensity[i]) - int(b.intensity[i]));
  return sum / double(a.intensity.size());
}

}  // namespace

class TestTileRenderer : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void withoutContentItIsSettledAtOnce();
  void showsWhatTheCompositorMakes();
  void tilesLieAtWholePixels();
  void panningReusesTiles();
  void aMovedPoseMovesThePicture();
  void anIdenticalTextureChangesNothing();
  void aRemovedTextureDisappears();
  void clearingShowsNothing();
  void noHolesWhileContentChanges();
  void noHolesAfterZoomAndTurn();
  void standInsAreBounded();
  void standInsLieWhereTheContentIs();
  void theCentreComesFirst();
  void whatIsNoLongerWantedIsDropped();
  void coloursChangeWithoutComposing();
  void colourModes();
  void snapshotsEqualTheCompositor_data();
  void snapshotsEqualTheCompositor();
  void snapshotsShowNoPreviews();
  void zoomedOutItIsTheReducedExactPicture_data();
  void zoomedOutItIsTheReducedExactPicture();
  void zoomedOutAPreviewComesFirst();
  void zoomedOutOnlyWhatChangedIsMadeAgain();
  void zoomedOutAMoveShowsUpEverywhere();
  void readsTheIntensityUnderAPoint();
  void signalsWhenItSettles();
  void repaintsAreAskedForOncePerTurn();
  void aTinyBudgetStillSettles();
  void staysWithinItsBudget();
  void texturesWithoutCellsCountAsRemoved();
  void survivesAbsurdViews();
  void canBeDestroyedWhileWorking();
};

void TestTileRenderer::withoutContentItIsSettledAtOnce() {
  TileRenderer renderer({});
  QVERIFY(renderer.settled());
  renderer.setView(viewAt(0, 0, 0.05, 800, 600));
  QVERIFY(renderer.settled());
  QVERIFY(renderer.drawnTiles().empty());
  QVERIFY(renderer.contentBounds().empty());
  QCOMPARE(renderer.counts().pending, 0);
  QCOMPARE(renderer.counts().visible, renderer.counts().exact);
  // Content elsewhere changes nothing here.
  renderer.upsert({square(0, 1000, 1000, 5, {50, 0})});
  QVERIFY(renderer.settled());
  QCOMPARE(renderer.textureCount(), std::size_t(1));
}

void TestTileRenderer::showsWhatTheCompositorMakes() {
  const auto placed = field(12, 12);
  for (const double rotation : {0.0, 0.8}) {
    // Centres that put the world origin on a pixel corner: then the tiles' pixels are the view's own.
    const auto view = viewAt(0, 0, 0.05, 320, 240, rotation);
    TileRenderer renderer({});
    renderer.setView(view);
    renderer.upsert(placed);
    QVERIFY(!renderer.settled());
    WAIT_UNTIL_SETTLED(renderer);
    const Composition expected = exactOf(view, placed);
    const Composition actual = renderer.composition();
    // The same pixels counted from another origin: equal but for the last bit of a coordinate.
    QVERIFY(meanDifference(actual, expected) < 0.01);
    const QImage image = paintedPicture(renderer, view);
    const MapColors colors;
    int compared = 0;
    for (int y = 0; y < view.height_px; ++y) {
      for (int x = 0; x < view.width_px; ++x) {
        const std::size_t at = std::size_t(y * view.width_px + x);
        if (image.pixel(x, y) == kNothing) continue;
        const bool observed = actual.flags[at] != 0;
        if (!observed) QCOMPARE(image.pixel(x, y), QRgb(colors.unknown));
        if (observed)
          QVERIFY(std::abs(qRed(image.pixel(x, y)) - (0x15 + (0xff - 0x15) * actual.intensity[at] / 255)) <=
                  1);
        ++compared;
      }
    }
    QVERIFY(compared > 10'000);
  }
}

void TestTileRenderer::tilesLieAtWholePixels() {
  TileRenderer renderer({});
  renderer.upsert(field(12, 20));
  for (int step = 0; step < 5; ++step) {
    renderer.setView(viewAt(0.0173 * step, -0.0311 * step, 0.05, 500, 400, 0.3));
    WAIT_UNTIL_SETTLED(renderer);
    for (const DrawnTile& tile : renderer.drawnTiles()) {
      QVERIFY(!tile.stand_in);
      QVERIFY(tile.to_viewport.type() <= QTransform::TxTranslate);
      QCOMPARE(tile.to_viewport.dx(), std::round(tile.to_viewport.dx()));
      QCOMPARE(tile.to_viewport.dy(), std::round(tile.to_viewport.dy()));
      QCOMPARE(tile.image.format(), QImage::Format_RGB32);
    }
  }
}

void TestTileRenderer::panningReusesTiles() {
  TileRenderer renderer({});
  renderer.upsert(field(30, 40));
  renderer.setView(viewAt(0, 0, 0.05, 800, 600));
  WAIT_UNTIL_SETTLED(renderer);
  const auto composed = renderer.counts().composed;
  renderer.setView(viewAt(0.3, 0.2, 0.05, 800, 600));  // 6 and 4 pixels
  WAIT_UNTIL_SETTLED(renderer);
  const auto few = renderer.counts().composed - composed;
  QVERIFY(few <= 9);  // at most a row and a column of tiles came into view
  renderer.setView(viewAt(0, 0, 0.05, 800, 600));
  QVERIFY(renderer.settled());  // back again: all is still there
}

void TestTileRenderer::aMovedPoseMovesThePicture() {
  TileRenderer renderer({});
  auto placed = square(0, -3, 0, 2, {100, 0});
  const auto view = viewAt(0, 0, 0.05, 400, 300);
  renderer.setView(view);
  renderer.upsert({placed});
  WAIT_UNTIL_SETTLED(renderer);
  QCOMPARE(renderer.intensityAt({-3, 0}), std::optional<int>(228));
  QCOMPARE(renderer.intensityAt({3, 0}), std::nullopt);
  placed.world_from_texture.x_m += 6;
  renderer.upsert({placed});
  QVERIFY(!renderer.settled());
  WAIT_UNTIL_SETTLED(renderer);
  QCOMPARE(renderer.intensityAt({-3, 0}), std::nullopt);
  QCOMPARE(renderer.intensityAt({3, 0}), std::optional<int>(228));
  QCOMPARE(renderer.textureCount(), std::size_t(1));
  QCOMPARE(placed.texture.use_count() > 1, true);  // shared, not copied
}

void TestTileRenderer::anIdenticalTextureChangesNothing() {
  TileRenderer renderer({});
  const auto placed = field(5, 5);
  renderer.setView(viewAt(0, 0, 0.05, 400, 300));
  renderer.upsert(placed);
  WAIT_UNTIL_SETTLED(renderer);
  renderer.upsert(placed);
  QVERIFY(renderer.settled());
}

void TestTileRenderer::aRemovedTextureDisappears() {
  TileRenderer renderer({});
  const auto view = viewAt(0, 0, 0.05, 400, 300);
  renderer.setView(view);
  renderer.upsert({square(0, -3, 0, 2, {100, 0}), square(1, 3, 0, 2, {0, 100})});
  WAIT_UNTIL_SETTLED(renderer);
  renderer.remove({{0, 0}, {7, 7}});
  WAIT_UNTIL_SETTLED(renderer);
  QCOMPARE(renderer.intensityAt({-3, 0}), std::nullopt);
  QCOMPARE(renderer.intensityAt({3, 0}), std::optional<int>(78));
  renderer.remove({{0, 1}});
  QVERIFY(renderer.settled());
  QVERIFY(renderer.drawnTiles().empty());
  QVERIFY(renderer.contentBounds().empty());
}

void TestTileRenderer::clearingShowsNothing() {
  TileRenderer renderer({});
  renderer.setView(viewAt(0, 0, 0.4, 400, 300));
  renderer.upsert(field(20, 40));
  WAIT_UNTIL_SETTLED(renderer);
  renderer.setView(viewAt(0, 0, 0.3, 400, 300));
  renderer.clear();
  QVERIFY(renderer.settled());
  QVERIFY(renderer.drawnTiles().empty());
  QCOMPARE(renderer.textureCount(), std::size_t(0));
  renderer.upsert(field(20, 40, 2));
  WAIT_UNTIL_SETTLED(renderer);
  QVERIFY(!renderer.drawnTiles().empty());
}

void TestTileRenderer::noHolesWhileContentChanges() {
  for (const double scale : {0.05, 0.5}) {
    TileRenderer renderer({.threads = 1});
    const auto view = viewAt(0, 0, scale, 700, 500);
    renderer.setView(view);
    auto placed = field(60, 700 * scale);
    renderer.upsert(placed);
    WAIT_UNTIL_SETTLED(renderer);
    const int holes = countNothing(paintedPicture(renderer, view));
    bool seen_waiting = false;
    for (auto& texture : placed) texture.world_from_texture.x_m += 0.1;
    renderer.upsert(placed);
    connect(&renderer, &TileRenderer::tilesChanged, this, [&] {
      seen_waiting = seen_waiting || !renderer.settled();
      QVERIFY(countNothing(paintedPicture(renderer, view)) <=
              holes + 512 * 512);  // a tile or two may have become empty
    });
    QVERIFY(countNothing(paintedPicture(renderer, view)) <= holes);
    WAIT_UNTIL_SETTLED(renderer);
    QVERIFY(seen_waiting);
  }
}

void TestTileRenderer::noHolesAfterZoomAndTurn() {
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

void TestTileRenderer::standInsAreBounded() {
  TileRenderer renderer({.threads = 1});
  renderer.upsert(field(200, 60));
  auto view = viewAt(0, 0, 0.02, 900, 700);
  std::size_t most = 0;
  for (int step = 0; step < 40; ++step) {
    view = view.zoomedAt({450, 350}, step % 2 == 0 ? 0.97 : 1.05);
    renderer.setView(view);
    QCoreApplication::processEvents(QEventLoop::AllEvents, 3);
    most = std::max(most, renderer.drawnTiles().size());
  }
  QVERIFY(most <= 150);  // five screens' worth of tiles at the very most
  WAIT_UNTIL_SETTLED(renderer);
}

void TestTileRenderer::standInsLieWhereTheContentIs() {
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

void TestTileRenderer::theCentreComesFirst() {
  TileRenderer renderer({.threads = 1});
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

void TestTileRenderer::whatIsNoLongerWantedIsDropped() {
  // Snapshots of huge pixels take long per tile, so that work is certainly under way when the view changes.
  TileRenderer renderer({.threads = 1, .previews = false});
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

void TestTileRenderer::coloursChangeWithoutComposing() {
  TileRenderer renderer({});
  const auto view = viewAt(0, 0, 0.05, 300, 200);
  renderer.setView(view);
  renderer.upsert({square(0, 0, 0, 30, {127, 0})});
  WAIT_UNTIL_SETTLED(renderer);
  const auto composed = renderer.counts().composed;
  MapColors colors;
  colors.free = 0xff204060;
  colors.occupied = 0xff204060;
  renderer.setColors(colors, ColorMode::Normal);
  QVERIFY(renderer.settled());
  QVERIFY(renderer.colors() == colors);
  QCOMPARE(paintedPicture(renderer, view).pixel(150, 100), QRgb(0xff204060));
  QCOMPARE(renderer.counts().composed, composed);
}

void TestTileRenderer::colourModes() {
  TileRenderer renderer({});
  const auto view = viewAt(0, 0, 0.05, 400, 100);
  renderer.setView(view);
  renderer.upsert({square(0, -6, 0, 4, {127, 0}, render::kIncremental),
                   square(1, 0, 0, 4, {127, 0}, render::kActive), square(2, 6, 0, 4, {0, 255}, 0)});
  WAIT_UNTIL_SETTLED(renderer);
  const MapColors colors;
  const auto colorAt = [&](double x) {
    return paintedPicture(renderer, view).pixel(int(200 + x / 0.05), 50);
  };
  QCOMPARE(colorAt(-6), QRgb(colors.free));
  QCOMPARE(colorAt(0), QRgb(colors.free));
  QCOMPARE(colorAt(6), QRgb(colors.occupied));
  QCOMPARE(colorAt(3), QRgb(colors.unknown));
  renderer.setColors(colors, ColorMode::Incremental);
  QCOMPARE(colorAt(-6), QRgb(colors.incremental_free));
  QCOMPARE(colorAt(0), QRgb(colors.free));
  renderer.setColors(colors, ColorMode::Active);
  QCOMPARE(colorAt(0), QRgb(colors.free));
  // 35 % of #ffffff over #778899.
  QCOMPARE(colorAt(-6), qRgb(0xa7, 0xb2, 0xbd));
  // 35 % of #15181c over #778899.
  QCOMPARE(colorAt(6), qRgb(0x55, 0x61, 0x6d));
  QCOMPARE(colorAt(3), QRgb(colors.unknown));
}

void TestTileRenderer::snapshotsEqualTheCompositor_data() {
  QTest::addColumn<double>("scale");
  QTest::addColumn<double>("rotation");
  for (const double scale : {0.009, 0.05, 0.0731, 0.25, 1.0}) {
    for (const double rotation : {0.0, 1.1})
      QTest::addRow("%g m, turned %g", scale, rotation) << scale << rotation;
  }
}

void TestTileRenderer::snapshotsEqualTheCompositor() {
  QFETCH(double, scale);
  QFETCH(double, rotation);
  const auto placed = field(40, 30);
  const auto view = viewAt(1.2345, -0.777, scale, 611, 347, rotation);
  TileRenderer renderer({.threads = 2, .previews = false});
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
  for (const DrawnTile& tile : renderer.drawnTiles()) {
    QVERIFY(tile.to_viewport.dx() >= 0 && tile.to_viewport.dx() + tile.image.width() <= 611);
  }
}

void TestTileRenderer::snapshotsShowNoPreviews() {
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

void TestTileRenderer::zoomedOutItIsTheReducedExactPicture_data() {
  QTest::addColumn<double>("scale");
  QTest::addColumn<double>("rotation");
  for (const double scale : {0.11, 0.2, 0.27, 0.5, 1.3, 3.2}) {
    for (const double rotation : {0.0, 0.6})
      QTest::addRow("%g m, turned %g", scale, rotation) << scale << rotation;
  }
}

void TestTileRenderer::zoomedOutItIsTheReducedExactPicture() {
  QFETCH(double, scale);
  QFETCH(double, rotation);
  const auto placed = field(80, 40);
  const auto view = viewAt(0, 0, scale, 300, 200, rotation);
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

void TestTileRenderer::zoomedOutAPreviewComesFirst() {
  TileRenderer renderer({.threads = 1});
  const auto view = viewAt(0, 0, 0.5, 800, 600);
  renderer.setView(view);
  int most_previews = 0;
  connect(&renderer, &TileRenderer::tilesChanged, this,
          [&] { most_previews = std::max(most_previews, renderer.counts().preview); });
  renderer.upsert(field(300, 400));
  WAIT_UNTIL_SETTLED(renderer);
  QCOMPARE(renderer.counts().preview, 0);
  QVERIFY(most_previews >= 6);
}

void TestTileRenderer::zoomedOutOnlyWhatChangedIsMadeAgain() {
  TileRenderer renderer({});
  auto placed = field(400, 200);
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

void TestTileRenderer::zoomedOutAMoveShowsUpEverywhere() {
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

void TestTileRenderer::readsTheIntensityUnderAPoint() {
  TileRenderer renderer({});
  renderer.setView(viewAt(50, -20, 0.02, 400, 300, 0.9));
  QCOMPARE(renderer.intensityAt({50, -20}), std::nullopt);
  renderer.upsert({square(0, 50, -20, 2, {0, 51})});
  WAIT_UNTIL_SETTLED(renderer);
  QCOMPARE(renderer.intensityAt({50, -20}), std::optional<int>(102));
  QCOMPARE(renderer.intensityAt({52, -20}), std::nullopt);
  QCOMPARE(renderer.intensityAt({1e300, -20}), std::nullopt);
  QCOMPARE(renderer.intensityAt({std::nan(""), 0}), std::nullopt);
}

void TestTileRenderer::signalsWhenItSettles() {
  TileRenderer renderer({});
  QSignalSpy settled(&renderer, &TileRenderer::settledChanged);
  renderer.setView(viewAt(0, 0, 0.05, 300, 200));
  renderer.upsert(field(10, 10));
  WAIT_UNTIL_SETTLED(renderer);
  QTRY_COMPARE(int(settled.count()) % 2, 0);  // away and back again, as often as that was
  const auto before = settled.count();
  renderer.upsert({square(99, 0, 0, 3, {0, 90})});
  QVERIFY(!renderer.settled());
  QTRY_COMPARE_WITH_TIMEOUT(settled.count(), before + 2, kPatience);
  QVERIFY(renderer.settled());
}

void TestTileRenderer::repaintsAreAskedForOncePerTurn() {
  TileRenderer renderer({});
  renderer.setView(viewAt(0, 0, 0.05, 300, 200));
  for (int i = 0; i < 50; ++i)
    renderer.upsert({square(i, 100 + i, 100, 1, {10, 0})});  // out of view: no work
  QSignalSpy changed(&renderer, &TileRenderer::tilesChanged);
  QCoreApplication::sendPostedEvents();
  QCOMPARE(changed.count(), 1);
}

void TestTileRenderer::aTinyBudgetStillSettles() {
  TileRenderer renderer({.tile_budget_bytes = 1, .dense_budget_bytes = 1});
  const auto placed = field(60, 60);
  const auto view = viewAt(0, 0, 1.0, 500, 400, 0.1);
  renderer.upsert(placed);
  renderer.setView(view);
  WAIT_UNTIL_SETTLED(renderer);
  QVERIFY(meanDifference(renderer.composition(), exactOf(view, placed)) < 1);
}

void TestTileRenderer::staysWithinItsBudget() {
  const std::size_t budget = 12 << 20;
  TileRenderer renderer({.tile_budget_bytes = budget});
  renderer.upsert(field(400, 150));
  for (int step = 0; step < 12; ++step) {
    renderer.setView(viewAt(-60 + 10 * step, 0, 0.05, 400, 300));
    WAIT_UNTIL_SETTLED(renderer);
    QVERIFY(renderer.counts().cache_bytes <= budget + (4 << 20));
  }
}

void TestTileRenderer::texturesWithoutCellsCountAsRemoved() {
  TileRenderer renderer({});
  renderer.setView(viewAt(0, 0, 0.05, 300, 200));
  auto placed = square(0, 0, 0, 3, {50, 0});
  renderer.upsert({placed});
  placed.world_from_texture.yaw_rad = std::nan("");
  renderer.upsert({placed});
  QCOMPARE(renderer.textureCount(), std::size_t(0));
  placed.texture.reset();
  renderer.upsert({placed});
  QCOMPARE(renderer.textureCount(), std::size_t(0));
  QVERIFY(renderer.settled());
}

void TestTileRenderer::survivesAbsurdViews() {
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

void TestTileRenderer::canBeDestroyedWhileWorking() {
  for (int round = 0; round < 20; ++round) {
    auto renderer = std::make_unique<TileRenderer>(TileRenderer::Options{});
    renderer->upsert(field(20, 40, unsigned(round)));
    renderer->setView(viewAt(0, 0, round % 2 == 0 ? 0.05 : 0.7, 1000, 800));
    QCoreApplication::sendPostedEvents();
    const bool working = !renderer->settled();
    renderer.reset();
    QVERIFY(working);
  }
}

QTEST_GUILESS_MAIN(TestTileRenderer)
#include "test_tile_renderer.moc"
