#include "simulator/topic_messages.h"

#include <array>
#include <limits>

#include "ros_messages/wrapper.pb.h"
#include "simulator/json_text.h"
#include "simulator/live_topics.h"

namespace mapwright::simulator {
namespace {

ros_messages::slam::SlamState wireOf(map::SlamState state) {
  switch (state) {
    case map::SlamState::Slam:
      return ros_messages::slam::SLAM_STATE_SLAM;
    case map::SlamState::Positioning:
      return ros_messages::slam::SLAM_STATE_POSITIONING;
    case map::SlamState::Invalid:
      break;
  }
  return ros_messages::slam::SLAM_STATE_INVALID;
}

}  // namespace

std::string submapListJson(const map::SubmapList& list) {
  std::string out;
  out.reserve(200 + list.entries.size() * 300);
  out += R"({"topic":"/submap_list","slam_state":)";
  appendJsonText(out, nameOf(list.slam_state));
  out += R"(,"uuid":)";
  appendJsonText(out, list.uuid);
  out += R"(,"submap":[)";
  const auto flag = [&](std::string_view key, bool value) {
    out += key;
    out += value ? "true" : "false";
  };
  bool first = true;
  for (const map::SubmapEntry& entry : list.entries) {
    out += first ? R"({"trajectory_id":)" : R"(,{"trajectory_id":)";
    first = false;
    out += std::to_string(entry.id.trajectory);
    out += R"(,"submap_index":)";
    out += std::to_string(entry.id.index);
    out += R"(,"submap_version":)";
    out += std::to_string(entry.version);
    out += R"(,"pose":)";
    char separator = '{';
    const geometry::Pose3& p = entry.pose;
    for (const auto& [key, value] : {std::pair{"\"x\":", p.x},
                                     {"\"y\":", p.y},
                                     {"\"z\":", p.z},
                                     {"\"qx\":", p.qx},
                                     {"\"qy\":", p.qy},
                                     {"\"qz\":", p.qz},
                                     {"\"qw\":", p.qw}}) {
      out += separator;
      separator = ',';
      out += key;
      appendJsonNumber(out, value);
    }
    flag(R"(},"is_frozen":)", entry.is_frozen);
    flag(R"(,"is_incremental_submap":)", entry.is_incremental);
    flag(R"(,"is_nearby_map":)", entry.is_nearby);
    out += '}';
  }
  out += "]}";
  return out;
}

std::string submapListBinary(const map::SubmapList& list) {
  ros_messages::RosMessageWrapper wrapper;
  wrapper.set_type(ros_messages::SUBMAP_LIST);
  ros_messages::slam::SubmapList& message = *wrapper.mutable_submap_list();
  message.set_slam_state(wireOf(list.slam_state));
  message.set_uuid(list.uuid);
  for (const map::SubmapEntry& entry : list.entries) {
    ros_messages::slam::SubmapEntry& row = *message.add_submaps();
    row.set_trajectory_id(entry.id.trajectory);
    row.set_submap_index(entry.id.index);
    row.set_submap_version(entry.version);
    ros_messages::Pose& pose = *row.mutable_pose();
    pose.set_x(entry.pose.x);
    pose.set_y(entry.pose.y);
    pose.set_z(entry.pose.z);
    pose.set_qx(entry.pose.qx);
    pose.set_qy(entry.pose.qy);
    pose.set_qz(entry.pose.qz);
    pose.set_qw(entry.pose.qw);
    row.set_is_frozen(entry.is_frozen);
    row.set_is_incremental_submap(entry.is_incremental);
    row.set_is_nearby_map(entry.is_nearby);
  }
  return binaryMessage(kSubmapListTopic, wrapper);
}

void addBadEntries(map::SubmapList& list) {
  const std::vector<map::SubmapEntry> good(
      list.entries.begin(), list.entries.begin() + std::min<std::ptrdiff_t>(2, std::ssize(list.entries)));
  map::SubmapEntry bad;
  bad.version = 1;
  bad.id = {90, 0};
  bad.pose.x = std::numeric_limits<double>::quiet_NaN();
  list.entries.push_back(bad);
  bad.id = {90, 1};
  bad.pose = {};
  bad.pose.qw = 0;
  list.entries.push_back(bad);
  if (!good.empty()) list.entries.push_back(good.front());
  if (good.size() > 1) {
    map::SubmapEntry back = good[1];
    back.version -= 1;
    list.entries.push_back(back);
  }
}

Frame TopicMessages::listMessage(bool binary, bool bad_entries) {
  const std::lock_guard lock(mutex_);
  const ListStamp stamp = state_.stamp();
  const std::string uuid = state_.uuid();
  if (stamp != stamp_ || uuid != uuid_ || bad_entries != bad_entries_) {
    json_ = binary_ = {};
    stamp_ = stamp;
    uuid_ = uuid;
    bad_entries_ = bad_entries;
  }
  Frame& frame = binary ? binary_ : json_;
  if (!frame.bytes) {
    map::SubmapList list = state_.list();
    if (bad_entries) addBadEntries(list);
    frame = {std::make_shared<const std::string>(binary ? submapListBinary(list) : submapListJson(list)),
             binary};
  }
  return frame;
}

std::optional<Frame> TopicMessages::messageOf(std::string_view topic, bool binary, bool bad_entries) {
  if (topic == kSubmapListTopic) return listMessage(binary, bad_entries);
  if (std::optional<std::string> own = ownTopic(topic, state_, library_.current()))
    return textFrame(std::move(*own));
  if (std::optional<std::string> around = surroundingsTopic(topic, state_))
    return textFrame(std::move(*around));
  if (std::optional<Frame> points = points_.messageOf(topic, binary)) return points;
  return maps_.messageOf(topic);
}

}  // namespace mapwright::simulator
