// The spatial index against a plain search, and the learning test that shows why the product composes for
// itself.
#include <algorithm>
#include <random>

#include <QImage>
#include <QPainter>
#include <QtTest>

#include "render/texture_index.h"
#include "scenes.h"
#include "test_program.h"

namespace test_texture_index {

using namespace mapwright;
using render::PlacedTexture;
using render::TextureIndex;

namespace {

std::vector<map::SubmapId> idsOf(const std::vector<PlacedTexture>& placed) {
  std::vector<map::SubmapId> ids;
  for (const PlacedTexture& texture : placed) ids.push_back(texture.id);
  return ids;
}

std::vector<map::SubmapId> plainSearch(const std::vector<PlacedTexture>& placed,
                                       const geometry::WorldRect& rect) {
  std::vector<map::SubmapId> ids;
  for (const PlacedTexture& texture : placed) {
    if (render::boundsOf(texture).intersects(rect)) ids.push_back(texture.id);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

}  // namespace

class TestTextureIndex : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void findsWhatAPlainSearchFinds();
  void tellsWhatChanged();
  void knowsTheFinest();
  void holdsTexturesOfAnySizeAnywhere();
  void qPainterDoesNotComposeAsSpecified();
};

void TestTextureIndex::findsWhatAPlainSearchFinds() {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(-60, 60), size(0, 30);
  auto placed = testing::field(300, 100);
  placed.push_back(testing::square(300, 5, 5, 40, {1, 0}));
  placed.push_back(testing::square(301, -5, 20, 0.05, {1, 0}));
  int other = 400;
  for (const double resolution : {0.02, 0.1, 0.11, 0.5}) {
    for (int i = 0; i < 12; ++i) {
      PlacedTexture texture = testing::square(other++, place(random), place(random), 1, {1, 0});
      texture.texture =
          cells::CellTexture::fromPairs(20, 20, resolution, std::vector<cells::CellPair>(400, {1, 0}));
      placed.push_back(texture);
    }
  }
  TextureIndex index;
  for (const auto& texture : placed) index.upsert(texture);
  for (int round = 0; round < 300; ++round) {
    // Keep moving and removing while looking.
    const std::size_t moved = random() % placed.size();
    placed[moved].world_from_texture.x_m = place(random);
    index.upsert(placed[moved]);
    if (round % 10 == 0) {
      QVERIFY(index.remove(placed.back().id).has_value());
      placed.pop_back();
    }
    const double x = place(random), y = place(random);
    const geometry::WorldRect rect{x, y, x + size(random), y + size(random)};
    const auto expected = plainSearch(placed, rect);
    QCOMPARE(idsOf(index.within(rect)), expected);
    QCOMPARE(index.anyWithin(rect), !expected.empty());
    std::optional<double> finest_m;
    for (const auto& texture : placed) {
      const double resolution_m = texture.texture->resolutionM();
      if (render::boundsOf(texture).intersects(rect) && (!finest_m || resolution_m < *finest_m))
        finest_m = resolution_m;
    }
    QCOMPARE(index.finestWithin(rect), finest_m);
  }
  QCOMPARE(index.size(), placed.size());
}

void TestTextureIndex::tellsWhatChanged() {
  TextureIndex index;
  auto texture = testing::square(0, 0, 0, 2, {1, 0});
  const auto added = index.upsert(texture);
  QVERIFY(added && added->before.empty() && added->after == render::boundsOf(texture));
  QVERIFY(!index.upsert(texture));
  texture.world_from_texture.x_m += 10;
  const auto moved = index.upsert(texture);
  QVERIFY(moved && moved->before == added->after && moved->after == render::boundsOf(texture));
  QVERIFY(index.bounds() == moved->after);
  QVERIFY(index.remove({0, 0}) == moved->after);
  QVERIFY(!index.remove({0, 0}));
  QVERIFY(index.bounds().empty());
}

void TestTextureIndex::knowsTheFinest() {
  TextureIndex index;
  QVERIFY(!index.finest());
  index.upsert(testing::square(0, 0, 0, 2, {1, 0}));
  QCOMPARE(index.finest(), std::optional<double>(0.05));
  index.clear();
  QVERIFY(!index.finest());
  QCOMPARE(index.size(), std::size_t(0));
}

void TestTextureIndex::holdsTexturesOfAnySizeAnywhere() {
  TextureIndex index;
  std::vector<PlacedTexture> placed;
  int i = 0;
  for (const double resolution : {1e-300, 1e-9, 0.05, 100.0, 1e290}) {
    for (const double x : {0.0, -1e9, 1e200}) {
      PlacedTexture texture = testing::square(i, 0, 0, 1, {1, 0});
      const std::vector<cells::CellPair> cells(9, {1, 0});
      texture.texture = cells::CellTexture::fromPairs(3, 3, resolution, cells);
      texture.id.index = i++;
      texture.world_from_texture = {x, x, 1};
      placed.push_back(texture);
      index.upsert(texture);
    }
  }
  for (const double at : {0.0, -1e9, 1e200}) {
    const geometry::WorldRect rect{at - 1, at - 1, at + 1, at + 1};
    QCOMPARE(idsOf(index.within(rect)), plainSearch(placed, rect));
  }
  const geometry::WorldRect everything{-1e308, -1e308, 1e308, 1e308};
  QCOMPARE(index.within(everything).size(), placed.size());
  for (const auto& texture : placed) QVERIFY(index.remove(texture.id).has_value());
  QCOMPARE(index.size(), std::size_t(0));
}

void TestTextureIndex::qPainterDoesNotComposeAsSpecified() {
  // Value 100 with alpha 0 over 128 has to give 228. SourceOver leaves such a pixel out or not, as its loops
  // please; it is no valid premultiplied colour, and nothing promises anything for it.
  QImage target(64, 64, QImage::Format_ARGB32_Premultiplied);
  target.fill(qRgba(128, 128, 128, 255));
  QImage source(64, 64, QImage::Format_ARGB32_Premultiplied);
  source.fill(qRgba(200, 200, 200, 0));
  {
    QPainter painter(&target);
    painter.drawImage(0, 0, source);
  }
  QVERIFY(qRed(target.pixel(20, 20)) != 255);  // 128 + 200, saturated
}

}  // namespace test_texture_index

MAPWRIGHT_TEST(test_texture_index, TestTextureIndex, Core)
#include "test_texture_index.moc"
