// Names for many waypoints: numbers as they were typed, taken ones left out, collisions found beforehand.
#include <QtTest>

#include "exchange/waypoint_names.h"
#include "test_program.h"

namespace test_waypoint_names {

using namespace mapwright::exchange;

namespace {

QStringList words(const char* text) { return QString::fromUtf8(text).split(QLatin1Char('|')); }

QStringList after(const std::vector<NewName>& names) {
  QStringList texts;
  for (const NewName& one : names) texts << one.after;
  return texts;
}

Renaming pattern(const char* text, int first = 1, int step = 1) {
  return {.pattern = QString::fromUtf8(text), .first = first, .step = step};
}

}  // namespace

class TestWaypointNames : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aSeriesHasDigitsAsTyped() {
    QCOMPARE(namesOf({QStringLiteral("Corr "), QStringLiteral("1")}, 3, {}).names,
             words("Corr 1|Corr 2|Corr 3"));
    QCOMPARE(namesOf({QStringLiteral("Corr "), QStringLiteral("08")}, 3, {}).names,
             words("Corr 08|Corr 09|Corr 10"));
    QCOMPARE(namesOf({QStringLiteral("A-"), QStringLiteral("098"), 2}, 3, {}).names,
             words("A-098|A-100|A-102"));
    QCOMPARE(namesOf({QStringLiteral("R"), QStringLiteral("2"), -1}, 4, {}).names, words("R2|R1|R0|R-1"));
    QCOMPARE(namesOf({{}, QStringLiteral("7")}, 2, {}).names, words("7|8"));
  }

  void whatIsTakenIsLeftOutAndTold() {
    const SeriesNames made =
        namesOf({QStringLiteral("Corr "), QStringLiteral("1")}, 3, {"Corr 2", "Corr 3", "corr 1"});
    QCOMPARE(made.names, words("Corr 1|Corr 4|Corr 5"));
    QCOMPARE(made.skipped, words("Corr 2|Corr 3"));
  }

  void withoutANumberItGoesOnAfterTheHighest() {
    const TakenNames taken{"Corr 7", "Corr 12", "Corr 3b", "Corr", "Corridor 99", "Dock 007", "Rack 5"};
    QCOMPARE(nextNumber(QStringLiteral("Corr "), taken), QStringLiteral("13"));
    QCOMPARE(nextNumber(QStringLiteral("Dock "), taken), QStringLiteral("008"));
    QCOMPARE(nextNumber(QStringLiteral("New "), taken), QStringLiteral("1"));
    QCOMPARE(namesOf({QStringLiteral("Dock ")}, 2, taken).names, words("Dock 008|Dock 009"));
    QVERIFY(namesOf({QStringLiteral("Corr ")}, 2, taken).skipped.isEmpty());
  }

  void whatIsNoNumberMakesNoNames() {
    QVERIFY(namesOf({QStringLiteral("Corr "), QStringLiteral("x")}, 3, {}).names.isEmpty());
    QVERIFY(namesOf({QStringLiteral("Corr "), QStringLiteral("1"), 0}, 3, {}).names.isEmpty());
    QCOMPARE(namesOf({QStringLiteral("L"), QString(400, QLatin1Char('9'))}, 1, {}).names.size(), 1);
  }

  void aPatternCounts() {
    const QStringList names = words("Dock|Gate|Lift");
    QCOMPARE(after(renamed(names, pattern("Corr #"), {})), words("Corr 1|Corr 2|Corr 3"));
    QCOMPARE(after(renamed(names, pattern("C## west", 9, 2), {})), words("C09 west|C11 west|C13 west"));
    QCOMPARE(after(renamed(names, pattern("Corr", 8), {})), words("Corr 8|Corr 9|Corr 10"));
    QCOMPARE(after(renamed(names, pattern("Floor 2, *"), {})),
             words("Floor 2, Dock|Floor 2, Gate|Floor 2, Lift"));
    QCOMPARE(after(renamed(names, pattern("  "), {})), names);  // nothing typed yet
  }

  void namesAreTextWhateverIsInThem() {
    QCOMPARE(after(renamed(words("<b>&amp;</b> 😀|a*b"), pattern("* #"), {})),
             words("<b>&amp;</b> 😀 1|a*b 2"));
  }

  void aPartIsReplaced() {
    Renaming renaming{
        .how = Renaming::How::Replace, .find = QStringLiteral("corr"), .replacement = QStringLiteral("Hall")};
    QCOMPARE(after(renamed(words("Corr 1|Dock|CORR corr"), renaming, {})), words("Hall 1|Dock|Hall Hall"));
    renaming.match_case = true;
    QCOMPARE(after(renamed(words("Corr 1|corr 2"), renaming, {})), words("Corr 1|Hall 2"));
    renaming.find.clear();
    QCOMPARE(after(renamed(words("Corr 1"), renaming, {})), words("Corr 1"));
  }

  void collisionsAreFoundBeforehand() {
    const auto taken = renamed(words("a|b"), pattern("Corr #"), {"Corr 2"});
    QVERIFY(taken[0].trouble == NameTrouble::None && taken[1].trouble == NameTrouble::Taken);
    Renaming same{
        .how = Renaming::How::Replace, .find = QStringLiteral("2"), .replacement = QStringLiteral("1")};
    // The one that keeps its name is not at fault.
    const auto twice = renamed(words("Rack 1|Rack 2"), same, {});
    QVERIFY(twice[0].trouble == NameTrouble::None && twice[1].trouble == NameTrouble::Twice);
    same.find = QStringLiteral("Rack 2");
    same.replacement.clear();
    QVERIFY(renamed(words("Rack 2"), same, {})[0].trouble == NameTrouble::Empty);
    // All move up by one: the names that are free then are no trouble.
    for (const NewName& one : renamed(words("R 1|R 2|R 3"), pattern("R #", 2), {}))
      QVERIFY(one.trouble == NameTrouble::None);
  }
};

}  // namespace test_waypoint_names

MAPWRIGHT_TEST(test_waypoint_names, TestWaypointNames, Core)
#include "test_waypoint_names.moc"
