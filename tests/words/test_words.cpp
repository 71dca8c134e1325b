#include <random>

#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "test_program.h"
#include "words/decimal.h"
#include "words/listed.h"
#include "words/qt_plain.h"
#include "words/qt_versions.h"
#include "words/shortened.h"
#include "words/shortest.h"

namespace test_words {

using namespace mapwright;

class WordsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void coordinatesHaveNoExponent() {
    std::mt19937_64 dice(5);
    std::uniform_real_distribution<double> digits(-1, 1);
    for (int round = 0; round < 20'000; ++round) {
      double number = digits(dice) * std::pow(10, int(dice() % 15));
      if (round % 3 == 0) number = std::round(number);
      if (round % 3 == 1) number = std::round(number * 1000) / 1000;
      const std::string written = words::shortest(number);
      QCOMPARE(std::strtod(written.c_str(), nullptr), number);
      if (number == 0 || std::abs(number) >= 1e-6)
        QVERIFY2(written.find('e') == std::string::npos, written.c_str());
      const QString shown = words::decimal(number);
      QVERIFY2(!shown.contains(QLatin1Char('e')) &&
                   std::abs(shown.toDouble() - number) <= 0.51e-6 + std::abs(number) * 1e-15,
               qPrintable(shown));
      QVERIFY2(!shown.endsWith(QLatin1Char('.')), qPrintable(shown));
    }
    QCOMPARE(words::shortest(400000), std::string("400000"));
    QCOMPARE(words::shortest(1e300), std::string("1e+300"));
    QCOMPARE(words::decimal(5572094.155411), QStringLiteral("5572094.155411"));
    QCOMPARE(words::decimal(0.05), QStringLiteral("0.05"));
    QCOMPARE(words::decimal(-1e-9), QStringLiteral("0"));
    QCOMPARE(words::decimal(1200), QStringLiteral("1200"));
  }

  void nothingIsLeftThatATerminalObeys() {
    // Every character of the first 0x3000: what is obeyed, and only that, is gone.
    for (char32_t code = 0; code < 0x3000; ++code) {
      const QString one = QStringLiteral("a") + QString::fromUcs4(&code, 1) + QStringLiteral("b");
      const bool control = code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x2028 || code == 0x2029;
      const bool direction = (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
      const QString line = words::plainLine(one);
      QCOMPARE(line, control ? QStringLiteral("a b") : direction ? QStringLiteral("ab") : one);
      const bool layout = code == '\n' || code == '\t';
      QCOMPARE(words::plainText(one), layout ? one : line);
    }
  }

  void whatIsNoUtf8IsShownAsThat_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("text");
    const auto row = [](const char* name, QByteArray bytes, const char* text) {
      QTest::newRow(name) << bytes << QString::fromUtf8(text);
    };
    row("fine",
        "Gr\xc3\xb6\xc3\x9f"
        "e \xf0\x9f\x8f\xad",
        "Größe 🏭");
    row("lone lead", "a\xc3", "a\xef\xbf\xbd");
    row("lone tail", "\x9b[31m", "\xef\xbf\xbd[31m");
    row("overlong escape", "\xc0\x9b", "\xef\xbf\xbd\xef\xbf\xbd");
    row("overlong in three", "\xe0\x82\x9b", "\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd");
    row("surrogate", "\xed\xa0\x80", "\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd");
    row("beyond", "\xf5\x80\x80\x80", "\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd");
    row("cut off", "\xf0\x9f\x8f", "\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd");
    row("nothing", "", "");
  }
  void whatIsNoUtf8IsShownAsThat() {
    QFETCH(QByteArray, bytes);
    QTEST(QString::fromStdString(words::plainLine(bytes.toStdString())), "text");
    QTEST(QString::fromStdString(words::plainText(bytes.toStdString())), "text");
  }

  void jsonLosesNothingAndObeysNothing() {
    QString all;
    for (char32_t code = 1; code < 0x3000; ++code) all += QString::fromUcs4(&code, 1);
    const QJsonObject object{{all, all}};
    for (const auto format : {QJsonDocument::Indented, QJsonDocument::Compact}) {
      const QByteArray json = words::escapedJson(QJsonDocument(object).toJson(format));
      QCOMPARE(QJsonDocument::fromJson(json).object(), object);
      const QString shown = QString::fromUtf8(json);
      QCOMPARE(words::plainText(shown), shown);
    }
  }

  void sentencesEndOnce_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("sentence");
    const auto row = [](const char* words, const char* sentence) {
      QTest::newRow(words) << QString::fromUtf8(words) << QString::fromUtf8(sentence);
    };
    row("no answer", "No answer.");
    row("No answer.", "No answer.");
    row("no answer..", "No answer.");
    row("No answer. ", "No answer.");
    row("no answer!", "No answer!");
    row("really?", "Really?");
    row("and so on...", "And so on...");
    row("and so on…", "And so on…");
    row("  no answer\n", "No answer.");
    row("500", "500.");
    row("größe", "Größe.");
    row("maps/one cannot be read", "maps/one cannot be read.");
    row("/tmp/one is full", "/tmp/one is full.");
    row(" ", "");
    row("", "");
    row("..", "");
    row("没有应答", "没有应答。");
    row("急停已按下，始于 07:36:29", "急停已按下，始于 07:36:29。");
    row("Nothing in 会议室 3", "Nothing in 会议室 3.");
    row("没有应答。", "没有应答。");
    row("真的？", "真的？");
    row("There is no map 一楼", "There is no map 一楼.");
  }
  void sentencesEndOnce() {
    QFETCH(QString, words);
    QTEST(words::asSentence(words), "sentence");
  }

  void aReasonFollowsItsColon_data() {
    QTest::addColumn<QString>("what");
    QTest::addColumn<QString>("reason");
    QTest::addColumn<QString>("sentence");
    const auto row = [](const char* name, const char* what, const char* reason, const char* sentence) {
      QTest::newRow(name) << QString::fromUtf8(what) << QString::fromUtf8(reason)
                          << QString::fromUtf8(sentence);
    };
    row("plain", "It cannot be loaded", "no answer", "It cannot be loaded: no answer.");
    row("ended", "It cannot be loaded", "no answer.", "It cannot be loaded: no answer.");
    row("ended twice", "It cannot be loaded", "no answer..", "It cannot be loaded: no answer.");
    row("colon given", "It cannot be loaded: ", "no answer", "It cannot be loaded: no answer.");
    row("no reason", "It cannot be loaded", "", "It cannot be loaded.");
    row("only a stop", "It cannot be loaded:", " . ", "It cannot be loaded.");
    row("a question", "It asks", "who?", "It asks: who?");
  }
  void aReasonFollowsItsColon() {
    QFETCH(QString, what);
    QFETCH(QString, reason);
    QTEST(QString::fromStdString(words::because(what.toStdString(), reason.toStdString())), "sentence");
  }

  // It may end with a name.
  void whereChineseIsSpokenASentenceWithChineseIsOne() {
    QCOMPARE(words::because("无法读取 a.png", "它不是 PNG", true),
             std::string("无法读取 a.png：它不是 PNG。"));
    QCOMPARE(words::asSentence("it answers 404", true), std::string("It answers 404."));
  }

  void sentencesFollowEachOther() {
    QCOMPARE(words::paragraph({QStringLiteral("It is lost."), QString(), QStringLiteral("It comes back.")}),
             QStringLiteral("It is lost. It comes back."));
    QCOMPARE(words::paragraph({QStringLiteral("已丢失。"), QStringLiteral("会回来。")}),
             QStringLiteral("已丢失。会回来。"));
    QCOMPARE(words::paragraph({}), QString());
  }

  void anAddressWithAColonGetsNoSecondOne() {
    QCOMPARE(words::about(QStringLiteral("demo:"), QStringLiteral("No map.")),
             QStringLiteral("demo: No map."));
    QCOMPARE(words::about(QStringLiteral("a.yaml"), QStringLiteral("No map.")),
             QStringLiteral("a.yaml: No map."));
  }

  // With Qt 6.4 and 6.8.
  void timesInUtcEndWithZ() {
    const auto text = [](const QDateTime& time) { return time.toString(Qt::ISODateWithMs); };
    QCOMPARE(text(words::utcOfMs(-1)), QStringLiteral("1969-12-31T23:59:59.999Z"));
    const QDateTime shown(QDate(2026, 3, 29), QTime(12, 30), QTimeZone(2 * 3600));
    QCOMPARE(text(words::takenAsUtc(shown)), QStringLiteral("2026-03-29T12:30:00.000Z"));
  }

  void whatIsCutOffShows() {
    QCOMPARE(words::shortened(QStringLiteral("Hall"), 4), QStringLiteral("Hall"));
    QCOMPARE(words::shortened(QStringLiteral("Halle"), 4), QStringLiteral("Hal…"));
    // No half of a letter that takes two units.
    QCOMPARE(words::shortened(QStringLiteral("Ha\U0001F3EDle"), 4), QStringLiteral("Ha…"));
  }
};

}  // namespace test_words

MAPWRIGHT_TEST(test_words, WordsTest, Core)
#include "test_words.moc"
