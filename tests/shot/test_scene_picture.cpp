// A picture that is drawn from a session while a window shows the same session.
#include <QSignalSpy>
#include <QTest>

#include "../session/fake_robot.h"
#include "shot/picture.h"
#include "test_program.h"

namespace test_scene_picture {

using namespace mapwright;
using scene::Layer;
using test::FakeRobot;

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
    scene::MapScene on_screen(render::TileRenderer::Options{});
    on_screen.setLayersVisible({Layer::Path});
    on_screen.setSession(&session);
    QTRY_VERIFY(asked.wanted.contains(QStringLiteral("/path")));

    shot::Look look;
    look.view.width_px = 64;
    look.view.height_px = 48;
    look.layers = {Layer::Grid};
    shot::ScenePicture picture(look, session, std::make_shared<work::Workers>(1));
    QSignalSpy finished(&picture, &shot::Picture::finished);
    picture.start();
    QTRY_VERIFY(!finished.isEmpty());
    QCOMPARE(picture.image().size(), QSize(64, 48));
    QVERIFY(asked.wanted.contains(QStringLiteral("/path")));
  }
};

}  // namespace test_scene_picture

MAPWRIGHT_TEST(test_scene_picture, ScenePictureTest, Widgets)
#include "test_scene_picture.moc"
