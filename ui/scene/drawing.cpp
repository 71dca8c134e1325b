#include "ui/scene/drawing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <QFile>
#include <QGlyphRun>
#include <QRawFont>
#include <QTextLayout>

#include "ui/scene/label_font.h"

namespace mapwright::ui::scene {
namespace {

/// Emoji are pictures in their font.
bool hasPictures(const QGlyphRun& run) { return !run.rawFont().fontTable("CBLC").isEmpty(); }

/// The font to take a run's outlines from. Those that FreeType reads from a face move by up to 1/64 pixel
/// once the same face has drawn hinted letters, as a window does: so labels have a face of their own.
QRawFont faceFor(const QGlyphRun& run) {
  struct Own {
    QRawFont font;
    QByteArray head;  // tells versions of the file apart
    std::map<qreal, QRawFont> sized;
  };
  const auto load = [] {
    auto* const own = new Own;
    QFile file(QString::fromLatin1(kLabelFontFile));
    if (file.open(QIODevice::ReadOnly)) own->font.loadFromData(file.readAll(), 1, QFont::PreferNoHinting);
    if (own->font.isValid()) own->head = own->font.fontTable("head");
    return own;
  };
  static Own& own = *load();  // never deleted: fonts must not outlive the application
  const QRawFont font = run.rawFont();
  if (own.head.isEmpty() || font.fontTable("head") != own.head) return font;
  const auto [sized, is_new] = own.sized.try_emplace(font.pixelSize(), own.font);
  if (is_new) sized->second.setPixelSize(font.pixelSize());
  return sized->second;
}

/// All but the pictures: once Qt 6.4 was asked for the outlines of their font it takes other widths for them,
/// and may find none.
QPainterPath outlines(const QList<QGlyphRun>& runs) {
  QPainterPath path;
  path.setFillRule(Qt::WindingFill);
  for (const QGlyphRun& run : runs) {
    if (hasPictures(run)) continue;
    const QRawFont font = faceFor(run);
    const QList<quint32> glyphs = run.glyphIndexes();
    const QList<QPointF> positions = run.positions();
    for (qsizetype i = 0; i < glyphs.size(); ++i)
      path.addPath(font.pathForGlyph(glyphs[i]).translated(positions[i]));
    if (run.strikeOut()) {
      const QRectF box = run.boundingRect();
      path.addRect(box.left(), positions.value(0).y() - font.ascent() / 3, box.width(), font.lineThickness());
    }
  }
  return path;
}

}  // namespace

QPointF toPoint(const Eigen::Vector2d& v) { return {v.x(), v.y()}; }

QRectF squareAround(const QPointF& middle, double half) {
  return {middle - QPointF(half, half), QSizeF(2 * half, 2 * half)};
}

QColor translucent(QColor color, int alpha) {
  color.setAlpha(alpha);
  return color;
}

QColor colorFrom(std::uint32_t rgba) {
  return QColor(int(rgba >> 24 & 255), int(rgba >> 16 & 255), int(rgba >> 8 & 255), int(rgba & 255));
}

QPolygonF toPolygon(const geometry::ViewTransform& view, const std::vector<Eigen::Vector2d>& world) {
  QPolygonF polygon;
  for (const Eigen::Vector2d& corner : world) polygon << toPoint(view.pixelFromWorld(corner));
  return polygon;
}

QPointF hatchOrigin(const geometry::ViewTransform& view) {
  constexpr int kHatchPx = 8;  // Qt's patterns repeat after this
  const QPointF zero = toPoint(view.pixelFromWorld({0, 0}));
  const auto phase = [](double at) { return std::isfinite(at) ? std::fmod(std::round(at), kHatchPx) : 0.0; };
  return {phase(zero.x()), phase(zero.y())};
}

bool inView(const geometry::ViewTransform& view, const QRectF& rect, double margin_px) {
  return rect.adjusted(-margin_px, -margin_px, margin_px, margin_px)
      .intersects(QRectF(0, 0, view.width_px, view.height_px));
}

QColor readable(const QColor& color, const MapTheme& theme) {
  // Relative luminance and contrast as in WCAG 2; above its limits, as the halo covers part of thin letters.
  constexpr float kLeastContrast = 10;
  constexpr int kSteps = 10;
  const auto linear = [](float part) {
    return part <= 0.04045F ? part / 12.92F : std::pow((part + 0.055F) / 1.055F, 2.4F);
  };
  const auto luminance = [&linear](const QColor& of) {
    return 0.2126F * linear(of.redF()) + 0.7152F * linear(of.greenF()) + 0.0722F * linear(of.blueF());
  };
  const float halo = luminance(theme.text_halo);
  for (int step = 0; step < kSteps; ++step) {
    const float part = float(step) / kSteps;
    const auto mixed = [part](float own, float text) { return own + (text - own) * part; };
    const QColor one =
        QColor::fromRgbF(mixed(color.redF(), theme.text.redF()), mixed(color.greenF(), theme.text.greenF()),
                         mixed(color.blueF(), theme.text.blueF()));
    const float own = luminance(one);
    if ((std::max(own, halo) + 0.05F) / (std::min(own, halo) + 0.05F) >= kLeastContrast) return one;
  }
  return theme.text;
}

void drawLabel(QPainter& painter, const QPointF& baseline_left, const QString& text, const MapTheme& theme,
               const QColor& color, bool struck_through) {
  QFont font = theme.label_font;
  font.setStrikeOut(struck_through);
  QTextLayout layout(text, font);
  layout.beginLayout();
  const QTextLine line = layout.createLine();
  layout.endLayout();
  const QList<QGlyphRun> runs = layout.glyphRuns();
  const QPointF origin = baseline_left - QPointF(0, line.ascent());
  const QPainterPath path = outlines(runs).translated(origin);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme.text_halo, 3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(path);
  painter.fillPath(path, color);
  for (const QGlyphRun& run : runs) {
    if (hasPictures(run)) painter.drawGlyphRun(origin, run);
  }
}

QRectF pixelBounds(const geometry::ViewTransform& view, std::span<const Eigen::Vector2d> world) {
  if (world.empty()) return {};
  QPointF least = toPoint(view.pixelFromWorld(world.front())), most = least;
  for (const Eigen::Vector2d& point : world.subspan(1)) {
    const QPointF pixel = toPoint(view.pixelFromWorld(point));
    least = {std::min(least.x(), pixel.x()), std::min(least.y(), pixel.y())};
    most = {std::max(most.x(), pixel.x()), std::max(most.y(), pixel.y())};
  }
  return {least, most};
}

std::vector<QPolygonF> visibleLines(const geometry::ViewTransform& view,
                                    std::span<const Eigen::Vector2d> world, double margin_px) {
  return visibleLines(view, world, margin_px, QRectF(0, 0, view.width_px, view.height_px));
}

std::vector<QPolygonF> visibleLines(const geometry::ViewTransform& view,
                                    std::span<const Eigen::Vector2d> world, double margin_px,
                                    const QRectF& exposed) {
  std::vector<QPolygonF> lines;
  QPolygonF line;
  const QRectF seen = (exposed & QRectF(0, 0, view.width_px, view.height_px))
                          .adjusted(-margin_px, -margin_px, margin_px, margin_px);
  const auto end = [&] {
    if (line.size() > 1) lines.push_back(line);
    line.clear();
  };
  std::optional<QPointF> before;
  for (std::size_t i = 0; i < world.size(); ++i) {
    const QPointF pixel = toPoint(view.pixelFromWorld(world[i]));
    if (!std::isfinite(pixel.x()) || !std::isfinite(pixel.y())) {
      end();
      before.reset();
      continue;
    }
    if (!before) {
      before = pixel;
      continue;
    }
    const QPointF step = pixel - *before;
    if (std::abs(step.x()) + std::abs(step.y()) < 2 && i + 1 < world.size()) continue;
    const QRectF box = QRectF(*before, pixel).normalized();
    const bool crosses = box.left() <= seen.right() && box.right() >= seen.left() &&
                         box.top() <= seen.bottom() && box.bottom() >= seen.top();
    if (crosses) {
      if (line.isEmpty()) line << *before;
      line << pixel;
    } else {
      end();
    }
    before = pixel;
  }
  end();
  return lines;
}

QPainterPath pathOf(const std::vector<QPolygonF>& lines) {
  QPainterPath path;
  for (const QPolygonF& line : lines) path.addPolygon(line);
  return path;
}

void drawRaster(QPainter& painter, const QRectF& exposed, const render::RasterTiles::Drawing& drawing) {
  if (!drawing.stand_ins.empty()) {
    painter.save();
    painter.setClipRegion(QRegion(exposed.toAlignedRect()) - drawing.covered, Qt::IntersectClip);
    drawTiles(painter, exposed, drawing.stand_ins);
    painter.restore();
  }
  drawTiles(painter, exposed, drawing.tiles);
}

void drawTiles(QPainter& painter, const QRectF& exposed, std::span<const render::DrawnTile> tiles) {
  const QTransform base = painter.transform();
  for (const render::DrawnTile& tile : tiles) {
    if (tile.image.isNull() || !tile.to_viewport.mapRect(QRectF(tile.image.rect())).intersects(exposed))
      continue;
    if (tile.to_viewport.type() <= QTransform::TxTranslate) {
      painter.setTransform(base);
      painter.drawImage(QPointF(tile.to_viewport.dx(), tile.to_viewport.dy()), tile.image);
    } else {
      painter.setTransform(tile.to_viewport * base);
      painter.drawImage(QPointF(0, 0), tile.image);
    }
  }
  painter.setTransform(base);
}

}  // namespace mapwright::ui::scene
