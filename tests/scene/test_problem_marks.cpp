// Marks where something is missing on the map: in pixels, and what they answer.
#include <chrono>

#include <QImage>
#include <QPainter>
#include <QTest>

#include "fake_robot.h"
#include "map/live_topics.h"
#include "render/tile_renderer.h"
#include "session/session_options.h"
#include "test_program.h"
#include "ui/scene/map_scene.h"
#include "ui/scene/problem_marks.h"

namespace test_problem_marks {

using namespace mapwright;
using Outcome = map::SubmapAnswer::Outcome;
using session::Session;
using test::FakeRobot;
using ui::scene::Layer;
using ui::scene::MapScene;
using ui::scene::ProblemMark;

namespace {

map::SubmapList listOf(int count) {
  map::SubmapList list;
  list.uuid = "u";
  for (int i = 0; i < count; ++i) {
    map::SubmapEntry entry;
    entry.id = {0, i};
    entry.version = 1;
    entry.pose = geometry::poseFromYaw(0.2 + i, 0.2, 0);
    list.entries.push_back(entry);
  }
  return list;
}

}  // namespace

class ProblemMarksTest : public QObject {
  Q_OBJECT
  FakeRobot* robot_ = nullptr;
  std::unique_ptr<Session> session_;
  std::unique_ptr<MapScene> scene_;

  QImage painted() {
    QImage image(200, 200, QImage::Format_RGB32);
    QPainter painter(&image);
    scene_->render(&painter, QRectF(0, 0, 200, 200), QRectF(0, 0, 200, 200));
    return image;
  }
  bool isMarked(const Eigen::Vector2d& world_m) {
    scene_->setLayerVisible(Layer::Problems, true);
    const QImage with = painted();
    scene_->setLayerVisible(Layer::Problems, false);
    const QImage without = painted();
    scene_->setLayerVisible(Layer::Problems, true);
    const Eigen::Vector2d at = scene_->view().pixelFromWorld(world_m);
    const QRect around(int(at.x()) - 10, int(at.y()) - 10, 20, 20);
    return with.copy(around) != without.copy(around);
  }

 private Q_SLOTS:
  void init() {
    auto robot = std::make_unique<FakeRobot>();
    robot_ = robot.get();
    robot_->has_topics = robot_->has_maps = true;
    session_ = std::make_unique<Session>(std::move(robot), Session::Options{});
    robot_->setPhase(robot::ConnectionPhase::Online);
    render::TileRenderer::Options options;
    options.previews = false;
    scene_ = std::make_unique<MapScene>(options);
    for (const Layer layer : ui::scene::allLayers()) {
      scene_->setLayerVisible(
          layer, layer == Layer::Submaps || layer == Layer::Problems || layer == Layer::Overlays);
    }
    scene_->setView({{0, 0}, 0.01, 0, 200, 200});
    scene_->setSession(session_.get());
  }
  void cleanup() {
    scene_.reset();
    session_.reset();
  }

  void aMissingSubmapIsMarkedAtItsPlaceAndSaysWhy() {
    robot_->say(listOf(1));
    QVERIFY(!isMarked({0.2, 0.2}));  // it may still come
    robot_->answer(Outcome::NotFound);
    QTRY_VERIFY(isMarked({0.2, 0.2}));
    QVERIFY(!isMarked({-0.5, -0.5}));
    const auto found = scene_->problemMarksAt({0.22, 0.2}, 9);
    QCOMPARE(found.size(), std::size_t(1));
    QCOMPARE(found[0].title, QStringLiteral("Submap 0-0"));
    QVERIFY2(found[0].reason.contains(QStringLiteral("The robot said no.")), qPrintable(found[0].reason));
    QCOMPARE(found[0].at_m, Eigen::Vector2d(0.2, 0.2));
    QVERIFY(scene_->problemMarksAt({-0.5, 0.2}, 9).empty());
  }

  void aMarkGoesWhenThePictureComes() {
    robot_->say(listOf(1));
    QTRY_VERIFY(!robot_->open.empty());
    robot_->answer(Outcome::NotFound);
    QTRY_VERIFY(isMarked({0.2, 0.2}));
    map::SubmapList next = listOf(1);
    next.entries[0].version = 2;
    robot_->say(next);
    QTRY_VERIFY(!robot_->open.empty());
    robot_->answer(Outcome::Ok);
    QTRY_VERIFY(scene_->problemMarksAt({0.2, 0.2}, 9).empty());
    QVERIFY(!isMarked({0.2, 0.2}));
  }

  void brokenOnesAndThoseWithoutTheSliceAreMarked() {
    robot_->say(listOf(2));
    QTRY_COMPARE(robot_->open.size(), std::size_t(2));
    QCOMPARE(robot_->answer(Outcome::Ok, 0, 5, 400).id.index, 0);  // more cells than came
    robot_->answer(Outcome::Ok);
    scene_->setView({{0.7, 0.2}, 0.01, 0, 200, 200});
    QTRY_COMPARE(scene_->problemMarksAt({0.2, 0.2}, 9).size(), std::size_t(1));
    QVERIFY(isMarked({0.2, 0.2}));
    QVERIFY(scene_->problemMarksAt({1.1, 0.1}, 9).empty());
    session_->setSlice(3);
    // Its first slice tells where it lies: from its pose to the lower left.
    QTRY_COMPARE(scene_->problemMarksAt({1.05, 0.05}, 2).size(), std::size_t(1));
    QVERIFY(scene_->problemMarksAt({1.05, 0.05}, 2)[0].reason.contains(QLatin1Char('3')));
    scene_->setSlicesMarked(false);
    QVERIFY(scene_->problemMarksAt({1.05, 0.05}, 2).empty());
    QVERIFY(!isMarked({1.1, 0.1}));
  }

  void whereSubmapsAreNotShownTheirMarksAreNeither() {
    robot_->say(listOf(1));
    QTRY_VERIFY(!robot_->open.empty());
    robot_->answer(Outcome::NotFound);
    QTRY_VERIFY(isMarked({0.2, 0.2}));
    session_->setVisible({{0, 0}}, false);
    QTRY_VERIFY(!isMarked({0.2, 0.2}));
    session_->setVisible({{0, 0}}, true);
    QTRY_VERIFY(isMarked({0.2, 0.2}));
    scene_->setLayerVisible(Layer::Submaps, false);
    QVERIFY(!isMarked({0.2, 0.2}));
    QVERIFY(scene_->problemMarksAt({0.2, 0.2}, 9).empty());
    scene_->setLayerVisible(Layer::Submaps, true);
    scene_->setSession(nullptr);
    QVERIFY(!isMarked({0.2, 0.2}));
  }

  void anUnreadableOverlayIsMarkedWhereAPointOfItLies() {
    map::MapInfo info;
    info.broken_overlays = {{"7", "Hall <b>", fault::said("It is crooked."), Eigen::Vector2d(-0.4, 0.3)},
                            {"8", "", fault::said("It has no place."), std::nullopt}};
    robot_->say(info);
    QTRY_VERIFY(isMarked({-0.4, 0.3}));
    const auto found = scene_->problemMarksAt({-0.4, 0.3}, 9);
    QCOMPARE(found.size(), std::size_t(1));
    QVERIFY(found[0].title.contains(QStringLiteral("Hall <b>")));
    QCOMPARE(found[0].reason, QStringLiteral("It is crooked."));
    scene_->setLayerVisible(Layer::Overlays, false);
    QVERIFY(!isMarked({-0.4, 0.3}));
  }

  void aMapThatCannotBeLoadedIsMarkedWhereItWouldLie() {
    for (const Layer layer : {Layer::Submaps, Layer::WholeMap}) {
      scene_->setLayerVisible(layer, layer == Layer::WholeMap);
    }
    map::CatalogueEntry entry = FakeRobot::entry("7");
    entry.grid = map::GridReference{60, 60, 0.01, {-0.3, -0.3, 0}};
    robot_->answerList({entry});
    session_->openMap(entry.key);
    robot_->map_fetches.back().second(tl::make_unexpected(test::failed("no room")));
    QTRY_VERIFY(isMarked({0.2, 0.1}));
    QVERIFY(!isMarked({-0.8, -0.8}));
    const auto found = scene_->problemMarksAt({0.2, 0.1}, 9);
    QCOMPARE(found.size(), std::size_t(1));
    QVERIFY2(found[0].reason.contains(QStringLiteral("No room")), qPrintable(found[0].reason));
  }

  void aMapOfUnknownSizeIsMarkedWhereItsOriginLies() {
    for (const Layer layer : {Layer::Submaps, Layer::WholeMap}) {
      scene_->setLayerVisible(layer, layer == Layer::WholeMap);
    }
    map::CatalogueEntry entry = FakeRobot::entry("7");
    entry.grid = map::GridReference{0, 0, 0.01, {0.3, 0.3, 0}};  // as of a file whose picture is broken
    robot_->answerList({entry});
    session_->openMap(entry.key);
    robot_->map_fetches.back().second(tl::make_unexpected(test::failed("no picture")));
    QTRY_VERIFY(isMarked({0.3, 0.3}));
    QVERIFY(!isMarked({-0.3, -0.3}));
    QCOMPARE(scene_->problemMarksAt({0.32, 0.3}, 9).size(), std::size_t(1));
  }

  void aReferenceMapThatIsBrokenIsMarked() {
    QVERIFY(!isMarked({0.3, 0.3}));
    const map::GridReference grid{60, 60, 0.01, {0.3, 0.3, 0}};
    scene_->setReferenceTrouble(ui::scene::MapTrouble{
        ui::scene::gridCorners(grid), true, QStringLiteral("Plan"), QStringLiteral("It breaks off.")});
    QVERIFY(isMarked({0.6, 0.6}));
    const auto found = scene_->problemMarksAt({0.6, 0.6}, 9);
    QCOMPARE(found.size(), std::size_t(1));
    QCOMPARE(found[0].reason, QStringLiteral("It breaks off."));
    scene_->setReferenceTrouble(std::nullopt);
    QVERIFY(!isMarked({0.6, 0.6}) && scene_->problemMarksAt({0.6, 0.6}, 9).empty());
  }

  void aHundredThousandOfThemAreFoundByTheirPlace() {
    ui::scene::SubmapMarks marks;
    for (int i = 0; i < 100'000; ++i)
      marks.put({0, i}, {ui::scene::MarkKind::Missing, {double(i % 1'000), double(i / 1'000)}, {}});
    QCOMPARE(marks.size(), std::size_t(100'000));
    QVERIFY(!marks.within({0, 0, 1'000, 100}, 400));
    const auto some = marks.within({10.5, 10.5, 13.5, 12.5}, 400);
    QVERIFY(some);
    QCOMPARE(some->size(), std::size_t(6));
    QCOMPARE(some->front().first, (map::SubmapId{0, 11'011}));
    QVERIFY(marks.any({999, 99, 1'001, 101}));
    QVERIFY(!marks.any({999.5, 99.5, 1'001, 101}));
    QVERIFY(marks.remove({0, 99'999}));
    QVERIFY(!marks.remove({0, 99'999}));
    QVERIFY(!marks.any({998.5, 98.5, 1'001, 101}));
    QVERIFY(!marks.put({0, 0}, {ui::scene::MarkKind::Missing, {0, 0}, {}}));
    QVERIFY(marks.put({0, 0}, {ui::scene::MarkKind::Corrupt, {0, 0}, {}}));
  }

  void farAwayTheyAreSummedUpInSquares() {
    robot_->say(listOf(600));
    for (int i = 0; i < 600; ++i) {
      QTRY_VERIFY(!robot_->open.empty());
      robot_->answer(Outcome::NotFound);
    }
    scene_->setView({{300, 0}, 4, 0, 200, 200});
    QTRY_VERIFY(isMarked({300, 0}));
    QVERIFY(!isMarked({300, 300}));
  }
};

}  // namespace test_problem_marks

MAPWRIGHT_TEST(test_problem_marks, ProblemMarksTest, Widgets)
#include "test_problem_marks.moc"
