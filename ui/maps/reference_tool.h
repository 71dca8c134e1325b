// Lays the reference map by hand: a drag moves it, a drag with Shift turns it, two clicks make a pair of
// points.
#pragma once

#include <optional>
#include <vector>

#include "geometry/pose.h"
#include "map/grid_reference.h"
#include "placing/align.h"
#include "scene/map_scene.h"
#include "ui/view/map_tool.h"

namespace mapwright::window {

class ReferenceTool : public MapTool {
  Q_OBJECT
 public:
  /// `scene` must outlive this.
  explicit ReferenceTool(const scene::MapScene* scene, QObject* parent = nullptr);

  /// What is laid at present.
  void setState(const map::GridReference& grid, const geometry::Pose2& world_from_map,
                const std::vector<placing::PointPair>& pairs);
  /// Clicks make pairs; otherwise drags move.
  void setPairing(bool pairing);

  QString name() const override { return QStringLiteral("reference"); }
  QCursor cursor() const override { return pairing_ ? Qt::CrossCursor : Qt::SizeAllCursor; }
  void deactivate() override;
  bool pressed(const MapPoint& at) override;
  void dragged(const MapPoint& at) override;
  void released(const MapPoint& at) override;
  void dragCancelled() override;
  void clicked(const MapPoint& at) override;
  void hovered(const MapPoint& at) override;
  bool keyPressed(const MapKeyPress& press) override;
  void paint(QPainter& painter) override;
  QString hint() const override;

 Q_SIGNALS:
  /// A drag begins: what moves it until the next one is one step.
  void taken();
  /// While it is dragged; the last one counts.
  void moved(const mapwright::geometry::Pose2& world_from_map);
  void paired(const mapwright::placing::PointPair& pair);
  void refused(const QString& why);

 private:
  struct Hold {
    geometry::Pose2 before;
    Eigen::Vector2d from_m, pivot_m;
    bool turns;
  };

  /// Of the cells, as a hand can hit them.
  bool isOnMap(const Eigen::Vector2d& world_m) const;

  const scene::MapScene* scene_;
  map::GridReference grid_;  // of the map, in its own coordinates
  geometry::Pose2 pose_;
  std::vector<placing::PointPair> pairs_;
  bool pairing_ = false;
  std::optional<Hold> hold_;
  std::optional<Eigen::Vector2d> first_m_;  // of a pair: on the reference map, where it lies now
  std::optional<Eigen::Vector2d> cursor_m_;
};

}  // namespace mapwright::window
