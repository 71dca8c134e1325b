// A submission that goes on after a failure, and one that sends only what somebody has looked at.
#include <QSignalSpy>
#include <QtTest>

#include "edit/open_waypoints.h"
#include "fake_waypoint_store.h"
#include "test_program.h"

namespace test_going_on {

using namespace mapwright;
using namespace mapwright::edit;
using test::FakeWaypointStore;
using test::waypoint;
using State = SubmittedRequest::State;

namespace {

struct Desk {
  Desk() {
    store.is_called = true;
    store.points = {waypoint("a", 0, 0, "A"), waypoint("b", 5, 0, "B"), waypoint("c", 9, 0, "C")};
    list = std::make_unique<OpenWaypoints>(store, map::MapKey{map::MapKind::Stored, "1"},
                                           QStringLiteral("kabam+ws://192.0.2.7"), EditOptions{});
  }
  WaypointDocument& document() { return list->document(); }
  void set(const map::Waypoint& to) { document().change({document().to(to.id, to)}, QStringLiteral("set")); }
  void refuse(std::size_t nth) {
    store.before_performing = [this, nth] {
      map::Failure refused{map::FailureKind::RejectedByRobot};
      refused.applied = map::Applied::No;
      if (store.asked.size() == nth) store.failures.push_back(refused);
    };
  }
  std::vector<State> states() const {
    std::vector<State> states;
    for (const auto& row : list->submission().rows()) states.push_back(row.state);
    return states;
  }

  FakeWaypointStore store{FakeWaypointStore::Mode::OneByOne};
  std::unique_ptr<OpenWaypoints> list;
};

#define READY(desk) QTRY_COMPARE((desk).list->phase(), OpenWaypoints::Phase::Ready)
#define STOPPED(desk) QTRY_COMPARE((desk).list->submission().phase(), SubmissionPhase::Stopped)

}  // namespace

class TestGoingOn : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void othersAreSentAndThatItFailedIsNotForgotten() {
    Desk desk;
    READY(desk);
    for (const char* key : {"a", "b", "c"}) desk.set(waypoint(key, 20, 0, key));
    desk.refuse(1);
    desk.list->send(desk.list->planned(), AtFailure::GoOn);
    STOPPED(desk);
    QCOMPARE(desk.states(), (std::vector<State>{State::Failed, State::Done, State::Done}));
    QCOMPARE(desk.list->submission().failure()->kind, map::FailureKind::RejectedByRobot);
    QVERIFY(desk.list->looked());
    QCOMPARE(desk.document().unsaved(), (std::set<Key>{"a"}));
  }

  void whatNeedsTheFailedOneIsLeftOut() {
    Desk desk;
    READY(desk);
    // A keeps its name, since it could not be deleted; so nobody else gets it.
    desk.document().change({desk.document().to("a", std::nullopt)}, QStringLiteral("delete"));
    desk.set(waypoint("b", 5, 0, "A"));
    desk.set(waypoint("c", 9, 1, "C"));
    desk.refuse(1);
    desk.list->send(desk.list->planned(), AtFailure::GoOn);
    STOPPED(desk);
    QCOMPARE(desk.states(), (std::vector<State>{State::Failed, State::NotSent, State::Done}));
    QCOMPARE(desk.store.asked.size(), std::size_t(2));
  }

  void nothingButWhatWasReviewedIsSent() {
    Desk desk;
    READY(desk);
    desk.set(waypoint("a", 20, 0, "A"));
    const auto reviewed = desk.list->planned();
    desk.set(waypoint("b", 20, 0, "B"));
    desk.list->send(reviewed, AtFailure::Stop);
    QTRY_COMPARE(desk.list->submission().phase(), SubmissionPhase::Undecided);
    QVERIFY(desk.store.asked.empty() && desk.document().conflicts().empty());
    desk.list->send(desk.list->planned(), AtFailure::Stop);
    QTRY_COMPARE(desk.list->submission().phase(), SubmissionPhase::Done);
    QCOMPARE(desk.store.asked.size(), std::size_t(2));
  }

  void aSecondSubmissionBeginsWithoutTheRowsOfTheFirst() {
    Desk desk;
    READY(desk);
    for (const double x : {1.0, 2.0}) {
      desk.set(waypoint("a", x, 0, "A"));
      desk.list->save();
      QTRY_COMPARE(desk.list->submission().phase(), SubmissionPhase::Done);
      QCOMPARE(desk.list->submission().rows().size(), std::size_t(1));
    }
  }
};

}  // namespace test_going_on

MAPWRIGHT_TEST(test_going_on, TestGoingOn, Widgets)
#include "test_going_on.moc"
