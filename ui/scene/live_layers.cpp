#include "scene/live_layers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QPainter>

namespace mapwright::scene {
namespace {

constexpr int kTileEdge = 256;  // of the renderer's tiles

}  // namespace

RasterLayer::RasterLayer(const LayerContext& context, render::GridRenderer& renderer)
    : DeviceLayer(context), renderer_(renderer) {}

void RasterLayer::paintPixels(QPainter& painter, const QRectF& exposed) {
  drawRaster(painter, exposed, renderer_.drawing());
}

CloudLayer::Key CloudLayer::keyNow() const {
  return {context_.view, context_.live->clouds, style(), context_.theme.dark, ratio_};
}

void CloudLayer::pointsArrived() {
  const auto toLogical = [this](const QRect& rect) {
    return QRectF(QPointF(rect.topLeft()) / ratio_, QSizeF(rect.size()) / ratio_).adjusted(-1, -1, 1, 1);
  };
  update(toLogical(painted_));
  splat();
  update(toLogical(painted_));
}

void CloudLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  ratio_ = painter->device()->devicePixelRatioF();
  if (!(keyNow() == key_)) splat();
  if (painted_.isEmpty()) return;
  const QRectF target(QPointF(painted_.topLeft()) / ratio_, QSizeF(painted_.size()) / ratio_);
  painter->drawImage(target, image_, painted_);
}

// Points are written directly into an image: thirty thousand of them take a fraction of a millisecond there
// and ten with the painter.
void CloudLayer::splat() {
  key_ = keyNow();
  const geometry::ViewTransform& view = context_.view;
  const QSize size(int(std::ceil(view.width_px * ratio_)), int(std::ceil(view.height_px * ratio_)));
  if (image_.size() != size) {
    image_ = QImage(size, QImage::Format_ARGB32_Premultiplied);
    image_.fill(Qt::transparent);
  } else if (!painted_.isEmpty()) {
    for (int y = painted_.top(); y <= painted_.bottom(); ++y) {
      auto* line = reinterpret_cast<QRgb*>(image_.scanLine(y));
      std::fill(line + painted_.left(), line + painted_.right() + 1, 0);
    }
  }
  painted_ = {};
  if (image_.isNull() || context_.live->clouds.empty()) return;

  const auto choice = CloudChoice(style().choice);
  const QColor one = colorOr(context_.theme.cloud);
  std::array<QRgb, 256> colors;
  for (int i = 0; i < 256; ++i) {
    colors[std::size_t(i)] =
        choice == CloudChoice::OneColor ? one.rgb() : QColor::fromHsv(240 - i * 240 / 255, 220, 230).rgb();
  }
  const int edge = std::max(1, int(std::lround(sizeOr(2) * ratio_)));
  const double c = std::cos(view.rotation_rad), s = std::sin(view.rotation_rad);
  const double per_m = ratio_ / view.scale_m_per_px;
  const double half_w = view.width_px * ratio_ / 2, half_h = view.height_px * ratio_ / 2;
  int left = size.width(), top = size.height(), right = -1, bottom = -1;
  std::vector<QRgb*> rows(std::size_t(size.height()));
  for (int y = 0; y < size.height(); ++y) rows[std::size_t(y)] = reinterpret_cast<QRgb*>(image_.scanLine(y));
  for (const auto& [topic, cloud] : context_.live->clouds) {
    if (!cloud) continue;
    for (const map::CloudPoint& point : *cloud) {
      const double dx = (point.x_m - view.center_m.x()) * per_m, dy = (point.y_m - view.center_m.y()) * per_m;
      const double px = half_w + c * dx - s * dy - edge / 2.0, py = half_h - (s * dx + c * dy) - edge / 2.0;
      if (!(px > -edge && py > -edge && px < size.width() && py < size.height())) continue;
      const int x0 = std::max(0, int(std::floor(px + 0.5))), y0 = std::max(0, int(std::floor(py + 0.5)));
      const int x1 = std::min(size.width(), int(std::floor(px + 0.5)) + edge);
      const int y1 = std::min(size.height(), int(std::floor(py + 0.5)) + edge);
      if (x0 >= x1 || y0 >= y1) continue;
      std::size_t index = point.intensity;
      if (choice == CloudChoice::Height) index = std::size_t(std::clamp(point.z_m / 2.5F, 0.0F, 1.0F) * 255);
      for (int y = y0; y < y1; ++y)
        std::fill(rows[std::size_t(y)] + x0, rows[std::size_t(y)] + x1, colors[index]);
      left = std::min(left, x0);
      top = std::min(top, y0);
      right = std::max(right, x1 - 1);
      bottom = std::max(bottom, y1 - 1);
    }
  }
  if (right >= left) painted_ = QRect(QPoint(left, top), QPoint(right, bottom));
}

LinesLayer::LinesLayer(const LayerContext& context, Lines lines, QColor MapTheme::*color, double width_px)
    : LayerItem(context), lines_(std::move(lines)), color_(color), width_px_(width_px) {}

void LinesLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const double width = sizeOr(width_px_);
  const QColor color = colorOr(context_.theme.*color_);
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setBrush(Qt::NoBrush);
  lines_([&](std::span<const Eigen::Vector2d> world) {
    for (const QPolygonF& line : visibleLines(context_.view, world, width + 2)) {
      painter->setPen(QPen(context_.theme.text_halo, width + 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      painter->drawPolyline(line);
      painter->setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      painter->drawPolyline(line);
    }
  });
}

void ConstraintsLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const auto& sets = context_.live->constraints.by_name;
  const QSizeF viewport(context_.view.width_px, context_.view.height_px);
  const QRectF seen(QPointF(0, 0), viewport);
  for (const auto& [name, segments] : sets) {
    QList<QLineF> lines;
    for (const auto& [from, to] : segments) {
      const QLineF line(toPoint(context_.view.pixelFromWorld(from)),
                        toPoint(context_.view.pixelFromWorld(to)));
      if (QRectF(line.p1(), line.p2()).normalized().adjusted(-1, -1, 1, 1).intersects(seen)) lines << line;
    }
    if (lines.isEmpty()) continue;
    // Residuals are remaining errors; other constraints are only there.
    const bool residual = name.find("esidual") != std::string::npos;
    const QColor color = colorOr(residual ? context_.theme.bad : context_.theme.constraint);
    sheet_.paint(*painter, viewport, 0.8, [&](QPainter& on_sheet) {
      on_sheet.setPen(QPen(color, 0));
      on_sheet.drawLines(lines);
    });
  }
}

void LocalPathLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const map::LocalPathMessage& path = context_.live->local_path;
  if (path.points.size() < 2) return;
  QColor color = translucent(colorOr(context_.theme.path), 90);
  if (path.rgba && !style().color.isValid()) {
    color = QColor(int(*path.rgba >> 24 & 255), int(*path.rgba >> 16 & 255), int(*path.rgba >> 8 & 255),
                   std::max(60, int(*path.rgba & 255)));
  }
  const double width = std::clamp(path.width_m / context_.view.scale_m_per_px, 3.0, 4000.0);
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setBrush(Qt::NoBrush);
  painter->setPen(QPen(color, width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
  for (const QPolygonF& line : visibleLines(context_.view, path.points, width)) painter->drawPolyline(line);
}

void TargetLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const auto& planning = context_.live->planning;
  if (!planning) return;
  constexpr std::size_t kFew = 50;
  constexpr double kReachPx = 20;
  const QColor color = colorOr(context_.theme.target);
  const QRectF near_view(-kReachPx, -kReachPx, context_.view.width_px + 2 * kReachPx,
                         context_.view.height_px + 2 * kReachPx);
  for (const geometry::Pose2& target : planning->targets) {
    const QPointF at = toPoint(context_.view.pixelFromWorld({target.x_m, target.y_m}));
    if (!near_view.contains(at)) continue;
    const double heading = target.yaw_rad + context_.view.rotation_rad;
    if (planning->targets.size() > kFew) {  // a cloud of them
      painter->setPen(QPen(color, 1.5));
      painter->drawLine(at, at + QPointF(std::cos(heading), -std::sin(heading)) * 7);
      continue;
    }
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setBrush(Qt::NoBrush);
    for (const auto& [pen_color, width] : {std::pair{context_.theme.text_halo, 5.0}, std::pair{color, 2.0}}) {
      painter->setPen(QPen(pen_color, width, Qt::SolidLine, Qt::RoundCap));
      painter->drawEllipse(at, 9, 9);
      painter->drawLine(at, at + QPointF(std::cos(heading), -std::sin(heading)) * 16);
    }
    painter->setBrush(color);
    painter->drawEllipse(at, 2, 2);
  }
}

void NearbyRobotsLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const QColor color = colorOr(context_.theme.other_robot);
  painter->setRenderHint(QPainter::Antialiasing);
  for (const map::NearbyRobot& other : context_.live->nearby_robots) {
    painter->setBrush(Qt::NoBrush);
    painter->setPen(QPen(translucent(color, 150), 2, Qt::DotLine));
    for (const QPolygonF& line : visibleLines(context_.view, other.trend, 4)) painter->drawPolyline(line);
    const auto outline = context_.live->nearby_footprints.find(other.footprint_digest);
    if (outline != context_.live->nearby_footprints.end() && outline->second.size() >= 3) {
      QPolygonF polygon;
      for (const Eigen::Vector2d& corner : outline->second) {
        polygon << toPoint(context_.view.pixelFromWorld(other.pose.apply(corner)));
      }
      painter->setBrush(translucent(color, 70));
      painter->setPen(QPen(color, 1.5));
      painter->drawPolygon(polygon);
    }
    drawPlace(*painter, context_, {other.pose.x_m, other.pose.y_m}, other.pose.yaw_rad, color,
              QString::fromStdString(other.uid));
  }
}

void SwipeLayer::setAt(double fraction) {
  at_ = fraction;
  update();
}

void SwipeLayer::setNames(const QString& left, const QString& right) {
  if (left == left_ && right == right_) return;
  left_ = left;
  right_ = right;
  update();
}

void SwipeLayer::paintName(QPainter& painter, const QString& name, double from_px, double to_px,
                           bool at_end) const {
  constexpr double kLineGapPx = 18, kPadPx = 8, kTopPx = 12, kHeightPx = 24, kLeastPx = 32, kMostPx = 420;
  const QFontMetricsF metrics(context_.theme.label_font);
  const double room = std::min(kMostPx, to_px - from_px - 2 * kLineGapPx) - 2 * kPadPx;
  if (name.isEmpty() || room < kLeastPx) return;
  const QString text = metrics.elidedText(name, Qt::ElideRight, room);
  const double width = std::ceil(metrics.horizontalAdvance(text)) + 2 * kPadPx;
  const QRectF box(at_end ? to_px - kLineGapPx - width : from_px + kLineGapPx,
                   context_.covered_top_px + kTopPx, width, kHeightPx);
  painter.setPen(Qt::NoPen);
  painter.setBrush(context_.theme.text_halo);
  painter.drawRoundedRect(box, 4, 4);
  painter.setPen(context_.theme.text);
  painter.setFont(context_.theme.label_font);
  painter.drawText(box, Qt::AlignCenter, text);
}

void SwipeLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const double x = std::round(at_ * context_.view.width_px);
  painter->fillRect(QRectF(x - 2, 0, 4, context_.view.height_px), context_.theme.text_halo);
  painter->fillRect(QRectF(x - 1, 0, 2, context_.view.height_px), context_.theme.accent);
  painter->setRenderHint(QPainter::Antialiasing);
  paintName(*painter, left_, 0, x, true);
  paintName(*painter, right_, x, context_.view.width_px, false);
}

}  // namespace mapwright::scene
