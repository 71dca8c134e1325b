// What differs between two pictures, what of it is allowed, and where on the map it lies.
#include <QFile>
#include <QImage>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>

#include "compare/comparison.h"
#include "compare/comparison_sentence.h"
#include "compare/difference_picture.h"
#include "compare/faults.h"
#include "compare/picture_view.h"
#include "test_program.h"

namespace test_comparison {

using namespace mapwright;
using compare::Allowed;
using compare::Comparison;
using compare::PixelBox;

namespace {

constexpr QRgb kGround = 0xffe0e4e8, kMarker = 0xffc02020;

QImage ground(int width = 200, int height = 150) {
  QImage picture(width, height, QImage::Format_RGB32);
  picture.fill(kGround);
  return picture;
}

QImage withBlock(QImage picture, const QRect& block, QRgb colour = kMarker) {
  for (int y = block.top(); y <= block.bottom(); ++y) {
    for (int x = block.left(); x <= block.right(); ++x) picture.setPixel(x, y, colour);
  }
  return picture;
}

/// The same numbers in every run.
class Dice {
 public:
  unsigned next(unsigned below) {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return unsigned(state_ >> 33) % below;
  }

 private:
  unsigned long long state_ = 7;
};

}  // namespace

class ComparisonTest : public QObject {
  Q_OBJECT
  QTemporaryDir folder_;

  std::string path(const char* name) const { return folder_.filePath(QLatin1String(name)).toStdString(); }
  std::string put(const char* name, const QImage& picture) const {
    if (!picture.save(QString::fromStdString(path(name)))) qFatal("%s: not written", name);
    return path(name);
  }
  Comparison compared(const QImage& expected, const QImage& actual, const Allowed& allowed = {}) const {
    const auto made = compare::comparePictures(put("a.png", expected), put("b.png", actual), allowed);
    if (!made) qFatal("not compared: %s", inEnglish(made.error()).c_str());
    return *made;
  }

 private Q_SLOTS:
  void animationsAreRefused() {
    const std::string still = put("still.png", ground());
    for (const char pictures : {'\x01', '\x02'}) {
      QFile file(QString::fromStdString(still));
      QVERIFY(file.open(QIODevice::ReadOnly));
      QByteArray bytes = file.readAll();
      // Behind the header: how many pictures, how often they are shown, and a checksum that nobody looks at.
      bytes.insert(33, QByteArray("\0\0\0\x08"
                                  "acTL\0\0\0",
                                  11) +
                           pictures + QByteArray(8, '\0'));
      QFile moving(QString::fromStdString(path("moving.png")));
      QVERIFY(moving.open(QIODevice::WriteOnly | QIODevice::Truncate));
      moving.write(bytes);
      moving.close();
      const auto made = compare::comparePictures(still, path("moving.png"), {});
      QCOMPARE(made.has_value(), pictures == '\x01');
      if (!made) QVERIFY(inEnglish(made.error()).find("animation") != std::string::npos);
    }
  }

  void theSamePicturesAreEqual() {
    const Comparison made = compared(ground(), ground());
    QVERIFY(made.equal && made.clusters.empty() && made.differs.empty());
    QCOMPARE(made.differing, std::int64_t(0));
    QCOMPARE(compare::comparisonText(made, {}), QStringLiteral("The pictures are the same."));
  }

  void aPixelThatDiffersInOneChannelDiffers() {
    QImage other = ground();
    other.setPixel(10, 20, qRgb(0xe0, 0xe4, 0xe9));
    const Comparison exact = compared(ground(), other);
    QVERIFY(!exact.equal);
    QCOMPARE(exact.differing, std::int64_t(1));
    QCOMPARE(exact.max, 1);
    QCOMPARE(exact.clusters.front().box, (PixelBox{10, 20, 1, 1}));
    QVERIFY(compared(ground(), other, {.tolerance = 1}).equal);
  }

  void transparencyIsAChannel() {
    QImage clear(8, 8, QImage::Format_ARGB32);
    clear.fill(qRgba(90, 90, 90, 255));
    QImage other = clear;
    other.setPixel(3, 3, qRgba(90, 90, 90, 0));
    QCOMPARE(compared(clear, other).max, 255);
  }

  void noiseWithinTheTolerancePasses() {
    Dice dice;
    QImage noisy = ground();
    for (int y = 0; y < noisy.height(); ++y) {
      for (int x = 0; x < noisy.width(); ++x)
        noisy.setPixel(x, y, qRgb(0xe0 + int(dice.next(7)) - 3, 0xe4, 0xe8));
    }
    const Comparison made = compared(ground(), noisy, {.tolerance = 3});
    QVERIFY(made.equal);
    QCOMPARE(made.differing, std::int64_t(0));
    QCOMPARE(made.max, 3);
    QVERIFY(!compared(ground(), noisy, {.tolerance = 2}).equal);
  }

  void speckleWithinTheSharePasses() {
    Dice dice;
    QImage speckled = ground();
    for (int i = 0; i < 300; ++i) speckled.setPixel(int(dice.next(200)), int(dice.next(150)), qRgb(0, 0, 0));
    const Comparison made = compared(ground(), speckled, {.max_differing_percent = 2});
    QVERIFY(made.equal);
    QVERIFY(made.differing > 250 && made.clusters_dense == 0);
    QVERIFY(!compared(ground(), speckled, {.max_differing_percent = 0.5}).equal);
  }

  void aLostMarkerFailsWhateverShareIsAllowed() {
    const QImage marked = withBlock(ground(), {50, 40, 6, 6});
    const Comparison made = compared(marked, ground(), {.max_differing_percent = 100});
    QVERIFY(!made.equal);
    QCOMPARE(made.differing, std::int64_t(36));
    QCOMPARE(made.clusters.size(), std::size_t(1));
    QVERIFY(made.clusters.front().dense);
    QCOMPARE(made.clusters.front().box, (PixelBox{50, 40, 6, 6}));
  }
  void aLostMarkerFailsAmongSpeckle() {
    Dice dice;
    QImage speckled = ground();
    for (int i = 0; i < 300; ++i) speckled.setPixel(int(dice.next(200)), int(dice.next(150)), qRgb(0, 0, 0));
    QVERIFY(!compared(withBlock(ground(), {50, 40, 6, 6}), speckled, {.max_differing_percent = 50}).equal);
  }
  void aLostRingAndALostLineFailToo() {
    const QImage ring = withBlock(withBlock(ground(), {20, 20, 6, 6}), {21, 21, 4, 4}, kGround);
    QVERIFY(!compared(ring, ground(), {.max_differing_percent = 100}).equal);
    QVERIFY(!compared(withBlock(ground(), {20, 70, 90, 1}), ground(), {.max_differing_percent = 100}).equal);
  }

  void whatIsNearIsOneCluster() {
    QImage other = withBlock(ground(), {10, 10, 4, 4});
    other = withBlock(withBlock(other, {17, 10, 2, 4}), {100, 100, 8, 8});
    const Comparison made = compared(ground(), other);
    QCOMPARE(made.clusters_in_all, std::int64_t(2));
    QCOMPARE(made.clusters[0].box, (PixelBox{100, 100, 8, 8}));
    QCOMPARE(made.clusters[1].box, (PixelBox{10, 10, 9, 4}));
    QCOMPARE(made.clusters[1].pixels, std::int64_t(24));
  }

  void theGrayOfAMaskIsWhatMayDiffer() {
    const QImage other = withBlock(ground(), {50, 40, 6, 6}, qRgb(0xd0, 0xe4, 0xe8));
    QImage mask(200, 150, QImage::Format_Grayscale8);
    mask.fill(0);
    for (int y = 40; y < 46; ++y) {
      for (int x = 50; x < 56; ++x) mask.setPixel(x, y, qRgb(16, 16, 16));
    }
    Allowed allowed;
    allowed.mask = put("mask.png", mask);
    const Comparison made = compared(ground(), other, allowed);
    QVERIFY(made.equal);
    QCOMPARE(made.max, 0);
    QVERIFY(!compared(ground(), withBlock(ground(), {50, 40, 6, 6}, qRgb(0xcf, 0xe4, 0xe8)), allowed).equal);
    QVERIFY(!compared(ground(), withBlock(ground(), {56, 40, 6, 6}, qRgb(0xd0, 0xe4, 0xe8)), allowed).equal);
    allowed.mask = put("small.png", ground(20, 15));
    const auto refused = compare::comparePictures(path("a.png"), path("b.png"), allowed);
    QVERIFY(!refused && refused.error().code == compare::fault::MaskOfOtherSize);
  }

  void otherSizesAreSaidAndNeverEqual() {
    const Comparison made = compared(ground(), ground(180, 160), {.max_differing_percent = 100});
    QVERIFY(!made.equal && !made.sameSize());
    QCOMPARE(made.differing, std::int64_t(20 * 150 + 180 * 10));
    QVERIFY(compare::comparisonText(made, {}).startsWith(
        QStringLiteral("The sizes differ: 200 x 150 expected, 180 x 160 here. 4,800 pixels differ (15 %)")));
    const QString most = compare::comparisonText(compared(ground(1, 1), ground(100, 100)), {});
    QVERIFY2(most.contains(QStringLiteral("9,999 pixels differ (100 %)")), qPrintable(most));
    for (const auto& made_of :
         {compared(ground(60, 50), ground(60, 40)), compared(ground(60, 40), ground(60, 50))}) {
      QCOMPARE(made_of.clusters.size(), std::size_t(1));
      QCOMPARE(made_of.clusters.front().box, (PixelBox{0, 40, 60, 10}));
      QCOMPARE(made_of.percent(), 20.0);
    }
  }

  void whatCannotBeReadIsRefused_data() {
    QTest::addColumn<QByteArray>("bytes");
    QImage picture = ground(400, 300);
    QTemporaryDir folder;
    picture.save(folder.filePath(QStringLiteral("p.png")));
    QFile file(folder.filePath(QStringLiteral("p.png")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray whole = file.readAll();
    QTest::newRow("nothing") << QByteArray();
    QTest::newRow("no picture") << QByteArray("hello");
    QTest::newRow("cut off") << whole.left(whole.size() / 2);
    // The header of a picture of a hundred thousand by a hundred thousand pixels.
    QTest::newRow("a bomb") << QByteArray::fromHex(
        "89504e470d0a1a0a0000000d49484452000186a0000186a00800000000ba6a1c3e0000000a49444154789c63600000000200"
        "0148af"
        "a47100000000"
        "49454e44ae426082");
  }
  void whatCannotBeReadIsRefused() {
    QFETCH(QByteArray, bytes);
    const std::string good = put("good.png", ground());
    QFile file(QString::fromStdString(path("bad.png")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
    file.close();
    QVERIFY(!compare::comparePictures(good, path("bad.png"), {}));
    QVERIFY(!compare::comparePictures(path("bad.png"), good, {}));
    QVERIFY(!compare::comparePictures(good, path("nowhere.png"), {}));
  }

  void theDifferenceShowsTheMapPaleAndWhatDiffersStrongInABox() {
    const QImage actual = withBlock(ground(), {90, 60, 6, 6});
    const Comparison made = compared(ground(), actual);
    QVERIFY(!compare::writeDifference(made, path("a.png"), path("b.png"), path("d.png")));
    const QImage picture(QString::fromStdString(path("d.png")));
    QCOMPARE(picture.size(), actual.size());
    const QColor inside = picture.pixelColor(92, 62), pale = picture.pixelColor(5, 5),
                 box = picture.pixelColor(86, 62);
    QVERIFY(inside.saturation() > 200 && inside.value() > 150);
    QVERIFY(pale.saturation() == 0 && pale.value() > 200);
    QVERIFY(box.saturation() > 200 && box != inside);
    QCOMPARE(picture.pixelColor(89, 62), pale);  // room between
  }

  void samplesOf16BitsAreComparedExactly() {
    for (const QImage::Format format : {QImage::Format_Grayscale16, QImage::Format_RGBA64}) {
      QImage one(20, 20, format), other(20, 20, format);
      for (QImage* const image : {&one, &other}) image->fill(qRgb(128, 128, 128));
      QCOMPARE(compared(one, other).max, 0);
      // By the last bit of one sample.
      reinterpret_cast<quint16*>(other.scanLine(5))[7] ^= 1;
      const Comparison made = compared(one, other);
      QVERIFY(!made.equal);
      QCOMPARE(made.differing, std::int64_t(1));
      QCOMPARE(made.max, 1);
      QVERIFY(compared(one, other, {.tolerance = 1}).equal);
    }
    // The same gray in 8 and in 16 bits.
    QImage flat(20, 20, QImage::Format_Grayscale8), deep(20, 20, QImage::Format_Grayscale16);
    flat.fill(200);
    for (int y = 0; y < 20; ++y) std::fill_n(reinterpret_cast<quint16*>(deep.scanLine(y)), 20, 200 * 257);
    QCOMPARE(compared(flat, deep).max, 0);
  }

  void howAColourIsWrittenMakesNoDifference() {
    const QImage marked = withBlock(ground(), {50, 40, 6, 6});
    const QImage indexed = marked.convertToFormat(QImage::Format_Indexed8);
    QVERIFY(indexed.colorCount() == 2);
    QCOMPARE(compared(marked, indexed).max, 0);
    // Its colour counts also where nothing is to be seen of it.
    QImage clear(8, 8, QImage::Format_ARGB32);
    clear.fill(qRgba(90, 90, 90, 0));
    QImage other = clear;
    other.setPixel(3, 3, qRgba(80, 90, 90, 0));
    QCOMPARE(compared(clear, other).max, 10);
  }

  void whatOnlyOneOfTwoSizesHasIsShown() {
    const auto strong = [](const QColor& colour) { return colour.saturation() > 200; };
    for (const auto& [expected, actual] :
         {std::pair(ground(230, 150), ground(200, 180)), std::pair(ground(200, 180), ground(230, 150))}) {
      const Comparison made = compared(expected, actual);
      QCOMPARE(made.differing, std::int64_t(30 * 150 + 200 * 30));
      QCOMPARE(made.clusters.size(), std::size_t(1));
      QCOMPARE(made.clusters.front().box, (PixelBox{0, 0, 230, 180}));
      QVERIFY(!compare::writeDifference(made, path("a.png"), path("b.png"), path("d.png")));
      const QImage picture(QString::fromStdString(path("d.png")));
      QCOMPARE(picture.size(), QSize(230, 180));
      for (const QPoint& at : {QPoint(210, 60), QPoint(60, 160)}) {
        int hatched = 0;
        for (int x = 0; x < 16; ++x) hatched += strong(picture.pixelColor(at.x() + x, at.y())) ? 1 : 0;
        QCOMPARE(hatched, 8);
      }
      QVERIFY(!strong(picture.pixelColor(60, 60)));
      QCOMPARE(picture.pixelColor(215, 165), QColor(Qt::white));  // neither has it
    }
  }

  void theReportBesideAPictureTellsWhereItLies() {
    geometry::ViewTransform view;
    view.center_m = {10, -4};
    view.scale_m_per_px = 0.05;
    view.width_px = 200;
    view.height_px = 150;
    QFile file(QString::fromStdString(path("b.json")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QJsonDocument(QJsonObject{{QStringLiteral("view"), compare::jsonOf(view)}}).toJson());
    file.close();
    const QString picture = QString::fromStdString(path("b.png"));
    QCOMPARE(compare::viewBeside(picture, {200, 150}), std::optional(view));
    QVERIFY(!compare::viewBeside(picture, {200, 151}));
    // A box in the upper left corner.
    const geometry::WorldRect world = compare::worldOf(view, {0, 0, 20, 10});
    QVERIFY(std::abs(world.min_x - 5) < 1e-9 && std::abs(world.max_x - 6) < 1e-9);
    QVERIFY(std::abs(world.max_y + 0.25) < 1e-9 && std::abs(world.min_y + 0.75) < 1e-9);
    const Comparison made = compared(ground(), withBlock(ground(), {0, 0, 20, 10}));
    QCOMPARE(compare::clustersText(made, view), QStringLiteral("1 cluster of 0.50 m² at (5.5, -0.5)"));
    const QJsonObject cluster = compare::clustersJson(made, view).at(0).toObject();
    QCOMPARE(cluster[QLatin1String("world")].toArray(), (QJsonArray{5.0, -0.75, 1.0, 0.5}));
    QCOMPARE(cluster[QLatin1String("box")].toArray(), (QJsonArray{0, 0, 20, 10}));
  }
};

}  // namespace test_comparison

MAPWRIGHT_TEST(test_comparison, ComparisonTest, Core)
#include "test_comparison.moc"
