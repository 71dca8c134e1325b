#include <QtTest>

#include "net/plain_sentences.h"
#include "test_program.h"

namespace test_plain_sentences {

using namespace mapwright::net;

class TestPlainSentences : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void errorBodiesBecomeShortText_data() {
    QTest::addColumn<QByteArray>("body");
    QTest::addColumn<QByteArray>("content_type");
    QTest::addColumn<QString>("text");
    const auto row = [](const char* name, const QByteArray& body, const char* type, const char* text) {
      QTest::addRow("%s", name) << body << QByteArray(type) << QString::fromUtf8(text);
    };
    row("detail", "{\"detail\": \"No such map\"}", "application/json", "No such map");
    row("message", "{\"message\": \"Busy\\nnow\"}", "application/json", "Busy now");
    row("error", "{\"error\": \"Bag is damaged\"}", "", "Bag is damaged");
    row("detail first", "{\"error\": \"b\", \"detail\": \"a\"}", "", "a");
    row("not a text", "{\"detail\": [1, 2]}", "application/json", "");
    row("skips what is not a text", "{\"detail\": {\"a\": 1}, \"error\": \"b\"}", "application/json", "b");
    row("broken JSON", "{\"detail\": \"No such", "application/json", "");
    row("plain", "  out of\tmemory\r\n", "text/plain", "out of memory");
    row("page",
        "<html><head><title>x</title><style>b{}</style></head><body><h1>502</h1>Bad&nbsp;gateway &amp; "
        "more</body>",
        "text/html", "502 Bad gateway & more");
    row("script", "<script>alert('x')</script>gone", "text/html", "gone");
    row("unclosed script", "gone<script>alert('x')", "text/html", "gone");
    row("markup in JSON", "{\"detail\": \"<b onclick='x'>No</b> map\"}", "application/json", "No map");
    row("escaped markup", "&lt;b&gt;No&lt;/b&gt; map", "text/html", "‹b›No‹/b› map");
    row("page that does not say so", "<!DOCTYPE html><html><body><x-y>502</x-y> Bad</body></html>", "",
        "502 Bad");
    row("no markup", "can't parse <class 'str'> of <filename>, a<b and c>d", "text/plain",
        "can't parse ‹class 'str'› of ‹filename›, a‹b and c›d");
    row("no markup in JSON", "{\"detail\": \"no <class 'int'> here\"}", "application/json",
        "no ‹class 'int'› here");
    row("no markup in a page", "<p>no &lt;a&gt; <class 'int'></p>", "text/html", "no ‹a› ‹class 'int'›");
    row("comparison", "{\"detail\": \"width < 5 > 3\"}", "application/json", "width ‹ 5 › 3");
    row("picture", QByteArray("\x89PNG\0\0", 6), "image/png", "");
    row("binary", QByteArray("a\0b", 3), "", "");
    row("nothing", "", "", "");
  }
  void errorBodiesBecomeShortText() {
    QFETCH(QByteArray, body);
    QFETCH(QByteArray, content_type);
    QFETCH(QString, text);
    QCOMPARE(errorText(body, content_type), text);
  }

  void wordsKeepWhatStandsBetweenAngleBrackets() {
    QCOMPARE(plainText(QStringLiteral("can't parse <class 'str'> of <b>\n")),
             QStringLiteral("can't parse ‹class 'str'› of ‹b›"));
  }

  void sentencesAreBounded() {
    const QByteArray endless(1 << 20, 'x');
    QCOMPARE(errorText(endless, "text/plain").size(), kMaxSentence);
    QByteArray tags;
    for (int i = 0; i < 100'000; ++i) {
      tags += "<script ";
    }
    QVERIFY(!plainText(QString::fromLatin1(tags)).contains(u'<'));
  }

  void originsAreComparedWithTheirDefaultPorts() {
    const auto same = [](const char* a, const char* b) {
      return sameOrigin(QUrl(QLatin1String(a)), QUrl(QLatin1String(b)));
    };
    QVERIFY(same("http://robot/a", "http://robot:80/b?c"));
    QVERIFY(same("http://ROBOT/a", "http://robot/"));
    QVERIFY(same("https://robot", "https://robot:443"));
    QVERIFY(!same("http://robot:8090/", "http://robot/"));
    QVERIFY(!same("http://robot/", "https://robot/"));
    QVERIFY(!same("http://robot/", "http://robot.evil/"));
    QVERIFY(!same("http://robot/", "http://user@evil/robot/"));
  }

  void headerValuesStayOnTheirLine() {
    QCOMPARE(headerSafe("a\r\nHost: b\x01\x7f\xc3"), QByteArray("aHost: b\xc3"));
  }
};

}  // namespace test_plain_sentences

MAPWRIGHT_TEST(test_plain_sentences, TestPlainSentences, Core)
#include "test_plain_sentences.moc"
