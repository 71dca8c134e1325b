// Every fault on request, and none without.
#include <set>

#include <QTcpSocket>

#include "running.h"
#include "test_program.h"
#include "topic_socket.h"

namespace test_faults {

using namespace mapwright::simulator;

namespace {

Options faulty(const Faults& faults) {
  Options options = paused();
  options.faults = faults;
  return options;
}

Options faulty(std::vector<RequestFault> requests) {
  Options options = paused();
  options.faults.requests = std::move(requests);
  return options;
}

std::string target(const Running& robot, int index) {
  return "/ros/slam/submaps/" + robot.uuid() + "/0/" + std::to_string(index) + "?ver=24";
}

std::optional<ros_messages::slam::SubmapQueryV2Response> parsed(const std::string& body) {
  ros_messages::slam::SubmapQueryV2Response response;
  if (!response.ParseFromString(body)) return std::nullopt;
  return response;
}

}  // namespace

class TestFaults : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void droppedRequestsGetNoAnswer() {
    Running robot(faulty(std::vector<RequestFault>{{FaultKind::Drop, kSubmaps}}));
    QCOMPARE(robot.get(target(robot, 0)).status, 0);
    QTRY_VERIFY(robot.requestLog().front().until_s >= 0);
    QCOMPARE(robot.requestLog().front().status, 0);
    QCOMPARE(robot.get("/device/info").status, 200);  // only submaps go wrong
  }

  void truncatedAnswersEndHalfWay() {
    Faults faults;
    Running robot(faulty(faults));
    const raw::HttpReply good = robot.get(target(robot, 0));
    faults.requests.push_back({FaultKind::Truncate, kSubmaps});
    robot.setFaults(faults);
    const raw::HttpReply bad = robot.get(target(robot, 0));
    QCOMPARE(bad.status, 200);
    QVERIFY(!bad.whole);
    QCOMPARE(bad.headers.at("content-length"), std::to_string(good.body.size()));
    QCOMPARE(bad.body, good.body.substr(0, good.body.size() / 2));
  }

  void wrongSizesDoNotFitTheCells() {
    Running robot(faulty(std::vector<RequestFault>{{FaultKind::WrongSize, kSubmaps}}));
    for (int index = 0; index < 8; ++index) {
      const auto response = parsed(robot.get(target(robot, index)).body);
      QVERIFY(response.has_value());
      QVERIFY(!raw::unpack(response->textures(0)).has_value());
    }
  }

  void corruptAnswersAreNoMessage() {
    Running robot(faulty(std::vector<RequestFault>{{FaultKind::Corrupt, kSubmaps}}));
    for (int index = 0; index < 8; ++index) {
      const raw::HttpReply reply = robot.get(target(robot, index));
      QCOMPARE(reply.status, 200);
      QVERIFY(reply.whole);
      QVERIFY(!parsed(reply.body).has_value());
    }
  }

  void httpErrorsHaveTheChosenStatus() {
    for (const int status : {400, 404, 500, 502, 504}) {
      Running robot(faulty(std::vector<RequestFault>{{FaultKind::Refuse, kSubmaps, 1, status}}));
      QCOMPARE(robot.get(target(robot, 0)).status, status);
    }
  }

  void statusErrorsComeInsideAnOkAnswer() {
    Running robot(faulty(std::vector<RequestFault>{{FaultKind::StatusError, kSubmaps}}));
    const raw::HttpReply reply = robot.get(target(robot, 0));
    QCOMPARE(reply.status, 200);
    QVERIFY(parsed(reply.body).has_value());
    QVERIFY(parsed(reply.body)->status().code() != ros_messages::slam::OK);
    QVERIFY(!parsed(reply.body)->status().message().empty());
  }

  void latencyDelaysOneAnswerAndNoOther() {
    Running robot(faulty(std::vector<RequestFault>{{FaultKind::Delay, kSubmaps, 1, 300},
                                                   {FaultKind::Jitter, kSubmaps, 1, 50}}));
    QCOMPARE(robot.get(target(robot, 0)).status, 200);
    QTRY_VERIFY(robot.requestLog().front().until_s >= 0);
    QVERIFY(robot.requestLog().front().until_s - robot.requestLog().front().at_s >= 0.3);
  }

  void theSameSeedFailsTheSameRequests() {
    Faults faults;
    faults.requests.push_back({FaultKind::Drop, kSubmaps, 0.3});
    faults.requests.push_back({FaultKind::Refuse, kSubmaps, 0.3});
    const auto outcomes = [&](std::uint32_t seed) {
      Options options = faulty(faults);
      options.seed = seed;
      Running robot(options);
      std::vector<int> statuses;
      for (int round = 0; round < 2; ++round) {
        for (int index = 0; index < 20; ++index) statuses.push_back(robot.get(target(robot, index)).status);
      }
      return statuses;
    };
    const std::vector<int> first = outcomes(1);
    QCOMPARE(first.size(), std::size_t(40));
    QVERIFY(outcomes(1) == first);
    QVERIFY(outcomes(2) != first);
    QCOMPARE(std::set<int>(first.begin(), first.end()), (std::set<int>{0, 200, 500}));
    QVERIFY(std::vector<int>(first.begin(), first.begin() + 20) !=
            std::vector<int>(first.begin() + 20, first.end()));
  }

  void aPathIsMetWithAllThatIsBelowIt() {
    Running robot(faulty(std::vector<RequestFault>{{FaultKind::Refuse, kReads, 1, 404, "/device/info"},
                                                   {FaultKind::Cut, kWrites, 1, 0, "/maps/"}}));
    QCOMPARE(robot.get("/device/info").status, 404);
    QCOMPARE(robot.get("/device/info/brief?x=1").status, 404);
    QCOMPARE(robot.get("/device/boot_progress").status, 200);
    QCOMPARE(robot.send("DELETE", "/maps/2", "").status, 0);
    QCOMPARE(robot.get("/maps/2").status, 404);  // it was done
  }

  void aRequestMayHaveNoAnswerAtAll() {
    Running robot(faulty(std::vector<RequestFault>{{FaultKind::Silence, kAllRequests, 1, 0, "/maps/2"}}));
    QTcpSocket client;
    client.connectToHost(QStringLiteral("127.0.0.1"), robot.port());
    QVERIFY(client.waitForConnected());
    client.write("DELETE /maps/2 HTTP/1.1\r\nHost: x\r\n\r\n");
    QTRY_COMPARE(robot.requestLog().size(), std::size_t(1));
    QTRY_COMPARE(robot.get("/maps/").body.find("620620f9c0fd0ecb0f66d981"), std::string::npos);
    QCOMPARE(client.state(), QAbstractSocket::ConnectedState);
    QCOMPARE(robot.requestLog().front().until_s, -1.0);
  }

  void badEntriesStandBesideGoodOnes() {
    Faults faults;
    faults.bad_entries = true;
    Running robot(faulty(faults));
    TopicSocket client(robot.port());
    QTRY_VERIFY(client.isOpen());
    client.send(R"({"enable_topic":"/submap_list"})");
    QTRY_COMPARE(client.of("/submap_list").size(), 1);
    QVERIFY(client.of("/submap_list").first().contains(QLatin1String("\"x\":null")));
    const raw::List list = raw::readList(client.of("/submap_list").first().toStdString());
    QVERIFY(list.find(90, 1) != nullptr);
    QCOMPARE(list.find(90, 1)->pose[6], 0.0);
    int of_first = 0;
    std::set<int> versions_of_second;
    for (const raw::Entry& entry : list.entries) {
      if (entry.trajectory == 0 && entry.index == 0) ++of_first;
      if (entry.trajectory == 0 && entry.index == 1) versions_of_second.insert(entry.version);
    }
    QCOMPARE(of_first, 2);
    QCOMPARE(versions_of_second, (std::set<int>{23, 24}));
  }

  void linksAreCutAndSessionsRestartedOnSchedule() {
    Faults faults;
    faults.websocket_drop_every_s = 1;
    faults.uuid_change_every_s = 1;
    Simulator robot(faulty(faults));
    const std::string before = robot.uuid();
    QVERIFY(!robot.start());
    TopicSocket client(robot.port());
    QTRY_VERIFY(client.isOpen());
    QTRY_VERIFY(!client.isOpen());
    QTRY_VERIFY(robot.uuid() != before);
  }
};

}  // namespace test_faults

MAPWRIGHT_TEST(test_faults, TestFaults, Core)
#include "test_faults.moc"
