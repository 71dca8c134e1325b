// The versions of overlays that commands have read or stored (history/version_store.h).
#pragma once

#include <string>
#include <vector>

#include <QString>
#include <tl/expected.hpp>

#include "app/robot_command.h"
#include "history/version_store.h"
#include "robot/overlay_store.h"

namespace mapwright::app {

/// Where they are: a file.
std::string overlaysHistory();

/// Keeps what a command sees of one map. What cannot be kept is a remark of the robot's.
class KeptOverlays {
 public:
  KeptOverlays(RobotReading& robot, map::MapKey map) : robot_(robot), map_(std::move(map)) {}
  void keep(const robot::OverlayText& text, bool saved);

 private:
  RobotReading& robot_;
  map::MapKey map_;
  bool failed_ = false;
};

struct WholeVersion {
  history::KeptVersion about;
  std::string text;
};
/// The newest first. `robot`: as typed, `map`: an id, uid or name; empty: all. Errors are sentences, here and
/// below.
tl::expected<std::vector<history::KeptVersion>, QString> keptVersions(const std::string& robot,
                                                                      const std::string& map);
tl::expected<WholeVersion, QString> keptVersion(const std::string& number);
/// The one before it of the same map; without text if it is the first.
tl::expected<WholeVersion, QString> versionBefore(const history::KeptVersion& version);
/// [{"number","robot","map","uid","name","version"|null,"at","kept":"read|saved","bytes"}], or a table.
void printVersions(const std::vector<history::KeptVersion>& versions, bool json);

}  // namespace mapwright::app
