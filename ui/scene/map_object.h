// What is drawn on the map, thing by thing: found at a point, listed, described.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <QString>

#include "geometry/rect.h"
#include "map/submap.h"
#include "ui/scene/layer.h"

namespace mapwright::ui::scene {

/// Whose features: those of a map that is opened, or of the robot's present one.
enum class FeaturesOf { WholeMap, ComparedMap, Robot };

/// Identifies a thing while it is there: a robot that reports it again leaves its id as it is.
struct ObjectId {
  Layer layer = Layer::Robot;
  FeaturesOf of = FeaturesOf::Robot;
  std::string key;         // its id or name; empty = it has none
  std::size_t number = 0;  // its index among all of the layer when it was found; tells equal keys apart

  bool sameAs(const ObjectId& other) const {
    return layer == other.layer && of == other.of && key == other.key &&
           (!key.empty() || number == other.number);
  }
};

/// The submap with this id; nullopt: it is another thing.
std::optional<map::SubmapId> submapOf(const ObjectId& id);

enum class ObjectForm { Point, Line, Area };

/// A row of what is known. Plain text.
struct ObjectProperty {
  QString name, value;
  bool operator==(const ObjectProperty&) const = default;
};

struct MapObject {
  ObjectId id;
  ObjectForm form = ObjectForm::Point;
  QString kind;                                     // "Auto door"
  QString name;                                     // one line of plain text; empty = it has none
  Eigen::Vector2d at_m{0, 0};                       // world; the middle of a line or an area
  std::optional<double> yaw_rad;                    // world, counter-clockwise
  std::vector<std::vector<Eigen::Vector2d>> parts;  // its lines, or its rings; none for a point
  std::int64_t look = 0;                            // which of its layer's looks (LayerSpec::sample)
  std::vector<ObjectProperty> properties;           // what else is known, most important first
  int topic = -1;  // map::topicIndex() of the message that it comes from; -1 = none

  /// A point for one without parts.
  geometry::WorldRect bounds() const;
  /// Of all its lines; 0 for a point.
  double lengthM() const;
  /// Without its holes; 0 unless it is an area.
  double areaM2() const;
};

}  // namespace mapwright::ui::scene
