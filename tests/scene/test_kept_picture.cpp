// What is kept of what takes long to draw, and when it is drawn again.
#include <vector>

#include <QImage>
#include <QPainter>
#include <QTest>

#include "test_program.h"
#include "ui/scene/kept_picture.h"

namespace test_kept_picture {

using namespace mapwright;

class TestKeptPicture : public QObject {
  Q_OBJECT
 private:
  static constexpr QRectF kPart{10, 10, 5, 5}, kAll{0, 0, 40, 30};
  ui::scene::KeptPicture kept_;
  geometry::ViewTransform view_;
  std::vector<QRectF> drawn_;  // what was asked for

  QImage paint(const QRectF& exposed, std::uint64_t revision, double opacity = 1, qreal ratio = 1) {
    QImage image((QSizeF(40, 30) * ratio).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(ratio);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setOpacity(opacity);
    kept_.paint(painter, exposed, view_, revision, [&](QPainter& on, const QRectF& part) {
      drawn_.push_back(part);
      on.fillRect(QRectF(2, 2, 20, 20), revision % 2 == 0 ? Qt::red : Qt::blue);
    });
    return image;
  }

 private Q_SLOTS:
  void init() {
    kept_.forget();
    drawn_.clear();
    view_ = {};
    view_.width_px = 40;
    view_.height_px = 30;
  }

  void fromTheThirdTimeOnNothingIsDrawn() {
    const QImage once = paint(kPart, 0);
    QCOMPARE(drawn_, std::vector<QRectF>{kPart});
    QCOMPARE(paint(kPart, 0), once);
    QCOMPARE(drawn_, (std::vector<QRectF>{kPart, kAll}));
    QCOMPARE(paint(kAll, 0), once);
    QCOMPARE(drawn_.size(), std::size_t(2));
  }

  void itIsDrawnAgainWhereTheCameraMovesOrItLooksDifferent() {
    for (int i = 0; i < 3; ++i) paint(kAll, 0);
    drawn_.clear();
    const QImage blue = paint(kAll, 1);
    QCOMPARE(blue.pixelColor(5, 5), QColor(Qt::blue));
    for (int i = 0; i < 3; ++i) QCOMPARE(paint(kAll, 1), blue);
    QCOMPARE(drawn_, std::vector<QRectF>{kAll});
    view_.center_m.x() = 1;
    paint(kPart, 1);
    QCOMPARE(drawn_, (std::vector<QRectF>{kAll, kPart}));
  }

  void itHasThePixelsOfTheDevice() {
    const QImage once = paint(kAll, 0, 1, 1.5);
    for (int i = 0; i < 3; ++i) QCOMPARE(paint(kAll, 0, 1, 1.5), once);
    QCOMPARE(drawn_.size(), std::size_t(2));
    QCOMPARE(kept_.bytes(), std::size_t(60 * 45 * 4));
    paint(kAll, 0, 1, 1);
    QCOMPARE(drawn_.size(), std::size_t(3));
  }

  void whatShowsThroughIsDrawnEachTime() {
    for (int i = 0; i < 3; ++i) paint(kAll, 0, 0.5);
    QCOMPARE(drawn_.size(), std::size_t(3));
  }
};

}  // namespace test_kept_picture

MAPWRIGHT_TEST(test_kept_picture, TestKeptPicture, Widgets)
#include "test_kept_picture.moc"
