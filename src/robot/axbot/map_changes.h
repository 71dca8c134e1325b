// Changes of the maps of an Autoxing robot. Lives on the link's thread. Source: docs/protocols/autoxing.md,
// "Requests".
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <QJsonObject>

#include "robot/axbot/map_requests.h"
#include "robot/map_administration.h"

namespace mapwright::robot::axbot {

class MapChanges {
 public:
  using Task = wire::TaskPtr;
  /// `maps` outlives this. `robot_now_s`: the time on the robot's own clock, seconds since the epoch; nullopt
  /// = not known.
  MapChanges(RobotServer server, MapRequests& maps, std::function<std::optional<double>()> robot_now_s)
      : server_(std::move(server)), maps_(maps), robot_now_s_(std::move(robot_now_s)) {}

  /// Sent once; then the robot is asked how it is now, also if the answer is lost.
  void carryOut(const Task& task, const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply);
  void progress(const Task& task, OutcomeTo<std::optional<MappingProgress>> reply);

 private:
  struct Change;
  using ChangePtr = std::shared_ptr<Change>;
  void begin(const ChangePtr& change);
  /// Gets how it is now, and whether that is what was wanted.
  using Seen = std::function<void(Outcome<map::CatalogueEntry> now, bool holds)>;
  using Look = std::function<void(const ChangePtr& change, Seen seen)>;

  void send(const ChangePtr& change, net::HttpMethod method, const QString& path, const QJsonObject& body,
            Look look);
  void rename(const ChangePtr& change);
  void load(const ChangePtr& change);
  void remove(const ChangePtr& change);
  void startMapping(const ChangePtr& change, bool continues);
  void endMapping(const ChangePtr& change, const QString& state);
  void save(const ChangePtr& change);
  void saveMapping(const ChangePtr& change, const std::string& mapping);
  /// The map as it is now, and whether it is the current one.
  void lookAt(const Task& task, const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply);
  /// The robot's current map, without an id if there is none; `holds` if a mapping is running as `wanted`.
  Look lookForMapping(bool wanted);

  const RobotServer server_;
  MapRequests& maps_;
  const std::function<std::optional<double>()> robot_now_s_;
};

}  // namespace mapwright::robot::axbot
