// Suites as YAML: what is read, and where what is wrong stands.
#include <QTest>

#include "suite/read_suite.h"
#include "test_program.h"

namespace test_read_suite {

using namespace mapwright;

namespace {

const suite::KnownOptions kKnown{{"robot", "size", "center", "layers", "robot-anyway-of"},
                                 {"raw", "robot-anyway"}};

suite::Suite good(const std::string& yaml) {
  const auto read = suite::readSuite(yaml, kKnown);
  if (!read) qFatal("%s", qPrintable(read.error()));
  return *read;
}

}  // namespace

class ReadSuiteTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void viewsTakeTheDefaultsAndTheirOwn() {
    const suite::Suite read = good(
        "defaults: {robot: office.yaml, size: 640x480, tolerance: 2, raw: true}\n"
        "views:\n"
        "  - name: hall\n"
        "    center: [1, -2.5]\n"
        "    max_differing: 0.1\n"
        "  - {name: \"door <b> 🚪\", robot: other.yaml, raw: false, robot_anyway: true, mask: m.png}\n");
    QCOMPARE(read.views.size(), std::size_t(2));
    const suite::View& hall = read.views[0];
    QCOMPARE(hall.name, QStringLiteral("hall"));
    QCOMPARE(hall.at.line, 3);
    QCOMPARE(hall.option("robot"), std::string("office.yaml"));
    QCOMPARE(hall.option("center"), std::string("1,-2.5"));
    QCOMPARE(hall.tolerance, 2);
    QCOMPARE(hall.max_differing_percent, 0.1);
    QCOMPARE(hall.options.size(), std::size_t(4));
    const suite::View& door = read.views[1];
    QCOMPARE(door.option("robot"), std::string("other.yaml"));
    QCOMPARE(door.mask, QStringLiteral("m.png"));
    QCOMPARE(std::count_if(door.options.begin(), door.options.end(),
                           [](const auto& option) { return option.is_switch; }),
             1);
  }

  void qualityIsReadAndAViewsOwnReplacesTheDefault() {
    const suite::Suite read = good(
        "defaults: {quality: {closures_over_m: 0.5}}\n"
        "views:\n"
        "  - {name: usual}\n"
        "  - {name: own, quality: {disagreement_over: 0.02, tolerance_cells: 1}}\n");
    QCOMPARE(read.views[0].quality.closures_over_m, std::optional(0.5));
    QVERIFY(!read.views[0].quality.disagreement_over);
    QVERIFY(!read.views[1].quality.closures_over_m);
    QCOMPARE(read.views[1].quality.disagreement_over, std::optional(0.02));
    QCOMPARE(read.views[1].quality.tolerance_cells, 1);
    QVERIFY(!good("views:\n  - {name: a}").views[0].quality.asked());
    QCOMPARE(good("views:\n  - {name: a, quality: {disagreement_over: 0}}").views[0].quality.tolerance_cells,
             4);
  }

  void aViewSwitchesOffTheQualityOfTheDefaults() {
    for (const char* off : {"false", "null", "~", ""}) {
      const suite::Suite read =
          good(std::string("defaults: {quality: {closures_over_m: 0.5, disagreement_over: 0.1}}\n"
                           "views:\n"
                           "  - {name: judged}\n"
                           "  - name: drawn only\n"
                           "    quality: ") +
               off);
      QVERIFY(read.views[0].quality.asked());
      QVERIFY2(!read.views[1].quality.asked(), off);
    }
    QVERIFY(!good("defaults: {quality: false}\nviews:\n  - {name: a}").views[0].quality.asked());
  }

  void whatIsWrongIsSaidWithItsPlace_data() {
    QTest::addColumn<QString>("yaml");
    QTest::addColumn<QString>("location");
    QTest::addColumn<QString>("word");
    const auto row = [](const char* name, const char* yaml, const char* location, const char* word) {
      QTest::newRow(name) << QString::fromUtf8(yaml) << QString::fromUtf8(location)
                          << QString::fromUtf8(word);
    };
    const char* const in_view = "Line 2, column ";
    row("an unknown key", "views:\n  - {name: a, colour: red}", "Line 2, column 15: ", "\"colour\"");
    row("an unknown key above", "view:\n  - {name: a}", "Line 1, column 1: ", "\"view\"");
    row("a key twice", "views:\n  - {name: a, size: 1x1, size: 2x2}", in_view, "twice");
    row("a key of the defaults twice", "defaults: {size: 1x1, size: 2x2}\nviews:\n  - {name: a}",
        "Line 1, column 23: ", "\"size\" stands here twice");
    row("views twice", "views:\n  - {name: a}\nviews:\n  - {name: b}",
        "Line 3, column 1: ", "\"views\" stands here twice");
    row("defaults twice", "defaults: {raw: true}\nviews:\n  - {name: a}\ndefaults: {}",
        "Line 4, column 1: ", "\"defaults\" stands here twice");
    row("no name", "views:\n  - {robot: a}", in_view, "no name");
    row("an empty name", "views:\n  - {name: \"\"}", "Line 2, column 12: ", "empty");
    row("a name that leaves", "views:\n  - {name: ../x}", in_view, "leave the folder");
    row("an absolute name", "views:\n  - {name: /etc/x}", in_view, "leave the folder");
    row("a backslash", "views:\n  - {name: 'a\\b'}", in_view, "leave the folder");
    row("a hidden name", "views:\n  - {name: .x}", in_view, "leave the folder");
    row("a name with a line break", "views:\n  - {name: \"a\\nb\"}", in_view, "cannot be seen");
    row("a blank at the end", "views:\n  - {name: \"a \"}", in_view, "blanks");
    row("two alike", "views:\n  - {name: Hall}\n  - {name: hall}", "Line 3, column 12: ", "line 2");
    row("two alike by composition", "views:\n  - {name: \"\\u00e4\"}\n  - {name: \"a\\u0308\"}", "Line 3",
        "line 2");
    row("the name of a variant", "views:\n  - {name: hall}\n  - {name: hall.1}", "Line 3", "variant");
    row("a default name", "defaults: {name: a}\nviews:\n  - {name: b}", "Line 1", "default");
    row("a tolerance", "views:\n  - {name: a, tolerance: 300}", in_view, "0 to 255");
    row("half a tolerance", "views:\n  - {name: a, tolerance: 1.5}", in_view, "whole");
    row("a share", "views:\n  - {name: a, max_differing: -1}", in_view, "0 to 100");
    row("a quality that is a number", "views:\n  - {name: a, quality: 0.5}", "Line 2, column 24: ", "limits");
    row("a quality that is true", "views:\n  - {name: a, quality: true}", "Line 2, column 24: ", "or false");
    row("a quality of nothing", "views:\n  - {name: a, quality: {}}", "Line 2, column 24: ", "or both");
    row("an unknown key of quality", "views:\n  - name: a\n    quality:\n      closures: 1",
        "Line 4, column 7: ", "\"closures\" of quality. Known: closures_over_m, disagreement_over");
    row("a key of quality twice", "views:\n  - {name: a, quality: {closures_over_m: 1, closures-over-m: 2}}",
        "Line 2, column 45: ", "twice");
    row("a residual below zero", "views:\n  - {name: a, quality: {closures_over_m: -1}}",
        "Line 2, column 42: ", "closures_over_m must be a number from 0 to 10000");
    row("a residual that is no number", "views:\n  - {name: a, quality: {closures_over_m: nan}}",
        "Line 2, column 42: ", "must be a number");
    row("a share in percent", "views:\n  - {name: a, quality: {disagreement_over: 2}}",
        "Line 2, column 44: ", "0 to 1.");
    row("a tolerance of quality",
        "views:\n  - {name: a, quality: {disagreement_over: 1, tolerance_cells: 1.5}}",
        "Line 2, column 64: ", "tolerance_cells must be a whole number");
    row("a large tolerance of quality",
        "views:\n  - {name: a, quality: {disagreement_over: 1, tolerance_cells: 41}}",
        "Line 2, column 64: ", "0 to 40");
    row("closures without their limit",
        "views:\n  - {name: a, quality: {disagreement_over: 1, closures_at_least: 1}}",
        "Line 2, column 24: ", "without closures_over_m");
    row("half a closure", "views:\n  - {name: a, quality: {closures_over_m: 1, closures_at_least: 1.5}}",
        "Line 2, column 64: ", "closures_at_least must be a whole number");
    row("a tolerance without its limit",
        "views:\n  - {name: a, quality: {closures_over_m: 1, tolerance_cells: 1}}",
        "Line 2, column 24: ", "without disagreement_over");
    row("a switch", "views:\n  - {name: a, raw: 1}", in_view, "true or false");
    row("a map for a text", "views:\n  - {name: a, size: {w: 1}}", in_view, "text or a number");
    row("an empty value", "views:\n  - {name: a, size: \"\"}", in_view, "no value");
    row("a view that is a text", "views:\n  - hall", in_view, "keys");
    row("no YAML", "views:\n  - {name: a", "Line ", "not YAML");
    row("a second document", "views:\n  - {name: a}\n---\nviews:\n  - {name: b}",
        "Line 4, column 1: ", "second document");
    row("views in the second document", "---\n---\nviews:\n  - {name: b}",
        "Line 3, column 1: ", "second document");
    row("a comma at the end", "{\"views\": [{\"name\": \"a\"}]},", "Line 1, column 27: ", "not YAML");
    row("nothing but a comma", ",", "Line 1, column 1: ", "not YAML");
    row("a view of itself", "views: &v\n  - {name: a, size: *v}", "Line 2, column ", "not YAML");
    row("no views", "views: []", "Line 1", "no views");
    row("nothing", "", "", "no views");
    row("a text", "hello", "", "no views");
  }
  void whatIsWrongIsSaidWithItsPlace() {
    QFETCH(QString, yaml);
    QFETCH(QString, location);
    QFETCH(QString, word);
    const auto read = suite::readSuite(yaml.toStdString(), kKnown);
    QVERIFY(!read);
    QVERIFY2(read.error().startsWith(location), qPrintable(read.error()));
    QVERIFY2(read.error().contains(word), qPrintable(read.error()));
  }

  void tenThousandViewsAreRead() {
    std::string yaml = "views:\n";
    for (int i = 0; i < 10'000; ++i) yaml += "  - {name: view " + std::to_string(i) + ", robot: a.yaml}\n";
    QCOMPARE(good(yaml).views.size(), std::size_t(10'000));
  }
  void aDocumentThatBeginsAndEndsIsOne() {
    QCOMPARE(good("---\nviews:\n  - {name: a}\n...\n").views.size(), std::size_t(1));
    QCOMPARE(good("views:\n  - {name: a}\n---\n").views.size(), std::size_t(1));
  }
  void aValueIsNotLongerThanAnybodyWrites_data() {
    QTest::addColumn<int>("entries");
    QTest::addColumn<int>("length");
    QTest::addColumn<bool>("is_read");
    QTest::newRow("many") << 1'000 << 5 << true;
    QTest::newRow("too many") << 1'001 << 1 << false;
    QTest::newRow("too long together") << 900 << 12 << false;
    QTest::newRow("one that is long") << 1 << 10'000 << true;
    QTest::newRow("one that is too long") << 1 << 10'001 << false;
  }
  void aValueIsNotLongerThanAnybodyWrites() {
    QFETCH(int, entries);
    QFETCH(int, length);
    QFETCH(bool, is_read);
    const std::string entry(std::size_t(length), 'x');
    std::string list = entries == 1 ? entry : "[" + entry;
    for (int i = 1; i < entries; ++i) list += "," + entry;
    if (entries > 1) list += "]";
    const auto read =
        suite::readSuite("defaults: {layers: &a " + list + "}\nviews:\n  - {name: a, layers: *a}\n", kKnown);
    QCOMPARE(read.has_value(), is_read);
    if (!read) QVERIFY2(read.error().startsWith(QStringLiteral("Line 1, column ")), qPrintable(read.error()));
  }
  void theValuesOfAllViewsTogetherAreBounded() {
    // Written once, they stand in every view.
    std::string yaml = "defaults: {layers: " + std::string(10'000, 'x') + "}\nviews:\n";
    for (int i = 0; i < 10'000; ++i) yaml += "  - {name: v" + std::to_string(i) + "}\n";
    const auto read = suite::readSuite(yaml, kKnown);
    QVERIFY(!read);
    QVERIFY2(read.error().startsWith(QStringLiteral("Line 6713, column 5: ")), qPrintable(read.error()));
  }
  void aListThatRefersToItselfAndOneThatIsHugeAreRefused() {
    QVERIFY(!suite::readSuite("views: &a\n  - *a\n", kKnown));
    QVERIFY(!suite::readSuite(std::string(std::size_t(100'000), '['), kKnown));
    QVERIFY(!suite::readSuite(std::string(suite::kMostSuiteBytes + 1, ' '), kKnown));
  }
};

}  // namespace test_read_suite

MAPWRIGHT_TEST(test_read_suite, ReadSuiteTest, Core)
#include "test_read_suite.moc"
