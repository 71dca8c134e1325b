// `mapwright bags report`: a moment of a recording as one HTML file.
#include <algorithm>
#include <cmath>
#include <sched.h>
#include <set>

#include <QJsonArray>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTcpServer>
#include <QTest>

#include "program.h"
#include "recording/append_file.h"
#include "recording/mcap_writer.h"
#include "simulator/simulator.h"
#include "test_program.h"

namespace test_bag_report {

using namespace mapwright;

namespace {

constexpr std::int64_t kStartNs = 1'717'405'200'000'000'000;
const std::string kOdd = "<b>Hall</b> \xf0\x9f\xa4\x96 \xd7\xa9\xd7\x9c\xd7\x95\xd7\x9d";

QString at(double after_s) { return QString::number(1'717'405'200 + after_s, 'f', 3); }

struct Drive {
  double y_m = 1;
  double stops_s = 40;  // where it stands from then on
  bool poses = true;
  bool alerted = false;  // from the beginning
  bool flaps = false;    // a stop and an alert, three times
};

}  // namespace

class BagReportTest : public QObject {
  Q_OBJECT
  tests::Program program_;

  /// A minute: it drives towards a virtual wall and stops half a metre before it.
  QString recording(const char* name, const Drive& drive) const {
    const QString path = program_.path(name);
    auto target = recording::appendFile(path.toStdString(), recording::Existing::Replace);
    const auto writer = recording::McapWriter::create(std::move(*target), {});
    const auto say = [&](double after_s, const char* topic, const std::string& rest) {
      recording::Channel channel;
      channel.topic = topic;
      channel.message_encoding = "json";
      std::string text = "{'topic':'" + channel.topic + "'," + rest + "}";
      std::replace(text.begin(), text.end(), '\'', '"');
      const std::int64_t at_ns = kStartNs + std::llround(after_s * 1e9);
      (void)(*writer)->write(*(*writer)->addChannel(channel), {at_ns, at_ns, 0},
                             {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    };
    say(0, "/map/info",
        "'name':'" + kOdd +
            "','uid':'u1','map_version':3,'overlays':{'type':'FeatureCollection','features':[" +
            "{'type':'Feature','geometry':{'type':'LineString','coordinates':[[2.5,-5],[2.5,5]]}," +
            "'properties':{'lineType':'2','name':'" + kOdd + "'}}]}");
    say(0.1, "/robot_model", "'footprint':[[0.3,0.25],[-0.3,0.25],[-0.3,-0.25],[0.3,-0.25]],'width':0.5");
    const std::string y = std::to_string(drive.y_m);
    say(0.2, "/path", "'positions':[[0," + y + "],[10," + y + "]]");
    say(0.3, "/planning_state", "'move_state':'moving','action_type':'standard','remaining_distance':10");
    for (int i = 3; i < 600; ++i) {
      const double now_s = i * 0.1;
      const double x = std::min(now_s, drive.stops_s) * 0.05;
      if (drive.poses) say(now_s, "/tracked_pose", "'pos':[" + std::to_string(x) + "," + y + "],\"ori\":0");
      if (i % 10 == 0) say(now_s, "/battery_state", "'percentage':" + std::to_string(0.8 - now_s / 1000));
      if (i % 10 == 0)
        say(now_s, "/slam/state", "'state':'positioning','reliable':true,'position_quality':10");
    }
    if (drive.alerted) {
      for (int i = 1; i < 60; ++i) say(i, "/alerts", "'alerts':[{'code':6004,'level':'error','msg':'M'}]");
    }
    if (drive.flaps) {
      for (int i = 0; i < 6; ++i) {
        const bool on = i % 2 == 0;
        say(41 + 2 * i, "/wheel_state",
            std::string("'control_mode':'auto','emergency_stop_pressed':") + (on ? "true" : "false"));
        say(40 + 2 * i, "/alerts", on ? "'alerts':[{'code':6004,'level':'error','msg':'M'}]" : "'alerts':[]");
      }
      say(51.5, "/alerts", "'alerts':[{'code':6004,'level':'error','msg':'M'}]");
    }
    say(60, "/bumper_state", "'front':'" + kOdd + "'");
    say(60, "/alerts", "'alerts':[{'code':6001,'level':'error','msg':'" + kOdd + "'}]");
    (void)(*writer)->close();
    return path;
  }
  tests::Ended report(const QStringList& words, const QMap<QString, QString>& environment = {}) const {
    return program_.run(QStringList{QStringLiteral("bags"), QStringLiteral("report")} + words,
                        {.environment = environment});
  }

 private Q_SLOTS:
  void aMomentIsOneFile() {
    const QString file = recording("drive.mcap", {});
    const auto done = report({file, QStringLiteral("--at"), at(50), QStringLiteral("-o"),
                              QStringLiteral("a.html"), QStringLiteral("--json")});
    QVERIFY2(done.code == 0 && done.err.isEmpty(), qPrintable(done.err));
    const QJsonObject told = done.object();
    QCOMPARE(told[QStringLiteral("on_the_way")].toArray().size(), 1);
    const QJsonObject wall = told[QStringLiteral("on_the_way")][0].toObject();
    QVERIFY(std::abs(wall[QStringLiteral("along_m")].toDouble() - 0.25) < 0.1);
    QCOMPARE(wall[QStringLiteral("name")].toString(), QString::fromStdString(kOdd));
    QCOMPARE(told[QStringLiteral("speed")].toDouble(), 0.0);
    const QString html = QString::fromUtf8(program_.bytes("a.html"));
    QVERIFY(html.contains(QLatin1String("drive.mcap")));
    QVERIFY(html.contains(QLatin1String("consistent with being held up at Virtual wall")));
    QVERIFY(html.contains(QLatin1String("&lt;b&gt;Hall&lt;/b&gt;")) && !html.contains(QLatin1String("<b>")));
    QVERIFY(html.contains(QLatin1String("data:image/png;base64,")));
    // Nothing of this machine, and nothing from elsewhere.
    for (const QString& odd : {program_.folder(), QStringLiteral("http:"), QStringLiteral("<script")})
      QVERIFY2(!html.contains(odd), qPrintable(odd));
  }

  void submapsOfAnEarlierSessionAreMissingAndNotWaitedFor() {
    simulator::Options options;
    options.paused = true;
    options.start_at_s = 700;
    simulator::Simulator robot(options);
    QVERIFY(!robot.start());
    robot.restartSlam();
    const QMap<QString, QString> environment{
        {QStringLiteral("MAPWRIGHT_ROBOT"), QString::fromStdString(robot.address())}};
    const auto done = report({QStringLiteral("2024-06-03_09-00-00.bag"), QStringLiteral("--at"), at(300),
                              QStringLiteral("--timeout"), QStringLiteral("60"), QStringLiteral("-o"),
                              QStringLiteral("earlier.html")},
                             environment);
    QCOMPARE(done.code, 1);
    QVERIFY2(done.err.contains(QLatin1String("Submaps that could not be drawn")), qPrintable(done.err));
    QVERIFY(program_.bytes("earlier.html").contains("</html>"));
  }

  void anAlertFromTheBeginningHasNoTime() {
    const auto told = [&](const QString& file, double after_s) {
      return report({file, QStringLiteral("--at"), at(after_s), QStringLiteral("-o"), QStringLiteral("-")})
          .out;
    };
    const QString before = QStringLiteral("(since before the recording begins)");
    QVERIFY(told(recording("alerted.mcap", {1, 40, true, true}), 50).contains(before));
    const QString later = told(recording("drive.mcap", {}), 60);
    QVERIFY(later.contains(QLatin1String("(since 09:01:00.000, for 0.0 s)")) && !later.contains(before));
  }

  /// What keeps a window from flickering is no part of a report.
  void whatHasEndedIsOverAndWhatBeganAgainIsNew() {
    const QString file = recording("flaps.mcap", {1, 40, true, false, true});
    const auto done = report({file, QStringLiteral("--at"), at(53.5), QStringLiteral("-o"),
                              QStringLiteral("flaps.html"), QStringLiteral("--json")});
    QVERIFY2(done.code == 0, qPrintable(done.err));
    const QJsonArray safety = done.object()[QStringLiteral("safety")].toArray();
    QCOMPARE(safety.size(), 1);
    QCOMPARE(safety[0].toObject()[QStringLiteral("code")].toInt(), 6004);
    QCOMPARE(safety[0].toObject()[QStringLiteral("since")].toDouble(), at(51.5).toDouble());
    const QString html = QString::fromUtf8(program_.bytes("flaps.html"));
    QVERIFY(!html.contains(QLatin1String("It is pressed")));
  }

  void whatTheBagTellsOfBumpersIsShownAsSent() {
    const QString file = recording("drive.mcap", {});
    const auto done =
        report({file, QStringLiteral("--at"), at(60), QStringLiteral("-o"), QStringLiteral("-")});
    QVERIFY2(done.code == 0, qPrintable(done.err));
    QVERIFY(done.out.contains(QLatin1String("/bumper_state")) &&
            done.out.contains(QLatin1String("&quot;front&quot;")));
    QVERIFY(!done.out.contains(QLatin1String("Bumpers: the bag has no topic")));
  }

  void theBytesAreTheSameWhoeverAsks() {
    const QString file = recording("drive.mcap", {}), other = recording("other.mcap", {1.2, 60, true});
    const QStringList words{file,  QStringLiteral("--at"), at(50), QStringLiteral("--against"),
                            other, QStringLiteral("-o")};
    QVERIFY(report(words + QStringList{QStringLiteral("first.html")}).code == 0);
    const QByteArray first = program_.bytes("first.html");
    QVERIFY(first.size() > 10'000);
    const QList<QMap<QString, QString>> elsewhere{{},
                                                  {{QStringLiteral("TZ"), QStringLiteral("Asia/Kolkata")}},
                                                  {{QStringLiteral("LC_ALL"), QStringLiteral("de_DE.UTF-8")},
                                                   {QStringLiteral("LANG"), QStringLiteral("ar_EG.UTF-8")}},
                                                  {{QStringLiteral("HOME"), QStringLiteral("/nonexistent")}}};
    for (const auto& environment : elsewhere) {
      QVERIFY(report(words + QStringList{QStringLiteral("again.html")}, environment).code == 0);
      QVERIFY(program_.bytes("again.html") == first);
    }
    // On one processor.
    const auto alone = program_.run(QStringList{QStringLiteral("bags"), QStringLiteral("report")} + words +
                                        QStringList{QStringLiteral("again.html")},
                                    {.in_child = [] {
                                      cpu_set_t one;
                                      CPU_ZERO(&one);
                                      CPU_SET(0, &one);
                                      sched_setaffinity(0, sizeof one, &one);
                                    }});
    QVERIFY2(alone.code == 0, qPrintable(alone.err));
    QVERIFY(program_.bytes("again.html") == first);
  }

  /// The robot tells the state anew while the seconds after the moment are read.
  void theBytesAreTheSameHoweverSlowTheRobotIs() {
    std::set<QByteArray> all;
    for (const int latency_ms : {0, 10, 30, 60, 110}) {
      simulator::Options options;
      options.paused = true;
      options.start_at_s = 1500;
      options.faults.requests.push_back({simulator::FaultKind::Delay, simulator::kMaps, 1, latency_ms});
      simulator::Simulator robot(options);
      QVERIFY(!robot.start());
      const auto done =
          report({QStringLiteral("2024-06-03_09-10-00.bag"), QStringLiteral("--at"), at(900),
                  QStringLiteral("--robot"), QString::fromStdString(robot.address()), QStringLiteral("-o"),
                  QStringLiteral("slow.html")},
                 {{QStringLiteral("XDG_CACHE_HOME"), program_.path(QString::number(latency_ms))}});
      QVERIFY2(done.code == 0, qPrintable(done.err));
      const QByteArray html = program_.bytes("slow.html");
      QVERIFY(html.contains("/trajectory") && html.contains("/nearby_robot_footprints"));
      all.insert(html);
    }
    QCOMPARE(all.size(), std::size_t(1));
  }

  void aFileOfAnotherKindHasNoBags() {
    const QString file = recording("drive.mcap", {});
    program_.put("a.png", "no picture");
    const QStringList rest{QStringLiteral("--at"), at(20), QStringLiteral("-o"), QStringLiteral("no.html")};
    const auto told = report(QStringList{QStringLiteral("a.png")} + rest);
    const auto beside =
        report(QStringList{file, QStringLiteral("--against"), QStringLiteral("a.png")} + rest);
    for (const auto* const done : {&told, &beside}) QCOMPARE(done->code, 2);
    QCOMPARE(told.err, QStringLiteral("a.png: There is nothing in this file that can be replayed.\n"));
    QVERIFY(beside.err.startsWith(QLatin1String("--against a.png is not a recording.")));
    QVERIFY(!QFile::exists(program_.path("no.html")));
  }

  void aBagWithoutPositionsIsReported() {
    const QString file = recording("still.mcap", {1, 40, false});
    const auto done =
        report({file, QStringLiteral("--at"), at(50), QStringLiteral("-o"), QStringLiteral("-")});
    QVERIFY2(done.code == 0, qPrintable(done.err));
    QVERIFY(done.out.contains(QLatin1String("Position: the bag holds none up to this time.")));
    // There is no place to look for in another run, but its time can be named.
    const QString other = recording("drive.mcap", {});
    const auto lost = report({file, QStringLiteral("--at"), at(50), QStringLiteral("--against"), other,
                              QStringLiteral("-o"), QStringLiteral("-")});
    QVERIFY2(lost.code == 2 && lost.err.contains(QLatin1String("Give its time")), qPrintable(lost.err));
    const auto named = report({file, QStringLiteral("--at"), at(50), QStringLiteral("--against"),
                               other + QLatin1Char('@') + at(20), QStringLiteral("-o"), QStringLiteral("-")});
    QVERIFY2(named.code == 0, qPrintable(named.err));
    QVERIFY(named.out.contains(QLatin1String("2024-06-03 09:00:20.000")));
  }

  void aTimeOutsideIsRefusedWithTheRange() {
    const QString file = recording("drive.mcap", {});
    for (const double wrong : {-1.0, 61.0}) {
      const auto done =
          report({file, QStringLiteral("--at"), at(wrong), QStringLiteral("-o"), QStringLiteral("no.html")});
      QCOMPARE(done.code, 2);
      QVERIFY2(done.err.contains(QLatin1String("from 2024-06-03 09:00:00.000 to 2024-06-03 09:01:00.000")),
               qPrintable(done.err));
      QVERIFY(done.err.count(QLatin1Char('\n')) == 1);
      // Pictures are refused alike.
      const auto drawn =
          program_.run({QStringLiteral("snapshot"), QStringLiteral("--bag"), file, QStringLiteral("--at"),
                        at(wrong), QStringLiteral("--layers"), QStringLiteral("robot"),
                        QStringLiteral("--center"), QStringLiteral("0,0"), QStringLiteral("--scale"),
                        QStringLiteral("0.05"), QStringLiteral("-o"), QStringLiteral("no.png")});
      QCOMPARE(drawn.code, 2);
      QVERIFY2(drawn.err.contains(QLatin1String("from 2024-06-03 09:00:00.000 to 2024-06-03 09:01:00.000")),
               qPrintable(drawn.err));
      QVERIFY(!QFile::exists(program_.path("no.png")));
      program_.put(
          "suite.yaml",
          "views:\n  - {name: a, robot: drive.mcap, layers: robot, center: [0, 0], scale: 0.05, at: " +
              at(wrong).toUtf8() + "}\n");
      const auto ran = program_.run(
          QStringLiteral("suite run suite.yaml --expected e --report r").split(QLatin1Char(' ')));
      QVERIFY2(ran.code == 1 && ran.out.contains(QLatin1String("a: failed. ")) &&
                   ran.out.contains(QLatin1String("is not within it")),
               qPrintable(ran.out));
    }
    QVERIFY(!QFile::exists(program_.path("no.html")));
    // Robots state whole seconds: the last one belongs to the bag, the one before the first does not.
    simulator::Options options;
    options.paused = true;
    options.start_at_s = 1500;
    simulator::Simulator robot(options);
    QVERIFY(!robot.start());
    for (const double wrong : {599.0, 599.9, 1201.0}) {
      const auto done = report({QStringLiteral("2024-06-03_09-10-00.bag"), QStringLiteral("--at"), at(wrong),
                                QStringLiteral("--robot"), QString::fromStdString(robot.address()),
                                QStringLiteral("-o"), QStringLiteral("no.html")});
      QVERIFY2(done.code == 2 && done.err.contains(QLatin1String("it lasts from 2024-06-03 09:10:00.000")),
               qPrintable(done.err));
    }
    QVERIFY(!QFile::exists(program_.path("no.html")));
  }

  void whatIsLostOfADamagedFileIsTold() {
    const QString path = recording("cut.mcap", {});
    QFile file(path);
    QVERIFY(file.resize(file.size() * 3 / 4));
    const auto done =
        report({path, QStringLiteral("--at"), at(10), QStringLiteral("-o"), QStringLiteral("cut.html")});
    QVERIFY2(done.code == 1 && done.err.contains(QLatin1String("Its end is missing")), qPrintable(done.err));
    QVERIFY(QString::fromUtf8(program_.bytes("cut.html")).contains(QLatin1String("Its end is missing")));
    // Nothing is left of it.
    QVERIFY(file.resize(100));
    const auto empty =
        report({path, QStringLiteral("--at"), at(10), QStringLiteral("-o"), QStringLiteral("empty.html")});
    QVERIFY2(empty.code == 2 && empty.err.contains(QLatin1String("cut.mcap")) &&
                 !empty.err.contains(QLatin1String("1970")),
             qPrintable(empty.err));
  }

  void anotherRunIsFoundAtTheSamePlace() {
    const QString file = recording("drive.mcap", {}), other = recording("other.mcap", {1.2, 60, true});
    // It passes x = 1 after 20 s, 20 cm beside.
    const auto done = report({file, QStringLiteral("--at"), at(20), QStringLiteral("--against"), other,
                              QStringLiteral("-o"), QStringLiteral("b.html"), QStringLiteral("--json")});
    QVERIFY2(done.code == 0, qPrintable(done.err));
    const QJsonObject against = done.object()[QStringLiteral("against")].toObject();
    QVERIFY(std::abs(against[QStringLiteral("metres")].toDouble() - 0.2) < 0.01);
    QVERIFY(std::abs(against[QStringLiteral("at")].toDouble() - 1'717'405'220) < 0.11);
    const QString html = QString::fromUtf8(program_.bytes("b.html"));
    QVERIFY(html.contains(QLatin1String("came nearest to the same place: 0.20 m away")));
    QCOMPARE(html.count(QLatin1String("data:image/png;base64,")), 2);
  }

  void theRecordingIsNotReplaced() {
    const QString file = recording("drive.mcap", {});
    const QStringList words{file, QStringLiteral("--at"), at(20), QStringLiteral("-o")};
    const auto self = report(words + QStringList{file});
    QVERIFY2(self.code == 2 && self.err.contains(QLatin1String("is the recording itself")) &&
                 !self.err.contains(QLatin1String("--force")),
             qPrintable(self.err));
    QVERIFY(report({file, QStringLiteral("--at"), QStringLiteral("soon"), QStringLiteral("-o"),
                    QStringLiteral("x.html")})
                .code == 2);
  }

  void aDeviceIsWrittenInto() {
    const QString file = recording("drive.mcap", {});
    const QStringList words{file, QStringLiteral("--at"), at(20), QStringLiteral("-o")};
    const auto full = report(words + QStringList{QStringLiteral("/dev/full")});
    QVERIFY2(full.code == 2 && full.err.contains(QLatin1String("No space left on device")) &&
                 !full.err.contains(QLatin1String("--force")),
             qPrintable(full.err));
    QCOMPARE(report(words + QStringList{QStringLiteral("/dev/null")}).code, 0);
    QVERIFY(
        report(words + QStringList{QStringLiteral("/dev/stdout")}).out.contains(QLatin1String("</html>")));
  }

  void whatIsNoRecordingIsNoOtherRun() {
    simulator::Options options;
    options.paused = true;
    simulator::Simulator robot(options);
    QVERIFY(!robot.start());
    program_.put("a.png", "no recording");
    for (const char* other : {"a.png", "a.png@2024-06-03T09:00:00Z"}) {
      const auto done =
          report({QStringLiteral("2024-06-03_09-00-00.bag"), QStringLiteral("--at"), at(115),
                  QStringLiteral("--against"), QLatin1String(other), QStringLiteral("--robot"),
                  QString::fromStdString(robot.address()), QStringLiteral("-o"), QStringLiteral("-")});
      QVERIFY2(done.code == 2 && done.err.contains(QLatin1String("a.png is not a recording")),
               qPrintable(done.err));
    }
  }

  void aRobotThatDoesNotAnswerIsNamed() {
    QTcpServer silent;
    QVERIFY(silent.listen(QHostAddress::LocalHost));
    const QString address = QStringLiteral("axbot+http://127.0.0.1:%1").arg(silent.serverPort());
    const auto done =
        report({QStringLiteral("x.bag"), QStringLiteral("--at"), at(0), QStringLiteral("--robot"), address,
                QStringLiteral("--timeout"), QStringLiteral("2"), QStringLiteral("-o"), QStringLiteral("-")});
    QVERIFY2(done.code == 3 && done.err.startsWith(address), qPrintable(done.err));
  }

  /// A bag of a robot, with its map of now.
  void aBagOfARobotIsReported() {
    simulator::Options options;
    options.paused = true;
    options.start_at_s = 700;
    simulator::Simulator robot(options);
    QVERIFY(!robot.start());
    const auto done = report({QStringLiteral("2024-06-03_09-00-00.bag"), QStringLiteral("--at"), at(115),
                              QStringLiteral("--against"), QStringLiteral("2024-06-03_08-50-00.bag"),
                              QStringLiteral("-o"), QStringLiteral("-")},
                             {{QStringLiteral("MAPWRIGHT_ROBOT"), QString::fromStdString(robot.address())}});
    QVERIFY2(done.code == 0, qPrintable(done.err));
    QVERIFY(done.out.contains(QLatin1String("The emergency stop is pressed")));
    QVERIFY(done.out.contains(QLatin1String("2024-06-03_08-50-00.bag")));
    QCOMPARE(done.out.count(QLatin1String("data:image/png;base64,")), 2);
  }
};

}  // namespace test_bag_report

MAPWRIGHT_TEST(test_bag_report, BagReportTest, Core)
#include "test_bag_report.moc"
