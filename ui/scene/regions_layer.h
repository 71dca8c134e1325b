// What of a map by regions has not been fetched, marked as such. Private to this room.
#pragma once

#include <optional>

#include <QPointer>

#include "map/grid_reference.h"
#include "regions/region_map.h"
#include "scene/layer_item.h"

namespace mapwright::scene {

/// Hatched wherever no answer is known, with a line around all that the robot says there is, and outlines of
/// their own for what is being fetched and what failed. Cells lie over it. Without a map by regions it draws
/// nothing.
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
