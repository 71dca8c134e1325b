// Parses the robot's answers about its maps, their overlays (GeoJSON, RFC 7946) and its submaps. Pure
// functions, any thread. Source: docs/protocols/autoxing.md, "Requests" (/maps, /mappings,
// /chassis/current-map, /ros/slam/map_image), "Overlays"; docs/protocols/cartographer-submaps.md, "Messages".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "map/catalogue.h"
#include "map/live_topics.h"
#include "map/overlay.h"
#include "map/submap.h"
#include "robot/map_transfer.h"
#include "robot/wire/read_json.h"

namespace ros_messages::slam {
class SubmapList;
}

namespace mapwright::robot::axbot {

/// The rows of a list of maps or mappings. Rows without an id are only counted.
struct MapRows {
  std::vector<map::CatalogueEntry> entries;
  int without_id = 0;
};
tl::expected<MapRows, Fault> parseMapRows(std::string_view body, map::MapKind kind);

/// The mapping of a list of mappings that is in progress; nullopt: none.
struct RunningMapping {
  map::MapKey key;
  std::optional<double> started_s;  // on the robot's clock
  std::optional<bool> continues;
};
tl::expected<std::optional<RunningMapping>, Fault> parseRunningMapping(std::string_view body);

/// One map or mapping with everything needed to get its picture. Addresses as in the answer.
struct MapDetail {
  map::CatalogueEntry entry;
  map::GridReference grid;  // as stated: NaN if missing
  std::string image_url, trajectories_url, landmarks_url;
  std::vector<map::OverlayFeature> overlays;
  std::vector<map::BrokenOverlay> broken_overlays;
  bool overlays_readable = true;
};
tl::expected<MapDetail, Fault> parseMapDetail(std::string_view body, const map::MapKey& key);

/// A stored map, with the overlays as they are written.
tl::expected<MapFacts, Fault> parseMapFacts(std::string_view body, const map::MapKey& key);
/// The id in the answer to a new map; empty: it tells none.
std::string parseNewId(std::string_view body);

/// The current map: id is empty if it was set from data (-1).
struct CurrentMap {
  std::string id, uid;
  bool is(const map::CatalogueEntry& entry) const;
};
CurrentMap parseCurrentMap(std::string_view body);

/// Lines of a trajectories.json; points of a landmarks.json. Unreadable entries are skipped.
std::vector<std::vector<Eigen::Vector2d>> parseTrajectories(std::string_view body);
std::vector<map::WholeMap::Landmark> parseLandmarks(std::string_view body);

/// A GetMapImageResponse: the picture with its position.
tl::expected<map::WholeMap, Fault> parseOverview(std::string_view body, double asked_resolution_m);

/// The features of a FeatureCollection, a Feature, a list of features, or a text containing one of these, in
/// the robot's order. Undrawable ones are skipped, and added to `broken`; open rings are closed; each part of
/// a Multi... geometry becomes a feature. nullopt: it is not GeoJSON. Nothing at all (null, a blank text) has
/// no features.
std::optional<std::vector<map::OverlayFeature>> parseOverlays(
    const wire::Json& overlays, std::vector<map::BrokenOverlay>* broken = nullptr);
std::optional<std::vector<map::OverlayFeature>> parseOverlays(
    std::string_view geo_json, std::vector<map::BrokenOverlay>* broken = nullptr);

/// Reads a SubmapQueryV2Response. Never throws: garbage becomes Outcome::Failed with a reason.
map::SubmapAnswer parseSubmapResponse(const map::SubmapKey& key, std::string_view body);

/// The list itself, or why it cannot be used: none of its rows can be read, or its submaps have no uuid.
map::TopicMessage usable(map::SubmapList list);

/// A binary /submap_list as values.
map::TopicMessage toSubmapList(const ros_messages::slam::SubmapList& message);

}  // namespace mapwright::robot::axbot
