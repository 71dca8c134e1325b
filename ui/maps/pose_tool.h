// Places the robot on the map: a click says where it is, a drag also where it looks.
#pragma once

#include <optional>

#include "geometry/pose.h"
#include "scene/map_scene.h"
#include "ui/view/map_tool.h"

namespace mapwright::window {

class PoseTool : public MapTool {
  Q_OBJECT
 public:
  /// `scene` must outlive this.
  explicit PoseTool(const scene::MapScene* scene, QObject* parent = nullptr);

  /// What is drawn; nullopt: nothing.
  void setPose(const std::optional<geometry::Pose2>& pose);

  QString name() const override { return QStringLiteral("setPose"); }
  QCursor cursor() const override { return Qt::CrossCursor; }
  bool pressed(const MapPoint& at) override;
  void dragged(const MapPoint& at) override;
  void released(const MapPoint& at) override;
  void dragCancelled() override;
  void clicked(const MapPoint& at) override;
  bool keyPressed(const MapKeyPress& press) override;
  void paint(QPainter& painter) override;
  QString hint() const override;

 Q_SIGNALS:
  void placed(const mapwright::geometry::Pose2& pose);
  /// A drag was cancelled: as before.
  void takenBack(const std::optional<mapwright::geometry::Pose2>& pose);

 private:
  const scene::MapScene* scene_;
  std::optional<geometry::Pose2> pose_;
  std::optional<geometry::Pose2> before_;
  std::optional<Eigen::Vector2d> from_m_;  // of a drag
};

}  // namespace mapwright::window
