// The rectangles of the projections on the map: draw, select, move, resize.
#pragma once

#include <optional>

#include "scene/map_scene.h"
#include "ui/clouds/projection_draft.h"
#include "ui/view/map_tool.h"

namespace mapwright::window {

/// Drag on an empty part of the map: a new one. Click one: select it. Drag its edge, corner or inside: change
/// it. Delete removes the selected one. Esc leaves.
class ProjectionTool : public MapTool {
  Q_OBJECT
 public:
  /// Both must outlive this. Call refresh() after changing the draft.
  ProjectionTool(const scene::MapScene* scene, const ProjectionDraft* draft, QObject* parent = nullptr);

  QString name() const override { return QStringLiteral("projections"); }
  QCursor cursor() const override;
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

  /// Not editable: read-only for now, or because the robot cannot set them.
  void setEditable(bool editable, bool takes);
  void refresh();

 Q_SIGNALS:
  void chosen(std::optional<int> index);
  void drawn(const mapwright::geometry::WorldRect& rect);
  void changedTo(int index, const mapwright::map::Projection& projection);
  void removeWanted();

 private:
  struct Hold {
    int index = -1;  // -1: a new one is drawn
    RectGrip grip = RectGrip::None;
    map::Projection before;
    Eigen::Vector2d from_m{0, 0}, to_m{0, 0};
  };
  RectGrip gripOnChosen(const MapPoint& at) const;
  std::optional<int> indexAt(const MapPoint& at) const;
  void letGo();

  const scene::MapScene* scene_;
  const ProjectionDraft* draft_;
  bool editable_ = false, takes_ = false;
  std::optional<Hold> hold_;
  RectGrip under_ = RectGrip::None;
};

}  // namespace mapwright::window
