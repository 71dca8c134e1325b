// The rectangles of the projections on the map: drawn, chosen, moved, made larger.
#pragma once

#include <optional>

#include "scene/map_scene.h"
#include "window/map/map_tool.h"
#include "window/projections/projection_draft.h"

namespace mapwright::window {

/// Drag on bare map: a new one. Click in one: it is chosen. Drag its edge, corner or inside: it changes.
/// Delete takes the chosen one out. Esc leaves.
class ProjectionTool : public MapTool {
  Q_OBJECT
 public:
  /// Both must outlive this. Who changes the draft tells it by refresh().
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

  /// Not editable: they are only looked at, for now, or because the robot does not take any.
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
