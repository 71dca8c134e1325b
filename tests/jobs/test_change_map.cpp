// What is checked before a map of the robot is changed, and afterwards.
#include <QtTest>

#include "jobs/change_map.h"
#include "test_program.h"

namespace test_change_map {

using namespace mapwright;
using robot::MapChange;

class TestChangeMap : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void namesAreOneLine() {
    QVERIFY(jobs::noMapNameReason(QStringLiteral("hall 2")).isEmpty());
    QVERIFY(jobs::noMapNameReason(QStringLiteral("  ")).contains(QStringLiteral("must have a name")));
    QVERIFY(jobs::noMapNameReason(QStringLiteral("a\nb")).contains(QStringLiteral("one line")));
    QVERIFY(jobs::noFilenameReason(QStringLiteral("office.png")).isEmpty());
    QVERIFY(!jobs::noFilenameReason(QString()).isEmpty());
    QVERIFY(!jobs::noFilenameReason(QStringLiteral("a\tb.png")).isEmpty());
    QVERIFY(!jobs::noFilenameReason(QString(4097, QLatin1Char('a'))).isEmpty());
  }

  void othersOfTheSameNameAreNamed() {
    const auto stored = [](const char* id, const char* name, map::MapKind kind = map::MapKind::Stored) {
      map::CatalogueEntry made;
      made.key = {kind, id};
      made.name = name;
      return made;
    };
    std::vector<map::CatalogueEntry> maps{stored("42", "Hall"), stored("7", "hall"),
                                          stored("9", "Hall", map::MapKind::Mapping)};
    const robot::MapOrder save{.change = MapChange::Save, .name = "Hall "};
    QCOMPARE(jobs::alsoCalledSo(save, maps), QStringLiteral("Another map has this name: id 42."));
    QVERIFY(jobs::alsoCalledSo({.change = MapChange::Rename, .key = maps[0].key, .name = "Hall"}, maps)
                .isEmpty());
    QVERIFY(jobs::alsoCalledSo({.change = MapChange::Save, .name = "Lobby"}, maps).isEmpty());
    maps.push_back(stored("43", "Hall"));
    QCOMPARE(jobs::alsoCalledSo(save, maps), QStringLiteral("Other maps have this name: ids 42, 43."));
    for (const char* id : {"44", "45", "46", "47"}) maps.push_back(stored(id, "Hall"));
    QCOMPARE(jobs::alsoCalledSo(save, maps),
             QStringLiteral("Other maps have this name: ids 42, 43, 44, 45, 46 and others."));
  }

  void anAnswerThatDoesNotFitIsTold() {
    map::CatalogueEntry now;
    now.name = "other";
    QVERIFY(
        jobs::oddity({.change = MapChange::Rename, .name = "wanted"}, now).contains(QStringLiteral("other")));
    QVERIFY(!jobs::oddity({.change = MapChange::Load}, now).isEmpty());
    QVERIFY(!jobs::oddity({.change = MapChange::Archive}, now).isEmpty());
    QVERIFY(jobs::oddity({.change = MapChange::Unarchive}, now).isEmpty());
    now.name = "wanted";
    now.is_current = now.is_archived = true;
    QVERIFY(jobs::oddity({.change = MapChange::Rename, .name = "wanted"}, now).isEmpty());
    QVERIFY(jobs::oddity({.change = MapChange::Load}, now).isEmpty());
    QVERIFY(jobs::oddity({.change = MapChange::Archive}, now).isEmpty());
    QVERIFY(!jobs::oddity({.change = MapChange::Unarchive}, now).isEmpty());
    QVERIFY(jobs::oddity({.change = MapChange::Delete}, now).isEmpty());
  }
};

}  // namespace test_change_map

MAPWRIGHT_TEST(test_change_map, TestChangeMap, Core)
#include "test_change_map.moc"
