// What a robot holds otherwise than it was sent.
#include <QBuffer>
#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QtTest>

#include "jobs/new_map.h"
#include "test_program.h"

namespace test_new_map {

using namespace mapwright;

class TestNewMap : public QObject {
  Q_OBJECT
  static std::shared_ptr<const std::string> png(const QImage& image, int quality) {
    QBuffer file;
    (void)file.open(QIODevice::WriteOnly);
    (void)image.save(&file, "png", quality);
    return std::make_shared<const std::string>(file.data().toStdString());
  }
 private Q_SLOTS:
  void aPictureThatShowsTheSameIsTheSame() {
    QImage image(40, 30, QImage::Format_Grayscale8);
    image.fill(254);
    for (int x = 5; x < 35; ++x) image.setPixel(x, 10, qRgb(0, 0, 0));
    robot::NewMap sent;
    sent.name = "Hall";
    sent.grid = {40, 30, 0.05, {0, 0, 0}};
    sent.picture = png(image, 100);
    robot::MapParts held;
    held.facts.name = sent.name;
    held.facts.grid = sent.grid;
    held.picture = png(image, 0);
    QVERIFY(*held.picture != *sent.picture);
    QVERIFY2(jobs::differences(sent, held).isEmpty(),
             qPrintable(jobs::differences(sent, held).join(QLatin1Char(' '))));
    held.picture = png(image.convertToFormat(QImage::Format_RGB32), 0);
    QVERIFY(jobs::differences(sent, held).isEmpty());
    image.setPixel(20, 10, qRgb(254, 254, 254));  // a gap in the wall
    held.picture = png(image, 100);
    QVERIFY(jobs::differences(sent, held).join(QLatin1Char(' ')).contains(QStringLiteral("picture")));
    held.picture = png(image.copy(0, 0, 40, 29), 100);
    QCOMPARE(jobs::differences(sent, held).size(), 1);
    held.picture = std::make_shared<const std::string>("no picture");
    QCOMPARE(jobs::differences(sent, held).size(), 1);
    held.picture = nullptr;
    QCOMPARE(jobs::differences(sent, held), QStringList(QStringLiteral("its picture cannot be loaded")));
  }

  void transparentPixelsAreSentAsGray() {
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("map.png"));
    QImage image(30, 20, QImage::Format_RGBA8888);
    image.fill(QColor(0, 0, 0, 0));  // a robot that looks at the colour only would see walls
    for (int x = 5; x < 25; ++x) image.setPixelColor(x, 10, x < 15 ? Qt::black : Qt::white);
    QVERIFY(image.save(path));
    const auto made = jobs::newMapFrom({path, QStringLiteral("Hall"), 0.05, 0, 0});
    QVERIFY(made && made->made_opaque);
    const QImage sent = QImage::fromData(QByteArray::fromStdString(*made->map.picture));
    QVERIFY(!sent.hasAlphaChannel() && sent.size() == image.size());
    for (int y = 0; y < 20; ++y) {
      for (int x = 0; x < 30; ++x) {
        const int gray = y != 10 || x < 5 || x >= 25 ? 128 : x < 15 ? 0 : 255;
        QCOMPARE(qGray(sent.pixel(x, y)), gray);
      }
    }
    // Without transparency every byte is the file's.
    QVERIFY(image.convertToFormat(QImage::Format_RGB888).save(path));
    const auto plain = jobs::newMapFrom({path, QStringLiteral("Hall"), 0.05, 0, 0});
    QVERIFY(plain && !plain->made_opaque);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(QByteArray::fromStdString(*plain->map.picture), file.readAll());
  }

  void otherOverlaysAreOtherwise() {
    robot::NewMap sent;
    robot::MapParts held;
    sent.picture = held.picture = std::make_shared<const std::string>("a picture");
    sent.overlays = R"({"type":"FeatureCollection","features":[{"properties":{"name":"A","x":1.50}}]})";
    const auto odd = [&](const std::string& overlays) {
      held.facts.overlays = overlays;
      return jobs::differences(sent, held);
    };
    QCOMPARE(odd(sent.overlays), QStringList());
    // Other blanks, another notation, and an id that the robot gave.
    QCOMPARE(
        odd(R"({"features": [{"id": 7, "properties": {"x": 1.5, "name": "A"}}],"type":"FeatureCollection"})"),
        QStringList());
    QCOMPARE(odd(""), QStringList(QStringLiteral("it has no overlays")));
    for (const char* other :
         {R"({"type":"FeatureCollection","features":[]})", "{\"type\":\"FeatureColl",
          R"({"type":"FeatureCollection","features":[{"properties":{"name":"B","x":1.50}}]})"})
      QCOMPARE(odd(other), QStringList(QStringLiteral("its overlays are other ones")));
    sent.overlays = "no GeoJSON";
    QCOMPARE(odd("{}").size(), 1);
  }
};

}  // namespace test_new_map

MAPWRIGHT_TEST(test_new_map, TestNewMap, Core)
#include "test_new_map.moc"
