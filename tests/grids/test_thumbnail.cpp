// Small pictures of whole maps: what they show, and what they do not cost.
#include <QImage>
#include <QTest>

#include "grids/thumbnail.h"
#include "sentences/fault_sentence.h"
#include "test_program.h"

namespace test_thumbnail {

using namespace mapwright;

namespace {

/// Free, but for a wall one cell wide down the middle, and unknown in its lowest quarter.
map::WholeMap room(int width, int height) {
  std::string pgm = "P5\n" + std::to_string(width) + ' ' + std::to_string(height) + "\n255\n";
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) pgm += char(y * 4 >= height * 3 ? 205 : x == width / 2 ? 0 : 254);
  }
  map::WholeMap made;
  made.reading.mode = map::CellReading::Mode::Trinary;
  made.bytes = std::make_shared<const std::string>(std::move(pgm));
  return made;
}

QImage shown(const tl::expected<std::string, Fault>& picture) {
  return picture ? QImage::fromData(QByteArray::fromStdString(*picture)) : QImage();
}

}  // namespace

class TestThumbnail : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aLargeMapBecomesSmallAndKeepsItsWalls() {
    const QImage picture = shown(grids::thumbnailOf(room(1200, 800)));
    QVERIFY(picture.width() <= 192 && picture.width() > 96);
    QCOMPARE(picture.height(), (picture.width() * 800 + 600) / 1200);
    QVERIFY(qGray(picture.pixel(2, 2)) > 240);
    int dark = 0;
    for (int x = 0; x < picture.width(); ++x) dark += qGray(picture.pixel(x, 10)) < 20;
    QVERIFY2(dark == 1, qPrintable(QString::number(dark)));  // the wall, one cell of 1200
    const int unknown = qGray(picture.pixel(5, picture.height() - 2));
    QVERIFY(unknown > 150 && unknown < 240);
  }

  void aSmallMapStaysAsItIs() { QCOMPARE(shown(grids::thumbnailOf(room(40, 30))).size(), QSize(40, 30)); }

  void whatIsTooLargeOrBrokenSaysSo() {
    const auto large = grids::thumbnailOf(room(100, 100), {}, 9'999);
    QVERIFY(!large);
    QVERIFY2(sentences::wordsOf(large.error()).contains(QLatin1String("10,000")),
             qPrintable(sentences::wordsOf(large.error())));
    map::WholeMap broken;
    broken.bytes = std::make_shared<const std::string>("not a picture");
    QVERIFY(!grids::thumbnailOf(broken));
    map::WholeMap gone;
    gone.path = "/no/such/file.png";
    QVERIFY(!grids::thumbnailOf(gone));
  }
};

}  // namespace test_thumbnail

MAPWRIGHT_TEST(test_thumbnail, TestThumbnail, Core)
#include "test_thumbnail.moc"
