// The dock of loop closures: which contradict the map, where, and what is said where there are none.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QTableView>
#include <QtTest>

#include "render/tile_renderer.h"
#include "test_program.h"
#include "ui/kit/plain_label.h"
#include "ui/slam/closures_dock.h"
#include "ui/view/map_view.h"
#include "window_bench.h"
#include "window_parts.h"

namespace test_window_closures {

using namespace mapwright;
using namespace mapwright::ui;
using test::Bench;
using test::kAddress;

namespace {

geometry::Pose3 at(double x, double y) {
  geometry::Pose3 pose;
  pose.x = x;
  pose.y = y;
  return pose;
}

/// Two submaps and three nodes; node 0-2 lies 3 m beside where submap 0-0 has it.
class Graph : public robot::PoseGraphSource {
 public:
  robot::Call fetch(robot::OutcomeTo<std::shared_ptr<const map::PoseGraph>> reply) override {
    ++asked;
    QTimer::singleShot(0, &timers_, [this, reply] {
      if (fails) return reply(tl::make_unexpected(map::Failure{map::FailureKind::TimedOut}));
      reply(std::make_shared<const map::PoseGraph>(graph));
    });
    return {};
  }
  Graph() {
    using map::ConstraintKind;
    graph.submaps = {{{0, 0}, at(0, 0)}, {{0, 1}, at(10, 0)}};
    graph.trajectories = {
        {0, {{{0, 0}, 1.7e9, at(1, 0)}, {{0, 1}, 1.7e9, at(2, 0)}, {{0, 2}, 1.7e9, at(20, 0)}}}};
    graph.constraints = {{{0, 0}, {0, 0}, at(1, 0), ConstraintKind::Intra, 1, 1},
                         {{0, 0}, {0, 1}, at(2, 0.05), ConstraintKind::Inter, 1, 1},
                         {{0, 0}, {0, 2}, at(20, 3), ConstraintKind::Inter, 1, 1},
                         {{0, 1}, {0, 2}, at(10, 0.2), ConstraintKind::Inter, 1, 1}};
  }
  map::PoseGraph graph;
  bool fails = false;
  int asked = 0;

 private:
  QObject timers_;
};

struct Desk : Bench {
  Desk() {
    prepare = [this](test::FakeRobot& made) { made.pose_graph = with_graph ? &graph : nullptr; };
  }
  ~Desk() { window.reset(); }
  ClosuresDock& openDock() {
    Bench::open();
    if (window->connectTo(kAddress)) qFatal("not connected");
    dock = part<ClosuresDock>(*window);
    dock->toggleViewAction()->trigger();
    return *dock;
  }
  QString text(int row, ClosuresModel::Column column) {
    return dock->model()->index(row, column).data().toString();
  }
  bool says(const QString& words) {
    const auto labels = dock->findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(),
                       [&](const QLabel* label) { return label->text().contains(words); });
  }

  Graph graph;
  bool with_graph = true;
  ClosuresDock* dock = nullptr;
};

}  // namespace

class TestWindowClosures : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theWorstIsFirstAndItsPlacesAreShown() {
    Desk desk;
    ClosuresDock& dock = desk.openDock();
    QTRY_COMPARE(dock.model()->rowCount(), 3);
    QCOMPARE(desk.text(0, ClosuresModel::ResidualColumn), QStringLiteral("3.000"));
    QCOMPARE(desk.text(0, ClosuresModel::SubmapColumn), QStringLiteral("0-0"));
    QCOMPARE(desk.text(0, ClosuresModel::NodeColumn), QStringLiteral("0-2"));
    QCOMPARE(desk.text(1, ClosuresModel::ResidualColumn), QStringLiteral("0.200"));
    QVERIFY(desk.says(QStringLiteral("3 loop closures. 1 contradicts the finished map by more than 0.5 m.")));
    desk.load();
    const QModelIndex first = dock.model()->index(0, 0);
    QTest::mouseClick(dock.table()->viewport(), Qt::LeftButton, {}, dock.table()->visualRect(first).center());
    const geometry::WorldRect seen = desk.window->mapScene()->view().visibleWorld();
    QVERIFY(seen.contains({20, 0}) && seen.contains({20, 3}));
    QVERIFY(desk.window->mapScene()->highlighted().contains({0, 0}));
    QVERIFY(desk.says(QStringLiteral("Lies at 20.000, 0.000 m\nExpected at 20.000, 3.000 m")));
    desk.key(Qt::Key_Escape);
    desk.key(Qt::Key_Escape);
    QVERIFY(desk.window->mapScene()->highlighted().empty());
  }

  void aShortDistanceIsSeenWhenItsRowIsChosen() {
    Desk desk;
    desk.graph.graph.constraints = {{{0, 0}, {0, 1}, at(2, 0.028), map::ConstraintKind::Inter, 1, 1},
                                    {{0, 0}, {0, 2}, at(20, 0), map::ConstraintKind::Inter, 1, 1}};
    ClosuresDock& dock = desk.openDock();
    QTRY_COMPARE(dock.model()->rowCount(), 2);
    desk.load();
    const auto apart_px = [&](int row) {
      dock.table()->setCurrentIndex(dock.model()->index(row, 0));
      const ClosureRow& shown = dock.model()->row(row);
      return (shown.expected - shown.at).norm() / part<MapView>(*desk.window)->destination().scale_m_per_px;
    };
    QVERIFY(apart_px(0) >= 20);
    // Of none at all 30 cm are seen.
    QCOMPARE(apart_px(1), 0.0);
    QVERIFY(part<MapView>(*desk.window)->destination().visibleWorld().width() >= 0.29);
  }

  void aClosureOfTheMapIsPicked() {
    Desk desk;
    ClosuresDock& dock = desk.openDock();
    QTRY_COMPARE(dock.model()->rowCount(), 3);
    desk.load();
    desk.window->mapScene()->setLayersVisible({ui::scene::Layer::Closures});
    MapView& view = *part<MapView>(*desk.window);
    view.fit({15, -3, 25, 6}, false);
    const auto click = [&](double x, double y) {
      const Eigen::Vector2d px = desk.window->mapScene()->view().pixelFromWorld({x, y});
      QTest::mouseClick(view.viewport(), Qt::LeftButton, {}, QPoint(int(px.x()), int(px.y())));
    };
    const geometry::ViewTransform before = view.destination();
    QVERIFY(!desk.window->mapScene()->objectsAt({20, 2}, 6).empty());
    click(20, 2);
    QCOMPARE(dock.table()->currentIndex().row(), 0);
    QVERIFY(dock.table()->selectionModel()->isRowSelected(0));
    QVERIFY(desk.says(QStringLiteral("Expected at 20.000, 3.000 m")));
    QVERIFY(desk.window->mapScene()->highlighted().contains({0, 0}));
    QVERIFY(view.destination() == before);
    QVERIFY(
        dock.table()->viewport()->rect().contains(dock.table()->visualRect(dock.table()->currentIndex())));
    // By submap it is in the row of its submap.
    dock.findChildren<QCheckBox*>().front()->click();
    QVERIFY(!dock.table()->currentIndex().isValid());
    click(20, 2);
    QCOMPARE(desk.text(dock.table()->currentIndex().row(), ClosuresModel::SubmapColumn),
             QStringLiteral("0-0"));
  }

  void theMapShowsWhatIsListed() {
    Desk desk;
    ClosuresDock& dock = desk.openDock();
    QTRY_COMPARE(dock.model()->rowCount(), 3);
    desk.load();
    ui::scene::MapScene& scene = *desk.window->mapScene();
    scene.setLayersVisible({ui::scene::Layer::Closures});
    // Of what is drawn; the three lines begin at x = 2, 20 and 20, that of a constraint within a submap at 1.
    const auto on_map = [&] { return scene.layerBounds(ui::scene::Layer::Closures); };
    using geometry::WorldRect;
    const auto says = [&](const QString& words) {
      const auto labels = dock.findChildren<PlainLabel*>();
      return std::any_of(labels.begin(), labels.end(),
                         [&](const PlainLabel* label) { return label->text() == words; });
    };
    QCOMPARE(on_map(), (WorldRect{2, 0, 20, 3}));
    auto* const least = dock.findChild<QDoubleSpinBox*>();
    least->setValue(0.1);
    QCOMPARE(on_map(), (WorldRect{20, 0, 20, 3}));
    QVERIFY(says(QStringLiteral("2 of 4 constraints, and only these on the map")));
    auto* const kinds = dock.findChild<QComboBox*>();
    least->setValue(0);
    kinds->setCurrentIndex(1);
    QCOMPARE(on_map(), (WorldRect{1, 0, 1, 0}));
    kinds->setCurrentIndex(0);
    least->setValue(1);
    // It may be another graph now.
    desk.graph.graph.constraints[2].relative_pose.y = 4;
    Q_EMIT desk.robot->mapsChanged();
    QTRY_COMPARE(on_map(), (WorldRect{20, 0, 20, 4}));
    scene.setLayerVisible(ui::scene::Layer::Closures, false);
    QVERIFY(says(QStringLiteral("1 of 4 constraints")));
    scene.setLayerVisible(ui::scene::Layer::Closures, true);
    // What a closed panel leaves out cannot be known.
    dock.close();
    QCOMPARE(on_map(), (WorldRect{2, 0, 20, 4}));
    dock.show();
    QCOMPARE(on_map(), (WorldRect{20, 0, 20, 4}));
  }

  void aSquareIsWhereTheRobotShouldLie() {
    ui::scene::MapScene scene{render::TileRenderer::Options{}};
    for (const ui::scene::Layer layer : ui::scene::allLayers()) scene.setLayerVisible(layer, false);
    geometry::ViewTransform view;  // a pixel is 5 cm
    view.width_px = 400;
    view.height_px = 300;
    scene.setView(view);
    const auto painted = [&] {
      QImage image(400, 300, QImage::Format_RGB32);
      QPainter painter(&image);
      const QRectF whole(0, 0, 400, 300);
      scene.render(&painter, whole, whole);
      return image;
    };
    const QImage ground = painted();
    ui::scene::MapObject closure;
    closure.id.layer = ui::scene::Layer::Closures;
    closure.form = ui::scene::ObjectForm::Line;
    closure.parts = {{{-2, 0}, {2, 0}}};
    scene.setMarked(closure);
    const QImage marked = painted();
    const auto drawn = [&](int x, int y) { return marked.pixel(x, y) != ground.pixel(x, y); };
    QVERIFY(drawn(160, 150) && !drawn(240, 150));  // a dot, and a frame
    QVERIFY(!drawn(168, 142) && drawn(248, 142));  // corners
    // Away from each other they are named.
    const auto written = [&](int from, int to) {
      for (int x = from; x < to; ++x)
        if (drawn(x, 150)) return true;
      return false;
    };
    QVERIFY(written(100, 145) && written(256, 310));
  }

  void theListCanBeNarrowed() {
    Desk desk;
    ClosuresDock& dock = desk.openDock();
    QTRY_COMPARE(dock.model()->rowCount(), 3);
    auto* const least = dock.findChild<QDoubleSpinBox*>();
    least->setValue(0.1);
    QCOMPARE(dock.model()->rowCount(), 2);
    least->setValue(0);
    QTest::keyClicks(dock.filterEdit(), QStringLiteral("0-1"));
    QCOMPARE(dock.model()->rowCount(), 2);  // the submap, and the node of that name
    dock.filterEdit()->clear();
    auto* const kinds = dock.findChild<QComboBox*>();
    kinds->setCurrentIndex(2);
    QCOMPARE(dock.model()->rowCount(), 4);
    kinds->setCurrentIndex(0);
    dock.findChildren<QCheckBox*>().front()->click();
    QCOMPARE(dock.model()->rowCount(), 2);
    QCOMPARE(desk.text(0, ClosuresModel::NodeColumn), QStringLiteral("1 of 2"));
    QVERIFY(!dock.model()->index(0, 0).siblingAtColumn(ClosuresModel::TimeColumn).data().isValid());
  }

  void aSubmapThatIsChosenIsListedAlone() {
    Desk desk;
    desk.graph.graph.submaps.push_back({{0, 10}, at(0, 0)});
    desk.graph.graph.constraints.push_back({{0, 10}, {0, 1}, at(2, 0.01), map::ConstraintKind::Inter, 1, 1});
    ClosuresDock& dock = desk.openDock();
    QTRY_COMPARE(dock.model()->rowCount(), 4);
    QCheckBox* const by_submap = dock.findChildren<QCheckBox*>().front();
    by_submap->click();
    QCOMPARE(dock.model()->rowCount(), 3);
    QCOMPARE(desk.text(1, ClosuresModel::SubmapColumn), QStringLiteral("0-1"));
    dock.table()->setCurrentIndex(dock.model()->index(1, 0));
    QTest::keyClick(dock.table(), Qt::Key_Return);
    // Neither 0-10 nor the node 0-1.
    QCOMPARE(dock.model()->rowCount(), 1);
    QVERIFY(dock.filterEdit()->text().isEmpty());
    QVERIFY(dock.onlySubmap()->isVisible());
    QCOMPARE(dock.onlySubmap()->text(), QStringLiteral("Submap 0-1"));
    dock.onlySubmap()->click();
    QCOMPARE(dock.model()->rowCount(), 4);
    QVERIFY(!dock.onlySubmap()->isVisible());
    // Typed: a whole id is not the beginning of another one.
    dock.filterEdit()->setText(QStringLiteral("0-10"));
    QCOMPARE(dock.model()->rowCount(), 1);
    dock.filterEdit()->setText(QStringLiteral("0-1"));
    QCOMPARE(dock.model()->rowCount(), 3);
  }

  void theSubmapWithMostContradictionsIsFirst() {
    ClosuresModel model;
    const auto row = [](double off, int submap) {
      return ClosureRow{.residual_m = off, .submap = map::SubmapId{0, submap}, .node = map::NodeId{0, 0}};
    };
    model.setRows({row(9, 1), row(2, 2), row(1, 2), row(0.5, 1), row(0.1, 3)});
    model.setFilter({.by_submap = true});
    QCOMPARE(model.rowCount(), 3);
    QCOMPARE(model.row(0).submap->index, 2);
    QCOMPARE(model.index(0, ClosuresModel::NodeColumn).data().toString(), QStringLiteral("2 of 2"));
    QCOMPARE(model.index(1, ClosuresModel::NodeColumn).data().toString(), QStringLiteral("1 of 2"));
    QCOMPARE(model.index(2, ClosuresModel::NodeColumn).data().toString(), QStringLiteral("0 of 1"));
  }

  void nothingIsAskedBeforeItIsLookedAt() {
    Desk desk;
    desk.open();
    QVERIFY(!desk.window->connectTo(kAddress));
    QTRY_VERIFY(desk.window->session());
    QCOMPARE(desk.graph.asked, 0);
    desk.window->mapScene()->setLayerVisible(ui::scene::Layer::Closures, true);
    QTRY_COMPARE(desk.graph.asked, 1);
    // It may be another one now.
    Q_EMIT desk.robot->mapsChanged();
    QTRY_COMPARE(desk.graph.asked, 2);
  }

  void aMapWithoutLoopsSaysSo() {
    Desk desk;
    desk.graph.graph.constraints.resize(1);
    ClosuresDock& dock = desk.openDock();
    QTRY_VERIFY(desk.says(QStringLiteral("No loop was closed")));
    QCOMPARE(dock.model()->rowCount(), 0);
  }

  void whatCannotBeReadIsSaid() {
    Desk desk;
    desk.graph.fails = true;
    desk.openDock();
    QTRY_VERIFY(desk.says(QStringLiteral("The pose graph was not read.")));
  }

  void aHeaderSortsAndTheRowStaysCurrent() {
    Desk desk;
    ClosuresDock& dock = desk.openDock();
    QTRY_COMPARE(dock.model()->rowCount(), 3);
    dock.table()->setCurrentIndex(dock.model()->index(0, 0));
    QCOMPARE(desk.text(0, ClosuresModel::ResidualColumn), QStringLiteral("3.000"));
    dock.table()->sortByColumn(ClosuresModel::SubmapColumn, Qt::DescendingOrder);
    QCOMPARE(desk.text(0, ClosuresModel::SubmapColumn), QStringLiteral("0-1"));
    QCOMPARE(dock.table()->currentIndex().row(), 1);
    dock.table()->sortByColumn(ClosuresModel::ResidualColumn, Qt::AscendingOrder);
    QCOMPARE(desk.text(0, ClosuresModel::ResidualColumn), QStringLiteral("0.050"));
    QCOMPARE(dock.table()->currentIndex().row(), 2);
    // Neither: the worst first.
    dock.table()->sortByColumn(-1, Qt::AscendingOrder);
    QCOMPARE(dock.table()->currentIndex().row(), 0);
  }

  void noHeaderIsCutInANarrowPanel() {
    Desk desk;
    desk.open({1366, 768});
    QVERIFY(!desk.window->connectTo(kAddress));
    ClosuresDock& dock = *part<ClosuresDock>(*desk.window);
    dock.toggleViewAction()->trigger();
    QTRY_COMPARE(dock.model()->rowCount(), 3);
    const QHeaderView& header = *dock.table()->horizontalHeader();
    for (const bool by_submap : {false, true}) {
      dock.findChildren<QCheckBox*>().front()->setChecked(by_submap);
      for (int sorted = -1; sorted < ClosuresModel::kColumns; ++sorted) {
        dock.table()->sortByColumn(sorted, Qt::AscendingOrder);
        for (int column = 0; column < ClosuresModel::kColumns; ++column) {
          if (header.isSectionHidden(column)) continue;
          QVERIFY2(header.sectionSize(column) >= header.sectionSizeHint(column),
                   qPrintable(QStringLiteral("%1 of %2, sorted by %3, has %4 of %5")
                                  .arg(column)
                                  .arg(by_submap)
                                  .arg(sorted)
                                  .arg(header.sectionSize(column))
                                  .arg(header.sectionSizeHint(column))));
        }
      }
    }
  }

  void residualsOfAMappingRobotAreListedWithoutIds() {
    Desk desk;
    desk.with_graph = false;
    ClosuresDock& dock = desk.openDock();
    QTRY_VERIFY(!dock.model()->rowCount());
    map::ConstraintsMessage lists;
    lists.by_name["Inter residuals, same trajectory"] = {{{0, 0}, {0, 1}}, {{1, 0}, {1, 4}}};
    lists.by_name["Inter constraints, same trajectory"] = {{{0, 0}, {9, 9}}};
    desk.robot->say(lists);
    QTRY_COMPARE(dock.model()->rowCount(), 2);
    QCOMPARE(desk.text(0, ClosuresModel::ResidualColumn), QStringLiteral("4.000"));
    QVERIFY(desk.says(QStringLiteral("does not say which submaps")));
    dock.findChildren<QCheckBox*>().front()->click();
    QCOMPARE(dock.model()->rowCount(), 0);
    const auto labels = dock.findChildren<PlainLabel*>();
    QVERIFY(std::any_of(labels.begin(), labels.end(), [](const PlainLabel* label) {
      return label->text().contains(QStringLiteral("does not name the submaps"));
    }));
  }
};

}  // namespace test_window_closures

MAPWRIGHT_TEST(test_window_closures, TestWindowClosures, Widgets)
#include "test_window_closures.moc"
