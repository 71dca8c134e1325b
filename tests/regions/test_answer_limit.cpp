// Dispatchers that give no more than so many cells in one answer. Source:
// docs/protocols/rep130-map-dispatcher.md.
#include <QtTest>

#include "fake_dispatch.h"
#include "map_shown.h"
#include "regions/map_regions.h"
#include "test_program.h"

namespace test_answer_limit {

using namespace mapwright;
using namespace mapwright::regions;
using geometry::WorldRect;

namespace {

using Outcome = robot::Outcome<map::GridPart>;
using Answer = std::function<Outcome(const map::GridRegion&)>;

FakeGround hall(int width, int height) {
  FakeGround ground;
  ground.width = width;
  ground.height = height;
  ground.origin = {-37.35, -12.8, 0};
  return ground;
}

WorldRect boundsOf(const FakeGround& ground) {
  return {ground.origin.x_m, ground.origin.y_m, ground.origin.x_m + ground.width * ground.resolution_m,
          ground.origin.y_m + ground.height * ground.resolution_m};
}

enum class Habit { Corner, Middle, Rows, Edge, Nothing, Error, Strict };

/// What a dispatcher with a limit of `most` cells answers. Strict: nothing, too, for what is partly beyond.
Outcome limited(const FakeGround& ground, Habit habit, std::int64_t most, const map::GridRegion& region) {
  if (habit == Habit::Strict) {
    const Eigen::Vector2d low = region.centre_m - region.size_m / 2,
                          high = region.centre_m + region.size_m / 2;
    if (!boundsOf(ground).contains(low) || !boundsOf(ground).contains(high)) return ground.nothing();
  }
  const FakeGround::Cells wanted = ground.cellsIn(region);
  if (wanted.count() <= most && habit != Habit::Edge) return ground.cut(wanted);
  const int wide = wanted.wide(), high = wanted.high(), root = int(std::sqrt(double(most)));
  const int w = std::min(wide, root), h = std::min(high, root);
  const auto cropped = [&](int left, int bottom, int columns, int rows) {
    return ground.cut({wanted.left + left, wanted.bottom + bottom, wanted.left + left + columns,
                       wanted.bottom + bottom + rows});
  };
  switch (habit) {
    case Habit::Corner:
    case Habit::Edge:
      return cropped(0, 0, w, h);
    case Habit::Middle:
      return cropped((wide - w) / 2, (high - h) / 2, w, h);
    case Habit::Rows:
      return cropped(0, 0, wide, std::max(1, int(most / wide)));
    case Habit::Nothing:
    case Habit::Strict:
      return ground.nothing();
    case Habit::Error:
      break;
  }
  return tl::unexpected(map::Failure{.kind = map::FailureKind::RejectedByRobot});
}

struct Told {
  int asked = 0;
  bool smaller_before_end = false;
};

/// Answers everything that is asked for until nothing is due.
Told settle(MapRegions& regions, const Answer& answer) {
  Told told;
  Millis now{10'000};
  while (told.asked < 20'000) {
    const auto asks = regions.take(now);
    if (asks.empty()) {
      const auto due = regions.nextDue(now);
      if (!due || *due > now + Millis(3'000'000) || regions.plan().settled(4)) break;
      now = std::max(*due, now + Millis(1));
      continue;
    }
    told.smaller_before_end = told.smaller_before_end || regions.counts().smaller > 0;
    for (const RegionRequest& ask : asks) {
      regions.answered(ask.id, answer(askedFor(ask.rect)), now);
      ++told.asked;
    }
  }
  return told;
}

MapRegions regionsOf(std::optional<WorldRect> only = {}) {
  MapRegions::Options options;
  options.plan.only = only;
  return MapRegions(options);
}

void look(MapRegions& regions, const WorldRect& view) { regions.setView(view, view.center()); }

}  // namespace

class TestAnswerLimit : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatIsLeftOutIsAskedForInPieces_data() {
    QTest::addColumn<Habit>("habit");
    QTest::addColumn<int>("most");
    QTest::addColumn<WorldRect>("view");
    QTest::addColumn<bool>("only");
    QTest::addColumn<int>("most_asked");
    const WorldRect within{-10, 0, 10, 20}, some{-30, 0, 90, 60}, corner{-60, -30, 0, 30};
    const std::array habits{std::pair{"corner", Habit::Corner},   std::pair{"middle", Habit::Middle},
                            std::pair{"rows", Habit::Rows},       std::pair{"edge", Habit::Edge},
                            std::pair{"nothing", Habit::Nothing}, std::pair{"error", Habit::Error},
                            std::pair{"strict", Habit::Strict}};
    for (const auto& [name, habit] : habits) {
      // Squares of half the edge, a quarter, and so on: four times as many each.
      const int factor = habit == Habit::Rows ? 4 : 1;
      const auto row = [&, habit = habit, name = name](int most, int pieces, const char* what,
                                                       const WorldRect& view, int squares) {
        QTest::addRow("%s %d %s", name, most, what)
            << habit << most << view << (what == std::string_view("only")) << squares * pieces * factor + 60;
      };
      row(262'144, 16, "within", within, 4);
      row(20'000, 64, "within", within, 4);
      row(600'000, 4, "corner", corner, 8);
      row(20'000, 64, "corner", corner, 4);
      row(100'000, 16, "some", some, 12);
      row(100'000, 16, "only", some.grown(-1.23), 12);
    }
  }
  void whatIsLeftOutIsAskedForInPieces() {
    QFETCH(Habit, habit);
    QFETCH(int, most);
    QFETCH(WorldRect, view);
    QFETCH(bool, only);
    QFETCH(int, most_asked);
    const FakeGround ground = hall(6000, 4000);
    MapRegions regions = regionsOf(only ? std::optional(view) : std::nullopt);
    if (habit == Habit::Strict) regions.setExtent(ground.all().grid);
    look(regions, view);
    const Told told =
        settle(regions, [&](const auto& region) { return limited(ground, habit, most, region); });
    QCOMPARE(wrongIn(regions, ground, view.grown(-0.1)), 0);
    QCOMPARE(regions.counts().smaller, 0);
    QVERIFY(!told.smaller_before_end);
    QCOMPARE(regions.counts().failed, 0);
    QVERIFY(regions.plan().settled(4));
    QVERIFY2(told.asked <= most_asked, qPrintable(QString::number(told.asked)));
    // It is known from now on: what is looked at next is asked for in squares that it gives.
    const WorldRect next{view.min_x + 120, view.min_y + 60, view.max_x + 120, view.max_y + 60};
    if (only) return;
    look(regions, next);
    int too_much = 0;
    settle(regions, [&](const auto& region) {
      too_much += ground.cellsIn(region).count() > most;
      return limited(ground, habit, most, region);
    });
    if (habit >= Habit::Nothing) QCOMPARE(too_much, 0);
    QCOMPARE(wrongIn(regions, ground, next.grown(-0.1)), 0);
  }

  void aMapThatEndsCostsAQuestionASide() {
    const FakeGround ground = hall(2300, 1500);
    const WorldRect view{-60, -40, 110, 90};
    MapRegions plain = regionsOf();
    look(plain, view);
    int small = 0;
    const Told told = settle(plain, [&](const auto& region) {
      small += region.size_m.maxCoeff() < 1;
      return ground.part(region);
    });
    QCOMPARE(wrongIn(plain, ground, view), 0);
    QCOMPARE(plain.counts().smaller, 0);
    QCOMPARE(plain.plan().lattice().edge_m, 1024 * ground.resolution_m);
    QVERIFY2(small <= 4 + 4, qPrintable(QString::number(small)));  // and those of the search for the rim
    QVERIFY2(told.asked <= 2 * plain.counts().in_view, qPrintable(QString::number(told.asked)));
  }

  void whatHelpsNothingIsGivenUpAndTold() {
    const FakeGround ground = hall(6000, 4000);
    MapRegions regions = regionsOf();
    look(regions, {-30, 0, 60, 40});
    const Told told = settle(regions, [&](map::GridRegion region) {
      region.size_m = (region.size_m - Eigen::Vector2d(9, 9)).cwiseMax(0.001);
      return ground.part(region);
    });
    QCOMPARE(regions.counts().smaller, regions.counts().in_view);
    QVERIFY2(told.asked <= 4 * regions.counts().in_view + 20, qPrintable(QString::number(told.asked)));
  }

  void fewerThanTheLeastIsTold() {
    const FakeGround ground = hall(6000, 4000);
    MapRegions regions = regionsOf();
    const WorldRect view{0, 0, 10, 10};
    look(regions, view);
    const Told told =
        settle(regions, [&](const auto& region) { return limited(ground, Habit::Corner, 1000, region); });
    QVERIFY(regions.counts().smaller > 0);
    QVERIFY2(told.asked < 300, qPrintable(QString::number(told.asked)));
  }

  void whoLooksAwayWhileALimitIsSearchedGetsTheMapAllTheSame() {
    const FakeGround ground = hall(6000, 4000);
    MapRegions regions = regionsOf();
    const WorldRect view{-10, 0, 10, 20};
    look(regions, view);
    const Answer answer = [&](const auto& region) {
      return limited(ground, Habit::Nothing, 100'000, region);
    };
    // At any of the first questions: far away, or nowhere.
    for (int i = 0; i < 12; ++i) {
      const auto asks = regions.take(Millis(10'000));
      if (i % 2 == 0) {
        for (const RegionRequest& ask : asks)
          regions.answered(ask.id, answer(askedFor(ask.rect)), Millis(10'000));
        continue;
      }
      if (i % 4 == 1) {
        look(regions, {-1e6, -1e6, 1e6, 1e6});
        QVERIFY(regions.take(Millis(10'000)).empty());
      } else {
        regions.setView(std::nullopt, {0, 0});
      }
      for (const RegionRequest& ask : asks)
        regions.answered(ask.id, tl::unexpected(map::Failure{.kind = map::FailureKind::Cancelled}),
                         Millis(10'000));
      look(regions, view);
    }
    settle(regions, answer);
    QCOMPARE(wrongIn(regions, ground, view.grown(-0.1)), 0);
  }

  void whatFailsNowAndThenIsNoLimit() {
    const FakeGround ground = hall(6000, 4000);
    MapRegions regions = regionsOf();
    const WorldRect view{-30, 0, 60, 40};
    look(regions, view);
    int count = 0;
    settle(regions, [&](const auto& region) -> Outcome {
      if (++count % 3 == 2) return tl::unexpected(map::Failure{.kind = map::FailureKind::RejectedByRobot});
      return ground.part(region);
    });
    QCOMPARE(wrongIn(regions, ground, view), 0);
    QCOMPARE(regions.plan().lattice().edge_m, 1024 * ground.resolution_m);
  }
};

}  // namespace test_answer_limit

MAPWRIGHT_TEST(test_answer_limit, TestAnswerLimit, Nothing)
#include "test_answer_limit.moc"
