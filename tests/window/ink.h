// What is really painted: for tests that do not trust properties.
#pragma once

#include <algorithm>
#include <cstdlib>

#include <QHash>
#include <QImage>
#include <QWidget>

namespace mapwright::test {

/// What of a widget stands out from the commonest colour of it.
class Ink {
 public:
  explicit Ink(QWidget* widget) : Ink(widget, widget->rect()) {}
  Ink(QWidget* widget, const QRect& area)
      : image_(widget->grab(area).toImage().convertToFormat(QImage::Format_RGB32)) {
    QHash<QRgb, int> counts;
    int most = 0;
    for (int y = 0; y < image_.height(); ++y) {
      for (int x = 0; x < image_.width(); ++x) {
        const int count = ++counts[image_.pixel(x, y)];
        if (count <= most) continue;
        most = count;
        ground_ = image_.pixel(x, y);
      }
    }
  }

  /// The share of all pixels.
  double share() const {
    int inked = 0;
    for (int y = 0; y < image_.height(); ++y) {
      for (int x = 0; x < image_.width(); ++x) inked += at(x, y);
    }
    return image_.isNull() ? 0 : double(inked) / (image_.width() * image_.height());
  }

  /// The rightmost column: how far a line of text reaches.
  int reach() const {
    for (int x = image_.width() - 1; x > 0; --x) {
      for (int y = 0; y < image_.height(); ++y) {
        if (at(x, y)) return x;
      }
    }
    return 0;
  }

 private:
  bool at(int x, int y) const {
    const QRgb pixel = image_.pixel(x, y);
    return std::abs(qRed(pixel) - qRed(ground_)) + std::abs(qGreen(pixel) - qGreen(ground_)) +
               std::abs(qBlue(pixel) - qBlue(ground_)) >
           120;
  }

  QImage image_;
  QRgb ground_ = 0;
};

inline double ink(QWidget* widget, const QRect& area) { return Ink(widget, area).share(); }
inline double ink(QWidget* widget) { return Ink(widget).share(); }

}  // namespace mapwright::test
