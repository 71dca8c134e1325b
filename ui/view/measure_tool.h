// Measures along clicked points.
#pragma once

#include <optional>
#include <vector>

#include "scene/map_scene.h"
#include "ui/view/map_tool.h"

namespace mapwright::window {

/// Length of a polyline, metres.
double polylineLength(const std::vector<Eigen::Vector2d>& points);
/// "12.345 m", "1.204 km": three decimals below 100 m, then fewer.
QString lengthText(double metres);

/// Click adds a point, the leg to the cursor is updated live, Backspace removes the last point, Enter, double
/// click or Esc ends it and keeps the result; the next click starts a new one, a second Esc leaves the tool.
class MeasureTool : public MapTool {
  Q_OBJECT
 public:
  explicit MeasureTool(scene::MapScene* scene, QObject* parent = nullptr);

  QString name() const override { return QStringLiteral("measure"); }
  QCursor cursor() const override { return Qt::CrossCursor; }
  void activate() override;
  void deactivate() override;
  void clicked(const MapPoint& at) override;
  void hovered(const MapPoint& at) override;
  void left() override;
  bool doubleClicked(const MapPoint& at) override;
  bool keyPressed(const MapKeyPress& press) override;
  QString hint() const override;

  const std::vector<Eigen::Vector2d>& points() const { return points_; }
  bool ended() const { return ended_; }
  double total() const { return polylineLength(points_); }

 private:
  void show();
  void end();

  scene::MapScene* scene_;
  std::vector<Eigen::Vector2d> points_;
  std::optional<Eigen::Vector2d> live_;
  bool ended_ = false;
};

}  // namespace mapwright::window
