// Whether the robot is in a map.
#include <QTest>

#include "map/whereabouts.h"
#include "test_program.h"

namespace test_whereabouts {

using namespace mapwright::map;

namespace {

CatalogueEntry row(const char* id, const char* uid, const char* name, bool current = false,
                   MapKind kind = MapKind::Stored) {
  CatalogueEntry entry;
  entry.key = {kind, id};
  entry.uid = uid;
  entry.name = name;
  entry.is_current = current;
  return entry;
}

LiveState saying(const char* uid, const char* name) {
  MapInfo info;
  info.uid = uid;
  info.name = name;
  return reduce({}, info, 1);
}

LiveState mapping(LiveState live) {
  SlamStatus slam;
  slam.state = "slam";
  return reduce(std::move(live), slam, 1);
}

const MapKey kGround{MapKind::Stored, "1"}, kAttic{MapKind::Stored, "2"};

}  // namespace

class WhereaboutsTest : public QObject {
  Q_OBJECT
  const std::vector<CatalogueEntry> marked{row("1", "u1", "Floor", true), row("2", "u2", "Attic")};
  const std::vector<CatalogueEntry> unmarked{row("1", "u1", "Floor"), row("2", "u2", "Attic")};
  const std::vector<CatalogueEntry> without_uids{row("1", "", "Floor", true), row("2", "", "Floor")};

 private Q_SLOTS:
  void whatTheRobotSendsItIsIn() {
    QCOMPARE(whereabouts({MapKind::Live, {}}, "x", saying("u1", "Floor"), marked, true), Whereabouts::Here);
  }

  void theRobotsOwnWordGoesBeforeTheCatalogue() {
    // It changed its map; the list is from before.
    const LiveState live = saying("u2", "Attic");
    QCOMPARE(whereabouts(kGround, {}, live, marked, false), Whereabouts::Elsewhere);
    QCOMPARE(whereabouts(kAttic, {}, live, marked, false), Whereabouts::Here);
  }

  void aRobotThatSendsNothingAboutItsMapIsWhereTheCatalogueSays() {
    QCOMPARE(whereabouts(kGround, {}, {}, marked, false), Whereabouts::Here);
    QCOMPARE(whereabouts(kAttic, {}, {}, marked, false), Whereabouts::Elsewhere);
  }

  void aRobotThatTellsNeitherCanBeAnywhere() {
    QCOMPARE(whereabouts(kGround, {}, {}, unmarked, false), Whereabouts::Unknown);
    QCOMPARE(whereabouts(kGround, {}, {}, {}, false), Whereabouts::Unknown);
    QCOMPARE(whereabouts(kGround, {}, saying("", ""), unmarked, false), Whereabouts::Unknown);
    QCOMPARE(whereabouts(kGround, {}, saying("", ""), marked, false), Whereabouts::Here);
  }

  void namesAreOnlyTheLastResort() {
    // Two maps are called the same: the mark tells them apart.
    QCOMPARE(whereabouts(kGround, {}, saying("", "Floor"), without_uids, false), Whereabouts::Here);
    QCOMPARE(whereabouts(kAttic, {}, saying("", "Floor"), without_uids, false), Whereabouts::Elsewhere);
    QCOMPARE(whereabouts(kGround, {}, saying("", "Floor"), unmarked, false), Whereabouts::Here);
    QCOMPARE(whereabouts(kAttic, {}, saying("", "Floor"), unmarked, false), Whereabouts::Elsewhere);
    auto twins = without_uids;
    twins[0].is_current = false;
    QCOMPARE(whereabouts(kGround, {}, saying("", "Floor"), twins, false), Whereabouts::Unknown);
    QCOMPARE(whereabouts(kGround, "Floor", saying("u9", "Floor"), {}, false), Whereabouts::Here);
  }

  void aMapWithoutAnIdInTheListIsElsewhereWhenAnotherOneHasIt() {
    QCOMPARE(whereabouts({MapKind::Mapping, "7"}, {}, saying("u1", "Floor"), unmarked, false),
             Whereabouts::Elsewhere);
  }

  void whoMapsAfreshIsInNoStoredMap() {
    const LiveState live = mapping(saying("u1", "Floor"));
    QVERIFY(mapsAfresh(live, false));
    QVERIFY(!mapsAfresh(live, true));          // it carries on a stored map
    QVERIFY(!mapsAfresh(live, std::nullopt));  // nobody knows yet
    QVERIFY(!mapsAfresh(saying("u1", "Floor"), false));
    QCOMPARE(whereabouts(kGround, {}, live, marked, true), Whereabouts::Elsewhere);
    QCOMPARE(whereabouts(kGround, {}, live, marked, false), Whereabouts::Here);
  }

  void whoMapsIsInTheMappingThatRuns() {
    auto rows = marked;
    rows.push_back(row("7", "", "Survey", false, MapKind::Mapping));
    rows.push_back(row("8", "", "Survey", false, MapKind::Mapping));
    rows[2].state = "running";
    rows[3].state = "finished";
    const LiveState live = mapping({});
    QCOMPARE(whereabouts(rows[2].key, {}, live, rows, true), Whereabouts::Here);
    QCOMPARE(whereabouts(rows[3].key, {}, live, rows, true), Whereabouts::Elsewhere);
  }

  void aFileMayBeAnything() {
    QCOMPARE(whereabouts({MapKind::File, {}}, "Floor", saying("u1", "Floor"), marked, false),
             Whereabouts::Here);
    QCOMPARE(whereabouts({MapKind::File, {}}, "office", saying("u1", "Floor"), marked, false),
             Whereabouts::Unknown);
  }

  void theCurrentMapHasTheNameThatIsKnown() {
    QCOMPARE(currentMapName(saying("u2", "Attic"), marked), std::string("Attic"));
    QCOMPARE(currentMapName({}, marked), std::string("Floor"));
    QCOMPARE(currentMapName({}, unmarked), std::string());
  }
};

}  // namespace test_whereabouts

MAPWRIGHT_TEST(test_whereabouts, WhereaboutsTest, Nothing)
#include "test_whereabouts.moc"
