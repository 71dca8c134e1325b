#include <algorithm>

#include "robot/axbot/faults.h"
#include "robot/axbot/parse_overlays.h"
#include "robot/axbot/topic_subjects.h"

namespace mapwright::robot::axbot {
namespace {

using wire::Json;

map::TopicMessage slamStatus(const Json& message) {
  map::SlamStatus status;
  status.state = wire::text(message, {"state"});
  status.reliable = wire::flag(message, {"reliable"});
  status.position_quality = wire::smallInteger(message, {"position_quality"});
  status.lidar_matching_score = wire::number(message, {"lidar_matching_score"});
  status.lidar_matched = wire::flag(message, {"lidar_matched"});
  status.wheel_slipping = wire::flag(message, {"wheel_slipping"});
  return status;
}

map::TopicMessage batteryState(const Json& message) {
  map::BatteryState state;
  if (auto level = wire::number(message, {"percentage", "level"})) {
    // Some firmware sends 0..1, some 0..100.
    if (*level > 1) *level /= 100;
    state.level = std::clamp(*level, 0.0, 1.0);
  }
  state.voltage_v = wire::number(message, {"voltage"});
  state.current_a = wire::number(message, {"current"});
  state.supply = wire::text(message, {"power_supply_status"});
  return state;
}

map::TopicMessage wheelState(const Json& message) {
  return map::WheelState{wire::text(message, {"control_mode"}),
                         wire::flag(message, {"emergency_stop_pressed", "emergency_stop"}),
                         wire::flag(message, {"wheels_released"})};
}

map::AlertLevel alertLevel(const Json& alert) {
  const std::string level = wire::text(alert, {"level"});
  if (level == "error" || level == "fatal" || level == "critical" || level == "2") {
    return map::AlertLevel::Error;
  }
  if (level == "warning" || level == "warn" || level == "1") return map::AlertLevel::Warning;
  return map::AlertLevel::None;
}

map::TopicMessage alerts(const Json& message) {
  map::AlertsMessage alerts;
  const auto rows = wire::member(message, {"alerts"});
  if (!rows) return alerts;
  wire::JsonList list;
  if (rows->get(list)) {
    return map::UnreadableMessage{"/alerts",
                                  {fault::MemberIsNoList, {"alerts"}, {}, Consequence::AlertsBeforeStay}};
  }
  for (const Json row : list) {
    if (!row.is_object()) continue;
    alerts.alerts.push_back({wire::integer(row, {"code"}).value_or(0), alertLevel(row),
                             wire::text(row, {"msg", "message", "text"}), 0});
  }
  return alerts;
}

map::TopicMessage mapInfo(const Json& message) {
  map::MapInfo info;
  info.name = wire::text(message, {"name", "map_name"});
  info.uid = wire::text(message, {"uid", "map_uid"});
  info.map_version = wire::smallInteger(message, {"map_version"});
  info.overlays_version = wire::smallInteger(message, {"overlays_version"});
  if (const auto overlays = wire::member(message, {"overlays"})) info.overlays = parseOverlays(*overlays);
  return info;
}

}  // namespace

MaybeMessage readStateTopic(const std::string& topic, const Json& message) {
  if (topic == "/slam/state") return slamStatus(message);
  if (topic == "/battery_state" || topic == "/detailed_battery_state") return batteryState(message);
  if (topic == "/wheel_state") return wheelState(message);
  if (topic == "/sensor_manager_state") return map::SensorState{wire::text(message, {"power_state"})};
  if (topic == "/alerts") return alerts(message);
  if (topic == "/map/info") return mapInfo(message);
  return std::nullopt;
}

}  // namespace mapwright::robot::axbot
