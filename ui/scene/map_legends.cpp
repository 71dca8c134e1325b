// What maps, submaps and clouds look like in the legend.
#include <QCoreApplication>
#include <QFontMetricsF>

#include "clouds/draw_cloud.h"
#include "render/compositor.h"
#include "scene/clouds_layer.h"
#include "scene/legend.h"

namespace mapwright::scene {
namespace {

class MapLegendText {
  Q_DECLARE_TR_FUNCTIONS(MapLegend)
};

}  // namespace

void submapsLegend(Legend& legend) {
  const render::ColorTable table(legend.theme().map, legend.colors());
  const auto cell = [&](int flags, int intensity) {
    return QColor(table.at(std::uint8_t(render::kObserved | flags), std::uint8_t(intensity)));
  };
  addCells(legend, legend.theme().map);
  if (legend.colors() == render::ColorMode::Incremental) {
    legend.addCell(MapLegendText::tr("Free, of incremental submaps"), cell(render::kIncremental, 255));
    legend.addCell(MapLegendText::tr("Occupied, of incremental submaps"), cell(render::kIncremental, 0));
  }
  if (legend.colors() == render::ColorMode::Active) {
    legend.addCell(MapLegendText::tr("Free, of frozen submaps"), cell(0, 255));
    legend.addCell(MapLegendText::tr("Occupied, of frozen submaps"), cell(0, 0));
  }
}

void outlinesLegend(Legend& legend) {
  legend.addThing(MapLegendText::tr("Submap"), ObjectForm::Area, 0);
  legend.addThing(MapLegendText::tr("Frozen submap"), ObjectForm::Area, 1);
}

void idsLegend(Legend& legend) {
  // Labels are drawn above all layers: the sample is one of them.
  const auto add = [&](const QString& text, bool visible) {
    legend.add(text, [&, visible](QPainter& painter, const QRectF& room) {
      const QString id = QString::fromStdString(map::toText(map::SubmapId{0, 12}));
      const QFontMetricsF metrics(legend.theme().label_font);
      const QPointF corner = room.center() - QPointF(metrics.horizontalAdvance(id), metrics.height()) / 2;
      drawLabel(painter, corner + QPointF(0, metrics.ascent()), id, legend.theme(),
                translucent(legend.theme().text, visible ? 255 : 170), !visible);
    });
  };
  add(MapLegendText::tr("Trajectory and number of a submap"), true);
  add(MapLegendText::tr("Submap that you have hidden"), false);
}

void gridLegend(Legend& legend) {
  const auto add = [&](const QString& text, const QColor& color) {
    legend.add(text, [&](QPainter& painter, const QRectF& room) {
      painter.fillRect(QRectF(0, room.center().y(), room.width(), 1), color);
      painter.fillRect(QRectF(room.center().x(), 0, 1, room.height()), color);
    });
  };
  add(MapLegendText::tr("Grid line"), legend.theme().grid_minor);
  add(MapLegendText::tr("Line of the coarse grid"), legend.theme().grid_major);
  add(MapLegendText::tr("Axes: x = 0 and y = 0"), legend.theme().axis);
}

void cloudsLegend(Legend& legend) {
  const auto ramp = [&](const QString& low, const QString& high) {
    std::vector<QColor> colors;
    for (const std::uint32_t shade : clouds::shades()) colors.emplace_back(QRgb(shade | 0xff000000));
    legend.addScale(low, high, colors);
  };
  switch (DispatchedCloudChoice(legend.style().choice)) {
    case DispatchedCloudChoice::Height:
      return ramp(MapLegendText::tr("low"), MapLegendText::tr("high"));
    case DispatchedCloudChoice::Intensity:
      return ramp(MapLegendText::tr("weak"), MapLegendText::tr("strong echo"));
    case DispatchedCloudChoice::Rgb:
      return;  // their own colours need no words
    case DispatchedCloudChoice::OneColor:
      break;
  }
  const QColor own = legend.style().color;
  const QColor color = own.isValid() ? own : legend.theme().cloud;
  legend.add(MapLegendText::tr("Point of the map"), [&](QPainter& painter, const QRectF& room) {
    for (double x = 5; x < room.width(); x += 9) {
      for (double y = 3; y < room.height(); y += 7) painter.fillRect(QRectF(x, y, 2, 2), color);
    }
  });
}

}  // namespace mapwright::scene
