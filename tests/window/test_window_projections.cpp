// What a robot lays on the plane, in the window: asked for, edited by table, map and section, set.
#include <QMessageBox>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QtTest>

#include "fake_robot.h"
#include "known_addresses.h"
#include "robot/map_dispatch.h"
#include "test_program.h"
#include "ui/clouds/clouds_controller.h"
#include "ui/clouds/projection_tool.h"
#include "ui/clouds/projections_controller.h"
#include "ui/clouds/projections_dock.h"
#include "ui/clouds/section_dock.h"
#include "ui/view/map_view.h"
#include "ui/window/main_window.h"
#include "window_parts.h"

namespace test_window_projections {

using namespace mapwright;
using namespace mapwright::ui;
using List = std::vector<map::Projection>;

namespace {

/// Answers when the test says so.
class FakeDispatch : public robot::MapDispatch {
 public:
  std::vector<robot::DispatchOffer> offers() const override {
    return {{robot::DispatchService::ReadProjections, reads, {}, {}},
            {robot::DispatchService::ChangeProjections, changes, {}, {}}};
  }
  robot::Call grid(const std::optional<map::GridRegion>&, robot::OutcomeTo<map::GridPart>) override {
    return {};
  }
  robot::Call cloud(robot::CloudKind, const std::optional<map::CloudRegion>&,
                    robot::OutcomeTo<std::shared_ptr<const map::SpatialCloud>>) override {
    return {};
  }
  robot::Call save(const std::string&, robot::OutcomeTo<std::string>) override { return {}; }
  robot::Call projections(robot::OutcomeTo<List> reply) override {
    ++asked;
    return wait(std::move(reply));
  }
  robot::Call project(const List& wanted, robot::OutcomeTo<List> reply) override {
    sent.push_back(wanted);
    return wait(std::move(reply));
  }
  std::vector<robot::ProjectedPart> projected() const override { return parts; }
  std::vector<std::string> silent() const override { return silent_topics; }

  void answer(robot::Outcome<List> with) {
    state->over = true;
    const auto to = std::exchange(reply, {});
    to(std::move(with));
  }

  bool reads = true, changes = true;
  std::vector<robot::ProjectedPart> parts;
  std::vector<std::string> silent_topics;
  int asked = 0;
  std::vector<List> sent;

 private:
  robot::Call wait(robot::OutcomeTo<List> to) {
    state = std::make_shared<robot::Call::State>();
    reply = std::move(to);
    return robot::Call(state);
  }
  std::shared_ptr<robot::Call::State> state;
  robot::OutcomeTo<List> reply;
};

class ProjectingRobot : public test::FakeRobot {
 public:
  using FakeRobot::FakeRobot;
  robot::MapDispatch* mapDispatch() override { return has_dispatch ? &dispatch : nullptr; }
  FakeDispatch dispatch;
  bool has_dispatch = true;
};

map::Projection floorAt(double x, double y) { return {"map", {x, y}, {4, 2}, 0, 2}; }

struct Desk {
  Desk() : settings(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat) {}
  void open(bool has_dispatch = true, bool changes = true) {
    MainWindow::Dependencies wanted{
        [=, this](const QString& address,
                  const QByteArray&) -> tl::expected<std::unique_ptr<robot::Robot>, QString> {
          auto made = std::make_unique<ProjectingRobot>(address);
          made->has_dispatch = has_dispatch && projecting;
          made->dispatch.changes = changes;
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
    dock().show();
    dock().raise();
    QCoreApplication::processEvents();
    geometry::ViewTransform view;
    view.center_m = {5, 5};
    view.scale_m_per_px = 0.02;
    view.width_px = 800;
    view.height_px = 500;
    window->view()->moveTo(view, false);
  }
  ProjectionsController& projections() { return *part<ProjectionsController>(*window); }
  ProjectionsDock& dock() { return *projections().dock(); }
  FakeDispatch& dispatch() { return robot->dispatch; }
  const List& wanted() { return projections().draft().wanted(); }
  QString cell(int row, int column) {
    return dock().model()->data(dock().model()->index(row, column), Qt::DisplayRole).toString();
  }
  QPoint px(double x, double y) {
    const Eigen::Vector2d at = window->mapScene()->view().pixelFromWorld({x, y});
    return {int(std::lround(at.x())), int(std::lround(at.y()))};
  }
  void drag(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) {
    QWidget* const on = window->view()->viewport();
    QCoreApplication::processEvents();
    const QPoint from = px(from_m.x(), from_m.y()), to = px(to_m.x(), to_m.y());
    QTest::mousePress(on, Qt::LeftButton, {}, from);
    for (int step = 1; step <= 4; ++step) {
      const QPoint at = from + (to - from) * step / 4;
      QMouseEvent move(QEvent::MouseMove, at, on->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
      QApplication::sendEvent(on, &move);
    }
    QTest::mouseRelease(on, Qt::LeftButton, {}, to);
  }

  QTemporaryDir folder;
  QSettings settings;
  bool projecting = true;  // the next robot, too
  ProjectingRobot* robot = nullptr;
  std::unique_ptr<MainWindow> window;
};

}  // namespace

class TestWindowProjections : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aRobotWithoutThemSaysSo() {
    Desk desk;
    desk.open(false);
    QVERIFY(!desk.dock().absence().isEmpty());
    QVERIFY(!desk.dock().sendButton()->isVisible());
  }

  void theRobotIsAskedOnceItsListIsLookedAt() {
    Desk desk;
    desk.open();
    QCOMPARE(desk.dispatch().asked, 1);
    QVERIFY(!desk.dock().askButton()->isEnabled());
    desk.dispatch().answer(List{floorAt(1, 1), floorAt(6, 6)});
    QCOMPARE(desk.dock().model()->rowCount(), 2);
    QCOMPARE(desk.cell(1, ProjectionsModel::X), QStringLiteral("6"));
    QCOMPARE(desk.cell(1, ProjectionsModel::Frame), QStringLiteral("map"));
    QCOMPARE(desk.dock().state(), QStringLiteral("The robot has 2 projections."));
    QVERIFY(!desk.dock().sendButton()->isEnabled());
    desk.dock().askButton()->click();
    QCOMPARE(desk.dispatch().asked, 2);
  }

  void theToolOfARobotDoesNotStayInTheHandForAnotherOne() {
    Desk desk;
    desk.open();
    const auto tool = [&] { return desk.window->view()->tool()->name(); };
    const QString first = tool();
    desk.window->actionList().find(QStringLiteral("projections"))->trigger();
    QVERIFY(tool() != first);
    desk.projecting = false;
    QVERIFY(!desk.window->connectTo(QStringLiteral("axbot+http://192.0.2.8:8090")));
    QCOMPARE(tool(), first);
    QVERIFY(!desk.window->actionList().find(QStringLiteral("projections"))->isChecked());
  }

  void theRobotIsAskedAnewOnceThereIsNews() {
    Desk desk;
    desk.open();
    desk.dispatch().answer(List{floorAt(1, 1)});
    QCOMPARE(desk.dispatch().asked, 1);
    // The link was lost, and is back.
    desk.robot->goAway(QStringLiteral("gone"));
    QCOMPARE(desk.dispatch().asked, 1);
    desk.robot->goOnline();
    QCOMPARE(desk.dispatch().asked, 2);
    // What it offers changes while it is asked: once more then.
    Q_EMIT desk.dispatch().offersChanged();
    QCOMPARE(desk.dispatch().asked, 2);
    desk.dispatch().answer(List{floorAt(1, 1)});
    QCOMPARE(desk.dispatch().asked, 3);
    desk.dispatch().answer(List{floorAt(1, 1)});
    QCOMPARE(desk.dispatch().asked, 3);
    // A projected map that the list has is no news, another one is.
    robot::ProjectedPart part;
    part.part.grid = {80, 40, 0.05, {1, 1, 0}};
    part.max_z_m = 2;
    desk.dispatch().parts = {part};
    Q_EMIT desk.dispatch().projectedChanged(0);
    QCOMPARE(desk.dispatch().asked, 3);
    part.index = 1;
    desk.dispatch().parts.push_back(part);
    Q_EMIT desk.dispatch().projectedChanged(1);
    QCOMPARE(desk.dispatch().asked, 4);
    desk.dispatch().answer(List{floorAt(1, 1), floorAt(1, 1)});
    QCOMPARE(desk.dock().model()->rowCount(), 2);
  }

  void aProjectedMapThatStaysSilentIsNamed() {
    Desk desk;
    desk.open();
    desk.dispatch().silent_topics = {"/d/projected_map_1"};
    desk.dispatch().answer(List{floorAt(1, 1)});
    QVERIFY(desk.dock().outcome().contains(QStringLiteral("/d/projected_map_1")));
  }

  void whatIsSetIsShownAsTheRobotSaysIt() {
    Desk desk;
    desk.open();
    desk.dispatch().answer(List{floorAt(1, 1)});
    const auto at = desk.dock().model()->index(0, ProjectionsModel::Width);
    QVERIFY(desk.dock().model()->setData(at, 8.0, Qt::EditRole));
    QCOMPARE(desk.wanted()[0].size_m.x(), 8.0);
    QCOMPARE(desk.dock().state(), QStringLiteral("Edited here, not set on the robot yet."));
    desk.dock().sendButton()->click();
    QCOMPARE(desk.dispatch().sent.size(), std::size_t(1));
    QCOMPARE(desk.dispatch().sent[0][0].size_m.x(), 8.0);
    // Nothing can be edited meanwhile: what is there is what was sent.
    QVERIFY(!desk.dock().model()->setData(at, 9.0, Qt::EditRole));
    map::Projection smaller = floorAt(1, 1);
    smaller.size_m.x() = 6;
    desk.dispatch().answer(List{smaller});
    QCOMPARE(desk.cell(0, ProjectionsModel::Width), QStringLiteral("6"));
    QVERIFY(desk.dock().outcome().contains(QStringLiteral("1 projection differs from what was sent")));
    QVERIFY(!desk.dock().sendButton()->isEnabled());
  }

  void aFailureIsASentenceAndKeepsTheEdits() {
    Desk desk;
    desk.open();
    desk.dispatch().answer(List{floorAt(1, 1)});
    desk.dock().addButton()->click();
    QCOMPARE(desk.wanted().size(), std::size_t(2));
    desk.dock().sendButton()->click();
    desk.dispatch().answer(tl::make_unexpected(map::Failure{
        .kind = map::FailureKind::Unreachable, .subject = "projections", .detail = "<b>gone</b>"}));
    QVERIFY(!desk.dock().outcome().isEmpty());
    QCOMPARE(desk.wanted().size(), std::size_t(2));
    QVERIFY(desk.dock().sendButton()->isEnabled());
    desk.dock().revertButton()->click();
    QCOMPARE(desk.wanted(), List{floorAt(1, 1)});
    QVERIFY(desk.dock().outcome().isEmpty());
  }

  void rectanglesAreDrawnMovedAndTakenOutOnTheMap() {
    Desk desk;
    desk.open();
    desk.dispatch().answer(List{});
    desk.dock().drawButton()->click();
    desk.drag({2, 3}, {6, 5});
    QCOMPARE(desk.wanted().size(), std::size_t(1));
    QVERIFY((desk.wanted()[0].corner_m - Eigen::Vector2d(2, 3)).norm() < 0.05);
    QVERIFY((desk.wanted()[0].size_m - Eigen::Vector2d(4, 2)).norm() < 0.05);
    QCOMPARE(desk.dock().table()->currentIndex().row(), 0);
    desk.drag({4, 4}, {5, 4});  // its inside
    QVERIFY((desk.wanted()[0].corner_m - Eigen::Vector2d(3, 3)).norm() < 0.1);
    desk.drag({7, 5}, {8, 6});  // its upper right corner
    QVERIFY((desk.wanted()[0].size_m - Eigen::Vector2d(5, 3)).norm() < 0.1);
    // Within one that is not chosen a drag draws; a click chooses, and goes through those that lie on each
    // other.
    desk.dock().table()->setCurrentIndex({});
    desk.drag({4, 4}, {5, 5});
    QCOMPARE(desk.wanted().size(), std::size_t(2));
    QCOMPARE(desk.projections().draft().selected(), std::optional(1));
    QTest::mouseClick(desk.window->view()->viewport(), Qt::LeftButton, {}, desk.px(4.5, 4.5));
    QTRY_COMPARE(desk.projections().draft().selected(), std::optional(0));
    QTest::keyClick(desk.window->view(), Qt::Key_Delete);
    QTest::keyClick(desk.window->view(), Qt::Key_Delete);
    QVERIFY(desk.wanted().empty());
    QTest::keyClick(desk.window->view(), Qt::Key_Escape);
    QVERIFY(!desk.dock().drawButton()->isChecked());
  }

  void theirHeightsAreBandsInTheSection() {
    Desk desk;
    desk.open();
    desk.dispatch().answer(List{floorAt(1, 1)});
    SectionDock* const section = part<CloudsController>(*desk.window)->sectionDock();
    section->show();
    SectionView* const view = section->view();
    QTRY_VERIFY(view->isVisible());
    QCOMPARE(view->bands().size(), std::size_t(1));
    // Without a cloud the bands are what it shows.
    const double high = view->bands()[0].high_m;
    const QPoint at(view->width() / 2, int(std::lround(view->pxOf({0, high}).y())));
    QVERIFY(view->rect().contains(at));
    QTest::mousePress(view, Qt::LeftButton, {}, at);
    const QPoint to = at + QPoint(0, -10);
    QMouseEvent move(QEvent::MouseMove, to, view->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(view, &move);
    QTest::mouseRelease(view, Qt::LeftButton, {}, to);
    QVERIFY(desk.wanted()[0].max_z_m > high);
    QVERIFY(desk.projections().draft().changed());
  }

  void whatMeansNothingIsNotSent() {
    Desk desk;
    desk.open();
    desk.dispatch().answer(List{floorAt(1, 1)});
    const auto at = desk.dock().model()->index(0, ProjectionsModel::MinZ);
    QVERIFY(desk.dock().model()->setData(at, 5.0, Qt::EditRole));
    QVERIFY(!desk.dock().sendButton()->isEnabled());
    QVERIFY(desk.dock().state().contains(QStringLiteral("lower height")));
  }

  void aRobotThatOnlyTellsThemSaysSo() {
    Desk desk;
    desk.open(true, false);
    desk.dispatch().answer(List{floorAt(1, 1)});
    QVERIFY(desk.dock().state().contains(QStringLiteral("read-only")));
    QVERIFY(!desk.dock().addButton()->isEnabled());
    QVERIFY(!desk.dock().model()->setData(desk.dock().model()->index(0, 0), 3.0, Qt::EditRole));
  }

  void editsThatAreNotSetAreAskedAboutBeforeTheRobotIsLeft() {
    Desk desk;
    desk.open();
    desk.dispatch().answer(List{floorAt(1, 1)});
    desk.dock().addButton()->click();
    QCOMPARE(desk.wanted().size(), std::size_t(2));
    const auto question = [&] { return desk.window->findChild<QMessageBox*>(); };
    const session::Session* const before = desk.window->session();
    QVERIFY(!desk.window->connectTo(QStringLiteral("axbot+http://192.0.2.8:8090")));
    QVERIFY(question());
    QCOMPARE(desk.window->session(), before);
    question()->button(QMessageBox::Cancel)->click();
    QTRY_VERIFY(!question());
    QCOMPARE(desk.wanted().size(), std::size_t(2));
    QVERIFY(!desk.window->connectTo(QStringLiteral("axbot+http://192.0.2.8:8090")));
    question()->findChild<QPushButton*>(QStringLiteral("leaveProjections"))->click();
    QTRY_COMPARE(desk.wanted().size(), std::size_t(0));
  }

  void allColumnsAreSeenAtTheWidthThatTheDockOpensWith() {
    Desk desk;
    desk.open();
    desk.dispatch().answer(List{{"map", {-20.5, -15}, {40, 30}, 0.2, 2}, floorAt(1, 1)});
    auto* const table = desk.dock().findChild<QTableView*>();
    QVERIFY(table);
    QTRY_COMPARE(table->horizontalScrollBar()->maximum(), 0);
    QVERIFY(!table->horizontalScrollBar()->isVisible());
    QCOMPARE(desk.cell(0, ProjectionsModel::X), QStringLiteral("-20.5"));
    QCOMPARE(desk.cell(0, ProjectionsModel::Y), QStringLiteral("-15"));
    QCOMPARE(desk.cell(0, ProjectionsModel::MinZ), QStringLiteral("0.2"));
    QCOMPARE(desk.cell(1, ProjectionsModel::MinZ), QStringLiteral("0"));
  }

  void theHintOfTheToolIsTrueOfTheRobot() {
    Desk desk;
    desk.open(false);
    const ProjectionTool* const tool = desk.window->findChild<ProjectionTool*>();
    QVERIFY2(tool->hint().contains(QStringLiteral("cannot be set on this robot, and there are none")),
             qPrintable(tool->hint()));
    Desk reader;
    reader.open(true, false);
    reader.robot->goOnline();
    const ProjectionTool* const its = reader.window->findChild<ProjectionTool*>();
    QTRY_COMPARE(reader.dispatch().asked, 1);
    reader.dispatch().answer(List{floorAt(1, 1)});
    QVERIFY2(its->hint().contains(QStringLiteral("cannot be set on this robot: click")),
             qPrintable(its->hint()));
    Desk writer;
    writer.open();
    writer.robot->goOnline();
    const ProjectionTool* const draws = writer.window->findChild<ProjectionTool*>();
    QTRY_COMPARE(writer.dispatch().asked, 1);
    writer.dispatch().answer(List{});
    QVERIFY2(draws->hint().contains(QStringLiteral("Drag a rectangle")), qPrintable(draws->hint()));
  }

  void leavingTheRobotLeavesNothingBehind() {
    Desk desk;
    desk.open();
    desk.dispatch().answer(List{floorAt(1, 1)});
    desk.dock().addButton()->click();
    desk.dock().sendButton()->click();
    desk.window->leaveRobot();
    QVERIFY(desk.wanted().empty());
    QVERIFY(!desk.dock().absence().isEmpty());
    QVERIFY(part<CloudsController>(*desk.window)->sectionDock()->view()->bands().empty());
  }
};

}  // namespace test_window_projections

MAPWRIGHT_TEST(test_window_projections, TestWindowProjections, Widgets)
#include "test_window_projections.moc"
