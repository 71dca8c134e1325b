// Finds the map dispatcher among a robot's services and topics: by type if the server gives types, otherwise
// by the usual names. Pure. Source: docs/protocols/rep130-map-dispatcher.md.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "map/catalogue.h"
#include "robot/map_dispatch.h"
#include "robot/ros/ros_topics.h"

namespace mapwright::robot::ros {

/// A service by the name and type that REP 130 gives it; that for projections stands under ReadProjections.
struct UsualService {
  DispatchService service;
  const char* name;
  const char* type;
};
std::span<const UsualService> usualDispatchServices();
inline constexpr const char* kProjectedMap = "projected_map";
inline constexpr int kMostProjected = 32;

/// The map of one of its projections, in the catalogue: "projected_map_0".
bool isProjected(const map::MapKey& key);

/// What an address says about the dispatcher.
struct DispatchSettings {
  bool expected = false;  // there must be one: services that are not listed are tried by their usual names
  std::string ns;         // "/map_dispatcher"; empty = anywhere
  std::string near;       // of several use the one in this namespace
  std::map<DispatchService, std::string> names;  // remapped ones: "/other/name"
  std::string projected_map;                     // the topics without "_0"; empty = the usual ones
  bool operator==(const DispatchSettings&) const = default;
};

/// The parts of a dispatcher that exist.
struct Dispatcher {
  std::map<DispatchService, Endpoint> services;
  std::map<int, Endpoint> projected;  // topics by number
  std::vector<Endpoint> metadata;     // nav_msgs/MapMetaData: reports a new map without sending it
  bool topics_known = false;          // topics that are not in these lists do not exist
  bool operator==(const Dispatcher&) const = default;

  bool any() const { return !services.empty(); }
  bool has(DispatchService service) const { return services.contains(service); }
  std::optional<Endpoint> serviceOf(DispatchService service) const;
  std::vector<DispatchOffer> offers() const;
};

/// "map_msgs/GetMapROI" for all known spellings of this type: "map_msg/GetMapROI", "map_msgs/srv/GetMapROI";
/// "map_msgs/GetPointMap" also for "nav_msgs/GetPointMap", as the REP writes it.
std::string dispatchType(std::string_view type);
/// The services whose types should be requested.
std::vector<std::string> likeDispatchServices(const std::vector<std::string>& names,
                                              const DispatchSettings& settings);
/// `services`: those of likeDispatchServices() with their types; nullopt: the server does not list services.
/// `topics` likewise.
Dispatcher dispatcherIn(const std::optional<std::vector<Endpoint>>& services,
                        const std::optional<std::vector<Endpoint>>& topics, const DispatchSettings& settings);
/// The topic of a projected map that is not listed.
std::string projectedTopic(const DispatchSettings& settings, int index);
/// The names by which to try a service that is not listed, better ones first: `~save_map` is a private name
/// of the node.
std::vector<std::string> namesToTry(const DispatchSettings& settings, DispatchService service);
/// Its name: the one given, otherwise the usual one.
std::string nameBy(const DispatchSettings& settings, DispatchService service);

}  // namespace mapwright::robot::ros
