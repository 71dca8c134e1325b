// Places the robot on the map: a click says where it is, a drag also where it looks.
#pragma once

#include <optional>

#include "geometry/pose.h"
#include "ui/view/drag_tool.h"

namespace mapwright::ui {

class PoseTool : public DragTool {
  Q_OBJECT
 public:
  using DragTool::DragTool;

  /// What is drawn; nullopt: nothing.
  void setPose(const std::optional<geometry::Pose2>& pose);

  QString name() const override { return QStringLiteral("setPose"); }
  void paint(QPainter& painter) override;
  QString hint() const override;

 Q_SIGNALS:
  void placed(const mapwright::geometry::Pose2& pose);
  /// A drag was cancelled: as before.
  void takenBack(const std::optional<mapwright::geometry::Pose2>& pose);

 private:
  bool grab(const MapPoint& at) override;
  void update(const MapPoint& at) override;
  void cancel() override;
  void click(const MapPoint& at) override;

  std::optional<geometry::Pose2> pose_;
  std::optional<geometry::Pose2> before_;  // the drag
};

}  // namespace mapwright::ui
