// Painting leaves time to those who decode what is to be painted.
#include <QTest>

#include "test_program.h"
#include "ui/scene/repaint_pace.h"

namespace test_repaint_pace {

using mapwright::ui::scene::RepaintPace;

class RepaintPaceTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theFirstContentIsPaintedAtOnce() { QCOMPARE(RepaintPace().waitMs(0), 0.0); }

  void paintingRestsFourTimesAsLongAsItTook() {
    RepaintPace pace;
    pace.painted(1000, 1010);
    QCOMPARE(pace.waitMs(1010), 40.0);
    QCOMPARE(pace.waitMs(1040), 10.0);
    QCOMPARE(pace.waitMs(1050), 0.0);
    QCOMPARE(pace.waitMs(9000), 0.0);
  }

  void butNotSoLongThatItLooksStuck() {
    RepaintPace pace;
    pace.painted(0, 500);
    QCOMPARE(pace.waitMs(500), RepaintPace::kLongestMs);
  }

  void aSmallMapIsPaintedAsOftenAsThereIsNews() {
    RepaintPace pace;
    pace.painted(0, 0.5);
    QVERIFY(pace.waitMs(2.6) == 0);
  }
};

}  // namespace test_repaint_pace

MAPWRIGHT_TEST(test_repaint_pace, RepaintPaceTest, Nothing)
#include "test_repaint_pace.moc"
