#include "ui/scene/scene_items.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include <QFontMetricsF>
#include <QGraphicsScene>

#include "geometry/polyline.h"
#include "grids/grid_pyramid.h"
#include "regions/region_sheet.h"
#include "render/tile_renderer.h"
#include "sentences/fault_sentence.h"
#include "sentences/problem_sentence.h"
#include "sentences/subject_name.h"
#include "session/lacks_picture.h"
#include "ui/scene/lengths.h"

namespace mapwright::ui::scene {
namespace {

/// A veil over everything that is no longer live.
class StaleItem : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) override {
    painter->fillRect(option->exposedRect, context_.theme.stale_veil);
  }
};

/// The measured polyline, or ring, with the length of each leg, the angles between them, the total and the
/// area.
class MeasureItem : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    std::vector<Eigen::Vector2d> points = context_.measured;
    if (points.empty()) return;
    const bool ring = context_.measured_ring && points.size() > 2;
    if (ring) points.push_back(points.front());
    painter->setRenderHint(QPainter::Antialiasing);
    QPolygonF line;
    for (const Eigen::Vector2d& point : points) line << toPoint(context_.view.pixelFromWorld(point));
    if (ring) {
      painter->setPen(Qt::NoPen);
      painter->setBrush(translucent(context_.theme.measure, 34));
      painter->drawPolygon(line);
      painter->setBrush(Qt::NoBrush);
    }
    painter->setPen(QPen(context_.theme.text_halo, 4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter->drawPolyline(line);
    painter->setPen(QPen(context_.theme.measure, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter->drawPolyline(line);
    painter->setBrush(context_.theme.measure);
    for (const QPointF& point : line) painter->drawEllipse(point, 3.5, 3.5);
  }

  LabelUse labelUse() const override { return LabelUse::Names; }
  void collectLabels(LabelCollector& labels) const override {
    constexpr double kPointPx = 3.5;
    const std::vector<Eigen::Vector2d>& points = context_.measured;
    const std::size_t count = points.size();
    const bool ring = context_.measured_ring && count > 2;
    const auto pixel = [&](std::size_t i) {
      return toPoint(context_.view.pixelFromWorld(points[i % count]));
    };
    const auto add = [&](const QRectF& beside, std::size_t id, const QString& text, const QColor& color) {
      labels.add(LabelWish::Position::Beside, LabelRank::Chosen, beside, id, text, color);
    };
    QRectF all;
    for (std::size_t i = 0; i < count; ++i) {
      const QRectF mark(pixel(i) - QPointF(kPointPx, kPointPx), QSizeF(2 * kPointPx, 2 * kPointPx));
      labels.symbol(mark);
      all |= mark;
      // The leg that ends here, and the angle between it and the next.
      if (count > 2 && (i > 0 || ring)) {
        const std::size_t before = (i + count - 1) % count;
        const QRectF middle((pixel(i) + pixel(before)) / 2, QSizeF(0, 0));
        add(middle.adjusted(-1, -1, 1, 1), 3 * i, lengthText((points[i] - points[before]).norm()),
            context_.theme.text);
        if (i + 1 < count || ring) {
          const double rad = geometry::angleAt(points[i], points[before], points[(i + 1) % count]);
          add(mark, 3 * i + 2, QStringLiteral("%1°").arg(geometry::degreesFromRadians(rad), 0, 'f', 1),
              context_.theme.text);
        }
      }
      if (!ring && i > 0 && i + 1 == count)
        add(mark, 1, lengthText(geometry::lengthOf(points)), context_.theme.measure);
    }
    if (ring) {
      labels.add(LabelWish::Position::Within, LabelRank::Chosen, all, 1,
                 areaText(std::abs(geometry::signedAreaOf(points))), context_.theme.measure);
    }
  }
};

/// The line between the two halves of a swipe, with their names.
class SwipeItem : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) override {
    const double x = std::round(context_.swipe_at * context_.view.width_px);
    painter->fillRect(QRectF(x - 2, 0, 4, context_.view.height_px), context_.theme.text_halo);
    painter->fillRect(QRectF(x - 1, 0, 2, context_.view.height_px), context_.theme.accent);
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setFont(context_.theme.label_font);
    for (const auto& [box, text] : names()) {
      painter->setPen(Qt::NoPen);
      painter->setBrush(context_.theme.text_halo);
      painter->drawRoundedRect(box, 4, 4);
      painter->setPen(context_.theme.text);
      painter->drawText(box, Qt::AlignCenter, text);
    }
  }
  LabelUse labelUse() const override { return LabelUse::Symbols; }
  void collectLabels(LabelCollector& labels) const override {
    for (const auto& [box, text] : names()) labels.symbol(box);
  }

 private:
  struct Name {
    QRectF box;
    QString text;
  };
  std::vector<Name> names() const {
    const double x = std::round(context_.swipe_at * context_.view.width_px);
    std::vector<Name> names;
    addName(names, context_.left_name, 0, x, true);
    addName(names, context_.right_name, x, context_.view.width_px, false);
    return names;
  }
  void addName(std::vector<Name>& names, const QString& name, double from_px, double to_px,
               bool at_end) const {
    constexpr double kLineGapPx = 18, kPadPx = 8, kTopPx = 12, kHeightPx = 24, kLeastPx = 32, kMostPx = 420;
    const QFontMetricsF metrics(context_.theme.label_font);
    const double room = std::min(kMostPx, to_px - from_px - 2 * kLineGapPx) - 2 * kPadPx;
    if (name.isEmpty() || room < kLeastPx) return;
    const QString text = metrics.elidedText(name, Qt::ElideRight, room);
    const double width = std::ceil(metrics.horizontalAdvance(text)) + 2 * kPadPx;
    names.push_back({{at_end ? to_px - kLineGapPx - width : from_px + kLineGapPx,
                      context_.covered_top_px + kTopPx, width, kHeightPx},
                     text});
  }
};

/// nullopt: all is well, or its place is not known.
std::optional<MapTrouble> troubleOf(const session::Session& session, const session::MapSlot& slot) {
  const bool nothing = slot.phase() == session::MapSlot::Phase::Failed && !slot.cells();
  if (!nothing && !(slot.cells() && slot.broken())) return std::nullopt;
  const map::CatalogueEntry* const entry = map::entryOf(session.catalogue().entries(), slot.key());
  const std::optional<map::GridReference> grid = !nothing ? std::optional(slot.reference())
                                                 : entry  ? entry->grid
                                                          : std::nullopt;
  if (!grid) return std::nullopt;
  MapTrouble trouble;
  trouble.corners = gridCorners(*grid);
  trouble.nothing_shown = nothing;
  trouble.title = sentences::nameOf(map::subjectOf(slot.key(), slot.name().toStdString()));
  trouble.reason = sentences::sentenceOf(slot.remark());
  if (trouble.reason.isEmpty() && slot.cells())
    trouble.reason = sentences::sentenceOf(slot.cells()->trouble());
  return trouble;
}

LayerContext contextOf(render::TileRenderer& renderer, const render::TileRenderer::Options& options,
                       std::shared_ptr<clouds::CloudStore> clouds, std::function<void()> settled_changed) {
  LayerContext context;
  context.theme = lightMapTheme();
  context.clouds = std::move(clouds);
  context.submaps = &renderer;
  context.rasters.previews = options.previews;
  context.rasters.workers = options.workers;
  context.rasters.budget = std::make_shared<render::TileBudget>();
  context.rasters.budget->bytes = options.budgets.grid_tiles;
  context.settled_changed = std::move(settled_changed);
  return context;
}

}  // namespace

SceneItems::SceneItems(QGraphicsScene& scene, render::TileRenderer& renderer,
                       const render::TileRenderer::Options& options,
                       std::shared_ptr<clouds::CloudStore> clouds, std::function<void()> settled_changed,
                       std::function<void()> labels_due)
    : context(contextOf(renderer, options, std::move(clouds), std::move(settled_changed))),
      order(allLayers()),
      asks(options.previews),
      labels(options.previews),
      raster(context),
      highlight(new HighlightItem(context)),
      measure(new MeasureItem(context)),
      stale(new StaleItem(context)),
      swipe(new SwipeItem(context)),
      mark(new MarkItem(context)),
      ground_(new GroundItem(context)),
      labels_below_(new LabelsItem(context, labels, false)),
      labels_above_(new LabelsItem(context, labels, true)),
      labels_due_(std::move(labels_due)) {
  context.live = &nothing_live;
  context.ink = &labels.ink();
  for (const Layer layer : allLayers()) {
    const LayerSpec& spec = specOf(layer);
    std::vector<LayerItem*>& items = by_layer[layer];
    if (spec.items) items = spec.items(context);
    for (RasterLayer* item : raster.itemsOf(layer)) items.push_back(item);
    all.insert(all.end(), items.begin(), items.end());
    shown[layer] = spec.shown;
    // Submaps are on their own side of a swipe; landmarks and trajectories may belong to an opened map.
    for (LayerItem* item : items) {
      const bool robots = item->of() ? item->of() == FeaturesOf::Robot : spec.follows_robot;
      if (robots && layer != Layer::Submaps) robots_own.push_back(item);
    }
  }
  all.insert(all.end(), {raster.overview(), raster.compared(), raster.difference(), highlight, stale, measure,
                         swipe, mark});
  for (LayerItem* item : all) scene.addItem(item);
  for (QGraphicsItem* item :
       {static_cast<QGraphicsItem*>(ground_), static_cast<QGraphicsItem*>(labels_below_),
        static_cast<QGraphicsItem*>(labels_above_)})
    scene.addItem(item);
  stale->setVisible(false);
  context.changed = [this](const LayerItem& item, const QRectF& rect) { onItemChanged(item, rect); };
  stack();
  applyVisibility();
}

void SceneItems::update(Layer layer) const {
  for (LayerItem* item : itemsOf(layer)) item->update();
}

void SceneItems::allChanged() {
  ground_->changed(ground_->boundingRect());
  labels.changed(nullptr);
}

void SceneItems::viewportResized() {
  for (LayerItem* item : all) item->viewportResized();
  ground_->viewportResized();
  for (LabelsItem* item : {labels_below_, labels_above_}) item->viewportResized();
}

void SceneItems::onItemChanged(const LayerItem& item, const QRectF& rect) {
  if (!rect.isEmpty() && ground_->holds(&item)) ground_->changed(rect);
  if (item.labelUse() == LabelUse::None) return;
  const bool was_due = labels.due();
  labels.changed(&item);
  if (!was_due) labels_due_();
}

void SceneItems::placeLabels() {
  if (!labels.due()) return;
  // The topmost first.
  std::vector<LayerItem*> items(all);
  std::stable_sort(items.begin(), items.end(),
                   [](const LayerItem* a, const LayerItem* b) { return a->zValue() > b->zValue(); });
  std::erase(items, measure);
  for (const QRectF& rect : labels.place(context, items, {measure})) {
    labels_below_->update(rect);
    labels_above_->update(rect);
  }
}

void SceneItems::layGround() {
  std::vector<LayerItem*> layers(all);
  std::stable_sort(layers.begin(), layers.end(),
                   [](const LayerItem* a, const LayerItem* b) { return a->zValue() < b->zValue(); });
  std::vector<const LayerItem*> above{measure, stale, swipe};
  // From the lowest lively layer that is shown, all draw themselves.
  for (const auto& [layer, items] : by_layer) {
    if (!specOf(layer).lively) continue;
    std::copy_if(items.begin(), items.end(), std::back_inserter(above),
                 [](const LayerItem* item) { return item->isVisible(); });
  }
  const auto first = std::find_if(layers.begin(), layers.end(), [&above](const LayerItem* item) {
    return std::find(above.begin(), above.end(), item) != above.end();
  });
  layers.erase(first, layers.end());
  ground_->setLayers(std::move(layers));
}

void SceneItems::stack() {
  int z = 10;
  for (const Layer layer : order) {
    z += 10;
    for (LayerItem* item : itemsOf(layer)) item->setZValue(z);
  }
  const qreal submaps = first(Layer::Submaps).zValue();
  raster.overview()->setZValue(submaps - 1);
  raster.compared()->setZValue(std::max(submaps, first(Layer::WholeMap).zValue()) + 1);
  raster.difference()->setZValue(raster.compared()->zValue() + 1);
  highlight->setZValue(first(Layer::Ids).zValue() + 1);
  if (raster.referenceDifferences()) {
    raster.reference()->setZValue(raster.difference()->zValue() + 1);
  } else if (raster.referenceAbove()) {
    raster.reference()->setZValue(z + 5);
  }
  labels_below_->setZValue(z += 10);
  for (LayerItem* item : {stale, static_cast<LayerItem*>(mark), measure}) item->setZValue(z += 10);
  labels_above_->setZValue(z += 10);
  for (LayerItem* item : {swipe, &first(Layer::ScaleBar)}) item->setZValue(z += 10);
  labels.changed(nullptr);
  layGround();
}

MapsOnScreen SceneItems::onScreen() const {
  return {shown.at(Layer::WholeMap) || compare != CompareMode::Off,
          has_compared && compare != CompareMode::Off, compare,
          compare == CompareMode::Swipe && halves().left == HalfContent::Submaps};
}

Halves SceneItems::halves() const {
  if (wants_second) return {HalfContent::WholeMap, HalfContent::ComparedMap};
  if (has_submaps) return {HalfContent::Submaps, HalfContent::WholeMap};
  return {HalfContent::WholeMap, HalfContent::Nothing};
}

std::optional<QRectF> SceneItems::rectOf(ScreenPart part) const {
  const double x = std::round(context.swipe_at * context.view.width_px);
  if (part == ScreenPart::Left) return QRectF(0, 0, x, context.view.height_px);
  if (part == ScreenPart::Right) return QRectF(x, 0, context.view.width_px - x, context.view.height_px);
  return std::nullopt;
}

void SceneItems::applyVisibility() {
  LayerItem &whole = *raster.whole(), &submaps = first(Layer::Submaps);
  const bool second = has_compared;
  const bool swiping = compare == CompareMode::Swipe;
  const bool difference = compare == CompareMode::Difference && second;
  // Each is set once, at the end: one that is hidden and shown again is painted again.
  std::map<QGraphicsItem*, bool> visible;
  for (const auto& [layer, of_layer] : by_layer) {
    for (LayerItem* item : of_layer) visible[item] = shown.at(layer);
  }
  const bool submaps_left = halves().left == HalfContent::Submaps;
  if (compare != CompareMode::Off) {
    // Each half is one map, regardless of what was on screen before.
    visible[&whole] = !difference;
    visible[&submaps] = swiping && submaps_left;
    // Regions are on neither side of a comparison.
    for (LayerItem* item : itemsOf(Layer::Regions)) visible[item] = false;
    if (raster.referenceDifferences()) visible[raster.reference()] = false;
  }
  visible[raster.compared()] = swiping && second;
  visible[raster.difference()] = difference;
  const auto part = [&](ScreenPart which) { return swiping ? rectOf(which) : std::nullopt; };
  submaps.setPart(part(ScreenPart::Left));
  const ScreenPart of_the_whole = submaps_left ? ScreenPart::Right : ScreenPart::Left;
  whole.setPart(part(of_the_whole));
  raster.compared()->setPart(part(ScreenPart::Right));
  for (LayerItem* item : all) {
    if (item->of() == FeaturesOf::WholeMap) item->setPart(part(of_the_whole));
    if (item->of() != FeaturesOf::ComparedMap) continue;
    item->setPart(part(ScreenPart::Right));
    visible[item] = (visible.contains(item) ? visible[item] : item->isVisible()) && second && swiping;
  }
  // Data of the robot is shown where the robot is.
  for (LayerItem* item : robots_own) item->setPart(rectOf(place.drawn));
  if (place.drawn == ScreenPart::None) {
    for (LayerItem* item : robots_own) visible[item] = false;
    visible[&submaps] = false;
  }
  context.overlays_shown = shown.at(Layer::Overlays);
  first(Layer::Problems).setPart(submaps.part());
  visible[&first(Layer::Problems)] = shown.at(Layer::Problems) && visible[&submaps];
  raster.overview()->setPart(submaps.part());
  visible[raster.overview()] = visible[&submaps];
  raster.overview()->setOpacity(submaps.opacity());
  visible[highlight] = place.drawn != ScreenPart::None;
  visible[swipe] = swiping;
  for (const auto& [item, is_visible] : visible) item->setVisible(is_visible);
  swipe->update();
  for (LayerItem* item : all) item->setActive(item->isVisible());
  layGround();
}

bool SceneItems::placeRobot(session::Session* session) {
  has_submaps = session && session->robot().submapSource();
  wants_second = session && session->comparedMap().phase() != session::MapSlot::Phase::Empty;
  has_compared = session && session->comparedMap().cells() != nullptr;
  const RobotPlace before = place;
  place = {};
  if (!session) {
    robot_wanted.reset();
  } else {
    // A choice applies to one map.
    const session::MapSlot& whole = session->wholeMap();
    const std::optional<map::MapKey> shown_key =
        whole.cells() ? std::optional(whole.shown().key) : std::nullopt;
    if (wanted_on != shown_key) robot_wanted.reset();
    wanted_on = shown_key;
    place = robotPlace(*session, onScreen(), robot_wanted);
  }
  return !(place == before);
}

void SceneItems::updateWaypoints(const session::Session* session) {
  const auto fillWaypoints = [this, session](const session::MapSlot& slot, bool on_screen,
                                             MapFeatures& features) {
    features.waypoints.clear();
    if (!on_screen) return;
    // Edited ones need no picture below them.
    if (edited && edited->map == session->placesOf(slot)) {
      features.waypoints = edited->points;
      return;
    }
    if (!slot.cells() && !session::lacksPicture(slot)) return;
    for (const map::Waypoint& point : slot.waypoints().points) features.waypoints.push_back(drawnFrom(point));
  };
  context.of(FeaturesOf::WholeMap).waypoints.clear();
  context.of(FeaturesOf::ComparedMap).waypoints.clear();
  if (!session) return;
  fillWaypoints(session->wholeMap(), onScreen().whole, context.of(FeaturesOf::WholeMap));
  fillWaypoints(session->comparedMap(), onScreen().compared, context.of(FeaturesOf::ComparedMap));
}

bool SceneItems::opened(const session::Session& session) const {
  const session::MapSlot& slot = session.wholeMap();
  return onScreen().whole && slot.cells() && slot.shown().key.kind != map::MapKind::Live;
}

bool SceneItems::showsRobotsOverlays(const session::Session& session) const {
  // Next to an opened map they only belong on the half of the submaps.
  const bool beside = onScreen().submaps_left && place.drawn == ScreenPart::Left;
  return place.overlays_fit && (!opened(session) || beside);
}

void SceneItems::updateOverlays(const session::Session* session) {
  overlays_edited.clear();
  if (!session || !edited_overlays) return;
  const auto setEdited = [this](FeaturesOf of) {
    overlays_edited.insert(of);
    context.of(of).overlays = edited_overlays->features;
  };
  if (opened(*session) && session->wholeMap().shown().key == edited_overlays->map)
    setEdited(FeaturesOf::WholeMap);
  if (edited_overlays->robots && showsRobotsOverlays(*session)) setEdited(FeaturesOf::Robot);
}

void SceneItems::setFeatures(const session::Session* session) {
  context.features = {};
  updateWaypoints(session);
  if (!session) return;
  const MapsOnScreen on_screen = onScreen();
  const auto copyFeatures = [](const session::MapSlot& slot, MapFeatures& features) {
    if (!slot.cells() || slot.shown().key.kind == map::MapKind::Live) return;
    features.overlays = slot.shown().overlays;
    features.broken_overlays = slot.shown().broken_overlays;
    features.trajectories = slot.shown().trajectories;
    for (const auto& landmark : slot.shown().landmarks)
      features.landmarks.push_back({landmark.id, landmark.position_m, std::nullopt});
  };
  if (on_screen.whole) copyFeatures(session->wholeMap(), context.of(FeaturesOf::WholeMap));
  if (on_screen.compared) copyFeatures(session->comparedMap(), context.of(FeaturesOf::ComparedMap));
  if (on_screen.whole) context.of(FeaturesOf::WholeMap).trouble = troubleOf(*session, session->wholeMap());
  if (on_screen.compared)
    context.of(FeaturesOf::ComparedMap).trouble = troubleOf(*session, session->comparedMap());
  if (context.live->map_info && showsRobotsOverlays(*session)) {
    MapFeatures& robots = context.of(FeaturesOf::Robot);
    robots.overlays = context.live->map_info->overlays;
    robots.broken_overlays = context.live->map_info->broken_overlays;
  }
  updateOverlays(session);
}

}  // namespace mapwright::ui::scene
