#include "robot/recorded/block_placing.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "robot/ros/faults.h"

namespace mapwright::robot::recorded {
namespace {

constexpr std::int64_t kFirstNs = 60'000'000'000;  // at the start of a file, when static data is sent
constexpr int kMostOfFirst = 2000, kMostOfLast = 16;
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

void StaticTransforms::add(std::vector<Transform>& all, const recording::Message& message) {
  // One that cannot be read is reported in its own block.
  if (auto frame = fields_.read(message))
    all.push_back({message.channel->topic, message.log_time_ns, std::move(*frame)});
}

const std::vector<StaticTransforms::Transform>& StaticTransforms::until(std::int64_t at_ns) {
  if (shape_.statics.empty()) return until_;
  if (!first_) {
    first_.emplace();
    recording::Query query;
    query.topics = shape_.statics;
    if (const auto start_ns = file_.summary().start_ns) query.last_ns = *start_ns + kFirstNs;
    const auto cursor = file_.messages(query);
    for (int count = 0; count < kMostOfFirst; ++count) {
      const auto message = cursor->next();
      if (!message) break;
      add(*first_, *message);
    }
  }
  // Some publishers share a topic, each sending its own part: the last message alone is incomplete.
  std::vector<recording::Message> last;
  std::int64_t before_ns = at_ns;
  for (int count = 0; count < kMostOfLast; ++count) {
    const std::vector<recording::Message> found = file_.lastBefore(before_ns, shape_.statics);
    if (found.empty() && count == 0) last_ns_ = -1;
    if (found.empty()) break;
    const auto latest = std::max_element(found.begin(), found.end(), [](const auto& a, const auto& b) {
      return a.log_time_ns < b.log_time_ns;
    });
    if (count == 0 && latest->log_time_ns == last_ns_) return until_;
    if (count == 0) last_ns_ = latest->log_time_ns;
    before_ns = latest->log_time_ns - 1;
    last.push_back(*latest);
    if (!first_->empty() && latest->log_time_ns <= first_->back().at_ns) break;
  }
  until_.clear();
  std::copy_if(first_->begin(), first_->end(), std::back_inserter(until_),
               [&](const Transform& one) { return one.at_ns <= at_ns; });
  for (auto message = last.rbegin(); message != last.rend(); ++message) add(until_, *message);
  return until_;
}

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
      next_look_ns_(block_ns - kBeforeNs) {
  for (ros::RosWorld* const world : {&ahead_, &now_}) {
    world->setRobots(parts_.shape.robots);
    if (parts_.shape.root_serves) world->trustRoot();
    world->placeAtOnce(parts_.shape.fixed_frame, parts_.shape.own_frame);
  }
  readStatics();
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

void BlockPlacing::readStatics() {
  for (const StaticTransforms::Transform& one : parts_.statics.until(block_ns_ - kBeforeNs - 1)) {
    for (const ros::Source& source : parts_.shape.by_topic.at(one.topic)) {
      ahead_.take(source, one.frame->root(), secondsOf(one.at_ns));
      now_.take(source, one.frame->root(), secondsOf(one.at_ns));
    }
  }
}

void BlockPlacing::readBefore(std::int64_t from_ns) {
  std::vector<std::string> kept = parts_.shape.poses;
  kept.insert(kept.end(), parts_.shape.markers.begin(), parts_.shape.markers.end());
  const std::int64_t first_ns = block_ns_ - kBeforeNs;
  if (!kept.empty()) {
    std::vector<recording::Message> last = parts_.file.lastBefore(first_ns - 1, kept);
    std::stable_sort(last.begin(), last.end(),
                     [](const auto& a, const auto& b) { return a.log_time_ns < b.log_time_ns; });
    for (const recording::Message& message : last) {
      if (const auto frame = parts_.fields.read(message)) takeNow(message, *frame);
    }
  }
  recording::Query query;
  query.first_ns = first_ns;
  query.last_ns = from_ns - 1;
  query.topics = kept;
  query.topics.insert(query.topics.end(), parts_.shape.transforms.begin(), parts_.shape.transforms.end());
  if (query.topics.empty() || query.last_ns < query.first_ns) return;
  const auto cursor = parts_.file.messages(query);
  while (const auto message = cursor->next()) {
    before(message->log_time_ns);
    if (const auto frame = parts_.fields.read(*message)) take(*message, *frame);
  }
  before(from_ns - 1);
}

void BlockPlacing::advance(std::int64_t until_ns) {
  while (lead_ && lead_->log_time_ns <= until_ns) {
    if (const auto frame = parts_.fields.read(*lead_)) {
      for (const ros::Source& source : parts_.shape.by_topic.at(lead_->channel->topic))
        ahead_.take(source, (*frame)->root(), secondsOf(lead_->log_time_ns));
    }
    lead_ = leading_->next();
  }
}

ros::WorldResults BlockPlacing::before(std::int64_t at_ns) {
  ros::WorldResults all;
  if (parts_.shape.markers.empty()) return all;
  for (; next_look_ns_ <= at_ns; next_look_ns_ += kMarkersEveryNs) {
    endMarkers(next_look_ns_, all);
    append(all, now_.overdue(secondsOf(next_look_ns_)));
    if (next_look_ns_ < block_ns_ || std::exchange(told_beginning_, true) || !any_markers_) continue;
    all.push_back(resultOf(parts_.shape.markers.front(), next_look_ns_));
    all.back().message = now_.seenObjects();
  }
  endMarkers(at_ns, all);
  return all;
}

void BlockPlacing::endMarkers(std::int64_t until_ns, ros::WorldResults& results) {
  while (now_.nextMarkerEnd() <= secondsOf(until_ns)) append(results, now_.overdue(now_.nextMarkerEnd()));
}

ros::WorldResults BlockPlacing::takeNow(const recording::Message& message, const FramePtr& frame) {
  ros::WorldResults all;
  for (const ros::Source& source : parts_.shape.by_topic.at(message.channel->topic)) {
    any_markers_ |= source.form == ros::Form::Markers;
    append(all, now_.take(source, frame->root(), secondsOf(message.log_time_ns)));
  }
  return all;
}

ros::WorldResult BlockPlacing::takeGrid(const ros::Source& source, const ros::Field& msg,
                                        std::int64_t at_ns) {
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
  return ahead_.take(source, *grid, secondsOf(at_ns));
}

ros::WorldResult BlockPlacing::takePatch(const ros::Source& source, const ros::Field& msg,
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
  result = ahead_.take(of, whole, secondsOf(at_ns));
  result.topic = source.topic;
  result.recorded_s = patch->header.stamp_s;
  return result;
}

ros::WorldResults BlockPlacing::take(const recording::Message& message, const FramePtr& frame) {
  const std::int64_t at_ns = message.log_time_ns;
  advance(at_ns + kAheadNs);
  ros::WorldResults all;
  bool of_pose = false;
  for (const ros::Source& source : parts_.shape.by_topic.at(message.channel->topic)) {
    switch (source.form) {
      case ros::Form::Tf:
      case ros::Form::StaticTf:
      case ros::Form::Markers:
        any_markers_ |= source.form == ros::Form::Markers;
        append(all, now_.take(source, frame->root(), secondsOf(at_ns)));
        break;
      case ros::Form::MapService:
        all.push_back(takeGrid(source, frame->root()["map"], at_ns));
        break;
      case ros::Form::Grid:
        all.push_back(takeGrid(source, frame->root(), at_ns));
        break;
      case ros::Form::GridPatch:
        all.push_back(takePatch(source, frame->root(), at_ns));
        break;
      default:
        // Poses use the latest data, everything else its own stamp.
        ros::RosWorld& world = source.stream == map::Stream::Pose ? now_ : ahead_;
        append(all, world.take(source, frame->root(), secondsOf(at_ns)));
        break;
    }
    of_pose |= source.stream == map::Stream::Pose;
  }
  for (ros::WorldResult& result : all) {
    if (isOfBeginning(result, at_ns)) result.unplaced.reset();
  }
  if (of_pose) addPose(all, message.channel->topic, at_ns);
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
