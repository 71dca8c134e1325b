// Written labels with their halo, as pictures that are made once: laying out a text and filling its outlines
// takes a hundred times as long as drawing the picture of it.
#pragma once

#include <QCache>
#include <QColor>
#include <QHash>
#include <QImage>
#include <QPainter>
#include <QSizeF>
#include <QString>

#include "ui/scene/map_theme.h"

namespace mapwright::ui::scene {

/// Bounded: what has not been drawn for long is made again.
class LabelInk {
 public:
  /// Without the halo.
  QSizeF sizeOf(const QString& text, const MapTheme& theme);
  /// On whole pixels of the device, as near to `top_left` as they allow.
  void draw(QPainter& painter, const QPointF& top_left, const QString& text, const MapTheme& theme,
            const QColor& color, bool struck_through = false);

 private:
  struct Key {
    QString text;
    QRgb color, halo;
    int font_px;
    bool struck_through;
    qreal ratio;
    bool operator==(const Key&) const = default;
  };
  friend std::size_t qHash(const Key& key, std::size_t seed) {
    return qHashMulti(seed, key.text, key.color, key.halo, key.font_px, key.struck_through, key.ratio);
  }

  QCache<Key, QImage> images_{16'000'000};  // bytes
  QHash<QString, QSizeF> sizes_;
  int sizes_of_px_ = 0;  // the size of their font
};

}  // namespace mapwright::ui::scene
