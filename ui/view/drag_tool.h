// Tools that are used by dragging. A press is held until it is let go; beyond the threshold of the view it is
// a drag, otherwise a click. Esc, losing the focus and another tool take it back.
#pragma once

#include <optional>

#include "geometry/rect.h"
#include "ui/scene/drawing.h"
#include "ui/scene/map_scene.h"
#include "ui/view/map_tool.h"

namespace mapwright::ui {

class DragTool : public MapTool {
  Q_OBJECT
 public:
  /// `scene` must outlive this.
  explicit DragTool(const scene::MapScene* scene, QObject* parent = nullptr);

  void deactivate() override { dragCancelled(); }
  bool pressed(const MapPoint& at) final;
  void dragged(const MapPoint& at) final;
  void released(const MapPoint& at) final;
  void dragCancelled() final;
  void clicked(const MapPoint& at) final;
  /// Esc takes back what is held, then one step after the other, and leaves the tool in the end.
  bool keyPressed(const MapKeyPress& press) override;

 protected:
  struct Hold {
    MapPoint from, to;
    bool moved = false;  // it is a drag
  };
  const scene::MapScene& scene() const { return *scene_; }
  const scene::MapTheme& theme() const { return scene_->theme(); }
  QPointF px(const Eigen::Vector2d& world_m) const;
  /// Of `kReachPx`.
  double reach() const { return kReachPx * scene_->view().scale_m_per_px; }
  /// The press that this tool took, until it is let go.
  const std::optional<Hold>& hold() const { return hold_; }
  bool dragging() const { return hold_ && hold_->moved; }
  /// While it is dragged: the rectangle on the screen from where it began.
  QRectF frame() const;

  /// A press. False: a drag pans the map.
  virtual bool grab(const MapPoint& /*at*/) { return true; }
  /// Each move of the drag, and the last position once more before finish().
  virtual void update(const MapPoint& /*at*/) {}
  virtual void finish(const MapPoint& /*at*/) {}
  /// The press or the drag comes to nothing.
  virtual void cancel() {}
  /// Pressed and let go at one position, whether or not grab() took it.
  virtual void click(const MapPoint& /*at*/) {}
  /// Esc, with nothing held. False: there is nothing left to take back.
  virtual bool stepBack() { return false; }
  virtual void leave() { Q_EMIT finished(); }

 private:
  const scene::MapScene* scene_;
  std::optional<Hold> hold_;
};

/// Draws one thing from where the button goes down to where it is let go.
class DragShapeTool : public DragTool {
  Q_OBJECT
 public:
  using DragTool::DragTool;
  void paint(QPainter& painter) override;

 protected:
  struct Span {
    Eigen::Vector2d from_m{0, 0}, to_m{0, 0};
    geometry::WorldRect rect() const;
    double length() const { return (to_m - from_m).norm(); }
  };
  /// While it is dragged.
  std::optional<Span> span() const;
  /// It is a circle around where it began, not a rectangle along the axes of the map.
  virtual bool circle() const { return false; }
  /// It is let go, and neither flat nor empty.
  virtual void draw(const Span& span) = 0;

  void finish(const MapPoint& at) override;
};

/// Draws lines that stand out on any map: `draw` is called twice, first for the halo.
void strokeWithHalo(QPainter& painter, const scene::MapTheme& theme, double width_px, const auto& draw,
                    Qt::PenStyle style = Qt::SolidLine, double halo_px = 2) {
  for (const auto& [color, width] :
       {std::pair(theme.text_halo, width_px + halo_px), std::pair(theme.accent, width_px)}) {
    painter.setPen(QPen(color, width, style, Qt::RoundCap, Qt::RoundJoin));
    draw();
  }
}
void lineWithHalo(QPainter& painter, const scene::MapTheme& theme, const QPointF& from, const QPointF& to,
                  Qt::PenStyle style);
/// Something round that can be taken hold of.
void paintGrip(QPainter& painter, const scene::MapTheme& theme, const QPointF& at, double radius_px);
/// A rectangle that selects what is in it.
void paintFrame(QPainter& painter, const scene::MapTheme& theme, const QRectF& frame_px);
/// Where the handle is that turns what lies in `bounds` around `pivot_m`: above it, and on the screen
/// whenever the pivot is.
QPointF turnHandle(const geometry::ViewTransform& view, const geometry::WorldRect& bounds,
                   const Eigen::Vector2d& pivot_m, double above_px);
/// By how much the hand has turned around a pivot.
double turnAround(const Eigen::Vector2d& pivot_m, const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m);
/// One metre along the axis of the map that is closest to the direction of an arrow key.
Eigen::Vector2d arrowStep(const geometry::ViewTransform& view, int key);

}  // namespace mapwright::ui
