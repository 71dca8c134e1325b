// What a robot holds otherwise than it was sent.
#include <QBuffer>
#include <QImage>
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
