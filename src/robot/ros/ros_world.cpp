#include "robot/ros/ros_world.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "robot/ros/drawn_messages.h"
#include "robot/ros/faults.h"
#include "robot/ros/map_values.h"
#include "robot/ros/parts.h"
#include "robot/wire/picture_bytes.h"

namespace mapwright::robot::ros {
namespace {

using map::Stream;
using Missing = Transforms::Missing;

constexpr const char* kMap = "map";
constexpr double kSweepStepS = 0.01;  // how often the pose of a scan is looked up during the sweep
constexpr int kMostSweepSteps = 32;
constexpr double kMarkersEveryS = 0.05;    // how often waiting ones are checked
constexpr std::size_t kMostUnusable = 20;  // frames without a valid transform that are reported
constexpr const char* kBases[] = {"base_link", "base_footprint"};

map::GridKind kindOf(Stream stream) {
  return stream == Stream::CostmapLow    ? map::GridKind::CostmapLow
         : stream == Stream::CostmapHigh ? map::GridKind::CostmapHigh
                                         : map::GridKind::WholeMap;
}

/// sensor_msgs/BatteryState: percentage 0..1, NaN where it is not measured.
map::BatteryState readBattery(const Field& msg) {
  map::BatteryState battery;
  battery.level = msg["percentage"].number();
  // Some drivers use percent.
  if (battery.level && *battery.level > 1 && *battery.level <= 100) *battery.level /= 100;
  battery.voltage_v = msg["voltage"].number();
  battery.current_a = msg["current"].number();
  const auto status = msg["power_supply_status"].integer();
  battery.supply = status == 1 ? "charging" : status == 2 ? "discharging" : status == 4 ? "full" : "";
  return battery;
}

/// What of them is not drawn, or only as a spot.
std::vector<Fault> notShown(const std::vector<Marker>& markers, std::int64_t left_out) {
  std::int64_t meshes = 0, unknown = 0;
  std::string mesh;
  for (const Marker& marker : markers) {
    if (marker.action != Marker::Action::Add) continue;
    if (marker.kind == Marker::Kind::Mesh && ++meshes == 1) mesh = marker.text;
    unknown += marker.kind == Marker::Kind::Other;
  }
  std::vector<Fault> notes;
  if (left_out > 0) notes.push_back({fault::RosMarkersLeftOut, {left_out}});
  if (unknown > 0) notes.push_back({fault::RosMarkersUnknown, {unknown}});
  if (meshes > 0) notes.push_back({fault::RosMeshesAsSpots, {meshes, mesh}});
  return notes;
}

bool isPose(const Source& source) { return source.stream == Stream::Pose; }

}  // namespace

void RosWorld::keepGrids(std::set<std::string> topics) {
  kept_topics_ = std::move(topics);
  std::erase_if(grids_, [&](const auto& kept) { return !kept_topics_.contains(kept.first); });
}

void RosWorld::forget(const std::string& topic) {
  grids_.erase(topic);
  waiting_.erase(topic);
  topic_poses_.erase(topic);
  markers_.forget(topic);
}

void RosWorld::forgetAll() {
  const std::vector<std::string> robots = transforms_.namespaces();
  transforms_ = {};
  transforms_.setNamespaces(robots);
  unusable_.clear();
  map_frame_.clear();
  own_frame_.clear();
  in_own_frame_.clear();
  heard_s_.clear();
  first_transform_s_ = latest_s_ = 0;
  grids_.clear();
  waiting_.clear();
  topic_poses_.clear();
  markers_ = {};
}

std::string RosWorld::robotFrame() const {
  const std::vector<std::string>& robots = transforms_.namespaces();
  return robotFrameOf(robots.empty() ? std::string() : robots.front());
}

std::string RosWorld::robotFrameOf(const std::string& robot) const {
  const Transforms& transforms = transforms_.of(robot + '/');
  const std::string own = frameName(robot.empty() ? ns_ : robot);
  for (const std::string& prefix : {own.empty() ? std::string() : own + '/', std::string()}) {
    for (const char* base : kBases) {
      if (transforms.knows(prefix + base)) return prefix + base;
    }
  }
  const std::vector<std::string> frames = transforms.frames();
  for (const char* base : kBases) {
    for (const std::string& frame : frames) {
      if (frame.ends_with('/' + std::string(base))) return frame;
    }
  }
  return {};
}

std::string RosWorld::shownRobot() const {
  const std::vector<std::string>& robots = transforms_.namespaces();
  for (const std::string& robot : robots) {
    if (!robotFrameOf(robot).empty()) return robot;
  }
  return robots.empty() ? std::string() : robots.front();
}

bool RosWorld::fixedByMap() const { return !map_frame_.empty() || transforms().knows(kMap); }

std::vector<std::pair<Transforms::Newest, double>> RosWorld::ages(double now_s) const {
  std::vector<std::pair<Transforms::Newest, double>> ages;
  const std::vector<Transforms::Newest> pairs = transforms().newest();
  // The robot's clock is its newest stamp plus the time since that transform arrived.
  for (const Transforms::Newest& pair : pairs)
    ages.emplace_back(pair, pairs.back().stamp_s - pair.stamp_s + std::max(0.0, now_s - latest_s_));
  return ages;
}

bool RosWorld::posedByTransforms() const {
  const std::string robot = robotFrame();
  return !robot.empty() && transforms().find(fixedFrame(), robot, {}).has_value();
}

std::optional<std::string> RosWorld::toldFrame() const {
  if (!map_frame_.empty()) return map_frame_;
  if (transforms().knows(kMap)) return kMap;
  // Transforms arrive gradually, static ones first: their root is only valid once the others had time.
  if (first_transform_s_ == 0 || latest_s_ - first_transform_s_ < kLongestWaitS) return std::nullopt;
  const std::string robot = robotFrame();
  for (const std::string& root : transforms().roots()) {
    if (!robot.empty() && root != robot && transforms().find(root, robot, {})) return root;
  }
  return std::nullopt;
}

std::string RosWorld::fixedFrame() const {
  if (!given_frame_.empty()) return given_frame_;
  if (auto told = toldFrame()) return *told;
  return own_frame_.empty() ? kMap : own_frame_;
}

void RosWorld::learnOwnFrame(const Source& source, WorldResult& result) {
  if (!inOwnFrame() || source.stream != Stream::Cloud) return;
  in_own_frame_.insert(source.topic);
  result.notes.emplace_back(fault::RosFrameAlone, std::vector<FaultArgument>{own_frame_});
}

/// Something relates the frames now: data shown before is outdated, unless its position is the same.
void RosWorld::leaveOwnFrame(double now_s, WorldResults& results) {
  if (own_frame_.empty() || !given_frame_.empty() || !toldFrame()) return;
  const bool elsewhere = std::exchange(own_frame_, {}) != *toldFrame();
  for (const std::string& topic : std::exchange(in_own_frame_, {})) {
    if (!elsewhere) break;
    WorldResult gone;
    gone.topic = topic;
    gone.received_s = now_s;
    gone.message = map::PointCloudMessage{topic, std::make_shared<const std::vector<map::CloudPoint>>()};
    results.push_back(std::move(gone));
  }
}

Read<bool> patchGrid(Grid& grid, const GridPatch& patch) {
  const Header &of_grid = grid.header, &of_patch = patch.header;
  if (!of_patch.frame.empty() && !of_grid.frame.empty() && of_patch.frame != of_grid.frame) {
    return tl::unexpected(Fault(fault::RosPatchInOtherFrame, {of_patch.frame, of_grid.frame}));
  }
  // The two topics may overtake each other: a patch that the grid already contains would set it back.
  if (of_patch.stamp_s && of_grid.stamp_s && *of_patch.stamp_s < *of_grid.stamp_s) return false;
  if (auto why = applyPatch(grid, patch)) return tl::unexpected(std::move(*why));
  return true;
}

tl::expected<geometry::Pose2, Missing> RosWorld::inFixedFrame(const std::string& topic,
                                                              const Placed& placed) const {
  const std::string fixed = fixedFrame();
  // A pose may be sent only once: the present pose of its frame is used.
  const std::string& frame = placed.header.frame.empty() ? fixed : placed.header.frame;
  const auto found = transforms_.find(topic, fixed, frame, {});
  if (!found) return tl::make_unexpected(found.error());
  return placedIn(placed, *found);
}

std::optional<tl::expected<geometry::Pose2, Fault>> RosWorld::pose() const {
  std::optional<Located> found = located();
  return found ? std::optional(std::move(found->pose)) : std::nullopt;
}

std::optional<RosWorld::Located> RosWorld::located() const {
  std::optional<Fault> why;
  if (const std::string robot = robotFrame(); !robot.empty()) {
    const std::string fixed = fixedFrame();
    const auto found = transforms().find(fixed, robot, {});
    if (found)
      return Located{found->flat(), {}, transforms().latestCommon(fixed, robot).value_or(std::nullopt)};
    why = reasonOf(found.error());
  }
  // A pose on the map takes precedence over odometry.
  for (const Form form : {Form::PoseWithCovariance, Form::PoseStamped, Form::Odometry}) {
    for (const auto& [topic, told] : topic_poses_) {
      if (told.form != form) continue;
      const auto pose = inFixedFrame(topic, told.placed);
      if (pose) return Located{*pose, topic, {}};
      if (!why) why = reasonOf(pose.error());
    }
  }
  if (!why) return std::nullopt;
  return Located{tl::make_unexpected(std::move(*why)), {}, {}};
}

void RosWorld::onTransforms(const Source& source, const Field& msg, WorldResult& result) {
  for (const TfRow& row : readTf(msg)) {
    const auto taken = transforms_.setTransform(source.topic, row.parent, row.child, row.transform,
                                                row.stamp_s, source.form == Form::StaticTf);
    if (!given_frame_.empty() && taken == Transforms::Taken::Kept) {
      const std::pair frame(namespaceAmong(transforms_.namespaces(), source.topic), frameName(row.child));
      if (source.form == Form::StaticTf) heard_s_.erase(frame);
      if (source.form == Form::Tf) heard_s_[frame] = result.received_s;
    }
    if (taken != Transforms::Taken::NoNumbers) {
      unusable_.erase({source.topic, row.child});
    } else if (unusable_.size() < kMostUnusable) {
      unusable_.insert({source.topic, row.child});
    }
  }
  if (first_transform_s_ == 0) first_transform_s_ = result.received_s;
  latest_s_ = result.received_s;
  if (given_frame_.empty() && latest_s_ - first_transform_s_ > kLongestWaitS) {
    transforms_.trustRoot();
    // Whoever is shown stays so.
    if (ns_.empty() && robotFrame().empty()) transforms_.show(shownRobot());
  }
  // Several nodes share a topic: data of one of them does not fix that of another.
  for (const auto& [topic, child] : unusable_) {
    if (topic == source.topic)
      result.notes.push_back(fieldMissing("transforms[" + child + "].transform").value());
  }
  for (const Missing& loop : transforms_.of(source.topic).loops()) result.notes.push_back(reasonOf(loop));
}

void RosWorld::applyMapPatch(const Source& source, const Field& msg, WorldResult& result) {
  const auto grid = grids_.find(source.base);
  if (grid == grids_.end()) return;  // its grid has not arrived
  auto patch = readGridPatch(msg);
  if (!patch) {
    result.unreadable = std::move(patch.error());
    return;
  }
  const Read<bool> patched = patchGrid(grid->second, *patch);
  if (!patched) result.unreadable = patched.error();
  if (!patched || !*patched) return;
  result.notes = patch->notes;
  result.recorded_s = patch->header.stamp_s;
  Source of = source;
  of.form = Form::Grid;
  of.topic = source.base;
  onContent(of, grid->second, result);
}

void RosWorld::addEarlier(const Source& source, const Field& msg, double received_s) {
  earlier_ = true;
  (void)add(source, msg, received_s);
  earlier_ = false;
}

void RosWorld::forgetSilent(double now_s) {
  std::erase_if(heard_s_, [&](const auto& heard) {
    const bool silent = now_s - heard.second > Transforms::kHistoryS;
    if (silent) transforms_.drop(heard.first.first, heard.first.second);
    return silent;
  });
}

WorldResult RosWorld::add(const Source& source, const Grid& grid, double received_s) {
  WorldResult result;
  result.topic = source.topic;
  result.received_s = received_s;
  result.recorded_s = grid.header.stamp_s;
  result.notes = grid.notes;
  onContent(source, grid, result);
  return result;
}

WorldResults RosWorld::add(const Source& source, const Field& msg, double received_s) {
  WorldResult result;
  result.topic = source.topic;
  result.received_s = received_s;
  // Passes readable messages to `use`, the rest is unreadable.
  const auto with = [&](auto read, auto use) {
    if (!read) {
      result.unreadable = std::move(read.error());
    } else {
      result.recorded_s = read->header.stamp_s;
      use(std::move(*read));
    }
  };
  const auto taking = [&](auto content) { onContent(source, std::move(content), result); };
  WorldResults results;
  switch (source.form) {
    case Form::Tf:
    case Form::StaticTf:
      onTransforms(source, msg, result);
      leaveOwnFrame(received_s, results);
      for (WorldResult& placed : placeWaiting()) results.push_back(std::move(placed));
      if (looksAtMarkers(received_s)) lookAtMarkers(received_s, results);
      break;
    case Form::MapService:
    case Form::Grid:
      with(readGrid(msg), [&](Grid grid) {
        result.notes = grid.notes;
        if (source.stream == Stream::WholeMap) map_frame_ = grid.header.frame;
        leaveOwnFrame(received_s, results);
        if (kept_topics_.contains(source.topic)) grids_.insert_or_assign(source.topic, grid);
        taking(std::move(grid));
      });
      break;
    case Form::GridPatch:
      applyMapPatch(source, msg, result);
      break;
    case Form::Path:
      with(readPath(msg), taking);
      break;
    case Form::Polygon:
      with(readPolygon(msg), taking);
      break;
    case Form::LaserScan:
      with(plainType(source.type) == "sensor_msgs/MultiEchoLaserScan" ? readMultiEchoScan(msg)
                                                                      : readLaserScan(msg),
           taking);
      break;
    case Form::PointCloud:
      with(plainType(source.type) == "sensor_msgs/PointCloud" ? readPointCloud1(msg) : readPointCloud2(msg),
           [&](Points points) {
             result.notes = points.notes;
             taking(std::move(points));
           });
      break;
    case Form::PoseStamped:
    case Form::PoseWithCovariance:
    case Form::Odometry:
      with(source.form == Form::PoseStamped          ? readPoseStamped(msg)
           : source.form == Form::PoseWithCovariance ? readPoseWithCovariance(msg)
                                                     : readOdometry(msg),
           [&](Placed placed) {
             if (isPose(source)) {
               topic_poses_.insert_or_assign(source.topic, TopicPose{source.form, std::move(placed)});
             } else {
               taking(std::move(placed));
             }
           });
      break;
    case Form::PoseArray:
      with(readPoseArray(msg), taking);
      break;
    case Form::Markers: {
      const std::string type = plainType(source.type);
      std::int64_t left_out = 0;
      auto markers = isDrawn(type) ? readDrawn(type, msg, source.topic) : readMarkers(msg, &left_out);
      if (!markers) {
        result.unreadable = std::move(markers.error());
        break;
      }
      if (earlier_) {
        markers_.settle(source.topic, *markers, transforms_, fixedFrame(), received_s);
        break;
      }
      result.notes = notShown(*markers, left_out);
      markers_.apply(source.topic, *markers, received_s);
      lookAtMarkers(received_s, results);
      std::erase_if(results, [&](WorldResult& one) {
        if (one.topic != source.topic) return false;
        result.unplaced = std::move(one.unplaced);
        return true;
      });
      result.message = markers_.seen();
      break;
    }
    case Form::Battery:
      result.message = readBattery(msg);
      break;
  }
  results.push_back(std::move(result));
  return results;
}

const Header& RosWorld::headerOf(const Content& content) {
  return std::visit([](const auto& one) -> const Header& { return one.header; }, content);
}

RosWorld::Placing RosWorld::placeScan(const Points& points, const std::string& topic, const std::string& into,
                                      const Transform3& beginning, Sweep sweep) const {
  std::vector<Transform3> along{beginning};
  const Header& header = points.header;
  const std::string& frame = header.frame.empty() ? into : header.frame;
  if (sweep == Sweep::Beginning || points.sweep_s <= 0 || !header.stamp_s || frame == into)
    return placedAlong(points, topic, along);
  const int steps = std::clamp(int(std::ceil(points.sweep_s / kSweepStepS)), 1, kMostSweepSteps);
  for (int step = 1; step <= steps; ++step) {
    const auto found = transforms_.find(topic, into, frame, *header.stamp_s + points.sweep_s * step / steps);
    if (!found) return tl::make_unexpected(found.error());
    along.push_back(*found);
  }
  return placedAlong(points, topic, along);
}

RosWorld::Placing RosWorld::place(const Source& source, const Content& content, Sweep sweep) const {
  const Header& header = headerOf(content);
  const std::string fixed = fixedFrame();
  // The robot's footprint is drawn around the robot.
  const std::string into = source.stream == Stream::Model
                               ? robotFrameOf(namespaceAmong(transforms_.namespaces(), source.topic))
                               : fixed;
  if (into.empty()) return tl::make_unexpected(Missing{Missing::Kind::UnknownFrame, fixed, "base_link"});
  const auto found =
      transforms_.find(source.topic, into, header.frame.empty() ? into : header.frame, header.stamp_s);
  if (!found) return tl::make_unexpected(found.error());
  if (const auto* grid = std::get_if<Grid>(&content)) {
    map::GridMessage message = gridMessage(*grid, source.topic, kindOf(source.stream), *found);
    message.fingerprint = wire::fingerprint(*message.png);
    return message;
  }
  if (const auto* outline = std::get_if<Outline>(&content)) {
    map::Polyline points = placedIn(*outline, *found);
    if (source.stream == Stream::Path) return map::PathMessage{std::move(points)};
    if (source.stream == Stream::LocalPath) return map::LocalPathMessage{0, std::nullopt, std::move(points)};
    map::RobotModel model;
    model.footprint = std::move(points);
    return model;
  }
  if (const auto* cloud = std::get_if<Points>(&content))
    return placeScan(*cloud, source.topic, into, *found, sweep);
  map::PlanningState planning;
  if (const auto* poses = std::get_if<Poses>(&content)) {
    planning.targets = placedIn(*poses, *found);
  } else {
    planning.targets = {placedIn(std::get<Placed>(content), *found)};
  }
  return planning;
}

void RosWorld::onContent(const Source& source, Content content, WorldResult& result) {
  auto placed = place(source, content, Sweep::Whole);
  if (placed) {
    waiting_.erase(source.topic);  // older ones are useless now
    result.message = std::move(*placed);
    learnOwnFrame(source, result);
    return;
  }
  if (!given_frame_.empty()) {
    // If the end of a scan's sweep is unknown, its beginning is used.
    placed = place(source, content, Sweep::Beginning);
    if (placed) {
      result.message = std::move(*placed);
      learnOwnFrame(source, result);
    } else {
      result.unplaced = reasonOf(placed.error());
    }
    return;
  }
  // Data older than all transforms only gets older.
  if (placed.error().kind == Missing::Kind::TooOld) {
    result.unplaced = reasonOf(placed.error());
    return;
  }
  Queue& queue = waiting_[source.topic];
  if (queue.messages.empty()) queue.since_s = result.received_s;
  queue.messages.push_back({source, std::move(content), result.received_s});
  // One that cannot be placed makes room for the next, and so does the oldest of too many.
  if (!queue.told && queue.messages.size() <= kWaiting) return;
  queue.messages.pop_front();
  ++replaced_;
}

WorldResults RosWorld::placeWaiting() {
  WorldResults results;
  for (auto& [topic, queue] : waiting_) {
    std::deque<Waiting>& messages = queue.messages;
    for (std::size_t i = messages.size(); i-- > 0;) {
      auto placed = place(messages[i].source, messages[i].content, Sweep::Whole);
      if (!placed) continue;
      WorldResult result;
      result.topic = topic;
      result.received_s = messages[i].received_s;
      result.recorded_s = headerOf(messages[i].content).stamp_s;
      result.message = std::move(*placed);
      results.push_back(std::move(result));
      messages.erase(messages.begin(), messages.begin() + std::ptrdiff_t(i) + 1);
      queue.told = false;
      if (!messages.empty()) queue.since_s = messages.front().received_s;
      break;
    }
  }
  std::erase_if(waiting_, [](const auto& topic) { return topic.second.messages.empty(); });
  return results;
}

bool RosWorld::looksAtMarkers(double now_s) const {
  if (earlier_) return markers_.waits();
  // A recording is looked at again and again, and tells the same each time: at every transform.
  const bool exact = !given_frame_.empty() && !markers_.many();
  if (exact) return markers_.waits() || markers_.moves();
  return markers_.waits() && std::abs(now_s - markers_looked_s_) >= kMarkersEveryS;
}

void RosWorld::lookAtMarkers(double now_s, WorldResults& results) {
  markers_looked_s_ = now_s;
  const SeenMarkers::Look look = markers_.look(transforms_, fixedFrame(), now_s);
  bool told = !look.changed;  // one message contains those of all topics
  for (const std::string& topic : markers_.topics()) {
    const auto why = look.unplaced.find(topic);
    if (told && why == look.unplaced.end()) continue;
    WorldResult result;
    result.topic = topic;
    result.received_s = now_s;
    if (why != look.unplaced.end()) result.unplaced = why->second;
    if (!std::exchange(told, true)) result.message = markers_.seen();
    results.push_back(std::move(result));
  }
}

WorldResults RosWorld::overdue(double now_s) {
  WorldResults results;
  for (auto& [topic, queue] : waiting_) {
    std::deque<Waiting>& messages = queue.messages;
    // The newest of those that waited too long stays, in case its transform still arrives.
    while (messages.size() > 1 && now_s - messages[1].received_s > kLongestWaitS) messages.pop_front();
    if (queue.told || now_s - queue.since_s <= kLongestWaitS) continue;
    const Waiting& oldest = messages.front();
    // If the end of a scan's sweep is unknown, its beginning is used.
    auto placed = place(oldest.source, oldest.content, Sweep::Beginning);
    const std::string& frame = headerOf(oldest.content).frame;
    const bool may_be_told = first_transform_s_ > 0 && now_s - first_transform_s_ < kLongestWaitS;
    if (!placed && own_frame_.empty() && !toldFrame() && !may_be_told && !frame.empty() &&
        oldest.source.stream == Stream::Cloud) {
      own_frame_ = ownFrameOf(frame);
      placed = place(oldest.source, oldest.content, Sweep::Beginning);
    }
    queue.told = !placed;
    WorldResult result;
    result.topic = topic;
    result.received_s = oldest.received_s;
    if (placed) {
      result.recorded_s = headerOf(oldest.content).stamp_s;
      result.message = std::move(*placed);
      learnOwnFrame(oldest.source, result);
      messages.pop_front();
      queue.since_s = now_s;
    } else {
      result.unplaced = reasonOf(placed.error());
    }
    results.push_back(std::move(result));
  }
  std::erase_if(waiting_, [](const auto& topic) { return topic.second.messages.empty(); });
  lookAtMarkers(now_s, results);
  return results;
}

}  // namespace mapwright::robot::ros
