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

#include "../../pbstream/state_bytes.h"
#include "answer_gate.h"
#include "grids/grid_pyramid.h"
#include "recording/append_file.h"
#include "recording/mcap_writer.h"
#include "robot/aimdk/aimdk_robot.h"
#include "robot/axbot/axbot_robot.h"
#include "robot/bag_library.h"
#include "robot/files/file_robot.h"
#include "robot/localization.h"
#include "robot/map_administration.h"
#include "robot/map_dispatch.h"
#include "robot/map_transfer.h"
#include "robot/pbstream/state_robot.h"
#include "robot/picture_store.h"
#include "robot/pose_graph_source.h"
#include "robot/recorded/recorded_robot.h"
#include "robot/ros/ros_robot.h"
#include "robot/waypoint_store.h"
#include "simulator/simulator.h"

namespace mapwright::robot::testing {

enum class Adapter { Axbot, Aimdk, AimdkNewer, Ros, Kabam, Rep130, Files, Recorded, State };

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
    } else if (adapter == Adapter::Recorded) {
      writeRecording();
      key = {map::MapKind::Stored, "12"};
      unknown = {map::MapKind::Stored, "17"};
    } else if (adapter == Adapter::State) {
      QFile state(statePath());
      (void)state.open(QIODevice::WriteOnly);
      state.write(QByteArray::fromStdString(mapwright::pbstream::tests::wholeFile()));
    } else {
      simulator::Options options;
      options.paused = true;
      options.faults = faults;
      options.aimdk.newer = adapter == Adapter::AimdkNewer;
      options.ros.kabam = adapter == Adapter::Kabam;
      options.ros.dispatcher.there = adapter == Adapter::Rep130;
      options.ros.dispatcher.edge_m = 20;
      robot_itself = std::make_unique<simulator::Simulator>(options);
      (void)robot_itself->start();
      const bool axbot = adapter == Adapter::Axbot;
      gate = std::make_unique<AnswerGate>(overRosbridge() ? robot_itself->rosPort()
                                          : axbot         ? robot_itself->port()
                                                          : robot_itself->aimdkPort());
      key = {map::MapKind::Stored, axbot ? "2" : "1764059676131"};
      if (adapter == Adapter::Ros || adapter == Adapter::Rep130) key = {map::MapKind::Live, {}};
      unknown = {map::MapKind::Stored, axbot ? "99" : "17"};
    }
    make();
    if (adapter == Adapter::Kabam) findCurrentMap();
    checkPicture();
  }

  /// It tells by itself what it is asked for, so much is at hand without a question.
  bool overRosbridge() const {
    return adapter_ == Adapter::Ros || adapter_ == Adapter::Kabam || adapter_ == Adapter::Rep130;
  }

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
  void make(std::chrono::milliseconds timeout = std::chrono::milliseconds(20'000)) {
    robot.reset();
    if (adapter_ == Adapter::Files) {
      files::FileOptions options;
      options.path = folder_.path();
      robot = std::make_unique<files::FileRobot>(QStringLiteral("file:test"), options);
      return;
    }
    if (adapter_ == Adapter::Recorded) {
      recorded::RecordedOptions options;
      options.path = recordingPath();
      robot = std::make_unique<recorded::RecordedRobot>(QStringLiteral("file:test.mcap"), options);
      return;
    }
    if (adapter_ == Adapter::State) {
      pbstream::StateOptions options;
      options.path = statePath();
      robot = std::make_unique<pbstream::StateRobot>(QStringLiteral("file:map.pbstream"), options);
      return;
    }
    if (overRosbridge()) {
      ros::LinkOptions options;
      options.url = QUrl(QStringLiteral("ws://127.0.0.1:%1").arg(gate->port()));
      options.kabam_only = adapter_ == Adapter::Kabam;
      options.dispatch.expected = adapter_ == Adapter::Rep130;
      robot = std::make_unique<ros::RosRobot>(QStringLiteral("ros+test"), options);
      robot->connectToRobot();
      (void)QTest::qWaitFor([this] { return robot->connection().phase == ConnectionPhase::Online; }, 30'000);
      return;
    }
    const QUrl base(QStringLiteral("http://127.0.0.1:%1").arg(gate->port()));
    if (adapter_ == Adapter::Axbot) {
      axbot::LinkOptions options;
      options.base = base;
      options.answer_timeout = options.fetch_timeout = timeout;
      robot = std::make_unique<axbot::AxbotRobot>(QStringLiteral("axbot+test"), options);
    } else {
      aimdk::LinkOptions options;
      options.base = base;
      options.timeout = options.map_timeout = timeout;
      robot = std::make_unique<aimdk::AimdkRobot>(QStringLiteral("aimdk+test"), options);
      if (adapter_ != Adapter::AimdkNewer) return;
      robot->connectToRobot();  // what it can do is told by its answers
      (void)QTest::qWaitFor([this] { return robot->waypointStore() != nullptr; }, 30'000);
    }
  }

  /// All that it can be asked, of the map that it has.
  std::vector<Question> questions() const {
    std::vector<Question> all;
    const auto passTo = [](const std::function<void(Ended)>& end) {
      return [end](const auto& outcome) { end(outcome ? Ended() : Ended(outcome.error())); };
    };
    if (auto* maps = robot->mapCatalogue()) {
      all.push_back({"list", [=](auto end) { return maps->list(passTo(end)); }});
      all.push_back({"describe", [=, of = key](auto end) { return maps->describe(of, passTo(end)); }});
      all.push_back({"thumbnail", [=, of = key](auto end) { return maps->thumbnail(of, passTo(end)); }});
    }
    if (auto* whole = robot->wholeMapSource())
      all.push_back({"whole map", [=, of = key](auto end) { return whole->fetch(of, passTo(end)); }});
    if (auto* overview = robot->overviewSource())
      all.push_back({"overview", [=](auto end) { return overview->fetchOverview(0.2, passTo(end)); }});
    if (auto* points = robot->waypointSource())
      all.push_back({"waypoints", [=, of = key](auto end) { return points->waypoints(of, passTo(end)); }});
    if (auto* store = robot->waypointStore())
      all.push_back({"stored waypoints", [=, of = key](auto end) { return store->read(of, passTo(end)); }});
    if (auto* submaps = robot->submapSource()) {
      const bool state = adapter_ == Adapter::State;
      const std::string uuid = robot_itself ? robot_itself->uuid()
                               : state ? mapwright::pbstream::readStateFile(statePath().toStdString())->uuid
                                       : std::string("u");
      all.push_back({"submap", [=](auto end) {
                       return submaps->fetch({uuid, {0, 0}, state ? 40 : 24},
                                             [end](const map::SubmapAnswer& answer) {
                                               using Outcome = map::SubmapAnswer::Outcome;
                                               map::Failure failure;
                                               failure.kind = answer.failure;
                                               if (answer.outcome == Outcome::Cancelled)
                                                 failure.kind = map::FailureKind::Cancelled;
                                               end(answer.outcome == Outcome::Ok ? Ended() : Ended(failure));
                                             });
                     }});
    }
    if (auto* graph = robot->poseGraphSource())
      all.push_back({"pose graph", [=](auto end) { return graph->fetch(passTo(end)); }});
    if (auto* dispatch = robot->mapDispatch()) {
      const map::GridRegion square{{0, 0}, {2, 2}};
      const map::CloudRegion box{{0, 0, 1}, 0, {2, 2, 2}};
      all.push_back({"region", [=](auto end) { return dispatch->grid(square, passTo(end)); }});
      all.push_back(
          {"points", [=](auto end) { return dispatch->cloud(CloudKind::Points, box, passTo(end)); }});
      all.push_back({"voxels", [=](auto end) {
                       return dispatch->cloud(CloudKind::Occupancy, std::nullopt, passTo(end));
                     }});
      all.push_back({"projections", [=](auto end) { return dispatch->projections(passTo(end)); }});
    }
    if (auto* bags = robot->bagLibrary(); bags && adapter_ == Adapter::Recorded) {
      const BagKey bag{BagKind::File, recorded::bagNameOf(recordingPath())};
      all.push_back({"bags", [=](auto end) { return bags->list(passTo(end)); }});
      all.push_back({"bag", [=](auto end) { return bags->info(bag, passTo(end)); }});
      all.push_back({"messages", [=](auto end) { return bags->messages(bag, {0, 100}, passTo(end)); }});
      all.push_back({"bag's removal", [=](auto end) { return bags->remove(bag, passTo(end)); }});
    }
    if (auto* pictures = robot->pictureStore()) {
      all.push_back({"picture",
                     [=, of = key, wanted = picture](auto end) {
                       return pictures->write({of, wanted.cells, wanted.revision}, passTo(end));
                     },
                     true});
    }
    if (auto* transfer = robot->mapTransfer()) {
      all.push_back({"parts", [=, of = key](auto end) { return transfer->parts(of, passTo(end)); }});
    }
    if (auto* maps = robot->mapAdministration()) {
      if (maps->tellsProgress())
        all.push_back({"mapping", [=](auto end) { return maps->progress(passTo(end)); }});
      all.push_back({"rename",
                     [=, of = key](auto end) {
                       return maps->carryOut({MapChange::Rename, of, "Lobby"}, passTo(end));
                     },
                     true});
      all.push_back({"load",
                     [=, of = key](auto end) {
                       return maps->carryOut({MapChange::Load, of}, passTo(end));
                     },
                     true});
    }
    return all;
  }

  /// The picture of the map that it has, to be written as it is.
  struct Picture {
    std::shared_ptr<const grids::GridPyramid> cells;  // null: it takes none
    std::string revision;
  };

  map::MapKey key, unknown;
  Picture picture;
  std::unique_ptr<simulator::Simulator> robot_itself;  // null: files
  std::unique_ptr<AnswerGate> gate;                    // null: files
  std::unique_ptr<Robot> robot;

 private:
  QString statePath() const { return folder_.filePath(QStringLiteral("map.pbstream")); }
  QString recordingPath() const { return folder_.filePath(QStringLiteral("test.mcap")); }
  /// A map with its places, a submap, a message.
  void writeRecording() const {
    auto target = recording::appendFile(recordingPath().toStdString(), recording::Existing::Replace);
    const auto writer = recording::McapWriter::create(std::move(*target), {});
    const auto attach = [&](const std::string& name, const std::string& bytes) {
      (void)(*writer)->attach({name, "application/octet-stream", 1, 0, bytes});
    };
    attach("maps/stored/12", "P5\n4 4\n255\n" + std::string(16, char(254)));
    attach("maps/stored/12.json", R"({"name":"Hall","grid":{"width":4,"height":4,"resolution_m":0.05}})");
    attach("waypoints/stored/12.json", R"({"waypoints":[]})");
    attach("submaps/u/0/0/24", std::string("\x10\x18", 2));
    recording::Channel channel;
    channel.topic = "/alerts";
    channel.message_encoding = "json";
    const std::string text = R"({"topic":"/alerts","alerts":[]})";
    (void)(*writer)->write(*(*writer)->addChannel(channel), {5, 5, 1},
                           {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    (void)(*writer)->close();
  }

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

  void checkPicture() {
    if (!robot->pictureStore()) return;
    bool told = false;
    robot->wholeMapSource()->fetch(key, [&](const Outcome<map::WholeMap>& map) {
      told = true;
      if (!map) return;
      picture.revision = map->fingerprint;
      grids::GridOptions options;
      options.reading = map->reading;
      auto reading =
          map->bytes ? grids::openGrid(map->bytes, options) : grids::openGridFile(map->path, options);
      if (!reading) return;
      (void)(*reading)->read(std::atomic<bool>(false), {});
      picture.cells = (*reading)->pyramid();
    });
    (void)QTest::qWaitFor([&] { return told; }, 30'000);
  }

  Adapter adapter_;
  QTemporaryDir folder_;
};

}  // namespace mapwright::robot::testing
