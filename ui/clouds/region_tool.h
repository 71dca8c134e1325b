// Selects a box or a sphere on the map to fetch its cloud.
#pragma once

#include <optional>

#include "geometry/rect.h"
#include "scene/map_scene.h"
#include "ui/view/map_tool.h"

namespace mapwright::window {

enum class RegionShape { Box, Sphere };

/// Box: drag from corner to corner (its sides are parallel to the axes of the map, however the view is
/// rotated). Sphere: drag from the centre to its edge. Esc leaves.
class RegionTool : public MapTool {
  Q_OBJECT
 public:
  explicit RegionTool(const scene::MapScene* scene, QObject* parent = nullptr);

  QString name() const override { return QStringLiteral("cloudRegion"); }
  void deactivate() override;
  bool pressed(const MapPoint& at) override;
  void dragged(const MapPoint& at) override;
  void released(const MapPoint& at) override;
  void dragCancelled() override;
  bool keyPressed(const MapKeyPress& press) override;
  void paint(QPainter& painter) override;
  QString hint() const override;

  void setShape(RegionShape shape);
  RegionShape shape() const { return shape_; }

 Q_SIGNALS:
  void boxDrawn(const mapwright::geometry::WorldRect& box);
  void sphereDrawn(const Eigen::Vector2d& centre_m, double radius_m);

 private:
  void forget();
  const scene::MapScene* scene_;
  RegionShape shape_ = RegionShape::Box;
  std::optional<Eigen::Vector2d> from_, to_;
};

}  // namespace mapwright::window
