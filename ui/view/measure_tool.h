// Measures along clicked points: lengths, headings, angles, areas.
#pragma once

#include <optional>
#include <vector>

#include "ui/scene/map_scene.h"
#include "ui/view/map_tool.h"

namespace mapwright::ui {

/// Click adds a point, the leg to the cursor is updated live, a click on the first point closes a ring,
/// Backspace removes the last point, Enter, double click or Esc ends it and keeps the result; the next click
/// starts a new one, a second Esc leaves the tool.
class MeasureTool : public MapTool {
  Q_OBJECT
 public:
  explicit MeasureTool(scene::MapScene* scene, QObject* parent = nullptr);

  QString name() const override { return QStringLiteral("measure"); }
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
  bool closed() const { return closed_; }
  double total() const;

 private:
  void show();
  void end();
  bool onFirst(const Eigen::Vector2d& world_m) const;

  scene::MapScene* scene_;
  std::vector<Eigen::Vector2d> points_;
  std::optional<Eigen::Vector2d> live_;
  bool ended_ = false, closed_ = false;
};

}  // namespace mapwright::ui
