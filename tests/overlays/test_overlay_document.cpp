// Overlays as a document: what is not edited is written back to the byte.
#include <QTest>

#include "overlays/overlay_document.h"
#include "test_program.h"

namespace test_overlay_document {

using namespace mapwright::overlays;

namespace {

OverlayDocument read(const std::string& text) {
  auto document = OverlayDocument::read(text);
  if (!document) qFatal("no overlays: %s", text.c_str());
  return std::move(*document);
}

const std::string kOdd =
    "\xEF\xBB\xBF{ \"type\" : \"FeatureCollection\",\r\n"
    "\t\"properties\":{\"defaultRackWidth\":1.50,\"x\":1e3},\n \"features\" : [\n"
    "  "
    "{\"type\":\"Feature\",\"id\":12345678901234567890,\"geometry\":{\"type\":\"Point\",\"coordinates\":[1.0,"
    "2,"
    "0]},\"properties\":{\"type\":\"9\",\"name\":\"\\u00fc\",\"yaw\":\"90\"}} ,\n"
    "  "
    "{\"geometry\":{\"coordinates\":[[0,0],[1e0,0.10]],\"type\":\"LineString\"},\"properties\":{\"lineType\":"
    "2,"
    "\"name\":null}},\n\n"
    "  null, 7,\n"
    "  {\"id\":\"\",\"properties\":{\"id\":\"p1\",\"regionType\":\"12\"},\"geometry\":{\"type\":\"Polygon\","
    "\"coordinates\":[]},\"foreign\":[{}]}\n ] , \"crs\":null}\n";

}  // namespace

class OverlayDocumentTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatIsNotEditedIsWrittenBackToTheByte_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("odd") << QByteArray::fromStdString(kOdd);
    for (const char* text : {"", " \n", "null", "{}", "[]", "[ {} , {} ]", R"({"features":null})",
                             R"({"features":[]})", R"({"type":"FeatureCollection"})"}) {
      QTest::newRow(text) << QByteArray(text);
    }
  }
  void whatIsNotEditedIsWrittenBackToTheByte() {
    QFETCH(const QByteArray, text);
    QCOMPARE(read(text.toStdString()).text(), text.toStdString());
  }

  void featuresTellWhatTheyAre() {
    const OverlayDocument document = read(kOdd);
    QCOMPARE(document.features().size(), std::size_t(5));
    const auto& features = document.features();
    QCOMPARE(features[0].id(), std::string("12345678901234567890"));
    QCOMPARE(features[0].name(), std::string("ü"));
    QVERIFY(features[0].shape() == Shape::Point && features[1].shape() == Shape::Line);
    QVERIFY(features[4].shape() == Shape::Polygon && features[2].shape() == Shape::None);
    QCOMPARE(features[0].type(), 9);
    QCOMPARE(features[1].type(), 2);
    QCOMPARE(features[4].type(), 12);
    QCOMPARE(features[1].name(), std::string());
    QCOMPARE(features[4].id(), std::string("p1"));
  }

  void whatIsNoCollectionIsRefused() {
    for (const char* text :
         {"7", "\"x\"", "true", R"({"features":{}})", "{", R"({"type":"Feature","geometry":null})",
          R"({"type":"Point","coordinates":[1,2]})", R"({"type":"GeometryCollection","geometries":[]})",
          R"({"features":[{"id":1}],"features":[]})"})
      QVERIFY2(!OverlayDocument::read(text), text);
  }

  void aFeatureIsReplacedAddedAndRemovedAmongTheOthers() {
    OverlayDocument document = read("{\"features\": [\n  {\"id\":1},\n  {\"id\":2},\n  {\"id\":3}\n]}");
    document.replace(1, Feature(R"({"id":"two"})"));
    QCOMPARE(document.text(),
             std::string("{\"features\": [\n  {\"id\":1},\n  {\"id\":\"two\"},\n  {\"id\":3}\n]}"));
    document.add(Feature(R"({"id":4})"));
    document.remove(0);
    QCOMPARE(document.text(),
             std::string("{\"features\": [\n  {\"id\":\"two\"},\n  {\"id\":3},\n  {\"id\":4}\n]}"));
    document.remove(2);
    document.remove(1);
    document.remove(0);
    QCOMPARE(document.text(), std::string("{\"features\": [\n]}"));
    document.add(Feature(R"({"id":5})"));
    QVERIFY(OverlayDocument::read(document.text()));
  }

  void theFirstFeatureMakesTheCollection() {
    for (const char* text :
         {"", "null", "{}", R"({"features":null,"x":1.50})", "[]", R"({"x":1.50,"features":[]})"}) {
      OverlayDocument document = read(text);
      document.add(Feature(R"({"id":1})"));
      document.add(Feature(R"({"id":2})"));
      const auto again = OverlayDocument::read(document.text());
      QVERIFY2(again && again->features().size() == 2, document.text().c_str());
      QCOMPARE(again->features()[1].id(), std::string("2"));
      if (std::string_view(text).find("1.50") != std::string_view::npos)
        QVERIFY2(document.text().find("1.50") != std::string::npos, document.text().c_str());
    }
  }

  void membersOfTheCollectionAreSetAndRemoved() {
    OverlayDocument document = read(R"({"features": [{"id":1.50}], "properties": {"a": 1}})");
    document.setMember("properties", R"({"a": 2})");
    document.setMember("crs", "null");
    QCOMPARE(document.text(),
             std::string(R"({"features": [{"id":1.50}], "properties": {"a": 2}, "crs": null})"));
    document.setMember("properties", std::nullopt);
    QCOMPARE(document.text(), std::string(R"({"features": [{"id":1.50}], "crs": null})"));
  }

  void whatStandsAroundTheCollectionStays() {
    for (const auto& [before, after] : std::vector<std::pair<std::string, std::string>>{
             {"\xEF\xBB\xBF", ""}, {"  \r\n", ""}, {"", "\r\n"}, {"\xEF\xBB\xBF\n", "\n\n"}}) {
      OverlayDocument document = read(before + R"({"crs": 1, "features": [{"id":1} ]})" + after);
      document.setMember("crs", "2");
      QCOMPARE(document.text(), before + R"({"crs": 2, "features": [{"id":1} ]})" + after);
      document.setMember("crs", std::nullopt);
      QCOMPARE(document.text(), before + R"({"features": [{"id":1} ]})" + after);
      for (const char* none : {R"({"features":null})", "null"}) {
        document = read(before + none + after);
        document.add(Feature("{}"));
        const std::string text = document.text();
        QVERIFY2(text.starts_with(before + "{") && text.ends_with("}" + after), text.c_str());
      }
    }
  }
};

}  // namespace test_overlay_document

MAPWRIGHT_TEST(test_overlay_document, OverlayDocumentTest, Nothing)
#include "test_overlay_document.moc"
