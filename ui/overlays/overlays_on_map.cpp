#include "ui/overlays/overlays_on_map.h"

#include <algorithm>
#include <utility>

#include "overlays/drawn_parts.h"
#include "ui/overlays/overlay_text.h"
#include "ui/scene/drawing.h"

namespace mapwright::ui {

OverlaysOnMap::OverlaysOnMap(edit::OverlayEditing* editing, scene::MapScene* scene, QObject* parent)
    : QObject(parent), editing_(editing), scene_(scene) {
  connect(editing_, &edit::OverlayEditing::changed, this, &OverlaysOnMap::draw);
  connect(editing_, &edit::OverlayEditing::previewChanged, this, &OverlaysOnMap::drawPreview);
}

void OverlaysOnMap::setMap(const map::MapKey& map, bool robots) {
  if (map == map_ && robots == robots_) return;
  map_ = map;
  robots_ = robots;
  draw();
}

bool OverlaysOnMap::updateDrawn(FeatureKey key) {
  Drawn& drawn = drawn_[key];
  const Feature* const feature = editing_->find(key);
  // Features never change: it is the same text or another feature.
  if (feature ? drawn.feature && &drawn.feature->text() == &feature->text() : !drawn.feature) return true;
  const std::size_t before = drawn.parts.size();
  drawn.feature = feature ? std::optional(*feature) : std::nullopt;
  drawn.parts = feature ? overlays::partsToDraw(*feature) : std::vector<map::OverlayFeature>();
  return drawn.parts.size() == before;
}

void OverlaysOnMap::draw() {
  keys_.clear();
  of_preview_.clear();
  all_ = {map_, robots_, {}};
  if (!editing_->isOpen()) {
    drawn_.clear();
    return scene_->setOverlays(std::nullopt);
  }
  drawn_.resize(editing_->document().size());
  all_.features.reserve(drawn_.size());
  keys_.reserve(drawn_.size());
  for (FeatureKey key = 0; key < drawn_.size(); ++key) {
    updateDrawn(key);
    drawn_[key].first = keys_.size();
    for (const map::OverlayFeature& part : drawn_[key].parts) {
      all_.features.push_back(part);
      keys_.push_back(key);
    }
  }
  for (const auto& [key, feature] : editing_->preview()) of_preview_.insert(key);
  lifted_ = false;
  scene_->setOverlays(all_);
}

void OverlaysOnMap::drawLifted() {
  std::set<FeatureKey> keys;
  for (const auto& [key, feature] : editing_->preview()) keys.insert(keys.end(), key);
  for (const FeatureKey key : keys) {
    if (!updateDrawn(key)) return draw();
  }
  if (lifted_ && keys == of_preview_) return;
  if (!of_preview_.empty()) return draw();
  of_preview_ = std::move(keys);
  lifted_ = true;
  for (const FeatureKey key : of_preview_) {
    for (std::size_t part = 0; part < drawn_[key].parts.size(); ++part)
      all_.features[drawn_[key].first + part].parts.clear();
  }
  scene_->setOverlays(all_);
}

void OverlaysOnMap::drawPreview() {
  const bool open = editing_->isOpen() && drawn_.size() == editing_->document().size();
  if (open && editing_->preview().size() > kMostDrawnInHand) return drawLifted();
  if (lifted_) return draw();
  // What is in the hand, and what was; all else stays as it is.
  std::set<FeatureKey> keys = std::exchange(of_preview_, {});
  for (const auto& [key, feature] : editing_->preview()) of_preview_.insert(of_preview_.end(), key);
  keys.insert(of_preview_.begin(), of_preview_.end());
  if (!open) return draw();
  for (const FeatureKey key : keys) {
    if (!updateDrawn(key)) return draw();
    std::copy(drawn_[key].parts.begin(), drawn_[key].parts.end(),
              all_.features.begin() + std::ptrdiff_t(drawn_[key].first));
  }
  scene_->setOverlays(all_);
}

const std::vector<map::OverlayFeature>* OverlaysOnMap::partsOf(FeatureKey key) const {
  return key < drawn_.size() && drawn_[key].feature ? &drawn_[key].parts : nullptr;
}

geometry::WorldRect OverlaysOnMap::boundsOf(const std::set<FeatureKey>& keys) const {
  geometry::WorldRect bounds;
  for (const FeatureKey key : keys) {
    if (key >= drawn_.size()) continue;
    for (const map::OverlayFeature& part : drawn_[key].parts) {
      for (const auto& points : part.parts) {
        for (const Eigen::Vector2d& point : points) bounds.extend(point);
      }
    }
  }
  return bounds;
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
  for (FeatureKey key = 0; key < drawn_.size(); ++key) {
    const Drawn& drawn = drawn_[key];
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
  for (FeatureKey key = 0; key < drawn_.size(); ++key) {
    const Drawn& drawn = drawn_[key];
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

}  // namespace mapwright::ui

#include "moc_overlays_on_map.cpp"
