// Edits of overlays: only the values concerned become others, all can be undone, and what others change
// meanwhile lies below.
#include <numbers>

#include <QTest>

#include "overlays/editing_document.h"
#include "overlays/overlay_edits.h"
#include "test_program.h"

namespace test_overlay_edits {

using namespace mapwright::overlays;
using Eigen::Vector2d;
using State = EditingDocument::State;

namespace {

OverlayDocument read(const std::string& features) {
  auto document =
      OverlayDocument::read(R"({"type":"FeatureCollection","w": 1.50,"features":[)" + features + "]}");
  if (!document) qFatal("no overlays: %s", features.c_str());
  return std::move(*document);
}

std::string wall(const char* id, const char* coordinates, const char* more = "") {
  return std::string(R"({"id":")") + id + R"(", "geometry":{"type":"LineString","coordinates": )" +
         coordinates + R"(},"properties":{"lineType":"2")" + more + "}}";
}

std::string point(const char* id, const char* at, const char* properties) {
  return std::string(R"({"id":")") + id + R"(","geometry":{"type":"Point","coordinates":)" + at +
         R"(},"properties":)" + properties + "}";
}

Feature polygon(const char* coordinates) {
  return Feature(std::string(R"({"geometry":{"type":"Polygon","coordinates":)") + coordinates + "}}");
}

std::string coordinatesOf(const Feature& feature) { return std::string(feature.coordinates()->text()); }

/// One step that makes a feature another one.
void set(EditingDocument& document, FeatureKey key, std::optional<Feature> after) {
  document.change({{key, document.find(key), std::move(after)}});
}

}  // namespace

class OverlayEditsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void movingTouchesOnlyTheNumbersThatChange() {
    const Feature line(wall("a", "[ [1.50, 2.0, 0.10],[-3e0,4.00012] ]", R"(,"x":1.0e2)"));
    QCOMPARE(movedBy(line, {0.25, 0}).text(),
             wall("a", "[ [1.75, 2.0, 0.10],[-2.75,4.00012] ]", R"(,"x":1.0e2)"));
    QCOMPARE(coordinatesOf(movedBy(line, {0, 1.00001})), std::string("[ [1.50, 3, 0.10],[-3e0,5.0001] ]"));
    QCOMPARE(movedBy(line, {0, 0}).text(), line.text());
  }

  void collectionsMoveWithAllTheirParts() {
    const Feature all(
        R"({"geometry":{"type":"GeometryCollection","geometries":[{"type":"MultiPoint","coordinates":[[0,0],[1,1]]}]}})");
    QVERIFY(movedBy(all, {1, 2}).text().find("[[1,2],[2,3]]") != std::string::npos);
  }

  void whatIsTurnedLooksTheOtherWay() {
    const Feature text(point("a", "[1,0]", R"({"yaw":"80.0","type":9})"));
    const Feature turned = turnedAbout(text, {0, 0}, std::numbers::pi / 2);
    QCOMPARE(coordinatesOf(turned), std::string("[0,1]"));
    QCOMPARE(std::string(turned.property("yaw")->text()), std::string("\"170\""));
    const Feature further = turnedAbout(turned, {0, 0}, std::numbers::pi / 2);
    QCOMPARE(std::string(further.property("yaw")->text()), std::string("\"-100\""));
    QVERIFY(!turnedAbout(Feature(point("a", "[1,0]", "{}")), {0, 0}, 1).property("yaw"));
  }

  void verticesAreMovedInsertedAndDeleted() {
    const Feature closed = polygon("[[[0,0],[4,0],[4,4],[0,0]]]");
    QCOMPARE(verticesOf(closed).at(0).size(), std::size_t(3));
    QCOMPARE(coordinatesOf(withVertexAt(closed, {0, 0}, {1, 1})), std::string("[[[1,1],[4,0],[4,4],[1,1]]]"));
    const Feature four = withVertexAfter(closed, {0, 2}, {0, 4});
    QCOMPARE(coordinatesOf(four), std::string("[[[0,0],[4,0],[4,4],[0,4],[0,0]]]"));
    QCOMPARE(coordinatesOf(*withoutVertex(four, {0, 0})), std::string("[[[4,0],[4,4],[0,4],[4,0]]]"));
    QVERIFY(!withoutVertex(closed, {0, 1}));
    const Feature open = polygon("[[[0,0, 7],[4,0],[4,4],[0,4]]]");
    QCOMPARE(coordinatesOf(*withoutVertex(open, {0, 3})), std::string("[[[0,0, 7],[4,0],[4,4]]]"));
    QCOMPARE(coordinatesOf(withVertexAfter(open, {0, 0}, {2, 0.5})),
             std::string("[[[0,0, 7],[2,0.5, 7],[4,0],[4,4],[0,4]]]"));
    QVERIFY(!withoutVertex(Feature(wall("a", "[[0,0],[1,1]]")), {0, 0}));
  }

  void typesKeepTheirNotation() {
    QCOMPARE(withType(Feature(wall("a", "[[0,0],[1,1]]")), 1).text(),
             std::string(R"({"id":"a", "geometry":{"type":"LineString","coordinates": [[0,0],[1,1]]},)"
                         R"("properties":{"lineType":"1"}})"));
    QCOMPARE(withType(Feature(point("a", "[0,0]", R"({"type":9})")), 36).text(),
             point("a", "[0,0]", R"({"type":36})"));
  }

  void newFeaturesAreWrittenAsTheirNeighbours() {
    const OverlayDocument among =
        read(wall("a", "[[0,0],[1,1]]") + "," + point("b", "[0,0]", R"({"type":9})"));
    const Feature line = newFeature(among, Shape::Line, {{0, 0}, {1.23456, 0}}, 2, "x", "W");
    QVERIFY(line.shape() == Shape::Line && line.type() == 2 && line.id() == "x" && line.name() == "W");
    QCOMPARE(std::string(line.property("lineType")->text()), std::string("\"2\""));
    QCOMPARE(coordinatesOf(line), std::string("[[0, 0], [1.2346, 0]]"));
    const Feature charger = newFeature(among, Shape::Point, {{1, 2}}, 9, "y");
    QCOMPARE(std::string(charger.property("type")->text()), std::string("9"));
    const Feature region = newFeature(among, Shape::Polygon, {{0, 0}, {1, 0}, {1, 1}}, 1, "z");
    QCOMPARE(verticesOf(region).at(0).size(), std::size_t(3));
    QCOMPARE(region.coordinates()->children().at(0).children().size(), std::size_t(4));
    QCOMPARE(idOf({0x65, 0xa0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x1f}), std::string("65a00000000000000000001f"));
  }

  void copiesHaveAnIdAndANameOfTheirOwn() {
    const Feature one(wall("a", "[[0,0],[1,1]]", R"(,"name":"W","id":"a")"));
    const Feature copy = duplicateOf(one, "b", freeName(read(one.text()), Shape::Line, "W"));
    QVERIFY(copy.id() == "b" && copy.name() == "W 2");
    QCOMPARE(std::string(copy.property("id")->text()), std::string("\"b\""));
    QCOMPARE(coordinatesOf(copy), coordinatesOf(one));
  }

  void allIsUndoneToTheByte() {
    const OverlayDocument base = read(wall("a", "[[0,0],[1,1]]") + " ,\n" + wall("b", "[[2,2],[3,3]]"));
    EditingDocument document(base);
    QVERIFY(!document.unsaved());
    set(document, 0, movedBy(*document.find(0), {1, 0}));
    set(document, 1, std::nullopt);
    set(document, document.newKey(), Feature(wall("c", "[[5,5],[6,6]]")));
    QVERIFY(document.state(0) == State::Changed && document.state(1) == State::Deleted &&
            document.state(2) == State::New);
    QCOMPARE(document.unsavedCount(), std::size_t(3));
    const std::string edited = document.mine().text();
    QCOMPARE(changesBetween(base, document.mine()).size(), std::size_t(3));
    while (document.undo()) {
    }
    QCOMPARE(document.mine().text(), base.text());
    QVERIFY(!document.unsaved());
    while (document.redo()) {
    }
    QCOMPARE(document.mine().text(), edited);
  }

  void theBoxOfAllFollowsItsFeatures() {
    const auto all = [](const char* box, const std::string& features) {
      return *OverlayDocument::read(R"({"type":"FeatureCollection","bbox": )" + std::string(box) +
                                    R"(,"features":[)" + features + "]}");
    };
    const auto boxOf = [](const OverlayDocument& document) {
      const auto collection = document.collection();
      const auto box = collection->root().member("bbox");
      return box ? std::string(box->text()) : std::string();
    };
    const std::string a = wall("a", "[[0,0],[1,1]]"), b = wall("b", "[[2,2],[3,4]]");
    const OverlayDocument base = all("[0.0, 0, 3,4.00]", a + "," + b);
    EditingDocument document(base);
    set(document, 0, turnedAbout(Feature(a), {0, 0}, std::numbers::pi));
    QCOMPARE(boxOf(document.mine()), std::string("[-1, -1, 3,4]"));
    const OverlayDocument turned = document.mine();
    QVERIFY(document.undo());
    QCOMPARE(document.mine().text(), base.text());
    set(document, 1, std::nullopt);
    QCOMPARE(boxOf(document.mine()), std::string("[0, 0, 1,1]"));
    set(document, 0, std::nullopt);
    QCOMPARE(boxOf(document.mine()), std::string());
    // Others who move something move the box as well: nobody has to decide.
    EditingDocument shared(base);
    set(shared, 0, turnedAbout(Feature(a), {0, 0}, std::numbers::pi));
    shared.rebase(all("[0,0,9,9]", a + "," + wall("b", "[[2,2],[9,9]]")));
    QVERIFY(shared.conflicts().empty());
    QCOMPARE(boxOf(shared.mine()), std::string("[-1,-1,9,9]"));
    shared.markSaved();
    QVERIFY(!shared.unsaved());
    EditingDocument draft(all("[0,0,9,9]", a + "," + wall("b", "[[2,2],[9,9]]")));
    draft.restoreDraft(base, turned);
    QVERIFY(draft.conflicts().empty());
    QCOMPARE(boxOf(draft.mine()), std::string("[-1,-1,9,9]"));
    // One that did not fit, or that was put there by hand, stays.
    EditingDocument odd(all("[0,0,1,1]", a + "," + b));
    set(odd, 1, movedBy(Feature(b), {1, 1}));
    QCOMPARE(boxOf(odd.mine()), std::string("[0,0,1,1]"));
    EditingDocument own(base);
    own.change(own.editsTo(all("[-9,-9,9,9]", a + "," + b)));
    set(own, 1, movedBy(Feature(b), {1, 1}));
    QCOMPARE(boxOf(own.mine()), std::string("[-9,-9,9,9]"));
  }

  void stepsThatBelongTogetherAreOne() {
    EditingDocument document(read(wall("a", "[[0,0],[1,1]]")));
    set(document, 0, movedBy(*document.find(0), {1, 0}));
    QVERIFY(document.change({{0, document.find(0), movedBy(*document.find(0), {1, 0})}}, true));
    QCOMPARE(document.steps(), std::size_t(1));
    document.undo();
    QVERIFY(!document.unsaved());
  }

  void whatOthersChangeLiesBelow() {
    EditingDocument document(read(wall("a", "[[0,0],[1,1]]") + "," + wall("b", "[[2,2],[3,3]]")));
    set(document, 0, movedBy(*document.find(0), {1, 0}));
    const OverlayDocument theirs =
        read(wall("a", "[[0,0],[1,1]]", R"(,"speed":0.40)") + "," + wall("c", "[[8,8],[9,9]]"));
    document.rebase(theirs);
    QVERIFY(document.conflicts().empty());
    QCOMPARE(document.mine().text(),
             read(wall("a", "[[1,0],[2,1]]", R"(,"speed":0.40)") + "," + wall("c", "[[8,8],[9,9]]")).text());
    QVERIFY(!document.find(1) && document.state(1) == State::Same);
    QCOMPARE(document.changedThere(), (std::set<FeatureKey>{0, 1, 2}));
    document.undo();
    QCOMPARE(document.mine().text(), theirs.text());
  }

  void aDeletedOneThatOthersChangedIsUndoneToTheirs() {
    EditingDocument document(read(wall("a", "[[0,0],[1,1]]")));
    set(document, 0, std::nullopt);
    const OverlayDocument theirs = read(wall("a", "[[0,0],[1,1]]", R"(,"speed":1)"));
    document.rebase(theirs);
    QCOMPARE(document.conflicts().size(), std::size_t(1));
    QVERIFY(!document.mineOf(document.conflicts()[0]) && document.theirsOf(document.conflicts()[0]));
    document.undo();
    QVERIFY(document.conflicts().empty());
    QCOMPARE(document.mine().text(), theirs.text());
  }

  void theUserDecidesWhatBothChanged() {
    const auto opened = [] {
      EditingDocument document(read(wall("a", "[[0,0],[1,1]]", R"(,"name":"A","v":1)")));
      set(document, 0,
          withProperty(withProperty(*document.find(0), "name", "\"mine\""), "v", std::string("2")));
      document.rebase(read(wall("a", "[[0,0],[1,1]]", R"(,"name":"theirs","v":1)")));
      return document;
    };
    EditingDocument document = opened();
    QCOMPARE(document.conflicts().size(), std::size_t(1));
    const auto conflict = document.conflicts()[0];
    QCOMPARE(conflict.second.text(), std::string("properties.name"));
    QVERIFY(document.mineOf(conflict) == "\"mine\"" && document.theirsOf(conflict) == "\"theirs\"");
    QVERIFY(document.inConflict(0));
    document.useTheirs(conflict);
    QVERIFY(document.conflicts().empty() && document.state(0) == State::Changed);
    QVERIFY(document.find(0)->name() == "theirs" && document.find(0)->property("v")->text() == "2");
    document.undo();
    QCOMPARE(document.conflicts().size(), std::size_t(1));
    document.keepMine(conflict);
    QVERIFY(document.conflicts().empty() && document.find(0)->name() == "mine");
  }

  void whatTheyDeletedAndIChangedIsAConflict() {
    EditingDocument document(read(wall("a", "[[0,0],[1,1]]") + "," + wall("b", "[[2,2],[3,3]]")));
    set(document, 0, movedBy(*document.find(0), {1, 0}));
    document.rebase(read(wall("b", "[[2,2],[3,3]]")));
    QCOMPARE(document.conflicts().size(), std::size_t(1));
    QVERIFY(document.state(0) == State::New);
    document.useTheirs(document.conflicts()[0]);
    QVERIFY(!document.find(0) && document.conflicts().empty() && !document.unsaved());
  }

  void theStateThatWasSavedCanBeUndone() {
    const OverlayDocument base = read(wall("a", "[[0,0],[1,1]]"));
    EditingDocument document(base);
    set(document, 0, movedBy(*document.find(0), {1, 0}));
    set(document, document.newKey(), Feature(wall("c", "[[5,5],[6,6]]")));
    document.markSaved();
    QVERIFY(!document.unsaved() && document.conflicts().empty());
    document.rebase(document.mine());
    QVERIFY(!document.unsaved() && document.changedThere().empty());
    document.undo();
    document.undo();
    QCOMPARE(document.unsavedCount(), std::size_t(2));
    QCOMPARE(document.mine().text(), base.text());
  }

  void conflictsThatAreNotDecidedSurviveInADraft() {
    const OverlayDocument base = read(wall("a", "[[0,0],[1,1]]", R"(,"name":"A")") + "," +
                                      wall("b", "[[2,2],[3,3]]") + "," + wall("c", "[[4,4],[5,5]]"));
    const OverlayDocument theirs =
        read(wall("a", "[[0,0],[1,1]]", R"(,"name":"theirs","v":1)") + "," + wall("b", "[[2,2],[3,9]]"));
    EditingDocument document(base);
    set(document, 0, withProperty(*document.find(0), "name", "\"mine\""));
    set(document, 1, std::nullopt);
    set(document, 2, movedBy(*document.find(2), {1, 0}));
    document.rebase(theirs);
    QCOMPARE(document.conflicts().size(), std::size_t(3));
    // The program crashes; meanwhile nothing changes.
    EditingDocument again(theirs);
    again.restoreDraft(document.draftBase(), document.mine());
    QCOMPARE(again.conflicts().size(), std::size_t(3));
    QCOMPARE(again.mine().text(), document.mine().text());
    EditingDocument once_more(theirs);
    once_more.restoreDraft(again.draftBase(), again.mine());
    QCOMPARE(once_more.conflicts().size(), std::size_t(3));
    // One that is decided is not asked about again.
    document.keepMine(document.conflicts()[0]);
    EditingDocument decided(theirs);
    decided.restoreDraft(document.draftBase(), document.mine());
    QCOMPARE(decided.conflicts().size(), std::size_t(2));
    QVERIFY(decided.find(0)->name() == "mine");
  }

  void aDraftIsTakenUpOnWhatIsThereNow() {
    const OverlayDocument old_base = read(wall("a", "[[0,0],[1,1]]") + "," + wall("b", "[[2,2],[3,3]]"));
    const OverlayDocument old_mine = read(wall("a", "[[7,0],[8,1]]") + "," + wall("n", "[[4,4],[5,5]]"));
    EditingDocument document(
        read(wall("a", "[[0,0],[1,1]]", R"(,"v":1)") + "," + wall("b", "[[2,2],[3,4]]")));
    document.restoreDraft(old_base, old_mine);
    QCOMPARE(document.find(0)->text(), wall("a", "[[7,0],[8,1]]", R"(,"v":1)"));
    QCOMPARE(document.conflicts().size(), std::size_t(1));  // b: deleted here, changed there
    QVERIFY(!document.find(1) && document.find(2) && document.find(2)->id() == "n");
    document.undo();
    QVERIFY(!document.unsaved() && document.conflicts().empty());
  }
};

}  // namespace test_overlay_edits

MAPWRIGHT_TEST(test_overlay_edits, OverlayEditsTest, Nothing)
#include "test_overlay_edits.moc"
