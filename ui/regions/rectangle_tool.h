// Draws an axis-aligned rectangle on the map.
#pragma once

#include <functional>

#include "ui/view/drag_tool.h"

namespace mapwright::ui {

/// A drag draws it; it is reported once when the button is released.
class RectangleTool : public DragShapeTool {
  Q_OBJECT
 public:
  /// `describe`: one line about a rectangle.
  RectangleTool(const scene::MapScene* scene, std::function<QString(const geometry::WorldRect&)> describe,
                QObject* parent = nullptr);

  QString name() const override { return QStringLiteral("region"); }
  QString hint() const override;

 Q_SIGNALS:
  void drawn(const mapwright::geometry::WorldRect& rect);

 private:
  void draw(const Span& span) override { Q_EMIT drawn(span.rect()); }

  std::function<QString(const geometry::WorldRect&)> describe_;
};

}  // namespace mapwright::ui
