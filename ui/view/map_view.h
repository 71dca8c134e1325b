// The map on screen: turns input into camera moves. scene::MapScene paints the picture.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <QElapsedTimer>
#include <QGraphicsView>
#include <QTimer>

#include "geometry/view_transform.h"
#include "ui/scene/map_scene.h"
#include "ui/view/map_tool.h"

class QGestureEvent;
class QNativeGestureEvent;

namespace mapwright::ui {

class Actions;

inline constexpr double kLadder = 1.25;             // one wheel notch
inline constexpr double kNativeScaleMPerPx = 0.05;  // 1:1, a usual cell of a robot's map

/// The scale `steps` rungs from `scale` (positive magnifies). Whole steps snap to the ladder 0.05 * 1.25^k,
/// so that 1:1 is one of them; fractional steps do not snap.
double ladderScale(double scale_m_per_px, double steps);

/// An animation from one view to another, evaluated by `at(t)`, t in 0..1.
struct CameraMotion {
  geometry::ViewTransform from, to;
  /// The pixel whose world point stays fixed; nullopt = move straight.
  std::optional<Eigen::Vector2d> anchor;

  geometry::ViewTransform at(double t) const;
};

class MapView : public QGraphicsView {
  Q_OBJECT
 public:
  /// The scene must outlive the view.
  explicit MapView(scene::MapScene* scene, QWidget* parent = nullptr);

  scene::MapScene* mapScene() const { return scene_; }
  /// The camera, or its destination while it moves.
  geometry::ViewTransform destination() const { return motion_ ? motion_->to : scene_->view(); }
  bool moving() const { return motion_.has_value(); }

  /// 0 = jump. The default is 120 ms, or 0 where the desktop asks for reduced motion.
  void setAnimationMs(int ms) { animation_ms_ = ms; }

  /// Moves there, from the present point of an animation in progress.
  void moveTo(const geometry::ViewTransform& view, bool animated, std::optional<QPointF> anchor = {});
  void stopMoving();
  void zoomSteps(double steps, std::optional<QPointF> anchor = {});  // default anchor: the middle
  void setScale(double scale_m_per_px);
  void rotateBy(double rad, std::optional<QPointF> anchor = {});
  void setRotation(double rad);
  void lookAt(const Eigen::Vector2d& world_m, bool animated = true);
  /// Shows the whole rectangle, below the strips on top of the map; small ones are not magnified beyond
  /// `closest_m_per_px`.
  void fit(const geometry::WorldRect& world, bool animated, double closest_m_per_px = 0.005);
  /// The same at once, and again when strips or panels change: until the camera is moved otherwise, and never
  /// under the cursor.
  void keepFitted(const geometry::WorldRect& world, double closest_m_per_px);
  /// The height of the strips at its top.
  void setCoveredTop(int px);
  /// By what else floats over it. Names keep clear of it, and of what the tool paints.
  void setCovered(std::vector<QRectF> areas);

  /// While following, the robot is kept in the centre; manual panning stops it.
  void setFollowing(bool following);
  bool following() const { return following_; }

  void setTool(MapTool* tool);  // not owned; must not be null
  MapTool* tool() const { return tool_; }
  /// The active tool: the chosen one, or panning while Space is held.
  MapTool* activeTool() { return space_held_ ? &pan_tool_ : tool_; }

  /// World point under the cursor, while it is over the map.
  std::optional<Eigen::Vector2d> cursorWorld() const;
  Eigen::Vector2d worldAt(const QPointF& viewport_px) const;

 Q_SIGNALS:
  void cursorMoved();  // or left
  void movedByHand();  // the user took the camera
  void followingChanged(bool following);
  void escaped();  // Esc that no tool took
  void menuRequested(const QPoint& global_pos, const QPointF& viewport_px);

 protected:
  bool event(QEvent* event) override;
  bool viewportEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void drawForeground(QPainter* painter, const QRectF& rect) override;

 private:
  void setView(const geometry::ViewTransform& view);
  geometry::ViewTransform fittedTo(const geometry::WorldRect& world, double closest_m_per_px) const;
  bool fitAgain();
  void step();
  void updateCovered();
  void panBy(const QPointF& pixels);
  void zoomFactorAt(const QPointF& anchor, double factor);
  void onMovedByHand(bool keeps_following = false);
  void updateCursor();
  MapPoint pointAt(const QPointF& px, Qt::KeyboardModifiers modifiers) const;
  void cancelToolDrag();
  void centreOnRobot();
  bool nativeGesture(QNativeGestureEvent* event);
  bool gesture(QGestureEvent* event);
  QPointF middle() const { return {viewport()->width() / 2.0, viewport()->height() / 2.0}; }

  scene::MapScene* scene_;
  PanTool pan_tool_;
  MapTool* tool_ = &pan_tool_;
  std::optional<CameraMotion> motion_;
  struct Fit {
    geometry::WorldRect world;
    double closest_m_per_px = 0;
    double covered_px;  // by the strips, then
  };
  std::optional<Fit> kept_fit_;
  std::vector<QRectF> covered_;
  QSize window_size_;  // at the last resize
  QPoint corner_px_;   // of the map in the window, at that time
  QElapsedTimer motion_clock_;
  QTimer motion_timer_;
  int animation_ms_;
  bool following_ = false;
  bool space_held_ = false;
  bool keyboard_came_ = false;    // the focus, by keys: it is framed
  std::optional<QPointF> press_;  // where the button went down
  QPointF drag_last_;
  bool dragging_ = false;
  bool tool_takes_ = false;     // the tool took the press
  bool tool_dragging_ = false;  // and it became a drag
  std::optional<QPointF> cursor_px_;
};

/// "zoomIn", "zoomOut", "native", "fit", "northUp", "rotateLeft", "rotateRight". The view must outlive them.
void addCameraActions(Actions& actions, MapView& view);

}  // namespace mapwright::ui
