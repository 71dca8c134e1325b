// The bags of the simulated robot, its recordings, and the player that reads them in windows.
#include <algorithm>
#include <cmath>
#include <vector>

#include <QMap>
#include <QSet>

#include "listening.h"
#include "test_program.h"

namespace test_bags {

using mapwright::simulator::Options;

namespace {

double stampOf(const QJsonValue& message) { return message[QLatin1String("__stamp")].toDouble(); }
bool isLatched(const QJsonValue& message) { return message[QLatin1String("__latched")].toBool(); }
QString topicOf(const QJsonValue& message) { return message[QLatin1String("topic")].toString(); }
QByteArray compact(const QJsonValue& message) {
  return QJsonDocument(message.toObject()).toJson(QJsonDocument::Compact);
}

const std::string kBag = "/bags/2024-06-03_09-00-00.bag";
constexpr double kStart = 1717405200;

raw::HttpReply window(const Running& robot, double from, double until, const std::string& bag = kBag) {
  return robot.get(bag + "/player?start_time=" + std::to_string(from) + "&end_time=" + std::to_string(until));
}
QJsonArray messages(const Running& robot, double from, double until) {
  return object(window(robot, from, until).body)[QLatin1String("messages")].toArray();
}
std::string encoded(const QString& name) { return QUrl::toPercentEncoding(name).toStdString(); }

}  // namespace

class TestBags : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void bagsAreListedAndCanBeFetched() {
    Running robot(paused(700));
    for (const std::string folder : {"/bags", "/recording"}) {
      const auto list = robot.get(folder + "/");
      QCOMPARE(list.status, 200);
      QCOMPARE(robot.get(folder).body, list.body);
      const QJsonArray files = array(list.body);
      QVERIFY(files.size() >= 2);
      for (const QJsonValue& file : files) {
        QVERIFY(file[QLatin1String("filename")].toString().endsWith(QLatin1String(".bag")));
        QVERIFY(file[QLatin1String("size")].toString().endsWith(QLatin1String("KB")));
        QVERIFY(file[QLatin1String("end")].toString().contains(QLatin1String("-2024 ")));
        const QString url = file[QLatin1String("download_url")].toString();
        QVERIFY(url.startsWith(QLatin1String("http://192.168.25.25:8090/")) &&
                !url.contains(QLatin1Char(' ')));
        const auto bag = robot.get(url.mid(25).toStdString());
        QCOMPARE(bag.status, 200);
        QCOMPARE(int(bag.body.size()), file[QLatin1String("size_bytes")].toInt());
        QVERIFY(bag.body.starts_with("#ROSBAG V2.0\n"));
      }
    }
  }

  void aBagTellsHowMuchItHolds() {
    Running robot(paused(700));
    const auto reply = robot.get(kBag + "/player");
    QCOMPARE(reply.status, 200);
    QCOMPARE(reply.headers.at("cache-control"), std::string("public, max-age=2592000"));
    const QJsonObject bag = object(reply.body);
    QCOMPARE(bag[QLatin1String("start_time")].toDouble(), kStart);
    QCOMPARE(bag[QLatin1String("end_time")].toDouble(), kStart + 599);
    QVERIFY(bag[QLatin1String("total_messages")].toInt() > 6000);
    QVERIFY(!bag.contains(QLatin1String("messages")));
  }

  void allOfABagComesInOrder() {
    Running robot(paused(700));
    const QJsonObject whole = object(window(robot, 0, 1e12).body);
    const QJsonArray all = whole[QLatin1String("messages")].toArray();
    QCOMPARE(all.size(), whole[QLatin1String("total_messages")].toInt());
    double last = 0;
    for (const QJsonValue& message : all) {
      QVERIFY(stampOf(message) >= last);
      last = stampOf(message);
    }
    QVERIFY(last > whole[QLatin1String("end_time")].toDouble());  // metadata are whole seconds
  }

  void windowsPutTogetherAreTheLargeWindow() {
    Running robot(paused(700));
    const QJsonArray all = messages(robot, kStart, kStart + 59.9995);
    qsizetype at = 0;
    for (int i = 0; i < 6; ++i) {
      const double from = kStart + 10 * i;
      for (const QJsonValue& message : messages(robot, from, from + 9.9995)) {
        if (stampOf(message) < from) continue;  // what was said before
        QVERIFY(at < all.size());
        QCOMPARE(compact(message), compact(all[at]));
        ++at;
      }
    }
    QCOMPARE(at, all.size());
  }

  void aWindowBeginsWithWhatWasSaidLastOnLatchedTopics() {
    Running robot(paused(700));
    const double from = kStart + 62.5;
    QMap<QString, QByteArray> last;
    for (const QJsonValue& message : messages(robot, 0, from - 0.0005)) {
      if (isLatched(message)) last[topicOf(message)] = compact(message);
    }
    QMap<QString, QByteArray> filled;
    double before = 0;
    for (const QJsonValue& message : messages(robot, from, from + 5)) {
      QVERIFY(stampOf(message) >= before && stampOf(message) <= from + 5);
      before = stampOf(message);
      if (stampOf(message) >= from) continue;
      QVERIFY(isLatched(message) && !filled.contains(topicOf(message)));
      filled[topicOf(message)] = compact(message);
    }
    QCOMPARE(filled, last);
    for (const char* topic : {"/map/info", "/robot_model", "/alerts", "/sensor_manager_state", "/path",
                              "/local_path", "/planning_state", "/nearby_robot_footprints"})
      QVERIFY2(filled.contains(QLatin1String(topic)), topic);
  }

  void aWindowBesideTheBagIsEmptyOrWhatWasSaidLast() {
    Running robot(paused(700));
    QCOMPARE(messages(robot, 10, 20).size(), 0);
    const QJsonArray after = messages(robot, kStart + 5000, kStart + 5001);
    QVERIFY(!after.isEmpty());
    for (const QJsonValue& message : after) QVERIFY(isLatched(message));
  }

  void messagesAreTheRobotsOwnTopics() {
    Listening robot(paused(700));
    const QJsonArray window = messages(robot, kStart + 100, kStart + 103);
    QMap<QString, QJsonObject> first;
    for (const QJsonValue& message : window) {
      if (!first.contains(topicOf(message))) first[topicOf(message)] = message.toObject();
    }
    for (const char* topic : {"/tracked_pose", "/slam/state", "/path", "/planning_state", "/map/info",
                              "/battery_state", "/scan_matched_points2", "/nearby_robots", "/alerts"}) {
      const QJsonObject live = robot.of(topic), recorded = first.value(QLatin1String(topic));
      QVERIFY2(!live.isEmpty() && !recorded.isEmpty(), topic);
      for (const QString& key : live.keys()) QVERIFY2(recorded.contains(key), qPrintable(key));
    }
    // Half a metre and more per second, and no jumps.
    QList<QPointF> poses;
    for (const QJsonValue& message : window) {
      if (topicOf(message) != QLatin1String("/tracked_pose")) continue;
      const QJsonArray pos = message[QLatin1String("pos")].toArray();
      poses << QPointF(pos[0].toDouble(), pos[1].toDouble());
    }
    QCOMPARE(poses.size(), 30);
    for (int i = 1; i < poses.size(); ++i) {
      const QPointF step = poses[i] - poses[i - 1];
      QVERIFY(std::hypot(step.x(), step.y()) > 0.02 && std::hypot(step.x(), step.y()) < 0.12);
    }
  }

  void submapListsAreRecordedAndNotSaidBeforeAWindow() {
    Running robot(paused(700));
    int lists = 0;
    for (const QJsonValue& message : messages(robot, kStart + 100, kStart + 159.9995)) {
      if (topicOf(message) != QLatin1String("/submap_list")) continue;
      ++lists;
      QVERIFY(!isLatched(message));
      QCOMPARE(message[QLatin1String("uuid")].toString().toStdString(), robot.uuid());
      QVERIFY(!message[QLatin1String("submap")].toArray().isEmpty());
      QVERIFY(stampOf(message) >= kStart + 100);
    }
    QCOMPARE(lists, 6);
  }

  void thePastStaysAsItWas() {
    Running robot(paused(700));
    const std::string before = window(robot, kStart + 300, kStart + 302).body;
    robot.closeLoop();
    robot.restartSlam();
    robot.publishMapChange();
    QCOMPARE(robot.send("PATCH", "/maps/1", R"({"map_name":"Another"})").status, 200);
    QCOMPARE(robot.send("POST", "/chassis/pose", R"({"position":[9,9,0],"ori":0})").status, 200);
    QCOMPARE(robot.send("POST", "/services/wheel_control/set_emergency_stop", R"({"enable":true})").status,
             200);
    robot.advance(100);
    QCOMPARE(window(robot, kStart + 300, kStart + 302).body, before);
    Running again(paused(700));
    QCOMPARE(window(again, kStart + 300, kStart + 302).body, before);
  }

  void whatThePlayerCannotPlayIs400_data() {
    QTest::addColumn<QByteArray>("target");
    const QByteArray bag = QByteArray::fromStdString(kBag);
    QTest::newRow("no such bag") << QByteArray("/bags/2020-01-01_00-00-00.bag/player");
    QTest::newRow("a name that climbs") << QByteArray("/bags/..%2F..%2Fetc%2Fpasswd/player");
    QTest::newRow("a name that is no text") << QByteArray("/bags/%zz/player");
    QTest::newRow("a corrupt bag") << QByteArray("/bags/2024-06-02_23-00-00.bag/player");
    QTest::newRow("a corrupt bag's window")
        << QByteArray("/bags/2024-06-02_23-00-00.bag/player?start_time=1&end_time=2");
    QTest::newRow("a corrupt recording")
        << QByteArray("/recording/2024-06-02%2009%3A00%3A00_1008.bag/player");
    QTest::newRow("a bag that is being recorded") << QByteArray("/bags/2024-06-03_09-10-00.bag/player");
    QTest::newRow("only a start") << bag + "/player?start_time=1";
    QTest::newRow("only an end") << bag + "/player?end_time=1";
    QTest::newRow("no numbers") << bag + "/player?start_time=a&end_time=b";
    QTest::newRow("not finite") << bag + "/player?start_time=nan&end_time=inf";
    QTest::newRow("reversed") << bag + "/player?start_time=20&end_time=10";
  }
  void whatThePlayerCannotPlayIs400() {
    QFETCH(QByteArray, target);
    Running robot(paused(700));
    const auto reply = robot.get(target.toStdString());
    QCOMPARE(reply.status, 400);
    QVERIFY(!object(reply.body)[QLatin1String("error")].toString().isEmpty());
    QVERIFY(!reply.headers.contains("cache-control"));
  }

  void aBagIsWholeWhenItsTenMinutesAreOver() {
    Running robot(paused(700));
    const std::string next = "/bags/2024-06-03_09-10-00.bag/player";
    QCOMPARE(robot.get(next).status, 400);
    const qsizetype before = array(robot.get("/bags/").body).size();
    robot.advance(500);
    QCOMPARE(robot.get(next).status, 200);
    QCOMPARE(array(robot.get("/bags/").body).size(), before + 1);
    robot.advance(1e6);
    QVERIFY(array(robot.get("/bags/").body).size() < 20);  // old ones are purged
    QCOMPARE(robot.get(kBag + "/player").status, 400);
  }

  void aRecordingKeepsTheLastMinutes() {
    Running robot(paused(700));
    const auto reply =
        robot.send("POST", "/recording/", R"({"filename_suffix":"lost","duration":"90s","category":"pos"})");
    QCOMPARE(reply.status, 201);
    const QString name = object(reply.body)[QLatin1String("filename")].toString();
    QCOMPARE(name, QStringLiteral("2024-06-03 09:11:40_lost.bag"));
    QCOMPARE(array(robot.get("/recording/").body).last().toObject(), object(reply.body));
    const std::string path = "/recording/" + encoded(name);
    const QJsonObject bag = object(robot.get(path + "/player").body);
    QCOMPARE(bag[QLatin1String("end_time")].toInt() - bag[QLatin1String("start_time")].toInt(), 89);
    int scans = 0;
    const double from = bag[QLatin1String("start_time")].toDouble() + 10;
    for (const QJsonValue& message :
         object(window(robot, from, from + 9.9995, path).body)[QLatin1String("messages")].toArray())
      scans += topicOf(message) == QLatin1String("/scan_matched_points2") ? 1 : 0;
    QCOMPARE(scans, 50);  // every scan, to find out about positioning
    QCOMPARE(robot.send("POST", "/recording/", "{}").status, 201);
    QCOMPARE(robot.send("DELETE", path, "").status, 204);
    QCOMPARE(robot.get(path + "/player").status, 400);
  }

  void impossibleRecordingsAreRefused() {
    Running robot(paused(700));
    const qsizetype before = array(robot.get("/recording/").body).size();
    for (const char* body :
         {"x", R"({"duration":"6m"})", R"({"duration":"0s"})", R"({"duration":120})", R"({"duration":"m"})",
          R"({"category":"all"})", R"({"filename_suffix":"../x"})", R"({"filename_suffix":7})"}) {
      const auto reply = robot.send("POST", "/recording/", body);
      QCOMPARE(reply.status, 400);
      QVERIFY(!object(reply.body)[QLatin1String("detail")].toString().isEmpty());
    }
    QCOMPARE(array(robot.get("/recording/").body).size(), before);
  }

  void bagsCanBeDeletedButNotTheOneThatIsBeingRecorded() {
    Running robot(paused(700));
    QCOMPARE(robot.send("DELETE", kBag, "").status, 204);
    QCOMPARE(robot.get(kBag + "/player").status, 400);
    QCOMPARE(robot.send("DELETE", kBag, "").status, 404);
    QCOMPARE(robot.send("DELETE", "/bags/2024-06-03_09-10-00.bag", "").status, 400);
    QCOMPARE(robot.send("DELETE", "/bags/", "").status, 204);
    QCOMPARE(array(robot.get("/bags/").body).size(), 1);
    QCOMPARE(robot.send("DELETE", "/recording/", "").status, 204);
    QCOMPARE(array(robot.get("/recording/").body).size(), 0);
  }

  void oddBagsAreOddInTheirOwnWay() {
    Options options = paused(700);
    options.bags.odd = true;
    Running robot(options);
    const auto all = [&](const char* name) {
      return object(window(robot, 0, 4e9, std::string("/bags/") + name).body);
    };
    const auto stamps = [](const QJsonObject& bag) {
      std::vector<double> all_stamps;
      for (const QJsonValue& message : bag[QLatin1String("messages")].toArray())
        all_stamps.push_back(stampOf(message));
      return all_stamps;
    };
    QCOMPARE(all("empty.bag")[QLatin1String("total_messages")].toInt(), 0);
    QCOMPARE(stamps(all("one_message.bag")).size(), std::size_t(1));
    const auto back = stamps(all("clock_set_back.bag"));
    QVERIFY(!std::is_sorted(back.begin(), back.end()));
    const auto same = stamps(all("same_stamps.bag"));
    QVERIFY(std::is_sorted(same.begin(), same.end()));
    QVERIFY(std::adjacent_find(same.begin(), same.end()) != same.end());
    const QJsonObject late = all("ends_late.bag");
    QVERIFY(stamps(late).back() > late[QLatin1String("end_time")].toDouble() + 29);
  }

  void damagedBagsRefuseTheRangesThatHoldTheDamage() {
    Options options = paused(700);
    options.bags.odd = true;
    Running robot(options);
    for (const auto& [name, status] : {std::pair("damaged.bag", 400), {"unreadable.bag", 500}}) {
      const std::string bag = std::string("/bags/") + name;
      const QJsonObject info = object(robot.get(bag + "/player").body);
      double from = info[QLatin1String("start_time")].toDouble();
      double until = info[QLatin1String("end_time")].toDouble() + 1;
      QCOMPARE(window(robot, from, until, bag).status, status);
      int refused = 0;
      for (double s = from; s < until; s += 10) refused += window(robot, s, s + 9.9, bag).status == status;
      QVERIFY(refused <= 1);
    }
    QVERIFY(!object(robot.get("/bags/uncounted.bag/player").body).contains(QLatin1String("total_messages")));
  }

  void aBagOfEightHoursIsMadeRangeByRange() {
    Options options = paused(700);
    options.bags.odd = true;
    Running robot(options);
    const std::string bag = "/bags/eight_hours.bag";
    const QJsonObject info = object(robot.get(bag + "/player").body);
    QVERIFY(info[QLatin1String("total_messages")].toInt() > 100'000);
    const double end = info[QLatin1String("end_time")].toDouble();
    QVERIFY(end - info[QLatin1String("start_time")].toDouble() > 8 * 3600 - 60);
    const QJsonObject part = object(window(robot, end - 100, end - 90, bag).body);
    QVERIFY(part[QLatin1String("messages")].toArray().size() > 100);
  }

  void aRangeMayEndBeforeItsEnd() {
    const QJsonArray inclusive = messages(Running(paused(700)), kStart, kStart + 10);
    Options options = paused(700);
    options.bags.end_exclusive = true;
    Running robot(options);
    const double last = stampOf(inclusive.last());
    QCOMPARE(stampOf(messages(robot, kStart, last).last()) < last, true);
  }

  void aDownloadGoesOnFromAByte() {
    Running robot(paused(700));
    const auto whole = robot.get(kBag + "/download");
    const auto rest = robot.get(kBag + "/download", {{"Range", "bytes=100-"}});
    QCOMPARE(rest.status, 206);
    QCOMPARE(rest.body, whole.body.substr(100));
    QCOMPARE(robot.get(kBag + "/download", {{"Range", "bytes=99999999-"}}).status, 416);
  }

  void anEmptyRobotRecordsHowItIs() {
    Options options = paused(700);
    options.scene = "empty";
    Running robot(options);
    QSet<QString> topics;
    for (const QJsonValue& message : messages(robot, kStart, kStart + 10)) topics << topicOf(message);
    QVERIFY(topics.contains(QStringLiteral("/tracked_pose")) &&
            !topics.contains(QStringLiteral("/map/info")));
  }
};

}  // namespace test_bags

MAPWRIGHT_TEST(test_bags, TestBags, Core)
#include "test_bags.moc"
