// What of a robot's services and topics is a map dispatcher: by their types where the server tells them, else
// by their usual names. Pure. Source: docs/protocols/rep130-map-dispatcher.md.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/map_dispatch.h"
#include "robot/ros/ros_topics.h"

namespace mapwright::robot::ros {

/// The services of a dispatcher by the names that REP 130 has for them. That of the projections has two
/// types, of which each does one thing.
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

/// What people say of a dispatcher in an address.
struct DispatchWish {
  bool expected = false;                      // there must be one: what is silent is tried by its usual name
  std::string ns;                             // "/map_dispatcher"; empty = anywhere
  std::string near;                           // of several the one below this
  std::map<DispatchName, std::string> names;  // remapped ones: "/other/name"
  std::string projected_map;                  // the topics without "_0"; empty = as usual
  bool operator==(const DispatchWish&) const = default;
};

/// A service and its type as the server writes it, empty where it does not tell.
struct TypedService {
  std::string name, type;
  bool operator==(const TypedService&) const = default;
};

/// A dispatcher, as far as it is there.
struct FoundDispatch {
  std::map<DispatchName, TypedService> services;
  /// Where SetMapProjections and ProjectedMapsInfo are both there, the other one.
  std::optional<TypedService> projections_writer;
  std::map<int, FoundTopic> projected;  // by number
  std::vector<FoundTopic> metadata;     // nav_msgs/MapMetaData: tells of another map without sending it
  bool topics_told = false;             // what is not in these is not there
  bool operator==(const FoundDispatch&) const = default;

  bool any() const { return !services.empty(); }
  bool has(DispatchService service) const;
  std::optional<TypedService> serviceOf(DispatchService service) const;
  std::vector<DispatchOffer> offers() const;
};

/// "map_msgs/GetMapROI" of all that this type has been called: "map_msg/GetMapROI", "map_msgs/srv/GetMapROI".
std::string dispatchType(std::string_view type);
/// The services whose types are worth asking for.
std::vector<std::string> likeDispatchServices(const std::vector<std::string>& names,
                                              const DispatchWish& wish);
/// `services`: those of likeDispatchServices() with their types; nullopt: the server does not tell which
/// services there are. `topics` likewise.
FoundDispatch dispatchIn(const std::optional<std::vector<TypedService>>& services,
                         const std::optional<std::vector<FoundTopic>>& topics, const DispatchWish& wish);
/// The topic of a projected map that nobody tells of.
std::string projectedTopic(const DispatchWish& wish, int index);
/// Where it is called by: the one that was named, else the usual one.
std::string nameBy(const DispatchWish& wish, DispatchName name);
inline constexpr int kMostProjected = 32;

}  // namespace mapwright::robot::ros
