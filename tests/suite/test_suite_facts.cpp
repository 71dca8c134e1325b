// Facts of pictures: they come back from their file, and what changed of them is named where the pictures
// differ.
#include <functional>

#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "suite/facts.h"
#include "suite/facts_changes.h"
#include "suite/outcome.h"
#include "test_program.h"

namespace test_suite_facts {

using namespace mapwright;
using suite::Facts;

namespace {

map::OverlayFeature wallAt(double x) {
  map::OverlayFeature wall;
  wall.shape = map::OverlayShape::Line;
  wall.type = 2;
  wall.id = "5f3a";
  wall.name = "W17";
  wall.parts = {{{x, -4}, {x, -2}}};
  return wall;
}

geometry::WorldRect box(double x, double y, double size) { return {x, y, x + size, y + size}; }

Facts facts() {
  Facts facts;
  facts.picture = "5e";
  facts.view = geometry::ViewTransform{{0, 0}, 0.05, 0, 800, 600};
  facts.session = "u";
  facts.submaps[{12, 3}] = {7, {1, 2, 0.5}, box(11, -5, 4)};
  facts.submaps[{0, 1}] = {1, {0, 0, 0}, box(-18, 8, 2)};
  facts.map = suite::MapFact{
      "12", "Office", "uid", 3, 4, "abc", box(-20, -15, 40), geometry::Pose2{-20, -15, 0}, 0.05};
  facts.overlays = suite::overlaysText({wallAt(12.4)});
  map::Waypoint dock;
  dock.id = "9";
  dock.name = "Dock";
  dock.position_m = {-15, 3};
  dock.yaw_rad = 1;
  facts.waypoints = {dock};
  facts.robot = geometry::Pose2{3, 4, 0};
  facts.theme = "dark";
  facts.layers = {"whole", "submaps", "overlays"};
  facts.closures = suite::ClosuresFact{12, 0.3125};
  facts.disagreement = suite::DisagreementFact{4, 884, 21};
  facts.stamps = {{"/scan", 1700000000.25}};
  return facts;
}

QStringList wordsOf(const Facts& before, const Facts& after) {
  QStringList words;
  for (const suite::FactChange& change : suite::changesBetween(before, after)) words << change.words;
  return words;
}

compare::Comparison differingAt(const std::vector<compare::PixelBox>& boxes) {
  compare::Comparison made;
  made.expected = made.actual = {800, 600};
  made.equal = false;
  for (const compare::PixelBox& one : boxes) {
    made.clusters.push_back({one, std::int64_t(one.width) * one.height, true});
    made.differing += made.clusters.back().pixels;
  }
  made.clusters_in_all = std::int64_t(boxes.size());
  return made;
}

}  // namespace

class SuiteFactsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void numbersBeyondAllMapsComeBackFromTheirFile() {
    Facts far = facts();
    far.robot = geometry::Pose2{1e308, -4e15 / 7, 0};
    const auto again = suite::factsFrom(suite::factsBytes(far));
    QVERIFY(again && again->robot);
    QCOMPARE(again->robot->x_m, far.robot->x_m);
    QCOMPARE(again->robot->y_m, far.robot->y_m);
  }

  void factsComeBackFromTheirFile() {
    const QByteArray bytes = suite::factsBytes(facts());
    const auto back = suite::factsFrom(bytes);
    QVERIFY2(back, back ? "" : qPrintable(back.error()));
    QCOMPARE(suite::factsBytes(*back), bytes);
    QCOMPARE(back->picture, std::string("5e"));
    QCOMPARE(wordsOf(facts(), *back), QStringList());
    QCOMPARE(back->view->scale_m_per_px, 0.05);
    QVERIFY(back->closures == facts().closures && back->disagreement == facts().disagreement);
  }
  void figuresOfTheSessionAreNumbersForATrend() {
    const QJsonObject json = QJsonDocument::fromJson(suite::factsBytes(facts())).object();
    const QJsonObject closures = json[QLatin1String("closures")].toObject(),
                      disagreement = json[QLatin1String("disagreement")].toObject();
    QCOMPARE(closures[QLatin1String("inter")].toInt(), 12);
    QCOMPARE(closures[QLatin1String("largest_m")].toDouble(), 0.3125);
    QCOMPARE(disagreement[QLatin1String("tolerance_cells")].toInt(), 4);
    QCOMPARE(disagreement[QLatin1String("occupied_cells")].toInt(), 884);
    QCOMPARE(disagreement[QLatin1String("contradicted_cells")].toInt(), 21);
    QCOMPARE(disagreement[QLatin1String("share")].toDouble(), 21.0 / 884);
    Facts none = facts();
    none.closures = suite::ClosuresFact{};
    none.disagreement.reset();
    const auto back = suite::factsFrom(suite::factsBytes(none));
    QVERIFY(back && back->closures == none.closures && !back->disagreement);
  }
  void figuresAlterNoPixel() {
    Facts after = facts();
    after.closures.reset();
    after.disagreement->contradicted_cells = 800;
    QCOMPARE(wordsOf(facts(), after), QStringList());
  }
  void whatIsNoFileOfFactsIsRefused() {
    for (const char* bytes : {"", "[]", "{}", R"({"mapwright":"facts","version":1,"submaps":[{"id":"x"}]})",
                              R"({"mapwright":"facts"})", R"({"mapwright":"facts","version":"1"})"})
      QVERIFY(!suite::factsFrom(bytes));
    const auto later = suite::factsFrom(R"({"mapwright":"facts","version":99})");
    QVERIFY(!later);
    QCOMPARE(later.error(), QStringLiteral("Its version is 99; only version 1 can be read."));
    QVERIFY(suite::factsFrom(R"({"mapwright":"facts","version":1})"));
  }

  void everyChangeIsNamed() {
    Facts after = facts();
    after.submaps[{12, 3}].version = 9;
    after.submaps[{0, 1}].pose.x_m = 0.25;
    after.submaps[{0, 2}] = {1, {}, box(0, 0, 1)};
    after.overlays = suite::overlaysText({wallAt(12.8)});
    after.waypoints[0].position_m.x() = -14.5;
    after.map->version = 5;
    after.map->cells = "def";
    after.robot->yaw_rad = 1;
    after.stamps["/scan"] = 1700000001;
    QCOMPARE(
        wordsOf(facts(), after),
        (QStringList{
            QStringLiteral("map Office went from version 3 to 5"),
            QStringLiteral("virtual wall W17 moved by 0.40 m"),
            QStringLiteral("waypoint Dock moved by 0.50 m"), QStringLiteral("submap 0-1 moved by 0.25 m"),
            QStringLiteral("submap 12-3 went from version 7 to 9"), QStringLiteral("submap 0-2 is new"),
            QStringLiteral("the robot turned by 57.3°"), QStringLiteral("the cells of map Office changed"),
            QStringLiteral("messages of other times: /scan")}));
    QVERIFY(wordsOf(after, facts()).contains(QStringLiteral("submap 0-2 is gone")));
  }

  void howFarAThingMovedIsSaidToAMillimetre() {
    for (const auto& [x, moved] : {std::pair(12.401, "virtual wall W17 moved by 0.001 m"),
                                   std::pair(12.408, "virtual wall W17 moved by 0.008 m"),
                                   std::pair(12.45, "virtual wall W17 moved by 0.05 m")}) {
      Facts after = facts();
      after.overlays = suite::overlaysText({wallAt(x)});
      QCOMPARE(wordsOf(facts(), after), QStringList{QLatin1String(moved)});
    }
    // One end alone.
    map::OverlayFeature wall = wallAt(12.4);
    wall.parts[0][0].x() = 12.401;
    Facts after = facts();
    after.overlays = suite::overlaysText({wall});
    QCOMPARE(wordsOf(facts(), after), QStringList{QStringLiteral("virtual wall W17 has another shape")});
  }

  void whatIsNotDrawnIsNoCause() {
    map::OverlayFeature nowhere = wallAt(3);
    nowhere.id = "none";
    nowhere.parts = {{}};
    const auto changed = [&](const std::function<void(Facts&)>& change) {
      Facts before = facts(), after = facts();
      before.overlays = after.overlays = suite::overlaysText({wallAt(12.4)});
      change(after);
      return wordsOf(before, after);
    };
    const auto wall = [](const std::function<void(map::OverlayFeature&)>& change) {
      map::OverlayFeature made = wallAt(12.4);
      change(made);
      return suite::overlaysText({made});
    };
    const QStringList none;
    QCOMPARE(changed([](Facts& facts) { facts.waypoints[0].tags = {"a"}; }), none);
    QCOMPARE(changed([](Facts& facts) { facts.waypoints[0].type = "b"; }), none);
    QCOMPARE(changed([](Facts& facts) { facts.waypoints[0].yaw_rad = 1 + 2 * M_PI; }), none);
    QCOMPARE(changed([](Facts& facts) { facts.waypoints[0].position_m.x() += 3e-4; }), none);
    QCOMPARE(changed([](Facts& facts) { facts.waypoints[0].yaw_rad.reset(); }),
             QStringList{QStringLiteral("waypoint Dock has no heading any more")});
    // Lines have no names, nor headings.
    QCOMPARE(changed([&](Facts& all) { all.overlays = wall([](auto& one) { one.name = "W18"; }); }), none);
    QCOMPARE(changed([&](Facts& all) { all.overlays = wall([](auto& one) { one.yaw_rad = 1; }); }), none);
    QCOMPARE(changed([&](Facts& all) { all.overlays = wall([](auto& one) { one.id.clear(); }); }), none);
    QCOMPARE(changed([&](Facts& all) {
               all.overlays = wall([](auto& one) {
                 one.name = "W18";
                 one.parts = {{{12.8, -4}, {12.8, -2}}};
               });
             }),
             QStringList{QStringLiteral("virtual wall W17 moved by 0.40 m")});
    QCOMPARE(changed([&](Facts& facts) {
               facts.overlays = suite::overlaysText({wallAt(12.4), nowhere});
             }),
             none);
    // Pictures of submaps.
    const auto outlines = [](Facts& facts) { facts.layers = {"whole", "outlines"}; };
    Facts before = facts(), after = facts();
    outlines(before);
    outlines(after);
    after.submaps[{12, 3}].version = 9;
    QCOMPARE(wordsOf(before, after), none);
    after.submaps[{12, 3}].pose.x_m += 1;
    QCOMPARE(wordsOf(before, after), QStringList{QStringLiteral("submap 12-3 moved by 1.00 m")});
    // Versions of what is the same.
    QCOMPARE(changed([](Facts& facts) { facts.map->version = 9; }), none);
    QCOMPARE(changed([](Facts& facts) { facts.map->overlays_version = 9; }), none);
    QCOMPARE(changed([](Facts& facts) { facts.map->uid = "other"; }), none);
    QCOMPARE(changed([](Facts& facts) {
               facts.map->version = 9;
               facts.map->cells.clear();
             }),
             QStringList{QStringLiteral("map Office went from version 3 to 9")});
  }

  void anotherViewAndAnotherPlaceOfTheMapAreNamed() {
    const auto changed = [](const std::function<void(Facts&)>& change) {
      Facts after = facts();
      change(after);
      // As it is kept.
      return wordsOf(*suite::factsFrom(suite::factsBytes(facts())), after);
    };
    const QStringList another{QStringLiteral("the view is another one")};
    QCOMPARE(changed([](Facts& facts) { facts.view->center_m.x() += 0.05; }), another);
    QCOMPARE(changed([](Facts& facts) { facts.view->width_px = 801; }), another);
    QCOMPARE(changed([](Facts& facts) { facts.view->scale_m_per_px = 0.051; }), another);
    QCOMPARE(changed([](Facts& facts) { facts.view->rotation_rad = 0.01; }), another);
    QCOMPARE(changed([](Facts& facts) { facts.theme = "light"; }),
             QStringList{QStringLiteral("the theme is light instead of dark")});
    QCOMPARE(changed([](Facts& facts) {
               facts.layers = {"whole", "submaps", "grid"};
             }),
             (QStringList{QStringLiteral("layers that are drawn now: grid"),
                          QStringLiteral("layers that are drawn no more: overlays")}));
    QCOMPARE(changed([](Facts& facts) { facts.map->origin->x_m += 0.1; }),
             QStringList{QStringLiteral("map Office lies 0.10 m elsewhere")});
    QCOMPARE(changed([](Facts& facts) { facts.map->origin->yaw_rad = 0.1; }),
             QStringList{QString::fromUtf8("map Office is turned by 5.7°")});
    QCOMPARE(changed([](Facts& facts) { facts.map->resolution_m = 0.025; }),
             QStringList{QStringLiteral("map Office has another resolution")});
  }

  void whatHasNoPlaceIsNoCauseWhereAllIsExplained() {
    Facts after = facts();
    after.overlays = suite::overlaysText({wallAt(12.8)});
    after.map->cells = "def";
    const QString cells = QStringLiteral("the cells of map Office changed");
    const auto explained = [&](const std::vector<compare::PixelBox>& boxes) {
      return suite::explained(differingAt(boxes), *after.view, suite::changesBetween(facts(), after));
    };
    const std::vector<compare::PixelBox> wall{{638, 357, 20, 10}};
    suite::Explanation why = explained(wall);
    QCOMPARE(why.everywhere, QStringList());
    QCOMPARE(why.somewhere, QStringList{cells});
    QVERIFY2(
        suite::explanationText(differingAt(wall), *after.view, why)
            .endsWith(QStringLiteral(": virtual wall W17 moved by 0.40 m. There or elsewhere: the cells of "
                                     "map Office changed.")),
        qPrintable(suite::explanationText(differingAt(wall), *after.view, why)));
    // One that nothing else explains.
    why = explained({{638, 357, 20, 10}, {10, 590, 5, 5}});
    QCOMPARE(why.everywhere, QStringList{cells});
    QCOMPARE(why.somewhere, QStringList());
    // Another view is a cause in any case.
    after.theme = "light";
    QCOMPARE(explained(wall).everywhere, QStringList{QStringLiteral("the theme is light instead of dark")});
  }

  /// The map of facts(), 800 x 600 cells of 0.05 m, with these cells black.
  static Facts withBlack(const std::vector<Eigen::Vector2i>& black) {
    Facts made = facts();
    suite::CellBlocks blocks(800, 600);
    for (int y = 0; y < 600; ++y) {
      std::vector<std::uint8_t> row(800, 254);
      for (const Eigen::Vector2i& at : black) {
        if (at.y() == y) row[std::size_t(at.x())] = 0;
      }
      blocks.addRow(y, row.data());
    }
    made.map->blocks = blocks;
    for (const Eigen::Vector2i& at : black)
      made.map->cells += ' ' + std::to_string(at.x()) + ',' + std::to_string(at.y());
    return made;
  }

  void cellsThatChangedHaveTheirPlace() {
    const Facts before = withBlack({}), after = withBlack({{400, 300}, {440, 300}, {100, 500}});
    const QByteArray bytes = suite::factsBytes(after);
    const auto kept = suite::factsFrom(bytes);
    QVERIFY(kept);
    QCOMPARE(suite::factsBytes(*kept), bytes);
    QVERIFY(kept->map->blocks == after.map->blocks);
    // Of 800 x 600 cells in blocks of 16 x 16; (400, 300) and (440, 300) are two blocks apart.
    QCOMPARE(after.map->blocks.edge, 16);
    QCOMPARE(
        wordsOf(before, *kept),
        (QStringList{QStringLiteral("cells of map Office changed within 0.80 x 0.80 m at (0.4, 0.2)"),
                     QStringLiteral("cells of map Office changed within 0.80 x 0.80 m at (2.0, 0.2)"),
                     QStringLiteral("cells of map Office changed within 0.80 x 0.80 m at (-14.8, -10.2)")}));
    const suite::Explanation why =
        suite::explained(differingAt({{400, 300, 1, 1}}), *after.view, suite::changesBetween(before, after));
    QCOMPARE(why.near[0],
             QStringList{QStringLiteral("cells of map Office changed within 0.80 x 0.80 m at (0.4, 0.2)")});
    QCOMPARE(why.somewhere + why.everywhere, QStringList());
    QCOMPARE(why.elsewhere.size(), 2);
  }
  void whatChangedNearOneOfManyClustersIsNotElsewhere() {
    const Facts before = withBlack({}), after = withBlack({{400, 300}});
    std::vector<compare::PixelBox> boxes(70, {10, 10, 1, 1});
    boxes.push_back({400, 300, 1, 1});
    const suite::Explanation why =
        suite::explained(differingAt(boxes), *after.view, suite::changesBetween(before, after));
    QCOMPARE(why.near.size(), std::size_t(71));
    QCOMPARE(why.near.back().size(), 1);
    QVERIFY(why.elsewhere.isEmpty());
  }
  void blocksThatTouchAreOnePlace() {
    QCOMPARE(
        wordsOf(withBlack({}), withBlack({{10, 10}, {20, 20}, {40, 30}})),
        QStringList{QStringLiteral("cells of map Office changed within 2.40 x 1.60 m at (-18.8, 14.2)")});
  }
  void cellsWithoutComparableBlocksHaveNoPlace() {
    const QStringList no_place{QStringLiteral("the cells of map Office changed")};
    Facts before = facts();  // as earlier versions kept them
    const Facts after = withBlack({{10, 10}});
    QCOMPARE(wordsOf(*suite::factsFrom(suite::factsBytes(before)), after), no_place);
    before.map->blocks = suite::CellBlocks(801, 600);
    QCOMPARE(wordsOf(before, after), no_place);
    before = withBlack({});
    before.map->resolution_m = 0.1;
    QCOMPARE(wordsOf(before, after).last(), no_place.first());
    for (const char* json :
         {R"({"size":[0,0],"edge":16,"rows":[]})", R"({"size":[16,16],"edge":16,"rows":["AA"]})",
          R"({"size":[2000000000,16],"edge":1,"rows":["AAAAAA"]})", "{}"})
      QVERIFY(!suite::blocksFrom(QJsonDocument::fromJson(json).object()).known());
  }
  void largeMapsKeepFewBlocks() {
    const suite::CellBlocks blocks(10'000, 10'000);
    QCOMPARE(blocks.edge, 256);
    QCOMPARE(blocks.sums.size(), std::size_t(1600));
  }

  void whatChangedNearAClusterIsItsCause() {
    Facts after = facts();
    after.submaps[{12, 3}].version = 9;
    after.submaps[{0, 1}].version = 2;
    after.overlays = suite::overlaysText({wallAt(12.8)});
    // Around (12.4, -3.1), and far from everything.
    const compare::Comparison made = differingAt({{638, 357, 20, 10}, {10, 590, 5, 5}});
    const suite::Explanation why = suite::explained(made, *after.view, suite::changesBetween(facts(), after));
    QCOMPARE(why.near[0], (QStringList{QStringLiteral("virtual wall W17 moved by 0.40 m"),
                                       QStringLiteral("submap 12-3 went from version 7 to 9")}));
    QCOMPARE(why.near[1], QStringList());
    QCOMPARE(why.elsewhere, QStringList{QStringLiteral("submap 0-1 went from version 1 to 2")});
    QCOMPARE(
        suite::explanationText(made, *after.view, why),
        QStringLiteral(
            "2 clusters, the largest 0.50 m² at (12.4, -3.1): virtual wall W17 moved by 0.40 m; submap "
            "12-3 went from version 7 to 9. 1 cluster: nothing known changed there. Elsewhere: submap 0-1 "
            "went from version 1 to 2."));
    const auto rows = suite::clusterRows(made, after.view, why);
    QCOMPARE(rows[0].near,
             QStringLiteral("virtual wall W17 moved by 0.40 m; submap 12-3 went from version 7 to 9"));
    QCOMPARE(rows[1].near, QStringLiteral("nothing that is known"));
  }
  void clustersOfWhichNothingIsKnownAreCounted() {
    Facts after = facts();
    after.overlays = suite::overlaysText({wallAt(12.8)});
    const auto textOf = [&](const std::vector<compare::PixelBox>& boxes) {
      const compare::Comparison made = differingAt(boxes);
      return suite::explanationText(
          made, *after.view, suite::explained(made, *after.view, suite::changesBetween(facts(), after)));
    };
    const std::vector<compare::PixelBox> boxes{{638, 357, 20, 10}, {10, 590, 6, 6}, {100, 590, 6, 6}};
    const QString wall = QStringLiteral(": virtual wall W17 moved by 0.40 m. ");
    const QString text = textOf(boxes);
    QVERIFY2(text.endsWith(wall + QStringLiteral("2 clusters: nothing known changed there.")),
             qPrintable(text));
    // What may be the cause of any of them is one of these, too.
    after.theme = "light";
    QVERIFY(!textOf(boxes).contains(QStringLiteral("nothing known")));
  }
  void namesBesidePointsAreAPartOfTheirPlace() {
    // Dock is drawn at (100, 240) in pixels; Gate stands near enough for its name to be pushed aside.
    const auto causeAt = [](const Facts& before, const Facts& after, int x, int y) {
      const compare::Comparison made = differingAt({{x, y, 6, 6}});
      return suite::explained(made, *after.view, suite::changesBetween(before, after)).near[0];
    };
    Facts before = facts(), after = facts();
    before.overlays.clear();
    after.overlays.clear();
    after.waypoints[0].name = "Dock 2";
    const QStringList renamed{QStringLiteral("waypoint Dock is called Dock 2 now")};
    QCOMPARE(causeAt(before, after, 140, 240), renamed);  // beside it
    QCOMPARE(causeAt(before, after, 100, 290), renamed);  // below, with a leader line
    QCOMPARE(causeAt(before, after, 50, 240), renamed);
    QCOMPARE(causeAt(before, after, 300, 240), QStringList());
    QCOMPARE(causeAt(before, after, 100, 340), QStringList());
    map::Waypoint gate;
    gate.id = "10";
    gate.name = "Gate";
    gate.position_m = {-7, 3};  // 160 px to the right
    before.waypoints.push_back(gate);
    after.waypoints.push_back(gate);
    QCOMPARE(causeAt(before, after, 300, 240), renamed);
    QCOMPARE(causeAt(before, after, 400, 240), QStringList());
    // A view that is turned by 90 degrees.
    before.view->rotation_rad = after.view->rotation_rad = M_PI / 2;
    const Eigen::Vector2d at = after.view->pixelFromWorld({-15, 3});
    QCOMPARE(causeAt(before, after, int(at.x()) + 60, int(at.y())), renamed);
    QCOMPARE(causeAt(before, after, int(at.x()), int(at.y()) + 100), QStringList());
  }
  void thatNothingChangedIsSaid() {
    const compare::Comparison made = differingAt({{10, 590, 6, 6}});
    const suite::Explanation why = suite::explained(made, *facts().view, {});
    QVERIFY(suite::explanationText(made, *facts().view, why)
                .endsWith(QStringLiteral("No fact that is kept of it changed.")));
  }
  void manyChangesAreCounted() {
    QStringList many;
    for (int i = 0; i < 30; ++i) many << QString::number(i);
    QCOMPARE(suite::firstChanges(many), QStringLiteral("0; 1; 2; 3 and 26 more"));
  }
};

}  // namespace test_suite_facts

MAPWRIGHT_TEST(test_suite_facts, SuiteFactsTest, Core)
#include "test_suite_facts.moc"
