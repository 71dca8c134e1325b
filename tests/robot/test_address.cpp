#include <QDir>
#include <QTest>

#include "robot/aimdk/aimdk_address.h"
#include "robot/axbot/axbot_address.h"
#include "robot/files/file_address.h"
#include "test_program.h"

namespace test_address {

using namespace mapwright::robot;

namespace {

Addresses known() {
  const auto demo = [](const QString& rest) -> ParsedAddress {
    Address address;
    address.text = QStringLiteral("demo:") + rest;
    return address;
  };
  return Addresses({axbot::addressScheme(),
                    aimdk::addressScheme(),
                    {QStringLiteral("demo:"), QStringLiteral("demo:"), demo},
                    files::addressScheme()});
}

ParsedAddress parse(const QString& typed) { return known().parse(typed); }

}  // namespace

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
    row("aimdk+http://h?tf=ws://h", "aimdk+http://h:50807?tf=ws://h:9090");
    row("aimdk+https://h?tf=wss://other:443/bridge/", "aimdk+https://h:50807?tf=wss://other:443/bridge");
    row("file:/maps/../maps/a.yaml", "file:/maps/a.yaml");
    row("file:///maps/a%20b.yaml", "file:/maps/a b.yaml");
    row("/maps/a.pgm", "file:/maps/a.pgm");
    row("/maps/a.png?resolution=0.05&origin=-10,-7.5,0.1",
        "file:/maps/a.png?resolution=0.05&origin=-10,-7.5,0.1");
    row("/bags/a.mcap?ns=/fleet/robot1", "file:/bags/a.mcap?ns=/fleet/robot1");
    row("demo:", "demo:");
    row("demo:?scene=warehouse", "demo:?scene=warehouse");
  }
  void addressesAreNormalised() {
    QFETCH(QString, typed);
    QFETCH(QString, text);
    const auto address = parse(typed);
    QVERIFY2(address.has_value(), qPrintable(address ? QString() : address.error()));
    QCOMPARE(address->text, text);
  }

  void aFileAddressHoldsItsPlace() {
    QCOMPARE(files::namespaceOf(*parse(QStringLiteral("file:/a.mcap?ns=/robot1/"))), std::string("/robot1"));
    QCOMPARE(files::namespaceOf(*parse(QStringLiteral("file:/a.mcap"))), std::string());
    const auto address = parse(QStringLiteral("file:/maps/a.png?resolution=0.02&origin=-1,2.5,0.5"));
    QVERIFY(address.has_value());
    QCOMPARE(address->scheme, QStringLiteral("file:"));
    QCOMPARE(address->path, QStringLiteral("/maps/a.png"));
    const files::PicturePlace place = files::placeOf(*address);
    QCOMPARE(*place.resolution_m, 0.02);
    QCOMPARE(*place.origin, (mapwright::geometry::Pose2{-1, 2.5, 0.5}));
    QVERIFY(hostOf(*address).isEmpty());
    QCOMPARE(localFiles(*address, {}, "/maps/b.png"),
             (std::vector<std::string>{"/maps/a.png", "/maps/b.png"}));
  }

  void barePathsAreFilesAndHostsAreRobots() {
    QCOMPARE(parse(QStringLiteral("maps/office.yaml"))->scheme, QStringLiteral("file:"));
    QCOMPARE(parse(QStringLiteral("Office Map.PGM"))->scheme, QStringLiteral("file:"));
    QCOMPARE(parse(QDir::tempPath())->scheme, QStringLiteral("file:"));
    QCOMPARE(parse(QStringLiteral("robot-3"))->scheme, QStringLiteral("axbot+"));
    // None of these is there: a name that no host can have is a missing file, not an unknown host.
    for (const char* missing : {"maps/office.jpg", "office.jpeg", "maps/office.tif", "floor 1.json"})
      QCOMPARE(parse(QLatin1String(missing))->scheme, QStringLiteral("file:"));
    for (const char* host : {"robot.local", "robot.local/api", "10.0.0.7", "robot:8090/x.y"})
      QCOMPARE(parse(QLatin1String(host))->scheme, QStringLiteral("axbot+"));
    QCOMPARE(parse(QStringLiteral("http://host/map.png"))->scheme, QStringLiteral("axbot+"));
    const auto agibot = parse(QStringLiteral("aimdk+http://h?tf=ws://h:9090"));
    QCOMPARE(agibot->scheme, QStringLiteral("aimdk+"));
    QCOMPARE(aimdk::tfOf(*agibot), QUrl(QStringLiteral("ws://h:9090")));
    QVERIFY(!agibot->url.hasQuery());
    QCOMPARE(hostOf(*agibot), QStringLiteral("h:50807"));
    QVERIFY(localFiles(*agibot, {}, "/maps/b.png").empty());
  }

  void whatNobodyRegisteredIsRefusedByName() {
    const auto refused = parse(QStringLiteral("kabam+ws://host"));
    QVERIFY(refused.error().contains(QStringLiteral("kabam+")));
    for (const char* known : {"axbot+http", "aimdk+http", "file:", "demo:"})
      QVERIFY2(refused.error().contains(QLatin1String(known)), qPrintable(refused.error()));
    QVERIFY(!Addresses().parse(QStringLiteral("robot-3")).has_value());
  }

  void whatBeginsLikeAnAddressIsNoNameOfAMap() {
    for (const char* typed :
         {"file:office.yaml", "FILE:x", "demo:", "axbot+http://h", "kabam+ws://h", " demo:"})
      QVERIFY2(known().isAddress(QLatin1String(typed)), typed);
    for (const char* typed : {"2", "office.yaml", "Ground floor", "http", "", "a+b", "demo"})
      QVERIFY2(!known().isAddress(QLatin1String(typed)), typed);
  }

  void everyKindShowsWhatItsAddressesLookLike() {
    const QStringList examples = known().examples();
    QVERIFY(!examples.isEmpty());
    for (const QString& example : examples) QVERIFY2(known().isAddress(example), qPrintable(example));
    QVERIFY(Addresses().examples().isEmpty());
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
                              "aimdk+http://host?tf=ws://u:pw@x",
                              "aimdk+http://host?tf=ws://x%3Ftoken=1",
                              "aimdk+http://host?tf=ws://x&tf=ws://y",
                              "aimdk+http://u:pw@h",
                              "aimdk+http://host?other=1",
                              "file:",
                              "file:/a.png?resolution=0",
                              "file:/a.png?resolution=nan",
                              "file:/a.mcap?ns=robot1",
                              "file:/a.mcap?ns=/",
                              "file:/a.mcap?ns=/a b",
                              "file:/a.png?origin=1",
                              "file:/a.png?origin=1,x",
                              "file:/a.png?scale=2",
                              "file:/a.yaml?resolution=0.1",
                              "/a.YML?origin=1,2",
                              "http://host?x=1",
                              "http://a b",
                              "http://host:99999"}) {
      QTest::newRow(typed) << QString::fromLatin1(typed);
    }
  }
  void badAddressesAreRefusedWithASentence() {
    QFETCH(QString, typed);
    const auto address = parse(typed);
    QVERIFY(!address.has_value());
    QVERIFY(address.error().endsWith(QLatin1Char('.')));
    QVERIFY(!address.error().contains(QStringLiteral("pw")));
  }

  void anAddressWithAPasswordIsNamedWithoutIt_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("named");
    const auto row = [](const char* typed, const char* named) {
      QTest::newRow(typed) << QString::fromLatin1(typed) << QString::fromLatin1(named);
    };
    row("http://user:pw@192.0.2.7:8090/", "http://192.0.2.7:8090/");
    row("user:pw@192.0.2.7", "192.0.2.7");
    row("user@host", "host");
    row("axbot+http://pw@host:1", "axbot+http://host:1");
    row("AXBOT+HTTPS://u:pw@host", "AXBOT+HTTPS://host");
    row("aimdk+http://u:p@pw@h/pw@h?tf=ws://pw@robot", "aimdk+http://robot");
    row("u:pw://x/pw@host", "host");
    row("http://u:p/w#pw?pw@host", "http://host");
  }
  void anAddressWithAPasswordIsNamedWithoutIt() {
    QFETCH(QString, typed);
    QFETCH(QString, named);
    const auto address = parse(typed);
    QVERIFY(!address.has_value());
    QVERIFY2(address.error().startsWith(named + QStringLiteral(": ")), qPrintable(address.error()));
    QVERIFY(!address.error().contains(QStringLiteral("pw")));
    QVERIFY(address.error().contains(QStringLiteral("--secret-file")));
  }

  void aHostAloneDoesNotSayWhichRobotIsThere_data() {
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("port");  // 0 = none, -1 = it is no host
    const auto row = [](const char* typed, const char* name, int port) {
      QTest::newRow(typed) << QString::fromLatin1(typed) << QString::fromLatin1(name) << port;
    };
    row("192.0.2.7", "192.0.2.7", 0);
    row(" dock-3.local ", "dock-3.local", 0);
    row("dock-3.local:9090", "dock-3.local", 9090);
    row("http://192.0.2.7/", "192.0.2.7", 0);
    row("HTTPS://192.0.2.7:8443", "192.0.2.7", 8443);
    row("[fe80::1]:9090", "fe80::1", 9090);
    row("fe80::1", "fe80::1", 0);
    row("", "", -1);
    row("192.0.2.7:0", "", -1);
    row("192.0.2.7:99999", "", -1);
    row("192.0.2.7/path", "192.0.2.7", 0);
    row("dock-3:9090/robots/7/", "dock-3", 9090);
    row("192.0.2.7/path?a=b", "", -1);
    row("192.0.2.7:0/path", "", -1);
    row("http://192.0.2.7:8090/maps/?a=b#c", "192.0.2.7", 8090);
    row("http://user:pw@192.0.2.7/maps", "", -1);
    row("user:pw@192.0.2.7", "", -1);
    row("two words", "", -1);
    row("axbot+http://192.0.2.7", "", -1);
    row("kabam+ws://192.0.2.7", "", -1);
    row("/maps/office.yaml", "", -1);
    row("office.yaml", "", -1);
  }
  void aHostAloneDoesNotSayWhichRobotIsThere() {
    QFETCH(QString, typed);
    QFETCH(QString, name);
    QFETCH(int, port);
    const auto host = known().bareHost(typed);
    QCOMPARE(host.has_value(), port >= 0);
    if (!host) return;
    QCOMPARE(host->name, name);
    QCOMPARE(host->port.value_or(0), port);
  }

  void aPortThatIsNoneIsNamed_data() {
    QTest::addColumn<QString>("typed");
    for (const char* typed :
         {"192.0.2.7:99999", "192.0.2.7:0", "http://192.0.2.7:70000/", "dock-3:123456789012",
          "axbot+http://dock-3:0", "aimdk+http://[fe80::1]:65536/x", "aimdk+http://h?tf=ws://h:65536"})
      QTest::newRow(typed) << QString::fromLatin1(typed);
  }
  void aPortThatIsNoneIsNamed() {
    QFETCH(QString, typed);
    const auto address = parse(typed);
    QVERIFY(!address);
    QVERIFY2(address.error().contains(QLatin1String("from 1 to 65535")), qPrintable(address.error()));
    QVERIFY2(address.error().contains(typed.section(QLatin1Char('='), -1)), qPrintable(address.error()));
  }

  void aHostIsShownWithThePortWhereItIsNotTheUsualOne() {
    const auto shown = [](const char* typed) { return known().hostShown(QLatin1String(typed)); };
    QCOMPARE(shown("axbot+http://192.0.2.7:8090"), QStringLiteral("192.0.2.7"));
    QCOMPARE(shown("axbot+http://192.0.2.7:9000"), QStringLiteral("192.0.2.7:9000"));
    QCOMPARE(shown("aimdk+http://[fe80::1]"), QStringLiteral("[fe80::1]"));
    QCOMPARE(shown("axbot+http://proxy/robots/7"), QStringLiteral("proxy/robots/7"));
    QVERIFY(shown("file:/maps/a.yaml").isEmpty() && shown("demo:").isEmpty());
  }

  void whatABrowserShowedIsKeptForAKind() {
    const auto host = known().bareHost(QStringLiteral("https://proxy/robots/7/"));
    QVERIFY(host && host->encrypted);
    const auto typed = known().bareHost(QStringLiteral("proxy/robots/7/"));
    QVERIFY(typed && !typed->encrypted);
    QCOMPARE(typed->path, host->path);
    QCOMPARE(addressAt(axbot::addressScheme(), *host, host->encrypted),
             QStringLiteral("axbot+https://proxy:8090/robots/7"));
  }

  void anAddressIsMadeOfAKindAndAHost() {
    const AddressScheme agibot = aimdk::addressScheme();
    QCOMPARE(agibot.title, QStringLiteral("Agibot"));
    const QString usual = addressAt(agibot, {QStringLiteral("dock-3"), {}}, false);
    QCOMPARE(usual, QStringLiteral("aimdk+http://dock-3:50807"));
    QCOMPARE(parse(usual)->text, usual);
    QCOMPARE(addressAt(axbot::addressScheme(), {QStringLiteral("fe80::1"), 8443}, true),
             QStringLiteral("axbot+https://[fe80::1]:8443"));
    QCOMPARE(known().titleOf(usual), agibot.title);
  }

  void aFileMayHaveAnAtSignInItsName() {
    QCOMPARE(parse(QStringLiteral("/maps/a:b@c.png"))->path, QStringLiteral("/maps/a:b@c.png"));
    QCOMPARE(parse(QStringLiteral("file:/maps/a:b@c.png"))->path, QStringLiteral("/maps/a:b@c.png"));
  }
};

}  // namespace test_address

MAPWRIGHT_TEST(test_address, AddressTest, Core)
#include "test_address.moc"
