// One robot of each adapter over its simulator, and everything that it can be asked.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QNetworkAccessManager>
#include <QNetworkReply>
#include <QTemporaryDir>
#include <QTest>

#include "answer_gate.h"
#include "robot/aimdk/aimdk_robot.h"
#include "robot/axbot/axbot_robot.h"
#include "robot/files/file_robot.h"
#include "robot/map_administration.h"
#include "robot/ros/ros_robot.h"
#include "robot/waypoint_store.h"
#include "simulator/simulator.h"

namespace mapwright::robot::testing {

enum class Adapter { Axbot, Aimdk, Ros, Kabam, Files };

/// How a question of whatever kind ended: nullopt = in its value.
using Ended = std::optional<map::Failure>;

struct Question {
  const char* name;
  std::function<Call(std::function<void(Ended)>)> ask;
  bool changes = false;
};

class Bench {
 public:
  explicit Bench(Adapter adapter, simulator::Faults faults = {}) : adapter_(adapter) {
    if (adapter == Adapter::Files) {
      QFile picture(folder_.filePath(QStringLiteral("hall.pgm")));
      (void)picture.open(QIODevice::WriteOnly);
      picture.write("P5\n4 4\n255\n" + QByteArray(16, char(254)));
      QFile yaml(folder_.filePath(QStringLiteral("hall.yaml")));
      (void)yaml.open(QIODevice::WriteOnly);
      yaml.write("image: hall.pgm\nresolution: 0.05\norigin: [0, 0, 0]\n");
      key = {map::MapKind::File, "hall.yaml"};
      unknown = {map::MapKind::File, "nowhere.yaml"};
    } else {
      simulator::Options options;
      options.paused = true;
      options.faults = faults;
      options.ros.kabam = adapter == Adapter::Kabam;
      robot_itself = std::make_unique<simulator::Simulator>(options);
      (void)robot_itself->start();
      const bool axbot = adapter == Adapter::Axbot;
      gate = std::make_unique<AnswerGate>(overRosbridge() ? robot_itself->rosPort()
                                          : axbot         ? robot_itself->port()
                                                          : robot_itself->aimdkPort());
      key = {map::MapKind::Stored, axbot ? "2" : "1764059676131"};
      if (adapter == Adapter::Ros) key = {map::MapKind::Live, {}};
      unknown = {map::MapKind::Stored, axbot ? "99" : "17"};
    }
    make();
    if (adapter == Adapter::Kabam) findCurrentMap();
  }

  /// It tells by itself what it is asked for, so much is at hand without a question.
  bool overRosbridge() const { return adapter_ == Adapter::Ros || adapter_ == Adapter::Kabam; }

  /// What the simulated Autoxing robot calls a map, asked behind the adapter's back.
  class Name {
   public:
    Name(const simulator::Simulator& robot, const std::string& id) {
      QNetworkRequest request(QUrl(
          QStringLiteral("http://127.0.0.1:%1/maps/%2").arg(robot.port()).arg(QString::fromStdString(id))));
      reply_.reset(network_.get(request));
    }
    bool known() const { return reply_->isFinished(); }
    QString text() {
      return QJsonDocument::fromJson(reply_->readAll()).object().value(QLatin1String("map_name")).toString();
    }

   private:
    QNetworkAccessManager network_;
    std::unique_ptr<QNetworkReply> reply_;
  };

  /// Another robot on the same way; one that loses patience with a silent robot.
  void make(std::chrono::milliseconds patience = std::chrono::milliseconds(20'000)) {
    robot.reset();
    if (adapter_ == Adapter::Files) {
      files::FileOptions options;
      options.path = folder_.path();
      robot = std::make_unique<files::FileRobot>(QStringLiteral("file:test"), options);
      return;
    }
    if (overRosbridge()) {
      ros::LinkOptions options;
      options.url = QUrl(QStringLiteral("ws://127.0.0.1:%1").arg(gate->port()));
      options.kabam_only = adapter_ == Adapter::Kabam;
      robot = std::make_unique<ros::RosRobot>(QStringLiteral("ros+test"), options);
      robot->connectToRobot();
      (void)QTest::qWaitFor([this] { return robot->connection().phase == ConnectionPhase::Online; }, 30'000);
      return;
    }
    const QUrl base(QStringLiteral("http://127.0.0.1:%1").arg(gate->port()));
    if (adapter_ == Adapter::Axbot) {
      axbot::LinkOptions options;
      options.base = base;
      options.patience = options.fetch_timeout = patience;
      robot = std::make_unique<axbot::AxbotRobot>(QStringLiteral("axbot+test"), options);
    } else {
      aimdk::LinkOptions options;
      options.base = base;
      options.patience = options.map_patience = patience;
      robot = std::make_unique<aimdk::AimdkRobot>(QStringLiteral("aimdk+test"), options);
    }
  }

  /// All that it can be asked, of the map that it has.
  std::vector<Question> questions() const {
    std::vector<Question> all;
    const auto tell = [](const std::function<void(Ended)>& end) {
      return [end](const auto& outcome) { end(outcome ? Ended() : Ended(outcome.error())); };
    };
    if (auto* maps = robot->mapCatalogue()) {
      all.push_back({"list", [=](auto end) { return maps->list(tell(end)); }});
      all.push_back({"describe", [=, of = key](auto end) { return maps->describe(of, tell(end)); }});
      all.push_back({"thumbnail", [=, of = key](auto end) { return maps->thumbnail(of, tell(end)); }});
    }
    if (auto* whole = robot->wholeMapSource())
      all.push_back({"whole map", [=, of = key](auto end) { return whole->fetch(of, tell(end)); }});
    if (auto* overview = robot->overviewSource())
      all.push_back({"overview", [=](auto end) { return overview->fetchOverview(0.2, tell(end)); }});
    if (auto* points = robot->waypointSource())
      all.push_back({"waypoints", [=, of = key](auto end) { return points->waypoints(of, tell(end)); }});
    if (auto* store = robot->waypointStore())
      all.push_back({"stored waypoints", [=, of = key](auto end) { return store->read(of, tell(end)); }});
    if (auto* submaps = robot->submapSource()) {
      const std::string uuid = robot_itself->uuid();
      all.push_back({"submap", [=](auto end) {
                       return submaps->fetch({uuid, {0, 0}, 24}, [end](const map::SubmapAnswer& answer) {
                         using Outcome = map::SubmapAnswer::Outcome;
                         map::Failure failure;
                         failure.kind = answer.failure;
                         if (answer.outcome == Outcome::Cancelled) failure.kind = map::FailureKind::Cancelled;
                         end(answer.outcome == Outcome::Ok ? Ended() : Ended(failure));
                       });
                     }});
    }
    if (auto* maps = robot->mapAdministration()) {
      all.push_back({"rename",
                     [=, of = key](auto end) {
                       return maps->carryOut({MapChange::Rename, of, "Lobby"}, tell(end));
                     },
                     true});
      all.push_back({"load",
                     [=, of = key](auto end) {
                       return maps->carryOut({MapChange::Load, of}, tell(end));
                     },
                     true});
    }
    return all;
  }

  map::MapKey key, unknown;
  std::unique_ptr<simulator::Simulator> robot_itself;  // null: files
  std::unique_ptr<AnswerGate> gate;                    // null: files
  std::unique_ptr<Robot> robot;

 private:
  void findCurrentMap() {
    bool told = false;
    robot->mapCatalogue()->list([&](const Outcome<std::vector<map::CatalogueEntry>>& entries) {
      told = true;
      for (const map::CatalogueEntry& entry : entries.value_or(std::vector<map::CatalogueEntry>{})) {
        if (entry.is_current) key = entry.key;
      }
    });
    (void)QTest::qWaitFor([&] { return told; }, 30'000);
  }

  Adapter adapter_;
  QTemporaryDir folder_;
};

}  // namespace mapwright::robot::testing
