// What of a map by regions has not been fetched, marked as such. Private to this room.
#pragma once

#include <QPointer>

#include "regions/region_map.h"
#include "scene/layer_item.h"

namespace mapwright::scene {

/// Hatched wherever no answer is known, with outlines of their own for what is being fetched and what failed.
/// Cells lie over it. Without a map by regions it draws nothing.
class RegionGround : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void setMap(const regions::RegionMap* map) { map_ = map; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  QPolygonF onScreen(const geometry::WorldRect& rect) const;
  void paintHatch(QPainter& painter) const;
  void paintOutlines(QPainter& painter) const;

  QPointer<const regions::RegionMap> map_;
};

}  // namespace mapwright::scene
