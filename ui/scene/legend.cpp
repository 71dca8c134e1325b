#include "ui/scene/legend.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <QLinearGradient>
#include <QPainterPath>

#include "render/grid_palettes.h"
#include "render/sample_grid.h"
#include "robot/robot.h"
#include "ui/scene/layer_reason.h"
#include "ui/scene/map_scene.h"
#include "ui/scene/scene_items.h"

namespace mapwright::ui::scene {
namespace {

/// Of the reference map and the map on screen.
LegendSection referenceLegend(const Legend::Source& source) {
  using render::Difference;
  Legend legend(Layer::Reference, source);
  const render::GridPalette palette = render::differencePalette(source.context.theme.dark);
  const auto add = [&](Difference what, const QString& text) {
    legend.addCell(text, cellColor(palette[std::size_t(what)]));
  };
  add(Difference::Appeared, LegendText::tr("Not on the reference map"));
  add(Difference::Vanished, LegendText::tr("On the reference map only"));
  add(Difference::OnlyFirst, LegendText::tr("Known on the reference map only"));
  add(Difference::OnlySecond, LegendText::tr("Unknown on the reference map"));
  add(Difference::SameOccupied, LegendText::tr("Occupied in both"));
  add(Difference::SameFree, LegendText::tr("Free in both"));
  return {LegendText::tr("Differences from the reference map"), legend.rows()};
}

LegendSection differenceLegend(const Legend::Source& source) {
  const bool earlier = source.session && source.session->comparedMap().showsEarlierState();
  using render::Difference;
  Legend legend(Layer::WholeMap, source);
  const render::GridPalette palette = render::differencePalette(source.context.theme.dark);
  const auto add = [&](Difference what, const QString& text) {
    legend.addCell(text, cellColor(palette[std::size_t(what)]));
  };
  add(Difference::Appeared,
      earlier ? LegendText::tr("New since then") : LegendText::tr("New in the second map"));
  add(Difference::Vanished,
      earlier ? LegendText::tr("Gone since then") : LegendText::tr("Gone in the second map"));
  add(Difference::OnlyFirst,
      earlier ? LegendText::tr("Known then only") : LegendText::tr("Known in the first map only"));
  add(Difference::OnlySecond,
      earlier ? LegendText::tr("Known now only") : LegendText::tr("Known in the second map only"));
  add(Difference::SameOccupied, LegendText::tr("Occupied in both"));
  add(Difference::SameFree, LegendText::tr("Free in both"));
  return {LegendText::tr("Difference"), legend.rows()};
}

/// What a comparison of two maps hides.
bool hiddenByDifference(Layer layer) {
  return layer == Layer::WholeMap || layer == Layer::Submaps || layer == Layer::Regions;
}

}  // namespace

std::vector<Eigen::Vector2d> LegendSample::box(double half_width_px, double half_height_px) {
  return {at(-half_width_px, -half_height_px), at(half_width_px, -half_height_px),
          at(half_width_px, half_height_px), at(-half_width_px, half_height_px)};
}

QImage Legend::painted(const QSize& size, const Paint& paint) const {
  QImage image((QSizeF(size) * source_.pixel_ratio).toSize(), QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(source_.pixel_ratio);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  const QRectF room(QPointF(0, 0), QSizeF(size));
  QPainterPath plate;
  plate.addRoundedRect(room, 3, 3);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillPath(plate, QColor(theme().map.free));
  painter.setClipPath(plate);
  painter.setOpacity(source_.opacity);
  paint(painter, room);
  // White stands out from a white dock.
  painter.setClipping(false);
  painter.setOpacity(1);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme().grid_major, 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawRoundedRect(room.adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
  return image;
}

Legend::Paint Legend::bySample(const Fill& fill) const {
  return [this, fill](QPainter& painter, const QRectF& room) {
    LegendSample sample;
    sample.context.theme = theme();
    sample.context.view.scale_m_per_px = LegendSample::kMPerPx;
    sample.context.view.width_px = int(room.width());
    sample.context.view.height_px = int(room.height());
    sample.context.live = &sample.live;
    sample.context.ink = context().ink;
    fill(sample);
    QStyleOptionGraphicsItem option;
    option.exposedRect = room;
    for (LayerItem* const made : specOf(layer_).items(sample.context)) {
      const std::unique_ptr<LayerItem> item(made);
      item->setStyle(style());
      item->paint(&painter, &option, nullptr);
    }
  };
}

void Legend::add(const QString& text, const Paint& paint) {
  rows_.push_back({text, painted(kSymbol, paint), {}, {}});
}

void Legend::addSample(const QString& text, const Fill& fill) { add(text, bySample(fill)); }

void Legend::addCell(const QString& text, const QColor& color) {
  add(text, [&](QPainter& painter, const QRectF& room) { painter.fillRect(room, color); });
}

void Legend::addSampleScale(const QString& low, const QString& high, const Fill& fill) {
  rows_.push_back({{}, painted(kScale, bySample(fill)), low, high});
}

void Legend::addScale(const QString& low, const QString& high, std::span<const QColor> colors,
                      const QString& text) {
  if (colors.empty()) return;
  const auto paint = [&](QPainter& painter, const QRectF& room) {
    QLinearGradient gradient(room.topLeft(), room.topRight());
    const double steps = std::max<double>(1, double(colors.size()) - 1);
    for (std::size_t i = 0; i < colors.size(); ++i) gradient.setColorAt(double(i) / steps, colors[i]);
    painter.fillRect(room, gradient);
  };
  rows_.push_back({text, painted(kScale, paint), low, high});
}

Legend::Paint Legend::byThing(ObjectForm form, std::int64_t look) const {
  return bySample([this, form, look](LegendSample& sample) {
    if (const auto fill = specOf(layer_).sample) fill(sample, form, look);
  });
}

void Legend::addThing(const QString& text, ObjectForm form, std::int64_t look) {
  add(text, byThing(form, look));
}

QImage Legend::lookOf(ObjectForm form, std::int64_t look, const QSize& size) const {
  // The cells of a whole map are the ground of all samples.
  if (layer_ != Layer::WholeMap) return painted(size, byThing(form, look));
  return painted(size, [this](QPainter& painter, const QRectF& room) {
    painter.fillRect(room.adjusted(room.width() / 2, 0, 0, 0), QColor(theme().map.occupied));
  });
}

QColor cellColor(std::uint32_t premultiplied) { return QColor::fromRgba(qUnpremultiply(premultiplied)); }

void addCells(Legend& legend, const render::MapColors& colors) {
  legend.addCell(LegendText::tr("Free"), QColor(colors.free));
  legend.addCell(LegendText::tr("Occupied"), QColor(colors.occupied));
  legend.addCell(LegendText::tr("Unknown"), QColor(colors.unknown));
}

QImage MapScene::symbolOf(const MapObject& object, int size_px, qreal pixel_ratio) const {
  constexpr int kSidePx = Legend::kSymbol.height();
  // Submaps are told apart by their outlines.
  const Layer layer = object.id.layer == Layer::Submaps ? Layer::Outlines : object.id.layer;
  const Legend::Source source{items_->context, layerStyle(layer), 1,
                              session_,        color_mode_,       pixel_ratio * size_px / kSidePx};
  QImage symbol = Legend(layer, source).lookOf(object.form, object.look, QSize(kSidePx, kSidePx));
  symbol.setDevicePixelRatio(pixel_ratio);
  return symbol;
}

std::vector<LegendSection> MapScene::legend(qreal pixel_ratio) const {
  std::vector<LegendSection> sections;
  const bool difference = compareMode() == CompareMode::Difference && items_->has_compared;
  Legend::Source source{items_->context, {}, 1, session_, color_mode_, pixel_ratio};
  if (difference) sections.push_back(differenceLegend(source));
  if (referenceDifferences() && compareMode() == CompareMode::Off && layerVisible(Layer::Reference))
    sections.push_back(referenceLegend(source));
  for (auto it = items_->order.rbegin(); it != items_->order.rend(); ++it) {
    const LayerSpec& spec = specOf(*it);
    if (!spec.legend || !layerVisible(*it) || (difference && hiddenByDifference(*it))) continue;
    if (session_ && !whyEmpty(*it, session_->robot()).isEmpty()) continue;
    source.style = layerStyle(*it);
    source.opacity = layerOpacity(*it);
    Legend legend(*it, source);
    spec.legend(legend);
    if (!legend.rows().empty()) sections.push_back({layerTitle(*it), legend.rows()});
  }
  return sections;
}

}  // namespace mapwright::ui::scene
