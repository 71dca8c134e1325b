// The colours of a tile: what is transparent, hatched, or on the ramp.
#include <QtTest>

#include "agreement/heat.h"
#include "submaps.h"
#include "test_program.h"

namespace test_heat {

using namespace mapwright;
using namespace mapwright::testing;
using agreement::Argb;
using agreement::CoverageHeat;
using agreement::DisagreementHeat;
using agreement::Shades;

namespace {

agreement::Survey surveyed(const std::vector<PlacedTexture>& submaps) {
  agreement::Survey survey;
  survey.setSubmaps(submaps);
  render::DenseCache cache;
  while (const auto task = survey.take()) survey.put(*task, agreement::makeTile(*task, cache));
  return survey;
}

std::uint8_t at(const Shades& shades, int column, int row) {
  return shades[std::size_t(row * agreement::kTileCells + column)];
}

}  // namespace

class TestHeat : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theWorstSquareIsTheDarkest();
  void seenOnceIsHatchedAcrossTiles();
  void manySubmapsAreTheDarkestBlue();
  void theStepsAreToldApart();
};

void TestHeat::theWorstSquareIsTheDarkest() {
  const auto survey = surveyed({plain(1, 0, 0, 100, 40, kFree), plain(2, 0.2, 0.2, 10, 10, kWall),
                                plain(3, 1.2, 0.2, 1, 1, kWall), plain(4, 6, 0, 1, 1, kWall)});
  const auto found = survey.disagreement();
  const DisagreementHeat heat(found);
  const Shades shades = heat.shades({0, 0}, *found.tiles.at({0, 0}));
  const auto colors = DisagreementHeat::colors();
  QCOMPARE(colors[at(shades, 200, 200)], Argb(0));             // unseen
  QCOMPARE(int(at(shades, 90, 30)), 1);                        // ground
  QCOMPARE(int(at(shades, 120, 0)), 2);                        // a wall that nobody contradicts
  QCOMPARE(std::size_t(at(shades, 5, 5)), colors.size() - 1);  // 100 cells in its square
  QCOMPARE(int(at(shades, 24, 4)), 3);                         // one
}

void TestHeat::seenOnceIsHatchedAcrossTiles() {
  const auto survey = surveyed({plain(1, 12, 0, 40, 1, kFree), plain(2, 12, 0, 2, 1, kFree)});
  const Shades left = CoverageHeat::shades(*survey.made().at({0, 0}));
  const Shades right = CoverageHeat::shades(*survey.made().at({1, 0}));
  QCOMPARE(int(at(left, 240, 0)), 3);  // twice
  int last = -1;
  for (int column = 242; column < 280; ++column) {
    const int shade = column < 256 ? at(left, column, 0) : at(right, column - 256, 0);
    QVERIFY(shade == 1 || shade == 2);
    if (shade != 2) continue;
    if (last >= 0) QCOMPARE(column - last, 4);
    last = column;
  }
  QVERIFY(last >= 0);
}

void TestHeat::manySubmapsAreTheDarkestBlue() {
  std::vector<PlacedTexture> submaps;
  for (int index = 0; index < 300; ++index)
    submaps.push_back(plain(index, 0, 0, index < 32 ? 2 : 1, 1, kMaybe));
  const auto survey = surveyed(submaps);
  const Shades shades = CoverageHeat::shades(*survey.made().at({0, 0}));
  const std::size_t darkest = CoverageHeat::colors().size() - 1;
  QCOMPARE(std::size_t(at(shades, 0, 0)), darkest);
  QCOMPARE(std::size_t(at(shades, 1, 0)), darkest);
}

void TestHeat::theStepsAreToldApart() {
  agreement::Tile counts;
  for (std::size_t seen_by = 0; seen_by < 40; ++seen_by) counts.seen_by[seen_by] = std::uint8_t(seen_by);
  const Shades shades = CoverageHeat::shades(counts);
  const auto colors = CoverageHeat::colors();
  const auto brightness = [&](int seen_by) {
    const Argb color = colors[at(shades, seen_by, 0)];
    return 0.2126 * double(color >> 16 & 255) + 0.7152 * double(color >> 8 & 255) +
           0.0722 * double(color & 255);
  };
  int step = 0;
  for (int seen_by = 3; seen_by < 40; ++seen_by) {
    const bool next = seen_by == 3 || seen_by == 5 || seen_by == 9 || seen_by == 17;
    QCOMPARE(int(at(shades, seen_by, 0)) - int(at(shades, seen_by - 1, 0)), next ? 1 : 0);
    if (next) QVERIFY(brightness(seen_by - 1) - brightness(seen_by) > 35);
    step += next ? 1 : 0;
  }
  QCOMPARE(step, 4);
}

}  // namespace test_heat

MAPWRIGHT_TEST(test_heat, TestHeat, Core)
#include "test_heat.moc"
