// RosLink: incoming messages.
#include <algorithm>
#include <utility>

#include <QDateTime>

#include "robot/ros/faults.h"
#include "robot/ros/ros_link.h"

namespace mapwright::robot::ros {
namespace {

using net::rosbridge::TopicMessage;

constexpr qint64 kPoseAnywayMs = 1'000;   // also for a robot that stands still
constexpr qint64 kFramesMs = 2'000;       // time for the frames of map and robot to become known
constexpr qint64 kPoseMissingMs = 2'000;  // before its absence is reported

constexpr qint64 kTellAgainMs = 5'000;
constexpr qint64 kReceptionEveryMs = 1'000;
constexpr double kLateS = 1;
constexpr std::size_t kMostAges = 100;

constexpr const char* kAskedMap = "nav_msgs/GetMapResponse";

map::Subject topicSubject(const std::string& topic) { return {map::SubjectKind::Topic, topic}; }

RawMessage rawOf(const TopicMessage& message) {
  RawMessage raw;
  raw.topic = QString::fromStdString(message.topic);
  raw.received = QDateTime::fromMSecsSinceEpoch(qint64(message.received_s * 1000), Qt::UTC);
  raw.bytes = message.bytes;
  raw.binary = message.binary;
  raw.text = message.msg.toJson(kMaxRawText);
  return raw;
}

/// Several publishers each send some of a robot's frames: one message does not replace the others.
std::string slotOf(const TopicMessage& message) {
  std::string slot = message.topic;
  if (lastPart(message.topic) != "tf_static") return slot;
  message.msg["transforms"].each(
      [&](const net::rosbridge::Field& transform) { slot += '\n' + transform["child_frame_id"].text(); });
  return slot;
}

}  // namespace

void RosLink::deliver(const std::string& name, std::string type, std::string slot,
                      const std::shared_ptr<const net::rosbridge::Frame>& frame, const char* member,
                      std::optional<double> said_s, double received_s) {
  if (!type.empty() && delivered_types_.insert(type).second) askDefinition();
  wire::DeliveryPlace::Parcel parcel;
  parcel.name = name;
  parcel.schema = std::move(type);
  parcel.encoding = frame->wire() == net::rosbridge::Frame::Wire::Binary ? "cbor" : "json";
  parcel.slot = std::move(slot);
  parcel.keeps = frame;
  parcel.held_bytes = std::size_t(frame->bytes()) * (parcel.encoding[0] == 'j' ? 3 : 1);
  parcel.find = [frame = frame.get(), member] { return frame->rawMember(member); };
  parcel.received_s = received_s;
  parcel.said_s = said_s;
  deliveries_->pass(std::move(parcel));
}

void RosLink::defineTypes() { askDefinition(); }

void RosLink::askDefinition() {
  if (defining_ || !known_ || !deliveries_->taken()) return;
  const auto next = std::find_if(delivered_types_.begin(), delivered_types_.end(),
                                 [&](const std::string& type) { return !defined_types_.contains(type); });
  if (next == delivered_types_.end()) return;
  const std::string type = *next;
  defined_types_.insert(type);
  defining_ = true;
  // A service has no such name in the list: its answer is a map.
  const bool ros2 =
      found_.topics && std::any_of(found_.topics->begin(), found_.topics->end(), [](const FoundTopic& one) {
        return one.type.find("/msg/") != std::string::npos;
      });
  const std::string map = ros2 ? "nav_msgs/msg/OccupancyGrid" : "nav_msgs/OccupancyGrid";
  const bool asked_map = type == kAskedMap;
  api_->define(asked_map ? map : type,
               [this, round = round_, type, map, asked_map](std::optional<RosDefinition> definition) {
                 if (round != round_) return;
                 defining_ = false;
                 if (definition && asked_map) definition = definitionAround(*definition, map, "map");
                 deliverDefinition(type, definition);
                 askDefinition();
               });
}

void RosLink::deliverDefinition(const std::string& type, const std::optional<RosDefinition>& definition) {
  wire::DeliveryPlace::Parcel parcel;
  parcel.kind = Delivery::Kind::Definition;
  parcel.name = type;
  parcel.encoding = definition && definition->ros2 ? "ros2msg" : "ros1msg";
  parcel.slot = "definition of " + type;
  if (definition) {
    const auto text = std::make_shared<const std::string>(definition->text);
    parcel.bytes = *text;
    parcel.held_bytes = text->size();
    parcel.keeps = text;
  }
  parcel.received_s = wall();
  deliveries_->pass(std::move(parcel));
}

void RosLink::deliverMessage(const TopicMessage& message) {
  std::string type = typeOf(found_, message.topic);
  if (type.empty()) {
    // Subscribed by its usual name.
    const auto source = std::find_if(sources_.begin(), sources_.end(),
                                     [&](const Source& one) { return one.topic == message.topic; });
    if (source != sources_.end()) type = source->type;
  }
  deliver(message.topic, std::move(type), slotOf(message), message.frame, "msg",
          message.msg["header"]["stamp"].time(), message.received_s);
}

void RosLink::take(const TopicMessage& message) {
  deliverMessage(message);
  if (watching_ && raw_limit_.allow(clock_.elapsed(), message.bytes)) Q_EMIT rawReceived(rawOf(message));
  const WantedTopic* const wanted = subscriptions_->heard(message.topic);
  if (!wanted) return;
  takeOfManager(message);
  if (std::any_of(wish_.dispatchers_own.begin(), wish_.dispatchers_own.end(),
                  [&](const FoundTopic& own) { return own.name == message.topic; }))
    note(message.topic, map::ProblemCode::Unreadable, dispatch_->hear(message.topic, message.msg));
  ++reception_.came;
  bool of_pose = false;
  const std::vector<Source> sources = wanted->sources;
  if (!sources.empty()) noteDelay(sources.front(), message);
  for (const Source& source : sources) {
    for (WorldResult& result : world_.take(source, message.msg, message.received_s)) tell(std::move(result));
    of_pose |= source.stream == map::Stream::Pose;
    if (source.stream == map::Stream::WholeMap && source.form == Form::Grid) asked_map_->heard();
  }
  if (of_pose && wish_.basics.pose && !pose_timer_->isActive()) {
    const qint64 since = pose_told_.isValid() ? pose_told_.elapsed() : options_.pose_every.count();
    pose_timer_->start(
        std::max(std::chrono::milliseconds(0), options_.pose_every - std::chrono::milliseconds(since)));
  }
}

// Clocks differ: what counts is the delay relative to the fastest message.
void RosLink::noteDelay(const Source& source, const TopicMessage& message) {
  const bool of_sensor =
      source.form == Form::LaserScan || source.form == Form::PointCloud || source.form == Form::Odometry;
  const auto stamp_s = of_sensor ? message.msg["header"]["stamp"].time() : std::nullopt;
  if (!stamp_s || *stamp_s == 0) return;
  const double delay_s = message.received_s - *stamp_s;
  least_late_s_ = std::min(delay_s, least_late_s_.value_or(delay_s));
  if (delay_s > *least_late_s_ + kLateS) ++reception_.late;
}

void RosLink::tellReception() {
  if (reception_told_.isValid() && reception_told_.elapsed() < kReceptionEveryMs) return;
  reception_told_.start();
  Reception now = reception_;
  now.dropped = qint64(mailbox_->replaced() + world_.gaveWay() - before_);
  for (const auto& [pair, age_s] : world_.ages(wall())) {
    if (now.transforms.size() == kMostAges) break;
    now.transforms.push_back(
        {QString::fromStdString(pair.parent), QString::fromStdString(pair.child), age_s});
  }
  Q_EMIT receptionTold(now);
}

void RosLink::takeAskedMap(const std::string& service, const net::rosbridge::CallAnswer& answer) {
  const auto known = std::find_if(sources_.begin(), sources_.end(), [&](const Source& source) {
    return source.form == Form::MapService && source.topic == service;
  });
  Source source{map::Stream::WholeMap, Form::MapService, service, {}, {}, true};
  const std::vector<Source> maps = sourcesFor(map::Stream::WholeMap, sources_);
  if (known != sources_.end()) {
    source.base = known->base;
  } else if (!maps.empty()) {
    source.base = maps.front().topic;
  }
  note(service, map::ProblemCode::Unavailable, std::nullopt);
  deliver(service, kAskedMap, service, answer.frame, "values", answer.values["map"]["header"]["stamp"].time(),
          wall());
  // Patches and subscribers treat it like the topic that it replaces.
  if (!source.base.empty()) source.topic = source.base;
  for (WorldResult& result : world_.take(source, answer.values["map"], wall())) tell(std::move(result));
  if (!source.base.empty()) subscriptions_->replacedBy(source.base, service);
}

void RosLink::takeOfManager(const TopicMessage& message) {
  if (wish_.managers_own.empty()) return;
  KabamBook& book = kabam_->book();
  const KabamBook::Taken taken = book.take(message.topic, message.frame, message.msg);
  if (!taken.own) return;
  const std::optional<Fault> odd =
      taken.readable ? std::nullopt : std::optional<Fault>(fault::MessageNotUnderstood);
  note(message.topic, map::ProblemCode::Unreadable, odd);
  if (taken.maps && book.current() && !book.current()->map.id.empty())
    emitTopic(book.topics().front(), book.mapInfo(), message.received_s, std::nullopt);
  if (taken.maps) {
    picture_timer_->start();
    Q_EMIT mapManagerStands(QString::fromStdString(book.state()));
    Q_EMIT mapsChanged();
  }
  kabam_->look();
  if (taken.waypoints) Q_EMIT waypointsChanged();
}

void RosLink::tell(WorldResult result) {
  const std::string topic = result.topic;
  if (result.message || result.unreadable) note(topic, map::ProblemCode::Unreadable, result.unreadable);
  if (result.message || result.unplaced) note(topic, map::ProblemCode::Unplaced, result.unplaced);
  std::optional<Fault> odd;
  if (!result.notes.empty()) odd = result.notes.front();
  if (!result.unreadable) note(topic, map::ProblemCode::Odd, odd);
  if (!result.message) return;
  const auto* const grid = std::get_if<map::GridMessage>(&*result.message);
  const bool whole = grid && grid->kind == map::GridKind::WholeMap;
  if (whole) {
    live_map_->take(*grid);
    if (live_map_->last()) dispatch_->sawMap(live_map_->last()->fingerprint);
    picture_timer_->start();
  }
  emitTopic(topic, std::move(*result.message), result.received_s, result.recorded_s);
}

void RosLink::comparePicture() {
  const KabamBook& book = kabam_->book();
  if (!known_ || !has_manager_ || !book.current() || book.current()->map.id.empty() || book.isMapping())
    return;
  const std::string& id = book.current()->map.id;
  bool other = pictures_doubted_.erase(id) > 0;
  if (live_map_->last()) {
    std::string& seen = pictures_seen_[id];
    other |= !seen.empty() && seen != live_map_->last()->fingerprint;
    seen = live_map_->last()->fingerprint;
  }
  if (other) Q_EMIT pictureChanged(QString::fromStdString(id));
}

void RosLink::note(const std::string& topic, map::ProblemCode code, const std::optional<Fault>& reason) {
  if (reason) {
    Trouble& trouble = troubles_[topic][code];
    const qint64 now = clock_.elapsed();
    if (trouble.reason == *reason && now - trouble.told_ms < kTellAgainMs) return;
    trouble = {*reason, now};
    Q_EMIT problemFound({map::Severity::Warning, topicSubject(topic), *reason, code});
    return;
  }
  const auto troubles = troubles_.find(topic);
  if (troubles == troubles_.end() || troubles->second.erase(code) == 0) return;
  Q_EMIT recovered({topicSubject(topic), code});
}

void RosLink::forgetTrouble(const std::string& topic) {
  const auto troubles = troubles_.extract(topic);
  if (troubles.empty()) return;
  for (const auto& [code, trouble] : troubles.mapped()) Q_EMIT recovered({topicSubject(topic), code});
}

// The first transforms may be only those of the wheels, and a pose may arrive before any of them: the robot
// would seem to jump when the others arrive.
bool RosLink::framesComplete() const {
  const bool map_expected =
      (!wish_.map_by_region || wish_.whole_map) && !sourcesFor(map::Stream::WholeMap, sources_).empty();
  const bool transforms_expected = std::any_of(sources_.begin(), sources_.end(),
                                               [](const Source& source) { return source.form == Form::Tf; });
  return (!map_expected || world_.fixedByMap()) && (!transforms_expected || world_.posedByTransforms());
}

void RosLink::tellPose() {
  if (known_since_.elapsed() < kFramesMs && !framesComplete()) {
    pose_timer_->start(std::chrono::milliseconds(kFramesMs / 20));
    return;
  }
  const auto pose = world_.pose();
  const std::vector<Source> sources = sourcesFor(map::Stream::Pose, sources_);
  if (!pose || sources.empty()) return;
  const std::string topic = sources.front().topic;
  if (!*pose) {
    if (!pose_missing_.isValid()) pose_missing_.start();
    if (pose_missing_.elapsed() < kPoseMissingMs) return;
    pose_missing_.start();
    note(topic, map::ProblemCode::Unplaced, pose->error());
    return;
  }
  pose_missing_.invalidate();
  note(topic, map::ProblemCode::Unplaced, std::nullopt);
  const bool again = !pose_told_.isValid() || pose_told_.elapsed() >= kPoseAnywayMs;
  if (last_pose_ == **pose && !again) return;
  last_pose_ = **pose;
  pose_told_.start();
  emitTopic(topic, map::TrackedPose{**pose}, wall(), std::nullopt);
}

void RosLink::emitTopic(const std::string& topic, map::TopicMessage message, double received_s,
                        std::optional<double> recorded_s) {
  const bool by_mail = wire::TopicMailbox::takes(message);
  map::StampedMessage stamped{std::move(message), received_s, recorded_s, topic};
  if (!by_mail) {
    Q_EMIT topicReceived(stamped);
  } else if (mailbox_->put(std::move(stamped))) {
    Q_EMIT mailArrived();
  }
}

}  // namespace mapwright::robot::ros
