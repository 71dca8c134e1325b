// Where grids lie, and what cannot be placed.
#include <cmath>
#include <limits>

#include <QTest>

#include "map/catalogue.h"
#include "map/grid_reference.h"
#include "map/overlay.h"
#include "test_program.h"

namespace test_grid_reference {

using namespace mapwright;
using map::GridReference;

class GridReferenceTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theOriginIsTheOuterCornerOfTheLowerLeftCell() {
    const GridReference grid{20, 10, 0.5, {-3, 4, 0}};
    QVERIFY((grid.worldFromCell({0, 10}) - Eigen::Vector2d(-3, 4)).norm() < 1e-12);
    QVERIFY((grid.worldFromCell({0, 0}) - Eigen::Vector2d(-3, 9)).norm() < 1e-12);
    QVERIFY((grid.worldFromCell({20, 0}) - Eigen::Vector2d(7, 9)).norm() < 1e-12);
    QVERIFY((grid.cellFromWorld({-2.75, 8.75}) - Eigen::Vector2d(0.5, 0.5)).norm() < 1e-12);
  }

  void aTurnedOriginTurnsTheGridAboutIt() {
    const GridReference grid{4, 2, 1, {10, 20, M_PI / 2}};
    // x runs along world y now, and the top row lies to the left.
    QVERIFY((grid.worldFromCell({4, 2}) - Eigen::Vector2d(10, 24)).norm() < 1e-12);
    QVERIFY((grid.worldFromCell({0, 0}) - Eigen::Vector2d(8, 20)).norm() < 1e-12);
    QVERIFY((grid.cellFromWorld(grid.worldFromCell({1.25, 0.75})) - Eigen::Vector2d(1.25, 0.75)).norm() <
            1e-12);
    const geometry::WorldRect bounds = grid.bounds();
    QVERIFY(std::abs(bounds.min_x - 8) < 1e-12 && std::abs(bounds.max_y - 24) < 1e-12);
  }

  void whatCannotBePlacedIsRefusedWithAReason_data() {
    QTest::addColumn<double>("resolution");
    QTest::addColumn<double>("x");
    QTest::addColumn<bool>("usable");
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    QTest::newRow("plain") << 0.05 << -8.1 << true;
    QTest::newRow("zero") << 0.0 << 0.0 << false;
    QTest::newRow("negative") << -0.05 << 0.0 << false;
    QTest::newRow("NaN") << nan << 0.0 << false;
    QTest::newRow("infinite") << inf << 0.0 << false;
    QTest::newRow("tiny") << 1e-9 << 0.0 << false;
    QTest::newRow("huge") << 1e6 << 0.0 << false;
    QTest::newRow("no origin") << 0.05 << nan << false;
    QTest::newRow("far away") << 0.05 << 1e9 << false;
  }
  void whatCannotBePlacedIsRefusedWithAReason() {
    QFETCH(double, resolution);
    QFETCH(double, x);
    QFETCH(bool, usable);
    const auto why = map::unusableReason({10, 10, resolution, {x, 0, 0}});
    QCOMPARE(!why.has_value(), usable);
    if (why) QVERIFY(why->any());
  }

  void keysAreReadAsTheyAreWritten() {
    for (const char* text : {"12", "1764059676131", "mapping:48", "live", "file"}) {
      QCOMPARE(map::toText(map::mapKeyFromText(text)), std::string(text));
    }
    QVERIFY(map::mapKeyFromText("mapping:48").kind == map::MapKind::Mapping);
    QCOMPARE(map::mapKeyFromText("9007199254740993").id, std::string("9007199254740993"));
  }
};

}  // namespace test_grid_reference

MAPWRIGHT_TEST(test_grid_reference, GridReferenceTest, Core)
#include "test_grid_reference.moc"
