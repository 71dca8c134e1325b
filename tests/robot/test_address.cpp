#include <QTest>

#include "robot/address.h"

using namespace mapwright::robot;

class AddressTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void addressesAreNormalised_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("text");
    const auto row = [](const char* typed, const char* text) {
      QTest::newRow(typed) << QString::fromLatin1(typed) << QString::fromLatin1(text);
    };
    row("axbot+http://192.0.2.7", "axbot+http://192.0.2.7:8090");
    row("axbot+https://robot.example:443/", "axbot+https://robot.example:443");
    row("192.0.2.7", "axbot+http://192.0.2.7:8090");
    row("robot-3:9000", "axbot+http://robot-3:9000");
    row(" http://[::1]:8090 ", "axbot+http://[::1]:8090");
    row("axbot+http://proxy/robots/7/", "axbot+http://proxy:8090/robots/7");
    row("demo:", "demo:");
    row("demo:?scene=warehouse", "demo:?scene=warehouse");
  }
  void addressesAreNormalised() {
    QFETCH(QString, typed);
    QFETCH(QString, text);
    const auto address = parseAddress(typed);
    QVERIFY2(address.has_value(), qPrintable(address ? QString() : address.error()));
    QCOMPARE(address->text, text);
  }

  void badAddressesAreRefusedWithASentence_data() {
    QTest::addColumn<QString>("typed");
    for (const char* typed :
         {"", "   ", "axbot+http://", "ftp://host", "axbot+http://user:pw@host", "http://host:0",
          "aimdk+http://host", "file:map.yaml", "http://host?x=1", "http://a b", "http://host:99999"}) {
      QTest::newRow(typed) << QString::fromLatin1(typed);
    }
  }
  void badAddressesAreRefusedWithASentence() {
    QFETCH(QString, typed);
    const auto address = parseAddress(typed);
    QVERIFY(!address.has_value());
    QVERIFY(address.error().endsWith(QLatin1Char('.')));
    QVERIFY(!address.error().contains(QStringLiteral("pw")));
  }
};

QTEST_GUILESS_MAIN(AddressTest)
#include "test_address.moc"
