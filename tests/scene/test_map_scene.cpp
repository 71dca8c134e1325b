// What the scene paints for a session, in pixels.
#include <cmath>

#include <QImage>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>

#include "fake_robot.h"
#include "map/live_topics.h"
#include "render/tile_colors.h"
#include "render/tile_renderer.h"
#include "session/session_options.h"
#include "test_program.h"
#include "ui/scene/map_scene.h"
#include "ui/scene/map_theme.h"

namespace test_map_scene {

using namespace mapwright;
using Outcome = map::SubmapAnswer::Outcome;
using session::Session;
using test::FakeRobot;
using ui::scene::Layer;
using ui::scene::MapScene;

namespace {

/// A submap whose 4 x 4 cells of 0.05 m cover x -0.2..0 and y -0.2..0 of its pose.
map::SubmapEntry entry(int index, int version, double x, double y) {
  map::SubmapEntry e;
  e.id = {0, index};
  e.version = version;
  e.pose = geometry::poseFromYaw(x, y, 0);
  return e;
}

map::SubmapList listOf(std::vector<map::SubmapEntry> entries, const std::string& uuid = "u") {
  map::SubmapList list;
  list.uuid = uuid;
  list.entries = std::move(entries);
  return list;
}

constexpr QRgb kUnknown = 0xff778899;

}  // namespace

class MapSceneTest : public QObject {
  Q_OBJECT
 private:
  FakeRobot* robot_ = nullptr;
  std::unique_ptr<Session> session_;
  std::unique_ptr<MapScene> scene_;

  QImage painted() {
    QImage image(100, 100, QImage::Format_RGB32);
    QPainter painter(&image);
    scene_->render(&painter, QRectF(0, 0, 100, 100), QRectF(0, 0, 100, 100));
    return image;
  }
  /// One pixel a centimetre, the world's origin in the middle; the submap at (0.2, 0.2) covers
  /// (50..70, 30..50).
  void showOneSubmap(char value = 127) {
    robot_->say(listOf({entry(0, 1, 0.2, 0.2)}));
    robot_->answer(Outcome::Ok, 0, value);
    QTRY_VERIFY(session_->counts().shown == 1 && scene_->renderer().settled());
  }

 private Q_SLOTS:
  void init() {
    auto robot = std::make_unique<FakeRobot>();
    robot_ = robot.get();
    session_ = std::make_unique<Session>(std::move(robot), Session::Options{});
    robot_->setPhase(robot::ConnectionPhase::Online);
    render::TileRenderer::Options options;
    options.previews = false;
    scene_ = std::make_unique<MapScene>(options);
    for (const Layer layer : ui::scene::allLayers()) scene_->setLayerVisible(layer, layer == Layer::Submaps);
    scene_->setView({{0, 0}, 0.01, 0, 100, 100});
    scene_->setSession(session_.get());
  }
  void cleanup() {
    scene_.reset();
    session_.reset();
  }

  void anEmptySceneShowsTheColourOfTheUnknown() {
    QVERIFY(scene_->renderer().settled());
    QCOMPARE(painted().pixel(10, 10), kUnknown);
  }

  void aSubmapLiesWhereItsPoseSays() {
    showOneSubmap();
    const QImage image = painted();
    QCOMPARE(image.pixel(60, 40), 0xffffffff);
    QCOMPARE(image.pixel(40, 40), kUnknown);
    QCOMPARE(image.pixel(60, 60), kUnknown);
    QCOMPARE(*scene_->occupancyAt({0.1, 0.1}), 0);
    QVERIFY(!scene_->occupancyAt({-0.2, 0.1}));
  }

  void coloursByClassAskForNothingAndComposeNothing() {
    showOneSubmap();
    const auto composed = scene_->renderer().counts().composed;
    using render::ColorMode;
    const auto colorOf = [](ColorMode mode, int of) { return render::classColors(mode)[std::size_t(of)]; };
    for (const auto& [mode, expected] : {std::pair(ColorMode::Trajectory, colorOf(ColorMode::Trajectory, 0)),
                                         std::pair(ColorMode::Age, colorOf(ColorMode::Age, 0)),
                                         std::pair(ColorMode::Version, colorOf(ColorMode::Version, 0)),
                                         std::pair(ColorMode::Normal, std::uint32_t(0xffffffff))}) {
      scene_->setColorMode(mode);
      QVERIFY(scene_->settled());
      QCOMPARE(painted().pixel(60, 40), expected);
      QCOMPARE(painted().pixel(40, 40), kUnknown);
    }
    QCOMPARE(scene_->renderer().counts().composed, composed);
    QVERIFY(robot_->open.empty());
  }

  void theLegendNamesTheTrajectories() {
    scene_->setColorMode(render::ColorMode::Trajectory);
    const auto texts = [this] {
      QStringList all;
      for (const auto& section : scene_->legend(1)) {
        for (const auto& row : section.rows) all << row.text;
      }
      return all.join(QLatin1Char(';'));
    };
    QCOMPARE(texts(), QStringLiteral("Occupied;Unknown"));
    QSignalSpy changed(scene_.get(), &MapScene::layersChanged);
    auto second = entry(0, 1, 0.2, 0.2), third = second;
    second.id.trajectory = 3;
    third.id.trajectory = 11;
    robot_->say(listOf({entry(0, 1, 0.2, 0.2), second, third}));
    QTRY_COMPARE(texts(), QStringLiteral("Trajectory 0;Trajectories 3, 11;Occupied;Unknown"));
    QVERIFY(!changed.isEmpty());
    scene_->setColorMode(render::ColorMode::Version);
    QCOMPARE(texts(), QStringLiteral(";Version unknown;Occupied;Unknown"));
  }

  void aNewSubmapRecoloursOthersOnlyWhenTheirTrajectoryHasDoubled() {
    std::vector<map::SubmapEntry> entries{entry(4, 1, 0.2, 0.2)};
    robot_->say(listOf(entries));
    robot_->answer(Outcome::Ok, 0, 127);
    scene_->setColorMode(render::ColorMode::Age);
    QTRY_VERIFY(session_->counts().shown == 1 && scene_->renderer().settled());
    const auto colorOf = [](int age) {
      return render::classColors(render::ColorMode::Age)[std::size_t(age)];
    };
    const auto composed = scene_->renderer().counts().composed;
    for (int newest = 5; newest < 8; ++newest) {
      entries.push_back(entry(newest, 1, 100, 100));
      robot_->say(listOf(entries));
      QTRY_VERIFY(scene_->renderer().settled());
      QCOMPARE(painted().pixel(60, 40), colorOf(4));
    }
    QCOMPARE(scene_->renderer().counts().composed, composed);
    entries.push_back(entry(8, 1, 100, 100));
    robot_->say(listOf(entries));
    QTRY_COMPARE(painted().pixel(60, 40), colorOf(2));
  }

  void aMovedPoseMovesThePicture() {
    showOneSubmap();
    robot_->say(listOf({entry(0, 1, 0.2, -0.1)}));
    QTRY_VERIFY(scene_->renderer().settled());
    QCOMPARE(painted().pixel(60, 40), kUnknown);
    QCOMPARE(painted().pixel(60, 70), 0xffffffff);
  }

  void hiddenAndRemovedSubmapsAreNotPainted() {
    showOneSubmap();
    session_->setVisible({{0, 0}}, false);
    QTRY_VERIFY(scene_->renderer().settled());
    QCOMPARE(painted().pixel(60, 40), kUnknown);
    session_->setVisible({{0, 0}}, true);
    QTRY_VERIFY(scene_->renderer().settled());
    QCOMPARE(painted().pixel(60, 40), 0xffffffff);
    robot_->say(listOf({}));
    QTRY_VERIFY(scene_->renderer().settled());
    QCOMPARE(painted().pixel(60, 40), kUnknown);
  }

  void aNewSlamSessionClearsTheMap() {
    showOneSubmap();
    robot_->say(listOf({entry(0, 1, 0.2, 0.2)}, "v"));
    QTRY_VERIFY(scene_->renderer().settled());
    QCOMPARE(painted().pixel(60, 40), kUnknown);
  }

  void aSceneJoinsASessionThatAlreadyHasPictures() {
    scene_->setSession(nullptr);
    robot_->say(listOf({entry(0, 1, 0.2, 0.2)}));
    robot_->answer(Outcome::Ok, 0, 127);
    QTRY_COMPARE(session_->counts().shown, 1);
    scene_->setSession(session_.get());
    QTRY_VERIFY(scene_->renderer().settled());
    QCOMPARE(painted().pixel(60, 40), 0xffffffff);
  }

  void aSliceThatIsNotThereShowsNothing() {
    showOneSubmap();
    session_->setSlice(3);
    QTRY_VERIFY(scene_->renderer().settled());
    QCOMPARE(painted().pixel(60, 40), kUnknown);
  }

  void theNamesOfAHighlightedSubmapAndOfAClosureAreReadInBothThemes_data() {
    QTest::addColumn<bool>("closure");
    QTest::newRow("submap") << false;
    QTest::newRow("closure") << true;
  }
  void theNamesOfAHighlightedSubmapAndOfAClosureAreReadInBothThemes() {
    QFETCH(bool, closure);
    // Relative luminance as in WCAG 2.
    const auto luminance = [](const QColor& color) {
      const auto linear = [](double part) {
        return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
      };
      return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
    };
    showOneSubmap();
    session_->setVisible({{0, 0}}, false);
    for (const bool dark : {false, true}) {
      const ui::scene::MapTheme theme = dark ? ui::scene::darkMapTheme() : ui::scene::lightMapTheme();
      scene_->setTheme(theme);
      if (!closure) scene_->setHighlighted({{0, 0}});
      ui::scene::MapObject object;
      object.id.layer = Layer::Closures;
      object.form = ui::scene::ObjectForm::Line;
      object.parts = {{{0, 0}, {0.1, 0}}};
      if (closure) scene_->setMarked(object);
      QTRY_VERIFY(scene_->settled());
      const QImage image = painted();
      // The lines of the frame are less bright, or less dark, than the letters.
      double letters = luminance(theme.accent);
      for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
          const double pixel = luminance(image.pixelColor(x, y));
          letters = dark ? std::max(letters, pixel) : std::min(letters, pixel);
        }
      }
      const double halo = luminance(theme.text_halo);
      QVERIFY((std::max(letters, halo) + 0.05) / (std::min(letters, halo) + 0.05) >= (dark ? 4.5 : 5.5));
    }
  }

  void theIdOfAHighlightedSubmapIsNotUnderTheLineOfAClosure() {
    showOneSubmap();
    session_->setVisible({{0, 0}}, false);
    scene_->setView({{0.1, 0.1}, 0.001, 0, 400, 400});  // the frame has 200 pixels
    const auto shot = [&](bool framed, bool marked) {
      scene_->setHighlighted(framed ? std::set<map::SubmapId>{{0, 0}, {9, 9}} : std::set<map::SubmapId>());
      std::optional<ui::scene::MapObject> closure;
      if (marked) {
        closure.emplace();
        closure->id.layer = Layer::Closures;
        closure->form = ui::scene::ObjectForm::Line;
        closure->parts = {{{0.06, 0.1}, {0.14, 0.1}}};
      }
      scene_->setMarked(closure);
      QImage image(400, 400, QImage::Format_RGB32);
      QPainter painter(&image);
      const QRectF whole(0, 0, 400, 400);
      scene_->render(&painter, whole, whole);
      return image;
    };
    const auto letters = [](const QImage& a, const QImage& b) {
      int differ = 0;
      for (int y = 108; y < 292; ++y)
        for (int x = 108; x < 292; ++x) differ += a.pixel(x, y) != b.pixel(x, y);
      return differ;
    };
    const int alone = letters(shot(true, false), shot(false, false));
    QVERIFY(alone > 50);
    QCOMPARE(letters(shot(true, true), shot(false, true)), alone);
  }

  void theTopmostVisibleSubmapIsPicked() {
    robot_->say(listOf({entry(0, 1, 0.2, 0.2), entry(1, 1, 0.25, 0.25)}));
    robot_->answer(Outcome::Ok);
    robot_->answer(Outcome::Ok);
    QTRY_COMPARE(session_->counts().shown, 2);
    QCOMPARE(scene_->submapAt({0.1, 0.1})->index, 1);
    session_->setVisible({{0, 1}}, false);
    QCOMPARE(scene_->submapAt({0.1, 0.1})->index, 0);
    QVERIFY(!scene_->submapAt({-0.4, 0}));
  }

  void theRobotStandsOnItsPose() {
    scene_->setLayerVisible(Layer::Robot, true);
    QCOMPARE(painted().pixel(20, 80), kUnknown);
    robot_->say(map::TrackedPose{{-0.3, -0.3, 0.5}});
    QCOMPARE(painted().pixel(20, 80), scene_->theme().robot.rgb());
  }

  void layersCanBeHiddenAndFaded() {
    showOneSubmap();
    scene_->setLayerVisible(Layer::Submaps, false);
    QCOMPARE(painted().pixel(60, 40), kUnknown);
    scene_->setLayerVisible(Layer::Submaps, true);
    scene_->setLayerOpacity(Layer::Submaps, 0.5);
    const QRgb faded = painted().pixel(60, 40);
    QVERIFY(qRed(faded) > 0x77 + 30 && qRed(faded) < 0xff - 30);
  }

  void theViewInAWindowTellsTheSessionWhatIsLookedAt_data() {
    QTest::addColumn<bool>("in_window");
    QTest::addColumn<int>("asked_first");
    QTest::newRow("in a window") << true << 5;
    QTest::newRow("for a picture") << false << 0;
  }
  void theViewInAWindowTellsTheSessionWhatIsLookedAt() {
    QFETCH(bool, in_window);
    render::TileRenderer::Options options;
    options.previews = in_window;
    scene_ = std::make_unique<MapScene>(options);
    scene_->setSession(session_.get());
    robot_->say(listOf({}));
    scene_->setView({{50, 0}, 0.01, 0, 100, 100});
    std::vector<map::SubmapEntry> entries;
    for (int i = 0; i < 10; ++i) entries.push_back(entry(i, 1, i * 10, 0));
    robot_->say(listOf(entries));
    QTEST(robot_->asked.at(0).id.index, "asked_first");
  }

  void namesOfLayersAreThoseOfTheCommandLine() {
    const QStringList expected =
        QStringLiteral(
            "reference whole regions submaps incremental match symmetry costmap costmap-high "
            "dispatched-cloud coverage disagreement walls-off problems grid overlays waypoints "
            "landmarks doors boxes constraints closures outlines ids trajectory path local-path "
            "target cloud robots trail track expanded-footprint footprint robot scalebar")
            .split(QLatin1Char(' '));
    // One by one: of two lists Qt says only that one is longer.
    qsizetype at = 0;
    for (const Layer layer : ui::scene::allLayers())
      QCOMPARE(ui::scene::layerName(layer), expected.value(at++));
    QCOMPARE(at, expected.size());
  }

  void aSceneMayOutliveNothingAndBeTakenDownInAnyOrder() {
    showOneSubmap();
    scene_->setSession(nullptr);
    session_.reset();
    QCOMPARE(painted().pixel(60, 40), kUnknown);
  }
};

}  // namespace test_map_scene

MAPWRIGHT_TEST(test_map_scene, MapSceneTest, Widgets)
#include "test_map_scene.moc"
