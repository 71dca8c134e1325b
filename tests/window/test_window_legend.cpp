// The legend: what it says of the map on screen.
#include <set>

#include <QLabel>
#include <QScrollArea>
#include <QtTest>

#include "render/grid_palettes.h"
#include "render/sample_grid.h"
#include "test_program.h"
#include "ui/layers/layers_dock.h"
#include "ui/layers/legend_dock.h"
#include "ui/maps/maps_controller.h"
#include "ui/maps/maps_dock.h"
#include "ui/maps/maps_model.h"
#include "ui/scene/map_theme.h"
#include "ui/view/compare_bar.h"
#include "window_bench.h"
#include "window_parts.h"

namespace test_window_legend {

using namespace mapwright;
using namespace mapwright::ui;
using test::Bench;
using test::kAddress;
using ui::scene::Layer;

namespace {

/// What is written in it, top to bottom.
QStringList textsOf(const LegendDock& dock) {
  QStringList texts;
  for (const QLabel* const label : dock.widget()->findChildren<QLabel*>()) texts << label->text();
  return texts;
}

QImage symbolOf(const LegendDock& dock, const QString& text) {
  for (const ui::scene::LegendSection& section : dock.shown()) {
    for (const ui::scene::LegendRow& row : section.rows) {
      if (row.text == text) return row.symbol;
    }
  }
  return {};
}

QStringList titlesOf(const LegendDock& dock) {
  QStringList titles;
  for (const ui::scene::LegendSection& section : dock.shown()) titles << section.title;
  return titles;
}

bool holds(const QImage& image, const QColor& color) {
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (image.pixelColor(x, y).rgb() == color.rgb()) return true;
    }
  }
  return false;
}

/// Opened from the View menu.
LegendDock& opened(MainWindow& window) {
  LegendDock& dock = *part<LegendDock>(window);
  dock.toggleViewAction()->trigger();
  QCoreApplication::processEvents();
  return dock;
}

void showOnly(MainWindow& window, const std::set<Layer>& layers) {
  window.mapScene()->setLayersVisible(layers);
  QCoreApplication::processEvents();
}

}  // namespace

class TestWindowLegend : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void isClosedAtFirst() {
    Bench bench;
    MainWindow& window = bench.open();
    QVERIFY(!part<LegendDock>(window)->isVisible());
    QVERIFY(part<LegendDock>(window)->shown().empty());  // nobody sees it: it costs nothing
    LegendDock& dock = opened(window);
    QTRY_VERIFY(dock.isVisible() && !dock.shown().empty());
    QTRY_VERIFY(textsOf(dock).contains(QStringLiteral("Where the robot was")));
  }

  void followsWhatIsShown() {
    Bench bench;
    MainWindow& window = bench.open();
    LegendDock& dock = opened(window);
    showOnly(window, {Layer::Path, Layer::Doors});
    QTRY_COMPARE(titlesOf(dock), (QStringList{QStringLiteral("Path"), QStringLiteral("Auto doors")}));
    part<LayersDock>(window)->eye(Layer::Path)->click();
    QTRY_COMPARE(titlesOf(dock), QStringList{QStringLiteral("Auto doors")});
    part<LayersDock>(window)->eye(Layer::Doors)->click();
    QTRY_VERIFY(dock.shown().empty());
    QTRY_VERIFY(textsOf(dock).join(QLatin1Char(' ')).contains(QLatin1String("No visible layer")));
  }

  void symbolsAreInTheColoursOfTheLayer_data() {
    QTest::addColumn<Layer>("layer");
    QTest::addColumn<QString>("text");
    QTest::newRow("path") << Layer::Path << QStringLiteral("Planned path to the target");
    QTest::newRow("trail") << Layer::Trail << QStringLiteral("Where the robot was");
    QTest::newRow("target") << Layer::Target << QStringLiteral("Target, with its heading");
    QTest::newRow("lidar") << Layer::Cloud << QStringLiteral("Lidar point");
    QTest::newRow("landmark") << Layer::Landmarks << QStringLiteral("Landmark");
    QTest::newRow("footprint") << Layer::Footprint << QStringLiteral("Outline of the robot");
    QTest::newRow("map's cloud") << Layer::DispatchedCloud << QStringLiteral("Point of the map");
  }
  void symbolsAreInTheColoursOfTheLayer() {
    QFETCH(Layer, layer);
    QFETCH(QString, text);
    Bench bench;
    MainWindow& window = bench.open();
    LegendDock& dock = opened(window);
    showOnly(window, {layer});
    const QColor wanted(10, 200, 30);
    ui::scene::LayerStyle style;
    if (layer == Layer::DispatchedCloud) style.choice = int(ui::scene::DispatchedCloudChoice::OneColor);
    window.mapScene()->setLayerStyle(layer, style);
    QTRY_VERIFY(!symbolOf(dock, text).isNull());
    QVERIFY(!holds(symbolOf(dock, text), wanted));
    style.color = wanted;
    window.mapScene()->setLayerStyle(layer, style);
    QTRY_VERIFY(holds(symbolOf(dock, text), wanted));
  }

  void sizesAndOpacityShow() {
    Bench bench;
    MainWindow& window = bench.open();
    LegendDock& dock = opened(window);
    showOnly(window, {Layer::Path});
    const QString text = QStringLiteral("Planned path to the target");
    QTRY_VERIFY(!symbolOf(dock, text).isNull());
    const QImage before = symbolOf(dock, text);
    window.mapScene()->setLayerStyle(Layer::Path, {{}, 9, 0});
    QTRY_VERIFY(symbolOf(dock, text) != before);
    const QImage wide = symbolOf(dock, text);
    window.mapScene()->setLayerOpacity(Layer::Path, 0.3);
    QTRY_VERIFY(symbolOf(dock, text) != wide);
  }

  void statesDifferInTheirSymbols_data() {
    QTest::addColumn<Layer>("layer");
    QTest::addColumn<int>("states");
    QTest::newRow("doors") << Layer::Doors << 3;
    QTest::newRow("waypoints") << Layer::Waypoints << 9;
    QTest::newRow("landmarks") << Layer::Landmarks << 2;
    QTest::newRow("constraints") << Layer::Constraints << 2;
    QTest::newRow("outlines") << Layer::Outlines << 2;
    QTest::newRow("ids") << Layer::Ids << 2;
    QTest::newRow("cells") << Layer::Submaps << 3;
    QTest::newRow("regions of a map") << Layer::Regions << 9;
    QTest::newRow("match") << Layer::EnvMatch << 1;
  }
  void statesDifferInTheirSymbols() {
    QFETCH(Layer, layer);
    QFETCH(int, states);
    Bench bench;
    MainWindow& window = bench.open();
    LegendDock& dock = opened(window);
    showOnly(window, {layer});
    QTRY_COMPARE(dock.shown().size(), std::size_t(1));
    const std::vector<ui::scene::LegendRow>& rows = dock.shown().front().rows;
    QCOMPARE(int(rows.size()), states);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t k = i + 1; k < rows.size(); ++k)
        QVERIFY2(rows[i].symbol != rows[k].symbol, qPrintable(rows[i].text + rows[k].text));
    }
  }

  void kindsOfOverlaysThatLookTheSameAreOneRow() {
    Bench bench;
    MainWindow& window = bench.open();
    LegendDock& dock = opened(window);
    showOnly(window, {Layer::Overlays});
    QTRY_COMPARE(dock.shown().size(), std::size_t(1));
    const ui::scene::MapTheme& theme = window.mapScene()->theme();
    // Hatched, and apart from the others in the same red.
    QVERIFY(!symbolOf(dock, QStringLiteral("Forbidden region")).isNull());
    QVERIFY(holds(symbolOf(dock, QStringLiteral("Virtual wall")), theme.bad));
    QVERIFY(holds(symbolOf(dock, QStringLiteral("Charger, Docking point")), theme.good));
    QVERIFY(holds(symbolOf(dock, QStringLiteral("Other points")), theme.place));
    std::vector<QImage> symbols;
    for (const ui::scene::LegendRow& row : dock.shown().front().rows) {
      QVERIFY2(std::find(symbols.begin(), symbols.end(), row.symbol) == symbols.end(), qPrintable(row.text));
      symbols.push_back(row.symbol);
    }
  }

  void colorsByAValueAreAScale() {
    Bench bench;
    MainWindow& window = bench.open();
    LegendDock& dock = opened(window);
    showOnly(window, {Layer::Cloud});
    window.mapScene()->setLayerStyle(Layer::Cloud, {{}, 0, int(ui::scene::CloudChoice::Height)});
    QTRY_VERIFY(!dock.shown().empty() && !dock.shown().front().rows.front().high.isEmpty());
    const ui::scene::LegendRow& row = dock.shown().front().rows.front();
    QCOMPARE(row.low, QStringLiteral("0 m"));
    QCOMPARE(row.high, QStringLiteral("2.5 m"));
    const int middle = row.symbol.height() / 2, width = row.symbol.width();
    // From blue to red, as the layer paints them.
    QVERIFY(row.symbol.pixelColor(8, middle).blue() > 150 && row.symbol.pixelColor(8, middle).red() < 100);
    QVERIFY(row.symbol.pixelColor(width - 8, middle).red() > 150);
    QTRY_VERIFY(textsOf(dock).contains(QStringLiteral("2.5 m")));
  }

  void followsTheTheme() {
    Bench bench;
    MainWindow& window = bench.open();
    bench.action("themeLight")->trigger();
    LegendDock& dock = opened(window);
    showOnly(window, {Layer::Path});
    const QString text = QStringLiteral("Planned path to the target");
    QTRY_VERIFY(holds(symbolOf(dock, text), ui::scene::lightMapTheme().path));
    bench.action("themeDark")->trigger();
    QTRY_VERIFY(holds(symbolOf(dock, text), ui::scene::darkMapTheme().path));
    bench.action("themeLight")->trigger();
    QTRY_VERIFY(holds(symbolOf(dock, text), ui::scene::lightMapTheme().path));
  }

  void followsTheColoursOfSubmaps() {
    Bench bench;
    MainWindow& window = bench.open();
    LegendDock& dock = opened(window);
    showOnly(window, {Layer::Submaps});
    QTRY_COMPARE(dock.shown().size(), std::size_t(1));
    QVERIFY(symbolOf(dock, QStringLiteral("Free, of incremental submaps")).isNull());
    bench.action("colorsIncremental")->trigger();
    QTRY_VERIFY(holds(symbolOf(dock, QStringLiteral("Free, of incremental submaps")),
                      QColor(window.mapScene()->theme().map.incremental_free)));
  }

  void leavesOutWhatARobotCannotHave() {
    Bench bench;
    bench.prepare = [](test::FakeRobot& robot) {
      robot.has_submaps = false;
      robot.has_catalogue = true;
    };
    MainWindow& window = bench.open();
    LegendDock& dock = opened(window);
    showOnly(window, {Layer::Path, Layer::WholeMap});
    QTRY_COMPARE(dock.shown().size(), std::size_t(2));
    QVERIFY(!window.connectTo(kAddress));
    showOnly(window, {Layer::Path, Layer::WholeMap});
    QTRY_COMPARE(titlesOf(dock), QStringList{QStringLiteral("Whole map")});
  }

  void saysWhatDifferenceShows() {
    Bench bench;
    bench.offerMaps();
    MainWindow& window = bench.open();
    QVERIFY(!window.connectTo(kAddress));
    QTRY_COMPARE(part<MapsDock>(window)->model()->maps(), 3);
    const auto stored = [](const char* id) { return map::MapKey{map::MapKind::Stored, id}; };
    part<MapsController>(window)->open(stored("1"));
    QTRY_VERIFY(window.session()->wholeMap().phase() == session::MapSlot::Phase::Ready);
    LegendDock& dock = opened(window);
    showOnly(window, {Layer::WholeMap, Layer::Grid});
    QTRY_VERIFY(titlesOf(dock).contains(QStringLiteral("Whole map")));
    Q_EMIT part<MapsDock>(window)->compareWanted(stored("2"));
    QTRY_COMPARE(window.session()->comparedMap().phase(), session::MapSlot::Phase::Ready);
    QTest::mouseClick(part<CompareBar>(window)->differenceButton(), Qt::LeftButton);
    QTRY_COMPARE(titlesOf(dock), (QStringList{QStringLiteral("Difference"), QStringLiteral("Grid")}));
    const auto palette = render::differencePalette(window.mapScene()->theme().dark);
    QVERIFY(holds(symbolOf(dock, QStringLiteral("New in the second map")),
                  QColor(QRgb(palette[std::size_t(render::Difference::Appeared)]))));
    QVERIFY(!symbolOf(dock, QStringLiteral("Known in the first map only")).isNull());
    QTest::mouseClick(part<CompareBar>(window)->closeButton(), Qt::LeftButton);
    QTRY_VERIFY(titlesOf(dock).contains(QStringLiteral("Whole map")));
  }
};

}  // namespace test_window_legend

MAPWRIGHT_TEST(test_window_legend, TestWindowLegend, Widgets)
#include "test_window_legend.moc"
