// How a layer tells what it shows, thing by thing (see map_object.h). Private to this room.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <QCoreApplication>

#include "ui/scene/layer_item.h"
#include "ui/scene/map_object.h"
#include "ui/scene/problem_marks.h"

namespace mapwright::session {
class Session;
}

namespace mapwright::ui::scene {

/// Lines, or the rings of an area; a point has one part of one position. World metres.
using ObjectParts = std::span<const std::span<const Eigen::Vector2d>>;
using SeeObject = std::function<void(std::size_t number, ObjectForm form, ObjectParts parts)>;

/// For LayerObjects::key: it has no id and no name.
std::string noKey(const LayerContext& context, FeaturesOf of, std::size_t number);

/// The things of a layer, numbered. The numbers hold until its data changes.
struct LayerObjects {
  void (*visit)(const LayerContext& context, FeaturesOf of, const SeeObject& see);
  /// All but `id`, `form` and `parts`, which follow from visit() and key().
  MapObject (*describe)(const LayerContext& context, FeaturesOf of, std::size_t number);
  std::string (*key)(const LayerContext& context, FeaturesOf of, std::size_t number) = noKey;
  /// Listed; points of sensors and thousands of segments are not.
  bool listed = true;
};

class ObjectText {
  Q_DECLARE_TR_FUNCTIONS(MapObject)
};

void seePoint(const SeeObject& see, std::size_t number, const Eigen::Vector2d& at);
void seePart(const SeeObject& see, std::size_t number, ObjectForm form,
             std::span<const Eigen::Vector2d> part);
template <class Thing>
void seePoints(const std::vector<Thing>& things, const SeeObject& see) {
  for (std::size_t i = 0; i < things.size(); ++i) seePoint(see, i, things[i].position_m);
}
/// A polyline that is the whole layer.
void seeLine(std::span<const Eigen::Vector2d> line, const SeeObject& see);
MapObject oneLine(const QString& kind, std::size_t points, int topic);

QString metres(double value);

/// A property is added if it is known.
class Properties {
 public:
  Properties& add(const QString& name, const QString& value);
  Properties& add(const QString& name, const std::string& value);
  Properties& add(const QString& name, std::optional<bool> value);
  operator std::vector<ObjectProperty>() const { return rows_; }

 private:
  std::vector<ObjectProperty> rows_;
};

class SceneItems;

/// See MapScene.
std::vector<ObjectId> objectsAt(const SceneItems& items, const Eigen::Vector2d& world_m, double reach_px);
std::optional<MapObject> objectOf(const SceneItems& items, const session::Session& session,
                                  const ObjectId& id);
std::vector<MapObject> allObjects(const SceneItems& items, std::size_t most);
/// A mark of what is missing as a thing. Its key says where it is, and what: marks have no order.
ObjectId idOf(const ProblemMark& mark);
/// Where the mark with this id was; nullopt: it is no id of a mark.
std::optional<Eigen::Vector2d> placeOfMark(const ObjectId& id);
MapObject problemObject(const ProblemMark& mark);
/// nullopt: it is not on screen.
std::optional<MapObject> submapObject(const LayerContext& context, const session::Session& session,
                                      const ObjectId& id);

/// How well something fits a click: the nearer and the smaller, the better.
struct ObjectFit {
  double distance_m = 0;  // 0 inside of an area
  double area_m2 = 0;
  auto operator<=>(const ObjectFit&) const = default;
};
/// nullopt: it is not at `world_m`.
std::optional<ObjectFit> fitOf(ObjectForm form, ObjectParts parts, const Eigen::Vector2d& world_m,
                               double reach_m);

}  // namespace mapwright::ui::scene
