// Finds the map dispatcher among a robot's services and topics: by type if the server gives types, otherwise
// by the usual names. Pure. Source: docs/protocols/rep130-map-dispatcher.md.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/map_dispatch.h"
#include "robot/ros/ros_topics.h"

namespace mapwright::robot::ros {

/// The services of a dispatcher, named as in REP 130. The one for projections has two types, and each does
/// only one thing.
enum class DispatchName {
  GetMap,
  GetSubMap,
  SaveMap,
  GetPointMap,
  GetSubPointMap,
  GetOccupancyMap,
  GetSubOccupancyMap,
  SetMapProjections,
};
inline constexpr DispatchName kDispatchNames[] = {DispatchName::GetMap,
                                                  DispatchName::GetSubMap,
                                                  DispatchName::SaveMap,
                                                  DispatchName::GetPointMap,
                                                  DispatchName::GetSubPointMap,
                                                  DispatchName::GetOccupancyMap,
                                                  DispatchName::GetSubOccupancyMap,
                                                  DispatchName::SetMapProjections};
/// "get_sub_map".
const char* usualName(DispatchName name);
inline constexpr const char* kProjectedMap = "projected_map";

/// What an address says about the dispatcher.
struct DispatchWish {
  bool expected = false;  // there must be one: services that are not listed are tried by their usual names
  std::string ns;         // "/map_dispatcher"; empty = anywhere
  std::string near;       // of several use the one in this namespace
  std::map<DispatchName, std::string> names;  // remapped ones: "/other/name"
  std::string projected_map;                  // the topics without "_0"; empty = the usual ones
  bool operator==(const DispatchWish&) const = default;
};

/// A service and its type as the server writes it, empty if unknown.
struct TypedService {
  std::string name, type;
  bool operator==(const TypedService&) const = default;
};

/// The parts of a dispatcher that exist.
struct FoundDispatch {
  std::map<DispatchName, TypedService> services;
  /// If SetMapProjections and ProjectedMapsInfo both exist, the other one.
  std::optional<TypedService> projections_writer;
  std::map<int, FoundTopic> projected;  // by number
  std::vector<FoundTopic> metadata;     // nav_msgs/MapMetaData: reports a new map without sending it
  bool topics_told = false;             // topics that are not in these lists do not exist
  bool operator==(const FoundDispatch&) const = default;

  bool any() const { return !services.empty(); }
  bool has(DispatchService service) const;
  std::optional<TypedService> serviceOf(DispatchService service) const;
  std::vector<DispatchOffer> offers() const;
};

/// "map_msgs/GetMapROI" for all known spellings of this type: "map_msg/GetMapROI", "map_msgs/srv/GetMapROI".
std::string dispatchType(std::string_view type);
/// The services whose types should be requested.
std::vector<std::string> likeDispatchServices(const std::vector<std::string>& names,
                                              const DispatchWish& wish);
/// `services`: those of likeDispatchServices() with their types; nullopt: the server does not list services.
/// `topics` likewise.
FoundDispatch dispatchIn(const std::optional<std::vector<TypedService>>& services,
                         const std::optional<std::vector<FoundTopic>>& topics, const DispatchWish& wish);
/// The topic of a projected map that is not listed.
std::string projectedTopic(const DispatchWish& wish, int index);
/// Its name: the one given, otherwise the usual one.
std::string nameBy(const DispatchWish& wish, DispatchName name);
inline constexpr int kMostProjected = 32;

}  // namespace mapwright::robot::ros
