#include <cmath>
#include <limits>
#include <random>

#include <QtTest>

#include "test_program.h"
#include "ui/scene/label_plan.h"

namespace test_label_plan {

using namespace mapwright::ui::scene;
using Position = LabelWish::Position;

namespace {

constexpr QSizeF kText(60, 13);

LabelWish wish(std::uint64_t key, double x, double y, LabelRank rank = LabelRank::Waypoint) {
  return {key, rank, Position::Beside, QRectF(x - 5, y - 5, 10, 10), kText};
}

LabelTask task(std::vector<LabelWish> wishes) {
  LabelTask task;
  task.view = QRectF(0, 0, 800, 600);
  for (const LabelWish& one : wishes) task.symbols.push_back(one.mark);
  task.wishes = std::move(wishes);
  return task;
}

/// As many as there are, anywhere in a square of this size.
LabelTask crowd(int count, double edge_px, int seed = 1) {
  std::mt19937 random{std::uint32_t(seed)};
  std::uniform_real_distribution<double> at(0, edge_px);
  std::vector<LabelWish> wishes;
  for (int i = 0; i < count; ++i) wishes.push_back(wish(std::uint64_t(i), at(random), at(random)));
  return task(std::move(wishes));
}

LabelTask moved(LabelTask task, const QPointF& by) {
  for (LabelWish& wish : task.wishes) wish.mark.translate(by);
  for (QRectF& symbol : task.symbols) symbol.translate(by);
  task.panned = true;
  return task;
}

std::map<std::uint64_t, QRectF> boxes(const LabelTask& task, const LabelPlan& plan) {
  std::map<std::uint64_t, QRectF> boxes;
  for (const PlacedLabel& label : plan.labels) boxes[task.wishes[label.wish].key] = label.box;
  return boxes;
}

}  // namespace

class LabelPlanTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aLabelStandsToTheRightOfItsObject() {
    const LabelTask one = task({wish(1, 300, 300)});
    const LabelPlan plan = placeLabels(one);
    QCOMPARE(plan.labels.size(), std::size_t(1));
    const PlacedLabel& label = plan.labels[0];
    QVERIFY(label.box.left() > one.wishes[0].mark.right());
    QVERIFY(label.box.left() < one.wishes[0].mark.right() + 6);
    QCOMPARE(label.box.center().y(), 300.0);
    QVERIFY(!label.leader);
  }

  void aLabelIsNotCutWhereTheViewBecameSmaller() {
    LabelTask one = task({wish(1, 700, 300)});
    const LabelPlan before = placeLabels(one);
    QVERIFY(before.labels.at(0).box.right() > 760);
    one.view.setWidth(750);
    const LabelPlan plan = placeLabels(one, before.memory);
    QVERIFY(one.view.contains(plan.labels.at(0).box));
    // What is dragged over the edge keeps its place.
    one.steady = one.panned = true;
    QCOMPARE(placeLabels(one, before.memory).labels.at(0).box, before.labels.at(0).box);
  }

  void whatStandsAwayFromItsThingHasALine() {
    const LabelTask all = crowd(300, 600);
    for (const PlacedLabel& label : placeLabels(all).labels) {
      const QRectF near = all.wishes[label.wish].mark.adjusted(-4, -4, 4, 4);
      QVERIFY(label.leader || near.intersects(label.box));
    }
  }

  void noLabelCoversAnotherOneOrASymbol_data() {
    QTest::addColumn<int>("count");
    for (const int count : {10, 60, 300, 3'000}) QTest::addRow("%d", count) << count;
  }
  void noLabelCoversAnotherOneOrASymbol() {
    QFETCH(int, count);
    const LabelTask all = crowd(count, 600);
    const LabelPlan plan = placeLabels(all);
    QVERIFY(plan.labels.size() > 5);
    for (std::size_t i = 0; i < plan.labels.size(); ++i) {
      for (const QRectF& symbol : all.symbols) QVERIFY(!plan.labels[i].box.intersects(symbol));
      for (std::size_t j = 0; j < i; ++j) QVERIFY(!plan.labels[i].box.intersects(plan.labels[j].box));
    }
  }

  void whereThereIsNoRoomBesideItALeaderLineLeadsToIt() {
    std::vector<LabelWish> wishes{wish(1, 300, 300)};
    LabelTask one = task(wishes);
    one.symbols.push_back(QRectF(308, 280, 20, 40));  // right
    one.symbols.push_back(QRectF(272, 280, 20, 40));  // left
    one.symbols.push_back(QRectF(285, 308, 30, 5));   // below
    one.symbols.push_back(QRectF(285, 288, 30, 5));   // above
    const LabelPlan plan = placeLabels(one);
    QCOMPARE(plan.labels.size(), std::size_t(1));
    QVERIFY(plan.labels[0].leader);
    const QLineF leader = *plan.labels[0].leader;
    QVERIFY(plan.labels[0].box.adjusted(-0.1, -0.1, 0.1, 0.1).contains(leader.p2()));
    QVERIFY(QLineF(leader.p1(), QPointF(300, 300)).length() < 8);
  }

  void whatRanksHigherComesFirst() {
    // They lie in one place: one of them has no room at all.
    LabelTask two = task({wish(1, 300, 300, LabelRank::Landmark), wish(2, 300, 300, LabelRank::Door)});
    two.wishes[0].position = two.wishes[1].position = Position::Within;
    for (LabelWish& one : two.wishes) one.mark = QRectF(260, 290, 80, 20);
    two.symbols.clear();
    LabelPlan plan = placeLabels(two);
    QCOMPARE(boxes(two, plan).size(), std::size_t(1));
    QVERIFY(boxes(two, plan).contains(2));
    // Though the other one stood there before.
    LabelTask first = two;
    first.wishes.pop_back();
    plan = placeLabels(two, placeLabels(first).memory);
    QVERIFY(boxes(two, plan).contains(2));
  }

  void whatRestsKeepsItsPlaceWhileRobotsMove() {
    LabelTask resting = crowd(60, 500);
    LabelMemory memory = placeLabels(resting).memory;
    const std::map<std::uint64_t, QRectF> before = boxes(resting, placeLabels(resting));
    for (int step = 0; step < 60; ++step) {
      LabelTask now = resting;
      now.steady = true;
      for (int robot = 0; robot < 3; ++robot) {
        now.wishes.push_back(
            wish(std::uint64_t(1000 + robot), 10.0 * step, 100.0 + 120 * robot, LabelRank::Robot));
        now.symbols.push_back(now.wishes.back().mark);
      }
      const LabelPlan plan = placeLabels(now, memory);
      const std::map<std::uint64_t, QRectF> after = boxes(now, plan);
      for (const auto& [key, box] : before) {
        const auto hit = [&box = box](const LabelWish& one) {
          return one.rank == LabelRank::Robot && one.mark.intersects(box);
        };
        if (std::any_of(now.wishes.begin(), now.wishes.end(), hit)) continue;
        QVERIFY(after.contains(key));
        QCOMPARE(after.at(key), box);
      }
      // Each step follows the first plan: what a robot has pushed away may go on lying elsewhere.
    }
  }

  void whatIsChosenIsNamedHoweverSmallItIs() {
    LabelTask small = task({wish(1, 300, 300)});
    small.wishes[0].position = Position::Within;
    QVERIFY(placeLabels(small).labels.empty());
    small.wishes[0].rank = LabelRank::Chosen;
    QCOMPARE(placeLabels(small).labels.size(), std::size_t(1));
  }

  void aLabelWithinAnAreaStaysInIt() {
    LabelTask area = task({wish(1, 300, 300, LabelRank::Region)});
    area.wishes[0].position = Position::Within;
    area.wishes[0].mark = QRectF(250, 275, 100, 50);
    area.symbols = {QRectF(290, 295, 20, 10)};  // in its middle
    const LabelPlan plan = placeLabels(area);
    QCOMPARE(plan.labels.size(), std::size_t(1));
    QVERIFY(area.wishes[0].mark.contains(plan.labels[0].box));
  }

  void whatIsChosenIsNamedBesideALineThroughItsMiddle() {
    for (const bool upright : {false, true}) {
      LabelTask area = task({wish(1, 300, 300, LabelRank::Chosen)});
      area.wishes[0].position = Position::Within;
      area.wishes[0].mark = QRectF(100, 100, 400, 400);
      area.symbols = {upright ? QRectF(294, 100, 12, 400) : QRectF(100, 294, 400, 12)};
      const LabelPlan plan = placeLabels(area);
      QCOMPARE(plan.labels.size(), std::size_t(1));
      QVERIFY(area.wishes[0].mark.contains(plan.labels[0].box));
      QVERIFY(!plan.labels[0].box.intersects(area.symbols[0]));
    }
  }

  void labelsStayWhileTheMapIsDragged_data() {
    QTest::addColumn<QPointF>("step");
    QTest::newRow("right") << QPointF(37, 0);
    QTest::newRow("left and up") << QPointF(-23, -11);
    QTest::newRow("by parts of pixels") << QPointF(0.3, 0.7);
  }
  void labelsStayWhileTheMapIsDragged() {
    QFETCH(QPointF, step);
    LabelTask all = crowd(900, 2'400);
    all = moved(all, QPointF(-800, -900));
    LabelPlan plan = placeLabels(all);
    for (int i = 0; i < 30; ++i) {
      const auto before = boxes(all, plan);
      all = moved(std::move(all), step);
      plan = placeLabels(all, plan.memory);
      const auto now = boxes(all, plan);
      int compared = 0;
      for (const auto& [key, box] : before) {
        const QRectF there = box.translated(step);
        if (!all.view.intersects(there)) continue;
        const auto still = now.find(key);
        QVERIFY2(still != now.end(), "one has vanished");
        QVERIFY2(QLineF(still->second.topLeft(), there.topLeft()).length() < 1e-6, "one has jumped");
        ++compared;
      }
      QVERIFY(compared > 20);
    }
  }

  void whatComesIntoViewPushesNothingAside() {
    LabelTask all = task({wish(1, 780, 300, LabelRank::Id), wish(2, 790 + 340, 300, LabelRank::Chosen)});
    all.wishes[1].rank = LabelRank::Door;
    LabelPlan plan = placeLabels(all);
    const QRectF before = boxes(all, plan).at(1);
    for (int i = 0; i < 20; ++i) {
      all = moved(std::move(all), {-25, 0});
      plan = placeLabels(all, plan.memory);
    }
    QCOMPARE(boxes(all, plan).at(1), before.translated(-500, 0));
  }

  void aLabelKeepsItsSideWhenWhatDroveItAwayIsGone() {
    LabelTask one = task({wish(1, 300, 300)});
    LabelPlan plan = placeLabels(one);
    const QRectF right = plan.labels[0].box;
    one.symbols.push_back(right);  // the robot drives there
    plan = placeLabels(one, plan.memory);
    const QRectF other = plan.labels.at(0).box;
    QVERIFY(!other.intersects(right));
    one.symbols.pop_back();
    plan = placeLabels(one, plan.memory);
    QCOMPARE(plan.labels.at(0).box, other);
  }

  void oneThatHadNoRoomComesBackOnlyWhenThereIsPlenty() {
    LabelTask one = task({wish(1, 300, 300)});
    one.wishes[0].position = Position::Over;
    const QRectF around = QRectF(240, 270, 120, 60);
    one.symbols = {around};
    LabelPlan plan = placeLabels(one);
    QVERIFY(plan.labels.empty());
    // A robot that trembles at its edge must not make it flicker.
    one.symbols = {QRectF(240, 308, 120, 60), QRectF(240, 230, 120, 62)};
    QVERIFY(!placeLabels(one).labels.empty());
    QVERIFY(placeLabels(one, plan.memory).labels.empty());
    one.symbols.clear();
    QVERIFY(!placeLabels(one, plan.memory).labels.empty());
  }

  void theSameTaskGivesTheSamePlan() {
    const LabelTask all = crowd(500, 700);
    QVERIFY(placeLabels(all).labels == placeLabels(all).labels);
  }

  void oddPlacesAreHarmless() {
    const double none = std::numeric_limits<double>::quiet_NaN();
    LabelTask odd = task({wish(1, 1e300, -1e300), wish(2, none, none), wish(3, 100, 100)});
    odd.wishes.push_back(wish(4, 200, 200));
    odd.wishes.back().size = QSizeF();
    const LabelPlan plan = placeLabels(odd);
    QCOMPARE(plan.labels.size(), std::size_t(1));
    QCOMPARE(odd.wishes[plan.labels[0].wish].key, std::uint64_t(3));
  }

  void aLabelIsInViewIfItCanBe() {
    const LabelTask edge = task({wish(1, 790, 300)});
    QVERIFY(edge.view.contains(placeLabels(edge).labels.at(0).box));
  }
};

}  // namespace test_label_plan

MAPWRIGHT_TEST(test_label_plan, LabelPlanTest, Core)
#include "test_label_plan.moc"
