#include "scene/layer_objects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include <QCoreApplication>

#include "geometry/polyline.h"
#include "map/live_topics.h"
#include "scene/legend.h"
#include "scene/scene_items.h"
#include "sentences/overlay_name.h"
#include "words/fixed.h"

namespace mapwright::scene {
namespace {

class ObjectText {
  Q_DECLARE_TR_FUNCTIONS(MapObject)
};

constexpr qsizetype kLongestValue = 200;

QString metres(double value) { return QStringLiteral("%1 m").arg(words::fixed(value, 2)); }
QString percent(double share) { return QStringLiteral("%1 %").arg(std::lround(share * 100)); }
QString plain(const std::string& text) { return shortName(text, kLongestValue); }

/// A property is added if it is known.
class Properties {
 public:
  Properties& add(const QString& name, const QString& value) {
    if (!value.isEmpty()) rows_.push_back({name, value});
    return *this;
  }
  Properties& add(const QString& name, const std::string& value) { return add(name, plain(value)); }
  Properties& add(const QString& name, std::optional<bool> value) {
    return value ? add(name, *value ? ObjectText::tr("yes") : ObjectText::tr("no")) : *this;
  }
  operator std::vector<ObjectProperty>() const { return rows_; }

 private:
  std::vector<ObjectProperty> rows_;
};

void seePoint(const SeeObject& see, std::size_t number, const Eigen::Vector2d& at) {
  const std::span<const Eigen::Vector2d> part(&at, 1);
  see(number, ObjectForm::Point, {&part, 1});
}
void seePart(const SeeObject& see, std::size_t number, ObjectForm form,
             std::span<const Eigen::Vector2d> part) {
  see(number, form, {&part, 1});
}

template <class Thing>
void seePoints(const std::vector<Thing>& things, const SeeObject& see) {
  for (std::size_t i = 0; i < things.size(); ++i) seePoint(see, i, things[i].position_m);
}

std::string onlyOne(const LayerContext&, FeaturesOf, std::size_t) { return {}; }

/// A polyline that is the whole layer.
void seeLine(std::span<const Eigen::Vector2d> line, const SeeObject& see) {
  if (line.size() > 1) seePart(see, 0, ObjectForm::Line, line);
}

MapObject oneLine(const QString& kind, std::size_t points, int topic) {
  MapObject object;
  object.kind = kind;
  object.topic = topic;
  object.properties = Properties().add(ObjectText::tr("Points"), QString::number(points));
  return object;
}

// The robot.

void seeRobot(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  const auto pose = context.robotPose();
  if (!pose) return;
  // It is hit by its mark; its footprint is as much of it.
  seePoint(see, 0, {pose->x_m, pose->y_m});
}

MapObject describeRobot(const LayerContext& context, FeaturesOf, std::size_t) {
  const map::LiveState& live = *context.live;
  MapObject object;
  object.kind = ObjectText::tr("Robot");
  object.topic = map::topicIndex<map::TrackedPose>();
  const auto pose = context.robotPose().value_or(geometry::Pose2());
  object.yaw_rad = pose.yaw_rad;
  Properties known;
  known.add(ObjectText::tr("Localization"), live.slam.state)
      .add(ObjectText::tr("Reliable"), live.slam.reliable);
  if (live.battery && live.battery->level)
    known.add(ObjectText::tr("Battery"), percent(*live.battery->level));
  if (live.planning) known.add(ObjectText::tr("Movement"), live.planning->move_state);
  if (live.model.width_m > 0) known.add(ObjectText::tr("Width"), metres(live.model.width_m));
  object.properties = known;
  return object;
}

// Other robots.

void seeNearby(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  const auto& robots = context.live->nearby_robots;
  for (std::size_t i = 0; i < robots.size(); ++i) seePoint(see, i, {robots[i].pose.x_m, robots[i].pose.y_m});
}

std::string keyOfNearby(const LayerContext& context, FeaturesOf, std::size_t number) {
  return context.live->nearby_robots[number].uid;
}

MapObject describeNearby(const LayerContext& context, FeaturesOf, std::size_t number) {
  const map::NearbyRobot& robot = context.live->nearby_robots[number];
  MapObject object;
  object.kind = ObjectText::tr("Nearby robot");
  object.name = shortName(robot.uid);
  object.yaw_rad = robot.pose.yaw_rad;
  object.topic = map::topicIndex<map::NearbyRobotsMessage>();
  return object;
}

// Doors.

void seeDoors(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  const auto& doors = context.live->doors;
  for (std::size_t i = 0; i < doors.size(); ++i) {
    if (doors[i].polygon.size() >= 3) seePart(see, i, ObjectForm::Area, doors[i].polygon);
  }
}

std::string keyOfDoor(const LayerContext& context, FeaturesOf, std::size_t number) {
  const map::AutoDoor& door = context.live->doors[number];
  return door.mac.empty() ? door.name : door.mac;
}

MapObject describeDoor(const LayerContext& context, FeaturesOf, std::size_t number) {
  const map::AutoDoor& door = context.live->doors[number];
  MapObject object;
  object.kind = ObjectText::tr("Automatic door");
  object.name = shortName(door.name);
  object.look = whichLook(door);
  object.topic = map::topicIndex<map::AutoDoorsMessage>();
  object.properties =
      Properties().add(ObjectText::tr("State"), door.state).add(ObjectText::tr("MAC address"), door.mac);
  return object;
}

// Landmarks.

const std::vector<map::Landmark>& landmarksOf(const LayerContext& context, FeaturesOf of) {
  return of == FeaturesOf::Robot ? context.live->landmarks : context.of(of).landmarks;
}

void seeLandmarks(const LayerContext& context, FeaturesOf of, const SeeObject& see) {
  seePoints(landmarksOf(context, of), see);
}

std::string keyOfLandmark(const LayerContext& context, FeaturesOf of, std::size_t number) {
  return landmarksOf(context, of)[number].id;
}

MapObject describeLandmark(const LayerContext& context, FeaturesOf of, std::size_t number) {
  const map::Landmark& landmark = landmarksOf(context, of)[number];
  MapObject object;
  object.kind = ObjectText::tr("Landmark");
  object.name = shortName(landmark.id);
  object.look = landmark.in_use.value_or(true) ? 1 : 0;
  if (of == FeaturesOf::Robot) object.topic = map::topicIndex<map::LandmarksMessage>();
  object.properties = Properties().add(ObjectText::tr("In use"), landmark.in_use);
  return object;
}

// Overlays.

void seeOverlays(const LayerContext& context, FeaturesOf of, const SeeObject& see) {
  std::vector<std::span<const Eigen::Vector2d>> parts;
  const std::vector<map::OverlayFeature>& features = context.of(of).overlays;
  for (std::size_t i = 0; i < features.size(); ++i) {
    parts.assign(features[i].parts.begin(), features[i].parts.end());
    if (parts.empty() || parts[0].empty()) continue;
    const auto form = features[i].shape == map::OverlayShape::Point  ? ObjectForm::Point
                      : features[i].shape == map::OverlayShape::Line ? ObjectForm::Line
                                                                     : ObjectForm::Area;
    see(i, form, parts);
  }
}

std::string keyOfOverlay(const LayerContext& context, FeaturesOf of, std::size_t number) {
  const map::OverlayFeature& feature = context.of(of).overlays[number];
  return feature.id.empty() ? feature.name : feature.id;
}

MapObject describeOverlay(const LayerContext& context, FeaturesOf of, std::size_t number) {
  const map::OverlayFeature& feature = context.of(of).overlays[number];
  MapObject object;
  object.kind = sentences::nameOf(feature.shape, feature.type);
  object.name = shortName(feature.name);
  object.look = feature.type;
  object.yaw_rad = feature.yaw_rad;
  Properties known;
  known.add(ObjectText::tr("Id"), feature.id)
      .add(ObjectText::tr("Type"), feature.type == 0 ? QString() : QString::number(feature.type));
  if (of == FeaturesOf::Robot) {
    object.topic = map::topicIndex<map::MapInfo>();
    if (const auto& info = context.live->map_info) {
      known.add(ObjectText::tr("Map"), info->name);
      if (info->map_version) known.add(ObjectText::tr("Map version"), QString::number(*info->map_version));
      if (info->overlays_version)
        known.add(ObjectText::tr("Overlays version"), QString::number(*info->overlays_version));
    }
  }
  object.properties = known;
  return object;
}

// Waypoints.

QString markText(WaypointMark mark) {
  switch (mark) {
    case WaypointMark::Saved:
      return {};
    case WaypointMark::Unsaved:
      return ObjectText::tr("changed, not saved");
    case WaypointMark::Sent:
      return ObjectText::tr("sent, not confirmed");
    case WaypointMark::Conflict:
      return ObjectText::tr("in conflict: mine");
    case WaypointMark::New:
      return ObjectText::tr("new, not saved");
    case WaypointMark::Deleted:
      return ObjectText::tr("deleted, not saved");
    case WaypointMark::Theirs:
      return ObjectText::tr("in conflict: theirs");
  }
  return {};
}

void seeWaypoints(const LayerContext& context, FeaturesOf of, const SeeObject& see) {
  seePoints(context.of(of).waypoints, see);
}

std::string keyOfWaypoint(const LayerContext& context, FeaturesOf of, std::size_t number) {
  return context.of(of).waypoints[number].name;
}

MapObject describeWaypoint(const LayerContext& context, FeaturesOf of, std::size_t number) {
  const DrawnWaypoint& point = context.of(of).waypoints[number];
  MapObject object;
  object.kind = ObjectText::tr("Waypoint");
  object.name = shortName(point.name);
  object.look = whichLook(point);
  object.yaw_rad = point.yaw_rad;
  Properties known;
  for (const QString& warning : point.warnings.split(QLatin1Char('\n')))
    known.add(ObjectText::tr("Warning"), warning);
  object.properties = known.add(ObjectText::tr("State"), markText(point.mark))
                          .add(ObjectText::tr("Type"), point.type)
                          .add(ObjectText::tr("Tags"), point.tags);
  return object;
}

// Boxes and drawings.

/// Counted in the order in which they are drawn; with the group that it belongs to.
std::pair<const map::GroundBox*, map::BoxGroup> boxInGroup(const map::LiveState& live, std::size_t number) {
  for (const map::BoxGroup& group : map::boxGroups(live)) {
    if (number < group.boxes->size()) return {&(*group.boxes)[number], group};
    number -= group.boxes->size();
  }
  return {};
}

const map::GroundBox* boxAt(const map::LiveState& live, std::size_t number) {
  return boxInGroup(live, number).first;
}

QString kindOf(map::BoxKind kind) {
  switch (kind) {
    case map::BoxKind::Pallet:
      return ObjectText::tr("Pallet");
    case map::BoxKind::Rack:
      return ObjectText::tr("Rack");
    case map::BoxKind::Charger:
      return ObjectText::tr("Charger");
    case map::BoxKind::Object:
      break;
  }
  return ObjectText::tr("Seen object");
}

std::optional<geometry::Pose2> placeOf(const LayerContext& context, const map::GroundBox& box) {
  if (!box.in_robot_frame) return box.pose;
  const auto robot = context.robotPose();
  return robot ? std::optional(*robot * box.pose) : std::nullopt;
}

void seeBoxes(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  for (std::size_t i = 0;; ++i) {
    const map::GroundBox* const box = boxAt(*context.live, i);
    if (!box) return;
    const auto pose = placeOf(context, *box);
    if (!pose) continue;
    const double a = box->length_m / 2, b = box->width_m / 2;
    if (a > 0 && b > 0) {
      const std::array corners{pose->apply({a, b}), pose->apply({-a, b}), pose->apply({-a, -b}),
                               pose->apply({a, -b})};
      seePart(see, i, ObjectForm::Area, corners);
    } else {
      seePoint(see, i, {pose->x_m, pose->y_m});
    }
  }
}

std::string keyOfBox(const LayerContext& context, FeaturesOf, std::size_t number) {
  const map::GroundBox* const box = boxAt(*context.live, number);
  return box ? box->label : std::string();
}

MapObject describeBox(const LayerContext& context, FeaturesOf, std::size_t number) {
  const auto [at, group] = boxInGroup(*context.live, number);
  const map::GroundBox& box = *at;
  MapObject object;
  object.kind = kindOf(group.kind);
  object.topic = group.topic;
  object.name = shortName(box.label);
  object.look = whichLook(box);
  if (const auto pose = placeOf(context, box)) object.yaw_rad = pose->yaw_rad;
  if (box.length_m > 0 && box.width_m > 0)
    object.properties = Properties().add(
        ObjectText::tr("Size"), QStringLiteral("%1 × %2").arg(metres(box.length_m), metres(box.width_m)));
  return object;
}

// Lines.

void seeConstraints(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  std::size_t number = 0;
  for (const auto& [name, segments] : context.live->constraints.by_name) {
    for (const auto& [from, to] : segments) {
      const std::array line{from, to};
      seePart(see, number++, ObjectForm::Line, line);
    }
  }
}

MapObject describeConstraint(const LayerContext& context, FeaturesOf, std::size_t number) {
  MapObject object;
  object.kind = ObjectText::tr("Constraint");
  object.topic = map::topicIndex<map::ConstraintsMessage>();
  for (const auto& [name, segments] : context.live->constraints.by_name) {
    if (number < segments.size()) {
      object.name = shortName(name);
      object.look = name.find("esidual") != std::string::npos ? 1 : 0;
      break;
    }
    number -= segments.size();
  }
  return object;
}

void seeTrajectories(const LayerContext& context, FeaturesOf of, const SeeObject& see) {
  if (of == FeaturesOf::Robot) return seeLine(context.live->trajectory, see);
  const auto& lines = context.of(of).trajectories;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].size() > 1) seePart(see, i, ObjectForm::Line, lines[i]);
  }
}

MapObject describeTrajectory(const LayerContext& context, FeaturesOf of, std::size_t number) {
  const bool robots = of == FeaturesOf::Robot;
  return oneLine(ObjectText::tr("Trajectory"),
                 robots ? context.live->trajectory.size() : context.of(of).trajectories[number].size(),
                 robots ? map::topicIndex<map::TrajectoryMessage>() : -1);
}

void seePath(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  seeLine(context.live->path, see);
}

MapObject describePath(const LayerContext& context, FeaturesOf, std::size_t) {
  return oneLine(ObjectText::tr("Path"), context.live->path.size(), map::topicIndex<map::PathMessage>());
}

void seeLocalPath(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  seeLine(context.live->local_path.points, see);
}

MapObject describeLocalPath(const LayerContext& context, FeaturesOf, std::size_t) {
  const map::LocalPathMessage& path = context.live->local_path;
  MapObject object =
      oneLine(ObjectText::tr("Local path"), path.points.size(), map::topicIndex<map::LocalPathMessage>());
  if (path.width_m > 0) object.properties.push_back({ObjectText::tr("Width"), metres(path.width_m)});
  return object;
}

void seeTargets(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  if (!context.live->planning) return;
  const auto& targets = context.live->planning->targets;
  for (std::size_t i = 0; i < targets.size(); ++i) seePoint(see, i, {targets[i].x_m, targets[i].y_m});
}

MapObject describeTarget(const LayerContext& context, FeaturesOf, std::size_t number) {
  const map::PlanningState& planning = *context.live->planning;
  MapObject object;
  object.kind = ObjectText::tr("Target");
  object.yaw_rad = planning.targets[number].yaw_rad;
  object.topic = map::topicIndex<map::PlanningState>();
  Properties known;
  known.add(ObjectText::tr("Movement"), planning.move_state)
      .add(ObjectText::tr("Action"), planning.action_type);
  if (planning.remaining_distance_m)
    known.add(ObjectText::tr("Distance left"), metres(*planning.remaining_distance_m));
  known.add(ObjectText::tr("Why it failed"), planning.fail_reason);
  object.properties = known;
  return object;
}

void seeTrail(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  map::Polyline line;
  line.reserve(context.live->trail.size());
  for (const map::TrailPoint& point : context.live->trail) line.push_back(point.position_m);
  seeLine(line, see);
}

MapObject describeTrail(const LayerContext& context, FeaturesOf, std::size_t) {
  return oneLine(ObjectText::tr("Trail"), context.live->trail.size(), map::topicIndex<map::TrackedPose>());
}

void seeTrack(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  if (!context.track) return;
  map::Polyline line;
  line.reserve(context.track->size());
  for (const TrackSample& sample : *context.track) line.push_back(sample.position_m);
  seeLine(line, see);
}

MapObject describeTrack(const LayerContext& context, FeaturesOf, std::size_t) {
  static const Track kNone;
  const Track& track = context.track ? *context.track : kNone;
  MapObject object = oneLine(ObjectText::tr("Track of the bag"), track.size(), -1);
  if (!track.empty())
    object.properties.push_back(
        {ObjectText::tr("Time in the bag"),
         ObjectText::tr("%1 to %2").arg(durationText(track.front().at_s), durationText(track.back().at_s))});
  return object;
}

// Points of sensors.

void seeCloud(const LayerContext& context, FeaturesOf, const SeeObject& see) {
  std::size_t number = 0;
  for (const auto& [topic, cloud] : context.live->clouds) {
    if (!cloud) continue;
    for (const map::CloudPoint& point : *cloud) seePoint(see, number++, {point.x_m, point.y_m});
  }
}

MapObject describeCloudPoint(const LayerContext& context, FeaturesOf, std::size_t number) {
  MapObject object;
  object.kind = ObjectText::tr("Lidar point");
  for (const auto& [topic, cloud] : context.live->clouds) {
    if (!cloud) continue;
    if (number < cloud->size()) {
      const map::CloudPoint& point = (*cloud)[number];
      object.topic = map::topicIndex<map::PointCloudMessage>();
      object.properties = Properties()
                              .add(ObjectText::tr("Height"), metres(point.z_m))
                              .add(ObjectText::tr("Intensity"), QString::number(point.intensity));
      break;
    }
    number -= cloud->size();
  }
  return object;
}

bool inside(ObjectParts rings, const Eigen::Vector2d& p) {
  bool odd = false;
  for (const auto& ring : rings) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const Eigen::Vector2d &a = ring[i], &b = ring[j];
      if ((a.y() > p.y()) != (b.y() > p.y()) &&
          p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x())
        odd = !odd;
    }
  }
  return odd;
}

/// What the layer says of a thing, with what follows from where it lies.
MapObject complete(const LayerObjects& things, const LayerContext& context, const ObjectId& id,
                   ObjectForm form, std::vector<map::Polyline> parts) {
  MapObject object = things.describe(context, id.of, id.number);
  object.id = id;
  object.form = form;
  // A robot often calls a thing by its kind.
  if (object.name.compare(object.kind, Qt::CaseInsensitive) == 0) object.name.clear();
  if (form == ObjectForm::Point) {
    object.at_m = parts[0][0];
    return object;
  }
  object.parts = std::move(parts);
  const map::Polyline& first = object.parts[0];
  // The middle of a line lies on it.
  object.at_m = form == ObjectForm::Line ? first[first.size() / 2] : object.bounds().center();
  return object;
}

std::vector<map::Polyline> copyOf(ObjectParts parts) {
  std::vector<map::Polyline> copy;
  copy.reserve(parts.size());
  for (const auto& part : parts) copy.emplace_back(part.begin(), part.end());
  return copy;
}

/// The present number of `id`, and what it is; nullopt: it is gone.
std::optional<MapObject> findObject(const LayerContext& context, const ObjectId& id) {
  const LayerObjects* const things = objectsOf(id.layer);
  if (!things) return std::nullopt;
  const auto of = id.of;
  // Where it was, or else the first with its key.
  struct Found {
    std::size_t number = 0;
    ObjectForm form = ObjectForm::Point;
    std::vector<map::Polyline> parts;
  };
  std::optional<Found> found;
  things->visit(context, of, [&](std::size_t number, ObjectForm form, ObjectParts parts) {
    const bool same_place = number == id.number;
    if ((found && !same_place) || (id.key.empty() && !same_place)) return;
    if (things->key(context, of, number) != id.key) return;
    found = Found{number, form, copyOf(parts)};
  });
  if (!found) return std::nullopt;
  return complete(*things, context, {id.layer, id.of, id.key, found->number}, found->form,
                  std::move(found->parts));
}

/// Calls `with` for each visible item that has things, the topmost first, with whose features it shows.
template <class With>
void forEachSource(const SceneItems& items, With&& with) {
  for (auto layer = items.order.rbegin(); layer != items.order.rend(); ++layer) {
    const LayerObjects* const things = objectsOf(*layer);
    if (!things) continue;
    for (const LayerItem* item : items.itemsOf(*layer)) {
      if (item->isVisible()) with(*layer, *item, *things, item->of().value_or(FeaturesOf::Robot));
    }
  }
}

}  // namespace

const LayerObjects* objectsOf(Layer layer) {
  static constexpr LayerObjects kRobot{seeRobot, onlyOne, describeRobot};
  static constexpr LayerObjects kNearby{seeNearby, keyOfNearby, describeNearby};
  static constexpr LayerObjects kDoors{seeDoors, keyOfDoor, describeDoor};
  static constexpr LayerObjects kLandmarks{seeLandmarks, keyOfLandmark, describeLandmark};
  static constexpr LayerObjects kOverlays{seeOverlays, keyOfOverlay, describeOverlay};
  static constexpr LayerObjects kWaypoints{seeWaypoints, keyOfWaypoint, describeWaypoint};
  static constexpr LayerObjects kBoxes{seeBoxes, keyOfBox, describeBox};
  static constexpr LayerObjects kConstraints{seeConstraints, onlyOne, describeConstraint, false};
  static constexpr LayerObjects kTrajectories{seeTrajectories, onlyOne, describeTrajectory};
  static constexpr LayerObjects kPath{seePath, onlyOne, describePath};
  static constexpr LayerObjects kLocalPath{seeLocalPath, onlyOne, describeLocalPath};
  static constexpr LayerObjects kTargets{seeTargets, onlyOne, describeTarget};
  static constexpr LayerObjects kTrail{seeTrail, onlyOne, describeTrail};
  static constexpr LayerObjects kTrack{seeTrack, onlyOne, describeTrack};
  static constexpr LayerObjects kCloud{seeCloud, onlyOne, describeCloudPoint, false};
  switch (layer) {
    case Layer::Robot:
      return &kRobot;
    case Layer::NearbyRobots:
      return &kNearby;
    case Layer::Doors:
      return &kDoors;
    case Layer::Landmarks:
      return &kLandmarks;
    case Layer::Overlays:
      return &kOverlays;
    case Layer::Waypoints:
      return &kWaypoints;
    case Layer::Boxes:
      return &kBoxes;
    case Layer::Constraints:
      return &kConstraints;
    case Layer::Trajectory:
      return &kTrajectories;
    case Layer::Path:
      return &kPath;
    case Layer::LocalPath:
      return &kLocalPath;
    case Layer::Target:
      return &kTargets;
    case Layer::Trail:
      return &kTrail;
    case Layer::Track:
      return &kTrack;
    case Layer::Cloud:
      return &kCloud;
    default:
      return nullptr;
  }
}

std::optional<ObjectFit> fitOf(ObjectForm form, ObjectParts parts, const Eigen::Vector2d& world_m,
                               double reach_m) {
  const bool area = form == ObjectForm::Area;
  if (area && inside(parts, world_m)) return ObjectFit{0, std::abs(geometry::signedAreaOf(parts[0]))};
  double nearest = std::numeric_limits<double>::infinity();
  geometry::WorldRect bounds;
  for (const auto& part : parts) {
    if (part.size() == 1) nearest = std::min(nearest, (part[0] - world_m).norm());
    for (std::size_t i = area ? 0 : 1; i < part.size(); ++i)
      nearest = std::min(
          nearest, geometry::distanceToSegment(world_m, part[i], part[i == 0 ? part.size() - 1 : i - 1]));
    if (!area) continue;
    for (const Eigen::Vector2d& point : part) bounds.extend(point);
  }
  if (!(nearest <= reach_m)) return std::nullopt;
  if (!area) return ObjectFit{nearest, 0};
  // One that is thinner than the cursor is hit beside it, too.
  if (std::min(bounds.width(), bounds.height()) > 2 * reach_m) return std::nullopt;
  return ObjectFit{0, std::abs(geometry::signedAreaOf(parts[0]))};
}

std::vector<ObjectId> objectsAt(const SceneItems& items, const Eigen::Vector2d& world_m, double reach_px) {
  constexpr std::size_t kMost = 50;
  const double reach_m = reach_px * items.context.view.scale_m_per_px;
  const QPointF pixel = toPoint(items.context.view.pixelFromWorld(world_m));
  struct Candidate {
    int rank;
    ObjectFit fit;
    ObjectId id;
  };
  std::vector<Candidate> candidates;
  forEachSource(items, [&](Layer layer, const LayerItem& item, const LayerObjects& things, FeaturesOf of) {
    if (item.part() && !item.part()->contains(pixel)) return;
    std::optional<Candidate> nearest;
    things.visit(items.context, of, [&](std::size_t number, ObjectForm form, ObjectParts parts) {
      const auto fit = fitOf(form, parts, world_m, reach_m);
      if (!fit) return;
      // What comes in thousands is not in the way of what comes in dozens.
      const int rank = !things.listed ? 2 : form == ObjectForm::Point ? 0 : form == ObjectForm::Line ? 1 : 3;
      Candidate candidate{rank, *fit, {layer, of, {}, number}};
      if (things.listed) {
        candidate.id.key = things.key(items.context, of, number);
        candidates.push_back(std::move(candidate));
      } else if (!nearest || *fit < nearest->fit) {
        nearest = std::move(candidate);
      }
    });
    if (nearest) candidates.push_back(std::move(*nearest));
  });
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.rank, a.fit) < std::tie(b.rank, b.fit);
  });
  std::vector<ObjectId> ids;
  for (Candidate& candidate : candidates) {
    if (ids.size() < kMost) ids.push_back(std::move(candidate.id));
  }
  const auto covers = [&](const LayerItem& item) {
    return item.isVisible() && (!item.part() || item.part()->contains(pixel));
  };
  if (covers(items.first(Layer::Submaps))) {
    for (auto it = items.context.outlines.rbegin(); it != items.context.outlines.rend(); ++it) {
      if (ids.size() >= kMost) break;
      if (it->second.visible && it->second.contains(world_m))
        ids.push_back({Layer::Submaps, FeaturesOf::Robot, map::toText(it->first), 0});
    }
  }
  for (const auto& [raster, of] : {std::pair(items.raster.compared(), FeaturesOf::ComparedMap),
                                   std::pair(items.raster.whole(), FeaturesOf::WholeMap)}) {
    const auto grid = covers(*raster) ? raster->grid() : std::nullopt;
    if (!grid) continue;
    const Eigen::Vector2d cell = grid->reference.cellFromWorld(world_m);
    if (cell.x() >= 0 && cell.y() >= 0 && cell.x() < grid->reference.width &&
        cell.y() < grid->reference.height)
      ids.push_back({Layer::WholeMap, of, {}, 0});
  }
  return ids;
}

namespace {

std::optional<MapObject> wholeMapObject(const SceneItems& items, const session::Session& session,
                                        const ObjectId& id) {
  const bool compared = id.of == FeaturesOf::ComparedMap;
  const auto grid = (compared ? items.raster.compared() : items.raster.whole())->grid();
  if (!grid) return std::nullopt;
  const session::MapSlot& slot = compared ? session.comparedMap() : session.wholeMap();
  const map::GridReference& reference = grid->reference;
  MapObject object;
  object.id = id;
  object.form = ObjectForm::Area;
  object.kind = ObjectText::tr("Map");
  object.name = shortName(slot.name().toStdString());
  object.yaw_rad = reference.origin.yaw_rad;
  const double width = reference.width * reference.resolution_m,
               height = reference.height * reference.resolution_m;
  const geometry::Pose2& origin = reference.origin;
  object.parts = {{origin.apply({0, 0}), origin.apply({width, 0}), origin.apply({width, height}),
                   origin.apply({0, height})}};
  object.at_m = origin.apply({width / 2, height / 2});
  if (slot.shown().key.kind == map::MapKind::Live) object.topic = map::topicIndex<map::GridMessage>();
  return object;
}

}  // namespace

std::optional<MapObject> objectOf(const SceneItems& items, const session::Session& session,
                                  const ObjectId& id) {
  if (!items.shown.at(id.layer)) return std::nullopt;
  if (id.layer == Layer::Submaps) return submapObject(items.context, session, id);
  if (id.layer == Layer::WholeMap) return wholeMapObject(items, session, id);
  return findObject(items.context, id);
}

ObjectId idOf(const ProblemMark& mark) {
  const QString key =
      QStringLiteral("%1 %2 %3")
          .arg(QString::number(mark.at_m.x(), 'g', 17), QString::number(mark.at_m.y(), 'g', 17), mark.title);
  return {Layer::Problems, FeaturesOf::Robot, key.toStdString(), 0};
}

std::optional<Eigen::Vector2d> placeOfMark(const ObjectId& id) {
  if (id.layer != Layer::Problems) return std::nullopt;
  const QStringList words = QString::fromStdString(id.key).split(QLatin1Char(' '));
  return words.size() < 3 ? std::nullopt
                          : std::optional(Eigen::Vector2d(words[0].toDouble(), words[1].toDouble()));
}

MapObject problemObject(const ProblemMark& mark) {
  MapObject object;
  object.id = idOf(mark);
  object.kind = ObjectText::tr("Missing");
  object.name = mark.title;
  object.at_m = mark.at_m;
  object.look = std::int64_t(mark.kind);
  object.properties = Properties().add(ObjectText::tr("Why"), mark.reason);
  if (mark.submap) object.topic = map::topicIndex<map::SubmapList>();
  return object;
}

std::vector<MapObject> allObjects(const SceneItems& items, std::size_t most) {
  std::vector<MapObject> all;
  forEachSource(items, [&](Layer layer, const LayerItem&, const LayerObjects& things, FeaturesOf of) {
    if (!things.listed) return;
    things.visit(items.context, of, [&](std::size_t number, ObjectForm form, ObjectParts parts) {
      if (all.size() >= most) return;
      const ObjectId id{layer, of, things.key(items.context, of, number), number};
      all.push_back(complete(things, items.context, id, form, copyOf(parts)));
    });
  });
  return all;
}

geometry::WorldRect MapObject::bounds() const {
  geometry::WorldRect bounds;
  for (const map::Polyline& part : parts) {
    for (const Eigen::Vector2d& point : part) bounds.extend(point);
  }
  if (bounds.empty()) bounds.extend(at_m);
  return bounds;
}

double MapObject::lengthM() const {
  double length = 0;
  for (const map::Polyline& part : parts) length += geometry::lengthOf(part);
  return length;
}

double MapObject::areaM2() const {
  if (form != ObjectForm::Area) return 0;
  double area = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double ring = std::abs(geometry::signedAreaOf(parts[i]));
    area += i == 0 ? ring : -ring;
  }
  return area;
}

}  // namespace mapwright::scene
