// Draws on the map, in viewport pixels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <QColor>
#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <QRectF>

#include "geometry/view_transform.h"
#include "render/raster_tiles.h"
#include "ui/scene/map_theme.h"

namespace mapwright::ui::scene {

QPointF toPoint(const Eigen::Vector2d& v);
QRectF squareAround(const QPointF& middle, double half);
/// `alpha`: 0 … 255.
QColor translucent(QColor color, int alpha);
/// 0xRRGGBBAA.
QColor colorFrom(std::uint32_t rgba);

/// The colour, shifted towards the theme's text colour if letters would not stand out against their halo.
QColor readable(const QColor& color, const MapTheme& theme);
/// Text with a halo, readable on any map.
void drawLabel(QPainter& painter, const QPointF& baseline_left, const QString& text, const MapTheme& theme,
               const QColor& color, bool struck_through = false);
QPolygonF toPolygon(const geometry::ViewTransform& view, const std::vector<Eigen::Vector2d>& world);
/// The box of toPolygon(); neither width nor height is less than 0, unless a point is no number.
QRectF pixelBounds(const geometry::ViewTransform& view, std::span<const Eigen::Vector2d> world);
/// For hatching that moves with the map.
QPointF hatchOrigin(const geometry::ViewTransform& view);
bool inView(const geometry::ViewTransform& view, const QRectF& rect, double margin_px = 20);
/// The viewport polyline of world points without invisible parts: points within two pixels of the previous
/// one, and parts outside the viewport grown by `margin_px` (which gives several polylines). `exposed`: the
/// part of the viewport that is painted; the lines are the same, only fewer.
std::vector<QPolygonF> visibleLines(const geometry::ViewTransform& view,
                                    std::span<const Eigen::Vector2d> world, double margin_px);
std::vector<QPolygonF> visibleLines(const geometry::ViewTransform& view,
                                    std::span<const Eigen::Vector2d> world, double margin_px,
                                    const QRectF& exposed);

/// The same lines as one path: where they cross, a translucent one is not drawn twice.
QPainterPath pathOf(const std::vector<QPolygonF>& lines);

/// Draws the tiles that touch `exposed`, both in device pixels.
void drawTiles(QPainter& painter, const QRectF& exposed, std::span<const render::DrawnTile> tiles);
/// The stand-ins where nothing finished covers them, and the tiles.
void drawRaster(QPainter& painter, const QRectF& exposed, const render::RasterTiles::Drawing& drawing);

}  // namespace mapwright::ui::scene
