#include "scene/map_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "scene/bag_track.h"
#include "scene/map_clouds.h"
#include "scene/map_scene_impl.h"
#include "scene/pose_between.h"
#include "scene/regions_on_map.h"

namespace mapwright::scene {
namespace {

std::uint8_t pixelFlags(const map::SubmapEntry& entry) {
  return std::uint8_t((entry.is_incremental ? render::kIncremental : 0) |
                      (entry.is_frozen ? 0 : render::kActive) | (entry.is_nearby ? render::kNearby : 0));
}

}  // namespace

MapScene::MapScene(render::TileRenderer::Options renderer_options, QObject* parent)
    : QGraphicsScene(parent),
      theme_(lightMapTheme()),
      renderer_(std::make_unique<render::TileRenderer>(renderer_options)) {
  setItemIndexMethod(NoIndex);
  impl_ = std::make_unique<Impl>(*this, *renderer_, renderer_options);
  impl_->context.theme = theme_;
  impl_->raster.setTheme(theme_);
  setBackgroundBrush(QColor(theme_.map.unknown));
  connect(&impl_->raster, &RasterStack::settledChanged, this, &MapScene::noteSettled);
  connect(&impl_->raster, &RasterStack::contentChanged, this, [this] {
    syncColors();
    Q_EMIT contentChanged();
  });
  connect(renderer_.get(), &render::TileRenderer::tilesChanged, this, &MapScene::paintContentSoon);
  auto* const between = new PoseBetween(this);
  connect(between, &PoseBetween::changed, this, [this, between] {
    impl_->context.between = between->pose();
    if (session_) takeLive(map::topicIndex<map::TrackedPose>());
  });
  auto* const track = new BagTrack(this);
  connect(track, &BagTrack::changed, this, [this, track] {
    impl_->track = track->track();
    impl_->items.at(Layer::Track)->update();
  });
  auto* const regions = new RegionsOnMap(this);
  connect(regions, &RegionsOnMap::shownChanged, this, [this, regions] {
    impl_->region_ground->setMap(regions->map());
    impl_->raster.setRegions(regions->map());
    for (LayerItem* item : impl_->itemsOf(Layer::Regions)) item->update();
    Q_EMIT contentChanged();
  });
  connect(regions, &RegionsOnMap::extentChanged, this, [this, regions] {
    impl_->region_ground->setExtent(regions->extent());
    impl_->region_ground->update();
  });
  connect(regions, &RegionsOnMap::regionsChanged, this, [this] { impl_->region_ground->update(); });
  connect(regions, &RegionsOnMap::sheetsChanged, this, [this] { impl_->raster.regionSheetsChanged(); });
  connect(regions, &RegionsOnMap::cellsChanged, this, [this](const geometry::WorldRect& where) {
    impl_->raster.regionCellsChanged(where);
    impl_->region_ground->update();
  });
  auto* const clouds = new MapClouds(this, renderer_options.workers);
  impl_->dispatched->setClouds(clouds);
  connect(clouds, &MapClouds::changed, this, [this] { impl_->dispatched->refresh(); });
  connect(clouds, &MapClouds::settledChanged, this, &MapScene::noteSettled);
  connect(&impl_->dispatched->tiles(), &render::PaintedTiles::settledChanged, this, &MapScene::noteSettled);
  impl_->clock.start();
  impl_->repaint_timer.setSingleShot(true);
  impl_->repaint_timer.setTimerType(Qt::PreciseTimer);
  connect(&impl_->repaint_timer, &QTimer::timeout, this, &MapScene::paintContent);
  connect(renderer_.get(), &render::TileRenderer::settledChanged, this, [this] { noteSettled(); });
  syncColors();
  geometry::ViewTransform view;
  view.width_px = 640;
  view.height_px = 480;
  setView(view);
}

void MapScene::drawBackground(QPainter* painter, const QRectF& rect) {
  impl_->labels.clear();
  impl_->began_ms = impl_->nowMs();
  QGraphicsScene::drawBackground(painter, rect);
}

void MapScene::drawForeground(QPainter* painter, const QRectF& rect) {
  QGraphicsScene::drawForeground(painter, rect);
  // A moving robot repaints a small part: that does not tell how long the whole takes.
  const bool whole = rect.width() * rect.height() > view_.width_px * view_.height_px / 2.0;
  if (whole) impl_->pace.painted(impl_->began_ms, impl_->nowMs());
}

void MapScene::paintContentSoon() {
  if (impl_->repaint_timer.isActive()) return;
  const double wait_ms = impl_->pace.waitMs(impl_->nowMs());
  if (wait_ms > 0) {
    impl_->repaint_timer.start(int(std::ceil(wait_ms)));
  } else {
    paintContent();
  }
}

void MapScene::paintContent() {
  impl_->tiles->update();
  for (const Layer layer : {Layer::Outlines, Layer::Ids}) impl_->items.at(layer)->update();
  if (!impl_->highlighted.empty()) impl_->highlight->update();
}

MapScene::~MapScene() {
  if (session_) session_->disconnect(this);
  clear();  // the items paint with data in impl_
}

work::Budgets MapScene::memory() const {
  const render::TileCounts tiles = renderer_->counts();
  work::Budgets held;
  held.dense = tiles.dense_bytes;
  held.tiles = tiles.cache_bytes;
  held.grid_tiles = impl_->raster.cacheBytes() + impl_->dispatched->tiles().cacheBytes();
  if (const regions::RegionMap* const map = RegionsOnMap::of(*this).map())
    held.regions = map->regions().bytes();
  return held;
}

void MapScene::setSession(session::Session* session) {
  if (session == session_) return;
  if (session_) {
    session_->disconnect(this);
    session_->catalogue().disconnect(this);
    for (const session::MapSlot* slot : {&session_->wholeMap(), &session_->comparedMap()})
      slot->disconnect(this);
  }
  session_ = session;
  PoseBetween::of(*this).show(std::nullopt);
  BagTrack::of(*this).show(nullptr);
  MapClouds::of(*this).clear();
  impl_->highlighted.clear();
  impl_->context.live = session_ ? &session_->live() : &impl_->nothing_live;
  impl_->robot_pose = impl_->context.live->robot_pose;
  impl_->raster.setSession(session_);
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
      impl_->highlighted.clear();
      update();
    });
    connect(session_, &Session::sliceChanged, this, &MapScene::syncAll);
    connect(session_, &Session::liveChanged, this, &MapScene::takeLive);
    connect(session_, &Session::frameChanged, this, &MapScene::takeFrame);
    for (const session::MapSlot* slot : {&session_->wholeMap(), &session_->comparedMap()}) {
      connect(slot, &session::MapSlot::changed, this, [this] {
        syncPlace();
        noteSettled();
      });
    }
    connect(&session_->catalogue(), &session::Catalogue::changed, this, &MapScene::syncPlace);
    connect(session_, &Session::listChanged, this, &MapScene::syncPlace);
    session_->setView(view_.visibleWorld(), view_.center_m);
    sendWants();
  }
  syncPlace();
  syncAll();
}

void MapScene::syncAll() {
  std::vector<map::SubmapId> ids;
  if (session_) {
    for (const auto& [id, row] : session_->submaps().rows()) {
      if (row.shown_version >= 0) ids.push_back(id);
    }
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
    const submap::SubmapRow* row = session_->submaps().find(id);
    const auto placement = row ? session_->submaps().placement(id, session_->slice()) : std::nullopt;
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
  paintContentSoon();
}

void MapScene::setView(const geometry::ViewTransform& view) {
  if (view == view_) return;
  const bool resized = view.width_px != view_.width_px || view.height_px != view_.height_px;
  view_ = view;
  impl_->context.view = view;
  if (resized) {
    for (LayerItem* item : impl_->all) item->viewportResized();
    setSceneRect(0, 0, view.width_px, view.height_px);
    impl_->applyVisibility();
  }
  impl_->tiles->sendView();
  impl_->raster.sendView();
  impl_->dispatched->sendView();
  impl_->robot_rect = impl_->robot->robotRect();
  if (session_) session_->setView(view_.visibleWorld(), view_.center_m);
  update();
  Q_EMIT viewChanged();
}

void MapScene::setTheme(const MapTheme& theme) {
  theme_ = theme;
  impl_->context.theme = theme;
  impl_->raster.setTheme(theme);
  impl_->dispatched->refresh();
  setBackgroundBrush(QColor(theme.map.unknown));
  syncColors();
  update();
}

void MapScene::setColorMode(render::ColorMode mode) {
  color_mode_ = mode;
  syncColors();
  update();
  Q_EMIT layersChanged();
}

void MapScene::syncColors() {
  render::MapColors colors = theme_.map;
  colors.clear_unknown = impl_->items.at(Layer::WholeMap)->isVisible() || impl_->raster.overviewShown();
  if (colors == renderer_->colors() && color_mode_ == drawn_color_mode_) return;
  drawn_color_mode_ = color_mode_;
  renderer_->setColors(colors, color_mode_);
}

void MapScene::takeLive(int what) {
  using map::topicIndex;
  Impl& impl = *impl_;
  const auto touch = [&](Layer layer) {
    for (LayerItem* item : impl.itemsOf(layer)) item->update();
  };
  if (what == topicIndex<map::TrackedPose>() && impl.context.live->robot_pose == impl.robot_pose) {
    // The robot's pose is repeated all the time.
  } else if (what == topicIndex<map::TrackedPose>() || what == topicIndex<map::RobotModel>()) {
    const std::array<LayerItem*, 3> moved{impl.robot, impl.items.at(Layer::Footprint),
                                          impl.items.at(Layer::ExpandedFootprint)};
    for (LayerItem* item : moved) item->update(impl.robot_rect);
    impl.robot_rect = impl.robot->robotRect();
    impl.robot_pose = impl.context.live->robot_pose;
    for (LayerItem* item : moved) item->update(impl.robot_rect);
    const std::size_t length = impl.context.live->trail.size();
    if (length != std::exchange(impl.trail_length, length))
      impl.items.at(Layer::Trail)->update(impl.robot_rect);
    if (!impl.context.live->racks.empty()) touch(Layer::Boxes);
  } else if (what == topicIndex<map::PointCloudMessage>()) {
    if (impl.cloud->isVisible()) impl.cloud->pointsArrived();
  } else if (what == topicIndex<map::MapInfo>()) {
    syncPlace();
  } else if (what == topicIndex<map::SlamStatus>()) {
    if (impl.placeRobot(session_)) showPlaced();
  } else {
    static const std::map<int, Layer> kLayerOf{
        {topicIndex<map::PathMessage>(), Layer::Path},
        {topicIndex<map::LocalPathMessage>(), Layer::LocalPath},
        {topicIndex<map::TrajectoryMessage>(), Layer::Trajectory},
        {topicIndex<map::PlanningState>(), Layer::Target},
        {topicIndex<map::NearbyRobotsMessage>(), Layer::NearbyRobots},
        {topicIndex<map::NearbyFootprintsMessage>(), Layer::NearbyRobots},
        {topicIndex<map::LandmarksMessage>(), Layer::Landmarks},
        {topicIndex<map::AutoDoorsMessage>(), Layer::Doors},
        {topicIndex<map::PalletsMessage>(), Layer::Boxes},
        {topicIndex<map::RackMessage>(), Layer::Boxes},
        {topicIndex<map::SeenObjectsMessage>(), Layer::Boxes},
        {topicIndex<map::ConstraintsMessage>(), Layer::Constraints}};
    if (const auto found = kLayerOf.find(what); found != kLayerOf.end()) touch(found->second);
  }
}

void MapScene::takeFrame() {
  impl_->trail_length = 0;
  impl_->cloud->pointsArrived();
  impl_->robot_rect = impl_->robot->robotRect();
  impl_->robot_pose = impl_->context.live->robot_pose;
  syncFeatures();
  update();
}

void MapScene::syncFeatures() {
  impl_->takeFeatures(session_);
  for (const Layer layer : {Layer::Overlays, Layer::Waypoints, Layer::Landmarks, Layer::Trajectory}) {
    for (LayerItem* item : impl_->itemsOf(layer)) item->update();
  }
}

void MapScene::sendWants() {
  if (!session_) return;
  map::Streams streams;
  for (const Layer layer : allLayers()) {
    if (layerVisible(layer)) streams.merge(layerStreams(layer));
  }
  if (impl_->compare != CompareMode::Off) streams.merge(layerStreams(Layer::WholeMap));
  session_->want(QStringLiteral("layers"), streams);
}

void MapScene::noteSettled() {
  if (picturesSettled()) Q_EMIT tilesSettled();
}

geometry::WorldRect MapScene::contentBounds() const {
  if (!session_) return {};
  geometry::WorldRect bounds;
  if (impl_->items.at(Layer::Submaps)->isVisible()) bounds.extend(session_->contentBounds());
  if (impl_->items.at(Layer::WholeMap)->isVisible() || bounds.empty())
    bounds.extend(impl_->raster.wholeBounds());
  if (impl_->has_compared && impl_->compare != CompareMode::Off) {
    bounds.extend(impl_->raster.wholeBounds());
    bounds.extend(impl_->raster.comparedBounds());
  }
  if (impl_->items.at(Layer::Regions)->isVisible()) bounds.extend(impl_->raster.regionBounds());
  if (const RegionsOnMap& regions = RegionsOnMap::of(*this);
      regions.map() && regions.extent() && layerVisible(Layer::Regions))
    bounds.extend(regions.extent()->bounds());
  if (layerVisible(Layer::DispatchedCloud)) bounds.extend(MapClouds::of(*this).bounds());
  if (bounds.empty()) bounds = session_->contentBounds();
  if (!bounds.empty() || !layerVisible(Layer::Cloud)) return bounds;
  // A robot without a map: its sensor data is all there is.
  for (const auto& [topic, cloud] : session_->live().clouds) {
    if (!cloud) continue;
    for (const map::CloudPoint& point : *cloud) bounds.extend(Eigen::Vector2d(point.x_m, point.y_m));
  }
  return bounds;
}

std::vector<render::PlacedTexture> MapScene::placedTextures() const {
  std::vector<render::PlacedTexture> placed;
  if (!session_) return placed;
  for (const auto& [id, row] : session_->submaps().rows()) {
    if (const auto placement = session_->submaps().placement(id, session_->slice()))
      placed.push_back({id, placement->texture, placement->world_from_texture, pixelFlags(row.entry)});
  }
  return placed;
}

std::optional<render::PlacedGrid> MapScene::wholeMap() const { return impl_->raster.wholeMap(); }

void MapScene::setHighlighted(std::set<map::SubmapId> ids) {
  impl_->highlighted = std::move(ids);
  impl_->highlight->update();
}

const std::set<map::SubmapId>& MapScene::highlighted() const { return impl_->highlighted; }

bool MapScene::highlightedAt(const Eigen::Vector2d& world_m) const {
  return std::any_of(impl_->highlighted.begin(), impl_->highlighted.end(), [&](map::SubmapId id) {
    const auto it = impl_->outlines.find(id);
    return it != impl_->outlines.end() && it->second.contains(world_m);
  });
}

std::optional<map::SubmapId> MapScene::submapAt(const Eigen::Vector2d& world_m) const {
  if (impl_->place.drawn == ScreenPart::None) return std::nullopt;
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
  const Eigen::Vector2d pixel = view_.pixelFromWorld(world_m);
  const auto shows = [&](const LayerItem& item) {
    return item.isVisible() && (!item.part() || item.part()->contains(pixel.x(), pixel.y()));
  };
  if (shows(*impl_->items.at(Layer::Submaps))) {
    if (const auto intensity = renderer_->intensityAt(world_m)) {
      return int(std::lround((1.0 - *intensity / 255.0) * 100.0));
    }
  }
  if (impl_->items.at(Layer::Regions)->isVisible()) {
    if (const auto occupancy = impl_->raster.regionOccupancyAt(world_m)) return occupancy;
  }
  const auto whole = shows(*impl_->raster.compared())           ? impl_->raster.comparedMap()
                     : shows(*impl_->items.at(Layer::WholeMap)) ? impl_->raster.wholeMap()
                                                                : std::nullopt;
  if (!whole) return std::nullopt;
  const Eigen::Vector2d cell = whole->reference.cellFromWorld(world_m);
  if (!(cell.x() >= 0 && cell.y() >= 0 && cell.x() < whole->reference.width &&
        cell.y() < whole->reference.height))
    return std::nullopt;
  const grids::CellMeaning& meaning = grids::meaningOf(whole->cells->code());
  const std::uint8_t byte = whole->cells->at(int(cell.x()), int(cell.y()));
  if (!meaning.known[byte]) return std::nullopt;
  return meaning.occupancy[byte];
}

bool MapScene::picturesSettled() const {
  return (!impl_->items.at(Layer::Submaps)->isVisible() || renderer_->settled()) && impl_->raster.drawn() &&
         cloudsSettled();
}

bool MapScene::settled() const {
  const bool submaps = impl_->items.at(Layer::Submaps)->isVisible();
  if (submaps && !renderer_->settled()) return false;
  if (submaps && session_ && !session_->settled(1)) return false;
  return cloudsSettled() && impl_->raster.settled();
}

bool MapScene::cloudsSettled() const {
  return !impl_->dispatched->isVisible() ||
         (MapClouds::of(*this).settled() && impl_->dispatched->tiles().settled());
}

void MapScene::setStale(bool stale) { impl_->stale->setVisible(stale); }

}  // namespace mapwright::scene

#include "moc_map_scene.cpp"
