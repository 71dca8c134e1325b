#include "scene/map_scene.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/map_layers.h"

namespace mapwright::scene {
namespace {

constexpr std::array kLayers{Layer::Submaps, Layer::Grid,  Layer::Outlines, Layer::Ids,
                             Layer::Trail,   Layer::Robot, Layer::ScaleBar};

std::uint8_t pixelFlags(const map::SubmapEntry& entry) {
  return std::uint8_t((entry.is_incremental ? render::kIncremental : 0) |
                      (entry.is_frozen ? 0 : render::kActive) | (entry.is_nearby ? render::kNearby : 0));
}

}  // namespace

QString layerName(Layer layer) {
  switch (layer) {
    case Layer::Submaps:
      return QStringLiteral("submaps");
    case Layer::Grid:
      return QStringLiteral("grid");
    case Layer::Outlines:
      return QStringLiteral("outlines");
    case Layer::Ids:
      return QStringLiteral("ids");
    case Layer::Trail:
      return QStringLiteral("trail");
    case Layer::Robot:
      return QStringLiteral("robot");
    case Layer::ScaleBar:
      break;
  }
  return QStringLiteral("scalebar");
}

std::vector<Layer> allLayers() { return {kLayers.begin(), kLayers.end()}; }

class MapScene::Impl {
 public:
  Impl(MapScene& scene, render::TileRenderer& renderer)
      : tiles(new TileLayer(context, renderer)),
        grid(new GridLayer(context)),
        outlines_item(new OutlineLayer(context, outlines, highlighted, OutlineLayer::What::Outlines)),
        ids(new OutlineLayer(context, outlines, highlighted, OutlineLayer::What::Ids)),
        highlight(new OutlineLayer(context, outlines, highlighted, OutlineLayer::What::Highlight)),
        trail(new TrailLayer(context, live)),
        robot(new RobotLayer(context, live)),
        measure(new MeasureLayer(context, measured)),
        stale(new StaleLayer(context)),
        scale_bar(new ScaleBarLayer(context)) {
    int z = 0;
    for (LayerItem* item : std::initializer_list<LayerItem*>{tiles, grid, outlines_item, ids, highlight,
                                                             trail, robot, stale, measure, scale_bar}) {
      item->setZValue(z++);
      scene.addItem(item);
      items.push_back(item);
    }
    outlines_item->setVisible(false);
    ids->setVisible(false);
    stale->setVisible(false);
  }

  LayerItem* item(Layer layer) const {
    switch (layer) {
      case Layer::Submaps:
        return tiles;
      case Layer::Grid:
        return grid;
      case Layer::Outlines:
        return outlines_item;
      case Layer::Ids:
        return ids;
      case Layer::Trail:
        return trail;
      case Layer::Robot:
        return robot;
      case Layer::ScaleBar:
        break;
    }
    return scale_bar;
  }

  LayerContext context;
  Outlines outlines;
  std::optional<map::SubmapId> highlighted;
  map::LiveState live;
  std::vector<Eigen::Vector2d> measured;
  QRectF robot_rect;
  TileLayer* tiles;
  GridLayer* grid;
  OutlineLayer *outlines_item, *ids, *highlight;
  TrailLayer* trail;
  RobotLayer* robot;
  MeasureLayer* measure;
  StaleLayer* stale;
  ScaleBarLayer* scale_bar;
  std::vector<LayerItem*> items;
};

MapScene::MapScene(render::TileRenderer::Options renderer_options, QObject* parent)
    : QGraphicsScene(parent),
      theme_(lightMapTheme()),
      renderer_(std::make_unique<render::TileRenderer>(renderer_options)) {
  setItemIndexMethod(NoIndex);
  impl_ = std::make_unique<Impl>(*this, *renderer_);
  impl_->context.theme = theme_;
  setBackgroundBrush(QColor(theme_.map.unknown));
  connect(renderer_.get(), &render::TileRenderer::tilesChanged, this, [this] { impl_->tiles->update(); });
  connect(renderer_.get(), &render::TileRenderer::settledChanged, this, [this] {
    if (renderer_->settled()) Q_EMIT tilesSettled();
  });
  renderer_->setColors(theme_.map, color_mode_);
  geometry::ViewTransform view;
  view.width_px = 640;
  view.height_px = 480;
  setView(view);
}

MapScene::~MapScene() {
  if (session_) session_->disconnect(this);
  clear();  // the items paint with what impl_ holds
}

void MapScene::setSession(session::Session* session) {
  if (session == session_) return;
  if (session_) session_->disconnect(this);
  session_ = session;
  impl_->highlighted.reset();
  impl_->live = session_ ? session_->live() : map::LiveState{};
  renderer_->clear();
  impl_->outlines.clear();
  if (session_) {
    using session::Session;
    connect(session_, &Session::submapsPlaced, this, &MapScene::syncPlaced);
    connect(session_, &Session::submapsRemoved, this, [this](const std::vector<map::SubmapId>& ids) {
      renderer_->remove(ids);
      for (const map::SubmapId id : ids) impl_->outlines.erase(id);
      update();
    });
    connect(session_, &Session::sessionRestarted, this, [this] {
      renderer_->clear();
      impl_->outlines.clear();
      impl_->highlighted.reset();
      update();
    });
    connect(session_, &Session::sliceChanged, this, &MapScene::syncAll);
    connect(session_, &Session::liveChanged, this, [this] {
      const std::size_t had = impl_->live.trail.size();
      impl_->live = session_->live();
      impl_->robot->update(impl_->robot_rect);
      impl_->robot_rect = impl_->robot->robotRect();
      impl_->robot->update(impl_->robot_rect);
      if (impl_->live.trail.size() != had) impl_->trail->update(impl_->robot_rect);
    });
    session_->setView(view_.visibleWorld(), view_.center_m);
  }
  syncAll();
}

void MapScene::syncAll() {
  std::vector<map::SubmapId> ids;
  if (session_) {
    for (const auto& [id, row] : session_->book().rows()) ids.push_back(id);
  }
  renderer_->clear();
  impl_->outlines.clear();
  syncPlaced(ids);
  update();
}

void MapScene::syncPlaced(const std::vector<map::SubmapId>& ids) {
  std::vector<render::PlacedTexture> placed;
  std::vector<map::SubmapId> gone;
  for (const map::SubmapId id : ids) {
    const submap::SubmapRow* row = session_->book().find(id);
    const auto placement = row ? session_->book().placement(id, session_->slice()) : std::nullopt;
    if (!placement) {
      gone.push_back(id);
      impl_->outlines.erase(id);
      continue;
    }
    Outline& outline = impl_->outlines[id];
    const double along = -placement->texture->height() * placement->texture->resolutionM();
    const double across = -placement->texture->width() * placement->texture->resolutionM();
    const geometry::Pose2& pose = placement->world_from_texture;
    outline.corners = {pose.apply({0, 0}), pose.apply({0, across}), pose.apply({along, across}),
                       pose.apply({along, 0})};
    outline.center = pose.apply({along / 2, across / 2});
    outline.frozen = row->entry.is_frozen;
    outline.visible = row->visible;
    if (row->visible) {
      placed.push_back({id, placement->texture, pose, pixelFlags(row->entry)});
    } else {
      gone.push_back(id);
    }
  }
  if (!gone.empty()) renderer_->remove(gone);
  if (!placed.empty()) renderer_->upsert(std::move(placed));
  for (LayerItem* item : {impl_->outlines_item, impl_->ids, impl_->highlight}) item->update();
}

void MapScene::setView(const geometry::ViewTransform& view) {
  if (view == view_) return;
  const bool resized = view.width_px != view_.width_px || view.height_px != view_.height_px;
  view_ = view;
  impl_->context.view = view;
  if (resized) {
    for (LayerItem* item : impl_->items) item->viewportResized();
    setSceneRect(0, 0, view.width_px, view.height_px);
  }
  impl_->tiles->sendView();
  impl_->robot_rect = impl_->robot->robotRect();
  if (session_) session_->setView(view_.visibleWorld(), view_.center_m);
  update();
  Q_EMIT viewChanged();
}

void MapScene::setTheme(const MapTheme& theme) {
  theme_ = theme;
  impl_->context.theme = theme;
  setBackgroundBrush(QColor(theme.map.unknown));
  renderer_->setColors(theme.map, color_mode_);
  update();
}

void MapScene::setColorMode(render::ColorMode mode) {
  color_mode_ = mode;
  renderer_->setColors(theme_.map, mode);
  update();
  Q_EMIT layersChanged();
}

bool MapScene::layerVisible(Layer layer) const { return impl_->item(layer)->isVisible(); }

void MapScene::setLayerVisible(Layer layer, bool visible) {
  impl_->item(layer)->setVisible(visible);
  Q_EMIT layersChanged();
}

double MapScene::layerOpacity(Layer layer) const { return impl_->item(layer)->opacity(); }

void MapScene::setLayerOpacity(Layer layer, double opacity) {
  impl_->item(layer)->setOpacity(std::clamp(opacity, 0.0, 1.0));
  Q_EMIT layersChanged();
}

void MapScene::setHighlighted(std::optional<map::SubmapId> id) {
  impl_->highlighted = id;
  impl_->highlight->update();
}

std::optional<map::SubmapId> MapScene::highlighted() const { return impl_->highlighted; }

std::optional<map::SubmapId> MapScene::submapAt(const Eigen::Vector2d& world_m) const {
  for (auto it = impl_->outlines.rbegin(); it != impl_->outlines.rend(); ++it) {
    if (it->second.visible && it->second.contains(world_m)) return it->first;
  }
  return std::nullopt;
}

void MapScene::setMeasurement(std::optional<Measurement> measurement) {
  impl_->measured = measurement ? std::move(measurement->points) : std::vector<Eigen::Vector2d>{};
  impl_->measure->update();
}

std::optional<int> MapScene::occupancyAt(const Eigen::Vector2d& world_m) const {
  const auto intensity = renderer_->intensityAt(world_m);
  if (!intensity) return std::nullopt;
  return int(std::lround((1.0 - *intensity / 255.0) * 100.0));
}

bool MapScene::settled() const { return renderer_->settled() && (!session_ || session_->settled(1)); }

void MapScene::setStale(bool stale) { impl_->stale->setVisible(stale); }

}  // namespace mapwright::scene
