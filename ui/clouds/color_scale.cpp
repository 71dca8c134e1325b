#include "ui/clouds/color_scale.h"

#include <algorithm>
#include <cmath>

#include <QLinearGradient>
#include <QPainter>

#include "ui/kit/plain_label.h"
#include "ui/kit/ui_colors.h"

namespace mapwright::ui {
namespace {

constexpr int kBarPx = 12, kGapPx = 3, kMostStops = 32;

/// Enough decimals to distinguish the ends.
QString valueText(double value, double span) {
  const int decimals = span > 0 ? std::clamp(2 - int(std::floor(std::log10(span))), 0, 3) : 2;
  return QLocale::c().toString(value, 'f', decimals);
}

}  // namespace

ColorScale::ColorScale(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setObjectName(QStringLiteral("cloudColorScale"));
  hide();
}

void ColorScale::setScale(const std::optional<scene::CloudScale>& scale) {
  if (scale == scale_) return;
  scale_ = scale;
  setVisible(scale_.has_value());
  if (scale_) {
    const QStringList at = values();
    const QString words = scale_->of == scene::CloudScale::Of::Height
                              ? tr("Colours by height, from %1 to %2").arg(at.first(), at.last())
                              : tr("Colours by intensity, from %1 to %2").arg(at.first(), at.last());
    setAccessibleName(words);
    setToolTip(plainToolTip(words));
  }
  update();
}

QStringList ColorScale::values() const {
  if (!scale_) return {};
  const double span = scale_->high - scale_->low;
  QStringList all;
  for (const double at : {scale_->low, scale_->low + span / 2, scale_->high}) {
    const QString text = valueText(at, span);
    all << (scale_->of == scene::CloudScale::Of::Height ? tr("%1 m").arg(text) : text);
  }
  return all;
}

QSize ColorScale::sizeHint() const { return {200, kBarPx + kGapPx + fontMetrics().height()}; }

void ColorScale::paintEvent(QPaintEvent*) {
  if (!scale_ || scale_->colors.empty()) return;
  QPainter painter(this);
  const UiColors colors = appColors();
  const QRectF bar(0.5, 0.5, width() - 1, kBarPx - 1);
  QLinearGradient gradient(bar.topLeft(), bar.topRight());
  const std::size_t last = scale_->colors.size() - 1;
  for (int stop = 0; stop <= kMostStops; ++stop) {
    const double part = double(stop) / kMostStops;
    gradient.setColorAt(part, QColor::fromRgb(scale_->colors[std::size_t(std::lround(part * double(last)))]));
  }
  painter.setPen(colors.border);
  painter.setBrush(gradient);
  painter.drawRect(bar);
  painter.setPen(colors.secondary_text);
  const QRectF text(0, kBarPx + kGapPx, width(), fontMetrics().height());
  const QStringList all = values();
  painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter, all[0]);
  painter.drawText(text, Qt::AlignRight | Qt::AlignVCenter, all[2]);
  // The middle is dropped if there is no room for three.
  const int needed = fontMetrics().horizontalAdvance(all.join(QStringLiteral("    ")));
  if (needed < width()) painter.drawText(text, Qt::AlignHCenter | Qt::AlignVCenter, all[1]);
}

}  // namespace mapwright::ui

#include "moc_color_scale.cpp"
