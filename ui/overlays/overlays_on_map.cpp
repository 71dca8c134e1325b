#include "ui/overlays/overlays_on_map.h"

#include <algorithm>
#include <charconv>
#include <numbers>

#include "overlays/overlay_shapes.h"
#include "scene/drawing.h"

namespace mapwright::window {
namespace {

map::OverlayShape drawnShape(overlays::Shape shape) {
  return shape == overlays::Shape::Line      ? map::OverlayShape::Line
         : shape == overlays::Shape::Polygon ? map::OverlayShape::Polygon
                                             : map::OverlayShape::Point;
}

int typeAs(const Feature& feature, overlays::Shape shape) {
  const auto value = feature.property(overlays::typeProperty(shape));
  if (!value) return 0;
  const std::string written =
      value->kind() == overlays::JsonKind::String ? value->string() : std::string(value->text());
  int type = 0;
  std::from_chars(written.data(), written.data() + written.size(), type);
  return type;
}

/// As the layer draws it: several for a shape of several parts.
std::vector<map::OverlayFeature> partsToDraw(const Feature& feature) {
  std::vector<map::OverlayFeature> parts;
  int polygon = -1;
  for (overlays::Path& path : overlays::shapesOf(feature).paths) {
    if (path.points.empty()) continue;
    if (path.shape == overlays::Shape::Polygon && path.polygon == polygon && !parts.empty()) {
      parts.back().parts.push_back(std::move(path.points));
      continue;
    }
    polygon = path.polygon;
    map::OverlayFeature drawn;
    drawn.shape = drawnShape(path.shape);
    drawn.type = typeAs(feature, path.shape);
    drawn.id = feature.id();
    drawn.name = feature.name();
    const auto degrees = overlays::yawOf(feature);
    if (drawn.shape == map::OverlayShape::Point && degrees) drawn.yaw_rad = *degrees * std::numbers::pi / 180;
    drawn.parts.push_back(std::move(path.points));
    parts.push_back(std::move(drawn));
  }
  return parts;
}

}  // namespace

OverlaysOnMap::OverlaysOnMap(OverlayEditing* editing, scene::MapScene* scene, QObject* parent)
    : QObject(parent), editing_(editing), scene_(scene) {
  for (const auto signal : {&OverlayEditing::changed, &OverlayEditing::previewChanged})
    connect(editing_, signal, this, &OverlaysOnMap::draw);
}

void OverlaysOnMap::setMap(const map::MapKey& map, bool robots) {
  if (map == map_ && robots == robots_) return;
  map_ = map;
  robots_ = robots;
  draw();
}

void OverlaysOnMap::draw() {
  keys_.clear();
  if (!editing_->isOpen()) {
    drawn_.clear();
    return scene_->setOverlays(std::nullopt);
  }
  scene::DrawnOverlays drawn{map_, robots_, {}};
  for (FeatureKey key = 0; key < editing_->document().size(); ++key) {
    const Feature* const feature = editing_->find(key);
    if (!feature) {
      drawn_.erase(key);
      continue;
    }
    auto known = drawn_.find(key);
    // Features never change: it is the same text or another feature.
    if (known == drawn_.end() || &known->second.feature.text() != &feature->text())
      known = drawn_.insert_or_assign(key, Drawn{*feature, partsToDraw(*feature)}).first;
    for (const map::OverlayFeature& part : known->second.parts) {
      drawn.features.push_back(part);
      keys_.push_back(key);
    }
  }
  scene_->setOverlays(std::move(drawn));
}

std::optional<FeatureKey> OverlaysOnMap::at(const Eigen::Vector2d& world_m, double reach_px) const {
  for (const scene::ObjectId& id : scene_->objectsAt(world_m, reach_px)) {
    if (id.layer == scene::Layer::Overlays && scene_->showsEditedOverlays(id.of) && id.number < keys_.size())
      return keys_[id.number];
  }
  return std::nullopt;
}

void OverlaysOnMap::eachShape(
    const std::function<void(FeatureKey, const std::vector<overlays::Path>& paths)>& with) const {
  for (const auto& [key, drawn] : drawn_) {
    std::vector<overlays::Path> paths;
    for (const map::OverlayFeature& part : drawn.parts) {
      const overlays::Shape shape = part.shape == map::OverlayShape::Line      ? overlays::Shape::Line
                                    : part.shape == map::OverlayShape::Polygon ? overlays::Shape::Polygon
                                                                               : overlays::Shape::Point;
      for (const auto& points : part.parts) paths.push_back({shape, points});
    }
    with(key, paths);
  }
}

std::set<FeatureKey> OverlaysOnMap::within(const QRectF& frame_px) const {
  std::set<FeatureKey> keys;
  for (const auto& [key, drawn] : drawn_) {
    bool inside = !drawn.parts.empty();
    for (const map::OverlayFeature& part : drawn.parts) {
      for (const auto& points : part.parts) {
        inside = inside && std::all_of(points.begin(), points.end(), [&](const Eigen::Vector2d& point) {
                   return frame_px.contains(scene::toPoint(scene_->view().pixelFromWorld(point)));
                 });
      }
    }
    if (inside) keys.insert(key);
  }
  return keys;
}

}  // namespace mapwright::window

#include "moc_overlays_on_map.cpp"
