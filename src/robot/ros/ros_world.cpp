#include "robot/ros/ros_world.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "robot/ros/map_values.h"
#include "robot/wire/picture_facts.h"

namespace mapwright::robot::ros {
namespace {

using map::Stream;
using Missing = Transforms::Missing;

constexpr const char* kMap = "map";

map::GridKind kindOf(Stream stream) {
  return stream == Stream::CostmapLow    ? map::GridKind::CostmapLow
         : stream == Stream::CostmapHigh ? map::GridKind::CostmapHigh
                                         : map::GridKind::WholeMap;
}

/// sensor_msgs/BatteryState: percentage 0..1, NaN where it is not measured.
map::BatteryState readBattery(const Field& msg) {
  map::BatteryState battery;
  battery.level = msg["percentage"].number();
  // Some drivers count to a hundred.
  if (battery.level && *battery.level > 1 && *battery.level <= 100) *battery.level /= 100;
  battery.voltage_v = msg["voltage"].number();
  battery.current_a = msg["current"].number();
  const auto status = msg["power_supply_status"].integer();
  battery.supply = status == 1 ? "charging" : status == 2 ? "discharging" : status == 4 ? "full" : "";
  return battery;
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
  told_poses_.erase(topic);
  boards_.erase(topic);
}

void RosWorld::forgetAll() {
  transforms_ = {};
  map_frame_.clear();
  first_transform_s_ = latest_s_ = 0;
  grids_.clear();
  waiting_.clear();
  told_poses_.clear();
  boards_.clear();
}

std::string RosWorld::robotFrame() const {
  const std::vector<std::string> frames = transforms_.frames();
  const std::string own = frameName(ns_);
  const auto known = [&](const std::string& frame) {
    return std::binary_search(frames.begin(), frames.end(), frame);
  };
  for (const char* base : {"base_link", "base_footprint"}) {
    if (!own.empty() && known(own + '/' + base)) return own + '/' + base;
  }
  for (const char* base : {"base_link", "base_footprint"}) {
    if (known(base)) return base;
  }
  for (const char* base : {"/base_link", "/base_footprint"}) {
    for (const std::string& frame : frames) {
      if (frame.ends_with(base)) return frame;
    }
  }
  return {};
}

bool RosWorld::fixedByMap() const {
  const std::vector<std::string> frames = transforms_.frames();
  return !map_frame_.empty() || std::binary_search(frames.begin(), frames.end(), kMap);
}

bool RosWorld::posedByTransforms() const {
  const std::string robot = robotFrame();
  return !robot.empty() && transforms_.find(fixedFrame(), robot, {}).has_value();
}

std::string RosWorld::fixedFrame() const {
  if (!map_frame_.empty()) return map_frame_;
  const std::vector<std::string> frames = transforms_.frames();
  if (frames.empty() || std::binary_search(frames.begin(), frames.end(), kMap)) return kMap;
  // Transforms come by and by, those that never change first: their root is none before the others had time.
  if (latest_s_ - first_transform_s_ < kPatienceS) return kMap;
  const std::string robot = robotFrame();
  for (const std::string& root : transforms_.roots()) {
    if (!robot.empty() && root != robot && transforms_.find(root, robot, {})) return root;
  }
  return kMap;
}

tl::expected<geometry::Pose2, Missing> RosWorld::inFixedFrame(const Placed& placed) const {
  const std::string fixed = fixedFrame();
  // A pose may be told once and not again: its frame counts as it lies now.
  const auto found = transforms_.find(fixed, placed.header.frame.empty() ? fixed : placed.header.frame, {});
  if (!found) return tl::make_unexpected(found.error());
  return placedIn(placed, *found);
}

std::optional<tl::expected<geometry::Pose2, map::Reason>> RosWorld::pose() const {
  using Pose = tl::expected<geometry::Pose2, map::Reason>;
  std::optional<map::Reason> why;
  if (const std::string robot = robotFrame(); !robot.empty()) {
    const auto found = transforms_.find(fixedFrame(), robot, {});
    if (found) return Pose(found->flat());
    why = reasonOf(found.error());
  }
  // Where it is on the map goes before where its wheels say that it is.
  for (const Form form : {Form::PoseWithCovariance, Form::PoseStamped, Form::Odometry}) {
    for (const auto& [topic, told] : told_poses_) {
      if (told.form != form) continue;
      const auto pose = inFixedFrame(told.placed);
      if (pose) return Pose(*pose);
      if (!why) why = reasonOf(pose.error());
    }
  }
  if (!why) return std::nullopt;
  return Pose(tl::make_unexpected(std::move(*why)));
}

void RosWorld::takeTf(const Source& source, const Field& msg, WorldResult& result) {
  for (const TfRow& row : readTf(msg))
    transforms_.take(row.parent, row.child, row.transform, row.stamp_s, source.form == Form::StaticTf);
  if (first_transform_s_ == 0) first_transform_s_ = result.received_s;
  latest_s_ = result.received_s;
  for (const Missing& loop : transforms_.loops()) result.notes.push_back(reasonOf(loop));
}

void RosWorld::takePatch(const Source& source, const Field& msg, WorldResult& result) {
  const auto grid = grids_.find(source.base);
  if (grid == grids_.end()) return;  // what it changes has not come
  auto patch = readGridPatch(msg);
  if (!patch) {
    result.unreadable = std::move(patch.error());
    return;
  }
  if (auto why = applyPatch(grid->second, *patch)) {
    result.unreadable = std::move(*why);
    return;
  }
  result.notes = patch->notes;
  result.recorded_s = patch->header.stamp_s;
  Source of = source;
  of.form = Form::Grid;
  of.topic = source.base;
  takeContent(of, grid->second, result);
}

WorldResults RosWorld::take(const Source& source, const Field& msg, double received_s) {
  WorldResult result;
  result.topic = source.topic;
  result.received_s = received_s;
  // What can be read is `take`n, the rest is unreadable.
  const auto with = [&](auto read, auto take) {
    if (!read) {
      result.unreadable = std::move(read.error());
    } else {
      result.recorded_s = read->header.stamp_s;
      take(std::move(*read));
    }
  };
  const auto taking = [&](auto content) { takeContent(source, std::move(content), result); };
  WorldResults results;
  switch (source.form) {
    case Form::Tf:
    case Form::StaticTf:
      takeTf(source, msg, result);
      results = placeWaiting();
      break;
    case Form::Grid:
      with(readGrid(msg), [&](Grid grid) {
        result.notes = grid.notes;
        if (source.stream == Stream::WholeMap) map_frame_ = grid.header.frame;
        if (kept_topics_.contains(source.topic)) grids_.insert_or_assign(source.topic, grid);
        taking(std::move(grid));
      });
      break;
    case Form::GridPatch:
      takePatch(source, msg, result);
      break;
    case Form::Path:
      with(readPath(msg), taking);
      break;
    case Form::Polygon:
      with(readPolygon(msg), taking);
      break;
    case Form::LaserScan:
      with(readLaserScan(msg), taking);
      break;
    case Form::PointCloud:
      with(readPointCloud2(msg), [&](Points points) {
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
               told_poses_.insert_or_assign(source.topic, Told{source.form, std::move(placed)});
             } else {
               taking(std::move(placed));
             }
           });
      break;
    case Form::Markers: {
      auto markers = readMarkers(msg);
      if (!markers) {
        result.unreadable = std::move(markers.error());
        break;
      }
      MarkerBoard& board = boards_[source.topic];
      board.take(*markers, received_s);
      board.expire(received_s);
      Board shown;  // made member by member: g++ 12 takes it for uninitialised otherwise
      shown.markers = board.markers();
      taking(std::move(shown));
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

RosWorld::Placing RosWorld::boxes(const std::vector<Marker>& markers) const {
  map::SeenObjectsMessage seen;
  for (const Marker& marker : markers) {
    const auto found =
        transforms_.find(fixedFrame(), marker.header.frame.empty() ? fixedFrame() : marker.header.frame, {});
    if (!found) return tl::make_unexpected(found.error());
    if (auto box = boxOf(marker, *found)) seen.objects.push_back(std::move(*box));
  }
  return seen;
}

RosWorld::Placing RosWorld::place(const Source& source, const Content& content) const {
  if (const auto* board = std::get_if<Board>(&content)) return boxes(board->markers);
  const Header& header = headerOf(content);
  const std::string fixed = fixedFrame();
  // The outline of the robot is drawn around the robot.
  const std::string into = source.stream == Stream::Model ? robotFrame() : fixed;
  if (into.empty()) return tl::make_unexpected(Missing{Missing::Kind::UnknownFrame, fixed, "base_link"});
  const auto found = transforms_.find(into, header.frame.empty() ? into : header.frame, header.stamp_s);
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
  if (const auto* cloud = std::get_if<Points>(&content)) return placedIn(*cloud, source.topic, *found);
  map::PlanningState planning;
  planning.targets = {placedIn(std::get<Placed>(content), *found)};
  return planning;
}

void RosWorld::takeContent(const Source& source, Content content, WorldResult& result) {
  auto placed = place(source, content);
  if (placed) {
    waiting_.erase(source.topic);  // what is older is of no use any more
    result.message = std::move(*placed);
    return;
  }
  // What is older than all that is known can only get older.
  if (placed.error().kind == Missing::Kind::TooOld) {
    result.unplaced = reasonOf(placed.error());
    return;
  }
  std::deque<Waiting>& queue = waiting_[source.topic];
  const bool told = !queue.empty() && queue.front().told;
  queue.push_back({source, std::move(content), result.received_s, false});
  // One that is known to have no place makes way for the next, and so does the oldest of too many.
  if (told || queue.size() > kWaiting) {
    queue.pop_front();
    queue.front().told = told;
  }
}

WorldResults RosWorld::placeWaiting() {
  WorldResults results;
  for (auto& [topic, queue] : waiting_) {
    for (std::size_t i = queue.size(); i-- > 0;) {
      auto placed = place(queue[i].source, queue[i].content);
      if (!placed) continue;
      WorldResult result;
      result.topic = topic;
      result.received_s = queue[i].received_s;
      result.recorded_s = headerOf(queue[i].content).stamp_s;
      result.message = std::move(*placed);
      results.push_back(std::move(result));
      queue.erase(queue.begin(), queue.begin() + std::ptrdiff_t(i) + 1);
      break;
    }
  }
  std::erase_if(waiting_, [](const auto& topic) { return topic.second.empty(); });
  return results;
}

WorldResults RosWorld::overdue(double now_s) {
  WorldResults results;
  for (auto& [topic, queue] : waiting_) {
    // The newest of those that have waited too long stays, in case that its transform comes all the same.
    while (queue.size() > 1 && now_s - queue[1].received_s > kPatienceS) queue.pop_front();
    Waiting& oldest = queue.front();
    if (oldest.told || now_s - oldest.received_s <= kPatienceS) continue;
    auto placed = place(oldest.source, oldest.content);
    oldest.told = true;
    if (placed) continue;  // told by the next transform
    WorldResult result;
    result.topic = topic;
    result.received_s = oldest.received_s;
    result.unplaced = reasonOf(placed.error());
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace mapwright::robot::ros
