// What is really painted: for tests that do not trust properties.
#pragma once

#include <algorithm>

#include <QImage>
#include <QWidget>

namespace mapwright::test {

/// The share of pixels in `area` of `widget` (logical pixels) that stand out from the commonest colour of it.
inline double ink(QWidget* widget, const QRect& area) {
  const QImage image = widget->grab(area).toImage().convertToFormat(QImage::Format_RGB32);
  if (image.isNull()) return 0;
  QHash<QRgb, int> counts;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) ++counts[image.pixel(x, y)];
  }
  QRgb ground = 0;
  int most = 0;
  for (auto it = counts.cbegin(); it != counts.cend(); ++it) {
    if (it.value() > most) {
      most = it.value();
      ground = it.key();
    }
  }
  const auto apart = [&](QRgb pixel) {
    return std::abs(qRed(pixel) - qRed(ground)) + std::abs(qGreen(pixel) - qGreen(ground)) +
               std::abs(qBlue(pixel) - qBlue(ground)) >
           120;
  };
  int inked = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) inked += apart(image.pixel(x, y));
  }
  return double(inked) / (image.width() * image.height());
}
inline double ink(QWidget* widget) { return ink(widget, widget->rect()); }

/// The rightmost column of ink, as a share of the width: how far a line of text reaches.
inline int inkReach(QWidget* widget) {
  const QRect all = widget->rect();
  for (int x = all.right(); x > 0; --x) {
    if (ink(widget, QRect(x, all.top(), 1, all.height())) > 0) return x;
  }
  return 0;
}

}  // namespace mapwright::test
