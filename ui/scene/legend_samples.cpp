// A sample of each thing that layers show, for the legend, cards and lists.
#include <memory>

#include "scene/legend.h"

namespace mapwright::scene {
namespace {

std::vector<Eigen::Vector2d> lineOf(const LegendSample& sample) {
  return {LegendSample::at(-sample.reachPx(), 0), LegendSample::at(sample.reachPx(), 0)};
}

std::vector<Eigen::Vector2d> boxOf(const LegendSample& sample, double half_height_px) {
  return LegendSample::box(sample.reachPx() - 1, half_height_px);
}

map::OverlayFeature overlayOf(const LegendSample& sample, ObjectForm form, int type) {
  map::OverlayFeature feature;
  feature.type = type;
  switch (form) {
    case ObjectForm::Point:
      feature.shape = map::OverlayShape::Point;
      feature.parts = {{LegendSample::at(0, 0)}};
      break;
    case ObjectForm::Line:
      feature.shape = map::OverlayShape::Line;
      feature.parts = {lineOf(sample)};
      break;
    case ObjectForm::Area:
      feature.shape = map::OverlayShape::Polygon;
      feature.parts = {boxOf(sample, 7)};
      break;
  }
  return feature;
}

map::GroundBox boxLike(const LegendSample& sample, ObjectForm form, std::int64_t look) {
  map::GroundBox box;
  if (look >= 0) box.rgba = std::uint32_t(look);
  if (form != ObjectForm::Area) return box;
  box.length_m = 2 * (sample.reachPx() - 1) * LegendSample::kMPerPx;
  box.width_m = 14 * LegendSample::kMPerPx;
  return box;
}

map::NearbyRobot nearbyOf(LegendSample& sample) {
  const double half_px = sample.reachPx() / 2;
  map::NearbyRobot other;
  const Eigen::Vector2d at = LegendSample::at(-half_px, 0);
  other.pose = {at.x(), at.y(), 0};
  other.footprint_digest = "f";
  other.trend = {at, LegendSample::at(sample.reachPx(), 0)};
  sample.live.nearby_footprints["f"] = LegendSample::box(half_px, 7);
  return other;
}

}  // namespace

double LegendSample::reachPx() const { return context.view.width_px / 2.0 - 4; }

std::int64_t whichLook(const DrawnWaypoint& point) {
  return std::int64_t(point.mark) * 2 + (point.warnings.isEmpty() ? 0 : 1);
}
std::int64_t whichLook(const map::AutoDoor& door) {
  return door.state == "open" ? kOpenDoor : door.state == "closed" ? kClosedDoor : kOtherDoor;
}
std::int64_t whichLook(const map::GroundBox& box) { return box.rgba ? std::int64_t(*box.rgba) : -1; }

void fillSample(LegendSample& sample, Layer layer, ObjectForm form, std::int64_t look) {
  map::LiveState& live = sample.live;
  const double reach = sample.reachPx();
  const auto at = &LegendSample::at;
  switch (layer) {
    case Layer::Robot:
      live.robot_pose = geometry::Pose2{};
      return;
    case Layer::NearbyRobots:
      live.nearby_robots = {nearbyOf(sample)};
      return;
    case Layer::Doors:
      live.doors = {{{},
                     {},
                     look == kOpenDoor     ? "open"
                     : look == kClosedDoor ? "closed"
                                           : "",
                     boxOf(sample, 5)}};
      return;
    case Layer::Landmarks:
      live.landmarks = {{{}, at(0, 0), look != 0}};
      return;
    case Layer::Overlays:
      sample.context.of(FeaturesOf::WholeMap).overlays = {overlayOf(sample, form, int(look))};
      return;
    case Layer::Waypoints: {
      DrawnWaypoint point;
      point.mark = WaypointMark(look / 2);
      if (look % 2 == 1) point.warnings = QStringLiteral("!");
      sample.context.of(FeaturesOf::WholeMap).waypoints = {point};
      return;
    }
    case Layer::Boxes:
      live.seen_objects = {boxLike(sample, form, look)};
      return;
    case Layer::Constraints:
      live.constraints.by_name[look == 0 ? "constraints" : "residuals"] = {{at(-reach, 3), at(0, -5)},
                                                                           {at(0, -5), at(reach, 5)}};
      return;
    case Layer::Trajectory:
      live.trajectory = lineOf(sample);
      return;
    case Layer::Path:
      live.path = lineOf(sample);
      return;
    case Layer::LocalPath:
      live.local_path.points = lineOf(sample);
      live.local_path.width_m = 12 * LegendSample::kMPerPx;
      return;
    case Layer::Target: {
      const Eigen::Vector2d place = at(-3, 0);
      live.planning.emplace().targets = {{place.x(), place.y(), 0}};
      return;
    }
    case Layer::Trail:
      for (double x = -reach; x <= reach; x += 2) live.trail.push_back({at(x, 0), x});
      return;
    case Layer::Track: {
      constexpr int kSteps = 200;
      auto track = std::make_shared<Track>();
      for (int i = 0; i <= kSteps; ++i) {
        const double share = double(i) / kSteps;
        track->push_back({at(reach * (2 * share - 1), 0), share, share, int(look), i == 0});
      }
      sample.context.track = track;
      return;
    }
    case Layer::Cloud: {
      auto points = std::make_shared<std::vector<map::CloudPoint>>();
      for (const double x : {-7.0, 0.0, 7.0}) {
        map::CloudPoint point;
        point.x_m = at(x, 0).x();
        points->push_back(point);
      }
      live.clouds[{}] = points;
      return;
    }
    case Layer::Outlines: {
      const auto box = boxOf(sample, 7);
      Outline& outline = sample.context.outlines[{}];
      std::copy(box.begin(), box.end(), outline.corners.begin());
      outline.frozen = look != 0;
      return;
    }
    case Layer::Problems:
      sample.context.submap_marks->put({}, {MarkKind(look), at(0, 0)});
      return;
    default:
      return;
  }
}

}  // namespace mapwright::scene
