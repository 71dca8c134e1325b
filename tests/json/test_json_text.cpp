// JSON as it is written: nothing but what is edited changes, and what is no JSON is refused with its place.
#include <cmath>
#include <random>

#include <QTest>

#include "json/json_text.h"
#include "test_program.h"

namespace test_json_text {

using namespace mapwright::json;

namespace {

JsonText read(const std::string& text) {
  auto json = JsonText::read(text);
  if (!json) qFatal("not JSON: %s", text.c_str());
  return std::move(*json);
}

std::string with(const std::string& object, const char* name, const char* value) {
  return withMember(read(object).root(), name, value);
}

std::string without(const std::string& object, const char* name) {
  return withoutMember(read(object).root(), name);
}

/// All that is known of a value and of those in it.
std::string known(const JsonValue& value) {
  std::string all = value.key() + '=' + std::to_string(int(value.kind())) + std::string(value.text()) + ';' +
                    std::to_string(value.begin()) + ',' + std::to_string(value.keyBegin()) + ';';
  for (const JsonValue& child : value.children()) all += known(child);
  return all;
}

/// One of few values, so that two of them are often the same and are seldom written alike.
std::string someValue(std::mt19937& random, int depth) {
  constexpr const char* kPlain[] = {"1",     "1.0",         "1e0",   "10e-1", "0",    "-0",    "2",
                                    "\"a\"", "\"\\u0061\"", "\"1\"", "null",  "true", "false", "NaN"};
  const auto upTo = [&random](unsigned most) { return unsigned(random()) % (most + 1); };
  const unsigned kind = depth == 0 ? 0 : upTo(2);
  if (kind == 0) return kPlain[upTo(unsigned(std::size(kPlain)) - 1)];
  std::string text(1, kind == 1 ? '[' : '{');
  for (unsigned left = upTo(2); left-- > 0;) {
    if (kind == 2) text += upTo(1) ? "\"x\":" : "\"y\": ";
    text += someValue(random, depth - 1);
    text += left > 0 ? ", " : "";
  }
  return text + (kind == 1 ? ']' : '}');
}

bool same(const char* a, const char* b) { return sameValue(read(a).root(), read(b).root()); }

}  // namespace

class JsonTextTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyKindOfValueIsRead() {
    const JsonText json = read(R"( {"a": [1, -2.50, 1e3], "b":{"c":null}, "d" : true, "e":false, "f":"x"} )");
    const JsonValue root = json.root();
    QCOMPARE(root.children().size(), std::size_t(5));
    QCOMPARE(root.member("a")->children()[1].text(), std::string_view("-2.50"));
    QCOMPARE(root.member("a")->children()[2].number(), 1000.0);
    QVERIFY(root.member("b")->member("c")->kind() == JsonKind::Null);
    QVERIFY(root.member("d")->kind() == JsonKind::True && root.member("e")->kind() == JsonKind::False);
    QCOMPARE(root.member("f")->string(), std::string("x"));
    QVERIFY(!root.member("g"));
  }

  void stringsAreDecoded() {
    // Not a raw string: moc takes the escapes in it for its end.
    const JsonText json =
        read("[\"\\u0041\\n\\/\\\"\\\\\", \"\\ud83d\\ude00\", \"\\ud83d\", \"\\ude00x\", \"ü\"]");
    const auto strings = json.root().children();
    QCOMPARE(strings[0].string(), std::string("A\n/\"\\"));
    QCOMPARE(strings[1].string(), std::string("😀"));
    QCOMPARE(strings[2].string(), std::string("\xED\xA0\xBD"));
    QCOMPARE(strings[3].string(), std::string("\xED\xB8\x80x"));
    QVERIFY(!JsonText::read('"' + strings[2].string() + '"'));
    QCOMPARE(strings[4].string(), std::string("ü"));
  }

  void numbersBeyondDoublesAreInfiniteOrNothing() {
    const JsonText json = read("[1e999, -1e999, 1e-999, NaN, -Infinity, 12345678901234567890]");
    const auto numbers = json.root().children();
    QVERIFY(std::isinf(numbers[0].number()) && numbers[0].number() > 0);
    QVERIFY(std::isinf(numbers[1].number()) && numbers[1].number() < 0);
    QCOMPARE(numbers[2].number(), 0.0);
    QVERIFY(std::isnan(numbers[3].number()));
    QVERIFY(std::isinf(numbers[4].number()) && numbers[4].number() < 0);
    QCOMPARE(numbers[5].text(), std::string_view("12345678901234567890"));
  }

  void whatIsNoJsonIsRefusedWithItsPlace_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("line");
    QTest::addColumn<int>("column");
    QTest::newRow("nothing") << QByteArray("") << 1 << 1;
    QTest::newRow("end") << QByteArray("{\"a\":\n [1, 2") << 2 << 7;
    QTest::newRow("comma") << QByteArray("{\"a\":\n [1 2]}") << 2 << 5;
    QTest::newRow("last comma") << QByteArray("[1,]") << 1 << 4;
    QTest::newRow("name") << QByteArray("{a:1}") << 1 << 2;
    QTest::newRow("colon") << QByteArray("{\"a\" 1}") << 1 << 6;
    QTest::newRow("rest") << QByteArray("{} x") << 1 << 4;
    QTest::newRow("zeros") << QByteArray("[01]") << 1 << 2;
    QTest::newRow("plus") << QByteArray("[+1]") << 1 << 2;
    QTest::newRow("point") << QByteArray("[1.]") << 1 << 2;
    QTest::newRow("word") << QByteArray("[nul]") << 1 << 2;
    QTest::newRow("escape") << QByteArray("[\"\\x\"]") << 1 << 3;
    QTest::newRow("short escape") << QByteArray("[\"\\u12\"]") << 1 << 3;
    QTest::newRow("control") << QByteArray("[\"a\nb\"]") << 1 << 4;
    QTest::newRow("latin") << QByteArray("[\"\xFC\"]") << 1 << 3;
    QTest::newRow("surrogate") << QByteArray("[\"\xED\xA0\x80\"]") << 1 << 3;
    QTest::newRow("comment") << QByteArray("[1] // x") << 1 << 5;
  }
  void whatIsNoJsonIsRefusedWithItsPlace() {
    QFETCH(const QByteArray, text);
    const auto json = JsonText::read(text.toStdString());
    QVERIFY(!json);
    QTEST(json.error().line, "line");
    QTEST(json.error().column, "column");
  }

  void whatIsNestedTooDeeplyIsRefused() {
    QVERIFY(JsonText::read(std::string(200, '[') + std::string(200, ']')));
    QVERIFY(!JsonText::read(std::string(100'000, '[')));
    QVERIFY(!JsonText::read(std::string(202, '[') + std::string(202, ']')));
  }

  void whatIsCutOutOrRewrittenIsAsIfItHadBeenRead() {
    const JsonText whole = read(R"( {"a": [{"b" :"x", "c": [1, -2.50, []] }, 7], "d":"y"} )");
    const JsonValue root = whole.root(), object = root.member("a")->children()[0];
    const JsonText cut = JsonText::of(object);
    QCOMPARE(cut.text(), std::string(R"({"b" :"x", "c": [1, -2.50, []] })"));
    QCOMPARE(known(cut.root()), known(read(cut.text()).root()));
    QCOMPARE(known(JsonText::of(root.member("a")->children()[1]).root()), known(read("7").root()));
    // In any order, longer and shorter, and of another kind.
    const auto numbers = object.member("c")->children();
    const JsonText other = JsonText::rewritten({{numbers[1], "3"},
                                                {*root.member("d"), "12"},
                                                {numbers[0], "1.0001"},
                                                {*object.member("b"), "\"long\""}});
    QCOMPARE(other.text(), std::string(R"( {"a": [{"b" :"long", "c": [1.0001, 3, []] }, 7], "d":12} )"));
    QCOMPARE(known(other.root()), known(read(other.text()).root()));
  }

  void aMemberIsSetWithoutTouchingTheOthers() {
    QCOMPARE(with(R"({"a": 1.50,  "b":2})", "b", "3"), std::string(R"({"a": 1.50,  "b":3})"));
    QCOMPARE(with(R"({"a": 1, "b": 2})", "c", "3"), std::string(R"({"a": 1, "b": 2, "c": 3})"));
    QCOMPARE(with(R"({"a":1,"b":2})", "c", "3"), std::string(R"({"a":1,"b":2,"c":3})"));
    QCOMPARE(with("{\n  \"a\" : 1,\n  \"b\" : 2\n}", "c", "3"),
             std::string("{\n  \"a\" : 1,\n  \"b\" : 2,\n  \"c\": 3\n}"));
    QCOMPARE(with("{\n  \"a\": 1\n}", "c", "3"), std::string("{\n  \"a\": 1,\n  \"c\": 3\n}"));
    QCOMPARE(with("{}", "c", "3"), std::string(R"({"c": 3})"));
    QCOMPARE(with(R"({"a:b": 1, "x:y": 2})", "c", "3"), std::string(R"({"a:b": 1, "x:y": 2, "c": 3})"));
  }

  void ofANameThatOccursTwiceTheLastCounts() {
    QCOMPARE(read(R"({"a":1,"a":2})").root().member("a")->text(), std::string_view("2"));
    QCOMPARE(with(R"({"a":1,"a":2})", "a", "3"), std::string(R"({"a":1,"a":3})"));
    QCOMPARE(without(R"({"a":1,"b":0,"a":2})", "a"), std::string(R"({"b":0})"));
    QCOMPARE(without(R"({"a":1,"a":2})", "a"), std::string("{}"));
  }

  void aMemberIsRemovedWithItsComma() {
    QCOMPARE(without(R"({"a": 1, "b": 2, "c": 3})", "a"), std::string(R"({"b": 2, "c": 3})"));
    QCOMPARE(without(R"({"a": 1, "b": 2, "c": 3})", "b"), std::string(R"({"a": 1, "c": 3})"));
    QCOMPARE(without(R"({"a": 1, "b": 2, "c": 3})", "c"), std::string(R"({"a": 1, "b": 2})"));
    QCOMPARE(without("{ \"a\": 1 }", "a"), std::string("{  }"));
    QCOMPARE(without(R"({"a": 1})", "x"), std::string(R"({"a": 1})"));
  }

  void theSameValueMayBeWrittenInManyWays() {
    QVERIFY(same("1.50", "1.5") && same("15e-1", "1.5") && same("1.0", "1") && same("-0", "0"));
    QVERIFY(same(R"("A")", R"("\u0041")") && same(R"("\/")", R"("/")"));
    QVERIFY(same(R"({"a":1,"b":[2]})", R"({ "b":[2.0], "a":1 })"));
    QVERIFY(!same("[1,2]", "[2,1]") && !same("1", R"("1")") && !same("null", "false"));
    QVERIFY(!same("9007199254740993", "9007199254740992"));
    QVERIFY(!same("1e400", "1e500"));
    QVERIFY(same("NaN", "NaN"));
    QVERIFY(!same(R"({"a":1})", R"({"a":1,"b":null})"));
    QVERIFY(same(R"({"a":1,"a":2})", R"({"a":2})") && !same(R"({"a":1,"a":2})", R"({"a":1})"));
  }

  void valuesAreTheSameExactlyIfTheirCanonicalTextsAre() {
    std::mt19937 random(7);
    int agreed = 0, pairs = 0;
    for (; pairs < 20'000; ++pairs) {
      const JsonText a = read(someValue(random, 2)), b = read(someValue(random, 2));
      const bool wanted = canonical(a.root()) == canonical(b.root());
      QVERIFY2(sameValue(a.root(), b.root()) == wanted,
               (std::string(a.root().text()) + "  " + std::string(b.root().text())).c_str());
      agreed += wanted ? 1 : 0;
    }
    QVERIFY(agreed > pairs / 50);
  }

  void aStringIsQuoted() {
    QCOMPARE(quoted("a\"b\\c\nd\x01ü"), std::string("\"a\\\"b\\\\c\\nd\\u0001ü\""));
    QCOMPARE(read(quoted("a\"b\\c\nd\x01")).root().string(), std::string("a\"b\\c\nd\x01"));
  }
};

}  // namespace test_json_text

MAPWRIGHT_TEST(test_json_text, JsonTextTest, Nothing)
#include "test_json_text.moc"
