#include "ui/clouds/region_tool.h"

#include "ui/scene/lengths.h"

namespace mapwright::ui {

using scene::lengthText;

void RegionTool::setShape(RegionShape shape) {
  shape_ = shape;
  dragCancelled();
}

void RegionTool::draw(const Span& span) {
  if (circle()) {
    Q_EMIT sphereDrawn(span.from_m, span.length());
  } else {
    Q_EMIT boxDrawn(span.rect());
  }
}

QString RegionTool::hint() const {
  const auto drawn = span();
  if (!drawn) {
    return circle() ? tr("Drag from the centre of a sphere to its edge to fetch its cloud. Esc leaves.")
                    : tr("Drag a box to fetch its cloud. Esc leaves.");
  }
  const geometry::WorldRect box = drawn->rect();
  return circle() ? tr("Radius %1").arg(lengthText(drawn->length()))
                  : tr("%1 x %2").arg(lengthText(box.width()), lengthText(box.height()));
}

}  // namespace mapwright::ui

#include "moc_region_tool.cpp"
