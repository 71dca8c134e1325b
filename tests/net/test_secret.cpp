// A secret is told to its own origin and to nobody else.
#include <QtTest>

#include "net/secret.h"
#include "test_program.h"

namespace test_secret {

using mapwright::net::Secret;

class TestSecret : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void goesToItsOwnOriginOnly_data() {
    QTest::addColumn<QString>("origin");
    QTest::addColumn<QString>("asked");
    QTest::addColumn<bool>("told");
    const auto row = [](const char* origin, const char* asked, bool told) {
      QTest::addRow("%s for %s", origin, asked)
          << QString::fromLatin1(origin) << QString::fromLatin1(asked) << told;
    };
    row("http://h:8090", "http://h:8090/maps/?x=1", true);
    row("http://h:8090/prefix", "http://H:8090/other", true);
    row("http://h", "http://h:80/", true);
    row("https://h", "https://h:443/", true);
    row("http://h:8090", "ws://h:8090/ws/v2/topics", true);
    row("https://h:8090", "wss://h:8090/ws/v2/topics", true);
    row("ws://h:8090", "http://h:8090/", true);
    row("http://h:8090", "http://h:8091/", false);
    row("http://h:8090", "http://h/", false);
    row("http://h:8090", "http://g:8090/", false);
    row("http://h:8090", "http://h.evil:8090/", false);
    row("http://h:8090", "https://h:8090/", false);
    row("https://h:8090", "http://h:8090/", false);
    row("https://h:8090", "ws://h:8090/", false);
    row("http://h:8090", "wss://h:8090/", false);
    row("http://h:8090", "http://h:8090@g/", false);
    row("http://h:8090", "", false);
    row("http://h:8090", "/maps/", false);
    row("", "http://h:8090", false);
    row("", "", false);
    row("ftp://h", "http://h", false);
  }
  void goesToItsOwnOriginOnly() {
    QFETCH(QString, origin);
    QFETCH(QString, asked);
    QFETCH(bool, told);
    const Secret secret(QUrl(origin), "hush");
    QCOMPARE(secret.forUrl(QUrl(asked)), told ? QByteArray("hush") : QByteArray());
  }

  void cannotBreakOutOfItsHeader() {
    const QUrl url(QStringLiteral("http://h"));
    QCOMPARE(Secret(url, "hu\r\nHost: evil\nsh").forUrl(url), QByteArray("huHost: evilsh"));
  }
};

}  // namespace test_secret

MAPWRIGHT_TEST(test_secret, TestSecret, Core)
#include "test_secret.moc"
