// Whole maps on their way from and to an Autoxing robot. Lives on the link's thread. Source:
// docs/protocols/autoxing.md, "Requests", "What changes a robot".
#pragma once

#include <memory>

#include "robot/axbot/map_requests.h"
#include "robot/map_transfer.h"

namespace mapwright::robot::axbot {

class TransferRequests {
 public:
  using Task = wire::TaskPtr;
  /// `maps` outlives this.
  TransferRequests(RobotServer server, MapRequests& maps) : server_(std::move(server)), maps_(maps) {}

  void parts(const Task& task, const map::MapKey& key, OutcomeTo<MapParts> reply);
  void download(const Task& task, const MapFacts& of, const QString& path, OutcomeTo<DataDownload> reply);
  void add(const Task& task, const NewMap& map, OutcomeTo<MapParts> reply);

 private:
  struct Addition;
  void facts(const Task& task, const map::MapKey& key, OutcomeTo<MapFacts> reply);
  using AdditionPtr = std::shared_ptr<Addition>;
  void send(const AdditionPtr& addition);
  /// Finds it among the maps that were not there before.
  void findNew(const AdditionPtr& addition, const std::string& told_id, std::optional<map::Failure> doubt);
  void readBack(const AdditionPtr& addition, const map::MapKey& key);

  const RobotServer server_;
  MapRequests& maps_;
};

}  // namespace mapwright::robot::axbot
