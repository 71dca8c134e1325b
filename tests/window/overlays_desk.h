// A window on a simulated robot that holds three overlays, and somebody else who changes them.
#pragma once

#include <QLineEdit>
#include <QPushButton>
#include <QtTest>

#include "overlays/overlay_shapes.h"
#include "robot/axbot/axbot_address.h"
#include "robot/axbot/axbot_robot.h"
#include "robot/overlay_store.h"
#include "sentences/failure_sentence.h"
#include "simulator/simulator.h"
#include "ui/overlays/overlay_review.h"
#include "ui/overlays/overlay_text.h"
#include "ui/overlays/overlay_tool.h"
#include "ui/overlays/overlays_controller.h"
#include "ui/overlays/overlays_dock.h"
#include "ui/overlays/overlays_model.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/toast_stack.h"
#include "ui/window/main_window.h"
#include "window_parts.h"

namespace test_overlays_desk {

using namespace mapwright;
using namespace mapwright::ui;

inline constexpr const char* kOverlays =
    R"({"type":"FeatureCollection", "future": 1.50, "features":[
{"id":"w1","type":"Feature","geometry":{"type":"LineString","coordinates":[[0.00,0],[4,0]]},"properties":{"lineType":"2","name":"W17"}},
{"id":"r1","type":"Feature","geometry":{"type":"Polygon","coordinates":[[[1,2],[3,2],[3,4],[1,4],[1,2]]]},"properties":{"regionType":2,"name":"Lab","speed":0.40}},
{"id":"p1","type":"Feature","geometry":{"type":"Point","coordinates":[-2,1,0.5]},"properties":{"type":"25","yaw":"90","name":"Desk"}}]})";

struct Desk {
  explicit Desk(simulator::Options options = Desk::options())
      : settings(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat), sim(std::move(options)) {
    if (sim.start()) qFatal("no simulator");
    other = makeRobot();
    QVERIFY(hand(kOverlays));
  }
  virtual ~Desk() { window.reset(); }
  /// What the window is connected to.
  virtual QString address() const { return QString::fromStdString(sim.address()); }
  virtual robot::Addresses schemes() const { return robot::Addresses({robot::axbot::addressScheme()}); }
  virtual std::unique_ptr<robot::Robot> shown() { return makeRobot(); }
  static simulator::Options options() {
    simulator::Options options;
    options.paused = true;
    return options;
  }
  std::unique_ptr<robot::Robot> makeRobot() {
    robot::axbot::LinkOptions link;
    link.base = QUrl(QStringLiteral("http://127.0.0.1:%1").arg(sim.port()));
    return std::make_unique<robot::axbot::AxbotRobot>(QString::fromStdString(sim.address()), link);
  }

  /// Somebody else replaces the overlays of a map.
  bool hand(const std::string& text, const char* map = "1") {
    std::optional<bool> done;
    other->overlayStore()->write(
        {map::MapKind::Stored, map}, text, [&](robot::Outcome<std::monostate> outcome) {
          done = bool(outcome);
          if (!outcome) qWarning("not written: %s", sentences::sentenceOf(outcome.error()).c_str());
        });
    return QTest::qWaitFor([&] { return done.has_value(); }) && *done;
  }
  /// What the robot holds.
  std::string held(const char* map = "1") {
    std::optional<std::string> text;
    other->overlayStore()->read({map::MapKind::Stored, map}, [&](robot::Outcome<robot::OverlayText> outcome) {
      text = outcome ? outcome->text : std::string();
    });
    (void)QTest::qWaitFor([&] { return text.has_value(); });
    return text.value_or("");
  }
  /// The text that the robot held at first, with `from` replaced.
  static std::string with(const std::string& from, const std::string& to) {
    std::string text = kOverlays;
    const auto at = text.find(from);
    if (at == std::string::npos) qFatal("no %s", from.c_str());
    return text.replace(at, from.size(), to);
  }

  void start(bool usable = true) {
    window.reset();
    MainWindow::Dependencies wanted{
        [this](const QString&, const QByteArray&) -> tl::expected<std::unique_ptr<robot::Robot>, QString> {
          return shown();
        },
        settings};
    wanted.addresses = schemes();
    if (keeps_versions) wanted.overlays_history = history();
    if (keeps_drafts) wanted.edit.drafts_folder = folder.filePath(QStringLiteral("drafts"));
    window = std::make_unique<MainWindow>(std::move(wanted));
    window->resize(1900, 1050);
    window->show();
    window->view()->setAnimationMs(0);
    (void)QTest::qWaitForWindowActive(window.get());
    QVERIFY(!window->connectTo(address()));
    if (usable) QTRY_VERIFY(action("overlayTool")->isEnabled());
  }
  /// Where versions are kept.
  std::string history() const { return folder.filePath(QStringLiteral("overlays.sqlite")).toStdString(); }
  /// The tool is in the hand, with 50 pixels a metre.
  void open() {
    start();
    QTest::keyClick(window->view(), Qt::Key_E);
    QCOMPARE(window->view()->tool(), static_cast<MapTool*>(control().tool()));
    QTRY_VERIFY(editing().isOpen());
    QTRY_COMPARE(document().size(), std::size_t(3));
    QCoreApplication::processEvents();  // the dock has opened
    look();
  }
  void look() {
    geometry::ViewTransform camera = window->mapScene()->view();
    camera.center_m = {1, 1};
    camera.scale_m_per_px = 0.02;
    camera.rotation_rad = 0;
    window->view()->moveTo(camera, false);
  }

  OverlaysController& control() { return *part<OverlaysController>(*window); }
  edit::OverlayEditing& editing() { return *control().editing(); }
  const overlays::EditingDocument& document() { return editing().document(); }
  OverlaysDock& dock() { return *control().dock(); }
  QAction* action(const char* id) { return window->actionList().find(QLatin1String(id)); }
  QStringList toasts() { return part<MapOverlay>(*window)->toasts()->texts(); }
  bool says(const char* part_of_it) {
    return toasts().join(QLatin1Char('\n')).contains(QLatin1String(part_of_it));
  }
  QWidget* map() { return window->view()->viewport(); }
  QPoint px(double x, double y) {
    const Eigen::Vector2d at = window->mapScene()->view().pixelFromWorld({x, y});
    return {qRound(at.x()), qRound(at.y())};
  }
  void moveTo(const QPoint& at, bool pressed = true) {
    QMouseEvent move(QEvent::MouseMove, at, map()->mapToGlobal(at), Qt::NoButton,
                     pressed ? Qt::LeftButton : Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(map(), &move);
  }
  void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers keys = {}) {
    QTest::mousePress(map(), Qt::LeftButton, keys, from);
    moveTo((from + to) / 2);
    moveTo(to);
    QTest::mouseRelease(map(), Qt::LeftButton, keys, to);
  }
  void click(const QPoint& at, Qt::KeyboardModifiers keys = {}) {
    QTest::mouseClick(map(), Qt::LeftButton, keys, at);
  }
  void key(Qt::Key key, Qt::KeyboardModifiers keys = {}) { QTest::keyClick(window->view(), key, keys); }
  std::string coordinates(FeatureKey key) { return std::string(editing().find(key)->coordinates()->text()); }
  std::vector<Eigen::Vector2d> points(FeatureKey key) {
    return overlays::verticesOf(*editing().find(key)).at(0);
  }
  QString stateOf(FeatureKey key) {
    return dock().model()->indexOf(key).siblingAtColumn(OverlaysModel::StateColumn).data().toString();
  }
  void type(QLineEdit* edit, const char* text) {
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, QLatin1String(text));
    QTest::keyClick(edit, Qt::Key_Return);
  }
  /// Up to the review.
  void review() {
    action("save")->trigger();
    QTRY_VERIFY(control().review());
  }
  void save() {
    review();
    QTest::mouseClick(control().review()->saveButton(), Qt::LeftButton);
    QTRY_VERIFY(!control().busy() && !control().review());
  }

  QTemporaryDir folder;
  QSettings settings;
  simulator::Simulator sim;
  std::unique_ptr<robot::Robot> other;
  std::unique_ptr<MainWindow> window;
  bool keeps_drafts = false, keeps_versions = false;
};

}  // namespace test_overlays_desk
