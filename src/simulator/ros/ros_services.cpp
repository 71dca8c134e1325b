#include "simulator/ros/ros_services.h"

#include <algorithm>

#include "simulator/ros/message_details.h"
#include "simulator/ros/shapes.h"
#include "simulator/ros/topic_table.h"

namespace mapwright::simulator::ros {
namespace {

constexpr std::string_view kManager = "/map_manager/", kRosapi = "/rosapi/";

template <typename Result>
Value codeOf(Result result) {
  return {static_cast<int>(result)};
}

Value resultOnly(UpdateResult result) { return Value::Object{{"result", codeOf(result)}}; }

Value triggered(bool done, std::string_view verb, std::string_view past) {
  return Value::Object{{"success", done},
                       {"message", done ? "Mapping " + std::string(past)
                                        : "Invalid request to " + std::string(verb) + " mapping"}};
}

}  // namespace

std::vector<Services::Row> Services::rows() const {
  const bool is_ros1 = options_.ros.dialect == RosDialect::Ros1;
  std::vector<Row> rows;
  if (!options_.ros.dispatcher.there)
    rows.push_back({is_ros1 ? "/static_map" : "/map_server/map", "nav_msgs/GetMap"});
  for (const Dispatcher::Row& row : dispatcher_.services()) rows.push_back({row.name, row.type});
  if (options_.ros.kabam) {
    for (const Row& row : {Row{"/map_manager/start_mapping", "std_srvs/Trigger"},
                           Row{"/map_manager/stop_mapping", "std_srvs/Trigger"},
                           Row{"/map_manager/save_map", "kabam_msgs/SaveMap"},
                           Row{"/map_manager/load_map", "kabam_msgs/LoadMap"},
                           Row{"/map_manager/delete_map", "kabam_msgs/UpdateMap"},
                           Row{"/map_manager/archive_map", "kabam_msgs/UpdateMap"},
                           Row{"/map_manager/rename_map", "kabam_msgs/UpdateMap"},
                           Row{"/map_manager/update_map_image", "kabam_msgs/UpdateMap"},
                           Row{"/map_manager/create_waypoint", "kabam_msgs/ManageWaypoint"},
                           Row{"/map_manager/delete_waypoint", "kabam_msgs/ManageWaypoint"},
                           Row{"/map_manager/rename_waypoint", "kabam_msgs/ManageWaypoint"},
                           Row{"/map_manager/reposition_waypoint", "kabam_msgs/ManageWaypoint"},
                           Row{"/map_manager/get_waypoint", "kabam_msgs/GetWaypoint"}})
      rows.push_back(row);
  }
  if (options_.ros.rosapi) {
    for (const Row& row :
         {Row{"/rosapi/topics", "rosapi/Topics"}, Row{"/rosapi/topic_type", "rosapi/TopicType"},
          Row{"/rosapi/topics_for_type", "rosapi/TopicsForType"}, Row{"/rosapi/services", "rosapi/Services"},
          Row{"/rosapi/service_type", "rosapi/ServiceType"}, Row{"/rosapi/nodes", "rosapi/Nodes"},
          Row{"/rosapi/message_details", "rosapi/MessageDetails"}})
      rows.push_back(row);
  }
  return rows;
}

std::string Services::typeOf(const Row& row) const {
  if (options_.ros.dialect == RosDialect::Ros2 && row.type.starts_with("rosapi/")) {
    return "rosapi_msgs/srv/" + std::string(row.type.substr(row.type.find('/') + 1));
  }
  std::string name = typeName(row.type, "srv", options_.ros.dialect);
  if (options_.ros.dispatcher.map_msg && name.starts_with("map_msgs/")) name.erase(7, 1);
  return name;
}

/// Those that there are now.
std::vector<TopicRow> Services::topics() const {
  std::vector<TopicRow> rows = topicTable(options_, faults_.faults().ros);
  const std::vector<Dispatcher::Row> own = dispatcher_.topics();
  std::erase_if(rows, [&](const TopicRow& row) {
    const auto& projected = Dispatcher::projectedTopics();
    if (std::find(projected.begin(), projected.end(), row.name) == projected.end()) return false;
    return std::none_of(own.begin(), own.end(),
                        [&](const Dispatcher::Row& there) { return there.name == row.name; });
  });
  return rows;
}

bool Services::has(std::string_view service) const {
  const std::vector<Row> all = rows();
  return std::any_of(all.begin(), all.end(), [&](const Row& row) { return row.name == service; });
}

CallOutcome Services::call(std::string_view name, const Value& args) {
  // ROS resolves names that are not whole; roslib asks for "rosapi/topics".
  const std::string service = name.starts_with('/') ? std::string(name) : '/' + std::string(name);
  const std::vector<Row> all = rows();
  const auto row =
      std::find_if(all.begin(), all.end(), [&](const Row& known) { return known.name == service; });
  if (row == all.end()) return {false, "Service " + service + " does not exist"};
  const std::string type = std::string(row->type) + "Request";
  const tl::expected<Value, std::string> request = args.as<Value::List>() != nullptr
                                                       ? types_.fromList(type, *args.as<Value::List>())
                                                       : types_.complete(type, args);
  if (!request) return {false, request.error()};
  if (dispatcher_.has(service)) return dispatcher_.call(service, *request);
  Value values = answer(service, *request);
  if (values.isNull())
    return {false, "service [" + service + "] responded with an error: b'there is no map'"};
  return {true, std::move(values)};
}

Value Services::answer(std::string_view service, const Value& request) {
  if (service.starts_with(kManager)) return answerManager(service.substr(kManager.size()), request);
  if (service.starts_with(kRosapi)) return answerRosapi(service.substr(kRosapi.size()), request);
  std::optional<Value> map = messages_.mapMessage();
  if (!map) return {};
  return Value::Object{{"map", std::move(*map)}};
}

Value Services::answerManager(std::string_view verb, const Value& request) {
  const std::string& map_id = request["map_id"].text();
  if (verb == "start_mapping") return triggered(kabam_.startMapping(), "start", "started");
  if (verb == "stop_mapping") return triggered(kabam_.stopMapping(), "stop", "stopped");
  if (verb == "save_map") {
    std::string id;
    const SaveResult result = kabam_.save(request["map_name"].text(), id);
    return Value::Object{{"result", codeOf(result)}, {"map_id", id}};
  }
  if (verb == "load_map")
    return Value::Object{{"result", codeOf(kabam_.load(map_id, request["loc_waypoint_name"].text()))}};
  if (verb == "delete_map") return resultOnly(kabam_.remove(map_id, request["delete_map"].flag()));
  if (verb == "archive_map") return resultOnly(kabam_.archive(map_id, request["set_archive"].flag()));
  if (verb == "rename_map") return resultOnly(kabam_.relabel(map_id, request["new_map_label"].text()));
  if (verb == "update_map_image") {
    const RosFaults faults = faults_.faults().ros;
    if (faults.picture_code > 0) return Value::Object{{"result", faults.picture_code}};
    if (faults.picture_ignored) return resultOnly(UpdateResult::Updated);
    return resultOnly(kabam_.replaceImage(map_id, request["updated_image"]));
  }
  if (verb == "get_waypoint") {
    return Value::Object{{"waypoints", waypointsOf(map_id, request["waypoint_id"].text())}};
  }
  const Value& info = request["waypoint_info"];
  Value shown = *types_.complete("kabam_msgs/MapWaypoint", {});
  const WaypointResult result = verb == "create_waypoint" ? kabam_.create(info, shown)
                                : verb == "delete_waypoint"
                                    ? kabam_.removeWaypoint(info, request["delete_waypoint"].flag(), shown)
                                : verb == "rename_waypoint" ? kabam_.rename(info, shown)
                                                            : kabam_.reposition(info, shown);
  return Value::Object{{"result", codeOf(result)}, {"waypoint_response", std::move(shown)}};
}

Value Services::waypointsOf(const std::string& map_id, const std::string& waypoint_id) const {
  const RosFaults faults = faults_.faults().ros;
  Value::List found;
  for (const KabamMap& map : kabam_.maps()) {
    if (map.id != map_id) continue;
    for (std::size_t i = 0; i < map.waypoints.size(); ++i) {
      if (waypoint_id.empty() || map.waypoints[i].id == waypoint_id)
        found.push_back(shownWaypoint(map.waypoints[i], map.id, i, faults));
    }
  }
  return Value::Object{{"waypoints", std::move(found)}};
}

Value Services::answerRosapi(std::string_view verb, const Value& request) const {
  const std::vector<TopicRow> topics = this->topics();
  Value::List names, types;
  if (verb == "topics") {
    for (const TopicRow& topic : topics) {
      names.emplace_back(topic.name);
      types.emplace_back(typeName(topic.type, "msg", options_.ros.dialect));
    }
    return Value::Object{{"topics", std::move(names)}, {"types", std::move(types)}};
  }
  if (verb == "message_details") return messageDetails(request["type"].text(), options_.ros.dialect);
  if (verb == "topic_type") {
    for (const TopicRow& topic : topics) {
      if (topic.name == request["topic"].text())
        return Value::Object{{"type", typeName(topic.type, "msg", options_.ros.dialect)}};
    }
    return Value::Object{{"type", ""}};
  }
  if (verb == "topics_for_type") {
    for (const TopicRow& topic : topics) {
      if (typeName(topic.type, "msg", options_.ros.dialect) == request["type"].text())
        names.emplace_back(topic.name);
    }
    return Value::Object{{"topics", std::move(names)}};
  }
  if (verb == "services") {
    for (const Row& row : rows()) names.emplace_back(row.name);
    return Value::Object{{"services", std::move(names)}};
  }
  if (verb == "service_type") {
    for (const Row& row : rows()) {
      if (row.name == request["service"].text()) return Value::Object{{"type", typeOf(row)}};
    }
    return Value::Object{{"type", ""}};
  }
  for (const char* node :
       {"/amcl", "/map_server", "/move_base", "/robot_state_publisher", "/rosbridge_websocket"})
    names.emplace_back(node);
  if (options_.ros.kabam) names.emplace_back("/map_manager");
  if (options_.ros.dispatcher.there) names.emplace_back("/map_dispatcher");
  if (options_.ros.rosapi) names.emplace_back("/rosapi");
  return Value::Object{{"nodes", std::move(names)}};
}

}  // namespace mapwright::simulator::ros
