// The axis of a bag, the times that are typed and shown, and what happened as marks: pure.
#include <set>

#include <QtTest>

#include "excerpt/time_typed.h"
#include "replay/event_sentence.h"
#include "test_program.h"
#include "ui/replay/timeline_axis.h"
#include "ui/replay/timeline_events.h"

namespace test_timeline {

using namespace mapwright;
using namespace mapwright::ui;
using replay::Event;
using replay::EventKind;

namespace {

// 2023-10-31 14:36:17.250
constexpr double kStart = 1'698'762'977.25;
constexpr double kEnd = kStart + 600;

Event at(double at_s, EventKind kind) {
  Event event;
  event.at_s = at_s;
  event.kind = kind;
  return event;
}

TimelineAxis axis(double from_s, double until_s, double width_px = 800) {
  TimelineAxis made;
  made.from_s = from_s;
  made.until_s = until_s;
  made.width_px = width_px;
  return made;
}

}  // namespace

class TestTimeline : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatFallsTogetherIsOneMarkThatTellsHowMany() {
    const TimelineAxis shown = axis(kStart, kEnd);  // 0.75 s a pixel
    std::vector<Event> events;
    for (const double after_s : {10.0, 11.0, 12.0, 200.0, 400.0})
      events.push_back(at(kStart + after_s, EventKind::MoveState));
    events[1].kind = EventKind::EmergencyStopOn;
    const auto clusters = clustersOf(events, shown);
    QCOMPARE(clusters.size(), std::size_t(3));
    QCOMPARE(clusters[0].first, std::size_t(0));
    QCOMPARE(clusters[0].count, std::size_t(3));
    QCOMPARE(int(clusters[0].mark.mark), int(Mark::Bad));
    QVERIFY(std::abs(clusters[0].px - shown.pixelOf(kStart + 11)) < 1e-6);
    QCOMPARE(clusters[1].count, std::size_t(1));
    QVERIFY(std::abs(clusters[2].px - shown.pixelOf(kStart + 400)) < 1e-6);
    QVERIFY(clustersOf({}, shown).empty());
  }

  void anOverfullLaneIsARowOfNumbersSideBySide() {
    const TimelineAxis shown = axis(kStart, kStart + 8 * 3600);
    std::vector<Event> events;
    for (int i = 0; i < 20'000; ++i) events.push_back(at(kStart + i * 1.4, EventKind::MoveState));
    const auto clusters = clustersOf(events, shown);
    QVERIFY(clusters.size() > 5 && clusters.size() < 60);
    std::size_t count = 0;
    double end_px = -1e9;
    for (const EventCluster& cluster : clusters) {
      QVERIFY(cluster.px - cluster.half_px >= end_px);
      QCOMPARE(cluster.first, count);
      end_px = cluster.px + cluster.half_px;
      count += cluster.count;
    }
    QCOMPARE(count, events.size());
  }

  void everyKindOfEventBelongsToAGroup() {
    std::set<QString> words;
    for (const replay::EventGroup group : replay::kEventGroups) {
      QVERIFY(!groupName(group).isEmpty());
      words.insert(QString::fromStdString(replay::wordOf(group)));
    }
    QCOMPARE(words.size(), std::size(replay::kEventGroups));
    QVERIFY(replay::groupOf(EventKind::QualityLow) == replay::groupOf(EventKind::PositionJump));
    QVERIFY(replay::groupOf(EventKind::MoveState) != replay::groupOf(EventKind::AlertBegan));
  }

  void readsTheTimesThatPeopleType_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<double>("after_start_s");
    const auto row = [](const char* typed, double after_s) {
      QTest::newRow(typed) << QString::fromLatin1(typed) << after_s;
    };
    row("14:36:17.250", 0);
    row(" 14:40:17.25 ", 240);
    row("14:40", 222.75);
    row("14:36", 0);
    row("14:40:17,25", 240);
    row("2023-10-31 14:40:17.250", 240);
    row("2023-10-31T14:40:17.250Z", 240);
    row("2023-10-31T15:40:17.250+01:00", 240);
    row("+90", 90);
    row("+1:30", 90);
    row("+1:30.5", 90.5);
    row("-10", 590);
    row("-1:00", 540);
    row("12.5", 12.5);
    row("12.5 s", 12.5);
    row("1698763037.25", 60);
  }
  void readsTheTimesThatPeopleType() {
    QFETCH(QString, typed);
    QFETCH(double, after_start_s);
    const auto read = excerpt::timeTyped(typed, kStart, kEnd);
    QVERIFY(read);
    QVERIFY2(std::abs(*read - (kStart + after_start_s)) < 1e-3, qPrintable(QString::number(*read - kStart)));
  }

  void aNumberIsAStampWhereStampsBeginAtZero() {
    QCOMPARE(excerpt::timeTyped(QStringLiteral("12.5"), 3, 60), std::optional(12.5));
    QCOMPARE(excerpt::timeTyped(QStringLiteral("+12.5"), 3, 60), std::optional(15.5));
    QVERIFY(!excerpt::timeTyped(QStringLiteral("2"), 3, 60));
  }

  void takesNothingElseForATime() {
    for (const char* typed : {"", "noon", "25:00", "14:61", "14:00:00", "2023-10-30 14:40:17", "+601", "-601",
                              "nan", "inf", "+-3", "1e99", "1698762000", "14:40:17:00", "+99999999999999"})
      QVERIFY2(!excerpt::timeTyped(QString::fromLatin1(typed), kStart, kEnd), typed);
  }

  void aClockTimeIsOfTheDayThatTheBagReaches() {
    // 23:50 to 00:10
    const double from_s = 1'698'796'200, until_s = from_s + 1200;
    QCOMPARE(excerpt::timeTyped(QStringLiteral("23:55:00"), from_s, until_s), std::optional(from_s + 300));
    QCOMPARE(excerpt::timeTyped(QStringLiteral("00:05:00"), from_s, until_s), std::optional(from_s + 900));
    QVERIFY(!excerpt::timeTyped(QStringLiteral("12:00:00"), from_s, until_s));
  }

  void showsTimesAsTheyAreTyped() {
    QCOMPARE(clockText(kStart), QStringLiteral("14:36:17.250"));
    QCOMPARE(clockText(kStart, 0), QStringLiteral("14:36:17"));
    QCOMPARE(clockText(kStart, 1), QStringLiteral("14:36:17.2"));
    QCOMPARE(dayText(kStart), QStringLiteral("2023-10-31"));
    QCOMPARE(elapsedText(12.56), QStringLiteral("0:12.5"));
    QCOMPARE(elapsedText(3723), QStringLiteral("1:02:03.0"));
    QVERIFY(!clockText(std::numeric_limits<double>::infinity()).isEmpty());
    QCOMPARE(excerpt::timeTyped(clockText(kStart), kStart, kEnd), std::optional(kStart));
  }

  void readsSpeedsWithinTheirBounds() {
    QCOMPARE(speedTyped(QStringLiteral("2x")), std::optional(2.0));
    QCOMPARE(speedTyped(QStringLiteral(" -0.5 x")), std::optional(-0.5));
    QCOMPARE(speedTyped(QStringLiteral("0,1")), std::optional(0.1));
    for (const char* typed : {"", "x", "0", "0.05x", "21", "-21x", "nan", "fast"})
      QVERIFY2(!speedTyped(QString::fromLatin1(typed)), typed);
    QCOMPARE(speedText(0.5), QStringLiteral("0.5x"));
    QCOMPARE(speedText(-20), QStringLiteral("-20x"));
  }

  void labelsAreRoundAndApart() {
    for (const double length_s : {0.2, 1.0, 7.0, 60.0, 600.0, 3600.0, 8 * 3600.0, 86'400.0 * 40}) {
      const TimelineAxis shown = axis(kStart, kStart + length_s);
      double last_px = -1e9;
      int labels = 0;
      for (const AxisTick& tick : axisTicks(shown, 100)) {
        QVERIFY(tick.at_s >= shown.from_s && tick.at_s <= shown.until_s);
        if (tick.label.isEmpty()) continue;
        ++labels;
        QVERIFY(shown.pixelOf(tick.at_s) - last_px > 99);
        last_px = shown.pixelOf(tick.at_s);
      }
      QVERIFY2(labels >= 2, qPrintable(QString::number(length_s)));
    }
    const auto ticks = axisTicks(axis(kStart, kEnd), 100);
    QVERIFY(std::any_of(ticks.begin(), ticks.end(),
                        [](const AxisTick& t) { return t.label == QLatin1String("14:38"); }));
  }

  void zoomsAroundAPlaceAndStaysInTheBag() {
    const TimelineAxis all = axis(kStart, kEnd);
    const TimelineAxis near = all.zoomed(0.5, kStart + 100, kStart, kEnd);
    QCOMPARE(near.until_s - near.from_s, 300.0);
    QVERIFY(std::abs(near.pixelOf(kStart + 100) - all.pixelOf(kStart + 100)) < 1e-3);
    const TimelineAxis far = near.zoomed(100, kStart + 100, kStart, kEnd);
    QCOMPARE(far.from_s, kStart);
    QCOMPARE(far.until_s, kEnd);
    const TimelineAxis nearest = near.zoomed(1e-9, kStart + 100, kStart, kEnd);
    QVERIFY(nearest.until_s - nearest.from_s >= TimelineAxis::kNearestS * 0.999);
    QCOMPARE(near.movedBy(1e6, kStart, kEnd).until_s, kEnd);
    const TimelineAxis page = near.showing(kStart + 500, kStart, kEnd);
    QVERIFY(page.from_s <= kStart + 500 && page.until_s >= kStart + 500);
    QCOMPARE(page.until_s - page.from_s, 300.0);
  }

  void goesFromEventToEvent() {
    const std::vector<Event> events{at(10, EventKind::AlertBegan), at(20, EventKind::QualityLow),
                                    at(30, EventKind::QualityGood)};
    QCOMPARE(nextEvent(events, 0, 1)->at_s, 10.0);
    QCOMPARE(nextEvent(events, 10, 1)->at_s, 20.0);
    QCOMPARE(nextEvent(events, 10, -1), nullptr);
    QCOMPARE(nextEvent(events, 30, 1), nullptr);
    QCOMPARE(nextEvent(events, 30, -1)->at_s, 20.0);
    QCOMPARE(nextEvent({}, 5, 1), nullptr);
  }

  void poorStretchesLastUntilTheyEnd() {
    const std::vector<Event> events{at(10, EventKind::QualityLow), at(12, EventKind::QualityGood),
                                    at(20, EventKind::QualityLow)};
    const auto stretches = poorStretches(events, 30);
    QCOMPARE(stretches.size(), std::size_t(2));
    QCOMPARE(stretches[0], (Stretch{10, 12}));
    QCOMPARE(stretches[1], (Stretch{20, 30}));
  }

  void anEventIsOnePlainLine() {
    Event event = at(1, EventKind::AlertBegan);
    event.code = 1001;
    event.text = "<b>stuck</b>\nhere\u202e";
    QCOMPARE(replay::eventText(event), QStringLiteral("Alert 1001: <b>stuck</b> here"));
    event.text = std::string(100'000, 'x');
    QVERIFY(replay::eventText(event).size() < 200);
  }
};

}  // namespace test_timeline

MAPWRIGHT_TEST(test_timeline, TestTimeline, Core)
#include "test_timeline.moc"
