#include "pbstream/read_pose_graph.h"

#include <algorithm>
#include <map>
#include <utility>

#include "cartographer/state.pb.h"
#include "pbstream/poses.h"
#include "words/figures.h"

namespace mapwright::pbstream {
namespace {

// Many times the largest known maps. A message of two bytes becomes a value of a hundred.
constexpr std::size_t kMostConstraints = 4'000'000;
constexpr std::size_t kMostNodes = 4'000'000;
constexpr std::size_t kMostOthers = 1'000'000;  // submaps; trajectories; landmarks

/// True while there is room for another one.
bool hasRoom(Wire& wire, std::size_t count, std::size_t most) {
  if (count < most) return true;
  wire.fail({faultText("pbstream", "its pose graph has more than %1 parts of one kind"),
             {words::grouped(std::int64_t(most))}});
  return false;
}

/// In the order of their ids, each id once; how many were left out.
template <typename T>
std::size_t keepFirst(std::vector<T>& of) {
  const auto before = [](const T& a, const T& b) { return a.id < b.id; };
  if (!std::is_sorted(of.begin(), of.end(), before)) std::stable_sort(of.begin(), of.end(), before);
  const auto end = std::unique(of.begin(), of.end(), [](const T& a, const T& b) { return a.id == b.id; });
  const auto left_out = std::size_t(of.end() - end);
  of.erase(end, of.end());
  return left_out;
}

struct Counts {
  std::size_t nodes = 0, twice = 0;
};

void readTrajectory(Wire& wire, map::PoseGraph& graph, Counts& counts) {
  map::Trajectory trajectory;
  std::vector<map::SubmapPose> submaps;
  cartographer_state::TrajectoryNode node;
  cartographer_state::TrajectorySubmap submap;
  wire.message([&](int number) {
    switch (number) {
      case 1:
        wire.read(node);
        if (!wire.good()) return true;
        if (!hasRoom(wire, counts.nodes++, kMostNodes)) return true;
        trajectory.nodes.push_back(
            {{0, node.node_index()}, secondsFromTicks(node.timestamp()), poseFrom(node.pose())});
        return true;
      case 2:
        wire.read(submap);
        if (wire.good() && hasRoom(wire, submaps.size(), kMostOthers))
          submaps.push_back({{0, submap.submap_index()}, poseFrom(submap.pose())});
        return true;
      case 3:
        trajectory.id = std::int32_t(wire.varint());
        return true;
      default:
        return false;
    }
  });
  for (map::TrajectoryNode& one : trajectory.nodes) one.id.trajectory = trajectory.id;
  for (map::SubmapPose& one : submaps) one.id.trajectory = trajectory.id;
  counts.twice += keepFirst(trajectory.nodes);
  if (hasRoom(wire, graph.submaps.size(), kMostOthers))
    graph.submaps.insert(graph.submaps.end(), submaps.begin(), submaps.end());
  if (hasRoom(wire, graph.trajectories.size(), kMostOthers))
    graph.trajectories.push_back(std::move(trajectory));
}

}  // namespace

std::optional<double> secondsFromTicks(std::int64_t ticks) {
  constexpr std::int64_t kEpoch = 621'355'968'000'000'000;
  constexpr std::int64_t kTicksInASecond = 10'000'000;
  if (ticks <= 0) return std::nullopt;
  const std::int64_t since = ticks - kEpoch;
  return double(since / kTicksInASecond) + double(since % kTicksInASecond) / double(kTicksInASecond);
}

ReadGraph readPoseGraph(Wire& wire) {
  ReadGraph read;
  map::PoseGraph& graph = read.graph;
  Counts counts;
  cartographer_state::Constraint constraint;
  cartographer_state::LandmarkPose landmark;
  std::size_t unknown_tags = 0;
  wire.message([&](int number) {
    switch (number) {
      case 2:
        wire.read(constraint);
        if (!wire.good() || !hasRoom(wire, graph.constraints.size(), kMostConstraints)) return true;
        if (constraint.tag() > cartographer_state::Constraint::INTER_SUBMAP || constraint.tag() < 0)
          ++unknown_tags;
        graph.constraints.push_back(
            {idFrom(constraint.submap_id()),
             {constraint.node_id().trajectory_id(), constraint.node_id().node_index()},
             poseFrom(constraint.relative_pose()),
             constraint.tag() == cartographer_state::Constraint::INTRA_SUBMAP ? map::ConstraintKind::Intra
                                                                              : map::ConstraintKind::Inter,
             constraint.translation_weight(),
             constraint.rotation_weight()});
        return true;
      case 4:
        readTrajectory(wire, graph, counts);
        return true;
      case 5:
        wire.read(landmark);
        if (wire.good() && hasRoom(wire, graph.landmarks.size(), kMostOthers))
          graph.landmarks.push_back({landmark.landmark_id(), poseFrom(landmark.global_pose())});
        return true;
      default:
        return false;
    }
  });
  const std::size_t twice = counts.twice + keepFirst(graph.submaps) + keepFirst(graph.trajectories);
  if (twice > 0)
    read.odd.push_back(
        {faultText("pbstream",
                   "trajectories, nodes or submaps that are listed twice: %1; the first of each counts"),
         {words::grouped(std::int64_t(twice))}});
  if (unknown_tags > 0)
    read.odd.push_back(
        {faultText("pbstream", "constraints of a kind that is not known: %1; they count as INTER"),
         {words::grouped(std::int64_t(unknown_tags))}});
  return read;
}

}  // namespace mapwright::pbstream
