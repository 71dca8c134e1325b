// The map view under real mouse, wheel and key events, and the measuring tool.
#include <QSignalSpy>
#include <QtTest>

#include "render/tile_renderer.h"
#include "test_program.h"
#include "ui/view/map_view.h"
#include "ui/view/measure_tool.h"

namespace test_window_view {

using namespace mapwright;
using namespace mapwright::ui;

namespace {

/// A view of 800 x 600 on an empty scene, at 5 cm a pixel around the origin, without animation.
struct Bench {
  explicit Bench(int animation_ms = 0) : scene({}), view(&scene) {
    view.setAnimationMs(animation_ms);
    view.resize(800, 600);
    view.show();
    (void)QTest::qWaitForWindowExposed(&view);
    geometry::ViewTransform camera = scene.view();
    camera.center_m = {0, 0};
    camera.scale_m_per_px = 0.05;
    view.moveTo(camera, false);
  }
  void wheel(const QPointF& at, int angle, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QWheelEvent event(at, view.viewport()->mapToGlobal(at), QPoint(), QPoint(0, angle), Qt::NoButton,
                      modifiers, Qt::NoScrollPhase, false);
    QApplication::sendEvent(view.viewport(), &event);
  }
  void drag(const QPoint& from, const QPoint& to, Qt::MouseButton button) {
    QTest::mousePress(view.viewport(), button, {}, from);
    for (const double part : {0.3, 0.7, 1.0}) {
      const QPoint at = from + (to - from) * part;
      QMouseEvent move(QEvent::MouseMove, at, view.viewport()->mapToGlobal(at), Qt::NoButton, button, {});
      QApplication::sendEvent(view.viewport(), &move);
    }
    QTest::mouseRelease(view.viewport(), button, {}, to);
  }
  void hover(const QPoint& at) {
    QMouseEvent move(QEvent::MouseMove, at, view.viewport()->mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(view.viewport(), &move);
  }
  const geometry::ViewTransform& camera() const { return scene.view(); }

  ui::scene::MapScene scene;
  MapView view;
};

bool near(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double within = 1e-9) {
  return (a - b).norm() < within;
}

}  // namespace

class TestWindowView : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void coversTheViewport() {
    Bench bench;
    QCOMPARE(bench.camera().width_px, 800);
    QCOMPARE(bench.camera().height_px, 600);
    bench.view.resize(640, 480);
    QCOMPARE(bench.camera().width_px, 640);
    QVERIFY(near(bench.camera().center_m, {0, 0}));  // the middle stays the middle
    QCOMPARE(bench.view.mapToScene(QPoint(17, 23)), QPointF(17, 23));
  }

  void wheelZoomsAtTheCursor() {
    Bench bench;
    const QPointF cursor(200, 150);
    const Eigen::Vector2d before = bench.view.worldAt(cursor);
    bench.wheel(cursor, 120);
    QCOMPARE(bench.camera().scale_m_per_px, 0.04);
    QVERIFY(near(bench.view.worldAt(cursor), before));
    bench.wheel(cursor, -240);
    QCOMPARE(bench.camera().scale_m_per_px, 0.0625);
    QVERIFY(near(bench.view.worldAt(cursor), before));
  }

  void ctrlWheelIsFineAndShiftWheelTurns() {
    Bench bench;
    const QPointF cursor(600, 450);
    const Eigen::Vector2d before = bench.view.worldAt(cursor);
    bench.wheel(cursor, 120, Qt::ControlModifier);
    QVERIFY(bench.camera().scale_m_per_px > 0.04 && bench.camera().scale_m_per_px < 0.05);
    QVERIFY(near(bench.view.worldAt(cursor), before));
    bench.wheel(cursor, 120, Qt::ShiftModifier);
    QVERIFY(bench.camera().rotation_rad != 0);
    QVERIFY(near(bench.view.worldAt(cursor), before));
  }

  void wheelIsHeldInItsLimits() {
    Bench bench;
    for (int i = 0; i < 200; ++i) bench.wheel({400, 300}, 1200);
    QCOMPARE(bench.camera().scale_m_per_px, geometry::kMinScaleMPerPx);
    for (int i = 0; i < 200; ++i) bench.wheel({400, 300}, -1200);
    QCOMPARE(bench.camera().scale_m_per_px, geometry::kMaxScaleMPerPx);
    QVERIFY(bench.camera().center_m.allFinite());
  }

  void animationEndsThereAndCanBeInterrupted() {
    Bench bench(40);
    const QPointF cursor(100, 500);
    const Eigen::Vector2d before = bench.view.worldAt(cursor);
    bench.wheel(cursor, 120);
    QVERIFY(bench.view.moving());
    bench.wheel(cursor, 120);  // a second notch while the first is on its way counts fully
    QTRY_VERIFY(!bench.view.moving());
    QCOMPARE(bench.camera().scale_m_per_px, 0.032);
    QVERIFY(near(bench.view.worldAt(cursor), before));
    bench.wheel(cursor, 120);
    QTest::mousePress(bench.view.viewport(), Qt::LeftButton, {}, {300, 300});
    QVERIFY(!bench.view.moving());
    QTest::mouseRelease(bench.view.viewport(), Qt::LeftButton, {}, {300, 300});
  }

  void dragsPan_data() {
    QTest::addColumn<Qt::MouseButton>("button");
    QTest::newRow("left") << Qt::LeftButton;
    QTest::newRow("middle") << Qt::MiddleButton;
  }
  void dragsPan() {
    QFETCH(Qt::MouseButton, button);
    Bench bench;
    QSignalSpy by_hand(&bench.view, &MapView::movedByHand);
    const Eigen::Vector2d held = bench.view.worldAt({300, 300});
    bench.drag({300, 300}, {400, 250}, button);
    QVERIFY(near(bench.view.worldAt({400, 250}), held));
    QVERIFY(near(bench.camera().center_m, {-5, -2.5}));
    QVERIFY(by_hand.size() > 0);
  }

  void dragsPanInATurnedView() {
    Bench bench;
    bench.view.setRotation(1.1);
    const Eigen::Vector2d held = bench.view.worldAt({300, 300});
    bench.drag({300, 300}, {350, 420}, Qt::LeftButton);
    QVERIFY(near(bench.view.worldAt({350, 420}), held));
  }

  void keysPan() {
    Bench bench;
    QTest::keyClick(&bench.view, Qt::Key_Right);
    QVERIFY(bench.camera().center_m.x() > 0);
    QCOMPARE(bench.camera().center_m.y(), 0.0);
    QTest::keyClick(&bench.view, Qt::Key_Left);
    QTest::keyClick(&bench.view, Qt::Key_Up);
    QVERIFY(near({0, bench.camera().center_m.y()}, bench.camera().center_m));
    QVERIFY(bench.camera().center_m.y() > 0);
  }

  void spaceDragPansEvenWhileMeasuring() {
    Bench bench;
    MeasureTool measure(&bench.scene);
    bench.view.setTool(&measure);
    QTest::keyPress(&bench.view, Qt::Key_Space);
    bench.drag({300, 300}, {302, 300}, Qt::LeftButton);  // shorter than a drag needs, but Space says drag
    QTest::keyRelease(&bench.view, Qt::Key_Space);
    QVERIFY(near(bench.camera().center_m, {-0.1, 0}));
    QVERIFY(measure.points().empty());
  }

  void doubleClickCentresAndZoomsIn() {
    Bench bench;
    const Eigen::Vector2d aim = bench.view.worldAt({200, 100});
    QTest::mouseDClick(bench.view.viewport(), Qt::LeftButton, {}, {200, 100});
    QVERIFY(near(bench.camera().center_m, aim));
    QVERIFY(bench.camera().scale_m_per_px < 0.05);
  }

  void fitsAndTurnsNorthUp() {
    Bench bench;
    bench.view.setRotation(0.7);
    QCOMPARE(bench.camera().rotation_rad, 0.7);
    const geometry::WorldRect rect{-20, -5, 60, 40};
    bench.view.fit(rect, false);
    QVERIFY(near(bench.camera().center_m, rect.center()));
    for (const Eigen::Vector2d& corner :
         {Eigen::Vector2d(-20, -5), Eigen::Vector2d(60, 40), Eigen::Vector2d(-20, 40)}) {
      const Eigen::Vector2d px = bench.camera().pixelFromWorld(corner);
      QVERIFY(px.x() >= 0 && px.x() <= 800 && px.y() >= 0 && px.y() <= 600);
    }
    bench.view.setRotation(0);
    QCOMPARE(bench.camera().rotation_rad, 0.0);
    bench.view.fit({}, false);  // nothing to fit changes nothing
    QVERIFY(near(bench.camera().center_m, rect.center()));
  }

  void tellsTheWorldUnderTheCursor() {
    Bench bench;
    bench.hover({400, 300});
    QVERIFY(bench.view.cursorWorld());
    QVERIFY(near(*bench.view.cursorWorld(), {0, 0}));
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(bench.view.viewport(), &leave);
    QVERIFY(!bench.view.cursorWorld());
  }

  void measuresAlongClicks() {
    Bench bench;
    MeasureTool measure(&bench.scene);
    QSignalSpy finished(&measure, &MapTool::finished);
    bench.view.setTool(&measure);
    QTest::mouseClick(bench.view.viewport(), Qt::LeftButton, {}, {400, 300});
    bench.hover({460, 300});  // 60 px of 5 cm
    QVERIFY2(measure.hint().contains(QStringLiteral("3 m, heading 0°")), qPrintable(measure.hint()));
    QTest::mouseClick(bench.view.viewport(), Qt::LeftButton, {}, {460, 300});
    QTest::mouseClick(bench.view.viewport(), Qt::LeftButton, {}, {460, 220});
    QCOMPARE(measure.points().size(), std::size_t(3));
    QVERIFY(std::abs(measure.total() - 7.0) < 1e-9);
    QTest::keyClick(&bench.view, Qt::Key_Backspace);
    QVERIFY(std::abs(measure.total() - 3.0) < 1e-9);
    QTest::keyClick(&bench.view, Qt::Key_Escape);
    QVERIFY(measure.ended());
    QVERIFY(measure.hint().contains(QLatin1String("Total 3 m")));
    bench.hover({700, 500});
    QVERIFY(measure.hint().contains(QLatin1String("Total 3 m")));  // an ended one stands still
    QCOMPARE(finished.size(), 0);
    QTest::keyClick(&bench.view, Qt::Key_Escape);
    QCOMPARE(finished.size(), 1);
    QTest::mouseClick(bench.view.viewport(), Qt::LeftButton, {}, {100, 100});
    QCOMPARE(measure.points().size(), std::size_t(1));  // a new one began
  }

  void aClickOnTheFirstPointClosesARingAndTellsItsArea() {
    Bench bench;
    MeasureTool measure(&bench.scene);
    bench.view.setTool(&measure);
    for (const QPoint& corner : {QPoint(400, 300), QPoint(460, 300), QPoint(460, 220)})
      QTest::mouseClick(bench.view.viewport(), Qt::LeftButton, {}, corner);
    bench.hover({403, 302});
    QVERIFY2(measure.hint().contains(QLatin1String("area")), qPrintable(measure.hint()));
    QTest::mouseClick(bench.view.viewport(), Qt::LeftButton, {}, {402, 301});
    QVERIFY(measure.closed());
    QVERIFY2(measure.hint().contains(QStringLiteral("Area 6.00 m², around it 12 m")),
             qPrintable(measure.hint()));
    QTest::keyClick(&bench.view, Qt::Key_Backspace);  // opens it again
    QVERIFY(!measure.closed());
    QCOMPARE(measure.points().size(), std::size_t(3));
  }

  void draggingWhileMeasuringSetsNoPoint() {
    Bench bench;
    MeasureTool measure(&bench.scene);
    bench.view.setTool(&measure);
    bench.drag({300, 300}, {360, 300}, Qt::LeftButton);
    QVERIFY(measure.points().empty());
    QVERIFY(near(bench.camera().center_m, {-3, 0}));
  }

  void asksForAMenuOnTheRight() {
    Bench bench;
    QSignalSpy wanted(&bench.view, &MapView::menuRequested);
    QContextMenuEvent event(QContextMenuEvent::Mouse, {50, 60},
                            bench.view.viewport()->mapToGlobal(QPoint(50, 60)));
    QApplication::sendEvent(bench.view.viewport(), &event);
    QCOMPARE(wanted.size(), 1);
    QCOMPARE(wanted[0][1].toPointF(), QPointF(50, 60));
  }
};

}  // namespace test_window_view

MAPWRIGHT_TEST(test_window_view, TestWindowView, Widgets)
#include "test_window_view.moc"
