#include "ui/scene/map_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "cells/cell_texture.h"
#include "grids/grid_pyramid.h"
#include "render/tile_renderer.h"
#include "sentences/fault_sentence.h"
#include "sentences/subject_name.h"
#include "submap/submap_store.h"
#include "ui/scene/layer_objects.h"
#include "ui/scene/scene_items.h"
#include "ui/scene/submap_classes.h"

namespace mapwright::ui::scene {
namespace {

std::uint16_t pixelFlags(const submap::SubmapStore& submaps, const map::SubmapEntry& entry) {
  return std::uint16_t((entry.is_incremental ? render::kIncremental : 0) |
                       (entry.is_frozen ? 0 : render::kActive) | (entry.is_nearby ? render::kNearby : 0) |
                       render::flagsOf(classesOf(submaps, entry.id)));
}

std::array<Eigen::Vector2d, 4> cornersOf(const submap::Placement& placement) {
  const double along = -placement.texture->height() * placement.texture->resolutionM();
  const double across = -placement.texture->width() * placement.texture->resolutionM();
  const geometry::Pose2& pose = placement.world_from_texture;
  return {pose.apply({0, 0}), pose.apply({0, across}), pose.apply({along, across}), pose.apply({along, 0})};
}

}  // namespace

MapScene::MapScene(render::TileRenderer::Options renderer_options, std::shared_ptr<clouds::CloudStore> clouds,
                   QObject* parent)
    : QGraphicsScene(parent),
      color_mode_(render::ColorMode::Normal),
      renderer_(std::make_unique<render::TileRenderer>(renderer_options)) {
  setItemIndexMethod(NoIndex);
  if (!clouds) clouds = std::make_shared<clouds::CloudStore>(renderer_options.workers);
  items_ = std::make_unique<SceneItems>(
      *this, *renderer_, renderer_options, std::move(clouds),
      [this] {
        if (items_) emitSettled();
      },
      [this] { placeLabelsSoon(); });
  setBackgroundBrush(QColor(theme().map.unknown));
  connect(&items_->raster, &RasterStack::contentChanged, this, [this] {
    syncColors();
    Q_EMIT contentChanged();
  });
  connect(renderer_.get(), &render::TileRenderer::tilesChanged, this, &MapScene::paintContentSoon);
  clock_.start();
  repaint_timer_.setSingleShot(true);
  repaint_timer_.setTimerType(Qt::PreciseTimer);
  connect(&repaint_timer_, &QTimer::timeout, this, &MapScene::paintContent);
  connect(renderer_.get(), &render::TileRenderer::settledChanged, this, [this] { emitSettled(); });
  syncColors();
  geometry::ViewTransform view;
  view.width_px = 640;
  view.height_px = 480;
  setView(view);
}

void MapScene::drawBackground(QPainter* painter, const QRectF& rect) {
  began_ms_ = nowMs();
  items_->placeLabels();
  // The GroundItem fills the viewport.
  if (!sceneRect().contains(rect)) QGraphicsScene::drawBackground(painter, rect);
}

void MapScene::placeLabelsSoon() {
  QMetaObject::invokeMethod(
      this, [this] { items_->placeLabels(); }, Qt::QueuedConnection);
}

void MapScene::repaintAll() {
  items_->allChanged();
  update();
}

void MapScene::drawForeground(QPainter* painter, const QRectF& rect) {
  QGraphicsScene::drawForeground(painter, rect);
  // A moving robot repaints a small part: that does not tell how long the whole takes.
  const bool whole = rect.width() * rect.height() > view_.width_px * view_.height_px / 2.0;
  if (whole) pace_.painted(began_ms_, nowMs());
}

void MapScene::paintContentSoon() {
  if (repaint_timer_.isActive()) return;
  const double wait_ms = pace_.waitMs(nowMs());
  if (wait_ms > 0) {
    repaint_timer_.start(int(std::ceil(wait_ms)));
  } else {
    paintContent();
  }
}

void MapScene::paintContent() {
  for (const Layer layer : allLayers()) {
    if (specOf(layer).shows_submaps) items_->update(layer);
  }
  if (!items_->context.highlighted.empty()) items_->highlight->update();
}

MapScene::~MapScene() {
  if (session_) session_->disconnect(this);
  clear();  // the items paint with data in items_
}

work::Budgets MapScene::memory() const {
  const render::TileCounts tiles = renderer_->counts();
  work::Budgets held;
  held.dense = tiles.dense_bytes;
  held.tiles = tiles.cache_bytes;
  for (const LayerItem* item : items_->all) held.grid_tiles += item->cacheBytes();
  if (const regions::RegionMap* const map = regions()) held.regions = map->regions().bytes();
  return held;
}

void MapScene::setSession(session::Session* session) {
  if (session == session_) return;
  if (session_) {
    session_->disconnect(this);
    session_->catalogue().disconnect(this);
    session_->poseGraph().disconnect(this);
    for (const session::MapSlot* slot : {&session_->wholeMap(), &session_->comparedMap()})
      slot->disconnect(this);
  }
  session_ = session;
  setPoseBetween(std::nullopt);
  setTrack(nullptr);
  setClosures(nullptr);
  setOutlined(std::nullopt);
  setAgreement(nullptr, 0);
  items_->context.highlighted.clear();
  setMarked(std::nullopt);
  setMarker(std::nullopt);
  items_->context.live = session_ ? &session_->live() : &items_->nothing_live;
  items_->robot_pose = items_->context.live->robot_pose;
  items_->raster.setSession(session_);
  renderer_->clear();
  items_->context.outlines.clear();
  if (session_) {
    using session::Session;
    connect(session_, &Session::submapsPlaced, this, &MapScene::syncPlaced);
    connect(session_, &Session::submapsRemoved, this, [this](const std::vector<map::SubmapId>& ids) {
      renderer_->remove(ids);
      for (const map::SubmapId id : ids) items_->context.outlines.erase(id);
      repaintAll();
    });
    connect(session_, &Session::sessionRestarted, this, [this] {
      renderer_->clear();
      items_->context.outlines.clear();
      items_->context.highlighted.clear();
      items_->context.submap_marks->clear();
      repaintAll();
    });
    connect(session_, &Session::sliceChanged, this, &MapScene::syncAll);
    connect(session_, &Session::rowsTouched, this, &MapScene::syncMarks);
    connect(session_, &Session::liveChanged, this, &MapScene::onLive);
    connect(session_, &Session::frameChanged, this, &MapScene::onFrame);
    for (const session::MapSlot* slot : {&session_->wholeMap(), &session_->comparedMap()}) {
      connect(slot, &session::MapSlot::changed, this, [this] {
        syncPlace();
        emitSettled();
      });
    }
    connect(&session_->catalogue(), &session::Catalogue::changed, this, &MapScene::syncPlace);
    connect(&session_->poseGraph(), &session::PoseGraphSlot::changed, this, &MapScene::syncClosures);
    connect(session_, &Session::listChanged, this, &MapScene::syncPlace);
    connect(session_, &Session::listChanged, this, &MapScene::syncAges);
    if (items_->asks) session_->setView(view_.visibleWorld(), view_.center_m);
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
  items_->context.outlines.clear();
  syncPlaced(ids);
  syncMarks({.all = true, .ids = {}});
  repaintAll();
}

/// The classes of a trajectory's submaps change when it has doubled.
void MapScene::syncAges() {
  const submap::SubmapStore& submaps = session_->submaps();
  std::map<std::int32_t, int> shifts;
  for (const std::int32_t trajectory : trajectoriesOf(submaps))
    shifts[trajectory] = ageShift(newestIndex(submaps, trajectory));
  const auto before = std::exchange(items_->age_shifts, shifts);
  if (shifts == before) return;
  std::vector<map::SubmapId> ids;
  for (const auto& [id, row] : submaps.rows()) {
    const auto was = before.find(id.trajectory);
    if (row.shown_version >= 0 && was != before.end() && was->second != shifts.at(id.trajectory))
      ids.push_back(id);
  }
  syncPlaced(ids);
  Q_EMIT layersChanged();  // the legend names the trajectories
}

void MapScene::syncMarks(const session::TouchedRows& rows) {
  bool changed = rows.all;
  if (rows.all) {
    items_->context.submap_marks->clear();
    if (session_) {
      for (const auto& [id, row] : session_->submaps().rows()) syncMark(id);
    }
  } else {
    for (const map::SubmapId id : rows.ids) changed |= syncMark(id);
  }
  if (changed) paintContentSoon();
}

bool MapScene::syncMark(map::SubmapId id) {
  using session::SubmapStatus;
  SubmapMarks& marks = *items_->context.submap_marks;
  const submap::SubmapRow* const row = session_->submaps().find(id);
  if (!row || !row->pose_usable || !row->visible) return marks.remove(id);
  PlacedMark mark;
  switch (session_->status(id)) {
    case SubmapStatus::Missing:
      mark.kind = MarkKind::Missing;
      break;
    case SubmapStatus::Waiting:
      // An older version may be on screen.
      if (row->drawable(session_->slice())) return marks.remove(id);
      mark.kind = MarkKind::Failed;
      break;
    case SubmapStatus::Corrupt:
      mark.kind = MarkKind::Corrupt;
      break;
    case SubmapStatus::NoSlice:
      if (!slices_marked_) return marks.remove(id);
      mark.kind = MarkKind::NoSlice;
      break;
    default:
      return marks.remove(id);
  }
  mark.at_m = {row->entry.pose.x, row->entry.pose.y};
  // Another slice tells how large it is.
  for (std::size_t slice = 0; slice < row->slices.size() && !mark.corners; ++slice) {
    const auto placement = session_->submaps().placement(id, int(slice));
    if (!placement) continue;
    mark.corners = cornersOf(*placement);
    mark.at_m = ((*mark.corners)[0] + (*mark.corners)[2]) / 2;
  }
  return marks.put(id, mark);
}

void MapScene::setSlicesMarked(bool marked) {
  if (std::exchange(slices_marked_, marked) != marked) syncMarks({.all = true, .ids = {}});
}

std::vector<ProblemMark> MapScene::problemMarksAt(const Eigen::Vector2d& world_m, double reach_px) const {
  std::vector<ProblemMark> found;
  const QPointF at(view_.pixelFromWorld(world_m).x(), view_.pixelFromWorld(world_m).y());
  const double reach_m = reach_px * view_.scale_m_per_px;
  const geometry::WorldRect around =
      geometry::WorldRect{world_m.x(), world_m.y(), world_m.x(), world_m.y()}.grown(reach_m);
  const auto isNear = [&](const Eigen::Vector2d& point) { return (point - world_m).norm() <= reach_m; };
  const auto isIn = [&](const std::array<Eigen::Vector2d, 4>& corners) {
    Outline outline;
    outline.corners = corners;
    return outline.contains(world_m);
  };
  const auto addTrouble = [&](const MapTrouble& trouble) {
    const Eigen::Vector2d middle = (trouble.corners[0] + trouble.corners[2]) / 2;
    if (isIn(trouble.corners) || isNear(middle)) found.push_back({trouble.title, trouble.reason, middle});
  };
  const std::vector<LayerItem*>& items = items_->itemsOf(Layer::Problems);
  for (const LayerItem* item : items) {
    if (!item->isVisible() || (item->part() && !item->part()->contains(at))) continue;
    if (!item->of()) {
      if (const auto& trouble = items_->context.reference_trouble; trouble && item == items.back())
        addTrouble(*trouble);
      if (item != items.front()) continue;
      constexpr std::size_t kMost = 100;
      for (const auto& [id, mark] :
           items_->context.submap_marks->within(around, kMost).value_or(std::vector<SubmapMarks::Entry>())) {
        if (!isNear(mark.at_m) && !(mark.corners && isIn(*mark.corners))) continue;
        found.push_back(
            {sentences::nameOf(map::subjectOf(id)), reasonOf(id, mark.kind), mark.at_m, mark.kind, id});
      }
      continue;
    }
    const MapFeatures& features = items_->context.of(*item->of());
    for (const map::BrokenOverlay& feature : features.broken_overlays) {
      if (!items_->context.overlays_shown || !feature.at_m || !isNear(*feature.at_m)) continue;
      const QString name = shortName(feature.name.empty() ? feature.id : feature.name);
      found.push_back({name.isEmpty() ? tr("A feature of the overlays") : tr("Feature %1").arg(name),
                       sentences::sentenceOf(feature.reason), *feature.at_m});
    }
    if (features.trouble) addTrouble(*features.trouble);
  }
  return found;
}

QString MapScene::reasonOf(map::SubmapId id, MarkKind kind) const {
  if (kind == MarkKind::NoSlice) return tr("It has no slice %1.").arg(session_->slice());
  const QString reason = sentences::sentenceOf(session_->reason(id));
  return reason.isEmpty() ? tr("Its image could not be loaded.") : reason;
}

void MapScene::syncPlaced(const std::vector<map::SubmapId>& ids) {
  std::vector<render::PlacedTexture> placed;
  std::vector<map::SubmapId> gone;
  for (const map::SubmapId id : ids) {
    const submap::SubmapRow* row = session_->submaps().find(id);
    const auto placement = row ? session_->submaps().placement(id, session_->slice()) : std::nullopt;
    if (!placement) {
      gone.push_back(id);
      items_->context.outlines.erase(id);
      continue;
    }
    Outline& outline = items_->context.outlines[id];
    const geometry::Pose2& pose = placement->world_from_texture;
    outline.corners = cornersOf(*placement);
    outline.center = (outline.corners[0] + outline.corners[2]) / 2;
    outline.frozen = row->entry.is_frozen;
    outline.visible = row->visible;
    if (row->visible) {
      placed.push_back({id, placement->texture, pose, pixelFlags(session_->submaps(), row->entry)});
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
  items_->context.view = view;
  if (resized) {
    items_->viewportResized();
    setSceneRect(0, 0, view.width_px, view.height_px);
    items_->applyVisibility();
  }
  for (LayerItem* item : items_->all) item->viewMoved();
  items_->labels.viewMoved();
  items_->robot_rect = robotRect(items_->context);
  if (session_ && items_->asks) session_->setView(view_.visibleWorld(), view_.center_m);
  update();
  Q_EMIT viewChanged();
}

void MapScene::setTheme(const MapTheme& theme) {
  items_->context.theme = theme;
  items_->raster.themeChanged();
  for (LayerItem* item : items_->all) item->lookChanged();
  setBackgroundBrush(QColor(theme.map.unknown));
  syncColors();
  repaintAll();
}

void MapScene::setColorMode(render::ColorMode mode) {
  color_mode_ = mode;
  syncColors();
  repaintAll();
  Q_EMIT layersChanged();
}

void MapScene::syncColors() {
  render::MapColors colors = theme().map;
  const RasterLayer& reference = *items_->raster.reference();
  colors.clear_unknown = items_->raster.whole()->isVisible() ||
                         items_->raster.overview()->grid().has_value() ||
                         (reference.isVisible() && reference.grid().has_value());
  if (colors == renderer_->colors() && color_mode_ == drawn_color_mode_) return;
  drawn_color_mode_ = color_mode_;
  renderer_->setColors(colors, color_mode_);
}

void MapScene::onLive(int what) {
  using map::topicIndex;
  SceneItems& items = *items_;
  if (what == topicIndex<map::TrackedPose>() && items.context.live->robot_pose == items.robot_pose) {
    // The robot's pose is repeated all the time.
  } else if (what == topicIndex<map::TrackedPose>() || what == topicIndex<map::RobotModel>()) {
    const QRectF before = std::exchange(items.robot_rect, robotRect(items.context));
    items.robot_pose = items.context.live->robot_pose;
    for (LayerItem* item : items.all) item->robotMoved(before, items.robot_rect);
  } else if (what == topicIndex<map::MapInfo>()) {
    syncPlace();
  } else if (what == topicIndex<map::SlamStatus>()) {
    if (items.placeRobot(session_)) showPlaced();
  } else {
    for (const Layer layer : allLayers()) {
      const std::vector<int>& topics = specOf(layer).topics;
      if (std::find(topics.begin(), topics.end(), what) == topics.end()) continue;
      for (LayerItem* item : items.itemsOf(layer)) item->liveChanged();
    }
  }
}

void MapScene::onFrame() {
  items_->robot_rect = robotRect(items_->context);
  items_->robot_pose = items_->context.live->robot_pose;
  syncFeatures();
  repaintAll();
}

void MapScene::syncFeatures() {
  // Mostly nothing is different: a robot sends its map, or the list of its submaps, every few moments.
  const auto before = std::exchange(items_->context.features, {});
  items_->setFeatures(session_);
  for (LayerItem* item : items_->all) {
    if (const auto of = item->of(); of && before[std::size_t(*of)] != items_->context.of(*of)) item->update();
  }
}

void MapScene::sendWants() {
  if (session_ && items_->asks && layerVisible(Layer::Closures)) session_->poseGraph().want();
  if (!session_ || !items_->asks) return;
  map::Streams streams;
  for (const Layer layer : allLayers()) {
    if (layerVisible(layer)) streams.merge(layerStreams(layer));
  }
  if (items_->compare != CompareMode::Off) streams.merge(layerStreams(Layer::WholeMap));
  session_->want(QStringLiteral("layers"), streams);
}

void MapScene::emitSettled() {
  if (picturesSettled()) Q_EMIT tilesSettled();
}

geometry::WorldRect MapScene::contentBounds() const {
  if (!session_) return {};
  const RasterStack& raster = items_->raster;
  geometry::WorldRect bounds;
  if (items_->first(Layer::Submaps).isVisible()) bounds.extend(session_->contentBounds());
  if (raster.whole()->isVisible() || bounds.empty()) bounds.extend(raster.whole()->gridBounds());
  if (items_->has_compared && items_->compare != CompareMode::Off) {
    bounds.extend(raster.whole()->gridBounds());
    bounds.extend(raster.compared()->gridBounds());
  }
  if (items_->first(Layer::Regions).isVisible()) bounds.extend(raster.regionBounds());
  for (const Layer layer : allLayers()) {
    if (layerVisible(layer) && specOf(layer).in_fit) bounds.extend(items_->first(layer).contentBounds());
  }
  if (bounds.empty()) bounds = session_->contentBounds();
  // A robot without a map: its sensor data is all there is.
  if (bounds.empty() && layerVisible(Layer::Cloud)) bounds = layerBounds(Layer::Cloud);
  return bounds;
}

geometry::WorldRect MapScene::layerBounds(Layer layer) const {
  geometry::WorldRect bounds;
  const std::vector<LayerItem*>& robots_own = items_->robots_own;
  if (layer == Layer::Regions) {  // sheets reach beyond what was fetched
    bounds.extend(items_->first(layer).contentBounds());
    bounds.extend(items_->raster.regionBounds());
    return bounds;
  }
  const bool robot_drawn = items_->place.drawn != ScreenPart::None;
  for (const LayerItem* item : items_->itemsOf(layer)) {
    const bool robots = std::find(robots_own.begin(), robots_own.end(), item) != robots_own.end();
    if (robot_drawn || !robots) bounds.extend(item->contentBounds());
  }
  return bounds;
}

std::vector<render::PlacedTexture> MapScene::placedTextures() const {
  std::vector<render::PlacedTexture> placed;
  if (!session_) return placed;
  for (const auto& [id, row] : session_->submaps().rows()) {
    if (const auto placement = session_->submaps().placement(id, session_->slice()))
      placed.push_back({id, placement->texture, placement->world_from_texture,
                        pixelFlags(session_->submaps(), row.entry)});
  }
  return placed;
}

std::optional<render::PlacedGrid> MapScene::wholeMap() const { return items_->raster.whole()->grid(); }

void MapScene::setHighlighted(std::set<map::SubmapId> ids) {
  items_->context.highlighted = std::move(ids);
  items_->highlight->update();
}

void MapScene::setOutlined(std::optional<std::set<map::SubmapId>> ids) {
  if (ids == items_->context.outlined) return;
  items_->context.outlined = std::move(ids);
  for (const Layer layer : {Layer::Outlines, Layer::Ids}) items_->update(layer);
}

const std::set<map::SubmapId>& MapScene::highlighted() const { return items_->context.highlighted; }

bool MapScene::highlightedAt(const Eigen::Vector2d& world_m) const {
  return std::any_of(items_->context.highlighted.begin(), items_->context.highlighted.end(),
                     [&](map::SubmapId id) {
                       const auto it = items_->context.outlines.find(id);
                       return it != items_->context.outlines.end() && it->second.contains(world_m);
                     });
}

std::optional<map::SubmapId> MapScene::submapAt(const Eigen::Vector2d& world_m) const {
  if (items_->place.drawn == ScreenPart::None) return std::nullopt;
  for (auto it = items_->context.outlines.rbegin(); it != items_->context.outlines.rend(); ++it) {
    if (it->second.visible && it->second.contains(world_m)) return it->first;
  }
  return std::nullopt;
}

std::vector<ObjectId> MapScene::objectsAt(const Eigen::Vector2d& world_m, double reach_px) const {
  std::vector<ObjectId> ids = scene::objectsAt(*items_, world_m, reach_px);
  const std::vector<ProblemMark> marks = problemMarksAt(world_m, reach_px);
  // What is missing comes before the ground on which it is missing, and after what lies on it.
  const auto ground = std::find_if(ids.begin(), ids.end(), [](const ObjectId& id) {
    return id.layer == Layer::Submaps || id.layer == Layer::WholeMap;
  });
  std::vector<ObjectId> missing;
  for (const ProblemMark& mark : marks) missing.push_back(idOf(mark));
  ids.insert(ground, missing.begin(), missing.end());
  return ids;
}

std::optional<MapObject> MapScene::object(const ObjectId& id) const {
  if (!session_) return std::nullopt;
  const auto mark_at = placeOfMark(id);
  if (!mark_at) return scene::objectOf(*items_, *session_, id);
  for (const ProblemMark& mark : problemMarksAt(*mark_at, 1)) {
    if (idOf(mark).sameAs(id)) return problemObject(mark);
  }
  return std::nullopt;
}

std::vector<MapObject> MapScene::objects(std::size_t most) const { return scene::allObjects(*items_, most); }

void MapScene::setMarked(std::optional<MapObject> object) {
  items_->mark->update(items_->mark->covers());
  items_->context.marked = std::move(object);
  items_->mark->update(items_->mark->covers());
}

void MapScene::setMarker(std::optional<Eigen::Vector2d> world_m) {
  items_->mark->update(items_->mark->covers());
  items_->context.marker = std::move(world_m);
  items_->mark->update(items_->mark->covers());
}

const std::optional<Eigen::Vector2d>& MapScene::marker() const { return items_->context.marker; }

void MapScene::setReference(std::optional<render::PlacedGrid> placed) {
  items_->raster.setReference(std::move(placed));
  syncColors();
  update();
}

void MapScene::setReferenceAbove(bool above) {
  if (above == referenceAbove()) return;
  items_->raster.setReferenceAbove(above);
  items_->stack();
  repaintAll();
}

bool MapScene::referenceAbove() const { return items_->raster.referenceAbove(); }

void MapScene::setReferenceDifferences(bool shown) {
  if (shown == referenceDifferences()) return;
  items_->raster.setReferenceDifferences(shown);
  items_->stack();
  repaintAll();
  Q_EMIT layersChanged();
}

void MapScene::setWallsOff(std::shared_ptr<const WallsOff> walls) {
  if (walls == items_->context.walls_off) return;
  items_->context.walls_off = std::move(walls);
  items_->update(Layer::WallsOff);
}

bool MapScene::referenceDifferences() const { return items_->raster.referenceDifferences(); }

void MapScene::setReferenceTrouble(std::optional<MapTrouble> trouble) {
  if (!trouble && !items_->context.reference_trouble) return;
  items_->context.reference_trouble = std::move(trouble);
  repaintAll();
}

void MapScene::referenceRowsArrived() { items_->raster.reference()->renderer().rowsArrived(); }

void MapScene::setMeasurement(std::vector<Eigen::Vector2d> points, bool closed) {
  items_->context.measured = std::move(points);
  items_->context.measured_ring = closed;
  items_->measure->update();
}

std::optional<int> MapScene::occupancyAt(const Eigen::Vector2d& world_m) const {
  const Eigen::Vector2d pixel = view_.pixelFromWorld(world_m);
  const auto shows = [&](const LayerItem& item) {
    return item.isVisible() && (!item.part() || item.part()->contains(pixel.x(), pixel.y()));
  };
  if (shows(items_->first(Layer::Submaps))) {
    if (const auto intensity = renderer_->intensityAt(world_m)) {
      return int(std::lround((1.0 - *intensity / 255.0) * 100.0));
    }
  }
  if (items_->first(Layer::Regions).isVisible()) {
    if (const auto occupancy = items_->raster.regionOccupancyAt(world_m)) return occupancy;
  }
  const auto whole = shows(*items_->raster.compared()) ? items_->raster.compared()->grid()
                     : shows(*items_->raster.whole())  ? items_->raster.whole()->grid()
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
  return std::all_of(items_->all.begin(), items_->all.end(),
                     [](const LayerItem* item) { return !item->isVisible() || item->settled(); });
}

bool MapScene::settled() const {
  const bool submaps = items_->first(Layer::Submaps).isVisible();
  return (!submaps || !session_ || session_->settled(1)) && picturesSettled() && items_->raster.read();
}

void MapScene::setStale(bool stale) { items_->stale->setVisible(stale); }

void MapScene::setWaypoints(std::optional<DrawnWaypoints> waypoints) {
  if (waypoints == items_->edited) return;
  items_->edited = std::move(waypoints);
  items_->updateWaypoints(session_);
  items_->update(Layer::Waypoints);
}

void MapScene::setOverlays(std::optional<DrawnOverlays> overlays) {
  if (!overlays && !items_->edited_overlays) return;
  items_->edited_overlays = std::move(overlays);
  if (!items_->edited_overlays) return syncFeatures();
  items_->updateOverlays(session_);
  items_->update(Layer::Overlays);
}

bool MapScene::showsEditedOverlays(FeaturesOf of) const { return items_->overlays_edited.contains(of); }

void MapScene::setEditedCells(const map::MapKey& map, std::shared_ptr<const grids::GridPyramid> cells) {
  items_->raster.setEdited(map, std::move(cells));
}

void MapScene::editedCellsChanged(const geometry::WorldRect& where) {
  items_->raster.editedChanged(where);
  Q_EMIT cellsEdited(where);
}

bool MapScene::layerVisible(Layer layer) const { return items_->shown.at(layer); }

void MapScene::setLayerVisible(Layer layer, bool visible) {
  items_->shown[layer] = visible;
  syncPlace();
  sendWants();
  Q_EMIT layersChanged();
}

void MapScene::setLayersVisible(const std::set<Layer>& layers) {
  for (const Layer layer : allLayers()) items_->shown[layer] = layers.contains(layer);
  syncPlace();
  sendWants();
  Q_EMIT layersChanged();
}

double MapScene::layerOpacity(Layer layer) const { return items_->first(layer).opacity(); }

void MapScene::setLayerOpacity(Layer layer, double opacity) {
  for (LayerItem* item : items_->itemsOf(layer)) item->setOpacity(std::clamp(opacity, 0.0, 1.0));
  items_->applyVisibility();
  Q_EMIT layersChanged();
}

const LayerStyle& MapScene::layerStyle(Layer layer) const { return items_->first(layer).style(); }

void MapScene::setLayerStyle(Layer layer, const LayerStyle& style) {
  for (LayerItem* item : items_->itemsOf(layer)) item->setStyle(style);
  if (layer == Layer::WholeMap) applyReduction();
  Q_EMIT layersChanged();
}

void MapScene::applyReduction() {
  if (!session_) return;
  const bool average = WholeMapChoice(layerStyle(Layer::WholeMap).choice) == WholeMapChoice::Average;
  for (session::MapSlot* slot : {&session_->wholeMap(), &session_->comparedMap()}) {
    slot->setAveraged(average);
  }
}

const std::vector<Layer>& MapScene::layerOrder() const { return items_->order; }

void MapScene::setLayerOrder(const std::vector<Layer>& order) {
  std::vector<Layer> next, fixed;
  const auto missing = [&](Layer layer) { return std::find(next.begin(), next.end(), layer) == next.end(); };
  for (const Layer layer : order) {
    if (!specOf(layer).order_fixed && missing(layer)) next.push_back(layer);
  }
  for (const Layer layer : allLayers()) {
    if (specOf(layer).order_fixed) {
      fixed.push_back(layer);
    } else if (missing(layer)) {
      next.push_back(layer);  // one that the caller does not know goes on top
    }
  }
  next.insert(next.end(), fixed.begin(), fixed.end());
  items_->order = std::move(next);
  items_->stack();
  repaintAll();
  Q_EMIT layersChanged();
}

CompareMode MapScene::compareMode() const { return items_->compare; }

void MapScene::setCompareMode(CompareMode mode) {
  if (mode == items_->compare) return;
  items_->compare = mode;
  syncPlace();
  sendWants();
  repaintAll();
  Q_EMIT layersChanged();
}

const RobotPlace& MapScene::robotPlace() const { return items_->place; }

void MapScene::setRobotWanted(std::optional<bool> wanted) {
  items_->robot_wanted = wanted;
  syncPlace();
}

void MapScene::syncPlace() {
  if (items_->placeRobot(session_)) return showPlaced();
  items_->applyVisibility();
  syncColors();
  syncFeatures();
}

void MapScene::showPlaced() {
  items_->applyVisibility();
  syncColors();
  syncFeatures();
  repaintAll();
  Q_EMIT robotPlaceChanged();
}

double MapScene::swipeAt() const { return items_->context.swipe_at; }

void MapScene::setSwipeAt(double fraction) {
  items_->context.swipe_at = std::clamp(fraction, 0.0, 1.0);
  items_->applyVisibility();
}

Halves MapScene::halves() const {
  Halves halves = items_->halves();
  if (halves.left == HalfContent::Submaps && !items_->first(Layer::Submaps).isVisible())
    halves.left = HalfContent::Nothing;
  return halves;
}

void MapScene::setHalfNames(const QString& left, const QString& right) {
  items_->context.left_name = left;
  items_->context.right_name = right;
  items_->swipe->update();
}

void MapScene::setCoveredTop(double px) {
  if (px == items_->context.covered_top_px) return;
  items_->context.covered_top_px = px;
  items_->swipe->update();
  items_->labels.viewMoved();
  placeLabelsSoon();
}

void MapScene::setCovered(std::vector<QRectF> areas) {
  if (areas == items_->context.covered) return;
  items_->context.covered = std::move(areas);
  items_->labels.viewMoved();
  placeLabelsSoon();
}

double MapScene::coveredTop() const { return items_->context.covered_top_px; }

const MapTheme& MapScene::theme() const { return items_->context.theme; }

regions::RegionMap* MapScene::regions() const { return items_->context.regions; }

void MapScene::setRegions(regions::RegionMap* regions) {
  using regions::RegionMap;
  if (regions == items_->context.regions) return;
  if (items_->context.regions) items_->context.regions->disconnect(this);
  items_->context.regions = regions;
  const auto shown = [this] {
    items_->raster.regionSheetsChanged();
    items_->update(Layer::Regions);
    Q_EMIT contentChanged();
  };
  if (regions) {
    LayerItem* const ground = &items_->first(Layer::Regions);
    connect(regions, &RegionMap::changed, this, [ground] { ground->update(); });
    connect(regions, &RegionMap::sheetsChanged, this, [this] { items_->raster.regionSheetsChanged(); });
    connect(regions, &RegionMap::cellsChanged, this, [this, ground](const geometry::WorldRect& where) {
      items_->raster.regionCellsChanged(where);
      ground->update();
    });
    connect(regions, &QObject::destroyed, this, shown);
  }
  shown();
}

void MapScene::setRegionsExtent(const std::optional<map::GridReference>& extent) {
  if (std::exchange(items_->context.regions_of, extent) != extent) items_->first(Layer::Regions).update();
}

bool MapScene::showsClouds() const {
  return layerVisible(Layer::DispatchedCloud) && !items_->context.clouds->empty();
}

void MapScene::setClosures(std::shared_ptr<const map::Closures> closures) {
  chosen_closures_ = std::move(closures);
  syncClosures();
}

void MapScene::syncClosures() {
  items_->context.closures_chosen = chosen_closures_ != nullptr;
  auto now = chosen_closures_ ? chosen_closures_ : session_ ? session_->poseGraph().closures() : nullptr;
  if (now == items_->context.closures) return;
  items_->context.closures = std::move(now);
  items_->update(Layer::Closures);
}

void MapScene::setTrack(std::shared_ptr<const Track> track) {
  if (track == items_->context.track) return;
  const bool had_one = std::exchange(items_->context.track, std::move(track)) != nullptr;
  items_->update(Layer::Track);
  // The legend has words about it only while there is one.
  if (had_one != (items_->context.track != nullptr)) Q_EMIT layersChanged();
}

void MapScene::setAgreement(std::shared_ptr<const agreement::Tiles> tiles, double cell_m) {
  if (!tiles && !items_->context.agreement) return;
  items_->context.agreement = std::move(tiles);
  items_->context.agreement_cell_m = cell_m;
  for (const Layer layer : {Layer::Coverage, Layer::Disagreement}) items_->update(layer);
}

void MapScene::setPoseBetween(const std::optional<geometry::Pose2>& pose) {
  if (pose == items_->context.between) return;
  items_->context.between = pose;
  if (session_) onLive(map::topicIndex<map::TrackedPose>());
  Q_EMIT poseBetweenChanged();
}

std::optional<geometry::Pose2> MapScene::robotPose() const { return items_->context.robotPose(); }

}  // namespace mapwright::ui::scene

#include "moc_map_scene.cpp"
