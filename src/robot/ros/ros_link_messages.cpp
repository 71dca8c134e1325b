// RosLink: what comes by topics.
#include <algorithm>
#include <utility>

#include <QDateTime>

#include "robot/ros/ros_link.h"

namespace mapwright::robot::ros {
namespace {

using net::rosbridge::TopicMessage;

constexpr qint64 kPoseAnywayMs = 1'000;   // a robot that stands still is told of, too
constexpr qint64 kFramesMs = 2'000;       // for the frames of map and robot to be known
constexpr qint64 kPoseMissingMs = 2'000;  // before it is told that it has none

constexpr qint64 kTellAgainMs = 5'000;

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
  if (watching_ && raw_limit_.allow(clock_.elapsed(), message.bytes)) Q_EMIT rawReceived(rawOf(message));
  const WantedTopic* const wanted = subscriptions_->heard(message.topic);
  if (!wanted) return;
  takeOfManager(message);
  bool of_pose = false;
  const std::vector<Source> sources = wanted->sources;
  for (const Source& source : sources) {
    for (WorldResult& result : world_.take(source, message.msg, message.received_s)) tell(std::move(result));
    of_pose |= source.stream == map::Stream::Pose;
  }
  if (of_pose && wish_.basics.pose && !pose_timer_->isActive()) {
    const qint64 since = pose_told_.isValid() ? pose_told_.elapsed() : options_.pose_every.count();
    pose_timer_->start(
        std::max(std::chrono::milliseconds(0), options_.pose_every - std::chrono::milliseconds(since)));
  }
}

void RosLink::takeOfManager(const TopicMessage& message) {
  if (wish_.managers_own.empty()) return;
  KabamBook& book = kabam_->book();
  const KabamBook::Taken taken = book.take(message.topic, message.frame, message.msg);
  if (!taken.own) return;
  const std::optional<map::Reason> odd =
      taken.readable ? std::nullopt : std::optional<map::Reason>(map::ReasonCode::MessageNotUnderstood);
  note(message.topic, map::ProblemCode::Unreadable, odd);
  if (taken.maps && book.current() && !book.current()->map.id.empty())
    emitTopic(book.topics().front(), book.mapInfo(), message.received_s, std::nullopt);
  if (taken.maps) {
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
  std::optional<map::Reason> odd;
  if (!result.notes.empty()) odd = result.notes.front();
  if (!result.unreadable) note(topic, map::ProblemCode::Odd, odd);
  if (!result.message) return;
  const auto* const grid = std::get_if<map::GridMessage>(&*result.message);
  const bool whole = grid && grid->kind == map::GridKind::WholeMap;
  if (whole) live_map_->take(*grid);
  emitTopic(topic, std::move(*result.message), result.received_s, result.recorded_s);
}

void RosLink::note(const std::string& topic, map::ProblemCode code,
                   const std::optional<map::Reason>& reason) {
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

// The first transforms to come may be those of the wheels alone, and a pose may come before any of them: the
// robot would seem to jump when the others do.
bool RosLink::framesComplete() const {
  const bool map_expected = !sourcesFor(map::Stream::WholeMap, sources_).empty();
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
