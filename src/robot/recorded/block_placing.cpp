#include "robot/recorded/block_placing.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "robot/ros/faults.h"

namespace mapwright::robot::recorded {
namespace {

constexpr std::int64_t kMissingNs = 2'000'000'000;  // after the start, while transforms are still missing
using recording::secondsOf;

void append(ros::WorldResults& all, ros::WorldResults more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

ros::WorldResult resultOf(const std::string& topic, std::int64_t at_ns) {
  ros::WorldResult result;
  result.topic = topic;
  result.received_s = secondsOf(at_ns);
  return result;
}

}  // namespace

void GridFolds::set(const std::string& topic, const ros::Grid& grid, std::int64_t at_ns) {
  folds_.insert_or_assign(topic, Fold{grid, at_ns, at_ns});
}

ros::Grid* GridFolds::made(const std::string& topic) {
  const auto known = folds_.find(topic);
  return known == folds_.end() ? nullptr : &known->second.grid;
}

void GridFolds::patched(const std::string& topic, std::int64_t at_ns) {
  if (const auto known = folds_.find(topic); known != folds_.end()) known->second.until_ns = at_ns;
}

ros::Grid* GridFolds::before(const std::string& topic, const std::string& patches, std::int64_t at_ns) {
  const std::vector<recording::Message> last = file_.lastBefore(at_ns, {topic});
  if (last.empty()) return nullptr;
  const std::int64_t whole_ns = last.front().log_time_ns;
  const auto known = folds_.find(topic);
  if (known == folds_.end() || known->second.whole_ns != whole_ns || known->second.until_ns > at_ns) {
    const auto frame = fields_.read(last.front());
    if (!frame) return nullptr;
    auto grid = ros::readGrid((*frame)->root());
    if (!grid) return nullptr;
    set(topic, *grid, whole_ns);
  }
  Fold& fold = folds_.at(topic);
  recording::Query query;
  query.first_ns = fold.until_ns;
  query.last_ns = at_ns - 1;
  query.topics = {patches};
  if (query.last_ns <= query.first_ns) return &fold.grid;
  const bool anew = fold.until_ns == fold.whole_ns;
  const auto cursor = file_.messages(query);
  while (const auto message = cursor->next()) {
    if (!anew && message->log_time_ns == fold.until_ns) continue;  // already applied
    const auto frame = fields_.read(*message);
    if (!frame) continue;
    // Its errors are reported where it is played.
    if (const auto patch = ros::readGridPatch((*frame)->root())) (void)ros::patchGrid(fold.grid, *patch);
  }
  fold.until_ns = query.last_ns;
  return &fold.grid;
}

std::int64_t BlockPlacing::blockOf(std::int64_t at_ns) {
  return (at_ns / kBlockNs - (at_ns % kBlockNs < 0)) * kBlockNs;
}

BlockPlacing::BlockPlacing(const PlacingParts& parts, std::int64_t block_ns, std::int64_t from_ns,
                           std::int64_t until_ns)
    : parts_(parts),
      block_ns_(block_ns),
      start_ns_(parts.file.summary().start_ns.value_or(block_ns)),
      ahead_(parts.shape.ns),
      now_(parts.shape.ns),
      next_look_ns_(block_ns) {
  for (ros::RosWorld* const world : {&ahead_, &now_}) {
    world->setRobots(parts_.shape.robots);
    if (parts_.shape.root_serves) world->trustRoot();
    world->placeAtOnce(parts_.shape.fixed_frame, parts_.shape.own_frame);
  }
  readEarlier();
  recording::Query query;
  query.first_ns = block_ns - kBeforeNs;
  query.last_ns = std::min(until_ns, block_ns + kBlockNs) + kAheadNs;
  query.topics = parts_.shape.transforms;
  if (!query.topics.empty()) {
    leading_ = parts_.file.messages(query);
    lead_ = leading_->next();
  }
  readBefore(from_ns);
}

void BlockPlacing::readEarlier() {
  for (const recording::Message& message : parts_.lasting.before(block_ns_)) {
    const auto frame = parts_.fields.read(message);
    if (!frame) continue;  // it is reported in its own block
    const double at_s = secondsOf(saidNs(message));
    now_.forgetSilent(at_s);
    for (const ros::Source& source : parts_.shape.by_topic.at(message.channel->topic)) {
      now_.addEarlier(source, (*frame)->root(), at_s);
      if (source.form == ros::Form::StaticTf) ahead_.addEarlier(source, (*frame)->root(), at_s);
    }
  }
  now_.forgetSilent(secondsOf(block_ns_));
  any_markers_ = parts_.lasting.anyMarkers();
  located_ = now_.located();
}

void BlockPlacing::readBefore(std::int64_t from_ns) {
  recording::Query query;
  query.first_ns = block_ns_;
  query.last_ns = from_ns - 1;
  query.topics = parts_.shape.transforms;
  for (const auto* const topics : {&parts_.shape.poses, &parts_.shape.markers})
    query.topics.insert(query.topics.end(), topics->begin(), topics->end());
  if (query.topics.empty() || query.last_ns < query.first_ns) return;
  const auto cursor = parts_.file.messages(query);
  while (const auto message = cursor->next()) {
    before(saidNs(*message));
    if (const auto frame = parts_.fields.read(*message)) add(*message, *frame);
  }
  before(from_ns - 1);
}

void BlockPlacing::advance(std::int64_t until_ns) {
  while (lead_ && saidNs(*lead_) <= until_ns) {
    if (const auto frame = parts_.fields.read(*lead_)) {
      const double at_s = secondsOf(saidNs(*lead_));
      ahead_.forgetSilent(at_s);
      for (const ros::Source& source : parts_.shape.by_topic.at(lead_->channel->topic))
        ahead_.add(source, (*frame)->root(), at_s);
    }
    lead_ = leading_->next();
  }
}

ros::WorldResults BlockPlacing::before(std::int64_t at_ns) {
  ros::WorldResults all;
  if (parts_.shape.markers.empty()) {
    now_.forgetSilent(secondsOf(at_ns));
    return all;
  }
  for (; next_look_ns_ <= at_ns; next_look_ns_ += kMarkersEveryNs) {
    endMarkers(next_look_ns_, all);
    now_.forgetSilent(secondsOf(next_look_ns_));
    append(all, now_.overdue(secondsOf(next_look_ns_)));
    if (next_look_ns_ < block_ns_ || std::exchange(told_beginning_, true) || !any_markers_) continue;
    all.push_back(resultOf(parts_.shape.markers.front(), next_look_ns_));
    all.back().message = now_.seenObjects();
  }
  endMarkers(at_ns, all);
  now_.forgetSilent(secondsOf(at_ns));
  shift(all);
  return all;
}

void BlockPlacing::shift(ros::WorldResults& results) const {
  if (!part_begins_s_) return;
  for (ros::WorldResult& result : results) result.received_s = std::max(result.received_s, *part_begins_s_);
}

void BlockPlacing::endMarkers(std::int64_t until_ns, ros::WorldResults& results) {
  while (now_.nextMarkerEnd() <= secondsOf(until_ns)) append(results, now_.overdue(now_.nextMarkerEnd()));
}

ros::WorldResult BlockPlacing::onGrid(const ros::Source& source, const ros::Field& msg, std::int64_t at_ns) {
  const auto grid = ros::readGrid(msg);
  if (!grid) {
    ros::WorldResult result = resultOf(source.topic, at_ns);
    result.unreadable = grid.error();
    return result;
  }
  if (parts_.shape.patches_of.contains(source.topic)) {
    parts_.folds.set(source.topic, *grid, at_ns);
    folded_.insert(source.topic);
  }
  return ahead_.add(source, *grid, secondsOf(at_ns));
}

ros::WorldResult BlockPlacing::applyMapPatch(const ros::Source& source, const ros::Field& msg,
                                             std::int64_t at_ns) {
  ros::WorldResult result = resultOf(source.topic, at_ns);
  const auto patch = ros::readGridPatch(msg);
  if (!patch) {
    result.unreadable = patch.error();
    return result;
  }
  ros::Grid* const grid = folded_.insert(source.base).second
                              ? parts_.folds.before(source.base, source.topic, at_ns)
                              : parts_.folds.made(source.base);
  if (grid == nullptr) {
    folded_.erase(source.base);
    return result;  // the grid that it changes has not arrived
  }
  const auto patched = ros::patchGrid(*grid, *patch);
  parts_.folds.patched(source.base, at_ns);
  if (!patched) result.unreadable = patched.error();
  if (!patched || !*patched) return result;
  ros::Source of = source;
  of.form = ros::Form::Grid;
  of.topic = source.base;
  ros::Grid whole = *grid;
  whole.notes = patch->notes;
  result = ahead_.add(of, whole, secondsOf(at_ns));
  result.topic = source.topic;
  result.recorded_s = patch->header.stamp_s;
  return result;
}

ros::WorldResults BlockPlacing::add(const recording::Message& message, const FramePtr& frame) {
  const std::int64_t at_ns = saidNs(message);
  if (at_ns != message.log_time_ns) part_begins_s_ = secondsOf(message.log_time_ns);
  advance(at_ns + kAheadNs);
  ahead_.forgetSilent(secondsOf(at_ns));
  ros::WorldResults all;
  bool of_pose = false;
  for (const ros::Source& source : parts_.shape.by_topic.at(message.channel->topic)) {
    switch (source.form) {
      case ros::Form::Tf:
      case ros::Form::StaticTf:
      case ros::Form::Markers:
        any_markers_ |= source.form == ros::Form::Markers;
        append(all, now_.add(source, frame->root(), secondsOf(at_ns)));
        break;
      case ros::Form::MapService:
        all.push_back(onGrid(source, frame->root()["map"], at_ns));
        break;
      case ros::Form::Grid:
        all.push_back(onGrid(source, frame->root(), at_ns));
        break;
      case ros::Form::GridPatch:
        all.push_back(applyMapPatch(source, frame->root(), at_ns));
        break;
      default:
        // Poses use the latest data, everything else its own stamp.
        ros::RosWorld& world = source.stream == map::Stream::Pose ? now_ : ahead_;
        append(all, world.add(source, frame->root(), secondsOf(at_ns)));
        break;
    }
    of_pose |= source.stream == map::Stream::Pose;
  }
  for (ros::WorldResult& result : all) {
    if (isOfBeginning(result, at_ns)) result.unplaced.reset();
  }
  if (of_pose) addPose(all, message.channel->topic, at_ns);
  shift(all);
  return all;
}

bool BlockPlacing::isOfBeginning(const ros::WorldResult& result, std::int64_t at_ns) const {
  if (!result.unplaced) return false;
  // That of markers says how many.
  const Fault& why = result.unplaced->because.empty() ? *result.unplaced : result.unplaced->because.front();
  if (why.code != robot::ros::fault::RosTransformTooOld) return false;
  const std::vector<ros::Transforms::Newest> newest = ahead_.transforms().newest();
  if (at_ns - start_ns_ > kMissingNs || newest.empty() || !result.recorded_s) return false;
  // By the robot's clock.
  return newest.back().stamp_s - *result.recorded_s < secondsOf(kMissingNs + kAheadNs);
}

void BlockPlacing::addPose(ros::WorldResults& results, const std::string& topic, std::int64_t at_ns) {
  const auto now = now_.located();
  if (!now) return;
  ros::WorldResult result = resultOf(topic, at_ns);
  if (now->pose) {
    // A message that does not affect it adds nothing: earlier data is not news at its time.
    const bool brought = !located_ || !(*located_ == *now) || (!now->topic.empty() && now->topic == topic);
    if (!brought) return;
    located_ = *now;
    result.message = map::TrackedPose{*now->pose};
  } else if (at_ns - std::max(block_ns_, start_ns_) > kMissingNs) {
    result.unplaced = now->pose.error();
  }
  results.push_back(std::move(result));
}

}  // namespace mapwright::robot::recorded
