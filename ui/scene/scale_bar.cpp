#include <cmath>

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QLocale>

#include "ui/scene/layer_item.h"
#include "ui/scene/lengths.h"

namespace mapwright::ui::scene {
namespace {

/// The scale bar, bottom left.
class ScaleBarLayer : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) override {
    const double length_m = lengthM();
    const QRectF frame = this->frame();
    const double width = frame.width() - 2 * kPad, y = frame.bottom() - kPad;
    if (!option->exposedRect.intersects(frame.adjusted(-2, -2, 2, 2))) return;
    const QString text = lengthText(length_m);
    const QFontMetricsF metrics(context_.theme.label_font);
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(Qt::NoPen);
    painter->setBrush(translucent(context_.theme.text_halo, 190));
    painter->drawRoundedRect(frame, 4, 4);
    painter->setRenderHint(QPainter::Antialiasing, false);
    painter->setPen(QPen(context_.theme.text, 2));
    painter->drawPolyline(QPolygonF{{kLeft, y - 6}, {kLeft, y}, {kLeft + width, y}, {kLeft + width, y - 6}});
    context_.ink->draw(*painter,
                       {kLeft + (width - metrics.horizontalAdvance(text)) / 2, y - 8 - metrics.ascent()},
                       text, context_.theme, context_.theme.text);
  }
  LabelUse labelUse() const override { return LabelUse::Symbols; }
  void collectLabels(LabelCollector& labels) const override { labels.symbol(frame()); }

 private:
  static constexpr double kWidestPx = 140, kLeft = 16, kBottom = 16, kPad = 8;
  double lengthM() const { return roundDown125(kWidestPx * context_.view.scale_m_per_px); }
  QRectF frame() const {
    const double width = std::round(lengthM() / context_.view.scale_m_per_px);
    return {kLeft - kPad, context_.view.height_px - kBottom - 24, width + 2 * kPad, 32};
  }
};

}  // namespace

QString lengthText(double metres) {
  if (!std::isfinite(metres)) return QStringLiteral("?");
  const QLocale plain = QLocale::c();
  const auto trimmed = [&](double value, int decimals) {
    QString text = plain.toString(value, 'f', decimals);
    if (text.contains(QLatin1Char('.'))) {
      while (text.endsWith(QLatin1Char('0'))) text.chop(1);
      if (text.endsWith(QLatin1Char('.'))) text.chop(1);
    }
    return text;
  };
  if (metres < 0.0995)
    return trimmed(metres * 1000, metres < 0.00995 ? 1 : 0) + QCoreApplication::translate("scene", " mm");
  if (metres < 1) return trimmed(metres * 100, 1) + QCoreApplication::translate("scene", " cm");
  if (metres < 1000) return trimmed(metres, metres < 100 ? 2 : 1) + QStringLiteral(" m");
  return trimmed(metres / 1000, metres < 10'000 ? 2 : 1) + QCoreApplication::translate("scene", " km");
}

QString areaText(double m2) {
  if (!std::isfinite(m2)) return QStringLiteral("?");
  const QLocale plain = QLocale::c();
  if (m2 < 1e6) return plain.toString(m2, 'f', m2 < 100 ? 2 : m2 < 10'000 ? 1 : 0) + QStringLiteral(" m²");
  return plain.toString(m2 / 1e6, 'f', 3) + QCoreApplication::translate("scene", " km²");
}

template <>
LayerSpec layerSpec<Layer::ScaleBar>() {
  return {.name = "scalebar",
          .title = QT_TRANSLATE_NOOP("scene", "Scale bar"),
          .group = LayerGroup::Annotations,
          .sets = LayerSet::Navigation | LayerSet::Mapping | LayerSet::MapOnly | LayerSet::Report |
                  LayerSet::Snapshot,
          .follows_robot = false,
          .order_fixed = true,
          .why_empty = neverEmpty,
          .items = oneItem<ScaleBarLayer>};
}

}  // namespace mapwright::ui::scene
