// Two people edit the overlays of one map: what each did stays, and what both did differently is a conflict.
#include <QTest>

#include "overlays/overlay_merge.h"
#include "test_program.h"

namespace test_overlay_merge {

using namespace mapwright::overlays;

namespace {

OverlayDocument read(const std::string& features) {
  auto document = OverlayDocument::read(R"({"type":"FeatureCollection","features":[)" + features + "]}");
  if (!document) qFatal("no overlays: %s", features.c_str());
  return std::move(*document);
}

/// The features of a document, as written.
std::string featuresOf(const OverlayDocument& document) {
  std::string text;
  for (const Feature& feature : document.features()) text += (text.empty() ? "" : ",") + feature.text();
  return text;
}

std::string point(const char* id, const char* name, const char* at = "[1,2]") {
  return std::string(R"({"id":")") + id + R"(","geometry":{"type":"Point","coordinates":)" + at +
         R"(},"properties":{"name":")" + name + R"(","type":9}})";
}

std::string nameless(const char* type, const char* at, const char* id = "") {
  return "{" + (*id ? std::string(R"("id":)") + id + "," : std::string()) +
         R"("geometry":{"type":"LineString","coordinates":)" + at + R"(},"properties":{"lineType":)" + type +
         "}}";
}

}  // namespace

class OverlayMergeTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void anotherNotationOrOrderIsNoChange() {
    const OverlayDocument before = read(R"({"id":"a","properties":{"w":1.50,"name":"\u0041"}},{"id":"b"})");
    const OverlayDocument after = read(R"({"id":"b"},{"properties":{"name":"A","w":1.5},"id":"a"})");
    QVERIFY(changesBetween(before, after).empty());
  }

  void anIdInAnotherNotationIsTheSame() {
    QVERIFY(changesBetween(read(R"({"id":1})"), read(R"({"id":1.0})")).empty());
    QCOMPARE(changesBetween(read(R"({"id":1})"), read(R"({"id":2})")).size(), std::size_t(2));
  }

  void changesNameWhatTheyChange() {
    const OverlayDocument before = read(point("a", "A") + "," + point("b", "B") + "," + point("c", "C"));
    const OverlayDocument after =
        read(point("a", "A") + "," + point("b", "B2", "[3,4]") + "," + point("d", "D"));
    const auto changes = changesBetween(before, after);
    QCOMPARE(changes.size(), std::size_t(3));
    QVERIFY(changes[0].kind == ChangeKind::Change && changes[0].id == "b" && changes[0].name == "B2");
    QCOMPARE(changes[0].parts.size(), std::size_t(2));
    QCOMPARE(changes[0].parts[0].part.text(), std::string("geometry"));
    QCOMPARE(changes[0].parts[1].part.text(), std::string("properties.name"));
    QVERIFY(changes[1].kind == ChangeKind::Remove && changes[1].id == "c");
    QVERIFY(changes[2].kind == ChangeKind::Add && changes[2].id == "d");
  }

  void whatBothChangedIsBroughtTogether() {
    const OverlayDocument base = read(point("a", "A") + "," + point("b", "B") + "," + point("c", "C"));
    const OverlayDocument mine = read(point("a", "A1") + "," + point("b", "B") + "," + point("e", "E"));
    const OverlayDocument theirs = read(point("d", "D") + "," + point("a", "A", "[7,8.0]") + "," +
                                        point("b", "B9") + "," + point("c", "C"));
    const OverlayMerge merged = merge(base, mine, theirs);
    QVERIFY(merged.conflicts.empty());
    QCOMPARE(merged.mine.size(), std::size_t(3));
    QCOMPARE(merged.theirs.size(), std::size_t(3));
    QCOMPARE(featuresOf(merged.document), point("d", "D") + "," + point("a", "A1", "[7,8.0]") + "," +
                                              point("b", "B9") + "," + point("e", "E"));
  }

  void whatOnlyTheyChangedStaysToTheByte() {
    const OverlayDocument base = read(point("a", "A"));
    const OverlayDocument theirs = read(R"({ "id":"a" , "properties":{"name":"\u0042","w":1.50} })");
    const OverlayMerge merged = merge(base, base, theirs);
    QVERIFY(merged.mine.empty() && merged.conflicts.empty());
    QCOMPARE(merged.document.text(), theirs.text());
  }

  void theSamePartChangedDifferentlyIsAConflict() {
    const OverlayMerge merged =
        merge(read(point("a", "A")), read(point("a", "mine")), read(point("a", "theirs")));
    QCOMPARE(merged.conflicts.size(), std::size_t(1));
    const OverlayConflict& conflict = merged.conflicts.front();
    QCOMPARE(conflict.part.text(), std::string("properties.name"));
    QVERIFY(conflict.base == R"("A")" && conflict.mine == R"("mine")" && conflict.theirs == R"("theirs")");
    QCOMPARE(featuresOf(merged.document), point("a", "theirs"));
  }

  void theSameChangeIsNoConflict() {
    const std::string both = R"({"id":"a","properties":{"w":1.50}})";
    const OverlayMerge merged =
        merge(read(R"({"id":"a"})"), read(both), read(R"({"id":"a","properties":{"w":1.5}})"));
    QVERIFY(merged.conflicts.empty());
    QCOMPARE(featuresOf(merged.document), std::string(R"({"id":"a","properties":{"w":1.5}})"));
  }

  void removingWhatTheOtherChangedIsAConflictBothWays() {
    const OverlayDocument base = read(point("a", "A")), changed = read(point("a", "A1")), none = read("");
    const OverlayMerge removed = merge(base, none, changed);
    QCOMPARE(removed.conflicts.size(), std::size_t(1));
    QVERIFY(removed.conflicts[0].part.of == Part::Of::Whole && !removed.conflicts[0].mine);
    QCOMPARE(featuresOf(removed.document), point("a", "A1"));
    const OverlayMerge kept = merge(base, changed, none);
    QCOMPARE(kept.conflicts.size(), std::size_t(1));
    QVERIFY(!kept.conflicts[0].theirs);
    QVERIFY(merge(base, none, none).conflicts.empty());
  }

  void anAddedFeatureIsThereOnce() {
    const OverlayDocument base = read(""), added = read(point("a", "A"));
    QCOMPARE(featuresOf(merge(base, added, added).document), point("a", "A"));
    const OverlayMerge other = merge(base, added, read(point("a", "B")));
    QCOMPARE(other.conflicts.size(), std::size_t(1));
    QVERIFY(!other.conflicts[0].base);
  }

  void featuresWithoutIdsAreFoundByWhatTheyAre() {
    const std::string wall = nameless("2", "[[0,0],[1,0]]"), track = nameless("1", "[[5,5],[6,6]]");
    const OverlayDocument base = read(wall + "," + track);
    // The robot has given ids, in another order; I turned the wall into a guide line.
    const OverlayDocument theirs =
        read(nameless("1", "[[5,5],[6,6]]", "8") + "," + nameless("2", "[[0,0],[1,0]]", "9"));
    const OverlayDocument mine = read(nameless("3", "[[0,0],[1,0]]") + "," + track);
    const OverlayMerge merged = merge(base, mine, theirs);
    QVERIFY(merged.conflicts.empty());
    QCOMPARE(featuresOf(merged.document),
             nameless("1", "[[5,5],[6,6]]", "8") + "," + nameless("3", "[[0,0],[1,0]]", "9"));
    // Removing what the robot only gave an id to is no conflict.
    QCOMPARE(featuresOf(merge(base, read(track), theirs).document), nameless("1", "[[5,5],[6,6]]", "8"));
  }

  void equalFeaturesAndEqualIdsStayAsManyAsTheyAre() {
    const std::string wall = nameless("2", "[[0,0],[1,0]]");
    const OverlayDocument twice = read(wall + "," + wall);
    QCOMPARE(changesBetween(twice, read(wall)).size(), std::size_t(1));
    QCOMPARE(featuresOf(merge(twice, read(wall), twice).document), wall);
    const OverlayDocument same_id = read(point("a", "A") + "," + point("a", "B"));
    QVERIFY(changesBetween(same_id, same_id).empty());
    QCOMPARE(featuresOf(merge(same_id, read(point("a", "B")), same_id).document), point("a", "B"));
  }

  void membersOfTheCollectionAreMergedToo() {
    const auto collection = [](const std::string& properties) {
      return *OverlayDocument::read(R"({"type":"FeatureCollection","features":[null],"properties":)" +
                                    properties + "}");
    };
    const OverlayMerge merged =
        merge(collection(R"({"rack":1,"pallet":1})"), collection(R"({"rack":2,"pallet":1})"),
              collection(R"({"rack":1, "pallet":1.50})"));
    QVERIFY(merged.conflicts.empty());
    QCOMPARE(merged.document.text(),
             std::string(
                 R"({"type":"FeatureCollection","features":[null],"properties":{"rack":2, "pallet":1.50}})"));
    const OverlayMerge clash =
        merge(collection(R"({"rack":1})"), collection(R"({"rack":2})"), collection("null"));
    QCOMPARE(clash.conflicts.size(), std::size_t(1));
    QCOMPARE(clash.document.text(), collection("null").text());
  }

  void tenThousandFeaturesAreMerged() {
    std::string base, mine, theirs;
    for (int i = 0; i < 10'000; ++i) {
      const std::string id = std::to_string(i);
      base += (i ? "," : "") + point(id.c_str(), "A");
      mine += (i ? "," : "") + point(id.c_str(), i % 2 ? "A" : "B");
      theirs += (i ? "," : "") + point(id.c_str(), "A", i % 3 ? "[1,2]" : "[3,4]");
    }
    const OverlayMerge merged = merge(read(base), read(mine), read(theirs));
    QVERIFY(merged.conflicts.empty());
    QCOMPARE(merged.mine.size(), std::size_t(5'000));
    QCOMPARE(merged.document.features()[0].text(), point("0", "B", "[3,4]"));
  }
};

}  // namespace test_overlay_merge

MAPWRIGHT_TEST(test_overlay_merge, OverlayMergeTest, Nothing)
#include "test_overlay_merge.moc"
