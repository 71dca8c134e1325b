#include "ui/scene/layer_item.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QPainterPath>

#include "words/qt_plain.h"
#include "words/shortened.h"

namespace mapwright::ui::scene {
namespace {

constexpr double kPlacePx = 5, kHeadingPx = 13;

QPointF headingTip(const LayerContext& context, double yaw_rad) {
  const double heading = yaw_rad + context.view.rotation_rad;
  return QPointF(std::cos(heading), -std::sin(heading)) * kHeadingPx;
}

}  // namespace

void LineSheet::paint(QPainter& painter, const QSizeF& viewport, double opacity,
                      const std::function<void(QPainter&)>& draw) {
  const qreal ratio = painter.device()->devicePixelRatioF();
  const QSize size = (viewport * ratio).toSize();
  if (sheet_.size() != size) sheet_ = QImage(size, QImage::Format_ARGB32_Premultiplied);
  if (sheet_.isNull()) return;
  sheet_.setDevicePixelRatio(ratio);
  sheet_.fill(Qt::transparent);
  QPainter on_sheet(&sheet_);
  draw(on_sheet);
  on_sheet.end();
  const qreal before = painter.opacity();
  painter.setOpacity(before * opacity);
  painter.drawImage(QPointF(0, 0), sheet_);
  painter.setOpacity(before);
}

QString shortName(const std::string& name, qsizetype longest) {
  return words::shortened(words::plainName(name), longest);
}

void drawHeading(QPainter& painter, const LayerContext& context, const QPointF& at, double yaw_rad,
                 const QColor& color) {
  const QPointF tip = at + headingTip(context, yaw_rad);
  painter.setPen(QPen(context.theme.text_halo, 5, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(at, tip);
  painter.setPen(QPen(color, 2.5, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(at, tip);
}

void drawPlace(QPainter& painter, const LayerContext& context, const Eigen::Vector2d& world_m,
               std::optional<double> yaw_rad, const QColor& color) {
  const QPointF at = toPoint(context.view.pixelFromWorld(world_m));
  if (!inView(context.view, QRectF(at, QSizeF(1, 1)))) return;
  painter.setRenderHint(QPainter::Antialiasing);
  if (yaw_rad) drawHeading(painter, context, at, *yaw_rad, color);
  painter.setPen(QPen(context.theme.text_halo, 1.5));
  painter.setBrush(color);
  painter.drawEllipse(at, kPlacePx, kPlacePx);
}

void drawHaloedLine(QPainter& painter, const LayerContext& context, const QColor& color, double width_px,
                    std::span<const Eigen::Vector2d> world_m, const QRectF& exposed) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  const QPainterPath lines = pathOf(visibleLines(context.view, world_m, width_px + 2, exposed));
  for (const auto& [pen_color, pen_width] :
       {std::pair(context.theme.text_halo, width_px + 2), std::pair(color, width_px)}) {
    painter.setPen(QPen(pen_color, pen_width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(lines);
  }
}

void keepSmallClear(LabelCollector& labels, const QRectF& area, double largest_px) {
  if (std::max(area.width(), area.height()) <= largest_px) labels.symbol(area);
}

void keepClear(LabelCollector& labels, const LayerContext& context, const QRectF& mark,
               std::optional<double> yaw_rad) {
  labels.symbol(mark);
  if (!yaw_rad) return;
  const QPointF tip = mark.center() + headingTip(context, *yaw_rad);
  labels.symbol(QRectF(mark.center(), tip).normalized().adjusted(-2, -2, 2, 2));
}

void labelPlace(LabelCollector& labels, const LayerContext& context, const Eigen::Vector2d& world_m,
                std::optional<double> yaw_rad, LabelRank rank, std::uint64_t id, const QString& name) {
  const QRectF mark = QRectF(-kPlacePx, -kPlacePx, 2 * kPlacePx, 2 * kPlacePx)
                          .translated(toPoint(context.view.pixelFromWorld(world_m)));
  keepClear(labels, context, mark, yaw_rad);
  if (labels.named(mark)) labels.add(LabelWish::Position::Beside, rank, mark, id, name, context.theme.text);
}

LayerItem::LayerItem(const LayerContext& context, std::optional<FeaturesOf> of) : context_(context), of_(of) {
  setFlag(ItemUsesExtendedStyleOption);
  setAcceptedMouseButtons(Qt::NoButton);
}

QRectF LayerItem::boundingRect() const {
  return {0, 0, qreal(context_.view.width_px), qreal(context_.view.height_px)};
}

QPainterPath LayerItem::shape() const {
  QPainterPath path;
  path.addRect(part_ ? *part_ & boundingRect() : boundingRect());
  return path;
}

void LayerItem::update(const QRectF& rect) {
  ++revision_;
  QGraphicsItem::update(rect);
  if (context_.changed) context_.changed(*this, rect.isNull() ? boundingRect() : rect);
}

QVariant LayerItem::itemChange(GraphicsItemChange change, const QVariant& value) {
  // The scene is told by QGraphicsItem, but not the picture that the GroundItem keeps.
  if (change == ItemVisibleHasChanged || change == ItemOpacityHasChanged) update();
  return QGraphicsItem::itemChange(change, value);
}

void SmallLayer::liveChanged() {
  const QRectF before = painted_;
  markPainted();
  for (const QRectF& rect : {before, painted_}) {
    if (!rect.isEmpty()) update(rect);
  }
  // Its labels, though it had none before, and has none now.
  if (before.isEmpty() && painted_.isEmpty() && context_.changed) context_.changed(*this, QRectF());
}

QRectF SmallLayer::reachOf(std::span<const Eigen::Vector2d> world_m, double margin_px) const {
  if (world_m.empty()) return {};
  const geometry::ViewTransform& view = context_.view;
  double left = std::numeric_limits<double>::infinity(), top = left, right = -left, bottom = -left;
  for (const Eigen::Vector2d& point : world_m) {
    const Eigen::Vector2d at = view.pixelFromWorld(point);
    if (!at.allFinite()) continue;
    left = std::min(left, at.x());
    right = std::max(right, at.x());
    top = std::min(top, at.y());
    bottom = std::max(bottom, at.y());
  }
  if (!(left <= right)) return {};
  const QRectF reach(QPointF(left, top), QPointF(right, bottom));
  return reach.adjusted(-margin_px, -margin_px, margin_px, margin_px) & boundingRect();
}

void LayerItem::setStyle(const LayerStyle& style) {
  if (style == style_) return;
  style_ = style;
  lookChanged();
}

void LayerItem::setPart(std::optional<QRectF> part) {
  if (part == part_) return;
  prepareGeometryChange();
  part_ = part;
  setFlag(ItemClipsToShape, part_.has_value());
  update();
}

void CrowdLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) {
  constexpr std::size_t kCrowd = 500;
  if (!widget || count() < kCrowd) {
    kept_.forget();
    return paintThings(*painter, option->exposedRect);
  }
  kept_.paint(*painter, option->exposedRect, context_.view, revision(),
              [this](QPainter& on, const QRectF& exposed) { paintThings(on, exposed); });
}

void DeviceLayer::viewMoved() {
  geometry::ViewTransform view = context_.view;
  view.scale_m_per_px /= pixel_ratio_;
  view.width_px = int(std::ceil(view.width_px * pixel_ratio_));
  view.height_px = int(std::ceil(view.height_px * pixel_ratio_));
  onViewChanged(view);
}

void DeviceLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) {
  if (const qreal ratio = painter->device()->devicePixelRatioF(); ratio != pixel_ratio_) {
    pixel_ratio_ = ratio;
    viewMoved();
  }
  QRectF exposed = option->exposedRect;
  if (part()) exposed &= *part();
  if (exposed.isEmpty()) return;
  painter->save();
  if (part()) painter->setClipRect(*part(), Qt::IntersectClip);
  painter->scale(1 / pixel_ratio_, 1 / pixel_ratio_);
  painter->setRenderHint(QPainter::SmoothPixmapTransform, false);
  paintPixels(*painter, QRectF(exposed.topLeft() * pixel_ratio_, exposed.size() * pixel_ratio_));
  painter->restore();
}

}  // namespace mapwright::ui::scene
