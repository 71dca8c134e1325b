#include "robot/ros/dispatch_names.h"

#include <algorithm>
#include <tuple>

#include "robot/ros/read_messages.h"

namespace mapwright::robot::ros {
namespace {

constexpr std::size_t kMostAsked = 60;

struct Usual {
  DispatchName name;
  const char* text;
  std::vector<std::string_view> types;
};
const std::vector<Usual>& usual() {
  static const std::vector<Usual> all{
      {DispatchName::GetMap, "get_map", {"nav_msgs/GetMap"}},
      {DispatchName::GetSubMap, "get_sub_map", {"map_msgs/GetMapROI"}},
      {DispatchName::SaveMap, "save_map", {"map_msgs/SaveMap"}},
      {DispatchName::GetPointMap, "get_point_map", {"map_msgs/GetPointMap"}},
      {DispatchName::GetSubPointMap, "get_sub_point_map", {"map_msgs/GetPointMapROI"}},
      {DispatchName::GetOccupancyMap, "get_occupancy_map", {"map_msgs/GetPointMap"}},
      {DispatchName::GetSubOccupancyMap, "get_sub_occupancy_map", {"map_msgs/GetPointMapROI"}},
      {DispatchName::SetMapProjections,
       "set_map_projections",
       {"map_msgs/SetMapProjections", "map_msgs/ProjectedMapsInfo"}}};
  return all;
}
const Usual& usual(DispatchName name) { return usual()[std::size_t(name)]; }

bool isOf(const Usual& one, std::string_view type) {
  return std::find(one.types.begin(), one.types.end(), type) != one.types.end();
}

std::string_view folderOf(std::string_view name) {
  const std::size_t slash = name.rfind('/');
  return slash == std::string_view::npos ? std::string_view() : name.substr(0, slash);
}

bool isBelow(std::string_view name, std::string_view ns) {
  return ns.empty() || (name.size() > ns.size() && name.starts_with(ns) && name[ns.size()] == '/');
}

/// A name that others use, too: not sufficient for a dispatcher.
bool isCommon(DispatchName name) { return name == DispatchName::GetMap || name == DispatchName::SaveMap; }

/// Two services of one type, distinguished by name.
bool fitsByName(DispatchName name, std::string_view service) {
  const bool occupancy = lastPart(service).find("occup") != std::string_view::npos;
  switch (name) {
    case DispatchName::GetPointMap:
    case DispatchName::GetSubPointMap:
      return !occupancy;
    case DispatchName::GetOccupancyMap:
    case DispatchName::GetSubOccupancyMap:
      return occupancy;
    default:
      return true;
  }
}

/// The number after "…/projected_map_"; nullopt: another topic.
std::optional<int> numberOf(std::string_view topic, const DispatchWish& wish) {
  const std::size_t line = topic.rfind('_');
  if (line == std::string_view::npos || topic.size() - line > 4) return std::nullopt;
  const std::string_view before = topic.substr(0, line), digits = topic.substr(line + 1);
  const bool number = !digits.empty() &&
                      std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; });
  const bool named = wish.projected_map.empty() ? isBelow(topic, wish.ns) : before == wish.projected_map;
  if (!number || !named) return std::nullopt;
  int value = 0;
  for (const char digit : digits) value = value * 10 + (digit - '0');
  return value < kMostProjected ? std::optional(value) : std::nullopt;
}

std::optional<TypedService> best(const std::vector<TypedService>& services, const Usual& one,
                                 const DispatchWish& wish, std::string_view only_type = {}) {
  const std::string wanted = nameBy(wish, one.name);
  const bool named = wish.names.contains(one.name);
  using Rank = std::tuple<bool, bool, bool, bool, std::size_t, std::string_view>;
  const TypedService* found = nullptr;
  Rank least;
  for (const TypedService& service : services) {
    const std::string type = dispatchType(service.type);
    const bool own_name = named ? service.name == wanted : lastPart(service.name) == one.text;
    if ((named || isCommon(one.name)) && !own_name) continue;
    if (!named && !wish.ns.empty() && !isBelow(service.name, wish.ns)) continue;
    const bool fits = type.empty() ? own_name && only_type.empty()
                                   : isOf(one, type) && (own_name || fitsByName(one.name, service.name)) &&
                                         (only_type.empty() || type == only_type);
    if (!fits) continue;
    const Rank rank{service.name != wanted,
                    !isBelow(service.name, wish.near),
                    !own_name,
                    type.empty(),
                    service.name.size(),
                    service.name};
    if (found && !(rank < least)) continue;
    found = &service;
    least = rank;
  }
  return found ? std::optional(*found) : std::nullopt;
}

}  // namespace

std::string nameBy(const DispatchWish& wish, DispatchName name) {
  const auto named = wish.names.find(name);
  return named != wish.names.end() ? named->second : wish.ns + '/' + usual(name).text;
}

const char* usualName(DispatchName name) { return usual(name).text; }

std::string dispatchType(std::string_view type) {
  const std::string plain = plainType(type);
  const std::string_view short_form = "map_msg/";
  return plain.starts_with(short_form) ? "map_msgs/" + plain.substr(short_form.size()) : plain;
}

bool FoundDispatch::has(DispatchService service) const { return serviceOf(service).has_value(); }

std::optional<TypedService> FoundDispatch::serviceOf(DispatchService service) const {
  const auto of = [this](DispatchName name) -> std::optional<TypedService> {
    const auto found = services.find(name);
    return found == services.end() ? std::nullopt : std::optional(found->second);
  };
  const auto projections = of(DispatchName::SetMapProjections);
  switch (service) {
    case DispatchService::Grid:
      return of(DispatchName::GetMap);
    case DispatchService::GridRegion:
      return of(DispatchName::GetSubMap);
    case DispatchService::Save:
      return of(DispatchName::SaveMap);
    case DispatchService::Cloud:
      return of(DispatchName::GetPointMap);
    case DispatchService::CloudRegion:
      return of(DispatchName::GetSubPointMap);
    case DispatchService::Occupancy:
      return of(DispatchName::GetOccupancyMap);
    case DispatchService::OccupancyRegion:
      return of(DispatchName::GetSubOccupancyMap);
    case DispatchService::ReadProjections:
      return projections;
    case DispatchService::ChangeProjections:
      break;
  }
  if (projections_writer) return projections_writer;
  if (!projections || dispatchType(projections->type) == "map_msgs/SetMapProjections") return std::nullopt;
  return projections;
}

std::vector<DispatchOffer> FoundDispatch::offers() const {
  using Service = DispatchService;
  std::vector<DispatchOffer> all;
  for (const Service service :
       {Service::Grid, Service::GridRegion, Service::Save, Service::Cloud, Service::CloudRegion,
        Service::Occupancy, Service::OccupancyRegion, Service::ReadProjections, Service::ChangeProjections}) {
    const auto found = serviceOf(service);
    all.push_back({service, found.has_value(), found ? found->name : std::string(),
                   found ? found->type : std::string()});
  }
  return all;
}

std::vector<std::string> likeDispatchServices(const std::vector<std::string>& names,
                                              const DispatchWish& wish) {
  std::vector<std::pair<std::tuple<bool, bool, std::size_t, std::string_view>, std::string>> like;
  for (const std::string& name : names) {
    if (name.empty() || name.size() > kLongestTopicName) continue;
    const bool named = std::any_of(wish.names.begin(), wish.names.end(),
                                   [&](const auto& one) { return one.second == name; });
    const std::string_view tail = lastPart(name);
    const bool exact =
        std::any_of(usual().begin(), usual().end(), [&](const Usual& one) { return tail == one.text; });
    // A KABAM map manager's own services are about maps, but are not meant.
    const bool managers = folderOf(name).ends_with("/map_manager");
    const bool about_maps = !managers && (tail.find("map") != std::string_view::npos ||
                                          tail.find("roi") != std::string_view::npos ||
                                          tail.find("proj") != std::string_view::npos);
    const bool below = wish.expected && !wish.ns.empty() && isBelow(name, wish.ns);
    if (!named && !exact && !about_maps && !below) continue;
    like.push_back({{!named, !exact, name.size(), name}, name});
  }
  std::sort(like.begin(), like.end());
  std::vector<std::string> some;
  for (std::size_t i = 0; i < like.size() && i < kMostAsked; ++i) some.push_back(like[i].second);
  return some;
}

FoundDispatch dispatchIn(const std::optional<std::vector<TypedService>>& services,
                         const std::optional<std::vector<FoundTopic>>& topics, const DispatchWish& wish) {
  FoundDispatch found;
  if (!services && !wish.expected) return found;
  found.topics_told = topics.has_value();
  for (const Usual& one : usual()) {
    // Services are not listed: try it.
    if (!services) {
      found.services[one.name] = {nameBy(wish, one.name), {}};
    } else if (auto service = best(*services, one, wish)) {
      found.services[one.name] = std::move(*service);
    }
  }
  const auto projections = found.services.find(DispatchName::SetMapProjections);
  if (services && projections != found.services.end()) {
    const Usual& one = usual(DispatchName::SetMapProjections);
    const auto reader = best(*services, one, wish, "map_msgs/SetMapProjections");
    const auto writer = best(*services, one, wish, "map_msgs/ProjectedMapsInfo");
    if (reader && writer) {
      projections->second = *reader;
      found.projections_writer = writer;
    }
  }
  // Names that map servers and others use are not sufficient for a dispatcher; next to a dispatcher, one
  // without a known type belongs to it.
  const bool real = std::any_of(found.services.begin(), found.services.end(),
                                [](const auto& one) { return !isCommon(one.first); });
  if (!real && !wish.expected) found.services.clear();
  for (const DispatchName name : {DispatchName::GetMap, DispatchName::SaveMap}) {
    const auto common = found.services.find(name);
    if (common == found.services.end() || !services || !common->second.type.empty()) continue;
    const bool beside = std::any_of(found.services.begin(), found.services.end(), [&](const auto& other) {
      return !isCommon(other.first) && folderOf(other.second.name) == folderOf(common->second.name);
    });
    if (!beside && !wish.names.contains(name)) found.services.erase(common);
  }
  if (!found.any() || !topics) return found;
  for (const FoundTopic& topic : *topics) {
    if (topic.name.size() > kLongestTopicName) continue;
    const std::string type = dispatchType(topic.type);
    if (type == "nav_msgs/MapMetaData" && found.metadata.size() < 4) found.metadata.push_back(topic);
    if (type != "map_msgs/ProjectedMap") continue;
    const auto number = numberOf(topic.name, wish);
    if (!number) continue;
    FoundTopic& kept = found.projected[*number];
    if (kept.name.empty() || topic.name.size() < kept.name.size()) kept = topic;
  }
  return found;
}

std::string projectedTopic(const DispatchWish& wish, int index) {
  const std::string before = wish.projected_map.empty() ? wish.ns + '/' + kProjectedMap : wish.projected_map;
  return before + '_' + std::to_string(index);
}

}  // namespace mapwright::robot::ros
