// A picture that is drawn from a session while a window shows the same session.
#include <QSignalSpy>
#include <QTest>

#include "../session/fake_robot.h"
#include "render/tile_renderer.h"
#include "session/session_options.h"
#include "test_program.h"
#include "ui/scene/map_theme.h"
#include "ui/shot/picture.h"

namespace test_scene_picture {

using namespace mapwright;
using test::FakeRobot;
using ui::scene::Layer;

namespace {

/// 20 x 20 cells, all free or all occupied.
map::SubmapAnswer square(const map::SubmapKey& key, bool occupied) {
  map::SubmapAnswer answer;
  answer.key = key;
  answer.outcome = map::SubmapAnswer::Outcome::Ok;
  answer.version = key.version;
  map::RawSlice slice;
  slice.width = slice.height = 20;
  slice.resolution_m = 0.05;
  for (int i = 0; i < 400; ++i) slice.cells += occupied ? std::string{'\0', 100} : std::string{100, '\0'};
  answer.slices = {slice};
  return answer;
}

}  // namespace

class ScenePictureTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whatTheWindowAsksForStaysAsked() {
    auto robot = std::make_unique<FakeRobot>();
    FakeRobot& asked = *robot;
    asked.has_topics = true;
    session::Session session(std::move(robot), {});
    session.open();
    asked.setPhase(robot::ConnectionPhase::Online);
    ui::scene::MapScene on_screen(render::TileRenderer::Options{});
    on_screen.setLayersVisible({Layer::Path});
    on_screen.setSession(&session);
    QTRY_VERIFY(asked.wanted.contains(QStringLiteral("/path")));

    ui::shot::Look look;
    look.view.width_px = 64;
    look.view.height_px = 48;
    look.layers = {Layer::Grid};
    ui::shot::ScenePicture picture(look, session, std::make_shared<work::Workers>(1));
    QSignalSpy finished(&picture, &ui::shot::Picture::finished);
    picture.start();
    QTRY_VERIFY(!finished.isEmpty());
    QCOMPARE(picture.image().size(), QSize(64, 48));
    QVERIFY(asked.wanted.contains(QStringLiteral("/path")));
  }

  void disagreementIsLookedForBeforeItIsDrawn_data() {
    QTest::addColumn<Layer>("layer");
    QTest::newRow("disagreement") << Layer::Disagreement;
    QTest::newRow("coverage") << Layer::Coverage;
  }
  void disagreementIsLookedForBeforeItIsDrawn() {
    QFETCH(Layer, layer);
    auto robot = std::make_unique<FakeRobot>();
    FakeRobot& asked = *robot;
    session::Session session(std::move(robot), {});
    session.open();
    asked.setPhase(robot::ConnectionPhase::Online);
    map::SubmapList list;
    list.uuid = "u";
    for (int i = 0; i < 2; ++i) {
      map::SubmapEntry entry;
      entry.id = {0, i};
      entry.version = 1;
      entry.pose = geometry::poseFromYaw(0.5 + 0.5 * i, 0.5, 0);
      list.entries.push_back(entry);
    }
    asked.say(list);
    for (int i = 0; i < 2; ++i) {
      QTRY_VERIFY(!asked.open.empty());
      const auto [key, reply] = asked.open.front();
      asked.open.erase(asked.open.begin());
      reply(square(key, key.id.index == 1));
    }
    QTRY_COMPARE(session.counts().shown, 2);
    ui::shot::Look look;
    look.view = {{0.25, 0}, 0.025, 0, 80, 60};
    look.layers = {Layer::Submaps};
    const auto drawn = [&](int threads) {
      ui::shot::ScenePicture picture(look, session, std::make_shared<work::Workers>(threads));
      QSignalSpy finished(&picture, &ui::shot::Picture::finished);
      picture.start();
      return QTest::qWaitFor([&] { return !finished.isEmpty(); }) ? picture.image() : QImage();
    };
    const QImage without = drawn(1);
    look.layers.insert(layer);
    const QImage image = drawn(1);
    QCOMPARE(drawn(4), image);
    // 0-0 covers x -0.5 .. 0.5, 0-1 from 0 on: they contradict where they overlap.
    QCOMPARE(image.pixel(2, 30), without.pixel(2, 30));
    QVERIFY(image.pixel(40, 30) != without.pixel(40, 30));
    if (layer == Layer::Disagreement) {
      QCOMPARE(image.pixel(40, 30), ui::scene::lightMapTheme().bad.rgb());
      QCOMPARE(image.pixel(20, 30), without.pixel(20, 30));
    }
  }
};

}  // namespace test_scene_picture

MAPWRIGHT_TEST(test_scene_picture, ScenePictureTest, Widgets)
#include "test_scene_picture.moc"
