// RosLink: incoming messages.
#include <algorithm>
#include <utility>

#include <QDateTime>

#include "robot/ros/faults.h"
#include "robot/ros/log.h"
#include "robot/ros/ros_link.h"

namespace mapwright::robot::ros {
namespace {

using net::rosbridge::TopicMessage;

constexpr std::chrono::milliseconds kPoseEvery{50};  // told at most so often
constexpr qint64 kPoseAnywayMs = 1'000;              // a robot that stands still is told of, too
constexpr qint64 kFramesMs = 2'000;                  // for the frames of map and robot to be known
constexpr qint64 kPoseMissingMs = 2'000;             // before it is told that it has none

constexpr qint64 kTellAgainMs = 5'000;
constexpr qint64 kReceptionEveryMs = 1'000;
constexpr double kLateS = 1;
constexpr std::size_t kMostAges = 100;

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

}  // namespace

void RosLink::take(const TopicMessage& message) {
  deliveries_.take(message);
  if (passesRaw(message.bytes)) Q_EMIT rawReceived(rawOf(message));
  const WantedTopic* const wanted = subscriptions_.heard(message.topic);
  if (!wanted) return;
  takeOfManager(message);
  if (std::any_of(wish_.dispatchers_own.begin(), wish_.dispatchers_own.end(),
                  [&](const FoundTopic& own) { return own.name == message.topic; }))
    note(message.topic, map::ProblemCode::Unreadable, dispatch_.hear(message.topic, message.msg));
  ++reception_.came;
  bool of_pose = false;
  const std::vector<Source> sources = wanted->sources;
  if (!sources.empty()) noteDelay(sources.front(), message);
  for (const Source& source : sources) {
    for (WorldResult& result : world_.take(source, message.msg, message.received_s)) tell(std::move(result));
    of_pose |= source.stream == map::Stream::Pose;
    if (source.stream == map::Stream::WholeMap && source.form == Form::Grid) asked_map_.heard();
  }
  if (of_pose && wish_.basics.pose && !pose_timer_.isActive()) {
    const qint64 since = pose_told_.isValid() ? pose_told_.elapsed() : qint64(kPoseEvery.count());
    pose_timer_.start(std::max(std::chrono::milliseconds(0), kPoseEvery - std::chrono::milliseconds(since)));
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
  now.dropped = qint64(places_->mailbox.replaced() + world_.gaveWay() - before_);
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
  deliveries_.takeMap(service, answer);
  // Patches, and whoever listens to the topic, take it for what that would have brought.
  if (!source.base.empty()) source.topic = source.base;
  for (WorldResult& result : world_.take(source, answer.values["map"], wall())) tell(std::move(result));
  if (!source.base.empty()) subscriptions_.replacedBy(source.base, service);
}

void RosLink::takeOfManager(const TopicMessage& message) {
  if (!kabam_.there()) return;
  const KabamBook::Taken taken = kabam_.take(message);
  if (!taken.own) return;
  const std::optional<Fault> odd =
      taken.readable ? std::nullopt : std::optional<Fault>(fault::MessageNotUnderstood);
  note(message.topic, map::ProblemCode::Unreadable, odd);
  KabamBook& book = kabam_.book();
  if (taken.maps && book.current() && !book.current()->map.id.empty())
    emitTopic(book.topics().front(), book.mapInfo(), message.received_s, std::nullopt);
  if (taken.maps) pictures_.sawMap();
  kabam_.tell(taken);
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
    live_map_.take(*grid);
    if (live_map_.last()) dispatch_.sawMap(live_map_.last()->fingerprint);
    pictures_.sawMap();
  }
  emitTopic(topic, std::move(*result.message), result.received_s, result.recorded_s);
}

void RosLink::note(const std::string& topic, map::ProblemCode code, const std::optional<Fault>& reason) {
  if (reason) {
    Trouble& trouble = troubles_[topic][code];
    const qint64 now = clock_.elapsed();
    if (trouble.reason == *reason && now - trouble.told_ms < kTellAgainMs) return;
    trouble = {*reason, now};
    qCInfo(lcRos, "%s: %s", topic.c_str(), inEnglish(*reason).c_str());
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
    pose_timer_.start(std::chrono::milliseconds(kFramesMs / 20));
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
  pass({std::move(message), received_s, recorded_s, topic});
}

}  // namespace mapwright::robot::ros
