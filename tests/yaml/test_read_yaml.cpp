// YAML of unknown origin: whatever the text, reading ends, within bounds.
#include <random>

#include <QTest>

#include "test_program.h"
#include "yaml/read_yaml.h"

namespace test_read_yaml {

using namespace mapwright;
using Code = yaml::Broken::Code;

class ReadYamlTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aSoundTextIsReadAsYamlCppReadsIt() {
    const std::string text = "image: a.pgm\norigin: &o [0, 1.5, 0]\nagain: *o\n";
    const auto document = yaml::readYaml(text);
    QVERIFY(document);
    QVERIFY(!document->next);
    QCOMPARE(document->root["again"][1].as<double>(), 1.5);
    QCOMPARE(YAML::Dump(document->root), YAML::Dump(YAML::Load(text)));
  }

  void anEmptyTextIsNull() {
    for (const char* text : {"", "# nothing\n", "---\n", "---\n...\n---\n"}) {
      const auto document = yaml::readYaml(text);
      QVERIFY2(document, text);
      QVERIFY(document->root.IsNull());
      QVERIFY(!document->next);
    }
  }

  void whereASecondDocumentBeginsIsSaid() {
    const auto document = yaml::readYaml("a: 1\n---\n---\nb: 2\n");
    QVERIFY(document);
    QVERIFY(document->next);
    QCOMPARE(document->next->line, 3);
    QCOMPARE(document->root["a"].as<int>(), 1);
  }

  void whatBeginsNothingEndsReading() {
    for (const char* text : {"{\"views\": [{\"name\": \"a\"}]},", ",", "a: 1\n...\n,", "[a], [b]"}) {
      const auto document = yaml::readYaml(text);
      QVERIFY2(!document, text);
      QCOMPARE(document.error().code, Code::NotYaml);
      QVERIFY2(document.error().line > 0, text);
    }
    QCOMPARE(yaml::readYaml("{a: b},").error().column, 7);
  }

  void whateverTheTextReadingEnds() {
    const std::vector<std::string> pieces{"[",   "]",   "{",   "}", ",",      ":",       ": ",  "- ", "-",
                                          "? ",  "&a ", "*a ", "!", "!!",     "|",       ">",   "'",  "\"",
                                          "#",   "%",   "@",   "`", "\n",     "\n  ",    " ",   "\t", "---",
                                          "...", "a",   "1",   "~", "\n--- ", "\n...\n", "<<: "};
    std::mt19937 dice(7);
    int refused = 0;
    for (int round = 0; round < 20'000; ++round) {
      std::string text;
      for (auto n = dice() % 12; n > 0; --n) text += pieces[dice() % pieces.size()];
      const auto document = yaml::readYaml(text);
      if (!document) ++refused;
      // What is accepted is what yaml-cpp makes of the same text.
      if (document) QCOMPARE(document->root.Type(), YAML::Load(text).Type());
    }
    QVERIFY(refused > 1000 && refused < 20'000);
  }

  void aliasesCountAsWhatTheyStandFor() {
    std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
    for (int i = 1; i < 12; ++i) {
      const std::string last = "*a" + std::to_string(i - 1);
      const std::string name = "a" + std::to_string(i);
      bomb += name + ": &" + name + " [" + last;
      for (int n = 1; n < 10; ++n) bomb += ", " + last;
      bomb += "]\n";
    }
    const auto document = yaml::readYaml(bomb);
    QVERIFY(!document);
    QCOMPARE(document.error().code, Code::TooMuch);
    QCOMPARE(document.error().line, 6);
    QVERIFY(yaml::readYaml("a: &a [1, 2]\nb: *a\n", {.most_nodes = 9}));
    QVERIFY(!yaml::readYaml("a: &a [1, 2]\nb: *a\n", {.most_nodes = 8}));
  }

  void whatContainsItselfIsRefused() {
    QVERIFY(!yaml::readYaml("&a [*a]"));
    QVERIFY(!yaml::readYaml("a: &a {b: [*a]}"));
    QVERIFY(!yaml::readYaml("[*nowhere]"));
  }

  void whatIsDeepIsRefused() {
    for (const char* opening : {"[", "{a: ", "- ", "? ", "[{a: "}) {
      std::string text;
      for (int i = 0; i < 20'000; ++i) text += opening;
      QVERIFY2(!yaml::readYaml(text), opening);
    }
  }

  void whatIsLongIsRefused() {
    const auto document = yaml::readYaml(std::string(101, 'a'), {.most_bytes = 100});
    QVERIFY(!document);
    QCOMPARE(document.error().code, Code::TooLong);
  }
};

}  // namespace test_read_yaml

MAPWRIGHT_TEST(test_read_yaml, ReadYamlTest, Nothing)
#include "test_read_yaml.moc"
