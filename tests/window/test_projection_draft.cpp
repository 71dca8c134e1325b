// What is to be projected, edited beside what the robot says.
#include <limits>

#include <QtTest>

#include "test_program.h"
#include "ui/clouds/projection_draft.h"
#include "ui/clouds/section_view.h"

namespace test_projection_draft {

using namespace mapwright;
using namespace mapwright::ui;
using map::ProjectionFlaw;
using List = ProjectionDraft::List;

namespace {

map::Projection floorAt(double x, double y) { return {{}, {x, y}, {10, 5}, 0, 2}; }

}  // namespace

class TestProjectionDraft : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whatTheRobotSaysIsTakenOverUnlessSomethingWasEdited() {
    ProjectionDraft draft;
    QVERIFY(!draft.changed());
    QVERIFY(draft.setAnswer({floorAt(0, 0)}));
    QVERIFY(!draft.changed());
    draft.set(0, floorAt(1, 0));
    QVERIFY(draft.changed());
    QVERIFY(!draft.setAnswer({floorAt(7, 7), floorAt(8, 8)}));
    QCOMPARE(draft.wanted(), List{floorAt(1, 0)});
    draft.revert();
    QCOMPARE(draft.wanted().size(), std::size_t(2));
    QVERIFY(!draft.changed());
    draft.add(floorAt(9, 9));
    draft.settle({floorAt(3, 3)});
    QCOMPARE(draft.wanted(), List{floorAt(3, 3)});
    QVERIFY(!draft.selected());
  }

  void anEmptyListIsAnEditToo() {
    ProjectionDraft draft;
    draft.setAnswer({floorAt(0, 0)});
    draft.select(0);
    draft.removeSelected();
    QVERIFY(draft.changed());
    QVERIFY(draft.wanted().empty());
    QVERIFY(!draft.selected());
    // A robot that says nothing of what it projects can be told all the same.
    ProjectionDraft silent;
    silent.add(floorAt(0, 0));
    QVERIFY(silent.changed());
  }

  void whatIsTakenOutLeavesTheNextOneChosen() {
    ProjectionDraft draft;
    draft.setAnswer({floorAt(0, 0), floorAt(1, 1), floorAt(2, 2)});
    draft.select(1);
    draft.removeSelected();
    QCOMPARE(draft.selected(), std::optional(1));
    QCOMPARE(*draft.selectedOne(), floorAt(2, 2));
    draft.removeSelected();
    QCOMPARE(draft.selected(), std::optional(0));
    draft.select(5);
    QVERIFY(!draft.selected());
  }

  void whatMeansNothingIsNamed() {
    map::Projection one = floorAt(0, 0);
    QVERIFY(map::flawOf(one) == ProjectionFlaw::None);
    one.size_m.x() = 0;
    QVERIFY(map::flawOf(one) == ProjectionFlaw::WithoutSize);
    one = floorAt(0, 0);
    one.max_z_m = one.min_z_m;
    QVERIFY(map::flawOf(one) == ProjectionFlaw::HeightsCrossed);
    one = floorAt(2e7, 0);
    QVERIFY(map::flawOf(one) == ProjectionFlaw::TooFar);
    one = floorAt(std::numeric_limits<double>::quiet_NaN(), 0);
    QVERIFY(map::flawOf(one) == ProjectionFlaw::NotFinite);
    ProjectionDraft draft;
    draft.setAnswer({floorAt(0, 0), one});
    QCOMPARE(draft.firstFlawed(), std::optional(1));
  }

  void whatARobotMadeOfItIsComparedAsGridsAre() {
    map::Projection near = floorAt(0.05, 0);
    QCOMPARE(map::differing({floorAt(0, 0)}, {near}), 0);
    near.max_z_m = 3;
    QCOMPARE(map::differing({floorAt(0, 0)}, {near}), 1);
    QCOMPARE(map::differing({floorAt(0, 0), floorAt(4, 4)}, {floorAt(0, 0)}), 1);
    QCOMPARE(map::differing({}, {}), 0);
  }

  void rectanglesAreTakenHoldOfWhereTheHandIs() {
    const map::Projection one = floorAt(0, 0);  // 10 x 5
    QVERIFY(gripAt(one, {5, 2}, 0.2) == RectGrip::Inside);
    QVERIFY(gripAt(one, {0.1, 2}, 0.2) == RectGrip::Left);
    QVERIFY(gripAt(one, {10.1, 2}, 0.2) == RectGrip::Right);
    QVERIFY(gripAt(one, {4, -0.1}, 0.2) == RectGrip::Bottom);
    QVERIFY(gripAt(one, {4, 5.1}, 0.2) == RectGrip::Top);
    QVERIFY(gripAt(one, {10, 5}, 0.2) == RectGrip::TopRight);
    QVERIFY(gripAt(one, {0, 0}, 0.2) == RectGrip::BottomLeft);
    QVERIFY(gripAt(one, {11, 2}, 0.2) == RectGrip::None);
  }

  void pulledOverItsOtherSideARectangleTurnsRound() {
    const map::Projection one = floorAt(0, 0);
    QCOMPARE(moved(one, RectGrip::Inside, {1, 2}), floorAt(1, 2));
    map::Projection after = moved(one, RectGrip::Left, {12, 9});
    QCOMPARE(after.corner_m, Eigen::Vector2d(10, 0));
    QCOMPARE(after.size_m, Eigen::Vector2d(2, 5));
    after = moved(one, RectGrip::TopRight, {-10, 1});
    QCOMPARE(after.corner_m, Eigen::Vector2d(0, 0));
    QVERIFY(after.size_m.x() > 0);
    QCOMPARE(after.size_m.y(), 6.0);
    QCOMPARE(moved(one, RectGrip::None, {1, 1}), one);
  }

  void bandsKeepTheirEndsInOrder() {
    const std::vector<SectionBand> bands{
        {0, 0, 2, false, true}, {1, 2.1, 4, true, true}, {2, 6, 7, false, false}};
    // The chosen one's edge, though the other's is nearer.
    const auto edge = edgeNear(bands, 2.02, 0.2);
    QVERIFY(edge && edge->at == 1 && edge->low);
    const auto other = edgeNear(bands, 0.05, 0.2);
    QVERIFY(other && other->at == 0 && other->low);
    QVERIFY(!edgeNear(bands, 5, 0.2));
    QVERIFY(!edgeNear(bands, 6, 0.2));  // it cannot be moved
    QCOMPARE(withEdgeAt(bands[0], false, 3).high_m, 3.0);
    QVERIFY(withEdgeAt(bands[0], true, 9).low_m < 2);
    QVERIFY(withEdgeAt(bands[0], false, -9).high_m > 0);
  }
};

}  // namespace test_projection_draft

MAPWRIGHT_TEST(test_projection_draft, TestProjectionDraft, Core)
#include "test_projection_draft.moc"
