// Selects a box or a sphere on the map to fetch its cloud.
#pragma once

#include "ui/view/drag_tool.h"

namespace mapwright::ui {

enum class RegionShape { Box, Sphere };

/// Box: drag from corner to corner (its sides are parallel to the axes of the map, however the view is
/// rotated). Sphere: drag from the centre to its edge.
class RegionTool : public DragShapeTool {
  Q_OBJECT
 public:
  using DragShapeTool::DragShapeTool;

  QString name() const override { return QStringLiteral("cloudRegion"); }
  QString hint() const override;

  void setShape(RegionShape shape);
  RegionShape shape() const { return shape_; }

 Q_SIGNALS:
  void boxDrawn(const mapwright::geometry::WorldRect& box);
  void sphereDrawn(const Eigen::Vector2d& centre_m, double radius_m);

 private:
  bool circle() const override { return shape_ == RegionShape::Sphere; }
  void draw(const Span& span) override;

  RegionShape shape_ = RegionShape::Box;
};

}  // namespace mapwright::ui
