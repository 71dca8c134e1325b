// The pictures of the documents, made by the program itself: each task is done in a real window, and what is
// seen then is the picture. docs/draw-pictures writes them; without it the test shows that the tasks work.
#include <algorithm>
#include <cmath>
#include <functional>

#include <QDirIterator>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QRegularExpression>
#include <QTableView>
#include <QtTest>

#include "../pbstream/state_bytes.h"
#include "app/robot_factory.h"
#include "cells/cell_texture.h"
#include "replay/replay_robot.h"
#include "robot/address.h"
#include "robot/bag_library.h"
#include "shown_window.h"
#include "simulator/simulator.h"
#include "submap/submap_store.h"
#include "test_program.h"
#include "ui/replay/replay_controller.h"
#include "ui/shell/replay_clock.h"
#include "ui/slam/disagreement_dock.h"
#include "window/window_parts.h"

namespace test_guide_pictures {

using namespace mapwright;

namespace {

/// A robot that stands still in time, so that its pictures hardly change from one run to the next.
simulator::Options frozen() {
  simulator::Options options;
  options.paused = true;
  options.start_at_s = 90;
  return options;
}

constexpr int kLongMs = 60'000;

/// A window on a simulated robot, and what a hand does there. What it cannot do ends the test.
class Desk {
 public:
  explicit Desk(const simulator::Options& options = frozen())
      : robot_(options), shown_([](const QString& to, const QByteArray&) {
          return app::makeRobot(to, {}, app::DemoTime::Frozen);
        }) {
    if (const auto error = robot_.start()) qFatal("%s", error->c_str());
  }

  ui::MainWindow& window() { return shown_.window(); }
  session::Session* session() { return shown_.session(); }
  const simulator::Simulator& robot() const { return robot_; }
  bool connectTo(const std::string& address) {
    return shown_.connectTo(QString::fromStdString(address)) && settles();
  }
  /// Opens the first map that the robot stores.
  bool openMap() {
    const auto stored = [this]() -> const map::CatalogueEntry* {
      for (const map::CatalogueEntry& entry : session()->catalogue().entries())
        if (entry.key.kind == map::MapKind::Stored) return &entry;
      return nullptr;
    };
    if (!QTest::qWaitFor([&] { return stored() != nullptr; }, kLongMs)) return false;
    session()->openMap(stored()->key);
    return QTest::qWaitFor([this] { return session()->wholeMap().cells() && settled(); }, kLongMs);
  }
  void act(const char* id) {
    QAction* const action = window().actionList().find(QLatin1String(id));
    if (!action || !QTest::qWaitFor([&] { return action->isEnabled(); }, kLongMs)) qFatal("no action %s", id);
    action->trigger();
  }
  QDockWidget& front(const char* dock) {
    auto* const panel = window().findChild<QDockWidget*>(QLatin1String(dock));
    if (!panel) qFatal("no dock %s", dock);
    panel->show();
    panel->raise();
    return *panel;
  }
  /// Selects the first row in a table of the dock that contains `text`.
  bool select(const char* dock, const char* text) {
    return QTest::qWaitFor(
        [&, &panel = front(dock)] {
          for (auto* const table : panel.findChildren<QTableView*>()) {
            const QModelIndexList rows = table->model()->match(table->model()->index(0, 0), Qt::DisplayRole,
                                                               QLatin1String(text), 1, Qt::MatchContains);
            if (rows.isEmpty()) continue;
            table->setCurrentIndex(rows.front());
            return true;
          }
          return false;
        },
        kLongMs);
  }
  /// What is seen when nothing moves any more; written if asked to.
  bool picture(const char* name) {
    const bool quiet = settles() && QTest::qWaitFor([this] { return !shown_.hasToasts(); }, kLongMs);
    const QImage seen = window().grab().toImage();
    const QString folder = qEnvironmentVariable("MAPWRIGHT_GUIDE_PICTURES");
    if (!folder.isEmpty() &&
        !seen.save(folder + QLatin1Char('/') + QLatin1String(name) + QStringLiteral(".png"), nullptr, 0))
      return false;
    return quiet && seen.size() == QSize(1366, 768);
  }

 private:
  bool settled() { return session() && shown_.mapsSettled() && window().mapScene()->settled(); }
  bool settles() {
    return QTest::qWaitFor([this] { return settled(); }, kLongMs);
  }

  simulator::Simulator robot_;
  test::ShownWindow shown_;
};

geometry::Pose2 times(const geometry::Pose2& a, const geometry::Pose2& b) {
  const double c = std::cos(a.yaw_rad), s = std::sin(a.yaw_rad);
  return {a.x_m + c * b.x_m - s * b.y_m, a.y_m + s * b.x_m + c * b.y_m, a.yaw_rad + b.yaw_rad};
}
geometry::Pose2 inverse(const geometry::Pose2& a) {
  const double c = std::cos(a.yaw_rad), s = std::sin(a.yaw_rad);
  return {-c * a.x_m - s * a.y_m, s * a.x_m - c * a.y_m, -a.yaw_rad};
}

/// The cells as Cartographer stores them. The frame of the submap is that of the texture.
cartographer_state::SerializedData stored(map::SubmapId id, const cells::CellTexture& texture) {
  cartographer_state::SerializedData data;
  auto& submap = *data.mutable_submap();
  submap.mutable_submap_id()->set_trajectory_id(id.trajectory);
  submap.mutable_submap_id()->set_submap_index(id.index);
  pbstream::tests::place(*submap.mutable_submap_2d()->mutable_local_pose(), 0, 0);
  submap.mutable_submap_2d()->set_num_range_data(100);
  submap.mutable_submap_2d()->set_finished(true);
  auto& grid = *submap.mutable_submap_2d()->mutable_grid();
  grid.mutable_limits()->set_resolution(texture.resolutionM());
  grid.mutable_limits()->mutable_max();
  grid.mutable_limits()->mutable_cell_limits()->set_num_x_cells(texture.width());
  grid.mutable_limits()->mutable_cell_limits()->set_num_y_cells(texture.height());
  for (int row = 0; row < texture.height(); ++row) {
    for (int column = 0; column < texture.width(); ++column) {
      const cells::CellPair cell = texture.at(column, row);
      const double k = 128 - (cell.value - cell.alpha), odds = std::log(9.0) * (2 * (k - 1) / 254 - 1);
      const double cost = 1 - 1 / (1 + std::exp(-odds));
      grid.add_cells(cell == cells::CellPair{} ? 0
                                               : std::clamp(int((cost - 0.1) / 0.8 * 32766) + 1, 1, 32767));
    }
  }
  grid.mutable_known_cells_box()->set_max_x(texture.width() - 1);
  grid.mutable_known_cells_box()->set_max_y(texture.height() - 1);
  grid.mutable_probability_grid_2d();
  grid.set_min_correspondence_cost(0.1f);
  grid.set_max_correspondence_cost(0.9f);
  return data;
}

/// What the simulated robot has mapped, as a state file. Each submap has a node, and loop closures with those
/// that overlap it. `moved` lies wrong, and its node with it; the closures say what was seen.
std::string stateOf(const session::Session& session, std::optional<map::SubmapId> moved) {
  struct Laid {
    map::SubmapId id;
    std::shared_ptr<const cells::CellTexture> texture;
    geometry::Pose2 pose, node;
  };
  std::vector<Laid> all;
  for (const auto& [id, row] : session.submaps().rows()) {
    const auto placement = session.submaps().placement(id, 0);
    if (!placement || id.trajectory != 0) continue;
    const geometry::Pose2 pose = placement->world_from_texture;
    const double half = placement->texture->resolutionM() / 2;
    const geometry::Pose2 middle{-half * placement->texture->height(), -half * placement->texture->width(),
                                 0};
    all.push_back({id, placement->texture, pose, times(pose, middle)});
  }
  cartographer_state::SerializedData graph;
  auto& poses = *graph.mutable_pose_graph();
  std::map<int, cartographer_state::Trajectory*> trajectories;
  const auto put = [](cartographer_state::Rigid3d& to, const geometry::Pose2& pose) {
    pbstream::tests::place(to, pose.x_m, pose.y_m, pose.yaw_rad);
  };
  for (const Laid& laid : all) {
    auto*& trajectory = trajectories[laid.id.trajectory];
    if (!trajectory) {
      trajectory = poses.add_trajectory();
      trajectory->set_trajectory_id(laid.id.trajectory);
    }
    const geometry::Pose2 shift = laid.id == moved ? geometry::Pose2{0.7, -0.5, 0} : geometry::Pose2{};
    auto& submap = *trajectory->add_submap();
    submap.set_submap_index(laid.id.index);
    put(*submap.mutable_pose(), times(shift, laid.pose));
    auto& node = *trajectory->add_node();
    node.set_node_index(laid.id.index);
    node.set_timestamp(621'355'968'000'000'000 + (1'700'000'000LL + laid.id.index) * 10'000'000);
    put(*node.mutable_pose(), times(shift, laid.node));
    for (const Laid& other : all) {
      if (std::hypot(other.node.x_m - laid.node.x_m, other.node.y_m - laid.node.y_m) > 4) continue;
      auto& constraint = *poses.add_constraint();
      constraint.mutable_submap_id()->set_trajectory_id(laid.id.trajectory);
      constraint.mutable_submap_id()->set_submap_index(laid.id.index);
      constraint.mutable_node_id()->set_trajectory_id(other.id.trajectory);
      constraint.mutable_node_id()->set_node_index(other.id.index);
      put(*constraint.mutable_relative_pose(), times(inverse(laid.pose), other.node));
      constraint.set_tag(other.id == laid.id ? cartographer_state::Constraint::INTRA_SUBMAP
                                             : cartographer_state::Constraint::INTER_SUBMAP);
    }
  }
  std::string file = pbstream::tests::header() + pbstream::tests::record(graph) +
                     pbstream::tests::record(pbstream::tests::optionsRecord(int(trajectories.size())));
  for (const Laid& laid : all) file += pbstream::tests::record(stored(laid.id, *laid.texture));
  for (const Laid& laid : all)
    file += pbstream::tests::record(pbstream::tests::nodeRecord(laid.id.trajectory, laid.id.index));
  return file;
}

}  // namespace

class GuidePicturesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void inspectWhatARobotKnows() {
    Desk desk;
    QVERIFY(desk.connectTo(desk.robot().address()));
    desk.act("layoutInspect");
    desk.act("modeBoth");
    desk.front("layers");
    desk.front("robot");
    desk.act("fit");
    QVERIFY(desk.picture("inspect"));
  }

  void editAMap_data() {
    QTest::addColumn<QString>("tool");
    QTest::addColumn<QString>("dock");
    QTest::addColumn<QString>("picture");
    QTest::newRow("waypoints") << QStringLiteral("waypointTool") << QStringLiteral("waypoints")
                               << QStringLiteral("waypoints");
    QTest::newRow("picture") << QStringLiteral("pictureTool") << QStringLiteral("picture")
                             << QStringLiteral("clean");
  }
  void editAMap() {
    QFETCH(QString, tool);
    QFETCH(QString, dock);
    QFETCH(QString, picture);
    Desk desk(simulator::Options{});  // its rosbridge needs time that passes
    QVERIFY(desk.connectTo(desk.robot().kabamAddress()) && desk.openMap());
    desk.act(qPrintable(tool));
    desk.front(qPrintable(dock));
    desk.act("fit");
    QVERIFY(desk.picture(qPrintable(picture)));
  }

  void editOverlays() {
    Desk desk;
    QVERIFY(desk.connectTo(desk.robot().address()) && desk.openMap());
    desk.act("layoutOperate");
    desk.act("modeWhole");
    desk.act("overlayTool");
    QVERIFY(desk.select("overlays", "Region 15"));
    desk.act("fit");
    QVERIFY(desk.picture("overlays"));
  }

  void replayWhatHappened() {
    Desk desk;
    QVERIFY(desk.connectTo(desk.robot().address()));
    robot::BagKey key;
    bool listed = false;
    const auto call = desk.session()->robot().bagLibrary()->list([&](auto bags) {
      listed = true;
      if (bags && bags->size() > 2) key = (*bags)[1].key;
    });
    QTRY_VERIFY(listed);
    auto* const replay = ui::part<ui::ReplayController>(desk.window());
    QVERIFY(replay);
    replay->openBag(key);
    QTRY_VERIFY_WITH_TIMEOUT(replay->clock().isOpen(), 30'000);
    desk.act("modeWhole");
    QTRY_VERIFY_WITH_TIMEOUT(replay->clock().readShare() == 1, 30'000);
    replay->clock().seek(replay->clock().start() + 300);
    QTRY_VERIFY(replay->clock().knowledge() == replay::Knowledge::Exact);
    desk.act("layoutReplay");
    desk.front("events");
    desk.front("timeline");
    desk.act("fit");
    QVERIFY(desk.picture("replay"));
  }

  void compareTwoMaps() {
    Desk desk;
    QVERIFY(desk.connectTo(desk.robot().address()));
    desk.act("modeWhole");
    desk.act("compare");
    desk.act("fit");
    QVERIFY(desk.picture("compare"));
  }

  void lookWhetherAMapIsGood_data() {
    QTest::addColumn<bool>("good");
    QTest::newRow("goodmap") << true;
    QTest::newRow("badmap") << false;
  }
  void lookWhetherAMapIsGood() {
    QFETCH(bool, good);
    const pbstream::tests::Folder folder;
    std::string path;
    {
      Desk desk;
      QVERIFY(desk.connectTo("demo:?submaps=60"));
      const map::SubmapId moved{0, 30};
      QVERIFY(desk.session()->submaps().find(moved));
      path =
          folder.write(stateOf(*desk.session(), good ? std::nullopt : std::optional(moved)), "hall.pbstream");
    }
    Desk desk;
    QVERIFY(desk.connectTo(path));
    desk.act("layoutInspect");
    desk.act("modeSubmaps");
    ui::scene::MapScene& scene = *desk.window().mapScene();
    scene.setLayerVisible(ui::scene::Layer::Closures, true);
    scene.setLayerVisible(ui::scene::Layer::Disagreement, true);
    auto& dock = dynamic_cast<ui::DisagreementDock&>(desk.front("disagreement"));
    desk.act("fit");
    const auto said = [&] { return dock.summary()->text(); };
    QTRY_VERIFY_WITH_TIMEOUT(said().contains(QStringLiteral("contradict")) &&
                                 !said().contains(QStringLiteral("so far")) &&
                                 !said().contains(QStringLiteral("still")),
                             kLongMs);
    QVERIFY(desk.picture(QTest::currentDataTag()));
  }

  /// A picture that nothing makes would show an old program for ever.
  void thePagesShowJustThese() {
    const QDir top(QFINDTESTDATA("../../docs"));
    QStringList pages{top.filePath(QStringLiteral("../README.md"))};
    QDirIterator below(top.path(), {QStringLiteral("*.md")}, QDir::Files, QDirIterator::Subdirectories);
    while (below.hasNext()) pages << below.next();
    QSet<QString> shown;
    for (const QString& page : pages) {
      QFile file(page);
      QVERIFY(file.open(QIODevice::ReadOnly));
      static const QRegularExpression picture(QStringLiteral("\\]\\([^)]*pictures/(\\w+)\\.png\\)"));
      for (auto all = picture.globalMatch(QString::fromUtf8(file.readAll())); all.hasNext();)
        shown << all.next().captured(1);
    }
    QStringList kept;
    for (const QFileInfo& picture :
         QDir(top.filePath(QStringLiteral("pictures"))).entryInfoList(QDir::Files)) {
      kept << picture.baseName();
      QVERIFY2(picture.size() < 350'000, qPrintable(picture.fileName()));
    }
    QCOMPARE(kept,
             (QStringList{QStringLiteral("badmap"), QStringLiteral("clean"), QStringLiteral("compare"),
                          QStringLiteral("goodmap"), QStringLiteral("inspect"), QStringLiteral("overlays"),
                          QStringLiteral("replay"), QStringLiteral("waypoints")}));
    QCOMPARE(shown, QSet<QString>(kept.begin(), kept.end()));
  }
};

}  // namespace test_guide_pictures

MAPWRIGHT_TEST(test_guide_pictures, GuidePicturesTest, Widgets)
#include "test_guide_pictures.moc"
