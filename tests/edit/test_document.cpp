// Documents: undo and redo, gestures, states, and the three-way merge.
#include <cmath>

#include <QSignalSpy>
#include <QtTest>

#include "edit/document.h"
#include "test_program.h"

namespace test_document {

using namespace mapwright;
using namespace mapwright::edit;
using map::Waypoint;

namespace {

Waypoint point(const std::string& id, double x = 0, double y = 0, const std::string& name = "P") {
  Waypoint made;
  made.id = id;
  made.name = name;
  made.position_m = {x, y};
  return made;
}

Items items(std::initializer_list<Waypoint> points) {
  Items made;
  for (const Waypoint& one : points) made.emplace(one.id, one);
  return made;
}

Waypoint moved(Waypoint from, double x) {
  from.position_m.x() = x;
  return from;
}
Waypoint renamed(Waypoint from, const std::string& name) {
  from.name = name;
  return from;
}

struct Desk {
  Desk() { document.reset(items({point("a"), point("b", 5)})); }
  void set(const Waypoint& to, Gesture gesture = 0) {
    document.change({document.to(to.id, to)}, QStringLiteral("change"), gesture);
  }
  void remove(const Key& key) { document.change({document.to(key, std::nullopt)}, QStringLiteral("delete")); }
  const Waypoint& at(const Key& key) const { return *document.find(key); }
  WaypointDocument document;
};

}  // namespace

class TestDocument : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void changesStandInTheOrderInWhichTheyWereMade() {
    Desk desk;
    for (const char* id : {"z", "m", "b2"}) desk.set(point(id));
    desk.set(moved(point("b", 5), 6));
    desk.remove("a");
    desk.set(moved(point("m"), 1));  // once more: it stays where it was
    const auto keys = [&] {
      std::string line;
      for (const auto& change : desk.document.changes()) line += change.key + ' ';
      return line;
    };
    QCOMPARE(keys(), std::string("z m b2 b a "));
    desk.document.mergeStored(items({point("a"), point("b", 5), point("q")}));
    QCOMPARE(keys(), std::string("z m b2 b a "));
    desk.document.confirm({{"m", std::nullopt, moved(point("m"), 1)}});
    QCOMPARE(keys(), std::string("z b2 b a "));
  }

  void whatIsChangedIsMadeSuchThatItCanBeKept() {
    Desk desk;
    desk.document.setFit(
        [](Waypoint& one, const Waypoint*) { fit(one, {.type = false, .no_heading = false}); });
    Waypoint made = point("c", 1);
    made.type = "shelf";
    desk.set(made);
    QCOMPARE(desk.at("c").type, std::string());
    QCOMPARE(desk.at("c").yaw_rad, std::optional(0.0));
    made.id = "d";
    desk.document.rebase({{"d", std::nullopt, made}}, QStringLiteral("take up"));
    QCOMPARE(desk.at("d").type, std::string());
    QCOMPARE(desk.at("d").yaw_rad, std::optional(0.0));
    // What somebody else keeps there comes as it is.
    desk.document.mergeStored(items({point("a"), point("b", 5), point("e")}));
    QVERIFY(!desk.at("e").yaw_rad);
  }

  void aNameThatAnotherOneHasIsRefused() {
    const robot::KeptFields one_of_each{.name_twice = false};
    const Items kept =
        items({point("a", 0, 0, "A"), point("b", 0, 0, "B"), point("c", 0, 0, "C"), point("d", 0, 0, "C")});
    const auto to = [&](const Key& key, const std::string& name) {
      const bool there = kept.contains(key);
      return Change{key, there ? std::optional(kept.at(key)) : std::nullopt, point(key, 0, 0, name)};
    };
    const auto refused = [&](const std::vector<Change>& changes) {
      return refusedNames(kept, changes, one_of_each);
    };
    QCOMPARE(refused({to("n", "N")}), (std::set<Key>{}));
    QCOMPARE(refused({to("n", "A")}), (std::set<Key>{"n"}));
    QCOMPARE(refused({to("a", "B"), to("b", "A")}), (std::set<Key>{}));  // they change places
    QCOMPARE(refused({to("n", "A"), {"a", kept.at("a"), std::nullopt}}), (std::set<Key>{}));
    QCOMPARE(refused({to("n", "N"), to("m", "N")}), (std::set<Key>{"m", "n"}));
    // Who waits for a name that is not let go of is refused, too.
    QCOMPARE(refused({to("a", "C"), to("b", "A")}), (std::set<Key>{"a", "b"}));
    // Whoever leaves a name alone is not asked, be it twice there.
    QCOMPARE(refused({{"c", kept.at("c"), moved(kept.at("c"), 1)}}), (std::set<Key>{}));
    QVERIFY(refusedNames(kept, {to("n", "A")}, {}).empty());
  }

  void undoAndRedoExchangeValues() {
    Desk desk;
    desk.set(moved(point("a"), 3));
    desk.remove("b");
    desk.set(point("c", 9));
    QCOMPARE(desk.document.items().size(), std::size_t(2));
    for (int i = 0; i < 3; ++i) desk.document.undoStack().undo();
    QVERIFY(desk.document.items() == items({point("a"), point("b", 5)}));
    QVERIFY(desk.document.unsaved().empty());
    for (int i = 0; i < 3; ++i) desk.document.undoStack().redo();
    QVERIFY(desk.document.items() == items({moved(point("a"), 3), point("c", 9)}));
    QCOMPARE(desk.document.unsaved(), (std::set<Key>{"a", "b", "c"}));
  }

  void movesOfOneGestureAreOneCommand() {
    Desk desk;
    for (int x = 1; x <= 5; ++x) desk.set(moved(point("a"), x), 7);
    QCOMPARE(desk.document.undoStack().count(), 1);
    desk.set(moved(point("a"), 6), 8);
    QCOMPARE(desk.document.undoStack().count(), 2);
    desk.document.undoStack().undo();
    QCOMPARE(desk.at("a").position_m.x(), 5.0);
    desk.document.undoStack().undo();
    QCOMPARE(desk.at("a").position_m.x(), 0.0);
  }

  void aCommandThatEndsWhereItBeganVanishes() {
    Desk desk;
    desk.set(moved(point("a"), 1), 7);
    desk.set(point("a"), 7);
    QCOMPARE(desk.document.undoStack().count(), 0);
    desk.set(point("a"));
    QCOMPARE(desk.document.undoStack().count(), 0);
    QVERIFY(!desk.document.undoStack().canUndo());
  }

  void oneSignalTellsWhatChanged() {
    Desk desk;
    std::vector<DocumentChange> told;
    connect(&desk.document, &WaypointDocument::changed, this,
            [&](const DocumentChange& change) { told.push_back(change); });
    desk.document.change({desk.document.to("a", moved(point("a"), 3)), desk.document.to("b", std::nullopt),
                          desk.document.to("c", point("c"))},
                         QStringLiteral("much"));
    QCOMPARE(told.size(), std::size_t(1));
    QCOMPARE(told[0].changed, std::vector<Key>{"a"});
    QCOMPARE(told[0].removed, std::vector<Key>{"b"});
    QCOMPARE(told[0].added, std::vector<Key>{"c"});
    desk.document.reset({});
    QVERIFY(told.back().everything);
  }

  void statesTellUnsavedSentAndConfirmed() {
    Desk desk;
    desk.set(moved(point("a"), 3));
    QCOMPARE(desk.document.state("a"), (ItemState{true, false, false}));
    const auto changes = desk.document.changes();
    QCOMPARE(changes.size(), std::size_t(1));
    QVERIFY(same(changes[0].before, std::optional(point("a"))));
    desk.document.markSent(changes);
    QCOMPARE(desk.document.state("a"), (ItemState{true, true, false}));
    desk.document.confirm(changes);
    QCOMPARE(desk.document.state("a"), ItemState{});
    desk.document.undoStack().undo();
    QCOMPARE(desk.document.state("a"), (ItemState{true, false, false}));  // saved is something else now
  }

  void whatIsEditedWhileItIsSentStaysUnsaved() {
    Desk desk;
    desk.set(moved(point("a"), 3));
    desk.document.markSent(desk.document.changes());
    desk.set(moved(point("a"), 4));
    desk.document.endSending();  // whether it arrived is not known …
    desk.document.mergeStored(items({moved(point("a"), 3), point("b", 5)}));  // … it did
    QVERIFY(desk.document.conflicts().empty());
    QCOMPARE(desk.at("a").position_m.x(), 4.0);
    QCOMPARE(desk.document.state("a"), (ItemState{true, false, false}));
  }

  void aCreatedOneWhoseAnswerWasLostIsToldByWhatItIsLike() {
    Desk desk;
    desk.set(point("mine", 7, 7, "Dock"));
    desk.document.markSent(desk.document.changes());
    desk.document.endSending();
    desk.document.mergeStored(items({point("a"), point("b", 5), point("41", 7, 7, "Dock")}));
    QCOMPARE(desk.document.items().size(), std::size_t(3));
    QVERIFY(desk.document.unsaved().empty());
    QCOMPARE(desk.document.theirName("mine"), Key("41"));
    desk.remove("mine");
    desk.document.mergeStored(items({point("a"), point("b", 5), point("41", 7, 7, "Dock")}));
    QCOMPARE(desk.document.items().size(), std::size_t(2));  // not back under its other name
  }

  void aRobotThatWasSlowMayCarryItOutAfterItWasRead() {
    Desk desk;
    desk.set(point("mine", 7, 7, "Dock"));
    desk.set(renamed(point("a"), "Gate"));
    desk.document.markSent(desk.document.changes());
    desk.document.endSending();
    desk.document.mergeStored(items({point("a"), point("b", 5)}));
    QCOMPARE(desk.document.unsaved(), (std::set<Key>{"a", "mine"}));
    desk.set(renamed(point("a"), "Gate 2"));
    desk.document.mergeStored(items({renamed(point("a"), "Gate"), point("b", 5), point("41", 7, 7, "Dock")}));
    QCOMPARE(desk.document.items().size(), std::size_t(3));
    QVERIFY(desk.document.conflicts().empty());
    QCOMPARE(desk.document.unsaved(), std::set<Key>{"a"});
    QCOMPARE(desk.at("a").name, std::string("Gate 2"));
  }

  void theirChangesComeInWhereIMadeNone() {
    Desk desk;
    desk.set(moved(point("a"), 3));
    desk.document.mergeStored(items({point("a"), moved(point("b"), 8), point("c")}));
    QCOMPARE(desk.at("b").position_m.x(), 8.0);
    QVERIFY(desk.document.find("c"));
    QCOMPARE(desk.document.unsaved(), std::set<Key>{"a"});
    desk.document.mergeStored(items({point("a"), point("c")}));
    QVERIFY(!desk.document.find("b"));
    QVERIFY(desk.document.conflicts().empty());
  }

  void myRenameAndTheirMoveGoTogether() {
    Desk desk;
    desk.set(renamed(point("a"), "Dock"));
    desk.document.mergeStored(items({moved(point("a"), 8), point("b", 5)}));
    QVERIFY(desk.document.conflicts().empty());
    QCOMPARE(desk.at("a").name, std::string("Dock"));
    QCOMPARE(desk.at("a").position_m.x(), 8.0);
    QVERIFY(desk.document.state("a").unsaved);
    // Undoing my rename keeps their move.
    desk.document.undoStack().undo();
    QCOMPARE(desk.at("a").name, std::string("P"));
    QCOMPARE(desk.at("a").position_m.x(), 8.0);
    QVERIFY(desk.document.unsaved().empty());
  }

  void conflictsAreValues_data() {
    QTest::addColumn<bool>("base_there");
    QTest::addColumn<double>("mine");    // 0 = deleted
    QTest::addColumn<double>("theirs");  // likewise
    QTest::addColumn<int>("kind");
    QTest::newRow("both changed") << true << 3.0 << 4.0 << int(ConflictKind::BothChanged);
    QTest::newRow("deleted here") << true << 0.0 << 4.0 << int(ConflictKind::DeletedHere);
    QTest::newRow("deleted there") << true << 3.0 << 0.0 << int(ConflictKind::DeletedThere);
    QTest::newRow("both added") << false << 3.0 << 4.0 << int(ConflictKind::BothAdded);
  }
  void conflictsAreValues() {
    QFETCH(bool, base_there);
    QFETCH(double, mine);
    QFETCH(double, theirs);
    QFETCH(int, kind);
    const auto there = [](double x) { return x == 0 ? std::nullopt : std::optional(point("x", x)); };
    const auto merged =
        merge(base_there ? std::optional(point("x", 9)) : std::nullopt, there(mine), there(theirs));
    QVERIFY(merged.conflict);
    QCOMPARE(int(merged.conflict->kind), kind);
    QVERIFY(same(decided(*merged.conflict, Side::Mine), there(mine)));
    QVERIFY(same(decided(*merged.conflict, Side::Theirs), there(theirs)));
  }

  void bothDoingTheSameIsNoConflict() {
    const std::optional<Waypoint> base = point("x"), moved_there = point("x", 3), none;
    QVERIFY(!merge(base, moved_there, moved_there).conflict);
    QVERIFY(!merge(base, none, none).conflict);
    QVERIFY(!merge(none, moved_there, moved_there).conflict);
  }

  void whatDoesNotCollideIsMergedInAConflictToo() {
    Desk desk;
    Waypoint mine = renamed(moved(point("a"), 3), "Mine");
    Waypoint theirs = moved(point("a"), 4);
    theirs.tags = {"dock"};
    desk.set(mine);
    desk.document.mergeStored(items({theirs, point("b", 5)}));
    QCOMPARE(desk.document.conflicts().at("a").fields, waypoint_field::kPosition);
    QVERIFY(desk.document.state("a").changed_elsewhere);
    QVERIFY(desk.document.changes().empty());  // nothing is sent before it is decided
    desk.document.decide("a", Side::Theirs, QStringLiteral("theirs"));
    QCOMPARE(desk.at("a").position_m.x(), 4.0);
    QCOMPARE(desk.at("a").name, std::string("Mine"));
    QCOMPARE(desk.at("a").tags, std::vector<std::string>{"dock"});
    QCOMPARE(desk.document.state("a"), (ItemState{true, false, false}));
  }

  void myVersionCanBeKept() {
    Desk desk;
    desk.set(moved(point("a"), 3));
    desk.document.mergeStored(items({moved(point("a"), 4), point("b", 5)}));
    desk.document.decide("a", Side::Mine, QStringLiteral("mine"));
    QCOMPARE(desk.at("a").position_m.x(), 3.0);
    const auto changes = desk.document.changes();
    QCOMPARE(changes.size(), std::size_t(1));
    QCOMPARE(changes[0].before->position_m.x(), 4.0);  // their version is what mine replaces
  }

  void takingTheirsCanBeUndone() {
    Desk desk;
    desk.set(moved(point("a"), 3));
    desk.document.mergeStored(items({point("b", 5)}));
    QCOMPARE(int(desk.document.conflicts().at("a").kind), int(ConflictKind::DeletedThere));
    desk.document.decide("a", Side::Theirs, QStringLiteral("theirs"));
    QVERIFY(!desk.document.find("a"));
    QVERIFY(desk.document.unsaved().empty());
    desk.document.undoStack().undo();
    QCOMPARE(desk.at("a").position_m.x(), 3.0);
    QVERIFY(desk.document.state("a").unsaved);
  }

  void aConflictEndsByHandToo() {
    Desk desk;
    desk.set(moved(point("a"), 3));
    desk.document.mergeStored(items({moved(point("a"), 4), point("b", 5)}));
    desk.set(moved(point("a"), 4));
    QVERIFY(desk.document.conflicts().empty());
    QVERIFY(desk.document.unsaved().empty());
  }

  void whatTheStoreKeepsBesideFollowsTheStore() {
    Desk desk;
    desk.set(renamed(point("a"), "Dock"));
    Waypoint theirs = point("a");
    theirs.source = "{\"height\": 3}";
    desk.document.mergeStored(items({theirs, point("b", 5)}));
    QCOMPARE(desk.at("a").source, theirs.source);
    QCOMPARE(desk.at("a").name, std::string("Dock"));
  }

  void olderChangesAreMadeAgain() {
    Desk desk;
    desk.document.reset(items({moved(point("a"), 8), point("b", 5)}));
    desk.document.rebase({{"a", point("a"), renamed(point("a"), "Dock")},
                          {"b", point("b", 4), point("b", 6)},
                          {"c", std::nullopt, point("c")}},
                         QStringLiteral("draft"));
    QCOMPARE(desk.at("a").name, std::string("Dock"));
    QCOMPARE(desk.at("a").position_m.x(), 8.0);
    QVERIFY(desk.document.find("c"));
    QCOMPARE(desk.document.conflicts().size(), std::size_t(1));
    QCOMPARE(desk.document.conflicts().at("b").theirs->position_m.x(), 5.0);
    QCOMPARE(desk.document.undoStack().count(), 1);
    desk.document.undoStack().undo();
    QVERIFY(desk.document.unsaved().empty());
    QVERIFY(desk.document.conflicts().empty());
  }

  // Numbers that went to a robot or into a file come back a little different.
  void whatDiffersByRoundingIsTheSame() {
    Waypoint sent = point("a", 1.5, -2);
    sent.yaw_rad = 0.5;
    Waypoint came = sent;
    came.yaw_rad = 0.5000000000000001;
    came.position_m.x() = std::nextafter(1.5, 2);
    QCOMPARE(difference(sent, came), FieldMask(0));
    Waypoint turned = sent;
    turned.yaw_rad = 0.501;
    QCOMPARE(difference(sent, turned), waypoint_field::kYaw);
    Waypoint whole_turn = sent, none = sent;
    sent.yaw_rad = std::acos(-1);
    whole_turn.yaw_rad = -std::acos(-1);
    QCOMPARE(difference(sent, whole_turn), FieldMask(0));
    none.yaw_rad.reset();
    QCOMPARE(difference(sent, none), waypoint_field::kYaw);
  }

  // Both made the same of it, and it was rounded on the way: nothing collides, whoever rounded it.
  void whatWasRoundedOnTheWayIsNoConflict() {
    Waypoint base = point("a", 1, 1), mine = base;
    base.yaw_rad = 0;
    mine.position_m = {2, 2};
    mine.yaw_rad = 0.5;
    Waypoint theirs = mine;
    theirs.yaw_rad = 0.5000000000000001;
    theirs.position_m.y() = std::nextafter(2, 3);
    QVERIFY(!merge(base, mine, theirs).conflict);
    Waypoint named = theirs;
    named.name = "theirs";
    const auto merged = merge(base, mine, named);
    QVERIFY(!merged.conflict);
    QCOMPARE(merged.item->name, std::string("theirs"));
    Waypoint rounded = base;
    rounded.yaw_rad = 1e-16;
    const auto kept = merge(base, mine, rounded);
    QVERIFY(!kept.conflict);
    QCOMPARE(*kept.item->yaw_rad, 0.5);
  }

  void whatIsSavedAndComesBackRoundedIsSaved() {
    Desk desk;
    Waypoint turned = point("a");
    turned.yaw_rad = 0.5;
    desk.set(turned);
    desk.document.markSent(desk.document.changes());
    turned.yaw_rad = 0.5000000000000001;
    desk.document.mergeStored(items({turned, point("b", 5)}));
    QVERIFY(desk.document.unsaved().empty() && desk.document.conflicts().empty());
    QCOMPARE(desk.document.sent(), std::size_t(0));
  }

  // Of a swap of names that broke off: what I put there is not theirs.
  void aTemporaryNameOfMineIsNoConflict() {
    const Waypoint base = point("a", 0, 0, "alfa"), mine = renamed(base, "bravo");
    Waypoint theirs = moved(renamed(base, "alfa ~1"), 3);
    const auto merged = merge(base, mine, theirs);
    QVERIFY(!merged.conflict);
    QCOMPARE(merged.item->name, std::string("bravo"));
    QCOMPARE(merged.item->position_m.x(), 3.0);
    // Who does not rename it lets it be, and what others call it is still theirs.
    QCOMPARE(merge(base, moved(base, 5), renamed(base, "alfa ~1")).item->name, std::string("alfa ~1"));
    QVERIFY(merge(base, mine, renamed(base, "golf")).conflict);
    QVERIFY(merge(base, mine, renamed(base, "bravo ~1")).conflict);
  }
};

}  // namespace test_document

MAPWRIGHT_TEST(test_document, TestDocument, Core)
#include "test_document.moc"
