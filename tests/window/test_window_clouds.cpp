// Clouds of the robot's map in the window: fetched by region, shown, cut, saved.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include "clouds/cloud_store.h"
#include "fake_robot.h"
#include "known_addresses.h"
#include "robot/map_dispatch.h"
#include "test_program.h"
#include "ui/clouds/clouds_controller.h"
#include "ui/clouds/clouds_dock.h"
#include "ui/clouds/region_tool.h"
#include "ui/clouds/section_dock.h"
#include "ui/clouds/section_tool.h"
#include "ui/maps/export_controller.h"
#include "ui/view/map_overlay.h"
#include "ui/view/map_view.h"
#include "ui/view/toast_stack.h"
#include "ui/window/main_window.h"
#include "window_parts.h"

namespace test_window_clouds {

using namespace mapwright;
using namespace mapwright::ui;
using Cloud = std::shared_ptr<const map::SpatialCloud>;

namespace {

/// Answers when the test says so.
class FakeDispatch : public robot::MapDispatch {
 public:
  struct Asked {
    robot::CloudKind kind;
    std::optional<map::CloudRegion> region;
    robot::OutcomeTo<Cloud> reply;
    std::shared_ptr<robot::Call::State> state;
  };
  std::vector<robot::DispatchOffer> offers() const override {
    std::vector<robot::DispatchOffer> all;
    for (const auto service : offered_services) all.push_back({service, true, {}, {}});
    return all;
  }
  robot::Call grid(const std::optional<map::GridRegion>&, robot::OutcomeTo<map::GridPart>) override {
    return {};
  }
  robot::Call cloud(robot::CloudKind kind, const std::optional<map::CloudRegion>& region,
                    robot::OutcomeTo<Cloud> reply) override {
    auto state = std::make_shared<robot::Call::State>();
    state->cancel = [this] { ++cancelled; };
    asked.push_back({kind, region, std::move(reply), state});
    return robot::Call(state);
  }
  robot::Call save(const std::string&, robot::OutcomeTo<std::string>) override { return {}; }
  robot::Call projections(robot::OutcomeTo<std::vector<map::Projection>>) override { return {}; }
  robot::Call project(const std::vector<map::Projection>&,
                      robot::OutcomeTo<std::vector<map::Projection>>) override {
    return {};
  }
  std::vector<robot::ProjectedPart> projected() const override { return {}; }

  void answer(robot::Outcome<Cloud> with) {
    Asked last = std::move(asked.back());
    last.state->over = true;
    last.reply(std::move(with));
  }

  std::vector<Asked> asked;
  int cancelled = 0;
  std::set<robot::DispatchService> offered_services{robot::DispatchService::Cloud,
                                                    robot::DispatchService::CloudRegion,
                                                    robot::DispatchService::OccupancyRegion};
};

class DispatchingRobot : public test::FakeRobot {
 public:
  using FakeRobot::FakeRobot;
  robot::MapDispatch* mapDispatch() override { return has_dispatch ? &dispatch : nullptr; }
  FakeDispatch dispatch;
  bool has_dispatch = true;
};

/// A floor of 10 m with a wall of 2 m along x = 0.
Cloud hall() {
  auto cloud = std::make_shared<map::SpatialCloud>();
  for (int x = 0; x < 100; ++x) {
    for (int y = 0; y < 100; ++y) cloud->points.emplace_back(float(x) * 0.1F, float(y) * 0.1F, 0.0F);
  }
  for (int y = 0; y < 100; ++y) {
    for (int z = 0; z < 21; ++z) cloud->points.emplace_back(0.0F, float(y) * 0.1F, float(z) * 0.1F);
  }
  cloud->intensity.assign(cloud->points.size(), 7);
  return cloud;
}

struct Desk {
  Desk() : settings(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat) {}
  void open() {
    MainWindow::Dependencies wanted{
        [this](const QString& address,
               const QByteArray&) -> tl::expected<std::unique_ptr<robot::Robot>, QString> {
          auto made = std::make_unique<DispatchingRobot>(address);
          made->has_dispatch = dispatches;
          robot = made.get();
          return std::unique_ptr<robot::Robot>(std::move(made));
        },
        settings};
    wanted.addresses = test::knownAddresses();
    window = std::make_unique<MainWindow>(std::move(wanted));
    window->resize(1366, 768);
    window->show();
    window->view()->setAnimationMs(0);
    (void)QTest::qWaitForWindowActive(window.get());
    QVERIFY(!window->connectTo(QStringLiteral("axbot+http://192.0.2.7:8090")));
    window->view()->moveTo(look(), false);
  }
  static geometry::ViewTransform look() {
    geometry::ViewTransform view;
    view.center_m = {5, 5};
    view.scale_m_per_px = 0.02;
    view.width_px = 800;
    view.height_px = 500;
    return view;
  }
  CloudsController& clouds() { return *part<CloudsController>(*window); }
  CloudsDock& dock() { return *clouds().dock(); }
  FakeDispatch& dispatch() { return robot->dispatch; }
  clouds::CloudStore& held() { return part<CloudsController>(*window)->store(); }
  QAction* action(const char* id) { return window->actionList().find(QLatin1String(id)); }
  QPoint px(double x, double y) {
    const Eigen::Vector2d at = window->mapScene()->view().pixelFromWorld({x, y});
    return {int(std::lround(at.x())), int(std::lround(at.y()))};
  }
  /// From one place of the map to another.
  void drag(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) {
    QWidget* const on = window->view()->viewport();
    QCoreApplication::processEvents();  // a dock that has opened makes the view smaller
    const QPoint from = px(from_m.x(), from_m.y()), to = px(to_m.x(), to_m.y());
    QTest::mousePress(on, Qt::LeftButton, {}, from);
    for (int step = 1; step <= 4; ++step) {
      const QPoint at = from + (to - from) * step / 4;
      QMouseEvent move(QEvent::MouseMove, at, on->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
      QApplication::sendEvent(on, &move);
    }
    QTest::mouseRelease(on, Qt::LeftButton, {}, to);
  }
  /// What is asked before the robot is left; null = nothing.
  QMessageBox* leaving() const {
    auto* const save = window->findChild<QPushButton*>(QStringLiteral("saveFetched"));
    return save ? qobject_cast<QMessageBox*>(save->window()) : nullptr;
  }
  /// Everything that is there, on the map.
  void load() {
    dock().viewButton()->click();
    QCOMPARE(dispatch().asked.size(), std::size_t(1));
    dispatch().answer(hall());
    QTRY_VERIFY(held().settled() && held().sums().clouds == 1);
  }

  QTemporaryDir folder;
  QSettings settings;
  bool dispatches = true;
  DispatchingRobot* robot = nullptr;
  std::unique_ptr<MainWindow> window;
};

}  // namespace

class TestWindowClouds : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aRobotWithoutADispatcherSaysSo() {
    Desk desk;
    desk.dispatches = false;
    desk.open();
    QVERIFY(!desk.dock().absence().isEmpty());
    QVERIFY(!desk.dock().viewButton()->isEnabled());
    // One that comes later is offered at once.
    desk.robot->has_dispatch = true;
    Q_EMIT desk.robot->capabilitiesChanged();
    QVERIFY(desk.dock().absence().isEmpty());
    QVERIFY(desk.dock().viewButton()->isEnabled());
  }

  void whatIsInViewIsFetchedAndShown() {
    Desk desk;
    desk.open();
    desk.dock().askLowBox()->setValue(-1);
    desk.dock().askHighBox()->setValue(3);
    desk.load();
    const map::CloudRegion& region = *desk.dispatch().asked.at(0).region;
    const geometry::WorldRect seen = desk.window->mapScene()->view().visibleWorld();
    QVERIFY((region.centre_m - Eigen::Vector3d(seen.center().x(), seen.center().y(), 1)).norm() < 1e-6);
    QVERIFY((region.size_m - Eigen::Vector3d(seen.width(), seen.height(), 4)).norm() < 1e-6);
    QCOMPARE(region.radius_m, 0.0);
    QVERIFY(desk.dock().counts().contains(QStringLiteral("12,100 points are shown.")));
    QVERIFY(desk.dock().outcome().contains(QStringLiteral("12,100 points were received.")));
    QTRY_VERIFY(desk.window->mapScene()->picturesSettled());
    const QImage picture = part<ExportController>(*desk.window)->mapPicture();
    const QPoint inside = desk.px(5, 5), outside = desk.px(-2, 5);
    const auto inkAround = [&](const QPoint& at) {
      int ink = 0;
      const QColor bare = desk.window->mapScene()->theme().map.unknown;
      for (int x = -8; x <= 8; ++x) {
        for (int y = -8; y <= 8; ++y) ink += QColor(picture.pixel(at + QPoint(x, y))) != bare ? 1 : 0;
      }
      return ink;
    };
    QVERIFY2(inkAround(inside) > inkAround(outside),
             qPrintable(QStringLiteral("%1 %2").arg(inkAround(inside)).arg(inkAround(outside))));
  }

  void aBoxAndASphereAreDrawnOnTheMap() {
    Desk desk;
    desk.open();
    desk.dock().regionButton()->click();
    desk.drag({2, 3}, {6, 5});
    QCOMPARE(desk.dispatch().asked.size(), std::size_t(1));
    const map::CloudRegion box = *desk.dispatch().asked[0].region;
    QVERIFY((box.centre_m.head<2>() - Eigen::Vector2d(4, 4)).norm() < 0.05);
    QVERIFY((box.size_m.head<2>() - Eigen::Vector2d(4, 2)).norm() < 0.05);
    desk.dispatch().answer(std::make_shared<const map::SpatialCloud>());
    QCOMPARE(desk.dock().outcome(), QStringLiteral("The robot has no points in this region."));
    desk.dock().shapeBox()->setCurrentIndex(1);
    Q_EMIT desk.dock().shapeBox()->activated(1);
    desk.dock().kindBox()->setCurrentIndex(1);
    Q_EMIT desk.dock().kindBox()->activated(1);
    desk.drag({5, 5}, {8, 5});
    QCOMPARE(desk.dispatch().asked.size(), std::size_t(2));
    QVERIFY(desk.dispatch().asked[1].kind == robot::CloudKind::Occupancy);
    QVERIFY(std::abs(desk.dispatch().asked[1].region->radius_m - 3) < 0.05);
    QTest::keyClick(desk.window->view(), Qt::Key_Escape);
    QVERIFY(!desk.action("cloudRegion")->isChecked());
  }

  void whatLiesBeyondIsCroppedAndWhatIsMissingIsTold() {
    Desk desk;
    desk.open();
    map::CloudRegion region;
    region.centre_m = {5, 5, 0};
    region.size_m = {2, 2, 2};
    desk.clouds().fetch(region);
    auto cloud = std::make_shared<map::SpatialCloud>();
    cloud->points = {{5, 5, 0}, {5.5F, 5, 0}, {7, 5, 0}};
    cloud->missing = 4;
    desk.dispatch().answer(cloud);
    QTRY_VERIFY(desk.held().settled() && desk.held().sums().came == 2);
    QVERIFY(
        desk.dock().outcome().contains(QStringLiteral("4 points that the robot announced did not arrive")));
    QVERIFY(desk.dock().outcome().contains(QStringLiteral("1 point lies outside the requested region")));
    // Another region than the one that was asked for.
    region.centre_m = {50, 50, 0};
    desk.clouds().fetch(region);
    desk.dispatch().answer(cloud);
    QTRY_VERIFY(desk.dock().outcome().contains(QStringLiteral("another region")));
    QCOMPARE(desk.held().sums().came, std::uint64_t(2));
  }

  void theWholeMapIsFetchedOnlyWhenOneIsSure() {
    Desk desk;
    desk.open();
    part<CloudsController>(*desk.window)->dock()->show();
    desk.dock().wholeButton()->click();
    QVERIFY(desk.dispatch().asked.empty());
    desk.dock().wholeSureButton()->click();
    QCOMPARE(desk.dispatch().asked.size(), std::size_t(1));
    QVERIFY(!desk.dispatch().asked[0].region);
    // Of cells this one offers regions alone.
    desk.dispatch().answer(hall());
    desk.dock().kindBox()->setCurrentIndex(1);
    Q_EMIT desk.dock().kindBox()->activated(1);
    QVERIFY(!desk.dock().wholeButton()->isEnabled());
    QVERIFY(!desk.dock().wholeButton()->toolTip().isEmpty());
    QVERIFY(desk.dock().viewButton()->isEnabled());
  }

  void oneRequestIsInProgressAtATimeAndCanBeCancelled() {
    Desk desk;
    desk.open();
    desk.dock().show();
    desk.dock().viewButton()->click();
    QVERIFY(!desk.dock().viewButton()->isEnabled());
    desk.dispatch().asked[0].state->on_progress({12'345'678, {}});
    desk.clouds().fetch(std::nullopt);
    QCOMPARE(desk.dispatch().asked.size(), std::size_t(1));
    desk.dock().cancelButton()->click();
    QCOMPARE(desk.dispatch().cancelled, 1);
    desk.dispatch().answer(tl::make_unexpected(map::Failure{.kind = map::FailureKind::Cancelled}));
    QCOMPARE(desk.dock().outcome(), QStringLiteral("Cancelled."));
    QVERIFY(desk.dock().viewButton()->isEnabled());
  }

  void aFailureIsASentenceAndKeepsWhatCame() {
    Desk desk;
    desk.open();
    desk.load();
    desk.dock().viewButton()->click();
    desk.robot->goAway(QStringLiteral("The cable was pulled"));
    desk.dispatch().answer(tl::make_unexpected(map::Failure{
        .kind = map::FailureKind::Unreachable, .subject = "cloud", .detail = "It <b>broke</b> off"}));
    QVERIFY(desk.dock().outcome().endsWith(QLatin1Char('.')));
    QVERIFY(desk.dock().outcome().contains(QStringLiteral("<b>broke</b>")));
    QCOMPARE(desk.held().sums().shown, std::uint64_t(12'100));
  }

  void heightsAreChosenByHandByKeysAndByTyping() {
    Desk desk;
    desk.open();
    desk.load();
    desk.dock().show();
    HeightSlider* const slider = desk.dock().slider();
    slider->resize(220, 72);
    // By hand: the lower handle to the right.
    QTest::mousePress(slider, Qt::LeftButton, {}, QPoint(int(slider->xOf(0)), 30));
    QMouseEvent move(QEvent::MouseMove, QPointF(slider->xOf(1), 30), QPointF(), Qt::NoButton, Qt::LeftButton,
                     {});
    QApplication::sendEvent(slider, &move);
    QTest::mouseRelease(slider, Qt::LeftButton);
    QVERIFY(desk.held().heightRange().has_value());
    QVERIFY(std::abs(desk.held().heightRange()->low_m - 1) < 0.03);
    QTRY_VERIFY(desk.held().settled());
    QVERIFY(desk.held().sums().shown < 2'000);
    QVERIFY(desk.dock().counts().contains(QStringLiteral("of 12,100 are shown.")));
    // By keys: the upper one.
    QTest::keyClick(slider, Qt::Key_Up);
    const double before = desk.held().heightRange()->high_m;
    QTest::keyClick(slider, Qt::Key_Left, Qt::ShiftModifier);
    QVERIFY(desk.held().heightRange()->high_m < before - 0.1);
    QTest::keyClick(slider, Qt::Key_Down);
    QTest::keyClick(slider, Qt::Key_Home);
    QVERIFY(std::abs(desk.held().heightRange()->low_m) < 1e-6);
    // By typing; an end that is beyond the other pushes it.
    desk.dock().lowBox()->setValue(0.25);
    QVERIFY(std::abs(desk.held().heightRange()->low_m - 0.25) < 1e-9);
    desk.dock().highBox()->setValue(0.1);
    QCOMPARE(*desk.held().heightRange(), (clouds::HeightRange{0.1, 0.1}));
    QTest::mouseDClick(slider, Qt::LeftButton, {}, QPoint(60, 30));
    QVERIFY(!desk.held().heightRange());
    QTRY_COMPARE(desk.held().sums().shown, std::uint64_t(12'100));
  }

  void coloursAndSizesAreThoseOfTheLayer() {
    Desk desk;
    desk.open();
    Q_EMIT desk.dock().colorBox()->activated(int(ui::scene::DispatchedCloudChoice::OneColor));
    desk.dock().sizeBox()->setValue(5);
    const ui::scene::LayerStyle& style =
        desk.window->mapScene()->layerStyle(ui::scene::Layer::DispatchedCloud);
    QCOMPARE(style.choice, int(ui::scene::DispatchedCloudChoice::OneColor));
    QCOMPARE(style.size, 5.0);
    desk.window->mapScene()->setLayerStyle(ui::scene::Layer::DispatchedCloud,
                                           ui::scene::LayerStyle{QColor(), 0, 1});
    QCOMPARE(desk.dock().colorBox()->currentIndex(), 1);
  }

  void aLineOnTheMapIsASectionWithValuesUnderTheCursor() {
    Desk desk;
    desk.open();
    desk.load();
    desk.action("cloudSection")->trigger();
    desk.drag({-1, 5}, {8, 5});
    SectionDock& dock = *desk.clouds().sectionDock();
    QVERIFY(!dock.isHidden());
    QTRY_VERIFY(dock.height() >= 240);  // a storey is to be seen
    QTRY_VERIFY(dock.view()->section() && dock.view()->settled());
    QVERIFY(dock.told().contains(QStringLiteral("points, from 0.00 m to 2.00 m")));
    SectionView* const view = dock.view();
    const std::uint64_t narrow = view->section()->points;
    // The wall stands a metre along.
    const QPoint wall = view->pxOf({1, 1.5}).toPoint();
    QMouseEvent over(QEvent::MouseMove, wall, view->mapToGlobal(wall), Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(view, &over);
    QVERIFY(view->reading() && view->reading()->nearest);
    QVERIFY(std::abs(view->reading()->nearest->x() - 1) < 0.1);
    QVERIFY(dock.told().contains(QStringLiteral("point at")));
    // Zoomed, the place under the cursor stays.
    const Eigen::Vector2d before = view->placeAt(wall);
    QWheelEvent wheel(wall, view->mapToGlobal(wall), {}, {0, 240}, Qt::NoButton, {}, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(view, &wheel);
    QVERIFY((view->placeAt(wall) - before).norm() < 0.01);
    const double zoomed = view->view().scale_m_per_px;
    QTest::keyClick(view, Qt::Key_F);
    QVERIFY(view->view().scale_m_per_px > zoomed);
    // A wider strip has more points.
    dock.widthBox()->setValue(4);
    QTRY_VERIFY(view->section() && view->section()->points > narrow);
    // Esc forgets the line, and then puts the tool away.
    QTest::keyClick(desk.window->view(), Qt::Key_Escape);
    QVERIFY(!view->section());
    QTest::keyClick(desk.window->view(), Qt::Key_Escape);
    QVERIFY(!desk.action("cloudSection")->isChecked());
  }

  void whatIsShownIsSaved() {
    Desk desk;
    desk.open();
    QVERIFY(!desk.dock().saveButton()->isEnabled());
    desk.load();
    QVERIFY(desk.dock().saveButton()->isEnabled());
    const QString path = desk.folder.filePath(QStringLiteral("a.pcd"));
    desk.clouds().saveTo(path);
    QTRY_VERIFY(QFile::exists(path));
    QTRY_VERIFY(!part<MapOverlay>(*desk.window)->toasts()->texts().isEmpty());
    desk.clouds().saveTo(desk.folder.filePath(QStringLiteral("a.las")));
    QVERIFY(part<MapOverlay>(*desk.window)->toasts()->texts().last().contains(QStringLiteral(".ply")));
    desk.dock().clearButton()->click();
    QVERIFY(!desk.dock().saveButton()->isEnabled());
    QVERIFY(desk.dock().counts().contains(QStringLiteral("Nothing")));
  }

  void whatIsNotSavedIsAskedAboutBeforeTheRobotIsLeft() {
    Desk desk;
    desk.open();
    desk.robot->goOnline();
    desk.load();
    desk.action("disconnect")->trigger();
    QTRY_VERIFY(desk.leaving());
    QVERIFY2(desk.leaving()->text().contains(QStringLiteral("points")), qPrintable(desk.leaving()->text()));
    desk.leaving()->button(QMessageBox::Cancel)->click();
    QTRY_VERIFY(!desk.leaving());
    QVERIFY(desk.window->session());
    // What is in a file is not lost.
    bool written = false;
    desk.clouds().saveTo(desk.folder.filePath(QStringLiteral("kept.pcd")), [&written] { written = true; });
    QTRY_VERIFY(written);
    desk.action("disconnect")->trigger();
    QTRY_VERIFY(!desk.window->session());
    QVERIFY(!desk.leaving());
  }
  void whatIsNotSavedMayBeDiscarded() {
    Desk desk;
    desk.open();
    desk.robot->goOnline();
    desk.load();
    desk.action("disconnect")->trigger();
    QTRY_VERIFY(desk.leaving());
    desk.leaving()->button(QMessageBox::Discard)->click();
    QTRY_VERIFY(!desk.window->session());
  }
  void whatTheColoursMeanIsSaid() {
    Desk desk;
    desk.open();
    desk.robot->goOnline();
    desk.load();
    ColorScale* const scale = desk.dock().scale();
    QTRY_COMPARE(scale->values().size(), 3);
    QVERIFY(!scale->isHidden());
    QVERIFY2(scale->values().first().endsWith(QStringLiteral(" m")), qPrintable(scale->values().first()));
    QVERIFY(scale->accessibleName().contains(QStringLiteral("height")));
    // It goes along with the heights that are shown.
    desk.dock().lowBox()->setValue(0.5);
    QTRY_VERIFY2(scale->values().first().startsWith(QStringLiteral("0.5")),
                 qPrintable(scale->values().first()));
    // One colour for all means nothing.
    Q_EMIT desk.dock().colorBox()->activated(int(ui::scene::DispatchedCloudChoice::OneColor));
    QTRY_VERIFY(scale->isHidden());
  }
  void bandsThatCoverEachOtherHaveTheirNumbersSideBySide() {
    Desk desk;
    desk.open();
    desk.load();
    desk.action("cloudSection")->trigger();
    desk.drag({-1, 5}, {8, 5});
    SectionView* const view = desk.clouds().sectionDock()->view();
    QTRY_VERIFY(view->section() && view->settled());
    view->setBands(
        {{0, 0, 2, false, true}, {1, 0, 2, false, true}, {2, 0.1, 2, true, true}, {12, 5000, 5001}});
    const std::vector<QRectF> labels = view->bandLabels();
    QCOMPARE(labels.size(), std::size_t(4));
    for (int i = 0; i < 3; ++i) {
      QVERIFY(!labels[std::size_t(i)].isEmpty());
      QVERIFY(QRectF(view->rect()).contains(labels[std::size_t(i)]));
      for (int j = 0; j < i; ++j) QVERIFY(!labels[std::size_t(i)].intersects(labels[std::size_t(j)]));
    }
    QVERIFY(labels[2].right() > labels[0].right());  // the chosen one is first
    QVERIFY(labels[3].isEmpty());
  }

  void anotherRobotHasOtherClouds() {
    Desk desk;
    desk.open();
    desk.load();
    desk.dock().viewButton()->click();
    desk.window->leaveRobot();
    QVERIFY(desk.held().empty());
    QVERIFY(!desk.dock().absence().isEmpty());
    QVERIFY(!desk.window->connectTo(QStringLiteral("axbot+http://192.0.2.8:8090")));
    QVERIFY(desk.dock().viewButton()->isEnabled());
  }
};

}  // namespace test_window_clouds

MAPWRIGHT_TEST(test_window_clouds, TestWindowClouds, Widgets)
#include "test_window_clouds.moc"
