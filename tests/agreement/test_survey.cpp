// A survey of all submaps: ranked places, what is made again after a change, limits.
#include <algorithm>
#include <limits>

#include <QtTest>

#include "agreement/faults.h"
#include "agreement/survey.h"
#include "submaps.h"
#include "test_program.h"

namespace test_survey {

using namespace mapwright;
using namespace mapwright::testing;
using agreement::Disagreement;
using agreement::Place;
using agreement::Survey;
using agreement::TileTask;

namespace {

/// Makes what is stale; returns how many tiles that were.
int complete(Survey& survey) {
  render::DenseCache cache;
  int made = 0;
  while (const auto task = survey.take()) {
    if (survey.put(*task, agreement::makeTile(*task, cache))) ++made;
  }
  return made;
}

Disagreement surveyed(const std::vector<PlacedTexture>& submaps, const Rules& rules) {
  Survey survey(rules);
  survey.setSubmaps(submaps);
  complete(survey);
  return survey.disagreement();
}

bool sameFindings(const Disagreement& a, const Disagreement& b) {
  return a.occupied_cells == b.occupied_cells && a.contradicted_cells == b.contradicted_cells &&
         std::equal(a.places.begin(), a.places.end(), b.places.begin(), b.places.end(),
                    [](const Place& one, const Place& other) {
                      return one.x == other.x && one.y == other.y && one.cells == other.cells &&
                             one.submaps == other.submaps;
                    }) &&
         std::equal(a.tiles.begin(), a.tiles.end(), b.tiles.begin(), b.tiles.end(),
                    [](const auto& one, const auto& other) {
                      return one.first == other.first &&
                             one.second->contradicted == other.second->contradicted &&
                             one.second->seen_by == other.second->seen_by;
                    });
}

/// A corridor of submaps every 4 m, 10 m long each, with walls on both sides.
std::vector<PlacedTexture> corridor(int count) {
  std::vector<PlacedTexture> all;
  for (int index = 0; index < count; ++index) {
    std::vector<CellPair> cells(200 * 60, kFree);
    for (int column = 0; column < 200; ++column) {
      cells[std::size_t(column)] = kWall;
      cells[std::size_t(59 * 200 + column)] = kWall;
    }
    all.push_back(submap(index, index * 4.0, 0, 200, 60, cells));
  }
  return all;
}

}  // namespace

class TestSurvey : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void findsWhatAPlainReadingFinds();
  void findsASubmapThatWasMoved();
  void ranksPlaces();
  void ranksNoMorePlacesThanAskedFor();
  void makesAgainOnlyWhatChanged();
  void isTheSameAsMadeAnewAfterAnyChanges();
  void forgetsTasksThatAreOutdated();
  void countsHowManySawACell();
  void makesAllOnAPool();
  void stopsWhenToldTo();
  void refusesAWorldThatIsTooLarge();
  void leavesOutWhatHasNoPlace();
};

void TestSurvey::findsWhatAPlainReadingFinds() {
  for (unsigned seed = 50; seed < 58; ++seed) {
    const Rules rules{0.05, int(seed % 5)};
    const auto submaps = someSubmaps(seed, -25, 12.8, 8);
    const PlainReading expected = plainReading(submaps, rules);
    const Disagreement found = surveyed(submaps, rules);
    QCOMPARE(found.occupied_cells, expected.occupied.size());
    QCOMPARE(found.contradicted_cells, expected.contradicted.size());
    QCOMPARE(found.places.size(), expected.squares.size());
    for (const Place& place : found.places) {
      const auto& [cells, ids] = expected.squares.at({int(std::floor(place.x)), int(std::floor(place.y))});
      QCOMPARE(place.cells, std::uint64_t(cells));
      std::vector<std::pair<int, map::SubmapId>> ranked;
      for (const auto& [id, its] : ids) ranked.emplace_back(-(its.first + its.second), id);
      std::sort(ranked.begin(), ranked.end());
      QCOMPARE(place.submaps.size(), ranked.size());
      for (std::size_t at = 0; at < ranked.size(); ++at) {
        const agreement::Part& part = place.submaps[at];
        QVERIFY(part.id == ranked[at].second);
        QCOMPARE(std::pair(int(part.occupied), int(part.free)), ids.at(part.id));
      }
    }
  }
}

void TestSurvey::findsASubmapThatWasMoved() {
  auto submaps = corridor(10);
  QCOMPARE(surveyed(submaps, {}).contradicted_cells, std::uint64_t(0));
  submaps[6].world_from_texture.y_m += 1.5;  // x 24..34
  const Disagreement found = surveyed(submaps, {});
  QVERIFY(found.share() > 0.05);
  for (const Place& place : found.places) {
    QVERIFY(place.x > 23 && place.x < 35);
    const auto ids = agreement::idsOf(place.submaps);
    QVERIFY(std::find(ids.begin(), ids.end(), map::SubmapId{0, 6}) != ids.end());
  }
  QVERIFY(found.places.size() >= 10);
}

void TestSurvey::ranksPlaces() {
  const std::vector<PlacedTexture> submaps{plain(1, 0, 0, 200, 60, kFree), plain(2, 0.2, 0.2, 4, 1, kWall),
                                           plain(3, 1.2, 0.2, 6, 1, kWall), plain(4, 2.2, 1.2, 4, 1, kWall),
                                           plain(5, 0.2, 1.2, 4, 1, kWall)};
  const Disagreement found = surveyed(submaps, {});
  QCOMPARE(found.places.size(), std::size_t(4));
  const std::vector<std::pair<double, double>> order{{1.5, 0.5}, {0.5, 0.5}, {0.5, 1.5}, {2.5, 1.5}};
  for (std::size_t at = 0; at < order.size(); ++at)
    QCOMPARE(std::pair(found.places[at].x, found.places[at].y), order[at]);
  QVERIFY((found.places[0].submaps == std::vector<agreement::Part>{{{0, 1}, 0, 6}, {{0, 3}, 6, 0}}));
  QCOMPARE(found.places[0].cells, std::uint64_t(6));
}

void TestSurvey::ranksNoMorePlacesThanAskedFor() {
  Survey survey;
  QVERIFY(!survey.setSubmaps(someSubmaps(52, -25, 12.8, 8)));
  complete(survey);
  const Disagreement all = survey.disagreement();
  QVERIFY(all.places.size() > 2);
  QCOMPARE(all.all_places, all.places.size());
  for (const std::size_t most : {std::size_t(0), std::size_t(2), all.places.size() + 1}) {
    Disagreement some = agreement::disagreementOf(survey.made(), survey.rules(), most);
    QCOMPARE(some.all_places, all.places.size());
    QCOMPARE(some.places.size(), std::min(most, all.places.size()));
    some.places.insert(some.places.end(), all.places.begin() + std::ptrdiff_t(some.places.size()),
                       all.places.end());
    QVERIFY(sameFindings(some, all));
  }
}

void TestSurvey::makesAgainOnlyWhatChanged() {
  auto submaps = corridor(40);  // 166 m
  Survey survey;
  QVERIFY(!survey.setSubmaps(submaps));
  const int all = complete(survey);
  QVERIFY(all >= 13);
  QCOMPARE(std::size_t(all), survey.tiles());
  QVERIFY(!survey.setSubmaps(submaps));
  QVERIFY(survey.complete());
  submaps[20].world_from_texture.y_m += 0.5;
  QVERIFY(!survey.setSubmaps(submaps));
  QVERIFY(survey.stale() > 0 && survey.stale() <= 4);
  complete(survey);
  QVERIFY(sameFindings(survey.disagreement(), surveyed(submaps, {})));
}

void TestSurvey::isTheSameAsMadeAnewAfterAnyChanges() {
  std::mt19937 random(9);
  auto submaps = someSubmaps(70, 0, 0, 12);
  const auto others = someSubmaps(71, 9, 3, 12);
  Survey survey;
  for (int step = 0; step < 12; ++step) {
    const std::size_t at = random() % submaps.size();
    if (step % 3 == 0) {
      submaps.erase(submaps.begin() + std::ptrdiff_t(at));
    } else if (step % 3 == 1) {
      submaps[at].world_from_texture.x_m += 7;
    } else {
      submaps[at].texture = others[at].texture;
    }
    QVERIFY(!survey.setSubmaps(submaps));
    complete(survey);
    QVERIFY(sameFindings(survey.disagreement(), surveyed(submaps, {})));
  }
  QVERIFY(!survey.setSubmaps({}));
  QCOMPARE(survey.disagreement().occupied_cells, std::uint64_t(0));
  QVERIFY(survey.made().empty());
}

void TestSurvey::forgetsTasksThatAreOutdated() {
  std::vector<PlacedTexture> submaps{plain(1, 1, 1, 10, 10, kWall)};
  Survey survey;
  QVERIFY(!survey.setSubmaps(submaps));
  render::DenseCache cache;
  const auto task = survey.take();
  QVERIFY(task && !survey.take());
  QVERIFY(!survey.complete());
  submaps[0].world_from_texture.x_m += 1;
  QVERIFY(!survey.setSubmaps(submaps));
  QVERIFY(!survey.put(*task, agreement::makeTile(*task, cache)));
  QCOMPARE(survey.stale(), std::size_t(1));
  const auto cancelled = survey.take();
  QVERIFY(!survey.put(*cancelled, nullptr));
  QCOMPARE(survey.stale(), std::size_t(1));
  QCOMPARE(complete(survey), 1);
  QVERIFY(survey.complete());
}

void TestSurvey::countsHowManySawACell() {
  Survey survey;
  QVERIFY(!survey.setSubmaps(std::vector{plain(1, 0, 0, 300, 10, kFree), plain(2, 10, 0, 100, 10, kWall),
                                         plain(3, 10, 0, 50, 10, kMaybe)}));
  complete(survey);
  const agreement::Coverage coverage = survey.coverage();
  QCOMPARE(coverage.seen_cells, std::uint64_t(3000));
  QCOMPARE(coverage.seenOnce(), std::uint64_t(2000));
  QCOMPARE(coverage.cells_seen_by[2], std::uint64_t(500));
  QCOMPARE(coverage.cells_seen_by[3], std::uint64_t(500));
  QCOMPARE(coverage.most(), 3);
  QCOMPARE(agreement::Coverage{}.most(), 0);
}

void TestSurvey::makesAllOnAPool() {
  const auto submaps = someSubmaps(90, 0, 0, 30);
  Survey survey;
  QVERIFY(!survey.setSubmaps(submaps));
  render::DenseCache cache;
  std::size_t last = 0, all = 0;
  QVERIFY(survey.makeAll(std::make_shared<work::Workers>(3), cache, [&](std::size_t made, std::size_t of) {
    last = made, all = of;
    return true;
  }));
  QCOMPARE(last, all);
  QCOMPARE(all, survey.tiles());
  QVERIFY(sameFindings(survey.disagreement(), surveyed(submaps, {})));
}

void TestSurvey::stopsWhenToldTo() {
  const auto submaps = corridor(60);
  Survey survey;
  QVERIFY(!survey.setSubmaps(submaps));
  render::DenseCache cache;
  const auto workers = std::make_shared<work::Workers>(2);
  QVERIFY(!survey.makeAll(workers, cache, [](std::size_t, std::size_t) { return false; }));
  QVERIFY(!survey.complete());
  QVERIFY(survey.makeAll(workers, cache));  // it can go on
  QVERIFY(sameFindings(survey.disagreement(), surveyed(submaps, {})));
}

void TestSurvey::refusesAWorldThatIsTooLarge() {
  Survey survey;
  const std::vector<PlacedTexture> fine{plain(1, 1, 1, 10, 10, kWall)};
  QVERIFY(!survey.setSubmaps(fine));
  complete(survey);
  auto large = fine;
  large.push_back({{0, 2}, cells::CellTexture::fromPairs(1, 1, 1e6, std::vector{kWall}), {}, 0});
  const auto fault = survey.setSubmaps(large);
  QVERIFY(fault && fault->code == agreement::fault::TooLarge);
  QVERIFY(survey.complete());
  QCOMPARE(survey.disagreement().occupied_cells, std::uint64_t(100));
}

void TestSurvey::leavesOutWhatHasNoPlace() {
  auto submaps =
      std::vector{plain(1, 1, 1, 10, 10, kWall), plain(2, 1, 1, 1, 1, kWall), plain(3, 1e12, 1, 1, 1, kWall)};
  submaps[1].world_from_texture.x_m = std::numeric_limits<double>::quiet_NaN();
  submaps.push_back({{0, 4}, nullptr, {}, 0});
  Survey survey;
  QVERIFY(!survey.setSubmaps(submaps));
  QVERIFY((survey.unplaceable() == std::vector<map::SubmapId>{{0, 2}, {0, 3}}));
  complete(survey);
  QCOMPARE(survey.coverage().seen_cells, std::uint64_t(100));
}

}  // namespace test_survey

MAPWRIGHT_TEST(test_survey, TestSurvey, Core)
#include "test_survey.moc"
