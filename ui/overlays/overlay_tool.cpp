#include "ui/overlays/overlay_tool.h"

#include <cmath>
#include <utility>

#include <QPainter>
#include <QPixmap>

#include "overlays/overlay_arrange.h"
#include "overlays/overlay_shapes.h"
#include "overlays/overlay_types.h"
#include "ui/overlays/overlay_text.h"

namespace mapwright::ui {

using Eigen::Vector2d;
using overlays::Shape;

OverlayTool::OverlayTool(edit::OverlayEditing* editing, const scene::MapScene* scene,
                         const OverlaysOnMap* on_map, OverlaySnapping* snapping, QObject* parent)
    : MapTool(parent),
      editing_(editing),
      scene_(scene),
      on_map_(on_map),
      select_(new OverlaySelect(editing, scene, on_map, snapping, this)),
      circle_(new OverlayDrawCircle(OverlayMode::Circle, editing, scene, snapping, this)),
      modes_{select_,
             new OverlayDraw(OverlayMode::Point, editing, scene, snapping, this),
             new OverlayDraw(OverlayMode::Line, editing, scene, snapping, this),
             new OverlayDraw(OverlayMode::Polygon, editing, scene, snapping, this),
             new OverlayDrawRectangle(OverlayMode::Rectangle, editing, scene, snapping, this),
             circle_} {
  types_[std::size_t(Shape::Point)] = 25;
  types_[std::size_t(Shape::Line)] = overlays::kVirtualWall;
  types_[std::size_t(Shape::Polygon)] = overlays::kForbiddenRegion;
  for (const DragTool* const mode : modes_) {
    connect(mode, &MapTool::changed, this, &MapTool::changed);
    connect(mode, &MapTool::hintChanged, this, &MapTool::hintChanged);
    if (const auto* const draw = qobject_cast<const OverlayDraw*>(mode)) {
      connect(draw, &OverlayDraw::refused, this, &OverlayTool::refused);
      connect(draw, &OverlayDraw::drawn, this, [this](const std::vector<Vector2d>& points) {
        editing_->add(shapeOf(mode_), points, newType(shapeOf(mode_)));
      });
      connect(draw, &MapTool::finished, this, [this] { setMode(OverlayMode::Select); });
    }
  }
  for (const auto signal : {&edit::OverlayEditing::changed, &edit::OverlayEditing::previewChanged})
    connect(editing_, signal, this, [this] { ++many_revision_; });
  connect(select_, &OverlaySelect::refused, this, &OverlayTool::refused);
  connect(select_, &MapTool::finished, this, &MapTool::finished);
}

void OverlayTool::setMode(OverlayMode mode) {
  if (mode_ == mode) return;
  hand().deactivate();
  mode_ = mode;
  Q_EMIT modeChanged();
  notifyChanged();
}

void OverlayTool::setNewType(Shape shape, int type) {
  if (std::exchange(types_[std::size_t(shape)], type) != type) Q_EMIT hintChanged();
}

void OverlayTool::setCircleRadius(double metres) {
  if (circle_->radius() != metres) circle_->setRadius(metres);
}

void OverlayTool::addPlace(const Vector2d& at_m, double yaw_deg) {
  if (!editing_->editable()) return;
  dragCancelled();
  auto* const draw = qobject_cast<OverlayDraw*>(&hand());
  if (draw && mode_ != OverlayMode::Point) return draw->addCorner(at_m);
  Feature point = overlays::newFeature(editing_->document().mine(), Shape::Point, {at_m},
                                       newType(Shape::Point), editing_->newId());
  point = overlays::withYaw(point, yaw_deg);
  editing_->put({point}, {}, tr("add %1").arg(overlayCalled(point)));
}

void OverlayTool::setUnavailableReason(const QString& sentence) {
  if (std::exchange(unavailable_reason_, sentence) != sentence) Q_EMIT hintChanged();
}

void OverlayTool::deactivate() {
  hand().deactivate();
  if (std::exchange(mode_, OverlayMode::Select) != OverlayMode::Select) Q_EMIT modeChanged();
}

void OverlayTool::dragged(const MapPoint& at) {
  cursor_m_ = at.world_m;
  hand().dragged(at);
}

void OverlayTool::hovered(const MapPoint& at) {
  cursor_m_ = at.world_m;
  hand().hovered(at);
}

void OverlayTool::left() {
  cursor_m_.reset();
  hand().left();
}

QPointF OverlayTool::px(const Vector2d& world_m) const {
  return scene::toPoint(scene_->view().pixelFromWorld(world_m));
}

bool OverlayTool::claims(const MapKeyPress& press) const {
  if (!editing_->isOpen() || !(press.modifiers & Qt::ControlModifier)) return false;
  if (press.key == Qt::Key_V) return !(press.modifiers & Qt::AltModifier);
  return press.modifiers == Qt::ControlModifier &&
         (press.key == Qt::Key_A || press.key == Qt::Key_C || press.key == Qt::Key_X);
}

/// Copying, cutting, pasting, and selecting all.
bool OverlayTool::editKey(const MapKeyPress& press) {
  const bool shift = press.modifiers & Qt::ShiftModifier;
  if (press.key == Qt::Key_C && !shift) return Q_EMIT copyWanted(), true;
  if (press.key == Qt::Key_X && !shift) return Q_EMIT cutWanted(), true;
  if (press.key == Qt::Key_A && !shift && editing_->isOpen()) {
    std::set<FeatureKey> all;
    for (FeatureKey key = 0; key < editing_->document().size(); ++key)
      if (editing_->document().find(key)) all.insert(key);
    editing_->select(std::move(all));
    return true;
  }
  if (press.key != Qt::Key_V) return false;
  Q_EMIT pasteWanted(shift ? std::optional(cursor_m_.value_or(scene_->view().center_m)) : std::nullopt);
  return true;
}

bool OverlayTool::keyPressed(const MapKeyPress& press) {
  if (press.modifiers & Qt::ControlModifier) return editKey(press);
  if (hand().keyPressed(press)) return true;
  // With no corner to take back, it is about what is selected.
  const bool deletes = press.key == Qt::Key_Delete || press.key == Qt::Key_Backspace;
  return drawing() && deletes && select_->keyPressed(press);
}

void OverlayTool::paint(QPainter& painter) {
  painter.setRenderHint(QPainter::Antialiasing);
  paintTheirs(painter);
  paintSelected(painter);
  hand().paint(painter);
}

/// What is drawn of one on the screen: its points, and its lines.
void OverlayTool::eachLine(FeatureKey key, const std::function<void(const QPointF&)>& point,
                           const std::function<void(const QPolygonF&)>& line, const QRectF& exposed) const {
  const auto* const parts = on_map_->partsOf(key);
  if (!parts) return;
  for (const map::OverlayFeature& part : *parts) {
    for (const auto& ring : part.parts) {
      if (ring.empty()) continue;
      if (part.shape == map::OverlayShape::Point) {
        point(px(ring[0]));
        continue;
      }
      std::vector<Vector2d> points = ring;
      if (part.shape == map::OverlayShape::Polygon) points.push_back(points.front());
      for (const QPolygonF& piece : scene::visibleLines(scene_->view(), points, 8, exposed)) line(piece);
    }
  }
}

void OverlayTool::paintSelected(QPainter& painter) {
  std::set<FeatureKey> keys = editing_->selected();
  if (const auto under = select_->under(); under && !drawing()) keys.insert(*under);
  painter.setBrush(Qt::NoBrush);
  if (keys.size() > kMostDrawnInHand) {
    const QColor color = scene_->theme().accent;
    if (keys != many_keys_ || color != many_color_) ++many_revision_;
    many_keys_ = std::move(keys);
    many_color_ = color;
    const QRectF viewport(painter.viewport());
    const QRectF exposed = painter.hasClipping() ? painter.clipBoundingRect() & viewport : viewport;
    return many_.paint(painter, exposed, scene_->view(), many_revision_,
                       [this](QPainter& on, const QRectF& part) { paintMany(on, many_keys_, part); });
  }
  many_.forget();
  for (const FeatureKey key : keys) {
    if (!editing_->find(key)) continue;
    const Qt::PenStyle style = editing_->selected().contains(key) ? Qt::SolidLine : Qt::DotLine;
    const auto stroke = [&](const auto& draw) {
      strokeWithHalo(painter, scene_->theme(), 2.5, draw, style, 2.5);
    };
    eachLine(
        key, [&](const QPointF& at) { stroke([&] { painter.drawEllipse(at, 11, 11); }); },
        [&](const QPolygonF& line) { stroke([&] { painter.drawPolyline(line); }); },
        QRectF(painter.viewport()));
  }
}

/// Plainer, and fast: each mark of a point is a copy of one picture.
void OverlayTool::paintMany(QPainter& painter, const std::set<FeatureKey>& keys,
                            const QRectF& exposed) const {
  constexpr double kMarkPx = 26;
  const QColor accent = scene_->theme().accent;
  const double ratio = painter.device()->devicePixelRatioF();
  QPixmap mark(int(std::ceil(kMarkPx * ratio)), int(std::ceil(kMarkPx * ratio)));
  mark.setDevicePixelRatio(ratio);
  mark.fill(Qt::transparent);
  QPainter on_mark(&mark);
  on_mark.setRenderHint(QPainter::Antialiasing);
  on_mark.setPen(QPen(accent, 2.5));
  on_mark.drawEllipse(QPointF(kMarkPx / 2, kMarkPx / 2), 11, 11);
  on_mark.end();
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(QPen(accent, 2));
  const QRectF seen = exposed.adjusted(-kMarkPx, -kMarkPx, kMarkPx, kMarkPx);
  for (const FeatureKey key : keys) {
    eachLine(
        key,
        [&](const QPointF& at) {
          if (seen.contains(at)) painter.drawPixmap(at - QPointF(kMarkPx / 2, kMarkPx / 2), mark);
        },
        [&](const QPolygonF& line) { painter.drawPolyline(line); }, exposed);
  }
  painter.restore();
}

void OverlayTool::paintTheirs(QPainter& painter) const {
  const scene::MapTheme& theme = scene_->theme();
  painter.setBrush(Qt::NoBrush);
  for (const auto& [key, part] : editing_->document().conflicts()) {
    const auto& theirs = editing_->document().findBase(key);
    if (!theirs || part.of == overlays::Part::Of::Property) continue;
    for (const overlays::Path& path : overlays::shapesOf(*theirs).paths) {
      std::vector<Vector2d> points = path.points;
      if (points.empty()) continue;
      if (path.shape == Shape::Polygon) points.push_back(points.front());
      painter.setPen(QPen(theme.warn, 2.5, Qt::DashLine));
      if (path.shape == Shape::Point) painter.drawEllipse(px(points[0]), 9, 9);
      for (const QPolygonF& line : scene::visibleLines(scene_->view(), points, 8)) painter.drawPolyline(line);
    }
  }
}

QString OverlayTool::hint() const {
  if (!editing_->isOpen())
    return unavailable_reason_.isEmpty() ? tr("Loading the overlays. Esc leaves.") : unavailable_reason_;
  return editing_->editable() ? hand().hint() : tr("The overlays are being saved.");
}

}  // namespace mapwright::ui

#include "moc_overlay_tool.cpp"
