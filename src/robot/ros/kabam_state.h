// The state reported by a KABAM map manager on its latched topics: its maps, the current one, its waypoints.
// Pure. Source: docs/protocols/kabam-map-manager.md, "Topics".
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "map/live_topics.h"
#include "net/rosbridge/frame.h"
#include "robot/ros/kabam_messages.h"

namespace mapwright::robot::ros {

class KabamState {
 public:
  /// Sets their namespace ("/map_manager").
  void setNamespace(std::string ns) { ns_ = std::move(ns); }
  const std::string& ns() const { return ns_; }
  std::vector<std::string> topics() const;

  struct Update {
    bool own = false;      // it is one of these topics
    bool readable = true;  // and was understood
    bool maps = false;     // the list of maps, or the current one, has changed
    bool waypoints = false;
  };
  Update apply(const std::string& topic, const std::shared_ptr<const net::rosbridge::Frame>& frame,
               const Field& msg);
  void forget();

  /// Both lists and the current map have arrived.
  bool listed() const { return active_ && archived_ && current_; }
  /// Enough for a list if the rest stays silent.
  bool partlyListed() const { return active_.has_value() || archived_.has_value(); }
  /// Each map once: first the active ones, then the archived ones. Maps in both lists count as archived.
  std::vector<KabamMap> maps() const;
  std::optional<KabamMap> find(const std::string& id) const;
  std::vector<map::CatalogueEntry> entries() const;
  std::optional<map::CatalogueEntry> entry(const std::string& id) const;
  const std::optional<KabamCurrent>& current() const { return current_; }
  bool isMapping() const { return current_ && current_->state == "MAPPING"; }
  /// IDLE, MAPPING, ACTIVE, or any other value; empty while unknown.
  std::string managerState() const { return current_ ? current_->state : std::string(); }
  bool isCurrent(const std::string& id) const { return current_ && !id.empty() && current_->map.id == id; }
  /// Those of the current map; nullopt while the topic has not sent them, or lags.
  std::optional<StoredWaypoints> waypoints(const std::string& fixed_frame) const;
  /// The topic lags behind the robot's answers: its data is ignored for now.
  void distrustWaypoints() { waypoints_lag_ = true; }
  /// The current map for display.
  map::MapInfo mapInfo() const;

 private:
  std::string ns_ = "/map_manager";
  std::optional<std::vector<KabamMap>> active_, archived_;
  std::optional<KabamCurrent> current_;
  std::shared_ptr<const net::rosbridge::Frame> waypoints_frame_;
  Field waypoints_;
  bool waypoints_lag_ = false;
};

}  // namespace mapwright::robot::ros
