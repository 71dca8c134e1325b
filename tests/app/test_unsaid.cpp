// A robot that repeats what it was told: neither the secret nor what proves it (rosauth's MAC) is in anything
// that the program says or writes. And its own files are for nobody else.
#include <sys/stat.h>

#include <QDirIterator>
#include <QTest>
#include <QTimer>

#include "../robot/scripted_bridge.h"
#include "../robot/scripted_robot.h"
#include "program.h"
#include "test_program.h"

namespace test_unsaid {

using namespace mapwright;
using robot::testing::ScriptedBridge;
using robot::testing::ScriptedRobot;

namespace {

const QByteArray kSecret = "hush/\"hush\" <7>";

QList<QByteArray> formsOfSecret() {
  return {kSecret,         kSecret.toBase64(),      kSecret.toPercentEncoding(),
          kSecret.toHex(), "hush/\\\"hush\\\" <7>", "hush\\/\\\"hush\\\" <7>"};
}

}  // namespace

class UnsaidTest : public QObject {
  Q_OBJECT
  tests::Program program_;

  tests::EndedBytes run(const QString& line) const {
    return program_.runForBytes(
        line.split(QLatin1Char(' ')),
        {.environment = {{QStringLiteral("MAPWRIGHT_SECRET"), QString::fromUtf8(kSecret)}}});
  }
  /// All that it wrote: its folder, without the pictures of this test.
  QByteArray written() const {
    QByteArray all;
    QDirIterator files(program_.folder(), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (files.hasNext()) {
      QFile file(files.next());
      if (file.open(QIODevice::ReadOnly)) all += file.fileName().toUtf8() + '\n' + file.readAll() + '\n';
    }
    return all;
  }

 private Q_SLOTS:
  void neitherTheSecretNorItsMacIsRepeated_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<bool>("ros");
    const auto row = [](const char* name, const char* line, bool ros) {
      QTest::newRow(name) << QString::fromLatin1(line) << ros;
    };
    row("a list", "maps list --robot ROBOT", false);
    row("a list as JSON", "maps list --json --robot ROBOT", false);
    row("a map", "maps show 1 --robot ROBOT --timeout 4", false);
    row("a change", "maps rename 1 New --robot ROBOT --timeout 4", false);
    row("a picture", "snapshot --robot ROBOT --timeout 4 --report r.json -o p.png", false);
    row("a whole map", "snapshot --mode whole --map 1 --robot ROBOT --timeout 4 --report r.json -o p.png",
        false);
    row("a report on the standard output", "snapshot --robot ROBOT --timeout 4 --json -o p.png", false);
    row("a recording", "record --seconds 2 --robot ROBOT -o r.mcap", false);
    row("bags", "bags list --robot ROBOT", false);
    row("bags that are recorded", "bags record --robot ROBOT", false);
    row("overlays", "overlays get --map 1 -o o.geojson --robot ROBOT", false);
    row("topics", "topics echo /a --count 1 --timeout 2 --robot ROBOT", false);
    row("ROS: a list", "maps list --robot BRIDGE --timeout 4", true);
    row("ROS: a picture", "snapshot --robot BRIDGE --timeout 4 --report r.json -o p.png", true);
    row("ROS: a map", "snapshot --mode whole --robot BRIDGE --timeout 4 --report r.json -o p.png", true);
    row("ROS: a recording", "record --seconds 2 --robot BRIDGE -o r.mcap", true);
    row("ROS: waypoints", "waypoints list --robot BRIDGE --timeout 4", true);
    row("ROS: topics", "topics echo /a --count 1 --timeout 2 --robot BRIDGE", true);
  }
  void neitherTheSecretNorItsMacIsRepeated() {
    QFETCH(QString, line);
    QFETCH(bool, ros);
    const QByteArray repeated = "not with " + formsOfSecret().join(" or ");
    const QByteArray said =
        QJsonDocument(QJsonObject{{QStringLiteral("detail"), QString::fromUtf8(repeated)}})
            .toJson(QJsonDocument::Compact);
    ScriptedRobot robot;
    robot.serve("/device/info", R"({"caps":{"supportsEnableTopicList":true}})");
    for (const char* path : {"/maps/", "/mappings/", "/maps/1", "/maps/1.png", "/bags/", "/recording/",
                             "/chassis/current-map", "/ros/map/overlays"})
      robot.answers[path] = ScriptedRobot::reply(500, said, "Content-Type: application/json\r\n");
    robot.greeting = QByteArray(said).replace("detail", "error");
    ScriptedBridge bridge;
    bridge.advertise(QStringLiteral("/a"), QStringLiteral("std_msgs/String"));
    bridge.advertise(QStringLiteral("/map"), QStringLiteral("nav_msgs/OccupancyGrid"));
    QByteArray mac;
    QTimer repeat;
    const auto look = [&] {
      for (const QJsonObject& asked : std::as_const(bridge.asked)) {
        if (asked[QLatin1String("op")] == QLatin1String("auth"))
          mac = asked[QLatin1String("mac")].toString().toLatin1();
      }
    };
    connect(&repeat, &QTimer::timeout, &repeat, [&] {
      look();
      const QJsonObject status{{QStringLiteral("op"), QStringLiteral("status")},
                               {QStringLiteral("level"), QStringLiteral("error")},
                               {QStringLiteral("msg"), QString::fromUtf8(repeated + ' ' + mac)}};
      for (QWebSocket* peer : std::as_const(bridge.peers))
        peer->sendTextMessage(QString::fromUtf8(QJsonDocument(status).toJson(QJsonDocument::Compact)));
    });
    repeat.start(200);
    line.replace(QStringLiteral("ROBOT"), QStringLiteral("axbot+") + robot.url().toString())
        .replace(QStringLiteral("BRIDGE"), QStringLiteral("ros+") + bridge.url().toString());
    const tests::EndedBytes ended = run(line);
    look();
    const QByteArray all = ended.out + ended.err + written();
    // A recorder may ask for so much that the bridge has forgotten how it began.
    if (ros && !line.startsWith(QLatin1String("record")))
      QVERIFY2(mac.size() == 128, "it proves that it knows the secret");
    QVERIFY2(mac.isEmpty() || !all.contains(mac), ended.err.constData());
    for (const QByteArray& form : formsOfSecret()) {
      const auto at = all.indexOf(form);
      QVERIFY2(at < 0, all.mid(std::max<qsizetype>(0, at - 200), 400).constData());
    }
  }

  void itsFilesAreForNobodyElse() {
    // As it stood there before, and as the umask would have it.
    const QString data = program_.path("data/mapwright");
    QVERIFY(QDir().mkpath(data) && QDir().mkpath(program_.path("config/mapwright")));
    QFile before(data + QStringLiteral("/overlays.sqlite"));
    QVERIFY(before.open(QIODevice::WriteOnly));
    before.close();
    QVERIFY(::chmod(QFile::encodeName(data).constData(), 0755) == 0);
    QVERIFY(::chmod(QFile::encodeName(before.fileName()).constData(), 0644) == 0);
    ScriptedRobot robot;
    robot.serve("/device/info", "{}");
    robot.serve("/maps/", R"([{"id":1,"uid":"u","map_name":"Hall"}])");
    robot.serve("/mappings/", "[]");
    robot.serve("/chassis/current-map", R"({"id":1})");
    robot.serve("/maps/1",
                "{\"id\":1,\"uid\":\"u\",\"map_name\":\"Hall\",\"overlays\":\"{\\\"type\\\":"
                "\\\"FeatureCollection\\\"}\"}");
    const tests::EndedBytes ended =
        run(QStringLiteral("overlays get --map 1 -o o.geojson --robot axbot+") + robot.url().toString());
    QVERIFY2(ended.code == 0, ended.err.constData());
    int files = 0;
    for (const char* folder : {"data", "config", "cache"}) {
      QDirIterator all(program_.path(folder) + QStringLiteral("/mapwright"),
                       QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDirIterator::Subdirectories);
      struct stat about {};
      const QByteArray own = QFile::encodeName(program_.path(folder) + QStringLiteral("/mapwright"));
      if (::stat(own.constData(), &about) == 0) QVERIFY2((about.st_mode & 0077) == 0, own.constData());
      while (all.hasNext()) {
        const QByteArray path = QFile::encodeName(all.next());
        QVERIFY(::stat(path.constData(), &about) == 0);
        if (path.contains("sqlite")) QVERIFY2((about.st_mode & 0777) == 0600, path.constData());
        ++files;
      }
    }
    QVERIFY(files > 0);
  }
};

}  // namespace test_unsaid

MAPWRIGHT_TEST(test_unsaid, UnsaidTest, Widgets)
#include "test_unsaid.moc"
