// Changes of the maps of an Autoxing robot. Lives on the link's thread. Source: docs/protocols/autoxing.md,
// "Requests".
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <QJsonObject>

#include "robot/axbot/map_requests.h"
#include "robot/map_administration.h"

namespace mapwright::robot::axbot {

/// Can stand in an address: a DELETE without an id would delete everything.
bool isPlainId(const std::string& id);

class MapChanges {
 public:
  using Task = wire::TaskPtr;
  /// `maps` outlives this.
  MapChanges(RobotServer server, MapRequests& maps) : server_(std::move(server)), maps_(maps) {}

  /// Sent once; then the robot is asked how it is now, also if the answer is lost.
  void carryOut(const Task& task, const MapOrder& order, OutcomeTo<map::CatalogueEntry> reply);

 private:
  struct Change;
  using ChangePtr = std::shared_ptr<Change>;
  /// Gets how it is now, and whether that is what was wanted.
  using Seen = std::function<void(Outcome<map::CatalogueEntry> now, bool holds)>;
  using Look = std::function<void(const ChangePtr& change, Seen seen)>;

  void send(const ChangePtr& change, net::HttpMethod method, const QString& path, const QJsonObject& body,
            Look look);
  void rename(const ChangePtr& change);
  void load(const ChangePtr& change);
  void remove(const ChangePtr& change);
  void startMapping(const ChangePtr& change);
  void stopMapping(const ChangePtr& change);
  void save(const ChangePtr& change);
  void saveMapping(const ChangePtr& change, const std::string& mapping);
  /// The map as it is now, and whether it is the current one.
  void lookAt(const Task& task, const map::MapKey& key, OutcomeTo<map::CatalogueEntry> reply);
  /// The robot's current map, without an id if there is none; `holds` if a mapping is running as `wanted`.
  Look lookForMapping(bool wanted);

  const RobotServer server_;
  MapRequests& maps_;
};

}  // namespace mapwright::robot::axbot
