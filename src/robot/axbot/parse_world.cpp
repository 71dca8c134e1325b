#include <algorithm>

#include <QCoreApplication>

#include "robot/axbot/topic_subjects.h"

namespace mapwright::robot::axbot {
namespace {

class SeenObjectsText {
  Q_DECLARE_TR_FUNCTIONS(SeenObjects)
};

using wire::Json;

/// VisualObjectLabel of the robot's reference; a null text for others.
QString nameOf(std::int64_t label) {
  switch (label) {
    case 1:
      return SeenObjectsText::tr("person");
    case 2:
      return SeenObjectsText::tr("platform hand truck");
    case 3:
      return SeenObjectsText::tr("scaffold");
    case 4:
      return SeenObjectsText::tr("queue stand");
    case 5:
      return SeenObjectsText::tr("portable grandstand");
    default:
      return {};
  }
}

QString rackName(bool aligned) {
  return aligned ? SeenObjectsText::tr("rack (aligned)") : SeenObjectsText::tr("rack");
}

bool isRobotFrame(const Json& object) {
  const std::string frame = wire::text(object, {"frame", "frame_id"});
  return frame == "base_link" || frame == "base_footprint" || frame == "robot";
}

geometry::Pose2 poseOf(const Json& object, bool& usable) {
  const auto given = wire::member(object, {"pose"});
  const auto pose = wire::asPose(given ? *given : object);
  usable = pose.has_value();
  return pose.value_or(geometry::Pose2{});
}

/// Calls `take` for every object in a list member; anything else counts as empty.
template <typename Take>
void forEachObject(const Json& message, wire::Names names, Take take) {
  const auto rows = wire::list(message, names);
  if (!rows) return;
  for (const Json row : *rows) {
    if (row.is_object()) take(row);
  }
}

map::TopicMessage nearbyRobots(const Json& message) {
  map::NearbyRobotsMessage robots;
  forEachObject(message, {"robots"}, [&](const Json& row) {
    bool usable = false;
    map::NearbyRobot robot{wire::text(row, {"uid", "id", "sn"}), poseOf(row, usable),
                           wire::polyline(row, {"trend"}), wire::text(row, {"footprint_digest"})};
    if (usable) robots.robots.push_back(std::move(robot));
  });
  return robots;
}

map::TopicMessage nearbyFootprints(const Json& message) {
  map::NearbyFootprintsMessage footprints;
  forEachObject(message, {"footprints"}, [&](const Json& row) {
    auto outline = wire::polyline(row, {"coordinates", "footprint"});
    if (outline.size() >= 3) footprints.by_digest[wire::text(row, {"digest"})] = std::move(outline);
  });
  return footprints;
}

map::TopicMessage landmarks(const Json& message) {
  map::LandmarksMessage landmarks;
  forEachObject(message, {"landmarks"}, [&](const Json& row) {
    if (const auto at = wire::asPoint(row)) {
      landmarks.landmarks.push_back({wire::text(row, {"id"}), *at, wire::flag(row, {"in_use"})});
    }
  });
  return landmarks;
}

map::TopicMessage autoDoors(const Json& message) {
  map::AutoDoorsMessage doors;
  forEachObject(message, {"doors"}, [&](const Json& row) {
    map::AutoDoor door{wire::text(row, {"name"}), wire::text(row, {"mac"}), wire::text(row, {"state"}), {}};
    door.polygon = wire::polyline(row, {"polygon"});
    if (const auto rings = wire::list(row, {"polygon"}); door.polygon.empty() && rings && rings->size() > 0) {
      door.polygon = wire::asPolyline(rings->at(0).value_unsafe());  // rings, as in GeoJSON
    }
    if (door.polygon.size() >= 2) doors.doors.push_back(std::move(door));
  });
  return doors;
}

std::optional<map::GroundBox> box(const Json& holder, std::string label, std::optional<double> length,
                                  std::optional<double> width, bool in_robot_frame) {
  bool usable = false;
  map::GroundBox box{std::move(label), poseOf(holder, usable), std::max(0.0, length.value_or(0)),
                     std::max(0.0, width.value_or(0)), in_robot_frame};
  return usable ? std::optional(std::move(box)) : std::nullopt;
}

map::TopicMessage pallets(const Json& message) {
  map::PalletsMessage pallets;
  forEachObject(message, {"pallets"}, [&](const Json& row) {
    const Json size = wire::member(row, {"size"}).value_or(row);
    // A fork comes along x: the depth is along it.
    const auto pallet =
        box(row, wire::text(row, {"pallet_id", "id"}), wire::number(size, {"depth", "length"}),
            wire::number(size, {"width"}), isRobotFrame(row));
    if (pallet) pallets.pallets.push_back(*pallet);
  });
  return pallets;
}

map::TopicMessage rack(const Json& message) {
  map::RackMessage rack;
  const bool seen = wire::flag(message, {"rack_detected"}).value_or(true);
  for (const char* name : {"rack_box", "rack_box_aligned"}) {
    const auto given = wire::member(message, {name});
    if (!seen || !given) continue;
    // Seen from above: width along x, height along y.
    const auto found = box(*given, rackName(name != std::string_view("rack_box")).toStdString(),
                           wire::number(*given, {"width"}), wire::number(*given, {"height", "depth"}),
                           isRobotFrame(message));
    if (found) rack.racks.push_back(*found);
  }
  return rack;
}

std::string objectLabel(const Json& row) {
  const auto label = wire::integer(row, {"label"});
  if (label == 0) return {};
  const QString name = nameOf(label.value_or(-1));
  return name.isEmpty() ? wire::text(row, {"label"}) : name.toStdString();
}

map::TopicMessage seenObjects(const Json& message) {
  map::SeenObjectsMessage objects;
  const bool in_robot_frame = isRobotFrame(message);
  forEachObject(message, {"boxes", "objects"}, [&](const Json& row) {
    std::optional<double> width, length;  // dimensions: width, length, height
    if (const auto sizes = wire::list(row, {"dimensions"}); sizes && sizes->size() >= 2) {
      width = wire::asNumber(sizes->at(0).value_unsafe());
      length = wire::asNumber(sizes->at(1).value_unsafe());
    }
    const auto object = box(row, objectLabel(row), length, width, in_robot_frame || isRobotFrame(row));
    if (object) objects.objects.push_back(*object);
  });
  return objects;
}

using Segments = std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>;

/// Segments as [x1, y1, x2, y2], as [[x1, y1], [x2, y2]], or as pairs of points.
Segments segments(const wire::JsonList& rows) {
  Segments segments;
  Eigen::Vector2d start(0, 0);
  bool started = false;
  for (const Json row : rows) {
    wire::JsonList parts;
    if (row.get(parts)) continue;
    const auto flat = wire::asPoint(row);
    if (flat && parts.size() == 4) {
      const auto x = wire::asNumber(parts.at(2).value_unsafe()),
                 y = wire::asNumber(parts.at(3).value_unsafe());
      if (x && y) segments.emplace_back(*flat, Eigen::Vector2d(*x, *y));
    } else if (flat && started) {
      segments.emplace_back(start, *flat);
      started = false;
    } else if (flat) {
      start = *flat;
      started = true;
    } else if (const auto ends = wire::asPolyline(row); ends.size() == 2) {
      segments.emplace_back(ends[0], ends[1]);
    }
  }
  return segments;
}

map::TopicMessage constraints(const Json& message) {
  map::ConstraintsMessage constraints;
  const Json holder = wire::member(message, {"constraints"}).value_or(message);
  simdjson::dom::object members;
  if (holder.get(members)) return constraints;
  for (const auto& [name, value] : members) {
    wire::JsonList rows;
    if (!value.get(rows)) constraints.by_name[std::string(name)] = segments(rows);
  }
  return constraints;
}

map::TopicMessage barcode(const Json& message) {
  const Json code = wire::member(message, {"barcode"}).value_or(message);
  map::BarcodeMessage barcode{wire::text(message, {"state"}), wire::text(code, {"id", "barcode_id"}), {}};
  if (const auto pose = wire::member(code, {"pose"})) barcode.pose = wire::asPose(*pose);
  return barcode;
}

}  // namespace

MaybeMessage readWorldTopic(const std::string& topic, const Json& message) {
  if (topic == "/nearby_robots") return nearbyRobots(message);
  if (topic == "/nearby_robot_footprints") return nearbyFootprints(message);
  if (topic == "/landmarks") return landmarks(message);
  if (topic == "/nearby_auto_doors") return autoDoors(message);
  if (topic == "/detected_pallets") return pallets(message);
  if (topic == "/detected_rack") return rack(message);
  if (topic == "/vision_detected_objects") return seenObjects(message);
  if (topic == "/constraint_list") return constraints(message);
  if (topic == "/collected_barcode") return barcode(message);
  return std::nullopt;
}

}  // namespace mapwright::robot::axbot
