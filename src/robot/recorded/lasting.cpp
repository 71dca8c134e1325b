#include "robot/recorded/lasting.h"

#include <algorithm>
#include <cstring>
#include <deque>
#include <functional>
#include <utility>

#include "recorder/layout.h"
#include "robot/axbot/parse_topics.h"
#include "robot/recorded/foxglove.h"
#include "robot/ros/drawn_messages.h"
#include "robot/ros/read_messages.h"
#include "robot/ros/robot_transforms.h"

namespace mapwright::robot::recorded {
namespace {

using recording::Message;
using recording::secondsOf;

constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max(),
                       kDeleted = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t kCheckpointEveryNs = 8'000'000'000;
constexpr std::size_t kMostCheckpointEntries = std::size_t(1) << 20;  // of all: some 100 MB
constexpr std::int64_t kLateNs = 1'000'000'000;  // how much later transforms are used (BlockPlacing)
constexpr std::size_t kMostLookedInto = std::size_t(32)
                                        << 20;  // larger messages are not read for their stamp
constexpr double kSameTimeS = 1e-6;             // as for ros::Transforms

/// Sent to whoever comes later, too: of ROS 2 by its quality of service, of ROS 1 by its connection.
bool isLatched(const recording::Channel& channel) {
  const auto value = [&](const char* name) {
    const auto found = channel.metadata.find(name);
    return found == channel.metadata.end() ? std::string_view() : std::string_view(found->second);
  };
  if (value("latching") == "1") return true;
  const std::string_view qos = value("offered_qos_profiles");
  if (qos.find("transient_local") != qos.npos) return true;
  const std::size_t at = qos.find("durability: 1");
  return at != qos.npos && (at + 13 == qos.size() || qos[at + 13] < '0' || qos[at + 13] > '9');
}

bool isTransforms(const std::string& type) { return type == "tf2_msgs/TFMessage" || type == "tf/tfMessage"; }

bool isMarkers(const std::string& type) {
  return type == "visualization_msgs/MarkerArray" || type == "visualization_msgs/Marker";
}

/// Topics of Autoxing robots whose messages change more than what the last one says.
bool lastsByContent(const std::string& topic) {
  if (topic == "/submap_list") return true;
  for (const map::Stream stream : {map::Stream::MapInfo, map::Stream::NearbyFootprints}) {
    const axbot::StreamTopics of = axbot::topicsOf(stream);
    if ((of.usual + of.older).contains(QString::fromStdString(topic))) return true;
  }
  return false;
}

/// Also of what is drawn like markers.
ros::Read<std::vector<ros::Marker>> markersIn(const net::rosbridge::Frame& frame, const Message& message) {
  const std::string type = ros::plainType(rosTypeOf(*message.channel));
  return ros::isDrawn(type) ? ros::readDrawn(type, frame.root(), message.channel->topic)
                            : ros::readMarkers(frame.root());
}

std::uint64_t contentOf(const ros::TfRow& row) {
  std::uint64_t hash = std::hash<std::string>()(row.parent);
  const auto add = [&](double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15ULL;
    hash ^= hash >> 29;
  };
  for (Eigen::Index i = 0; i < 3; ++i) add(row.transform.t_m[i]);
  for (Eigen::Index i = 0; i < 4; ++i) add(row.transform.q.coeffs()[i]);
  return hash;
}

}  // namespace

std::int64_t saidNs(const Message& message) {
  const auto at = message.channel->metadata.find(recorder::kSaidAt);
  const bool told = at != message.channel->metadata.end() && at->second == recorder::kPublishTime;
  return told && message.publish_time_ns > 0 ? std::min(message.publish_time_ns, message.log_time_ns)
                                             : message.log_time_ns;
}

std::vector<LastingTopic> lastingTopics(const recording::Source& file, const RosShape& shape) {
  std::map<std::string, std::set<Lasts>> lasting;
  std::map<std::string, std::string> base_of;
  for (const recording::ChannelPtr& channel : file.channels()) {
    std::set<Lasts>& lasts = lasting[channel->topic];
    if (!shape.isRos(*channel)) {
      if (channel->message_encoding == "json" && lastsByContent(channel->topic))
        lasts = {Lasts::UntilNext, Lasts::Autoxing};
      continue;
    }
    const std::string type = ros::plainType(rosTypeOf(*channel));
    const auto drawn = shape.by_topic.find(channel->topic);
    bool transforms = isTransforms(type), moving = false;
    if (isMarkers(type)) lasts.insert(Lasts::PerMarker);
    if (drawn != shape.by_topic.end()) {
      for (const ros::Source& source : drawn->second) {
        if (source.form == ros::Form::Markers) lasts.insert(Lasts::PerMarker);
        transforms |= source.form == ros::Form::StaticTf;
        moving |= source.form == ros::Form::Tf;
        // One message may be drawn in two ways.
        const bool last = source.form != ros::Form::Markers && source.form != ros::Form::StaticTf &&
                          source.form != ros::Form::Tf && source.form != ros::Form::GridPatch;
        if (last) lasts.insert(Lasts::UntilNext);
      }
    } else {
      moving = transforms && ros::lastPart(channel->topic) != "tf_static";
    }
    if (moving) lasts.insert(Lasts::Transforms);
    if (transforms && (!moving || isLatched(*channel))) lasts.insert(Lasts::PerChild);
    constexpr std::string_view kUpdates = "_updates";
    if (type == "map_msgs/OccupancyGridUpdate" && channel->topic.ends_with(kUpdates)) {
      lasts.insert(Lasts::Patches);
      base_of[channel->topic] = channel->topic.substr(0, channel->topic.size() - kUpdates.size());
    }
  }
  for (const auto& [grid, patches] : shape.patches_of) {
    if (!lasting.contains(patches)) continue;
    lasting[patches].insert(Lasts::Patches);
    base_of[patches] = grid;
  }
  std::vector<LastingTopic> topics;
  for (const auto& [topic, lasts] : lasting) {
    if (lasts.empty()) topics.push_back({topic, Lasts::UntilNext});
    for (const Lasts one : lasts)
      topics.push_back({topic, one, one == Lasts::Patches ? base_of.at(topic) : std::string()});
  }
  return topics;
}

std::vector<LastingTopic> placingTopics(const recording::Source& file, const RosShape& shape) {
  std::vector<LastingTopic> topics = lastingTopics(file, shape);
  std::erase_if(topics, [&](const LastingTopic& topic) {
    if (topic.lasts == Lasts::Patches || !shape.by_topic.contains(topic.topic)) return true;
    return topic.lasts == Lasts::UntilNext &&
           std::find(shape.poses.begin(), shape.poses.end(), topic.topic) == shape.poses.end();
  });
  return topics;
}

Lasting::Lasting(recording::Source& file, MessageFields& fields, std::vector<LastingTopic> topics,
                 const RosShape& shape)
    : file_(file), fields_(fields) {
  reset(std::move(topics), shape);
}

void Lasting::reset(std::vector<LastingTopic> topics, const RosShape& shape) {
  topics_ = std::move(topics);
  robots_ =
      shape.robots.size() > 1 ? shape.robots : std::vector<std::string>();  // one needs no names of its own
  fixed_frame_ = shape.fixed_frame;
  by_topic_.clear();
  indexed_.clear();
  transforms_.clear();
  for (std::uint32_t i = 0; i < topics_.size(); ++i) {
    // Its positions are those of its first entry; a topic may have several.
    by_topic_.try_emplace(topics_[i].topic, i);
    const Lasts lasts = topics_[i].lasts;
    if (lasts == Lasts::Transforms) transforms_.push_back(topics_[i].topic);
    if (lasts != Lasts::UntilNext && lasts != Lasts::Transforms && lasts != Lasts::Patches)
      indexed_.push_back(topics_[i].topic);
  }
  state_ = {};
  cursor_.reset();
  counted_.clear();
  checkpoints_.clear();
  checkpoint_entries_ = since_checkpoint_ = deleted_ = cleaned_ = 0;
  statics_.clear();
  frames_.clear();
  placed_by_.clear();
}

void Lasting::forgetFrom(std::int64_t at_ns) {
  cursor_.reset();
  const auto gone = checkpoints_.upper_bound(at_ns);
  for (auto it = gone; it != checkpoints_.end(); ++it) checkpoint_entries_ -= weightOf(*it->second);
  checkpoints_.erase(gone, checkpoints_.end());
  if (state_.until_ns > at_ns) state_ = checkpoints_.empty() ? State() : *checkpoints_.rbegin()->second;
  // Transforms may have come since.
  placed_by_.clear();
}

std::uint32_t Lasting::nameOf(const std::string& name) {
  return names_.try_emplace(name, std::uint32_t(names_.size())).first->second;
}

/// Several robots may have frames of the same name.
std::string Lasting::frameOfRobot(const std::string& topic, const std::string& frame) const {
  return ros::namespaceAmong(robots_, topic) + '\n' + ros::frameName(frame);
}

Lasting::Position Lasting::positionOf(const Message& message, std::uint32_t topic) {
  auto& [at_ns, count] = counted_[topic];
  if (at_ns != message.log_time_ns) count = 0;
  at_ns = message.log_time_ns;
  return {message.log_time_ns, topic, count++};
}

bool Lasting::reach(std::int64_t at_ns, int most) {
  if (indexed_.empty()) return true;
  if (state_.until_ns == at_ns && !cursor_) return true;
  if (!cursor_ || target_ns_ != at_ns) {
    // What has been applied of a time is applied again, which changes nothing.
    const auto after = checkpoints_.upper_bound(at_ns);
    const bool back = state_.until_ns > at_ns;
    if (after != checkpoints_.begin()) {
      const State& nearest = *std::prev(after)->second;
      if (back || nearest.until_ns > state_.until_ns) {
        state_ = nearest;
        since_checkpoint_ = 0;
      }
    } else if (back) {
      state_ = {};
      since_checkpoint_ = 0;
    }
    target_ns_ = at_ns;
    recording::Query query;
    query.first_ns = state_.until_ns;
    query.last_ns = at_ns - 1;
    query.topics = indexed_;
    counted_.clear();
    cursor_.reset();
    if (query.first_ns <= query.last_ns) cursor_ = file_.messages(query);
  }
  for (; cursor_; --most) {
    if (most <= 0) return false;
    const auto message = cursor_->next();
    if (!message) break;
    apply(*message);
  }
  cursor_.reset();
  state_.until_ns = at_ns;
  keepCheckpoint();
  return true;
}

void Lasting::apply(const Message& message) {
  const auto known = by_topic_.find(message.channel->topic);
  if (known == by_topic_.end()) return;
  if (message.log_time_ns > state_.until_ns) {
    state_.until_ns = message.log_time_ns;
    keepCheckpoint();
    dropDeleted();
  }
  const Position position = positionOf(message, known->second);
  for (std::uint32_t i = known->second; i < topics_.size() && topics_[i].topic == known->first; ++i) {
    if (topics_[i].lasts == Lasts::PerChild) applyTransforms(message, position);
    if (topics_[i].lasts == Lasts::PerMarker) applyMarkers(message, position);
    if (topics_[i].lasts == Lasts::Autoxing) applyFrame(message, position);
  }
}

void Lasting::applyTransforms(const Message& message, const Position& position) {
  const auto frame = fields_.read(message);
  if (!frame) return;  // it is reported where it is played
  for (const ros::TfRow& row : ros::readTf((*frame)->root())) {
    if (!ros::Transforms::isUsable(row.parent, row.child, row.transform)) continue;  // the one before stays
    const std::uint64_t content = contentOf(row);
    const auto [entry, is_new] =
        state_.entries.try_emplace({kTransform, nameOf(frameOfRobot(message.channel->topic, row.child)), 0});
    // Whoever repeats it adds nothing.
    if (!is_new && entry->second.content == content) continue;
    entry->second = {position, kNever, content};
    statics_[entry->first.name].emplace(saidNs(message), position);
    ++since_checkpoint_;
  }
}

void Lasting::applyMarkers(const Message& message, const Position& position) {
  const auto frame = fields_.read(message);
  const auto markers = frame ? markersIn(**frame, message) : tl::unexpected(Fault());
  if (!markers) return;
  state_.any_markers = true;
  const std::int64_t at_ns = saidNs(message);
  for (const ros::Marker& marker : *markers) {
    const Key key{position.topic, nameOf(marker.ns), marker.id};
    ++since_checkpoint_;
    switch (marker.action) {
      case ros::Marker::Action::Add: {
        const bool ends = marker.lifetime_s > 0 && marker.lifetime_s < 1e9;
        state_.entries[key] = {position, ends ? at_ns + recording::nanosecondsOf(marker.lifetime_s) : kNever,
                               0};
        break;
      }
      case ros::Marker::Action::Delete:
        if (const auto entry = state_.entries.find(key); entry != state_.entries.end()) {
          entry->second = {position, kDeleted, 0};
          ++deleted_;
        }
        break;
      case ros::Marker::Action::DeleteAll:
        state_.entries.erase(state_.entries.lower_bound({position.topic, 0, kDeleted}),
                             state_.entries.lower_bound({position.topic + 1, 0, kDeleted}));
        break;
    }
  }
}

/// The first message of a session or map, and that of the one before it: it forgets what lay in that one.
void Lasting::applyFrame(const Message& message, const Position& position) {
  const auto* const text = reinterpret_cast<const char*>(message.bytes.data());
  const axbot::TextFrame frame = axbot::parseTextFrame({text, message.bytes.size()});
  if (!frame.message) return;
  const auto begins = [&](const std::string& what) {
    Entry& now = state_.entries[{position.topic, 0, 0}];
    const std::uint64_t content = std::hash<std::string>()(what) | 1;
    if (now.content == content) return;
    if (now.content != 0) state_.entries[{position.topic, 0, 1}] = now;
    now = {position, kNever, content};
    ++since_checkpoint_;
  };
  if (const auto* list = std::get_if<map::SubmapList>(&*frame.message)) {
    if (!list->uuid.empty()) begins(list->uuid);
  } else if (const auto* info = std::get_if<map::MapInfo>(&*frame.message)) {
    begins(info->uid + '\n' + info->name + '\n' + std::to_string(info->map_version.value_or(0)));
  } else if (const auto* outlines = std::get_if<map::NearbyFootprintsMessage>(&*frame.message)) {
    for (const auto& [digest, outline] : outlines->by_digest) {
      state_.entries[{position.topic, nameOf(digest), 2}] = {position, kNever, 0};
      ++since_checkpoint_;
    }
  }
}

bool Lasting::isMarker(const Key& key) const {
  if (key.topic >= topics_.size()) return false;
  for (std::uint32_t i = key.topic; i < topics_.size() && topics_[i].topic == topics_[key.topic].topic; ++i) {
    if (topics_[i].lasts == Lasts::PerMarker) return true;
  }
  return false;
}

void Lasting::keepCheckpoint() {
  const auto after = checkpoints_.upper_bound(state_.until_ns);
  if (after != checkpoints_.begin()) {
    // Much of the time little has changed.
    const bool soon = state_.until_ns - std::prev(after)->first < kCheckpointEveryNs;
    if (soon || since_checkpoint_ == 0 || since_checkpoint_ < state_.entries.size() / 4) return;
  }
  since_checkpoint_ = 0;
  if (!checkpoints_.emplace(state_.until_ns, std::make_shared<const State>(state_)).second) return;
  checkpoint_entries_ += weightOf(state_);
  while (checkpoint_entries_ > kMostCheckpointEntries && checkpoints_.size() > 2) {
    // Every second one goes: then it takes longer to go back.
    for (auto it = std::next(checkpoints_.begin()); it != checkpoints_.end();) {
      checkpoint_entries_ -= weightOf(*it->second);
      it = checkpoints_.erase(it);
      if (it != checkpoints_.end()) ++it;
    }
  }
}

/// That a marker is deleted counts while it lies in a message with others that are not. Those whose lifetime
/// has ended are of no more use.
void Lasting::dropDeleted() {
  const std::size_t size = state_.entries.size();
  if (deleted_ < 5000 + size / 2 && size < 5000 + 2 * cleaned_) return;
  Found found;
  const std::set<Position> kept = live(state_.until_ns, found);
  const std::int64_t now_ns = state_.until_ns;
  std::erase_if(state_.entries, [&](const auto& entry) {
    return entry.second.until_ns <= now_ns && !kept.contains(entry.second.position);
  });
  deleted_ = 0;
  cleaned_ = state_.entries.size();
  frames_.clear();
}

std::optional<std::int64_t> Lasting::nextMarkerEnd() const {
  std::optional<std::int64_t> next;
  for (const auto& [key, entry] : state_.entries) {
    if (entry.until_ns == kNever || entry.until_ns <= state_.until_ns) continue;
    next = std::min(next.value_or(entry.until_ns), entry.until_ns);
  }
  return next;
}

void Lasting::read(const std::set<Position>& positions, Found& found) {
  for (auto position = positions.begin(); position != positions.end();) {
    const std::int64_t at_ns = position->log_ns;
    std::set<Position> wanted;
    recording::Query query;
    query.first_ns = query.last_ns = at_ns;
    for (; position != positions.end() && position->log_ns == at_ns; ++position) {
      if (found.contains(*position)) continue;
      wanted.insert(*position);
      query.topics.push_back(topics_[position->topic].topic);
    }
    if (wanted.empty()) continue;
    std::map<std::string, std::uint32_t> counted;
    const auto cursor = file_.messages(query);
    for (std::size_t left = wanted.size(); left > 0;) {
      auto message = cursor->next();
      if (!message) break;
      const std::string& topic = message->channel->topic;
      const Position here{at_ns, by_topic_.at(topic), counted[topic]++};
      if (!wanted.contains(here)) continue;
      found.emplace(here, std::move(*message));
      --left;
    }
  }
}

FramePtr Lasting::frameOf(const Position& position, const Message& message) {
  const auto known = frames_.find(position);
  if (known != frames_.end()) return known->second;
  auto frame = fields_.read(message);
  return frames_.emplace(position, frame ? std::move(*frame) : nullptr).first->second;
}

/// A message counts while one of its transforms or markers does; and with it the last word about each of its
/// other ones.
std::set<Lasting::Position> Lasting::live(std::int64_t at_ns, Found& found) {
  std::set<Position> all, markers;
  for (const auto& [key, entry] : state_.entries) {
    if (entry.until_ns <= at_ns) continue;
    all.insert(entry.position);
    if (isMarker(key)) markers.insert(entry.position);
  }
  for (std::set<Position> next = markers; !next.empty();) {
    read(next, found);
    std::set<Position> more;
    for (const Position& position : next) {
      const auto message = found.find(position);
      if (message == found.end()) continue;
      const FramePtr frame = frameOf(position, message->second);
      const auto read = frame ? markersIn(*frame, message->second) : tl::unexpected(Fault());
      if (!read) continue;
      for (const ros::Marker& marker : *read) {
        if (marker.action != ros::Marker::Action::Add) continue;
        const auto entry = state_.entries.find({position.topic, nameOf(marker.ns), marker.id});
        if (entry != state_.entries.end() && all.insert(entry->second.position).second)
          more.insert(entry->second.position);
      }
    }
    next = std::move(more);
  }
  return all;
}

void Lasting::addStamps(const Message& message, Lasts lasts, Stamped& need) {
  if (lasts == Lasts::PerMarker) {
    const FramePtr frame = frameOf(need.position, message);
    const auto markers = frame ? markersIn(*frame, message) : tl::unexpected(Fault());
    if (!markers) return;
    for (const ros::Marker& marker : *markers) {
      const std::string& in = marker.header.frame;
      if (marker.action != ros::Marker::Action::Add || marker.frame_locked || in.empty() ||
          in == fixed_frame_)
        continue;
      need.stamps_s.push_back(marker.header.stamp_s);
    }
  } else if (message.bytes.size() <= kMostLookedInto &&
             !ros::plainType(message.channel->schema_name).ends_with("Image")) {
    const auto frame = fields_.read(message);
    if (!frame) return;
    ros::Field root = (*frame)->root();
    if (const ros::Field map = root["map"]) root = map;
    ros::Field header = root["header"];
    if (header["frame_id"].text().empty()) {
      root["poses"].each([&](const ros::Field& pose) {
        if (header["frame_id"].text().empty() && pose["header"]) header = pose["header"];
      });
    }
    if (ros::frameName(header["frame_id"].text()) == fixed_frame_ || !header) return;
    const auto stamp_s = header["stamp"].time();
    need.stamps_s.push_back(stamp_s && *stamp_s != 0 ? stamp_s : std::nullopt);
    // A scan lies where the robot was during its sweep.
    const auto between_s = root["time_increment"].number();
    if (!stamp_s || !between_s || !(*between_s > 0)) return;
    const double sweep_s = *between_s * double(root["ranges"].size());
    for (int step = 1; step <= 32; ++step) need.stamps_s.push_back(*stamp_s + sweep_s * step / 32);
  }
  std::sort(need.stamps_s.begin(), need.stamps_s.end());
  need.stamps_s.erase(std::unique(need.stamps_s.begin(), need.stamps_s.end()), need.stamps_s.end());
}

namespace {

/// The transforms of a child frame that lie around some time.
struct Pair {
  double stamp_s = 0;
  std::int64_t said_ns = 0;
  std::size_t message = 0;
};

/// Around the stamp: the last one before it and the first one after it, of those said by then.
template <typename Visit>
void around(const std::deque<Pair>& pairs, double stamp_s, std::int64_t from_ns, std::int64_t until_ns,
            Visit visit) {
  const Pair *before = nullptr, *after = nullptr;
  for (const Pair& pair : pairs) {
    if (pair.said_ns < from_ns || pair.said_ns > until_ns) continue;
    if (pair.stamp_s <= stamp_s + kSameTimeS && (!before || pair.stamp_s >= before->stamp_s)) before = &pair;
    if (pair.stamp_s >= stamp_s - kSameTimeS && (!after || pair.stamp_s < after->stamp_s)) after = &pair;
  }
  if (before) visit(before->message);
  if (after) visit(after->message);
}

}  // namespace

/// The transforms by which they were placed.
void Lasting::addPlacing(std::vector<Stamped> needs, std::set<Position>& positions) {
  std::erase_if(needs, [](const Stamped& need) { return need.stamps_s.empty(); });
  // Static ones as they were then: they may be others now.
  for (const Stamped& need : needs) {
    std::set<Position>& by = placed_by_[need.position];
    for (const auto& [child, changes] : statics_) {
      const auto after = changes.lower_bound({need.at_ns + kLateNs + 1, Position{kDeleted, 0, 0}});
      if (after != changes.begin()) by.insert(std::prev(after)->second);
    }
    positions.insert(by.begin(), by.end());
  }
  if (transforms_.empty() || needs.empty()) return;
  std::sort(needs.begin(), needs.end(), [](const auto& a, const auto& b) { return a.at_ns < b.at_ns; });
  std::map<std::string, std::deque<Pair>> pairs;  // by child
  std::deque<Position> read;                      // of the messages
  std::size_t gone = 0;                           // of `read`, from its front
  const auto settle = [&](const Stamped& need) {
    std::set<Position>& by = placed_by_[need.position];
    const std::int64_t from_ns = need.at_ns - kHistoryNs, until_ns = need.at_ns + kLateNs;
    const auto addPosition = [&](std::size_t message) {
      if (message >= gone) by.insert(read[message - gone]);
    };
    std::vector<double> stamps_s;
    for (const std::optional<double>& stamp_s : need.stamps_s) {
      if (stamp_s) stamps_s.push_back(*stamp_s);
      if (stamp_s) continue;
      // At the latest that all have in common: it is the newest of one of them, then or when the last one
      // came.
      for (const std::int64_t by_ns : {need.at_ns, until_ns}) {
        for (const auto& [child, of] : pairs) {
          std::optional<double> newest_s;
          for (const Pair& pair : of) {
            if (pair.said_ns >= from_ns && pair.said_ns <= by_ns)
              newest_s = std::max(newest_s.value_or(pair.stamp_s), pair.stamp_s);
          }
          if (newest_s) stamps_s.push_back(*newest_s);
        }
      }
    }
    std::sort(stamps_s.begin(), stamps_s.end());
    stamps_s.erase(std::unique(stamps_s.begin(), stamps_s.end()), stamps_s.end());
    for (const double stamp_s : stamps_s) {
      for (const auto& [child, of] : pairs) around(of, stamp_s, from_ns, until_ns, addPosition);
    }
    positions.insert(by.begin(), by.end());
  };
  std::size_t settled = 0;
  const auto add = [&](const Message& message) {
    const auto known = by_topic_.find(message.channel->topic);
    if (known == by_topic_.end()) return;
    const Position position = positionOf(message, known->second);
    const std::int64_t said_ns = saidNs(message);
    for (; settled < needs.size() && needs[settled].at_ns + kLateNs < said_ns; ++settled)
      settle(needs[settled]);
    const auto frame = fields_.read(message);
    if (!frame) return;
    for (const ros::TfRow& row : ros::readTf((*frame)->root())) {
      std::deque<Pair>& of = pairs[frameOfRobot(known->first, row.child)];
      while (!of.empty() && of.front().said_ns < said_ns - kHistoryNs - 2 * kLateNs) of.pop_front();
      of.push_back({row.stamp_s, said_ns, gone + read.size()});
    }
    read.push_back(position);
    for (; read.size() > 100'000; ++gone) read.pop_front();
  };
  // What a part of a recording says of the time before it lies at its start.
  recording::Query query;
  query.topics = transforms_;
  const std::map<std::uint32_t, std::pair<std::int64_t, std::uint32_t>> counted = std::exchange(counted_, {});
  if (const auto start_ns = file_.summary().start_ns) {
    query.first_ns = query.last_ns = *start_ns;
    const auto cursor = file_.messages(query);
    std::vector<Message> first;
    while (auto message = cursor->next()) first.push_back(std::move(*message));
    const bool part = std::any_of(first.begin(), first.end(),
                                  [](const Message& one) { return saidNs(one) != one.log_time_ns; });
    if (part) std::for_each(first.begin(), first.end(), add);
    query.first_ns = part ? *start_ns + 1 : *start_ns;
  }
  for (const std::int64_t start_ns = query.first_ns; settled < needs.size();) {
    const std::size_t first = settled;
    query.first_ns = std::max(start_ns, needs[first].at_ns - kHistoryNs);
    query.last_ns = needs[first].at_ns + kLateNs;
    std::size_t last = first + 1;
    for (; last < needs.size() && needs[last].at_ns - kHistoryNs <= query.last_ns; ++last)
      query.last_ns = needs[last].at_ns + kLateNs;
    counted_.clear();
    if (query.first_ns <= query.last_ns) {
      const auto cursor = file_.messages(query);
      while (const auto message = cursor->next()) add(*message);
    }
    for (; settled < last; ++settled) settle(needs[settled]);
  }
  counted_ = counted;
}

/// Beside transforms and markers that are kept: the last ones of their topics, patches, the transforms of the
/// last seconds.
void Lasting::addRest(std::int64_t at_ns, Found& found, std::vector<Stamped>& needs) {
  const auto readInto = [&](recording::Query query) {
    query.last_ns = at_ns - 1;
    counted_.clear();
    const auto cursor = file_.messages(query);
    while (auto message = cursor->next()) {
      const Position position = positionOf(*message, by_topic_.at(message->channel->topic));
      found.insert_or_assign(position, std::move(*message));
    }
  };
  std::vector<std::string> last_of;
  for (const LastingTopic& topic : topics_) {
    if (topic.lasts == Lasts::UntilNext) last_of.push_back(topic.topic);
    if (topic.lasts != Lasts::Patches) continue;
    const std::vector<Message> whole = file_.lastBefore(at_ns - 1, {topic.base});
    if (whole.empty()) {
      last_of.push_back(topic.topic);
    } else {
      readInto({.first_ns = whole.front().log_time_ns, .topics = {topic.topic}});
    }
  }
  if (!transforms_.empty()) readInto({.first_ns = at_ns - kHistoryNs, .topics = transforms_});
  if (last_of.empty()) return;
  for (Message& message : file_.lastBefore(at_ns - 1, last_of)) {
    const Position position{message.log_time_ns, by_topic_.at(message.channel->topic), kLastOfTopic};
    Stamped need{position, saidNs(message), {}};
    if (!transforms_.empty() || !statics_.empty()) addStamps(message, Lasts::UntilNext, need);
    needs.push_back(std::move(need));
    found.insert_or_assign(position, std::move(message));
  }
}

std::vector<Message> Lasting::before(std::int64_t at_ns) {
  reach(at_ns);
  cursor_.reset();
  Found found;
  std::set<Position> positions = live(at_ns, found), placing;
  std::vector<Stamped> needs;
  const auto placed_by = std::exchange(placed_by_, {});
  for (const auto& [position, message] : found) {
    Stamped need{position, saidNs(message), {}};
    // Those that may have been placed only since are looked at again.
    const auto known = placed_by.find(position);
    if (known != placed_by.end() && need.at_ns + kLateNs < at_ns) {
      placing.insert(known->second.begin(), known->second.end());
      placed_by_.insert(*known);
      continue;
    }
    addStamps(message, Lasts::PerMarker, need);
    if (need.stamps_s.empty()) placed_by_[position];
    needs.push_back(std::move(need));
  }
  addRest(at_ns, found, needs);
  addPlacing(std::move(needs), placing);
  std::erase_if(placed_by_, [](const auto& one) { return one.first.ordinal == kLastOfTopic; });
  // Those of later are not known yet.
  std::erase_if(placing, [&](const Position& position) { return position.log_ns >= at_ns; });
  positions.merge(placing);
  read(positions, found);
  // The last one of a topic may have been found in two ways.
  std::erase_if(found, [&](const auto& one) {
    const auto& [position, message] = one;
    if (position.ordinal != kLastOfTopic) return false;
    const auto same = std::prev(found.upper_bound({position.log_ns, position.topic, kLastOfTopic - 1}),
                                found.begin()->first < position ? 1 : 0);
    return same->first.log_ns == position.log_ns && same->first.topic == position.topic &&
           same->first.ordinal != kLastOfTopic &&
           std::equal(same->second.bytes.begin(), same->second.bytes.end(), message.bytes.begin(),
                      message.bytes.end());
  });
  std::erase_if(frames_, [&](const auto& frame) { return !positions.contains(frame.first); });
  return inOrder(std::move(found));
}

/// By when they were said; those of the same time as the file has them, where one chunk tells.
std::vector<Message> Lasting::inOrder(Found found) {
  using Row = std::pair<std::int64_t, Message>;
  std::vector<Row> rows;
  rows.reserve(found.size());
  for (auto& [position, message] : found) rows.emplace_back(saidNs(message), std::move(message));
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.first < b.first; });
  for (auto first = rows.begin(); first != rows.end();) {
    const auto last = std::find_if(first, rows.end(), [&](const Row& row) {
      return row.first != first->first || row.second.keeps != first->second.keeps ||
             row.second.log_time_ns != first->second.log_time_ns;
    });
    std::sort(first, last,
              [](const Row& a, const Row& b) { return a.second.bytes.data() < b.second.bytes.data(); });
    first = last;
  }
  std::vector<Message> all;
  all.reserve(rows.size());
  for (Row& row : rows) all.push_back(std::move(row.second));
  return all;
}

struct EarlierMessages::Parts {
  explicit Parts(recording::Source& file)
      : shape(shapeOf(file, fields, {}, {})), lasting(file, fields, lastingTopics(file, shape), shape) {}
  MessageFields fields;
  RosShape shape;
  Lasting lasting;
};

EarlierMessages::EarlierMessages(recording::Source& file) : parts_(std::make_unique<Parts>(file)) {}
EarlierMessages::~EarlierMessages() = default;
bool EarlierMessages::reach(std::int64_t at_ns, int most) { return parts_->lasting.reach(at_ns, most); }
std::vector<Message> EarlierMessages::before(std::int64_t at_ns) { return parts_->lasting.before(at_ns); }

}  // namespace mapwright::robot::recorded
