// What the tools for overlays reckon with: what was seen and collected, snapping, pasting, putting in line,
// parts of several, defaults of the collection.
#include <QTest>

#include "overlays/editing_document.h"
#include "overlays/overlay_arrange.h"
#include "overlays/overlay_edits.h"
#include "overlays/overlay_marks.h"
#include "overlays/overlay_paste.h"
#include "overlays/overlay_snap.h"
#include "overlays/overlay_types.h"
#include "test_program.h"

namespace test_overlay_tools {

using namespace mapwright::overlays;
using Eigen::Vector2d;
using mapwright::geometry::WorldRect;

namespace {

OverlayDocument document(const std::string& features, const std::string& more = {}) {
  auto read =
      OverlayDocument::read(R"({"type":"FeatureCollection",)" + more + R"("features":[)" + features + "]}");
  if (!read) qFatal("no overlays: %s", features.c_str());
  return std::move(*read);
}

Feature multi(const char* type, const char* coordinates) {
  return Feature(std::string(R"({"geometry":{"type":")") + type + R"(","coordinates":)" + coordinates + "}}");
}

std::string coordinatesOf(const Feature& feature) { return std::string(feature.coordinates()->text()); }

std::string notPastedReason(const std::string& text) {
  const auto pasted = pastedFeatures(text);
  return pasted ? std::string() : inEnglish(pasted.error());
}

SnapIndex indexOf(const std::vector<Path>& paths) {
  SnapIndex index;
  for (std::size_t i = 0; i < paths.size(); ++i) index.add(i, {paths[i]});
  index.finish();
  return index;
}

}  // namespace

class OverlayToolsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatIsSeenIsWrittenAsItsNeighboursAre() {
    const OverlayDocument among = document(
        R"({"geometry":{"type":"Point","coordinates":[0,0]},"properties":{"type":"9","mapOverlay":true}})");
    const Feature charger = seenFeature(among, kCharger, {{4.179, -26.094}, 182.2}, "abc", "C1");
    QCOMPARE(charger.type(), kCharger);
    QVERIFY(charger.property("type")->kind() == JsonKind::String);
    QCOMPARE(coordinatesOf(charger), std::string("[4.179, -26.094]"));
    QCOMPARE(std::string(charger.property("yaw")->text()), std::string("-177.8"));
    QVERIFY(charger.property("mapOverlay") && !charger.property("ref"));
    const Feature rack = seenFeature(OverlayDocument(), kRackPoint, {{1, 2}, 0, "center_of_rear_edge"}, "x");
    QCOMPARE(rack.property("ref")->string(), std::string("center_of_rear_edge"));
    QVERIFY(!rack.property("mapOverlay"));
    // Seen again nothing else of it changes.
    const Feature before(
        R"({"id":"7","geometry":{"type":"Point","coordinates":[ 1.0,2, 0.5]},"properties":{"type":9,"yaw":"10","x":1.50}})");
    QCOMPARE(
        seenAgain(before, {{1, 3}, 20}).text(),
        std::string(
            R"({"id":"7","geometry":{"type":"Point","coordinates":[ 1.0,3, 0.5]},"properties":{"type":9,"yaw":"20","x":1.50}})"));
  }

  void marksThatAreThereAreLeftOutOrOffered() {
    const OverlayDocument among = document(
        R"({"geometry":{"type":"Point","coordinates":[1,1]},"properties":{"type":39,"landmarkId":"landmark_1"}},)"
        R"({"geometry":{"type":"Point","coordinates":[5,5]},"properties":{"type":"37","barcodeId":"D2_125"}})");
    using Kind = Mark::Kind;
    const auto offers = offersOf(among, {{Kind::Landmark, "landmark_10", {0, 0}},
                                         {Kind::Landmark, "landmark_2", {9, 9}},
                                         {Kind::Landmark, "landmark_2", {2, 2}},
                                         {Kind::Landmark, "landmark_1", {1.005, 1}},
                                         {Kind::Barcode, "D2_125", {5, 6}, 90}});
    QCOMPARE(offers.size(), std::size_t(3));
    QCOMPARE(offers[0].mark.id, std::string("landmark_2"));
    QCOMPARE(offers[0].mark.at_m, Vector2d(2, 2));
    QCOMPARE(offers[1].mark.id, std::string("landmark_10"));
    QVERIFY(!offers[0].present && !offers[1].present);
    QCOMPARE(offers[2].present, std::optional<std::size_t>(1));
    QCOMPARE(offers[2].away_m, 1.0);
    const Feature mark = markFeature(among, offers[0].mark, "id");
    QCOMPARE(mark.type(), kLandmark);
    QCOMPARE(mark.property("landmarkId")->string(), std::string("landmark_2"));
    QCOMPARE(mark.name(), std::string("landmark_2"));
    const Feature moved = withMark(among.features()[1], offers[2].mark);
    QCOMPARE(coordinatesOf(moved), std::string("[5,6]"));
    QVERIFY(offersOf(document(moved.text()), {offers[2].mark}).empty());
  }

  void theNearestVertexComesBeforeSidesAnglesAndTheGrid() {
    const SnapIndex index = indexOf({{Shape::Line, {{0, 0}, {10, 0}}},
                                     {Shape::Polygon, {{0, 5}, {4, 5}, {4, 9}}},
                                     {Shape::Point, {{20, 20}}}});
    SnapKinds kinds;
    kinds.grid = true;
    const SnapScene scene{&index};
    const auto at = [&](double x, double y) { return snapped({x, y}, 0.1, kinds, scene); };
    QVERIFY(at(0.05, 0.05).to == SnapTo::Vertex && at(0.05, 0.05).at_m == Vector2d(0, 0));
    QVERIFY(at(20, 20.05).to == SnapTo::Vertex);
    QVERIFY(at(3.21, 0.05).to == SnapTo::Edge);
    QCOMPARE(at(3.21, 0.05).at_m, Vector2d(3.21, 0));
    QVERIFY(at(2.05, 7.0).to == SnapTo::Edge);  // the side that closes the outline
    QVERIFY(at(6.53, 7.27).to == SnapTo::Grid);
    QCOMPARE(at(6.53, 7.27).at_m, Vector2d(6.5, 7.27));
    QVERIFY(at(6.25, 7.27).to == SnapTo::Nothing);
    // What the hand holds is no target.
    SnapScene holding{&index, [](FeatureKey key) { return key == 0; }};
    QVERIFY(snapped({3.21, 0.05}, 0.1, kinds, holding).to == SnapTo::Grid);
    kinds.edges = kinds.vertices = kinds.grid = false;
    QVERIFY(at(0.05, 0.05).to == SnapTo::Nothing);
  }

  void anglesAreMultiplesOf15Degrees() {
    SnapKinds kinds;
    SnapScene scene;
    scene.arms_m = {Vector2d(1, 1)};
    const Snapped level = snapped({4, 1.05}, 0.1, kinds, scene);
    QVERIFY(level.to == SnapTo::Angle && (level.at_m - Vector2d(4, 1)).norm() < 1e-9);
    const Snapped diagonal = snapped({3.02, 3}, 0.1, kinds, scene);
    QVERIFY(diagonal.to == SnapTo::Angle && std::abs(diagonal.at_m.x() - diagonal.at_m.y()) < 1e-9);
    QVERIFY(snapped({4, 1.4}, 0.1, kinds, scene).to == SnapTo::Nothing);
    QVERIFY(snapped({1.05, 1.01}, 0.1, kinds, scene).to == SnapTo::Nothing);
    // Between two neighbours the nearer direction counts.
    scene.arms_m = {Vector2d(1, 1), Vector2d(5, 5)};
    scene.angle_step_deg = 90;
    QVERIFY((snapped({5.02, 1.05}, 0.1, kinds, scene).at_m - Vector2d(5, 1.05)).norm() < 1e-9);
    QVERIFY(snapped({3, 3.02}, 0.1, kinds, scene).to == SnapTo::Nothing);
  }

  void longSidesAreFoundEverywhereAlongThem() {
    const SnapIndex index =
        indexOf({{Shape::Line, {{-500, -300}, {700, 450}}}, {Shape::Line, {{3, 900}, {3, -900}}}});
    SnapKinds kinds;
    kinds.vertices = false;
    const SnapScene scene{&index};
    for (double part = 0.01; part < 1; part += 0.013) {
      const Vector2d on = Vector2d(-500, -300) + part * Vector2d(1200, 750);
      QVERIFY2(snapped(on + Vector2d(0, 0.02), 0.05, kinds, scene).to == SnapTo::Edge,
               qPrintable(QString::number(part)));
      QVERIFY(snapped({3.02, -900 + 1800 * part}, 0.05, kinds, scene).to == SnapTo::Edge);
    }
  }

  void whateverIsGeoJsonIsPasted() {
    const std::string point = R"({"type":"Point","coordinates":[1,2]})";
    const std::string feature = R"({"type":"Feature","geometry":)" + point + R"(,"properties":{"type":9}})";
    QCOMPARE(pastedFeatures(point)->size(), std::size_t(1));
    QCOMPARE(pastedFeatures("\n " + feature)->front().text(), feature);
    QCOMPARE(pastedFeatures("[" + feature + "," + feature + "]")->size(), std::size_t(2));
    QCOMPARE(pastedFeatures(R"({"type":"FeatureCollection","features":[)" + feature + "]}")->size(),
             std::size_t(1));
  }

  void featuresWithoutAPlaceArePastedWithTheOthers() {
    const std::string good = R"({"type":"Feature","geometry":{"type":"Point","coordinates":[1,2]}})";
    const std::string none = R"({"type":"Feature","id":"n","geometry":null,"properties":{"name":"N"}})";
    const std::string empty = R"({"type":"Feature","geometry":{"type":"Polygon","coordinates":[]}})";
    const auto pasted = pastedFeatures("[" + good + "," + none + R"(,{"type":"Feature"},)" + empty + "]");
    QVERIFY(pasted);
    QCOMPARE(pasted->size(), std::size_t(4));
    QVERIFY(notPastedReason(R"({"type":"Polygon","coordinates":[]})").find("no place") != std::string::npos);
    QCOMPARE((*pasted)[1].text(), none);
    // Its id and name are taken then, and moving leaves it as it is.
    OverlayDocument among;
    among.add((*pasted)[1]);
    const std::vector<Feature> free = madeFree(among, {(*pasted)[1]}, [] { return "new"; });
    QCOMPARE(movedBy(free[0], {1, 1}).text(),
             std::string(R"({"type":"Feature","id":"new","geometry":null,"properties":{"name":"N 2"}})"));
  }

  void whatCannotBePastedIsToldWithItsPlace() {
    QCOMPARE(notPastedReason("hello"), std::string("it contains no overlays"));
    QCOMPARE(notPastedReason("{\n \"features\": [,]}"),
             std::string("line 2, column 15: a value is expected here"));
    QVERIFY(!notPastedReason("{}").empty());
    const std::string good = R"({"geometry":{"type":"Point","coordinates":[1,2]}})";
    const auto second = [&](const char* bad) { return notPastedReason("[" + good + "," + bad + "]"); };
    QVERIFY(second("7").find("number 2") != std::string::npos);
    QVERIFY(second("{}").find("feature 2 has no place") != std::string::npos);
    QVERIFY(second(R"({"geometry":{"type":"Circle","coordinates":[1,2]}})").find("Circle") !=
            std::string::npos);
    QVERIFY(second(R"({"geometry":{"type":"Point","coordinates":["x",2]}})").find("[\"x\",2]") !=
            std::string::npos);
    QVERIFY(second(R"({"geometry":{"type":"LineString","coordinates":[[1,2]]}})").find("too few") !=
            std::string::npos);
  }

  void groupsArePutInLineAndSpread() {
    const std::vector<WorldRect> boxes{{0, 0, 2, 1}, {5, 4, 6, 8}, {3, 1, 4, 2}};
    const auto left = shiftsToAlign(boxes, Alignment::Left);
    QCOMPARE(left[1], Vector2d(-5, 0));
    QCOMPARE(left[2], Vector2d(-3, 0));
    QCOMPARE(shiftsToAlign(boxes, Alignment::Top)[0], Vector2d(0, 7));
    QCOMPARE(shiftsToAlign(boxes, Alignment::CentreY)[0], Vector2d(0, 3.5));
    // Gaps of 1 and 1 become equal: they are already.
    QCOMPARE(shiftsToSpread(boxes, Spread::X)[2], Vector2d(0, 0));
    const auto spread = shiftsToSpread(boxes, Spread::Y);
    QCOMPARE(spread[0], Vector2d(0, 0));
    QCOMPARE(spread[1], Vector2d(0, 0));
    QCOMPARE(spread[2], Vector2d(0, 1));
    QCOMPARE(circleAround({1, 1}, 2).size(), std::size_t(kCircleVertices));
    for (const Vector2d& at : circleAround({1, 1}, 2))
      QVERIFY(std::abs((at - Vector2d(1, 1)).norm() - 2) < 1e-9);
  }

  void partsOfSeveralHaveVerticesLikeOthers() {
    const Feature areas = multi("MultiPolygon", "[[[[0,0],[1,0],[1,1],[0,0]]],[[[5,5],[6,5],[6,6],[5,6]]]]");
    QCOMPARE(verticesOf(areas).size(), std::size_t(2));
    QVERIFY(partShapeOf(areas) == Shape::Polygon);
    QCOMPARE(coordinatesOf(withVertexAt(areas, {0, 0}, {0, -1})),
             std::string("[[[[0,-1],[1,0],[1,1],[0,-1]]],[[[5,5],[6,5],[6,6],[5,6]]]]"));
    QVERIFY(!withoutVertex(areas, {0, 1}));
    QCOMPARE(coordinatesOf(*withoutVertex(areas, {1, 1})),
             std::string("[[[[0,0],[1,0],[1,1],[0,0]]],[[[5,5],[6,6],[5,6]]]]"));
    const Feature lines = multi("MultiLineString", "[[[0,0],[1,0]],[[2,2],[3,3]]]");
    QCOMPARE(coordinatesOf(withVertexAfter(lines, {1, 0}, {2, 3})),
             std::string("[[[0,0],[1,0]],[[2,2],[2,3],[3,3]]]"));
    const Feature points = multi("MultiPoint", "[[0,0],[1,0]]");
    QCOMPARE(verticesOf(points).at(0).size(), std::size_t(2));
    QCOMPARE(coordinatesOf(*withoutVertex(points, {0, 0})), std::string("[[1,0]]"));
    QCOMPARE(withType(areas, 12).type(), 12);
    QVERIFY(withType(areas, 12).property("regionType"));
  }

  void defaultsOfTheCollectionAreEditedLikeFeatures() {
    const OverlayDocument held =
        document(R"({"id":"a"})", R"("properties":{"defaultRackWidth":1.50,"x":[ 1]},)");
    EditingDocument editing(held);
    const auto set = [&](const char* name, std::optional<std::string> value) {
      const auto now = editing.find(kCollectionKey);
      editing.change({{kCollectionKey, now, withProperty(*now, name, value)}});
    };
    set("defaultRackWidth", "0.8");
    QVERIFY(editing.unsaved());
    QCOMPARE(editing.unsavedCount(), std::size_t(1));
    QCOMPARE(editing.mine().text(),
             document(R"({"id":"a"})", R"("properties":{"defaultRackWidth":0.8,"x":[ 1]},)").text());
    editing.undo();
    QCOMPARE(editing.mine().text(), held.text());
    editing.redo();
    // What others set beside it comes below.
    editing.rebase(document(R"({"id":"a"})",
                            R"("properties":{"defaultRackWidth":1.50,"x":[ 1],"defaultRackDepth":2},)"));
    QVERIFY(editing.conflicts().empty());
    QVERIFY(editing.mine().text().find(R"("defaultRackWidth":0.8,"x":[ 1],"defaultRackDepth":2)") !=
            std::string::npos);
    // The same one is to be decided.
    editing.rebase(
        document(R"({"id":"a"})", R"("properties":{"defaultRackWidth":3,"x":[ 1],"defaultRackDepth":2},)"));
    QCOMPARE(editing.conflicts().size(), std::size_t(1));
    editing.useTheirs(editing.conflicts().front());
    QVERIFY(!editing.unsaved());
    // A draft keeps them.
    EditingDocument later(held);
    later.restoreDraft(held, document(R"({"id":"a"})", R"("properties":{"defaultRackWidth":7,"x":[ 1]},)"));
    QVERIFY(later.unsaved());
    QVERIFY(later.mine().text().find(R"("defaultRackWidth":7)") != std::string::npos);
    // Where there are none yet, too.
    EditingDocument bare(document(R"({"id":"a"})"));
    const auto now = bare.find(kCollectionKey);
    bare.change({{kCollectionKey, now, withProperty(*now, "defaultPalletWidth", "1.2")}});
    QVERIFY(bare.mine().text().find(R"("properties": {"defaultPalletWidth": 1.2})") != std::string::npos ||
            bare.mine().text().find(R"("properties":{"defaultPalletWidth": 1.2})") != std::string::npos);
    bare.markSaved();
    QVERIFY(!bare.unsaved());
    // Undone after saving it is as it was, to the byte, whatever the robot tells meanwhile.
    bare.rebase(document(R"({"id":"a"})", R"("properties": { "defaultPalletWidth":1.20 }, )"));
    QVERIFY(!bare.unsaved());
    bare.undo();
    QVERIFY(bare.unsaved());
    QVERIFY(bare.mine().text().find("properties") == std::string::npos);
  }

  void halfASurrogatePairCanBeEdited() {
    const Feature odd(
        R"({"id":"a","geometry":{"type":"Point","coordinates":[1,2]},"properties":{"name":"x\ud83d","\udc00":1}})");
    QVERIFY(movedBy(odd, {1, 0}).text().find(R"("x\ud83d")") != std::string::npos);
    const Feature copy = duplicateOf(odd, "b", odd.name() + " 2");
    QVERIFY(copy.root().isObject());
    QVERIFY(copy.text().find(R"("x\ud83d 2")") != std::string::npos);
    const Feature set = withProperty(odd, odd.root().member("properties")->children()[1].key(), "2");
    QVERIFY(set.text().find(R"("\udc00":2)") != std::string::npos);
    // As a new member, too.
    const Feature other = withProperty(Feature(R"({"properties":{}})"), "\xED\xB0\x80", "3");
    QCOMPARE(other.text(), std::string(R"({"properties":{"\udc00": 3}})"));
  }
};

}  // namespace test_overlay_tools

MAPWRIGHT_TEST(test_overlay_tools, OverlayToolsTest, Core)
#include "test_overlay_tools.moc"
