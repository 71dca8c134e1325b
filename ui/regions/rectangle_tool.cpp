#include "ui/regions/rectangle_tool.h"

#include <utility>

namespace mapwright::ui {

RectangleTool::RectangleTool(const scene::MapScene* scene,
                             std::function<QString(const geometry::WorldRect&)> describe, QObject* parent)
    : DragShapeTool(scene, parent), describe_(std::move(describe)) {}

QString RectangleTool::hint() const {
  const auto drawn = span();
  return drawn ? describe_(drawn->rect()) : tr("Drag a rectangle over the region to fetch. Esc: back");
}

}  // namespace mapwright::ui

#include "moc_rectangle_tool.cpp"
