// The list of layers: groups, order, styles, presets, one layer alone, what a robot cannot fill.
#include <map>
#include <memory>
#include <set>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QSlider>
#include <QToolButton>
#include <QtTest>

#include "robot/offers_topics.h"
#include "test_program.h"
#include "ui/layers/fold_header.h"
#include "ui/layers/layer_row.h"
#include "ui/layers/layers_controller.h"
#include "ui/layers/layers_dock.h"
#include "ui/layers/preset_menu.h"
#include "ui/window/command_palette.h"
#include "window_bench.h"
#include "window_parts.h"

namespace test_window_layers {

using namespace mapwright;
using namespace mapwright::ui;
using test::Bench;
using test::kAddress;
using ui::scene::Layer;

namespace {

std::ptrdiff_t layerIndexOf(const ui::scene::MapScene& scene, Layer layer) {
  const std::vector<Layer>& order = scene.layerOrder();
  return std::find(order.begin(), order.end(), layer) - order.begin();
}

/// Step by step: the row itself moves below the cursor.
void dragTo(LayersDock& dock, LayerRow* row, const LayerRow* target) {
  const QPoint from(60, 12);
  QTest::mousePress(row, Qt::LeftButton, {}, from);
  for (int step = 0; step < 20; ++step) {
    const QPoint to = target->mapTo(&dock, QPoint(60, 20));
    QMouseEvent move(QEvent::MouseMove, row->mapFrom(&dock, to), QPoint(), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(row, &move);
    QCoreApplication::processEvents();
  }
  QTest::mouseRelease(row, Qt::LeftButton, {}, from);
}

std::set<Layer> shownIn(const ui::scene::MapScene& scene) {
  std::set<Layer> shown;
  for (const Layer layer : ui::scene::allLayers()) {
    if (scene.layerVisible(layer)) shown.insert(layer);
  }
  return shown;
}

/// An entry of a menu by its text; null: there is none.
QAction* entry(const QMenu& menu, const QString& text) {
  for (QAction* const action : menu.actions()) {
    if (plainActionText(*action) == text) return action;
  }
  return nullptr;
}

/// One whose topics are its own affair.
class TopicsRobot : public test::FakeRobot, public robot::OffersTopics {
 public:
  using FakeRobot::FakeRobot;
  std::optional<std::vector<robot::OfferedTopic>> offered() const override { return std::nullopt; }
  QStringList choicesFor(map::Stream stream) const override {
    return stream == map::Stream::Path || stream == map::Stream::CostmapLow ? choices : QStringList();
  }
  void choose(const robot::TopicChoices& topics) override { picked = topics; }
  robot::TopicChoices chosen() const override { return picked; }
  std::optional<robot::Reception> reception() const override { return std::nullopt; }

  QStringList choices{QStringLiteral("/a"), QStringLiteral("/b")};
  robot::TopicChoices picked;
};

}  // namespace

class TestWindowLayers : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void hasARowForEveryLayerTheTopOneOnTop() {
    Bench bench;
    MainWindow& window = bench.open();
    for (const Layer layer : ui::scene::allLayers()) QVERIFY(part<LayersDock>(window)->row(layer));
    QVERIFY(part<LayersDock>(window)->row(Layer::Robot)->y() <
            part<LayersDock>(window)->row(Layer::Submaps)->y());
    QVERIFY(part<LayersDock>(window)->row(Layer::Submaps)->y() <
            part<LayersDock>(window)->row(Layer::WholeMap)->y());
  }

  void movesARowByDraggingIt() {
    Bench bench;
    MainWindow& window = bench.open();
    LayersDock& dock = *part<LayersDock>(window);
    dock.setGrouped(false);
    LayerRow* grid = dock.row(Layer::Grid);
    LayerRow* submaps = dock.row(Layer::Submaps);
    QVERIFY(layerIndexOf(*window.mapScene(), Layer::Grid) > layerIndexOf(*window.mapScene(), Layer::Submaps));
    dragTo(dock, grid, submaps);
    QVERIFY(layerIndexOf(*window.mapScene(), Layer::Grid) < layerIndexOf(*window.mapScene(), Layer::Submaps));
    QTRY_VERIFY(grid->y() > submaps->y());
  }

  void aDraggedRowKeepsToItsGroupAndPassesNoMoreThanItMust() {
    Bench bench;
    MainWindow& window = bench.open({1366, 1600});
    LayersDock& dock = *part<LayersDock>(window);
    const std::vector<Layer> before = window.mapScene()->layerOrder();
    QVERIFY(dock.row(Layer::Waypoints)->y() < dock.row(Layer::Overlays)->y());
    dragTo(dock, dock.row(Layer::Waypoints), dock.row(Layer::WholeMap));
    // It is the last of the annotations, right below the one that it has passed; all others are as before.
    std::vector<Layer> expected = before;
    std::erase(expected, Layer::Waypoints);
    expected.insert(std::find(expected.begin(), expected.end(), Layer::Grid), Layer::Waypoints);
    QCOMPARE(window.mapScene()->layerOrder(), expected);
    QVERIFY(dock.row(Layer::Waypoints)->y() > dock.row(Layer::Grid)->y());
    QVERIFY(dock.row(Layer::Waypoints)->y() < dock.header(ui::scene::LayerGroup::Map)->y());
    // Upwards it never passes the scale bar.
    dragTo(dock, dock.row(Layer::Waypoints), dock.row(Layer::Robot));
    QCOMPARE(window.mapScene()->layerOrder().back(), Layer::ScaleBar);
    QVERIFY(dock.row(Layer::Waypoints)->y() > dock.row(Layer::ScaleBar)->y());
    QVERIFY(dock.row(Layer::Waypoints)->y() < dock.row(Layer::Overlays)->y());
  }

  void everyLayerIsInItsGroupAsItIsPainted() {
    Bench bench;
    MainWindow& window = bench.open();
    LayersDock& dock = *part<LayersDock>(window);
    std::map<ui::scene::LayerGroup, int> last;
    const std::vector<Layer>& order = window.mapScene()->layerOrder();
    for (auto it = order.rbegin(); it != order.rend(); ++it) {
      const ui::scene::LayerGroup group = ui::scene::specOf(*it).group;
      const int y = dock.row(*it)->y();
      QVERIFY(y > dock.header(group)->y());
      if (last.contains(group)) QVERIFY(y > last[group]);
      last[group] = y;
      for (const ui::scene::LayerGroup other : ui::scene::kLayerGroups) {
        if (other > group) QVERIFY(y < dock.header(other)->y());
      }
    }
    QCOMPARE(last.size(), std::size_t(4));
  }

  void groupsFoldAndStayFolded() {
    Bench bench;
    {
      MainWindow& window = bench.open();
      LayersDock& dock = *part<LayersDock>(window);
      QTest::mouseClick(dock.header(ui::scene::LayerGroup::Map), Qt::LeftButton);
      QVERIFY(!dock.row(Layer::Submaps)->isVisible());
      QVERIFY(dock.row(Layer::Cloud)->isVisible());
      QVERIFY(window.mapScene()->layerVisible(Layer::Submaps));
      QTest::keyClick(dock.header(ui::scene::LayerGroup::Environment), Qt::Key_Left);
      QVERIFY(!dock.row(Layer::Cloud)->isVisible());
      QTest::keyClick(dock.header(ui::scene::LayerGroup::Environment), Qt::Key_Right);
      QVERIFY(dock.row(Layer::Cloud)->isVisible());
      window.close();
    }
    MainWindow& again = bench.open();
    LayersDock& dock = *part<LayersDock>(again);
    QVERIFY(!dock.row(Layer::Submaps)->isVisible());
    QVERIFY(!dock.header(ui::scene::LayerGroup::Map)->open());
    bench.action("resetLayout")->trigger();
    QVERIFY(dock.row(Layer::Submaps)->isVisible());
  }

  void arrowKeysGoThroughHeadingsAndRows() {
    Bench bench;
    MainWindow& window = bench.open();
    LayersDock& dock = *part<LayersDock>(window);
    FoldHeader* const map = dock.header(ui::scene::LayerGroup::Map);
    map->setFocus();
    QTest::keyClick(map, Qt::Key_Up);
    QVERIFY(dock.row(Layer::Grid)->hasFocus());
    QTest::keyClick(dock.row(Layer::Grid), Qt::Key_Down);
    QVERIFY(map->hasFocus());
    QTest::keyClick(map, Qt::Key_Space);
    QVERIFY(!map->open());
  }

  void filtersByTitleAndName() {
    Bench bench;
    MainWindow& window = bench.open();
    LayersDock& dock = *part<LayersDock>(window);
    dock.header(ui::scene::LayerGroup::Environment)->click();
    QTest::keyClicks(dock.filterField(), QStringLiteral("lidar"));
    QVERIFY(dock.row(Layer::Cloud)->isVisible());  // although its group is folded
    QVERIFY(!dock.row(Layer::Path)->isVisible());
    QVERIFY(!dock.header(ui::scene::LayerGroup::Robot)->isVisible());
    dock.filterField()->clear();
    QVERIFY(!dock.row(Layer::Cloud)->isVisible());
    QTest::keyClicks(dock.filterField(), QStringLiteral("COSTMAP-H"));  // as the command line calls it
    QVERIFY(dock.row(Layer::CostmapHigh)->isVisible());
    QVERIFY(!dock.row(Layer::CostmapLow)->isVisible());
    QTest::keyClicks(dock.filterField(), QStringLiteral("x"));
    for (const Layer layer : ui::scene::allLayers()) QVERIFY(!dock.row(layer)->isVisible());
  }

  void altClickShowsALayerAloneAndTheNextWhatWasThereBefore() {
    Bench bench;
    MainWindow& window = bench.open();
    LayersDock& dock = *part<LayersDock>(window);
    const std::set<Layer> before = shownIn(*window.mapScene());
    const auto altClick = [&](Layer layer) {
      QTest::mouseClick(dock.eye(layer), Qt::LeftButton, Qt::AltModifier);
    };
    altClick(Layer::Cloud);
    QCOMPARE(shownIn(*window.mapScene()), std::set<Layer>{Layer::Cloud});
    altClick(Layer::CostmapLow);  // another one
    QCOMPARE(shownIn(*window.mapScene()), std::set<Layer>{Layer::CostmapLow});
    altClick(Layer::CostmapLow);
    QCOMPARE(shownIn(*window.mapScene()), before);
    // From the menu, and back by the strip, whatever was switched on meanwhile.
    QMenu menu;
    dock.fillMenu(menu, Layer::Cloud);
    entry(menu, QStringLiteral("Show only this layer"))->trigger();
    dock.eye(Layer::Robot)->click();
    QCOMPARE(shownIn(*window.mapScene()), (std::set<Layer>{Layer::Cloud, Layer::Robot}));
    auto* const back = dock.findChild<QWidget*>(QStringLiteral("soloStrip"))->findChild<QPushButton*>();
    QVERIFY(back->isVisible());
    QTest::mouseClick(back, Qt::LeftButton);
    QCOMPARE(shownIn(*window.mapScene()), before);
    QVERIFY(!back->isVisible());
    // One that is alone is not what the next start begins with.
    altClick(Layer::Cloud);
    window.close();
    QCOMPARE(shownIn(*bench.open().mapScene()), before);
  }

  void zoomsToWhatALayerHolds() {
    Bench bench;
    MainWindow& window = bench.open();
    LayersDock& dock = *part<LayersDock>(window);
    QVERIFY(!window.connectTo(kAddress));
    bench.load();
    const auto zoom = [&](QMenu& menu, Layer layer) {
      dock.fillMenu(menu, layer);
      return entry(menu, QStringLiteral("Zoom to this layer"));
    };
    QMenu empty;
    QVERIFY(!zoom(empty, Layer::Cloud)->isEnabled());
    QVERIFY(!zoom(empty, Layer::Cloud)->toolTip().isEmpty());
    QMenu hidden;
    QVERIFY(zoom(hidden, Layer::CostmapLow)->toolTip().contains(QLatin1String("hidden")));
    auto points = std::make_shared<std::vector<map::CloudPoint>>();
    points->push_back({100, 50, 0, 0});
    points->push_back({110, 54, 0, 0});
    bench.robot->say(map::PointCloudMessage{"/points", points});
    QMenu cloud;
    QVERIFY(zoom(cloud, Layer::Cloud)->isEnabled());
    zoom(cloud, Layer::Cloud)->trigger();
    const geometry::WorldRect seen = window.view()->destination().visibleWorld();
    QVERIFY(seen.contains({100, 50}) && seen.contains({110, 54}));
    QVERIFY(seen.width() < 40 && !seen.contains({0, 0}));
    QMenu submaps;
    zoom(submaps, Layer::Submaps)->trigger();
    const geometry::WorldRect all = window.view()->destination().visibleWorld();
    QVERIFY(all.contains({0, 0}) && all.contains({40, 0}));
  }

  void builtInPresetsChooseTheLayersAndLeaveTheMapAndStylesAlone() {
    Bench bench;
    MainWindow& window = bench.open();
    ui::scene::MapScene& scene = *window.mapScene();
    const ui::scene::LayerStyle style{QColor(10, 200, 30), 4.5, 1};
    scene.setLayerStyle(Layer::Cloud, style);
    scene.setLayerVisible(Layer::WholeMap, true);
    bench.action("layersMapOnly")->trigger();
    QCOMPARE(shownIn(scene), (std::set<Layer>{Layer::WholeMap, Layer::Submaps, Layer::Regions,
                                              Layer::DispatchedCloud, Layer::ScaleBar}));
    bench.action("layersNavigation")->trigger();
    QVERIFY(scene.layerVisible(Layer::CostmapLow) && scene.layerVisible(Layer::WholeMap));
    QVERIFY(!scene.layerVisible(Layer::Constraints));
    bench.action("layersMapping")->trigger();
    QVERIFY(scene.layerVisible(Layer::Constraints) && !scene.layerVisible(Layer::CostmapLow));
    bench.action("layersAll")->trigger();
    QCOMPARE(shownIn(scene).size(), ui::scene::allLayers().size());
    QCOMPARE(scene.layerStyle(Layer::Cloud), style);
    QMenu& menu = *part<LayersController>(window)->presets()->menu();
    QVERIFY(entry(menu, QStringLiteral("Layers: All"))->isChecked());
    QVERIFY(!entry(menu, QStringLiteral("Layers: Mapping"))->isChecked());
    bench.action("layersAll")->trigger();  // again: nothing to take back
    QVERIFY(bench.action("layersAll")->isChecked());
    scene.setLayerVisible(Layer::Ids, false);
    QVERIFY(!bench.action("layersAll")->isChecked());
    // They are where commands are looked for.
    CommandPalette palette(window.actionList(), Findings(), nullptr);
    QTest::keyClicks(palette.field(), QStringLiteral("layers: map only"));
    QCOMPARE(palette.list()->item(0)->text(), QStringLiteral("Layers: Map only"));
  }

  void everyCommandIsFoundByItsName() {
    Bench bench;
    MainWindow& window = bench.open();
    CommandPalette palette(window.actionList(), Findings(), nullptr);
    for (const Actions::Entry& entry : window.actionList().entries()) {
      if (!entry.action->isVisible()) continue;
      palette.field()->setText(nameAlone(entry));
      QVERIFY2(palette.list()->item(0)->text().startsWith(nameAlone(entry)), qPrintable(nameAlone(entry)));
    }
    // What cannot be done now is found and does nothing: no other command in its place.
    QVERIFY(!bench.action("redo")->isEnabled());
    const bool before = bench.action("replayReadAll")->isChecked();
    palette.show();
    palette.field()->setText(QStringLiteral("redo"));
    QTest::keyClick(palette.field(), Qt::Key_Return);
    QVERIFY(palette.isVisible());
    QCOMPARE(bench.action("replayReadAll")->isChecked(), before);
  }

  void presetsAreSavedRenamedAndDeleted() {
    Bench bench;
    const ui::scene::LayerStyle style{QColor(10, 200, 30), 4.5, 1};
    const QString first = QStringLiteral("Dock & lift"), listed = QStringLiteral("Layers: Dock & lift");
    {
      MainWindow& window = bench.open();
      ui::scene::MapScene& scene = *window.mapScene();
      PresetMenu& presets = *part<LayersController>(window)->presets();
      scene.setLayersVisible({Layer::Submaps, Layer::Cloud, Layer::Robot});
      scene.setLayerStyle(Layer::Cloud, style);
      scene.setLayerOpacity(Layer::Submaps, 0.5);
      bench.action("saveLayerPreset")->trigger();
      auto* const dialog = window.findChild<PresetNameDialog*>();
      QVERIFY(dialog && dialog->isVisible() && !dialog->yes()->isEnabled());
      QTest::keyClicks(dialog->field(), QStringLiteral("mapping"));  // always there
      QVERIFY(!dialog->yes()->isEnabled());
      dialog->field()->clear();
      QTest::keyClicks(dialog->field(), first);
      QTest::keyClick(dialog->field(), Qt::Key_Return);
      QCOMPARE(presets.own().size(), std::size_t(1));
      bench.action("resetLayout")->trigger();
      QVERIFY(scene.layerStyle(Layer::Cloud) == ui::scene::LayerStyle{} && scene.layerVisible(Layer::Path));
      QCOMPARE(presets.own().size(), std::size_t(1));  // resetting deletes none
      CommandPalette palette(window.actionList(), Findings(), nullptr);
      QTest::keyClicks(palette.field(), QStringLiteral("dock lift"));
      QCOMPARE(palette.list()->item(0)->text(), listed);
      window.close();
    }
    MainWindow& window = bench.open();
    ui::scene::MapScene& scene = *window.mapScene();
    PresetMenu& presets = *part<LayersController>(window)->presets();
    QVERIFY(entry(*presets.menu(), listed));
    entry(*presets.menu(), listed)->trigger();
    QCOMPARE(shownIn(scene), (std::set<Layer>{Layer::Submaps, Layer::Cloud, Layer::Robot}));
    QCOMPARE(scene.layerStyle(Layer::Cloud), style);
    QCOMPARE(scene.layerOpacity(Layer::Submaps), 0.5);
    PresetNameDialog* const dialog = presets.askForOtherName(first);
    dialog->field()->setText(QStringLiteral("Lift"));
    dialog->yes()->click();
    QVERIFY(!entry(*presets.menu(), listed));
    QMenu* const removing = entry(*presets.menu(), QStringLiteral("Delete"))->menu();
    QVERIFY(removing);
    removing->popup(window.mapToGlobal(QPoint(100, 100)));
    removing->setActiveAction(entry(*removing, QStringLiteral("Lift")));
    QTest::keyClick(removing, Qt::Key_Return);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QVERIFY(presets.own().empty() && !entry(*presets.menu(), QStringLiteral("Layers: Lift")));
    QVERIFY(!bench.action("layerPreset-Lift"));
    QCOMPARE(scene.layerStyle(Layer::Cloud), style);  // the layers stay
    bench.window.reset();
    QVERIFY(savedPresets(bench.settings).empty());
  }

  void aPresetOfAnotherRobotShowsAMapHereToo() {
    Bench bench;
    bench.prepare = [](test::FakeRobot& robot) {
      robot.has_submaps = false;
      robot.has_catalogue = true;
    };
    MainWindow& window = bench.open();
    PresetMenu& presets = *part<LayersController>(window)->presets();
    window.mapScene()->setLayersVisible({Layer::Submaps, Layer::Robot});
    presets.save(QStringLiteral("Submaps"));
    QVERIFY(!window.connectTo(kAddress));
    presets.choose(presets.own().front());
    QVERIFY(window.mapScene()->layerVisible(Layer::WholeMap));
    QVERIFY(window.mapScene()->layerVisible(Layer::Robot));
  }

  void movesARowByKeys() {
    Bench bench;
    MainWindow& window = bench.open();
    const std::vector<Layer> before = window.mapScene()->layerOrder();
    LayerRow* grid = part<LayersDock>(window)->row(Layer::Grid);
    grid->setFocus();
    QTest::keyClick(grid, Qt::Key_Up, Qt::ControlModifier);
    QCOMPARE(layerIndexOf(*window.mapScene(), Layer::Grid),
             std::find(before.begin(), before.end(), Layer::Grid) - before.begin() + 1);
    QVERIFY(grid->hasFocus());
    QTest::keyClick(grid, Qt::Key_Down, Qt::ControlModifier);
    QCOMPARE(window.mapScene()->layerOrder(), before);
  }

  void keepsTheScaleBarOnTop() {
    Bench bench;
    MainWindow& window = bench.open();
    const std::vector<Layer> before = window.mapScene()->layerOrder();
    LayerRow* bar = part<LayersDock>(window)->row(Layer::ScaleBar);
    bar->setFocus();
    QTest::keyClick(bar, Qt::Key_Down, Qt::ControlModifier);
    LayerRow* robot = part<LayersDock>(window)->row(Layer::Robot);
    QTest::keyClick(robot, Qt::Key_Up, Qt::ControlModifier);
    QCOMPARE(window.mapScene()->layerOrder(), before);
  }

  void foldsOutWhatALayerHasToOffer() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!part<LayersDock>(window)->row(Layer::Grid)->settings());
    LayerRow* cloud = part<LayersDock>(window)->row(Layer::Cloud);
    QTest::mouseClick(cloud->settings(), Qt::LeftButton);
    LayerStyleEditor* editor = cloud->editor();
    QVERIFY(editor && editor->isVisible());
    QVERIFY(editor->colorButton() && editor->sizeBox() && editor->choiceBox());
    editor->sizeBox()->setValue(5);
    QCOMPARE(window.mapScene()->layerStyle(Layer::Cloud).size, 5.0);
    editor->setColor(QColor(10, 200, 30));
    QCOMPARE(window.mapScene()->layerStyle(Layer::Cloud).color, QColor(10, 200, 30));
    editor->choiceBox()->setCurrentIndex(2);
    Q_EMIT editor->choiceBox()->activated(2);
    QCOMPARE(window.mapScene()->layerStyle(Layer::Cloud).choice, int(ui::scene::CloudChoice::Height));
    QTest::mouseClick(cloud->settings(), Qt::LeftButton);
    QVERIFY(!editor->isVisible());
  }

  void remembersOrderOpacityVisibilityAndStyles() {
    Bench bench;
    std::vector<Layer> order;
    const ui::scene::LayerStyle style{QColor(10, 200, 30), 4.5, 1};
    {
      MainWindow& window = bench.open();
      LayerRow* path = part<LayersDock>(window)->row(Layer::Path);
      QTest::keyClick(path, Qt::Key_Up, Qt::ControlModifier);
      order = window.mapScene()->layerOrder();
      part<LayersDock>(window)->opacity(Layer::Path)->setValue(40);
      part<LayersDock>(window)->eye(Layer::CostmapLow)->click();
      window.mapScene()->setLayerStyle(Layer::Cloud, style);
      QTest::mouseClick(part<LayersDock>(window)->findChild<QToolButton*>(QStringLiteral("layersInOrder")),
                        Qt::LeftButton);
      QVERIFY(!part<LayersDock>(window)->header(ui::scene::LayerGroup::Map)->isVisible());
      window.close();
    }
    MainWindow& again = bench.open();
    QCOMPARE(again.mapScene()->layerOrder(), order);
    QCOMPARE(again.mapScene()->layerOpacity(Layer::Path), 0.4);
    QVERIFY(again.mapScene()->layerVisible(Layer::CostmapLow));
    QCOMPARE(again.mapScene()->layerStyle(Layer::Cloud), style);
    QVERIFY(!part<LayersDock>(again)->grouped());
    bench.action("resetLayout")->trigger();
    QVERIFY(part<LayersDock>(again)->grouped());
    QCOMPARE(again.mapScene()->layerOrder(), ui::scene::allLayers());
    QCOMPARE(again.mapScene()->layerStyle(Layer::Cloud), ui::scene::LayerStyle{});
  }

  void takesNothingFromBrokenSettings() {
    Bench bench;
    bench.settings.setValue(QStringLiteral("layers/order"), QStringList{QStringLiteral("nonsense")});
    bench.settings.setValue(QStringLiteral("layers/cloud/size"), QStringLiteral("nan"));
    bench.settings.setValue(QStringLiteral("layers/cloud/choice"), 77);
    bench.settings.setValue(QStringLiteral("layers/cloud/color"), QStringLiteral("no colour"));
    bench.settings.setValue(QStringLiteral("layers/path/opacity"), -3);
    MainWindow& window = bench.open();
    QCOMPARE(window.mapScene()->layerOrder(), ui::scene::allLayers());
    QCOMPARE(window.mapScene()->layerStyle(Layer::Cloud), ui::scene::LayerStyle{});
    QCOMPARE(window.mapScene()->layerOpacity(Layer::Path), 0.0);
  }

  void aTopicIsChosenForALayerAndRememberedForItsRobot() {
    QTemporaryDir folder;
    QSettings settings(folder.filePath(QStringLiteral("s.ini")), QSettings::IniFormat);
    TopicsRobot* robot = nullptr;
    MainWindow::Dependencies wanted{
        [&](const QString& address,
            const QByteArray&) -> tl::expected<std::unique_ptr<robot::Robot>, QString> {
          auto made = std::make_unique<TopicsRobot>(address);
          robot = made.get();
          return std::unique_ptr<robot::Robot>(std::move(made));
        },
        settings};
    wanted.addresses = test::knownAddresses();
    MainWindow window(std::move(wanted));
    window.resize(1366, 768);
    window.show();
    LayerRow* const path = part<LayersDock>(window)->row(Layer::Path);
    LayerRow* const costmap = part<LayersDock>(window)->row(Layer::CostmapLow);
    QVERIFY(!part<LayersDock>(window)->row(Layer::Grid)->settings());
    QVERIFY(costmap->settings()->isHidden());  // without a robot there is nothing to choose
    QVERIFY(!window.connectTo(kAddress));
    QVERIFY(!costmap->settings()->isHidden());
    costmap->settings()->click();
    QComboBox* const topic = costmap->editor()->topicBox();
    QVERIFY(topic && topic->isVisibleTo(costmap));
    QCOMPARE(topic->count(), 3);
    QCOMPARE(topic->currentIndex(), 0);
    topic->setCurrentIndex(2);
    Q_EMIT topic->activated(2);
    QCOMPARE(robot->picked, (robot::TopicChoices{{map::Stream::CostmapLow, QStringLiteral("/b")}}));
    QCOMPARE(topic->currentText(), QStringLiteral("/b"));
    path->settings()->click();
    Q_EMIT path->editor()->topicBox()->activated(1);
    const robot::TopicChoices both{{map::Stream::CostmapLow, QStringLiteral("/b")},
                                   {map::Stream::Path, QStringLiteral("/a")}};
    QCOMPARE(robot->picked, both);
    // Another robot has its own.
    QVERIFY(!window.connectTo(QStringLiteral("axbot+http://192.0.2.8:8090")));
    QVERIFY(robot->picked.empty());
    QCOMPARE(topic->currentIndex(), 0);
    QVERIFY(!window.connectTo(kAddress));
    QCOMPARE(robot->picked, both);
    QCOMPARE(topic->currentText(), QStringLiteral("/b"));
    Q_EMIT topic->activated(0);
    QCOMPARE(robot->picked.size(), std::size_t(1));
    window.leaveRobot();
    QVERIFY(costmap->settings()->isHidden());
    QVERIFY(!path->settings()->isHidden());  // it has a colour
  }

  void foldsAwayWhatARobotCannotFillAndSaysWhy() {
    Bench bench;
    bench.prepare = [](test::FakeRobot& robot) {
      robot.has_submaps = false;
      robot.has_catalogue = true;
    };
    MainWindow& window = bench.open();
    LayersDock& dock = *part<LayersDock>(window);
    QVERIFY(dock.row(Layer::Submaps)->unavailable().isEmpty());
    QVERIFY(!dock.unavailableHeader()->isVisible());
    QVERIFY(!window.connectTo(kAddress));
    int lacking = 0;
    for (const Layer layer : ui::scene::allLayers()) lacking += !dock.row(layer)->unavailable().isEmpty();
    QVERIFY(dock.unavailableHeader()->isVisible());
    QCOMPARE(dock.unavailableHeader()->text(),
             QStringLiteral("%1 layers that this robot has no data for").arg(lacking));
    for (const Layer layer : {Layer::Submaps, Layer::Ids, Layer::Cloud, Layer::Robot}) {
      QVERIFY2(!dock.row(layer)->unavailable().isEmpty(), qPrintable(ui::scene::layerName(layer)));
      QVERIFY(!dock.row(layer)->isVisible());
      QVERIFY(!dock.eye(layer)->isEnabled());
    }
    QVERIFY(dock.row(Layer::WholeMap)->isVisible());
    QVERIFY(dock.row(Layer::Grid)->isVisible());
    // Unfolded, each has its reason.
    QTest::mouseClick(dock.unavailableHeader(), Qt::LeftButton);
    for (const Layer layer : {Layer::Submaps, Layer::Cloud}) {
      const LayerRow* const row = dock.row(layer);
      QVERIFY(row->isVisible() && !row->toolTip().isEmpty());
      QVERIFY(dock.reasonsShown().contains(row->unavailable()));
      QVERIFY(!dock.eye(layer)->isVisible());
    }
    // What it can have later comes back at its place, as the user has set it.
    const bool shown = window.mapScene()->layerVisible(Layer::Cloud);
    bench.robot->has_live = true;
    Q_EMIT bench.robot->capabilitiesChanged();
    const LayerRow* const cloud = dock.row(Layer::Cloud);
    QVERIFY(cloud->isVisible() && cloud->unavailable().isEmpty());
    QVERIFY(cloud->y() > dock.header(ui::scene::LayerGroup::Environment)->y());
    QVERIFY(cloud->y() < dock.header(ui::scene::LayerGroup::Map)->y());
    QCOMPARE(dock.eye(Layer::Cloud)->isChecked(), shown);
    QVERIFY(!dock.row(Layer::Submaps)->unavailable().isEmpty());
    window.leaveRobot();
    QVERIFY(dock.eye(Layer::Cloud)->isEnabled());
    QVERIFY(!dock.unavailableHeader()->isVisible());
  }
};

}  // namespace test_window_layers

MAPWRIGHT_TEST(test_window_layers, TestWindowLayers, Widgets)
#include "test_window_layers.moc"
