// The list of layers: order, styles, what a robot cannot fill.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QScrollArea>
#include <QSlider>
#include <QToolButton>
#include <QtTest>

#include "robot/offers_topics.h"
#include "test_program.h"
#include "ui/layers/layer_row.h"
#include "ui/layers/layers_dock.h"
#include "window_bench.h"
#include "window_parts.h"

namespace test_window_layers {

using namespace mapwright;
using namespace mapwright::window;
using scene::Layer;
using test::Bench;
using test::kAddress;

namespace {

std::ptrdiff_t placeOf(const scene::MapScene& scene, Layer layer) {
  const std::vector<Layer>& order = scene.layerOrder();
  return std::find(order.begin(), order.end(), layer) - order.begin();
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
    for (const Layer layer : scene::allLayers()) QVERIFY(part<LayersDock>(window)->row(layer));
    QVERIFY(part<LayersDock>(window)->row(Layer::Robot)->y() <
            part<LayersDock>(window)->row(Layer::Submaps)->y());
    QVERIFY(part<LayersDock>(window)->row(Layer::Submaps)->y() <
            part<LayersDock>(window)->row(Layer::WholeMap)->y());
  }

  void movesARowByDraggingIt() {
    Bench bench;
    MainWindow& window = bench.open();
    LayerRow* grid = part<LayersDock>(window)->row(Layer::Grid);
    LayerRow* submaps = part<LayersDock>(window)->row(Layer::Submaps);
    QVERIFY(placeOf(*window.mapScene(), Layer::Grid) > placeOf(*window.mapScene(), Layer::Submaps));
    const QPoint from(60, 12);
    QTest::mousePress(grid, Qt::LeftButton, {}, from);
    // Step by step: the row itself moves below the cursor.
    for (int step = 0; step < 20; ++step) {
      const QPoint target = submaps->mapTo(part<LayersDock>(window), QPoint(60, 20));
      QMouseEvent move(QEvent::MouseMove, grid->mapFrom(part<LayersDock>(window), target), QPoint(),
                       Qt::NoButton, Qt::LeftButton, {});
      QApplication::sendEvent(grid, &move);
      QCoreApplication::processEvents();
    }
    QTest::mouseRelease(grid, Qt::LeftButton, {}, from);
    QVERIFY(placeOf(*window.mapScene(), Layer::Grid) < placeOf(*window.mapScene(), Layer::Submaps));
    QTRY_VERIFY(grid->y() > submaps->y());
  }

  void movesARowByKeys() {
    Bench bench;
    MainWindow& window = bench.open();
    const std::vector<Layer> before = window.mapScene()->layerOrder();
    LayerRow* grid = part<LayersDock>(window)->row(Layer::Grid);
    grid->setFocus();
    QTest::keyClick(grid, Qt::Key_Up, Qt::ControlModifier);
    QCOMPARE(placeOf(*window.mapScene(), Layer::Grid),
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
    QCOMPARE(window.mapScene()->layerStyle(Layer::Cloud).choice, int(scene::CloudChoice::Height));
    QTest::mouseClick(cloud->settings(), Qt::LeftButton);
    QVERIFY(!editor->isVisible());
  }

  void remembersOrderOpacityVisibilityAndStyles() {
    Bench bench;
    std::vector<Layer> order;
    const scene::LayerStyle style{QColor(10, 200, 30), 4.5, 1};
    {
      MainWindow& window = bench.open();
      LayerRow* path = part<LayersDock>(window)->row(Layer::Path);
      QTest::keyClick(path, Qt::Key_Up, Qt::ControlModifier);
      order = window.mapScene()->layerOrder();
      part<LayersDock>(window)->opacity(Layer::Path)->setValue(40);
      part<LayersDock>(window)->eye(Layer::CostmapLow)->click();
      window.mapScene()->setLayerStyle(Layer::Cloud, style);
      window.close();
    }
    MainWindow& again = bench.open();
    QCOMPARE(again.mapScene()->layerOrder(), order);
    QCOMPARE(again.mapScene()->layerOpacity(Layer::Path), 0.4);
    QVERIFY(again.mapScene()->layerVisible(Layer::CostmapLow));
    QCOMPARE(again.mapScene()->layerStyle(Layer::Cloud), style);
    bench.action("resetLayout")->trigger();
    QCOMPARE(again.mapScene()->layerOrder(), scene::allLayers());
    QCOMPARE(again.mapScene()->layerStyle(Layer::Cloud), scene::LayerStyle{});
  }

  void takesNothingFromBrokenSettings() {
    Bench bench;
    bench.settings.setValue(QStringLiteral("layers/order"), QStringList{QStringLiteral("nonsense")});
    bench.settings.setValue(QStringLiteral("layers/cloud/size"), QStringLiteral("nan"));
    bench.settings.setValue(QStringLiteral("layers/cloud/choice"), 77);
    bench.settings.setValue(QStringLiteral("layers/cloud/color"), QStringLiteral("no colour"));
    bench.settings.setValue(QStringLiteral("layers/path/opacity"), -3);
    MainWindow& window = bench.open();
    QCOMPARE(window.mapScene()->layerOrder(), scene::allLayers());
    QCOMPARE(window.mapScene()->layerStyle(Layer::Cloud), scene::LayerStyle{});
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

  void greysWhatARobotCannotFillAndSaysWhy() {
    Bench bench;
    bench.prepare = [](test::FakeRobot& robot) {
      robot.has_submaps = false;
      robot.has_catalogue = true;
    };
    MainWindow& window = bench.open();
    QVERIFY(part<LayersDock>(window)->row(Layer::Submaps)->unavailable().isEmpty());
    QVERIFY(!window.connectTo(kAddress));
    for (const Layer layer : {Layer::Submaps, Layer::Ids, Layer::Cloud, Layer::Robot}) {
      QVERIFY2(!part<LayersDock>(window)->row(layer)->unavailable().isEmpty(),
               qPrintable(scene::layerName(layer)));
      QVERIFY(!part<LayersDock>(window)->eye(layer)->isEnabled());
      QVERIFY(!part<LayersDock>(window)->row(layer)->toolTip().isEmpty());
    }
    QVERIFY(part<LayersDock>(window)->row(Layer::WholeMap)->unavailable().isEmpty());
    QVERIFY(part<LayersDock>(window)->row(Layer::Grid)->unavailable().isEmpty());
    window.leaveRobot();
    QVERIFY(part<LayersDock>(window)->eye(Layer::Cloud)->isEnabled());
  }
};

}  // namespace test_window_layers

MAPWRIGHT_TEST(test_window_layers, TestWindowLayers, Widgets)
#include "test_window_layers.moc"
