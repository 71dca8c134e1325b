// A waypoint list that is open: reading, saving half-way and whole, changes from elsewhere, drafts.
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include "edit/open_waypoints.h"
#include "fake_waypoint_store.h"
#include "test_program.h"

namespace test_open_waypoints {

using namespace mapwright;
using namespace mapwright::edit;
using test::FakeWaypointStore;
using test::waypoint;
using Mode = FakeWaypointStore::Mode;
using State = SubmittedRequest::State;

namespace {

map::Failure failed(map::FailureKind kind, map::Applied applied) { return {kind, {}, applied}; }

struct Desk {
  explicit Desk(Mode mode) : store(mode) {
    store.points = {waypoint("a", 0, 0, "A"), waypoint("b", 5, 0, "B"), waypoint("c", 9, 0, "C")};
    open();
  }
  void open() {
    EditOptions options;
    options.drafts_folder = folder.path();
    options.later = [this](std::chrono::milliseconds, std::function<void()> then) {
      waiting.push_back(std::move(then));
    };
    list = std::make_unique<OpenWaypoints>(store, map::MapKey{map::MapKind::File, {}},
                                           QStringLiteral("file:/office.yaml"), options);
  }
  WaypointDocument& document() { return list->document(); }
  void move(const Key& key, double x) {
    map::Waypoint to = *document().find(key);
    to.position_m.x() = x;
    document().change({document().to(key, to)}, QStringLiteral("move"));
  }
  void ring() {
    for (const auto& then : std::exchange(waiting, {})) then();
  }
  SubmissionPhase phase() const { return list->submission().phase(); }
  std::vector<State> states() const {
    std::vector<State> states;
    for (const auto& row : list->submission().rows()) states.push_back(row.state);
    return states;
  }

  QTemporaryDir folder;
  FakeWaypointStore store;
  std::vector<std::function<void()>> waiting;
  std::unique_ptr<OpenWaypoints> list;
};

#define READY(desk) QTRY_COMPARE((desk).list->phase(), OpenWaypoints::Phase::Ready)

}  // namespace

class TestOpenWaypoints : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void savesEachChangeAndFollowsWhatIsKept_data() {
    QTest::addColumn<int>("mode");
    QTest::newRow("one by one") << int(Mode::OneByOne);
    QTest::newRow("all at once") << int(Mode::AllAtOnce);
  }
  void savesEachChangeAndFollowsWhatIsKept() {
    QFETCH(int, mode);
    Desk desk{Mode(mode)};
    READY(desk);
    desk.move("a", 1);
    desk.document().change({desk.document().to("b", std::nullopt)}, QStringLiteral("delete"));
    desk.document().change({desk.document().to("new", waypoint("new", 3, 3, "New"))}, QStringLiteral("add"));
    QSignalSpy saved(desk.list.get(), &OpenWaypoints::saved);
    desk.list->save();
    QTRY_COMPARE(saved.size(), 1);
    QCOMPARE(desk.store.asked.size(), std::size_t(Mode(mode) == Mode::OneByOne ? 3 : 1));
    QCOMPARE(desk.store.points.size(), std::size_t(3));
    QCOMPARE(desk.store.find("A")->position_m.x(), 1.0);
    QVERIFY(!desk.list->unsaved());
    QCOMPARE(desk.document().items().size(), std::size_t(3));
    QVERIFY(desk.document().find("new"));  // whatever the robot calls it
    // Once more: a new name there is no new thing here.
    desk.move("new", 4);
    desk.list->save();
    QTRY_COMPARE(saved.size(), 2);
    QCOMPARE(desk.store.points.size(), std::size_t(3));
    QCOMPARE(desk.store.find("New")->position_m.x(), 4.0);
  }

  void whatWasReadBeforeItWasSavedTakesNothingBack() {
    Desk desk(Mode::OneByOne);
    READY(desk);
    desk.store.slow = true;
    desk.list->read();
    desk.store.slow = false;
    desk.move("a", 1);
    QSignalSpy saved(desk.list.get(), &OpenWaypoints::saved);
    desk.list->save();
    QTRY_COMPARE(saved.size(), 1);
    desk.store.slow = true;
    desk.store.answers[0]();
    QCOMPARE(desk.document().find("a")->position_m.x(), 1.0);
    QVERIFY(!desk.list->unsaved());
    QCOMPARE(desk.store.answers.size(), std::size_t(2));  // it reads again instead
    desk.store.answers[1]();
    QCOMPARE(desk.document().find("a")->position_m.x(), 1.0);
    desk.store.put(waypoint("a", 2, 0, "A"));
    desk.list->read();
    desk.store.answers[2]();
    QCOMPARE(desk.document().find("a")->position_m.x(), 2.0);  // somebody else's
  }

  void savingNothingAsksForNothing() {
    Desk desk(Mode::AllAtOnce);
    READY(desk);
    QSignalSpy saved(desk.list.get(), &OpenWaypoints::saved);
    desk.list->save();
    QTRY_COMPARE(saved.size(), 1);
    QVERIFY(desk.store.asked.empty());
  }

  void stopsHalfWaySaysWhatWasAppliedAndGoesOn() {
    Desk desk(Mode::OneByOne);
    READY(desk);
    for (const char* key : {"a", "b", "c"}) desk.move(key, 20);
    // The first is done, the second refused.
    desk.store.before_performing = [&] {
      if (desk.store.asked.size() == 2)
        desk.store.failures.push_back(failed(map::FailureKind::RejectedByRobot, map::Applied::No));
    };
    desk.list->save();
    QTRY_COMPARE(desk.phase(), SubmissionPhase::Stopped);
    QCOMPARE(desk.states(), (std::vector<State>{State::Done, State::Failed, State::NotSent}));
    QCOMPARE(desk.list->submission().rows()[1].failure->applied, map::Applied::No);
    QCOMPARE(desk.document().unsaved(), (std::set<Key>{"b", "c"}));
    desk.list->save();
    QTRY_COMPARE(desk.phase(), SubmissionPhase::Done);
    QCOMPARE(desk.store.asked.size(), std::size_t(4));
    QCOMPARE(desk.states(), (std::vector<State>{State::Done, State::Done, State::Done}));
    QVERIFY(!desk.list->unsaved());
  }

  void afterALostAnswerItLooksWhetherItIsSaved() {
    Desk desk(Mode::OneByOne);
    READY(desk);
    desk.document().change({desk.document().to("new", waypoint("new", 3, 3, "New"))}, QStringLiteral("add"));
    desk.store.failures = {failed(map::FailureKind::TimedOut, map::Applied::Maybe)};  // and it was made
    QSignalSpy saved(desk.list.get(), &OpenWaypoints::saved);
    desk.list->save();
    QTRY_COMPARE(saved.size(), 1);
    QCOMPARE(desk.phase(), SubmissionPhase::Done);
    QCOMPARE(desk.store.asked.size(), std::size_t(1));
    QVERIFY(!desk.list->unsaved());
  }

  void whatWasLostWithTheLinkIsLookedForBeforeItIsSentAgain() {
    Desk desk(Mode::OneByOne);
    READY(desk);
    desk.document().change({desk.document().to("new", waypoint("new", 3, 3, "New"))}, QStringLiteral("add"));
    desk.store.failures = {failed(map::FailureKind::TimedOut, map::Applied::Maybe)};  // and it was made
    desk.store.before_performing = [&] { desk.store.unreadable = true; };
    desk.list->save();
    QTRY_COMPARE(desk.phase(), SubmissionPhase::Stopped);
    desk.store.before_performing = nullptr;
    desk.store.unreadable = false;
    QVERIFY(desk.list->unsaved());
    const int reads = desk.store.reads;
    desk.list->save();
    QTRY_COMPARE(desk.phase(), SubmissionPhase::Done);
    QVERIFY(desk.store.reads > reads);
    QCOMPARE(desk.store.asked.size(), std::size_t(1));  // not made twice
    QCOMPARE(desk.document().items().size(), std::size_t(4));
    QVERIFY(!desk.list->unsaved());
  }

  void canBeCancelled() {
    Desk desk(Mode::OneByOne);
    READY(desk);
    desk.move("a", 1);
    desk.move("b", 2);
    desk.store.hold = true;
    desk.list->save();
    QTRY_COMPARE(desk.store.asked.size(), std::size_t(1));
    QVERIFY(desk.document().state("a").sent);
    desk.list->cancelSaving();
    QTRY_COMPARE(desk.phase(), SubmissionPhase::Stopped);
    QCOMPARE(desk.list->submission().failure()->kind, map::FailureKind::Cancelled);
    QCOMPARE(desk.states(), (std::vector<State>{State::Failed, State::NotSent}));
    QVERIFY(!desk.document().state("a").sent);
    QVERIFY(desk.list->unsaved());
  }

  void aRobotThatIsGoneLeavesDoubtOfWhatWasInProgress() {
    Desk desk(Mode::OneByOne);
    READY(desk);
    desk.move("a", 1);
    desk.store.hold = true;
    desk.list->save();
    QTRY_COMPARE(desk.store.asked.size(), std::size_t(1));
    desk.list->robotGone();
    QCOMPARE(desk.phase(), SubmissionPhase::Stopped);
    QCOMPARE(desk.list->submission().rows()[0].failure->applied, map::Applied::Maybe);
    desk.list->save();
    desk.list->read();
    QCOMPARE(desk.phase(), SubmissionPhase::Stopped);
  }

  void aListThatIsGoneTakesNothingAlong() {
    Desk desk{Mode::AllAtOnce};
    READY(desk);
    desk.move("a", 1);
    QSignalSpy remarked(desk.list.get(), &OpenWaypoints::remarked);
    desk.store.points.clear();
    desk.store.there = false;
    Q_EMIT desk.store.changed();
    QTRY_COMPARE(remarked.size(), 1);
    QCOMPARE(desk.document().items().size(), std::size_t(3));
    QCOMPARE(desk.document().unsaved().size(), std::size_t(3));
    QVERIFY(desk.document().conflicts().empty());
    Q_EMIT desk.store.changed();  // still gone: that is known
    QTRY_COMPARE(desk.store.reads, 3);
    QSignalSpy saved(desk.list.get(), &OpenWaypoints::saved);
    desk.store.there = true;
    desk.list->save();
    QTRY_COMPARE(saved.size(), 1);
    QCOMPARE(desk.store.points.size(), std::size_t(3));
    QCOMPARE(remarked.size(), 1);
  }

  void aListThatWasEmptiedIsEmpty() {
    Desk desk{Mode::AllAtOnce};
    READY(desk);
    desk.store.points.clear();
    Q_EMIT desk.store.changed();
    QTRY_VERIFY(desk.document().items().empty());
  }

  void changesFromElsewhereComeIn() {
    Desk desk(Mode::AllAtOnce);
    READY(desk);
    desk.move("a", 1);
    desk.store.put(waypoint("b", 7, 7, "B"));
    Q_EMIT desk.store.changed();
    QTRY_COMPARE(desk.document().find("b")->position_m.x(), 7.0);
    QCOMPARE(desk.document().find("a")->position_m.x(), 1.0);
  }

  void whoWasOvertakenLooksAgainAndMerges() {
    Desk desk(Mode::AllAtOnce);
    READY(desk);
    desk.move("a", 1);
    desk.store.before_performing = [&] {
      if (desk.store.asked.size() == 1) desk.store.put(waypoint("b", 7, 7, "B"));
    };
    desk.list->save();
    QTRY_COMPARE(desk.phase(), SubmissionPhase::Done);
    QCOMPARE(desk.store.find("A")->position_m.x(), 1.0);
    QCOMPARE(desk.store.find("B")->position_m.x(), 7.0);
  }

  void whatCollidesHasToBeDecidedFirst() {
    Desk desk(Mode::AllAtOnce);
    READY(desk);
    desk.move("a", 1);
    desk.store.put(waypoint("a", 2, 0, "A"));
    desk.list->save();
    QTRY_COMPARE(desk.phase(), SubmissionPhase::Undecided);
    QVERIFY(desk.store.asked.empty());
    desk.document().decide("a", Side::Mine, QStringLiteral("mine"));
    desk.list->save();
    QTRY_COMPARE(desk.phase(), SubmissionPhase::Done);
    QCOMPARE(desk.store.find("A")->position_m.x(), 1.0);
  }

  void aListThatCannotBeReadIsNotEdited() {
    Desk desk(Mode::AllAtOnce);
    desk.store.unreadable = true;
    desk.open();
    QTRY_COMPARE(desk.list->phase(), OpenWaypoints::Phase::Failed);
    desk.list->save();
    QCOMPARE(desk.phase(), SubmissionPhase::Idle);
    desk.store.unreadable = false;
    desk.list->read();
    READY(desk);
    QVERIFY(!desk.list->failure());
  }

  void aDraftIsOfferedAfterAnEndWithoutSaving() {
    Desk desk(Mode::AllAtOnce);
    READY(desk);
    desk.move("a", 1);
    desk.ring();
    desk.list.reset();
    desk.store.put(waypoint("a", 0, 0, "Renamed meanwhile"));
    desk.open();
    READY(desk);
    QTRY_VERIFY(desk.list->drafts()->offered());
    QCOMPARE(desk.list->drafts()->offered()->changes, 1);
    QVERIFY(!desk.list->unsaved());
    desk.list->restoreDraft(QStringLiteral("draft"));
    QVERIFY(!desk.list->drafts()->offered());
    QCOMPARE(desk.document().find("a")->position_m.x(), 1.0);
    QCOMPARE(desk.document().find("a")->name, std::string("Renamed meanwhile"));
    QSignalSpy saved(desk.list.get(), &OpenWaypoints::saved);
    desk.list->save();
    QTRY_COMPARE(saved.size(), 1);
    QVERIFY(!desk.list->drafts()->keep());
    desk.open();
    READY(desk);
    QVERIFY(QDir(desk.folder.path()).entryList({QStringLiteral("*.json")}).isEmpty());
  }

  void aDraftThatIsTurnedDownOrDiscardedIsGone() {
    Desk desk(Mode::AllAtOnce);
    READY(desk);
    desk.move("a", 1);
    QVERIFY(!desk.list->drafts()->keep());
    QCOMPARE(QDir(desk.folder.path()).entryList({QStringLiteral("*.json")}).size(), 1);
    desk.list->discard();
    QVERIFY(!desk.list->unsaved());
    QVERIFY(QDir(desk.folder.path()).entryList({QStringLiteral("*.json")}).isEmpty());
    desk.move("a", 2);
    desk.list.reset();
    desk.open();
    QTRY_VERIFY(desk.list->drafts()->offered());
    desk.list->drafts()->turnDown();
    QVERIFY(QDir(desk.folder.path()).entryList({QStringLiteral("*.json")}).isEmpty());
    QVERIFY(!desk.list->unsaved());
  }

  void aDraftThatWasSavedAllTheSameIsNotOffered() {
    Desk desk(Mode::AllAtOnce);
    READY(desk);
    desk.move("a", 1);
    desk.list.reset();
    desk.store.put(waypoint("a", 1, 0, "A"));
    desk.open();
    READY(desk);
    QTRY_VERIFY(QDir(desk.folder.path()).entryList({QStringLiteral("*.json")}).isEmpty());
    QVERIFY(!desk.list->drafts()->offered());
  }

  void aBrokenDraftIsSetAsideAndSaid() {
    Desk desk(Mode::AllAtOnce);
    READY(desk);
    desk.move("a", 1);
    desk.list.reset();
    const QString name = QDir(desk.folder.path()).entryList({QStringLiteral("*.json")}).front();
    QFile file(desk.folder.filePath(name));
    QVERIFY(file.resize(file.size() / 2));
    desk.open();
    QSignalSpy remarked(desk.list.get(), &OpenWaypoints::remarked);
    QTRY_COMPARE(remarked.size(), 1);
    QVERIFY(QFile::exists(file.fileName() + QStringLiteral(".broken")));
    QVERIFY(!desk.list->drafts()->offered());
  }
};

}  // namespace test_open_waypoints

MAPWRIGHT_TEST(test_open_waypoints, TestOpenWaypoints, Core)
#include "test_open_waypoints.moc"
