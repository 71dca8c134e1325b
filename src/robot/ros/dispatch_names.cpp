#include "robot/ros/dispatch_names.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <tuple>

#include "robot/ros/read_messages.h"

namespace mapwright::robot::ros {
namespace {

constexpr std::size_t kMostAsked = 60;
constexpr const char* kReadsProjections = "map_msgs/SetMapProjections";
constexpr const char* kChangesProjections = "map_msgs/ProjectedMapsInfo";

constexpr UsualService kUsual[] = {
    {DispatchService::Grid, "get_map", "nav_msgs/GetMap"},
    {DispatchService::GridRegion, "get_sub_map", "map_msgs/GetMapROI"},
    {DispatchService::Save, "save_map", "map_msgs/SaveMap"},
    {DispatchService::Cloud, "get_point_map", "map_msgs/GetPointMap"},
    {DispatchService::CloudRegion, "get_sub_point_map", "map_msgs/GetPointMapROI"},
    {DispatchService::Occupancy, "get_occupancy_map", "map_msgs/GetPointMap"},
    {DispatchService::OccupancyRegion, "get_sub_occupancy_map", "map_msgs/GetPointMapROI"},
    {DispatchService::ReadProjections, "set_map_projections", kReadsProjections},
};

const UsualService& usual(DispatchService service) {
  return *std::find_if(std::begin(kUsual), std::end(kUsual) - 1,
                       [&](const UsualService& one) { return one.service == service; });
}

std::string_view folderOf(std::string_view name) {
  const std::size_t slash = name.rfind('/');
  return slash == std::string_view::npos ? std::string_view() : name.substr(0, slash);
}

bool isWithin(std::string_view name, std::string_view ns) { return ns.empty() || isBelow(name, ns); }

/// A name that others use, too: not sufficient for a dispatcher.
bool isCommon(DispatchService service) {
  return service == DispatchService::Grid || service == DispatchService::Save;
}

/// Two services of one type, distinguished by name.
bool fitsByName(DispatchService service, std::string_view name) {
  using Service = DispatchService;
  const bool occupancy = lastPart(name).find("occup") != std::string_view::npos;
  if (service == Service::Cloud || service == Service::CloudRegion) return !occupancy;
  if (service == Service::Occupancy || service == Service::OccupancyRegion) return occupancy;
  return true;
}

/// The number after "…/projected_map_"; nullopt: another topic.
std::optional<int> numberOf(std::string_view topic, const DispatchSettings& settings) {
  const std::size_t line = topic.rfind('_');
  if (line == std::string_view::npos || topic.size() - line > 4) return std::nullopt;
  const std::string_view before = topic.substr(0, line), digits = topic.substr(line + 1);
  const bool named =
      settings.projected_map.empty() ? isWithin(topic, settings.ns) : before == settings.projected_map;
  int value = -1;
  const char* const end = digits.data() + digits.size();
  const bool whole = std::from_chars(digits.data(), end, value).ptr == end;
  return whole && named && value >= 0 && value < kMostProjected ? std::optional(value) : std::nullopt;
}

std::optional<Endpoint> best(const std::vector<Endpoint>& services, DispatchService wanted_service,
                             const DispatchSettings& settings, std::string_view only_type = {}) {
  const std::string wanted = nameBy(settings, wanted_service);
  const bool named = settings.names.contains(wanted_service);
  using Rank = std::tuple<bool, bool, bool, bool, std::size_t, std::string_view>;
  const Endpoint* found = nullptr;
  Rank least;
  for (const Endpoint& service : services) {
    const std::string type = dispatchType(service.type);
    const bool own_name =
        named ? service.name == wanted : lastPart(service.name) == usual(wanted_service).name;
    if ((named || isCommon(wanted_service)) && !own_name) continue;
    if (!named && !isWithin(service.name, settings.ns)) continue;
    const bool its_type = type == usual(wanted_service).type ||
                          (wanted_service == DispatchService::ReadProjections && type == kChangesProjections);
    const bool fits = type.empty() ? own_name && only_type.empty()
                                   : its_type && (own_name || fitsByName(wanted_service, service.name)) &&
                                         (only_type.empty() || type == only_type);
    if (!fits) continue;
    const Rank rank{service.name != wanted,
                    !isWithin(service.name, settings.near),
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

std::span<const UsualService> usualDispatchServices() { return kUsual; }

bool isProjected(const map::MapKey& key) {
  const std::string before = std::string(kProjectedMap) + '_';
  if (key.kind != map::MapKind::Stored || !key.id.starts_with(before)) return false;
  int index = 0;
  while (index < kMostProjected && key.id != before + std::to_string(index)) ++index;
  return index < kMostProjected;
}

std::string nameBy(const DispatchSettings& settings, DispatchService service) {
  const auto named = settings.names.find(service);
  return named != settings.names.end() ? named->second : settings.ns + '/' + usual(service).name;
}

std::vector<std::string> namesToTry(const DispatchSettings& settings, DispatchService service) {
  constexpr std::string_view kNode = "/map_dispatcher";
  const std::string usual_name = nameBy(settings, service);
  const bool is_private =
      service == DispatchService::Save && !settings.names.contains(service) && !settings.ns.ends_with(kNode);
  if (!is_private) return {usual_name};
  return {settings.ns + std::string(kNode) + '/' + usual(service).name, usual_name};
}

std::string dispatchType(std::string_view type) {
  const std::string plain = plainType(type);
  if (plain == "nav_msgs/GetPointMap" || plain == "nav_msgs/GetPointMapROI")
    return "map_msgs/" + std::string(lastPart(plain));
  const std::string_view short_form = "map_msg/";
  return plain.starts_with(short_form) ? "map_msgs/" + plain.substr(short_form.size()) : plain;
}

std::optional<Endpoint> Dispatcher::serviceOf(DispatchService service) const {
  const auto found = services.find(service);
  return found == services.end() ? std::nullopt : std::optional(found->second);
}

std::vector<DispatchOffer> Dispatcher::offers() const {
  std::vector<DispatchOffer> all;
  for (int i = 0; i <= int(DispatchService::ChangeProjections); ++i) {
    const auto service = DispatchService(i);
    const Endpoint found = serviceOf(service).value_or(Endpoint{});
    all.push_back({service, has(service), found.name, found.type});
  }
  return all;
}

std::vector<std::string> likeDispatchServices(const std::vector<std::string>& names,
                                              const DispatchSettings& settings) {
  std::vector<std::pair<std::tuple<bool, bool, std::size_t, std::string_view>, std::string>> like;
  for (const std::string& name : names) {
    if (name.empty() || name.size() > kLongestTopicName) continue;
    const bool named = std::any_of(settings.names.begin(), settings.names.end(),
                                   [&](const auto& one) { return one.second == name; });
    const std::string_view tail = lastPart(name);
    const bool exact = std::any_of(std::begin(kUsual), std::end(kUsual),
                                   [&](const UsualService& one) { return tail == one.name; });
    // A KABAM map manager's own services are about maps, but are not meant.
    const bool managers = folderOf(name).ends_with("/map_manager");
    const bool about_maps = !managers && (tail.find("map") != std::string_view::npos ||
                                          tail.find("roi") != std::string_view::npos ||
                                          tail.find("proj") != std::string_view::npos);
    const bool below = settings.expected && isBelow(name, settings.ns);
    if (!named && !exact && !about_maps && !below) continue;
    like.push_back({{!named, !exact, name.size(), name}, name});
  }
  std::sort(like.begin(), like.end());
  std::vector<std::string> some;
  for (std::size_t i = 0; i < like.size() && i < kMostAsked; ++i) some.push_back(like[i].second);
  return some;
}

Dispatcher dispatcherIn(const std::optional<std::vector<Endpoint>>& services,
                        const std::optional<std::vector<Endpoint>>& topics,
                        const DispatchSettings& settings) {
  Dispatcher found;
  if (!services && !settings.expected) return found;
  found.topics_known = topics.has_value();
  for (const auto& [service, name, type] : kUsual) {
    // Services are not listed: try it.
    if (!services) {
      found.services[service] = {namesToTry(settings, service).front(), {}};
    } else if (auto one = best(*services, service, settings)) {
      found.services[service] = std::move(*one);
    }
  }
  // The service for projections has two types, and each does only one thing.
  if (auto projections = found.serviceOf(DispatchService::ReadProjections)) {
    const auto of_type = [&](const char* type) {
      return services ? best(*services, DispatchService::ReadProjections, settings, type) : std::nullopt;
    };
    const auto reader = of_type(kReadsProjections), writer = of_type(kChangesProjections);
    if (reader && writer) {
      found.services[DispatchService::ReadProjections] = *reader;
      found.services[DispatchService::ChangeProjections] = *writer;
    } else if (dispatchType(projections->type) != kReadsProjections) {
      found.services[DispatchService::ChangeProjections] = std::move(*projections);
    }
  }
  // Names that map servers and others use are not sufficient for a dispatcher; next to a dispatcher, one
  // without a known type belongs to it.
  const bool real = std::any_of(found.services.begin(), found.services.end(),
                                [](const auto& one) { return !isCommon(one.first); });
  if (!real && !settings.expected) found.services.clear();
  for (const DispatchService service : {DispatchService::Grid, DispatchService::Save}) {
    const auto common = found.services.find(service);
    if (common == found.services.end() || !services || !common->second.type.empty()) continue;
    const std::string_view folder = folderOf(common->second.name);
    // `~save_map` lies one level below the others, under the node's name.
    const bool is_private = service == DispatchService::Save && !folder.ends_with("/map_manager");
    const bool beside = std::any_of(found.services.begin(), found.services.end(), [&](const auto& other) {
      const std::string_view of_other = folderOf(other.second.name);
      return !isCommon(other.first) && (of_other == folder || (is_private && of_other == folderOf(folder)));
    });
    if (!beside && !settings.names.contains(service)) found.services.erase(common);
  }
  if (!found.any() || !topics) return found;
  for (const Endpoint& topic : *topics) {
    if (topic.name.size() > kLongestTopicName) continue;
    const std::string type = dispatchType(topic.type);
    if (type == "nav_msgs/MapMetaData" && found.metadata.size() < 4) found.metadata.push_back(topic);
    if (type != "map_msgs/ProjectedMap") continue;
    const auto number = numberOf(topic.name, settings);
    if (!number) continue;
    Endpoint& kept = found.projected[*number];
    if (kept.name.empty() || topic.name.size() < kept.name.size()) kept = topic;
  }
  return found;
}

std::string projectedTopic(const DispatchSettings& settings, int index) {
  const std::string before =
      settings.projected_map.empty() ? settings.ns + '/' + kProjectedMap : settings.projected_map;
  return before + '_' + std::to_string(index);
}

}  // namespace mapwright::robot::ros
