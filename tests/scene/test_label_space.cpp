#include <array>
#include <limits>

#include <QtTest>

#include "scene/layer_item.h"
#include "test_program.h"

namespace test_label_space {

using mapwright::scene::LabelSpace;

class LabelSpaceTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aNameTakesTheFirstSpotThatNoOtherCovers() {
    LabelSpace space;
    const std::array spots{QRectF(0, 0, 50, 12), QRectF(100, 0, 50, 12)};
    QCOMPARE(space.take(spots), std::optional(spots[0]));
    QCOMPARE(space.take(spots), std::optional(spots[1]));
    QCOMPARE(space.take(spots), std::optional<QRectF>());
  }

  void namesAreComparedAcrossTheWholePicture() {
    LabelSpace space;
    const std::array tall{QRectF(0, -200, 10, 400)};
    QVERIFY(space.take(tall));
    for (const double y : {-190.0, -40.0, 0.0, 31.0, 195.0}) {
      const std::array spot{QRectF(5, y, 20, 4)};
      QVERIFY2(!space.take(spot), qPrintable(QString::number(y)));
    }
    const std::array beside{QRectF(11, 0, 20, 4)};
    QVERIFY(space.take(beside));
  }

  void aNewFrameStartsEmpty() {
    LabelSpace space;
    const std::array spot{QRectF(0, 0, 50, 12)};
    QVERIFY(space.take(spot));
    QVERIFY(!space.take(spot));
    space.clear();
    QVERIFY(space.take(spot));
  }

  void farAwaySpotsAreHarmless() {
    LabelSpace space;
    const std::array spot{QRectF(1e300, -1e300, 50, 12)};
    QVERIFY(space.take(spot));
    const double none = std::numeric_limits<double>::quiet_NaN();
    const std::array nowhere{QRectF(none, none, 50, 12)};
    space.take(nowhere);
    const std::array near{QRectF(0, 0, 50, 12)};
    QVERIFY(space.take(near));
  }
};

}  // namespace test_label_space

MAPWRIGHT_TEST(test_label_space, LabelSpaceTest, Core)
#include "test_label_space.moc"
