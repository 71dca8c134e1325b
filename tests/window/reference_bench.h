// A window on a robot with a reference map laid under what it shows, for tests.
#pragma once

#include <array>

#include <QPushButton>
#include <QtTest>

#include "ui/maps/maps_controller.h"
#include "ui/maps/reference_controller.h"
#include "ui/maps/reference_dock.h"
#include "window_bench.h"

namespace mapwright::test {

using ui::MapsController;
using ui::part;
using ui::ReferenceController;
using ui::ReferenceDock;

inline const QString kFile = QStringLiteral("file:/maps/plan.yaml");

/// Free ground and walls, row by row from the top: 16 x 12 m.
struct Site {
  static constexpr double kCell_m = 0.05;
  int width = 320, height = 240;
  std::string cells = std::string(std::size_t(width) * std::size_t(height), char(254));

  void wall(int left, int top, int right, int bottom) {
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x) cells[std::size_t(y * width + x)] = 0;
  }
  /// Half a turn looks the same, a mirror image does not.
  static Site halves() {
    Site site = room();
    for (const auto& [left, top, right, bottom] :
         {std::array{110, 0, 113, 95}, {40, 180, 70, 200}, {20, 30, 32, 75}, {113, 60, 140, 63}}) {
      site.wall(left, top, right, bottom);
      site.wall(320 - right, 240 - bottom, 320 - left, 240 - top);
    }
    return site;
  }
  static Site room() {
    Site site;
    site.wall(0, 0, 320, 3);
    site.wall(0, 237, 320, 240);
    site.wall(0, 0, 3, 240);
    site.wall(317, 0, 320, 240);
    return site;
  }
  static Site rooms() {
    Site site = room();
    site.wall(110, 0, 113, 95);
    site.wall(110, 125, 113, 240);
    site.wall(110, 150, 230, 153);
    site.wall(250, 60, 320, 63);
    site.wall(200, 0, 203, 40);
    site.wall(40, 180, 70, 200);
    site.wall(150, 60, 165, 90);
    site.wall(270, 200, 290, 215);
    site.wall(20, 30, 32, 75);
    return site;
  }
  /// By a quarter, counter-clockwise around its lower left corner, then 12 m to the right: it is back where
  /// it was with {0, 12, -90 degrees}.
  Site turned() const {
    Site out;
    out.width = height;
    out.height = width;
    for (int y = 0; y < out.height; ++y)
      for (int x = 0; x < out.width; ++x)
        out.cells[std::size_t(y * out.width + x)] = cells[std::size_t(x * width + (width - 1 - y))];
    return out;
  }
  map::WholeMap map(const map::MapKey& key) const {
    map::WholeMap made = wholeMap(key, "Map", 1, 1);
    made.bytes = std::make_shared<const std::string>("P5\n" + std::to_string(width) + " " +
                                                     std::to_string(height) + "\n255\n" + cells);
    return made;
  }
};

inline const geometry::Pose2 kTurnedBack{0, 12, -geometry::radiansFromDegrees(90)};

struct ReferenceBench : Bench {
  ReferenceBench() {
    prepare = [](FakeRobot& made) { made.has_catalogue = true; };
  }
  /// The robot shows `site`, and `reference` is laid.
  MainWindow& openOn(const Site& site, const Site& reference) {
    prepare = [this, site, reference](FakeRobot& made) {
      made.has_catalogue = true;
      made.maps.entries = {catalogued("1", "Site"), catalogued("2", "Other")};
      made.maps.pictures["1"] = site.map({map::MapKind::Stored, "1"});
      made.maps.pictures[""] = reference.map({map::MapKind::File, {}});
      if (also) also(made);
    };
    MainWindow& opened = openOnRobot();
    part<MapsController>(opened)->open({map::MapKind::Stored, "1"});
    lay();
    const session::MapSlot& whole = window->session()->wholeMap();
    [&] { QTRY_VERIFY(whole.cells() && whole.settled() && this->reference()->isRead()); }();
    return opened;
  }
  std::function<void(FakeRobot&)> also;  // in openOn(): the robot, and the reader of the reference map
  ReferenceDock* dock() { return part<ReferenceDock>(*window); }
  /// Presses the button, and waits for the result.
  void align() {
    QTest::mouseClick(dock()->alignButton(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!dock()->cancelButton()->isVisible(), 60'000);
  }
  /// Looks at 40 x 30 m around the origin, 5 cm a pixel.
  MainWindow& openOnRobot() {
    MainWindow& opened = open();
    (void)opened.connectTo(kAddress);
    robot->goOnline();
    say("Hall");
    look();
    return opened;
  }
  void say(const char* uid) {
    map::MapInfo info;
    info.name = info.uid = uid;
    robot->say(info);
  }
  void look() {
    geometry::ViewTransform view = window->mapScene()->view();
    view.center_m = {0, 0};
    view.scale_m_per_px = 0.05;
    view.rotation_rad = 0;
    window->view()->moveTo(view, false);
  }
  ReferenceController* reference() { return part<ReferenceController>(*window); }
  void lay() {
    FakeRobot* const live = robot;  // the reader of the file is one, too
    reference()->lay(kFile);
    robot = live;
    QTRY_VERIFY(part<ReferenceDock>(*window)->moveButton()->isEnabled());
    part<ReferenceDock>(*window)->show();
    look();
  }
  QPoint at(double x_m, double y_m) const {
    const Eigen::Vector2d px = window->mapScene()->view().pixelFromWorld({x_m, y_m});
    return QPoint(int(std::lround(px.x())), int(std::lround(px.y())));
  }
  void click(double x_m, double y_m) {
    QTest::mouseClick(window->view()->viewport(), Qt::LeftButton, {}, at(x_m, y_m));
  }
  void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {}) {
    QWidget* const map = window->view()->viewport();
    QTest::mousePress(map, Qt::LeftButton, modifiers, from);
    for (int step = 1; step <= 4; ++step) {
      QMouseEvent move(QEvent::MouseMove, from + (to - from) * step / 4, QPoint(), Qt::NoButton,
                       Qt::LeftButton, modifiers);
      QApplication::sendEvent(map, &move);
    }
    QTest::mouseRelease(map, Qt::LeftButton, modifiers, to);
  }
};

}  // namespace mapwright::test
