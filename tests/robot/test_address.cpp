#include <QDir>
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
    row("aimdk+http://192.0.2.9", "aimdk+http://192.0.2.9:50807");
    row("AIMDK+https://agi.example:443/", "aimdk+https://agi.example:443");
    row("aimdk+http://h?tf=ws://h:9090", "aimdk+http://h:50807?tf=ws://h:9090");
    row("file:/maps/../maps/a.yaml", "file:/maps/a.yaml");
    row("file:///maps/a%20b.yaml", "file:/maps/a b.yaml");
    row("/maps/a.pgm", "file:/maps/a.pgm");
    row("/maps/a.png?resolution=0.05&origin=-10,-7.5,0.1",
        "file:/maps/a.png?resolution=0.05&origin=-10,-7.5,0.1");
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

  void aFileAddressHoldsItsPlace() {
    const auto address = parseAddress(QStringLiteral("file:/maps/a.png?resolution=0.02&origin=-1,2.5,0.5"));
    QVERIFY(address && address->backend == Backend::File);
    QCOMPARE(address->path, QStringLiteral("/maps/a.png"));
    QCOMPARE(*address->resolution_m, 0.02);
    QCOMPARE(*address->origin, (mapwright::geometry::Pose2{-1, 2.5, 0.5}));
  }

  void barePathsAreFilesAndHostsAreRobots() {
    QCOMPARE(parseAddress(QStringLiteral("maps/office.yaml"))->backend, Backend::File);
    QCOMPARE(parseAddress(QStringLiteral("Office Map.PGM"))->backend, Backend::File);
    QCOMPARE(parseAddress(QDir::tempPath())->backend, Backend::File);
    QCOMPARE(parseAddress(QStringLiteral("robot-3"))->backend, Backend::Axbot);
    QCOMPARE(parseAddress(QStringLiteral("http://host/map.png"))->backend, Backend::Axbot);
    const auto agibot = parseAddress(QStringLiteral("aimdk+http://h?tf=ws://h:9090"));
    QCOMPARE(agibot->backend, Backend::Aimdk);
    QCOMPARE(agibot->tf, QUrl(QStringLiteral("ws://h:9090")));
    QVERIFY(!agibot->url.hasQuery());
  }

  void badAddressesAreRefusedWithASentence_data() {
    QTest::addColumn<QString>("typed");
    for (const char* typed : {"",
                              "   ",
                              "axbot+http://",
                              "ftp://host",
                              "axbot+http://user:pw@host",
                              "http://host:0",
                              "kabam+ws://host",
                              "rep130+ws://host",
                              "aimdk+http://",
                              "aimdk+http://host?tf=http://x",
                              "aimdk+http://u:pw@h",
                              "aimdk+http://host?other=1",
                              "file:",
                              "file:/a.png?resolution=0",
                              "file:/a.png?resolution=nan",
                              "file:/a.png?origin=1",
                              "file:/a.png?origin=1,x",
                              "file:/a.png?scale=2",
                              "http://host?x=1",
                              "http://a b",
                              "http://host:99999"}) {
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
