#include "ui/view/map_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QApplication>
#include <QResizeEvent>
#include <QStyle>

#include "geometry/pose.h"

namespace mapwright::window {

namespace {

constexpr int kAnimationMs = 120;
constexpr int kFrameMs = 8;

Eigen::Vector2d vector(const QPointF& p) { return {p.x(), p.y()}; }

}  // namespace

MapView::MapView(scene::MapScene* scene, QWidget* parent) : QGraphicsView(parent), scene_(scene) {
  setScene(scene);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setAlignment(Qt::AlignLeft | Qt::AlignTop);
  setTransformationAnchor(QGraphicsView::NoAnchor);
  setResizeAnchor(QGraphicsView::NoAnchor);
  setInteractive(false);
  setMouseTracking(true);
  viewport()->setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Map"));
  viewport()->setAttribute(Qt::WA_AcceptTouchEvents);
  viewport()->grabGesture(Qt::PinchGesture);
  // The style reports whether the desktop wants no animations.
  animation_ms_ =
      style()->styleHint(QStyle::SH_Widget_Animation_Duration, nullptr, this) > 0 ? kAnimationMs : 0;
  motion_timer_.setTimerType(Qt::PreciseTimer);
  motion_timer_.setInterval(kFrameMs);
  connect(&motion_timer_, &QTimer::timeout, this, &MapView::step);
  updateCursor();
}

void MapView::setView(const geometry::ViewTransform& view) {
  geometry::ViewTransform sized = view;
  sized.width_px = std::max(1, viewport()->width());
  sized.height_px = std::max(1, viewport()->height());
  if (sized == scene_->view()) return;
  scene_->setView(sized);
  if (cursor_px_) Q_EMIT cursorMoved();
}

void MapView::moveTo(const geometry::ViewTransform& view, bool animated, std::optional<QPointF> anchor) {
  kept_fit_.reset();
  geometry::ViewTransform to = view;
  to.width_px = std::max(1, viewport()->width());
  to.height_px = std::max(1, viewport()->height());
  if (!animated || animation_ms_ <= 0 || !isVisible()) {
    stopMoving();
    setView(to);
    return;
  }
  motion_ = CameraMotion{scene_->view(), to, anchor ? std::optional(vector(*anchor)) : std::nullopt};
  motion_clock_.start();
  motion_timer_.start();
}

void MapView::stopMoving() {
  motion_.reset();
  motion_timer_.stop();
}

void MapView::step() {
  if (!motion_) return;
  const double t = double(motion_clock_.elapsed()) / std::max(1, animation_ms_);
  const geometry::ViewTransform view = motion_->at(t);
  if (t >= 1) stopMoving();
  setView(view);
}

void MapView::zoomSteps(double steps, std::optional<QPointF> anchor) {
  const geometry::ViewTransform goal = destination();
  const double scale = ladderScale(goal.scale_m_per_px, steps);
  const QPointF at = anchor.value_or(middle());
  // From the camera's present state, not its destination: the point under the cursor must not move.
  const geometry::ViewTransform now = scene_->view();
  geometry::ViewTransform to = now.zoomedAt(vector(at), now.scale_m_per_px / scale);
  if (motion_ && goal.rotation_rad != now.rotation_rad) {
    to = to.rotatedAt(vector(at), goal.rotation_rad - now.rotation_rad);
  }
  to.scale_m_per_px = scale;
  takeByHand(true);
  moveTo(to, true, at);
}

void MapView::zoomFactorAt(const QPointF& anchor, double factor) {
  takeByHand(true);
  stopMoving();
  setView(scene_->view().zoomedAt(vector(anchor), factor));
}

void MapView::setScale(double scale_m_per_px) {
  const geometry::ViewTransform now = destination();
  takeByHand(true);
  moveTo(now.zoomedAt(vector(middle()), now.scale_m_per_px / scale_m_per_px), true);
}

void MapView::rotateBy(double rad, std::optional<QPointF> anchor) {
  const QPointF at = anchor.value_or(middle());
  const geometry::ViewTransform goal = destination();
  const geometry::ViewTransform now = scene_->view();
  geometry::ViewTransform to =
      now.rotatedAt(vector(at), geometry::normalizeAngle(goal.rotation_rad + rad - now.rotation_rad));
  to = to.zoomedAt(vector(at), to.scale_m_per_px / goal.scale_m_per_px);
  takeByHand(true);
  moveTo(to, true, at);
}

void MapView::setRotation(double rad) {
  rotateBy(geometry::normalizeAngle(rad - destination().rotation_rad));
}

void MapView::lookAt(const Eigen::Vector2d& world_m, bool animated) {
  geometry::ViewTransform to = destination();
  to.center_m = world_m;
  takeByHand();
  moveTo(to, animated);
}

void MapView::fit(const geometry::WorldRect& world, bool animated, double closest_m_per_px) {
  if (world.empty()) return;
  setFollowing(false);
  moveTo(fittedTo(world, closest_m_per_px), animated);
}

geometry::ViewTransform MapView::fittedTo(const geometry::WorldRect& world, double closest_m_per_px) const {
  geometry::ViewTransform to = scene_->view();
  to.rotation_rad = destination().rotation_rad;
  to.width_px = std::max(1, viewport()->width());
  const int height = std::max(1, viewport()->height());
  // If strips leave hardly any room it is useless to avoid them.
  const double covered = std::min(scene_->coveredTop(), height / 2.0);
  to.height_px = std::max(1, int(height - covered));
  to = to.fitted(world, std::min(48.0, 0.06 * std::min(to.width_px, to.height_px)));
  to.scale_m_per_px = std::max(to.scale_m_per_px, closest_m_per_px);
  to.height_px = height;
  return to.pannedBy({0, covered / 2});
}

void MapView::keepFitted(const geometry::WorldRect& world, double closest_m_per_px) {
  if (world.empty()) return;
  fit(world, false, closest_m_per_px);
  kept_fit_ = {world, closest_m_per_px, scene_->coveredTop()};
}

bool MapView::fitAgain() {
  if (!kept_fit_ || cursor_px_) return false;
  const Fit fit = *kept_fit_;
  keepFitted(fit.world, fit.closest_m_per_px);
  return true;
}

void MapView::setCoveredTop(int px) {
  scene_->setCoveredTop(px);
  // A disappearing strip is no reason to move the map.
  if (kept_fit_ && px > kept_fit_->covered_px) fitAgain();
}

void MapView::panBy(const QPointF& pixels) {
  takeByHand();
  stopMoving();
  setView(scene_->view().pannedBy(vector(pixels)));
}

void MapView::takeByHand(bool keeps_following) {
  kept_fit_.reset();
  if (!keeps_following) setFollowing(false);
  Q_EMIT movedByHand();
}

void MapView::setFollowing(bool following) {
  if (following == following_) return;
  following_ = following;
  kept_fit_.reset();
  if (session::Session* session = scene_->session()) {
    if (following) {
      connect(session, &session::Session::liveHeard, this, &MapView::centreOnRobot, Qt::UniqueConnection);
      connect(scene_, &scene::MapScene::poseBetweenChanged, this, &MapView::centreOnRobot,
              Qt::UniqueConnection);
      const auto pose = scene_->robotPose();
      if (pose && scene_->robotPlace().drawn != scene::ScreenPart::None) {
        geometry::ViewTransform to = destination();
        to.center_m = {pose->x_m, pose->y_m};
        moveTo(to, true);
      }
    } else {
      disconnect(session, &session::Session::liveHeard, this, &MapView::centreOnRobot);
      disconnect(scene_, &scene::MapScene::poseBetweenChanged, this, &MapView::centreOnRobot);
    }
  }
  Q_EMIT followingChanged(following);
}

void MapView::centreOnRobot() {
  const auto pose = scene_->robotPose();
  if (!following_ || !pose) return;
  // If it is not drawn there is nothing to follow.
  if (scene_->robotPlace().drawn == scene::ScreenPart::None) return;
  const Eigen::Vector2d robot(pose->x_m, pose->y_m);
  if (motion_) {
    motion_->to.center_m = robot;
    motion_->anchor.reset();
    return;
  }
  geometry::ViewTransform view = scene_->view();
  view.center_m = robot;
  setView(view);
}

void MapView::setTool(MapTool* tool) {
  if (tool == tool_) return;
  cancelToolDrag();
  tool_->deactivate();
  tool_->disconnect(this);
  tool_ = tool;
  connect(tool_, &MapTool::changed, this, [this] {
    updateCursor();
    viewport()->update();
  });
  tool_->activate();
  viewport()->update();
  updateCursor();
}

void MapView::cancelToolDrag() {
  tool_takes_ = false;
  if (std::exchange(tool_dragging_, false)) tool_->dragCancelled();
}

MapPoint MapView::pointAt(const QPointF& px, Qt::KeyboardModifiers modifiers) const {
  return {worldAt(px), px, modifiers};
}

void MapView::drawForeground(QPainter* painter, const QRectF& rect) {
  QGraphicsView::drawForeground(painter, rect);
  // The scene's coordinates are viewport pixels.
  painter->save();
  tool_->paint(*painter);
  painter->restore();
}

std::optional<Eigen::Vector2d> MapView::cursorWorld() const {
  if (!cursor_px_) return std::nullopt;
  return worldAt(*cursor_px_);
}

Eigen::Vector2d MapView::worldAt(const QPointF& viewport_px) const {
  return scene_->view().worldFromPixel(vector(viewport_px));
}

void MapView::resizeEvent(QResizeEvent* event) {
  QGraphicsView::resizeEvent(event);
  setSceneRect(QRectF(viewport()->rect()));
  if (motion_) {
    motion_->from.width_px = motion_->to.width_px = std::max(1, viewport()->width());
    motion_->from.height_px = motion_->to.height_px = std::max(1, viewport()->height());
  }
  // A panel that opens or closes leaves the map where it is on the screen: the user may be about to click on
  // it. With the window itself it grows around the middle.
  const QPoint corner = mapTo(window(), QPoint());
  const QSize window_size = window()->size();
  const bool by_panel = event->oldSize().isValid() && window_size == window_size_ && !following_;
  const QPointF moved = corner_px_ - corner, grown(event->size().width() - event->oldSize().width(),
                                                   event->size().height() - event->oldSize().height());
  corner_px_ = corner;
  window_size_ = window_size;
  if (fitAgain()) return;
  geometry::ViewTransform view = scene_->view();
  if (by_panel) {
    const Eigen::Vector2d by(moved.x() - grown.x() / 2, moved.y() - grown.y() / 2);
    view = view.pannedBy(by);
    if (motion_) {
      motion_->from = motion_->from.pannedBy(by);
      motion_->to = motion_->to.pannedBy(by);
    }
  }
  setView(view);
}

void MapView::updateCursor() {
  viewport()->setCursor(dragging_     ? QCursor(Qt::ClosedHandCursor)
                        : space_held_ ? QCursor(Qt::OpenHandCursor)
                                      : tool_->cursor());
}

}  // namespace mapwright::window

#include "moc_map_view.cpp"
