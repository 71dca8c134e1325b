// Mirrors the selected waypoints about a line that is drawn: two clicks or a drag, with a preview of the
// result.
#pragma once

#include "ui/waypoints/two_point_tool.h"
#include "ui/waypoints/waypoint_editing.h"

namespace mapwright::ui {

class MirrorTool : public TwoPointTool {
  Q_OBJECT
 public:
  /// All must outlive this.
  MirrorTool(WaypointEditing* editing, const scene::MapScene* scene, WaypointSnapping* snapping,
             QObject* parent = nullptr);

  QString name() const override { return QStringLiteral("mirrorWaypoints"); }
  void activate() override;
  void forget() override;
  void paint(QPainter& painter) override;
  QString hint() const override;

 Q_SIGNALS:
  void activated();
  void ended();  // mirrored, or given up

 private:
  void lineMoved() override;
  void lineDrawn() override;
  void leave() override { Q_EMIT ended(); }

  WaypointEditing* editing_;
};

}  // namespace mapwright::ui
