// What the simulated robots answer over HTTP: pure of sockets, safe from any thread.
#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "simulator/bag_store.h"
#include "simulator/fault_plan.h"
#include "simulator/http_answer.h"
#include "simulator/map_library.h"
#include "simulator/mapping_tasks.h"
#include "simulator/robot_state.h"
#include "simulator/simulator.h"
#include "simulator/submap_source.h"
#include "simulator/value.h"

namespace mapwright::simulator {

/// What the answers are made from. Outlives all that holds it.
struct Robot {
  const Options& options;
  RobotState& state;
  MapLibrary& library;
  MappingTasks& mappings;
  FaultPlan& faults;
};

// Parts of what the Autoxing robot answers (docs/protocols/autoxing.md, "Requests"); nullopt
// for paths that are not theirs.
/// The current map, the pose, the live overlays and what the wheels are told.
std::optional<HttpAnswer> chassisAnswer(const Robot& robot, const HttpQuestion& question);
/// What it tells about its make.
std::optional<HttpAnswer> deviceAnswer(const Robot& robot, const HttpQuestion& question);
/// Stored maps and static files.
std::optional<HttpAnswer> mapAnswer(const Robot& robot, const HttpQuestion& question);
std::optional<HttpAnswer> mappingAnswer(const Robot& robot, const HttpQuestion& question);

/// Bags, recordings and the bag player.
class BagRoutes {
 public:
  explicit BagRoutes(const Robot& robot) : robot_(robot), store_(robot.state, robot.options.bags.odd) {}

  std::optional<HttpAnswer> answer(const HttpQuestion& question);

 private:
  HttpAnswer collection(BagFolder folder, const HttpQuestion& question);
  HttpAnswer record(const HttpQuestion& question);
  HttpAnswer download(std::string bytes, std::string_view range) const;
  HttpAnswer file(BagFolder folder, std::string_view rest, const HttpQuestion& question);
  HttpAnswer player(const std::optional<Bag>& bag, const HttpQuestion& question);
  std::shared_ptr<const BagRecording> recordingOf(const Bag& bag);

  const Robot robot_;
  BagStore store_;
  std::mutex mutex_;
  std::list<std::pair<BagSpan, std::shared_ptr<const BagRecording>>>
      recordings_;  // the last few, newest first
};

bool isSubmapPath(std::string_view path);

/// All that the Autoxing robot answers.
class HttpRoutes : public Answerer {
 public:
  explicit HttpRoutes(const Robot& robot);

  HttpAnswer answer(const HttpQuestion& question) override;
  bool isSlow(std::string_view path) const override;
  bool opensTopics(std::string_view secret) const override;

 private:
  HttpAnswer write(const HttpQuestion& question);
  HttpAnswer routed(const HttpQuestion& question);
  HttpAnswer submap(const HttpQuestion& question);
  HttpAnswer image(const HttpQuestion& question);

  const Robot robot_;
  BodyCache bodies_;
  BagRoutes bags_;
};

/// The Agibot robot's: JSON by POST to /rpc/<service>/<method>
/// (docs/protocols/agibot-aimdk.md). Its building is the Autoxing robot's.
class AimdkRoutes : public Answerer {
 public:
  explicit AimdkRoutes(const Robot& robot) : library_(robot.library), faults_(robot.faults) {}

  HttpAnswer answer(const HttpQuestion& question) override;
  bool isSlow(std::string_view) const override { return true; }
  bool opensTopics(std::string_view) const override { return false; }

 private:
  Value storedMapNames() const;
  Value currentMap() const;
  Value wholeMap(const Value& map_id);
  Value topoMessages(const Value& map_id);

  MapLibrary& library_;
  const FaultPlan& faults_;
};

}  // namespace mapwright::simulator
