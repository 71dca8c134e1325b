// What the simulated robots answer over HTTP: pure of sockets, safe from any thread.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "simulator/bags.h"
#include "simulator/http_answer.h"
#include "simulator/made.h"
#include "simulator/maps.h"
#include "simulator/robot_state.h"
#include "simulator/submap_source.h"

namespace mapwright::simulator {

/// What the answers are made from. Outlives all that holds it.
struct Robot {
  const Options& options;
  RobotState& state;
  MapLibrary& library;
  MappingTasks& mappings;
  BagStore& bags;
  MadeOfScene& made;
  BodyCache& bodies;  // that are of this robot
  FaultPlan& faults;
};

/// A request as its route understands it.
struct Request {
  const HttpQuestion& question;
  std::string_view name;  // what stands in the path for the star or the id
  RequestFields fields;
};

/// One row of what the Autoxing robot answers (docs/protocols/autoxing.md, "Requests").
struct Route {
  enum class Body { Any, Json, JsonOrForm };

  std::string_view method;
  /// A star stands for anything without a slash, # for an id, without a dot too; a slash at the end may be
  /// left out.
  std::string_view path;
  HttpAnswer (*answer)(const Robot& robot, const Request& request);
  Body body = Body::Any;
};

/// Of maps, the current one, mapping tasks and static files.
std::span<const Route> mapRoutes();
/// Of bags, recordings and the bag player.
std::span<const Route> bagRoutes();

/// Of what the robot sees around it.
std::span<const Route> sightingRoutes();

/// The landmarks beside a part of a drive.
Value::List landmarksAlong(const Drive& drive, double from_m, double length_m);

/// A map's PNG with the effects of the faults.
std::string faultyPng(const std::string& png, const Faults& faults);

bool isSubmapPath(std::string_view path);

/// All that the Autoxing robot answers.
class AxbotRoutes : public Answerer {
 public:
  explicit AxbotRoutes(const Robot& robot) : Answerer(robot.faults), robot_(robot) {}

  bool isSlow(std::string_view path) const override { return path != "/device/info"; }
  bool opensTopics(std::string_view secret) const override;

 private:
  unsigned kindsOf(const HttpQuestion& question) const override;
  HttpAnswer answered(const HttpQuestion& question, const Verdict& verdict) override;
  HttpAnswer refused(const HttpQuestion& question, const Verdict& verdict) const override;
  HttpAnswer ignored(const HttpQuestion& question) override;
  HttpAnswer routed(const HttpQuestion& question);

  const Robot robot_;
};

/// What the Agibot robot keeps, and can be told to change where its firmware is newer.
struct AimdkState;

/// The Agibot robot's: JSON by POST to /rpc/<service>/<method>
/// (docs/protocols/agibot-aimdk.md). Its building is the Autoxing robot's.
class AimdkRoutes : public Answerer {
 public:
  explicit AimdkRoutes(const Robot& robot);
  ~AimdkRoutes() override;

  bool isSlow(std::string_view) const override { return true; }
  bool opensTopics(std::string_view) const override { return false; }

 private:
  unsigned kindsOf(const HttpQuestion& question) const override;
  HttpAnswer answered(const HttpQuestion& question, const Verdict& verdict) override;
  HttpAnswer refused(const HttpQuestion& question, const Verdict& verdict) const override;
  HttpAnswer ignored(const HttpQuestion& question) override;

  const std::unique_ptr<AimdkState> state_;
};

}  // namespace mapwright::simulator
