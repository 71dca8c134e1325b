// Marks the parts of a map by regions that have not been fetched. Private to this room.
#pragma once

#include <optional>

#include <QPointer>

#include "map/grid_reference.h"
#include "regions/region_map.h"
#include "scene/layer_item.h"

namespace mapwright::scene {

/// Hatched wherever nothing is known, with a line around the reported extent, and outlines for regions being
/// fetched and failed ones. Cells are drawn over it. Draws nothing without a map by regions.
class RegionGround : public LayerItem {
 public:
  using LayerItem::LayerItem;
  void setMap(const regions::RegionMap* map) { map_ = map; }
  void setExtent(const std::optional<map::GridReference>& extent) { extent_ = extent; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  QPolygonF onScreen(const geometry::WorldRect& rect) const;
  void paintHatch(QPainter& painter) const;
  void paintOutlines(QPainter& painter) const;
  void paintExtent(QPainter& painter) const;

  QPointer<const regions::RegionMap> map_;
  std::optional<map::GridReference> extent_;
};

}  // namespace mapwright::scene
