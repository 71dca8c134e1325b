// Numbers over time: nothing of a line is lost in its picture, whatever the order in which it came.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <QtTest>

#include "series/series.h"
#include "test_program.h"

namespace test_series {

using namespace mapwright::series;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A walk with spikes, equal times, silence, and now and then something that is no number.
std::vector<Sample> walk(std::size_t count, std::uint32_t seed, int broken_percent = 1) {
  std::mt19937 random(seed);
  std::vector<Sample> samples;
  double at_s = 1'717'405'200, value = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (random() % 10 != 0) at_s += double(random() % 100) / 1000;
    if (random() % 500 == 0) at_s += 20;
    value += double(int(random() % 201) - 100) / 100;
    const bool spike = random() % 300 == 0, broken = int(random() % 100) < broken_percent;
    samples.push_back({at_s, broken ? kNaN : spike ? value + double(int(random() % 2001) - 1000) : value});
  }
  return samples;
}

Series whole(const std::vector<Sample>& samples) {
  Series series;
  series.insert(samples.front().at_s, samples.back().at_s + 1, samples);
  return series;
}

bool same(const std::vector<Sample>& a, const std::vector<Sample>& b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](const Sample& x, const Sample& y) {
           return x.at_s == y.at_s && (x.value == y.value || (std::isnan(x.value) && std::isnan(y.value)));
         });
}

struct Extremes {
  double least = std::numeric_limits<double>::infinity(), greatest = -std::numeric_limits<double>::infinity();
  void add(double value) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  bool operator==(const Extremes&) const = default;
};

int columnOf(double at_s, double from_s, double until_s, int columns) {
  return int(std::floor((at_s - from_s) / ((until_s - from_s) / columns)));
}

}  // namespace

class TestSeries : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void everySpikeIsInThePicture_data();
  void everySpikeIsInThePicture();
  void aPictureIsAsShortAsItIsWide();
  void fewSamplesAreDrawnAsTheyAre();
  void aLineGoesOnToTheNextSampleOnEitherSide();
  void noLineGoesAcrossWhatIsNotLoaded();
  void noLineGoesAcrossWhatIsNoNumber();
  void theOrderOfRangesDoesNotMatter();
  void aRangeThatComesAgainReplacesWhatItWas();
  void whatLiesOutsideOfItsRangeIsLeftOut();
  void appendingIsTheSameAsInserting();
  void theValueAtATimeIsTheLastOne();
  void extentIsThatOfAllSamples();
  void memoryIsBoundedAndSpikesStay();
  void memoryIsBoundedWhateverComes();
  void whatIsOldIsForgotten();
  void speedIsTheWayOverTheTime();
  void speedDoesNotDependOnTheRanges();
  void beingPlacedAnewIsNoSpeed();
};

void TestSeries::everySpikeIsInThePicture_data() {
  QTest::addColumn<int>("count");
  QTest::addColumn<int>("columns");
  QTest::addColumn<int>("broken");
  for (const int count : {100, 5'000, 200'000}) {
    for (const int columns : {7, 333, 2000}) {
      QTest::addRow("%d in %d", count, columns) << count << columns << 0;
      QTest::addRow("%d in %d, broken", count, columns) << count << columns << 5;
    }
  }
}
void TestSeries::everySpikeIsInThePicture() {
  QFETCH(int, count);
  QFETCH(int, columns);
  QFETCH(int, broken);
  const std::vector<Sample> samples = walk(std::size_t(count), std::uint32_t(count + columns), broken);
  const Series series = whole(samples);
  std::mt19937 random(5);
  const double first_s = samples.front().at_s, length_s = samples.back().at_s - first_s;
  for (int view = 0; view < 10; ++view) {
    const double from_s = view == 0 ? first_s : first_s + length_s * double(random() % 900) / 1000;
    const double until_s =
        view == 0 ? samples.back().at_s : from_s + length_s * double(1 + random() % 500) / 1000;
    std::map<int, Extremes> naive, drawn;
    for (const Sample& each : samples) {
      if (each.at_s >= from_s && each.at_s <= until_s && std::isfinite(each.value))
        naive[std::min(columnOf(each.at_s, from_s, until_s, columns), columns - 1)].add(each.value);
    }
    for (const Stroke& stroke : series.strokes(from_s, until_s, columns)) {
      for (const Sample& point : stroke) {
        if (point.at_s >= from_s && point.at_s <= until_s)
          drawn[std::min(columnOf(point.at_s, from_s, until_s, columns), columns - 1)].add(point.value);
      }
    }
    QCOMPARE(drawn.size(), naive.size());
    QVERIFY(drawn == naive);
  }
}

void TestSeries::aPictureIsAsShortAsItIsWide() {
  const std::vector<Sample> samples = walk(300'000, 3, 0);
  std::size_t points = 0;
  for (const Stroke& stroke : whole(samples).strokes(samples.front().at_s, samples.back().at_s, 500))
    points += stroke.size();
  QVERIFY2(points <= 4 * 500 + 2, qPrintable(QString::number(points)));
}

void TestSeries::fewSamplesAreDrawnAsTheyAre() {
  const std::vector<Sample> samples{{10, 1}, {11, 5}, {12, -2}, {13, 0}};
  const auto strokes = whole(samples).strokes(9, 14, 1000);
  QCOMPARE(strokes.size(), std::size_t(1));
  QVERIFY(same(strokes[0], samples));
}

void TestSeries::aLineGoesOnToTheNextSampleOnEitherSide() {
  const std::vector<Sample> samples{{10, 1}, {20, 2}, {30, 3}, {40, 4}};
  const auto strokes = whole(samples).strokes(22, 28, 100);
  QCOMPARE(strokes.size(), std::size_t(1));
  QVERIFY(same(strokes[0], {{20, 2}, {30, 3}}));
}

void TestSeries::noLineGoesAcrossWhatIsNotLoaded() {
  Series series;
  series.insert(0, 10, std::vector<Sample>{{1, 1}, {9, 2}});
  series.insert(20, 30, std::vector<Sample>{{21, 3}, {29, 4}});
  auto strokes = series.strokes(0, 30, 300);
  QCOMPARE(strokes.size(), std::size_t(2));
  QVERIFY(same(strokes[0], {{1, 1}, {9, 2}}));
  QVERIFY(same(strokes[1], {{21, 3}, {29, 4}}));
  QVERIFY(!series.at(15));
  // It turns out that nothing was said there: the line goes on.
  series.insert(10, 20, {});
  QCOMPARE(series.strokes(0, 30, 300).size(), std::size_t(1));
  QCOMPARE(series.at(15)->value, 2.0);
}

void TestSeries::noLineGoesAcrossWhatIsNoNumber() {
  const std::vector<Sample> samples{
      {1, 1}, {2, 2}, {3, kNaN}, {4, std::numeric_limits<double>::infinity()}, {5, 5}};
  const Series series = whole(samples);
  // As single samples, and where one column holds many of them.
  const auto strokes = series.strokes(0, 6, 600);
  QCOMPARE(strokes.size(), std::size_t(2));
  QVERIFY(same(strokes[1], {{5, 5}}));
  QVERIFY(!series.at(3.5));
  QCOMPARE(series.at(5.5)->value, 5.0);

  std::vector<Sample> many;
  for (int i = 0; i < 300; ++i) many.push_back({double(i), i >= 100 && i < 200 ? kNaN : 1.0});
  QCOMPARE(whole(many).strokes(0, 300, 30).size(), std::size_t(2));
}

void TestSeries::theOrderOfRangesDoesNotMatter() {
  const std::vector<Sample> samples = walk(50'000, 9);
  const double first_s = samples.front().at_s, end_s = samples.back().at_s + 1;
  const Series expected = whole(samples);
  std::mt19937 random(2);
  for (const int pieces : {3, 40, 3000}) {
    std::vector<double> cuts{first_s, end_s};
    for (int i = 0; i < pieces; ++i)
      cuts.push_back(first_s + (end_s - first_s) * double(random() % 1'000'000) / 1e6);
    std::sort(cuts.begin(), cuts.end());
    std::vector<std::size_t> order(cuts.size() - 1);
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), random);
    Series series;
    for (const std::size_t i : order) {
      std::vector<Sample> part;
      std::copy_if(samples.begin(), samples.end(), std::back_inserter(part),
                   [&](const Sample& each) { return each.at_s >= cuts[i] && each.at_s < cuts[i + 1]; });
      series.insert(cuts[i], cuts[i + 1], part);
    }
    QCOMPARE(series.size(), expected.size());
    QCOMPARE(series.covered().size(), std::size_t(1));
    QVERIFY(same(series.samples(first_s, end_s), samples));
    for (const int columns : {10, 777}) {
      const auto a = series.strokes(first_s, end_s, columns), b = expected.strokes(first_s, end_s, columns);
      QCOMPARE(a.size(), b.size());
      for (std::size_t i = 0; i < a.size(); ++i) QVERIFY(same(a[i], b[i]));
    }
  }
}

void TestSeries::aRangeThatComesAgainReplacesWhatItWas() {
  Series series;
  series.insert(0, 100, walk(0, 1));
  std::vector<Sample> many;
  for (int i = 0; i < 10'000; ++i) many.push_back({double(i) / 100, double(i)});
  series.insert(0, 100, many);
  series.insert(0, 100, many);
  QCOMPARE(series.size(), many.size());
  series.insert(25, 75, std::vector<Sample>{{30, -1}});
  QCOMPARE(series.size(), many.size() / 2 + 1);
  QCOMPARE(series.at(60)->value, -1.0);
  QCOMPARE(series.at(24.999)->value, 2499.0);
  QCOMPARE(series.at(75)->value, 7500.0);
  QCOMPARE(series.extent(20, 80)->first, -1.0);
}

void TestSeries::whatLiesOutsideOfItsRangeIsLeftOut() {
  Series series;
  series.insert(10, 20,
                std::vector<Sample>{{25, 1}, {12, 2}, {kNaN, 3}, {10, 4}, {20, 5}, {9.99, 6}, {11, 7}});
  QVERIFY(same(series.samples(0, 100), {{10, 4}, {11, 7}, {12, 2}}));
  series.insert(30, 30, std::vector<Sample>{{30, 1}});
  series.insert(kNaN, 40, std::vector<Sample>{{30, 1}});
  series.append(kNaN, 1);
  QCOMPARE(series.size(), std::size_t(3));
}

void TestSeries::appendingIsTheSameAsInserting() {
  const std::vector<Sample> samples = walk(100'000, 11);
  const double first_s = samples.front().at_s, end_s = samples.back().at_s + 1;
  Series series;
  series.cover(first_s, end_s);
  for (const Sample& each : samples) series.append(each.at_s, each.value);
  const Series expected = whole(samples);
  QVERIFY(same(series.samples(first_s, end_s), samples));
  const auto a = series.strokes(first_s, end_s, 500), b = expected.strokes(first_s, end_s, 500);
  QCOMPARE(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) QVERIFY(same(a[i], b[i]));
  // A clock that was set back.
  series.append(first_s - 5, 42);
  QCOMPARE(series.firstAt(), first_s - 5);
  QCOMPARE(series.lastAt(), samples.back().at_s);
}

void TestSeries::theValueAtATimeIsTheLastOne() {
  const Series series = whole({{10, 1}, {20, 2}, {20, 3}, {30, 4}});
  QVERIFY(!series.at(9.9));
  QCOMPARE(series.at(10)->value, 1.0);
  QCOMPARE(series.at(19.9)->value, 1.0);
  QCOMPARE(series.at(20)->value, 3.0);
  QCOMPARE(series.at(30.5)->value, 4.0);
  QVERIFY(!series.at(40));  // nobody has looked there
  QVERIFY(!Series().at(1));
  QVERIFY(Series().strokes(0, 1, 100).empty());
}

void TestSeries::extentIsThatOfAllSamples() {
  const std::vector<Sample> samples = walk(70'000, 21);
  const Series series = whole(samples);
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const std::size_t a = random() % samples.size(), b = random() % samples.size();
    const double from_s = samples[std::min(a, b)].at_s, until_s = samples[std::max(a, b)].at_s;
    Extremes naive;
    for (const Sample& each : samples) {
      if (each.at_s >= from_s && each.at_s <= until_s && std::isfinite(each.value)) naive.add(each.value);
    }
    const auto extent = series.extent(from_s, until_s);
    QCOMPARE(extent.has_value(), std::isfinite(naive.least));
    if (extent) QVERIFY(extent->first == naive.least && extent->second == naive.greatest);
  }
}

void TestSeries::memoryIsBoundedAndSpikesStay() {
  Series series({.most_samples = 10'000});
  series.cover(0, 1e9);
  for (int i = 0; i < 1'000'000; ++i)
    series.append(i, i == 123'456 ? 1e6 : i == 777'777 ? -1e6 : std::sin(i));
  QVERIFY(series.size() <= 10'000);
  QVERIFY(series.thinned());
  QVERIFY2(series.bytes() < 1'000'000, qPrintable(QString::number(series.bytes())));
  QCOMPARE(series.extent(0, 1e9)->first, -1e6);
  QCOMPARE(series.extent(0, 1e9)->second, 1e6);
  QCOMPARE(series.at(123'456)->value, 1e6);
}

void TestSeries::memoryIsBoundedWhateverComes() {
  Series series({.most_samples = 1'000});
  for (int i = 0; i < 100'000; ++i) series.append(i, i % 2 == 0 ? kNaN : i);
  QVERIFY(series.size() <= 1'000);
  Series backwards({.most_samples = 1'000});
  for (int i = 5'000; i > 0; --i) backwards.append(i, i);
  QVERIFY(backwards.size() <= 1'000);
  QCOMPARE(backwards.extent(0, 1e9)->second, 5'000.0);
}

void TestSeries::whatIsOldIsForgotten() {
  Series series;
  series.cover(0, 10'000);
  for (int i = 0; i < 10'000; ++i) series.append(i, i);
  series.forgetBefore(9'000);
  QCOMPARE(series.size(), std::size_t(1'000));
  QCOMPARE(series.firstAt(), 9'000.0);
  QVERIFY(!series.isCovered(8'000, 9'500));
  QVERIFY(series.isCovered(9'000, 9'500));
  QCOMPARE(series.extent(0, 1e9)->first, 9'000.0);
}

void TestSeries::speedIsTheWayOverTheTime() {
  std::vector<Sample> x, y;
  for (int i = 0; i <= 100; ++i) {
    x.push_back({i * 0.1, i * 0.1 * 0.6});
    y.push_back({i * 0.1, i * 0.1 * -0.8});
  }
  const std::vector<Sample> found = speeds(whole(x), whole(y), 0, 20);
  QCOMPARE(found.size(), x.size());
  QVERIFY(std::isnan(found.front().value));
  for (std::size_t i = 3; i < found.size(); ++i) QVERIFY(std::abs(found[i].value - 1) < 1e-9);
}

void TestSeries::speedDoesNotDependOnTheRanges() {
  std::mt19937 random(4);
  std::vector<Sample> x, y;
  double at_s = 0;
  for (int i = 0; i < 3000; ++i) {
    at_s += double(random() % 200) / 1000;
    if (random() % 100 == 0) at_s += 5;
    x.push_back({at_s, double(random() % 1000) / 1000});
    y.push_back({at_s, double(random() % 1000) / 1000});
  }
  const Series xs = whole(x), ys = whole(y);
  const std::vector<Sample> expected = speeds(xs, ys, 0, 1e6);
  std::vector<Sample> found;
  for (double from_s = 0; from_s < at_s + 1; from_s += 0.7) {
    const auto part = speeds(xs, ys, from_s, from_s + 0.7);
    found.insert(found.end(), part.begin(), part.end());
  }
  QVERIFY(same(found, expected));
}

void TestSeries::beingPlacedAnewIsNoSpeed() {
  std::vector<Sample> x, y;
  for (int i = 0; i <= 100; ++i) {
    x.push_back({i * 0.1, i < 50 ? 0.0 : 30.0});
    y.push_back({i * 0.1, 0});
  }
  for (const Sample& each : speeds(whole(x), whole(y), 0, 20))
    QVERIFY(std::isnan(each.value) || each.value < 0.001);
}

}  // namespace test_series

MAPWRIGHT_TEST(test_series, TestSeries, Nothing)
#include "test_series.moc"
