#include "scene/layer_item.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QFontMetricsF>
#include <QPainterPath>

#include "words/qt_plain.h"

namespace mapwright::scene {
namespace {

constexpr double kBandPx = 32;

// An invalid position goes into the first band: a robot may send one.
int bandOf(double y) { return y > -1e6 ? int(std::floor(std::min(y, 1e6) / kBandPx)) : int(-1e6 / kBandPx); }

}  // namespace

bool LabelSpace::free(const QRectF& spot) const {
  for (int band = bandOf(spot.top()); band <= bandOf(spot.bottom()); ++band) {
    const auto taken = bands_.find(band);
    if (taken == bands_.end()) continue;
    for (const QRectF& other : taken->second) {
      if (other.intersects(spot)) return false;
    }
  }
  return true;
}

std::optional<QRectF> LabelSpace::take(std::span<const QRectF> spots) {
  const auto spot = std::find_if(spots.begin(), spots.end(), [this](const QRectF& s) { return free(s); });
  if (spot == spots.end()) return std::nullopt;
  for (int band = bandOf(spot->top()); band <= bandOf(spot->bottom()); ++band) bands_[band].push_back(*spot);
  return *spot;
}

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
  const QString text = words::plainName(name);
  return text.size() > longest ? text.left(longest - 1) + QChar(0x2026) : text;
}

void drawName(QPainter& painter, const LayerContext& context, const QRectF& mark, const QString& name,
              const QColor& color) {
  if (name.isEmpty()) return;
  const QFontMetricsF metrics(context.theme.label_font);
  const QSizeF size(metrics.horizontalAdvance(name), metrics.height());
  const auto spot = [&](double center_x, double center_y) {
    return QRectF(QPointF(center_x - size.width() / 2, center_y - size.height() / 2), size);
  };
  const double aside = mark.width() / 2 + 5 + size.width() / 2,
               over = mark.height() / 2 + 3 + size.height() / 2;
  const double x = mark.center().x(), y = mark.center().y();
  const std::array spots{spot(x + aside, y - over / 2),
                         spot(x + aside, y + over / 2),
                         spot(x - aside, y - over / 2),
                         spot(x - aside, y + over / 2),
                         spot(x, y + over),
                         spot(x, y - over)};
  if (const auto taken = context.labels.take(spots)) {
    drawLabel(painter, {taken->left(), taken->top() + metrics.ascent()}, name, context.theme, color);
  }
}

void drawHeading(QPainter& painter, const LayerContext& context, const QPointF& at, double yaw_rad,
                 const QColor& color) {
  const double heading = yaw_rad + context.view.rotation_rad;
  const QPointF tip = at + QPointF(std::cos(heading), -std::sin(heading)) * 13;
  painter.setPen(QPen(context.theme.text_halo, 5, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(at, tip);
  painter.setPen(QPen(color, 2.5, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(at, tip);
}

void drawPlace(QPainter& painter, const LayerContext& context, const Eigen::Vector2d& world_m,
               std::optional<double> yaw_rad, const QColor& color, const QString& name) {
  const QPointF at = toPoint(context.view.pixelFromWorld(world_m));
  if (!inView(context.view, QRectF(at, QSizeF(1, 1)).adjusted(-200, 0, 0, 0))) return;
  painter.setRenderHint(QPainter::Antialiasing);
  if (yaw_rad) drawHeading(painter, context, at, *yaw_rad, color);
  painter.setPen(QPen(context.theme.text_halo, 1.5));
  painter.setBrush(color);
  painter.drawEllipse(at, 5, 5);
  if (!name.isEmpty() && context.view.scale_m_per_px <= kNameFromMPerPx) {
    drawName(painter, context, QRectF(at - QPointF(5, 5), QSizeF(10, 10)), name, context.theme.text);
  }
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

void DeviceLayer::viewMoved() {
  geometry::ViewTransform view = context_.view;
  view.scale_m_per_px /= pixel_ratio_;
  view.width_px = int(std::ceil(view.width_px * pixel_ratio_));
  view.height_px = int(std::ceil(view.height_px * pixel_ratio_));
  takeView(view);
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

}  // namespace mapwright::scene
