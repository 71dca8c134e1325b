// Fields of messages: named, read, and found.
#include <cmath>
#include <random>

#include <QtTest>

#include "series/fields.h"
#include "test_program.h"

namespace test_series_fields {

using namespace mapwright;
using namespace mapwright::series;

namespace {

FieldPath path(const char* text) { return FieldPath::parse(text).value_or(FieldPath{}); }

std::optional<double> read(const char* text, std::string_view json, const char* topic = "/t") {
  return FieldReader({path(text)}).read(topic, json).front();
}

}  // namespace

class TestSeriesFields : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aPathIsReadAndWritten_data();
  void aPathIsReadAndWritten();
  void whatIsNoPathIsNone_data();
  void whatIsNoPathIsNone();
  void garbageIsNoPathOrReadBack();
  void numbersAreRead();
  void oneParseReadsAllFields();
  void otherTopicsAndBrokenMessagesHaveNoValue();
  void fieldsAreFound();
  void deepAndLongMessagesAreBounded();
  void quantitiesAreThoseOfTheMessages();
};

void TestSeriesFields::aPathIsReadAndWritten_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<int>("steps");
  for (const char* text : {"/t.a", "/t.pos[0]", "/a/b/c.x[12].y[0][1].z", "/t[3]", "/t[\"odd.name\"].b",
                           "/t[\"q\\\"\\\\\"]", "\"/odd.topic\".x", "\"/odd topic\"[0]", "/t[\"\"]"}) {
    const QByteArray bytes(text);
    QTest::newRow(text) << bytes << int(path(text).steps.size());
  }
}
void TestSeriesFields::aPathIsReadAndWritten() {
  QFETCH(QByteArray, text);
  const auto parsed = FieldPath::parse(text.toStdString());
  QVERIFY(parsed);
  QCOMPARE(QByteArray::fromStdString(parsed->text()), text);
  QVERIFY(FieldPath::parse(parsed->text()) == parsed);
}

void TestSeriesFields::whatIsNoPathIsNone_data() {
  QTest::addColumn<QByteArray>("text");
  for (const char* text :
       {"", "/t", "/t.", "/t..a", "/t[", "/t[]", "/t[-1]", "/t[1", "/t[1x]", "/t[\"a]", "/t[\"a\"", "/t.a b",
        "\"/t", "\"\".a", ".a", "[0]", "/t[99999999999999999999999]", "/t.a]", "/t[0]a"}) {
    QTest::newRow(qPrintable(QLatin1Char('<') + QLatin1String(text))) << QByteArray(text);
  }
  QTest::newRow("too long") << QByteArray("/t.") + QByteArray(2000, 'a');
  QTest::newRow("too deep") << QByteArray("/t") + QByteArray(".a").repeated(33);
}
void TestSeriesFields::whatIsNoPathIsNone() {
  QFETCH(QByteArray, text);
  QVERIFY(!FieldPath::parse(text.toStdString()));
}

void TestSeriesFields::garbageIsNoPathOrReadBack() {
  std::mt19937 random(7);
  const std::string letters = "/a.[]\"\\0159 \n\x80";
  int paths = 0;
  for (int i = 0; i < 200'000; ++i) {
    std::string text = i % 2 == 0 ? "/t" : "";
    for (int n = int(random() % 12); n > 0; --n) text += letters[random() % letters.size()];
    const auto parsed = FieldPath::parse(text);
    if (!parsed) continue;
    ++paths;
    QVERIFY2(FieldPath::parse(parsed->text()) == parsed, text.c_str());
  }
  QVERIFY(paths > 100);
}

void TestSeriesFields::numbersAreRead() {
  const std::string json =
      R"({"i":-3,"u":18446744073709551615,"d":2.5e-3,"yes":true,"no":false,"s":" 12.25 ","plus":"+7","nan":"nan","nothing":null,"word":"full","empty":"","object":{"x":1},"pos":[1,[2,3]]})";
  QCOMPARE(*read("/t.i", json), -3.0);
  QCOMPARE(*read("/t.u", json), 18446744073709551615.0);
  QCOMPARE(*read("/t.d", json), 2.5e-3);
  QCOMPARE(*read("/t.yes", json), 1.0);
  QCOMPARE(*read("/t.no", json), 0.0);
  QCOMPARE(*read("/t.s", json), 12.25);
  QCOMPARE(*read("/t.plus", json), 7.0);
  QVERIFY(std::isnan(*read("/t.nan", json)));
  QVERIFY(std::isnan(*read("/t.nothing", json)));
  QCOMPARE(*read("/t.object.x", json), 1.0);
  QCOMPARE(*read("/t.pos[1][1]", json), 3.0);
  for (const char* absent :
       {"/t.word", "/t.empty", "/t.object", "/t.pos", "/t.pos[2]", "/t.pos.x", "/t.i.x", "/t.i[0]", "/t[0]"})
    QVERIFY2(!read(absent, json), absent);
}

void TestSeriesFields::oneParseReadsAllFields() {
  FieldReader reader({path("/t.a"), path("/other.a"), path("/t.b[1]"), path("/t.c")});
  QVERIFY(reader.wants("/t") && reader.wants("/other") && !reader.wants("/nothing"));
  const auto& values = reader.read("/t", R"({"a":1,"b":[2,3]})");
  QCOMPARE(values.size(), std::size_t(4));
  QVERIFY(values[0] == 1.0 && !values[1] && values[2] == 3.0 && !values[3]);
  // Nothing of the message before is left.
  const auto& later = reader.read("/other", R"({"a":9})");
  QVERIFY(!later[0] && later[1] == 9.0 && !later[2]);
}

void TestSeriesFields::otherTopicsAndBrokenMessagesHaveNoValue() {
  QVERIFY(!read("/t.a", R"({"a":1})", "/t2"));
  for (const char* broken :
       {"", "{", "null", "3", "[1]", R"({"a":)", R"({"a":1)", R"({"a":1e999})", "\x80\xff", R"({"a":01})"})
    QVERIFY2(!read("/t.a", broken), broken);
  std::mt19937 random(3);
  const std::string sound = R"({"a":[{"b":1.5},"2"],"c":true})";
  FieldReader reader({path("/t.a[0].b"), path("/t.a[1]"), path("/t.c")});
  for (int i = 0; i < 20'000; ++i) {
    std::string text = sound.substr(0, random() % (sound.size() + 1));
    if (!text.empty()) text[random() % text.size()] = char(random() % 256);
    reader.read("/t", text);
  }
  QVERIFY(reader.read("/t", sound)[0] == 1.5);
}

void TestSeriesFields::fieldsAreFound() {
  QStringList found;
  for (const FieldPath& each :
       numericFields("/t", R"({"topic":"/t","pos":[1,2],"ok":true,"o":{"odd.name":3,"w":"x","n":null}})"))
    found << QString::fromStdString(each.text());
  QCOMPARE(found, (QStringList{QStringLiteral("/t.pos[0]"), QStringLiteral("/t.pos[1]"),
                               QStringLiteral("/t.ok"), QStringLiteral("/t.o[\"odd.name\"]")}));
  QVERIFY(numericFields("/t", "[1,2]").empty());
  QVERIFY(numericFields("/t", "{\"a\":").empty());
}

void TestSeriesFields::deepAndLongMessagesAreBounded() {
  std::string deep = "1";
  for (int i = 0; i < 900; ++i) deep = "{\"a\":" + deep + "}";
  QVERIFY(numericFields("/t", deep).empty());
  std::string longest = "{\"a\":[0";
  for (int i = 0; i < 10'000; ++i) longest += ",1";
  QVERIFY(numericFields("/t", longest + "]}").size() <= 20);
  QVERIFY(read("/t.a[10000]", longest + "]}") == 1.0);
}

void TestSeriesFields::quantitiesAreThoseOfTheMessages() {
  const map::TopicMessage pose = map::TrackedPose{{1, 2, geometry::radiansFromDegrees(270)}};
  QCOMPARE(*valueOf(Quantity::X, pose), 1.0);
  QCOMPARE(*valueOf(Quantity::Y, pose), 2.0);
  QVERIFY(std::abs(*valueOf(Quantity::Yaw, pose) + 90) < 1e-9);
  QVERIFY(!valueOf(Quantity::Speed, pose) && !valueOf(Quantity::Battery, pose));
  map::SlamStatus slam;
  slam.position_quality = 8;
  slam.lidar_matching_score = 0.75;
  QCOMPARE(*valueOf(Quantity::PositionQuality, map::TopicMessage(slam)), 8.0);
  QCOMPARE(*valueOf(Quantity::MatchingScore, map::TopicMessage(slam)), 0.75);
  map::BatteryState battery;
  QVERIFY(!valueOf(Quantity::Battery, map::TopicMessage(battery)));
  battery.level = 0.42;
  QCOMPARE(*valueOf(Quantity::Battery, map::TopicMessage(battery)), 42.0);
}

}  // namespace test_series_fields

MAPWRIGHT_TEST(test_series_fields, TestSeriesFields, Nothing)
#include "test_series_fields.moc"
