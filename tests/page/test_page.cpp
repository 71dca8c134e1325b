// Reports as HTML: nothing that is handed in becomes markup, and the same calls give the same bytes.
#include <QBuffer>
#include <QCryptographicHash>
#include <QRegularExpression>
#include <QTest>
#include <QXmlStreamReader>

#include "page/page.h"
#include "test_program.h"

namespace test_page {

using namespace mapwright;

namespace {

const QString kOdd = QString::fromUtf8("<b>&\"' \U0001F916 \u05e9\u05dc\u05d5\u05dd \u202e\u2066 \x01 end");

QByteArray reportAbout(const QString& text) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  page::Page page(buffer, text);
  page.section(text);
  page.title(text);
  page.paragraph(text, page::Tone::Bad);
  page.list({text, text});
  page.facts({{text, {text, {text, page::Tone::Muted}}}});
  page.beginTable({text, text});
  page.row({text, page::figure(text)});
  page.endTable();
  page.beginColumns();
  page.picture(QByteArray(20'000, 'p'), {30, 20}, text, text);
  page.nextColumn();
  page.drawing("<svg viewBox=\"0 0 1 1\"></svg>", text);
  page.endColumns();
  page.section(text);
  page.end();
  return buffer.data();
}

/// Takes so many bytes.
class FullDevice : public QIODevice {
 public:
  explicit FullDevice(qint64 room) : room_(room) { open(WriteOnly); }

 protected:
  qint64 readData(char*, qint64) override { return -1; }
  qint64 writeData(const char*, qint64 count) override {
    room_ -= count;
    return room_ < 0 ? -1 : count;
  }

 private:
  qint64 room_;
};

}  // namespace

class PageTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void nothingHandedInBecomesMarkup() {
    const auto tags = [](QByteArray html) {
      QStringList all;
      static const QRegularExpression tag(QStringLiteral("<[^>]*>"));
      // The alternative text stands in an attribute.
      auto it = tag.globalMatch(
          QString::fromUtf8(html).remove(QRegularExpression(QStringLiteral("alt=\"[^\"]*\""))));
      while (it.hasNext()) all << it.next().captured();
      return all;
    };
    QCOMPARE(tags(reportAbout(kOdd)), tags(reportAbout(QStringLiteral("plain"))));
    const QString html = QString::fromUtf8(reportAbout(kOdd));
    QVERIFY(html.contains(QString::fromUtf8("&lt;b&gt;&amp;&quot;' \U0001F916")));
    QVERIFY(!html.contains(QChar(1)) && !html.contains(QChar(0x202e)));
  }

  /// What stands inside of the body is well-formed: every element ends, in order.
  void everyElementEnds() {
    QString body = QString::fromUtf8(reportAbout(kOdd));
    body = body.mid(body.indexOf(QLatin1String("<body>")));
    body.truncate(body.indexOf(QLatin1String("</html>")));
    body.replace(QRegularExpression(QStringLiteral("(<img [^>]*)>")), QStringLiteral("\\1/>"));
    QXmlStreamReader reader(body);
    while (!reader.atEnd()) reader.readNext();
    QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
  }

  void aPictureIsInTheFile() {
    const QByteArray html = reportAbout(QStringLiteral("x"));
    QVERIFY(html.contains("src=\"data:image/png;base64," + QByteArray(20'000, 'p').toBase64() + "\""));
    for (const char* reaching : {"http:", "https:", "url(", "<script", "<link", "@import"})
      QVERIFY2(!html.contains(reaching), reaching);
  }

  /// Its script is the only one that may run: by its checksum.
  void aSliderBringsItsOwnScriptAndNoOther() {
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    {
      page::Page page(buffer, QStringLiteral("x"), page::Scripts::Swipe);
      page.swipe("left", "right", kOdd, QStringLiteral("after"));
    }
    const QByteArray html = buffer.data();
    QCOMPARE(html.count("<script"), 1);
    const auto begin = html.indexOf("<script>") + 8;
    const QByteArray script = html.mid(begin, html.indexOf("</script>") - begin);
    const QByteArray sum = QCryptographicHash::hash(script, QCryptographicHash::Sha256).toBase64();
    QVERIFY(html.contains("script-src 'sha256-" + sum + "'\""));
    QVERIFY(html.contains(QByteArray("left").toBase64()) && html.contains(QByteArray("right").toBase64()));
    QVERIFY(html.contains("type=\"range\"") && !html.contains("<b>"));
  }

  void theSameCallsGiveTheSameBytes() { QCOMPARE(reportAbout(kOdd), reportAbout(kOdd)); }

  /// A name that is written from right to left, or that turns the direction, ends where it ends.
  void aNameKeepsItsDirectionToItself() {
    const QString name = page::named(kOdd);
    QVERIFY(name.startsWith(QChar(0x2068)) && name.endsWith(QChar(0x2069)));
    const QString inside = name.mid(1, name.size() - 2);
    for (const char16_t turning : u"\u202a\u202b\u202d\u202e\u2066\u2067\u2068\u2069")
      QVERIFY(turning == 0 || !inside.contains(QChar(turning)));
  }

  void aDeviceThatIsFullIsTold() {
    FullDevice device(5'000);
    page::Page page(device, QStringLiteral("title"));
    page.picture(QByteArray(20'000, 'p'), {1, 1}, QStringLiteral("alt"));
    QVERIFY(!page.end());
    FullDevice roomy(1'000'000);
    page::Page other(roomy, QStringLiteral("title"));
    QVERIFY(other.end());
  }
};

}  // namespace test_page

MAPWRIGHT_TEST(test_page, PageTest, Core)
#include "test_page.moc"
