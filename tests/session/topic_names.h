// What the robots of tests call what they send.
#pragma once

#include <map>

#include <QStringList>

#include "map/stream.h"

namespace mapwright::test {

inline const std::map<map::Stream, QStringList>& topicNames() {
  using map::Stream;
  static const std::map<Stream, QStringList> names{
      {Stream::Pose, {QStringLiteral("/tracked_pose")}},
      {Stream::Model, {QStringLiteral("/robot_model")}},
      {Stream::WholeMap, {QStringLiteral("/map_v2"), QStringLiteral("/map")}},
      {Stream::Incremental, {QStringLiteral("/incremental_map_v2")}},
      {Stream::EnvMatch, {QStringLiteral("/env_match_map")}},
      {Stream::EnvSymmetry, {QStringLiteral("/env_symmetry_map")}},
      {Stream::CostmapLow, {QStringLiteral("/maps/5cm/1hz")}},
      {Stream::CostmapHigh, {QStringLiteral("/maps/1cm/1hz")}},
      {Stream::MapInfo, {QStringLiteral("/map/info")}},
      {Stream::Landmarks, {QStringLiteral("/landmarks")}},
      {Stream::Doors, {QStringLiteral("/nearby_auto_doors")}},
      {Stream::Pallets, {QStringLiteral("/detected_pallets")}},
      {Stream::Racks, {QStringLiteral("/detected_rack")}},
      {Stream::SeenObjects, {QStringLiteral("/vision_detected_objects")}},
      {Stream::Constraints, {QStringLiteral("/constraint_list")}},
      {Stream::Trajectory, {QStringLiteral("/trajectory")}},
      {Stream::Path, {QStringLiteral("/path")}},
      {Stream::LocalPath, {QStringLiteral("/local_path")}},
      {Stream::Planning, {QStringLiteral("/planning_state")}},
      {Stream::Cloud, {QStringLiteral("/scan_matched_points2")}},
      {Stream::NearbyRobots, {QStringLiteral("/nearby_robots")}},
      {Stream::NearbyFootprints, {QStringLiteral("/nearby_robot_footprints")}},
      {Stream::Battery, {QStringLiteral("/battery_state")}},
      {Stream::Wheels, {QStringLiteral("/wheel_state")}},
      {Stream::Alerts, {QStringLiteral("/alerts")}},
      {Stream::Sensors, {QStringLiteral("/sensor_manager_state")}},
      {Stream::GlobalPositioning, {QStringLiteral("/global_positioning_state")}},
  };
  return names;
}

inline QStringList topicsOf(map::Stream stream) {
  const auto found = topicNames().find(stream);
  return found == topicNames().end() ? QStringList() : found->second;
}

inline QStringList topicsOf(const map::Streams& streams) {
  QStringList topics;
  for (const map::Stream stream : streams) topics += topicsOf(stream);
  return topics;
}

}  // namespace mapwright::test
