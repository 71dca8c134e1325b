#include <algorithm>
#include <atomic>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <QTest>

#include "cells/texture_store.h"
#include "scratch_files.h"
#include "test_program.h"

namespace test_texture_store {

using namespace mapwright::cells;

class TextureStoreTest : public QObject {
  Q_OBJECT
 private:
  using TexturePtr = std::shared_ptr<const CellTexture>;
  static TexturePtr texture(unsigned seed, int width = 150, int height = 130, bool folds = true) {
    std::mt19937 random(seed);
    std::vector<CellPair> pairs(std::size_t(width) * std::size_t(height));
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        if ((u / 30 + v / 40) % 2 == 0) continue;  // unknown ground
        CellPair& cell = pairs[std::size_t(v) * std::size_t(width) + std::size_t(u)];
        cell.value = std::uint8_t(random() % 100);
        if (!folds) cell.alpha = std::uint8_t(random() % 100);
      }
    }
    return CellTexture::fromPairs(width, height, 0.05, pairs);
  }
  static void compare(const CellTexture& kept, const CellTexture& own) {
    QCOMPARE(kept.levels(), own.levels());
    QCOMPARE(kept.observedCells(), own.observedCells());
    for (int level = 0; level < own.levels(); ++level) {
      const DenseCells a = kept.expand(level), b = own.expand(level);
      QCOMPARE(a.width, b.width);
      QCOMPARE(a.data, b.data);
      QCOMPARE(a.occupied_sum, b.occupied_sum);
    }
    QCOMPARE(kept.at(35, 5), own.at(35, 5));
  }

 private Q_SLOTS:
  void whatIsMovedToTheDiskIsTheSame_data() {
    QTest::addColumn<bool>("folds");
    QTest::newRow("folded") << true;
    QTest::newRow("pairs") << false;
  }
  void whatIsMovedToTheDiskIsTheSame() {
    QFETCH(bool, folds);
    const std::size_t budget = 3 * texture(0, 150, 130, folds)->bytes();
    const auto store = TextureStore::make({.budget_bytes = budget});
    std::vector<TexturePtr> kept;
    for (unsigned seed = 0; seed < 20; ++seed) {
      kept.push_back(texture(seed, 150, 130, folds));
      store->keep(*kept.back());
      QVERIFY(store->bytesInMemory() <= budget);
    }
    QVERIFY(store->bytesOnDisk() > 10 * kept[0]->bytes());
    for (const unsigned seed : {0U, 19U, 7U, 0U, 3U, 12U}) {
      compare(*kept[seed], *texture(seed, 150, 130, folds));
      QVERIFY(store->bytesInMemory() <= budget);
    }
    kept.clear();
    QCOMPARE(store->bytesInMemory(), std::size_t(0));
    QCOMPARE(store->bytesOnDisk(), std::size_t(0));
  }

  void roomInTheFileIsUsedAgain() {
    const auto store = TextureStore::make({.budget_bytes = 0});
    std::size_t most = 0;
    for (unsigned seed = 0; seed < 50; ++seed) {
      const TexturePtr one = texture(seed % 2);
      store->keep(*one);
      most = std::max(most, store->bytesOnDisk());
      compare(*one, *texture(seed % 2));
    }
    QVERIFY(most < 2 * texture(0)->bytes());
  }

  void manyThreadsSeeTheSame() {
    const auto store = TextureStore::make({.budget_bytes = 4 * texture(0)->bytes()});
    std::vector<TexturePtr> kept, own;
    for (unsigned seed = 0; seed < 16; ++seed) {
      own.push_back(texture(seed));
      kept.push_back(texture(seed));
      store->keep(*kept.back());
    }
    std::atomic<int> wrong{0};
    std::vector<std::thread> threads;
    for (unsigned t = 0; t < 4; ++t) {
      threads.emplace_back([&, t] {
        std::mt19937 random(t);
        for (int i = 0; i < 200; ++i) {
          const std::size_t which = random() % 16;
          if (kept[which]->expand(0).data != own[which]->expand(0).data) ++wrong;
          const TexturePtr passing = texture(100 + t);
          store->keep(*passing);
          if (passing->expand(1).data != texture(100 + t)->expand(1).data) ++wrong;
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    QCOMPARE(wrong.load(), 0);
  }

  void withoutRoomOnTheDiskEverythingStaysAndThatIsToldOnce() {
    int told = 0;
    // Not even what is temporary can be kept.
    qputenv("TMPDIR", "/dev/null/nowhere");
    const auto store = TextureStore::make({.budget_bytes = 0, .folder = "/dev/null/nowhere"},
                                          {.lost = {}, .no_room = [&](const std::string& why) {
                                             QVERIFY(!why.empty());
                                             ++told;
                                           }});
    std::vector<TexturePtr> kept;
    for (unsigned seed = 0; seed < 5; ++seed) {
      kept.push_back(texture(seed));
      store->keep(*kept.back());
    }
    qunsetenv("TMPDIR");
    QCOMPARE(told, 1);
    for (unsigned seed = 0; seed < 5; ++seed) compare(*kept[seed], *texture(seed));
    QCOMPARE(store->lost(), std::size_t(0));
  }

  void whatCannotBeReadBackIsToldAndDrawsNothing() {
    std::vector<std::uint64_t> told;
    const auto store = TextureStore::make(
        {.budget_bytes = 0}, {.lost = [&](std::uint64_t owner) { told.push_back(owner); }, .no_room = {}});
    const TexturePtr one = texture(1), other = texture(2);
    store->keep(*one, 41);
    store->keep(*other, 42);
    mapwright::test::truncateScratchFiles();
    const DenseCells nothing = one->expand(0);
    QCOMPARE(nothing.width, 150);
    QVERIFY(std::all_of(nothing.data.begin(), nothing.data.end(), [](std::uint8_t b) { return b == 0; }));
    QVERIFY(nothing.emptyWithin(0, 0, 149, 129));
    QVERIFY(one->at(35, 5) == CellPair{});
    one->expand(1);
    QCOMPARE(told, std::vector<std::uint64_t>({41}));
    other->expand(2);
    QCOMPARE(store->lost(), std::size_t(2));
  }

  void texturesOutliveWhoeverMadeTheStore() {
    auto store = TextureStore::make({.budget_bytes = 0});
    const TexturePtr one = texture(1);
    store->keep(*one);
    store->silence();
    store.reset();
    compare(*one, *texture(1));
  }
};

}  // namespace test_texture_store

MAPWRIGHT_TEST(test_texture_store, TextureStoreTest, Core)
#include "test_texture_store.moc"
