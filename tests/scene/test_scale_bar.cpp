#include <QTest>

#include "test_program.h"
#include "ui/scene/lengths.h"

namespace test_scale_bar {

using namespace mapwright::ui::scene;

class ScaleBarTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void lengthsAreRoundNumbers() {
    QCOMPARE(roundDown125(7.3), 5.0);
    QCOMPARE(roundDown125(4.9), 2.0);
    QCOMPARE(roundDown125(1.0), 1.0);
    QVERIFY(std::abs(roundDown125(0.0237) - 0.02) < 1e-12);
    QCOMPARE(roundDown125(25'000), 20'000.0);
  }
  void lengthsCarryTheirUnit_data() {
    QTest::addColumn<double>("metres");
    QTest::addColumn<QString>("text");
    const auto row = [](double metres, const char* text) {
      QTest::newRow(text) << metres << QString::fromLatin1(text);
    };
    row(0.0005, "0.5 mm");
    row(0.02, "20 mm");
    row(0.2, "20 cm");
    row(0.255, "25.5 cm");
    row(5, "5 m");
    row(12.345, "12.35 m");
    row(250, "250 m");
    row(2000, "2 km");
    row(12'345, "12.3 km");
  }
  void lengthsCarryTheirUnit() {
    QFETCH(double, metres);
    QFETCH(QString, text);
    QCOMPARE(lengthText(metres), text);
  }
};

}  // namespace test_scale_bar

MAPWRIGHT_TEST(test_scale_bar, ScaleBarTest, Core)
#include "test_scale_bar.moc"
