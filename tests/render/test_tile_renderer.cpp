// What the tile renderer shows, and when.
#include <algorithm>
#include <cmath>
#include <future>
#include <map>
#include <tuple>

#include <QSignalSpy>
#include <QtTest>

#include "painted.h"
#include "reference.h"
#include "render/tile_renderer.h"
#include "scenes.h"
#include "test_program.h"
#include "work/workers.h"

namespace test_tile_renderer {

using namespace mapwright;
using render::ColorMode;
using render::Composition;
using render::MapColors;
using render::TileRenderer;
using testing::countNothing;
using testing::exactOf;
using testing::field;
using testing::kNothing;
using testing::meanDifference;
using testing::paintedPicture;
using testing::square;
using testing::viewAt;

namespace {

constexpr int kPatience = 60'000;

#define WAIT_UNTIL_SETTLED(renderer) QTRY_VERIFY_WITH_TIMEOUT((renderer).settled(), kPatience)

}  // namespace

class TestTileRenderer : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void withoutContentItIsSettledAtOnce();
  void showsWhatTheCompositorMakes();
  void aMovedPoseMovesThePicture();
  void anIdenticalTextureChangesNothing();
  void aRemovedTextureDisappears();
  void clearingShowsNothing();
  void noHolesWhileContentChanges();
  void coloursChangeWithoutComposing();
  void colourModes();
  void classesTintThePicture();
  void classesSurviveHalving();
  void readsTheIntensityUnderAPoint();
  void signalsWhenItSettles();
  void repaintsAreAskedForOncePerTurn();
  void aTinyBudgetStillSettles();
  void staysWithinItsBudget();
  void texturesWithoutCellsCountAsRemoved();
  void canBeDestroyedWhileWorking();
  void holesAreFilledBeforeWhatIsThereGetsNewer();
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
    TileRenderer renderer({.workers = std::make_shared<work::Workers>(1)});
    const auto view = viewAt(0, 0, scale, 700, 500);
    renderer.setView(view);
    auto placed = field(60, 700 * scale);
    renderer.upsert(placed);
    // Ground under all of the view: whatever changes on it, a pixel without content is a hole.
    const double edge_m = 1000 * scale;
    renderer.upsert(
        {testing::plainTexture(500, 500, edge_m / 500, std::vector<cells::CellPair>(500 * 500, {60, 0}),
                               {edge_m / 2, edge_m / 2, 0}, 1000, 0)
             .placed});
    WAIT_UNTIL_SETTLED(renderer);
    QCOMPARE(countNothing(paintedPicture(renderer, view)), 0);
    int looks_while_waiting = 0, most_holes = 0;
    for (auto& texture : placed) texture.world_from_texture.x_m += 0.1;
    renderer.upsert(placed);
    connect(&renderer, &TileRenderer::tilesChanged, this, [&] {
      looks_while_waiting += !renderer.settled();
      most_holes = std::max(most_holes, countNothing(paintedPicture(renderer, view)));
    });
    QVERIFY(!renderer.settled());
    QCOMPARE(countNothing(paintedPicture(renderer, view)), 0);
    WAIT_UNTIL_SETTLED(renderer);
    QVERIFY(looks_while_waiting > 0);
    QCOMPARE(most_holes, 0);
  }
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

void TestTileRenderer::classesTintThePicture() {
  TileRenderer renderer({});
  const auto view = viewAt(0, 0, 0.05, 400, 100);
  renderer.setView(view);
  const auto classed = [](int index, double x, cells::CellPair cell, const render::PixelClasses& classes) {
    return square(index, x, 0, 4, cell, std::uint16_t(render::flagsOf(classes) | render::kActive));
  };
  renderer.upsert({classed(0, -6, {127, 0}, {1, 7, 3}), classed(1, 0, {127, 0}, {7, 2, 8}),
                   classed(2, 6, {0, 255}, {3, 1, 1})});
  WAIT_UNTIL_SETTLED(renderer);
  const auto composed = renderer.counts().composed;
  const MapColors colors;
  const auto colorAt = [&](double x) {
    return paintedPicture(renderer, view).pixel(int(200 + x / 0.05), 50);
  };
  const auto of = [](ColorMode mode, int cls) { return QRgb(render::classColors(mode)[std::size_t(cls)]); };
  const std::tuple<ColorMode, QRgb, QRgb> expected[] = {
      {ColorMode::Trajectory, of(ColorMode::Trajectory, 1), of(ColorMode::Trajectory, 7)},
      {ColorMode::Age, of(ColorMode::Age, 7), of(ColorMode::Age, 2)},
      {ColorMode::Version, of(ColorMode::Version, 3), render::kUnknownVersionColor},
      {ColorMode::Active, colors.free, colors.free}};
  for (const auto& [mode, left, middle] : expected) {
    renderer.setColors(colors, mode);
    QVERIFY(renderer.settled());
    QCOMPARE(colorAt(-6), left);
    QCOMPARE(colorAt(0), middle);
    QCOMPARE(colorAt(3), QRgb(colors.unknown));
    QCOMPARE(colorAt(6), QRgb(colors.occupied));
  }
  QCOMPARE(renderer.counts().composed, composed);
}

void TestTileRenderer::classesSurviveHalving() {
  // Left and right of x = 0 at every level of the pyramid; where both are in a pixel the later one counts.
  TileRenderer renderer({});
  const auto early = render::flagsOf({2, 7, 1}), late = render::flagsOf({3, 1, 1});
  renderer.upsert({square(0, -10, 0, 20, {100, 0}, early), square(1, 10, 0, 20, {100, 0}, late)});
  for (const double scale : {0.05, 0.2, 0.41, 0.8, 3.3}) {
    renderer.setView(viewAt(0.33, 0, scale, 300, 60, 0.2));
    WAIT_UNTIL_SETTLED(renderer);
    const Composition picture = renderer.composition();
    std::map<int, int> seen;
    for (const auto flags : picture.flags) {
      if (flags != 0) ++seen[flags & ~render::kObserved];
    }
    QCOMPARE(seen.size(), std::size_t(2));
    QVERIFY(seen[early] > 2 && seen[late] > 2);
    QVERIFY(seen[late] >= seen[early]);
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
  // Away and back again, as often as that was.
  QTRY_VERIFY(settled.count() >= 2 && settled.count() % 2 == 0);
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
  TileRenderer renderer({.budgets = {.dense = 1, .tiles = 1}});
  const auto placed = field(60, 60);
  const auto view = viewAt(0, 0, 1.0, 500, 400, 0.1);
  renderer.upsert(placed);
  renderer.setView(view);
  WAIT_UNTIL_SETTLED(renderer);
  QVERIFY(meanDifference(renderer.composition(), exactOf(view, placed)) < 1);
}

void TestTileRenderer::staysWithinItsBudget() {
  const std::size_t budget = 12 << 20;
  TileRenderer renderer({.budgets = {.dense = std::size_t(64) << 20, .tiles = budget}});
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

void TestTileRenderer::canBeDestroyedWhileWorking() {
  const auto workers = std::make_shared<work::Workers>(2);
  for (int round = 0; round < 20; ++round) {
    auto renderer = std::make_unique<TileRenderer>(TileRenderer::Options{.workers = workers});
    renderer->upsert(field(20, 40, unsigned(round)));
    renderer->setView(viewAt(0, 0, round % 2 == 0 ? 0.05 : 0.7, 1000, 800));
    QCoreApplication::sendPostedEvents();
    const bool working = !renderer->settled();
    renderer.reset();
    QVERIFY(working);
    QCOMPARE(workers->running() + workers->waiting(), 0);
  }
}

void TestTileRenderer::holesAreFilledBeforeWhatIsThereGetsNewer() {
  const auto workers = std::make_shared<work::Workers>(1);
  TileRenderer filled({.workers = workers}), empty({.workers = workers});
  const auto view = viewAt(6.4, 6.4, 0.05, 100, 100);  // within one tile
  filled.upsert({square(0, 0, 0, 12, {50, 0})});
  filled.setView(view);
  WAIT_UNTIL_SETTLED(filled);
  QStringList settled;
  connect(&filled, &TileRenderer::settledChanged, this, [&] {
    if (filled.settled()) settled << QStringLiteral("newer");
  });
  connect(&empty, &TileRenderer::settledChanged, this, [&] {
    if (empty.settled()) settled << QStringLiteral("hole");
  });
  std::promise<void> gate;
  work::Tasks other(workers);
  other.start(work::Urgency::InView, [opened = gate.get_future().share()] { opened.wait(); });
  filled.upsert({square(0, 0, 0, 12, {80, 0})});
  QTRY_COMPARE(workers->waiting(), 1);
  empty.upsert({square(0, 0, 0, 12, {50, 0})});
  empty.setView(view);
  QTRY_COMPARE(workers->waiting(), 2);
  gate.set_value();
  QTRY_COMPARE_WITH_TIMEOUT(settled, QStringList({QStringLiteral("hole"), QStringLiteral("newer")}),
                            kPatience);
}

}  // namespace test_tile_renderer

MAPWRIGHT_TEST(test_tile_renderer, TestTileRenderer, Core)
#include "test_tile_renderer.moc"
