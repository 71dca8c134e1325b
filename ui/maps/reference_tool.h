// Lays the reference map by hand: a drag moves it, a drag with Shift turns it, two clicks make a pair of
// points.
#pragma once

#include <optional>
#include <vector>

#include "geometry/pose.h"
#include "map/grid_reference.h"
#include "placing/align.h"
#include "ui/view/drag_tool.h"

namespace mapwright::ui {

class ReferenceTool : public DragTool {
  Q_OBJECT
 public:
  using DragTool::DragTool;

  /// What is laid at present.
  void setState(const map::GridReference& grid, const geometry::Pose2& world_from_map,
                const std::vector<placing::PointPair>& pairs);
  /// Clicks make pairs; otherwise drags move.
  void setPairing(bool pairing);

  QString name() const override { return QStringLiteral("reference"); }
  QCursor cursor() const override { return pairing_ ? Qt::CrossCursor : Qt::SizeAllCursor; }
  void deactivate() override;
  bool claims(const MapKeyPress& press) const override;
  bool keyPressed(const MapKeyPress& press) override;
  void hovered(const MapPoint& at) override;
  void paint(QPainter& painter) override;
  QString hint() const override;

 Q_SIGNALS:
  /// A drag or a run of keys begins: what moves it until the next one is one step.
  void taken();
  /// While it is dragged; the last one counts.
  void moved(const mapwright::geometry::Pose2& world_from_map);
  void paired(const mapwright::placing::PointPair& pair);
  void refused(const QString& why);

 private:
  bool grab(const MapPoint& at) override;
  void update(const MapPoint& at) override;
  void cancel() override;
  void click(const MapPoint& at) override;
  bool stepBack() override;
  /// By an arrow or a bracket; nullopt: another key.
  std::optional<geometry::Pose2> nudged(const MapKeyPress& press) const;
  /// Of the cells, as a hand can hit them.
  bool isOnMap(const Eigen::Vector2d& world_m) const;

  map::GridReference grid_;  // of the map, in its own coordinates
  geometry::Pose2 pose_;
  std::vector<placing::PointPair> pairs_;
  bool pairing_ = false;
  bool nudging_ = false;                    // the last step was one of keys
  geometry::Pose2 before_;                  // the drag
  Eigen::Vector2d pivot_m_{0, 0};           // where the middle of the view was then
  std::optional<Eigen::Vector2d> first_m_;  // of a pair: on the reference map, where it lies now
  std::optional<Eigen::Vector2d> cursor_m_;
};

}  // namespace mapwright::ui
