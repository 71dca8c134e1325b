#include "ui/scene/layer_objects.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "geometry/polyline.h"
#include "map/live_topics.h"
#include "ui/scene/scene_items.h"
#include "words/fixed.h"

namespace mapwright::ui::scene {

QString metres(double value) { return QStringLiteral("%1 m").arg(words::fixed(value, 2)); }

Properties& Properties::add(const QString& name, const QString& value) {
  if (!value.isEmpty()) rows_.push_back({name, value});
  return *this;
}
Properties& Properties::add(const QString& name, const std::string& value) {
  constexpr qsizetype kLongestValue = 200;
  return add(name, shortName(value, kLongestValue));
}
Properties& Properties::add(const QString& name, std::optional<bool> value) {
  return value ? add(name, *value ? ObjectText::tr("yes") : ObjectText::tr("no")) : *this;
}

std::string noKey(const LayerContext&, FeaturesOf, std::size_t) { return {}; }

void seePoint(const SeeObject& see, std::size_t number, const Eigen::Vector2d& at) {
  const std::span<const Eigen::Vector2d> part(&at, 1);
  see(number, ObjectForm::Point, {&part, 1});
}

void seePart(const SeeObject& see, std::size_t number, ObjectForm form,
             std::span<const Eigen::Vector2d> part) {
  see(number, form, {&part, 1});
}

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

namespace {

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
  const LayerObjects* const things = specOf(id.layer).objects;
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
    const bool same_number = number == id.number;
    if ((found && !same_number) || (id.key.empty() && !same_number)) return;
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
    const LayerObjects* const things = specOf(*layer).objects;
    if (!things) continue;
    for (const LayerItem* item : items.itemsOf(*layer)) {
      if (item->isVisible()) with(*layer, *item, *things, item->of().value_or(FeaturesOf::Robot));
    }
  }
}

}  // namespace

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
    if (!nearest) return;
    nearest->id.key = things.key(items.context, of, nearest->id.number);
    candidates.push_back(std::move(*nearest));
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

}  // namespace mapwright::ui::scene
