#include "ui/view/map_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QApplication>
#include <QGestureEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QPinchGesture>
#include <QPointingDevice>
#include <QResizeEvent>
#include <QStyle>
#include <QWheelEvent>

#include "geometry/pose.h"
#include "ui/kit/actions.h"
#include "ui/kit/ui_colors.h"

namespace mapwright::ui {

namespace {

constexpr int kAnimationMs = 120;
constexpr int kFrameMs = 8;
constexpr double kTurnDegrees = 15;
constexpr double kDragStartPx = 4;  // of what a tool has taken hold of
constexpr double kPanStartPx = 8;   // a click of an unsteady hand is still a click
constexpr double kFineZoom = 0.2;   // part of a rung with Ctrl
constexpr double kWheelTurn = geometry::radiansFromDegrees(5);  // one notch with Shift
constexpr double kArrowPx = 64;
constexpr double kNotch = 120;  // eighths of a degree, see QWheelEvent

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
  updateCovered();
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
  onMovedByHand(true);
  moveTo(to, true, at);
}

void MapView::zoomFactorAt(const QPointF& anchor, double factor) {
  onMovedByHand(true);
  stopMoving();
  setView(scene_->view().zoomedAt(vector(anchor), factor));
}

void MapView::setScale(double scale_m_per_px) {
  const geometry::ViewTransform now = destination();
  onMovedByHand(true);
  moveTo(now.zoomedAt(vector(middle()), now.scale_m_per_px / scale_m_per_px), true);
}

void MapView::rotateBy(double rad, std::optional<QPointF> anchor) {
  const QPointF at = anchor.value_or(middle());
  const geometry::ViewTransform goal = destination();
  const geometry::ViewTransform now = scene_->view();
  geometry::ViewTransform to =
      now.rotatedAt(vector(at), geometry::normalizeAngle(goal.rotation_rad + rad - now.rotation_rad));
  to = to.zoomedAt(vector(at), to.scale_m_per_px / goal.scale_m_per_px);
  onMovedByHand(true);
  moveTo(to, true, at);
}

void MapView::setRotation(double rad) {
  rotateBy(geometry::normalizeAngle(rad - destination().rotation_rad));
}

void MapView::lookAt(const Eigen::Vector2d& world_m, bool animated) {
  geometry::ViewTransform to = destination();
  to.center_m = world_m;
  onMovedByHand();
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

void MapView::setCovered(std::vector<QRectF> areas) {
  covered_ = std::move(areas);
  updateCovered();
}

void MapView::updateCovered() {
  std::vector<QRectF> areas = covered_;
  for (const QRectF& area : tool_->covered()) areas.push_back(area);
  scene_->setCovered(std::move(areas));
}

void MapView::panBy(const QPointF& pixels) {
  onMovedByHand();
  stopMoving();
  setView(scene_->view().pannedBy(vector(pixels)));
}

void MapView::onMovedByHand(bool keeps_following) {
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
  if (!dragging_) press_.reset();  // it is no click of the next tool
  tool_->deactivate();
  tool_->disconnect(this);
  tool_ = tool;
  connect(tool_, &MapTool::changed, this, [this] {
    updateCursor();
    updateCovered();
    viewport()->update();
  });
  tool_->activate();
  updateCovered();
  viewport()->update();
  updateCursor();
}

/// What the tool has taken hold of comes to nothing, whether it has moved or not.
void MapView::cancelToolDrag() {
  tool_dragging_ = false;
  if (!std::exchange(tool_takes_, false)) return;
  press_.reset();
  tool_->dragCancelled();
}

MapPoint MapView::pointAt(const QPointF& px, Qt::KeyboardModifiers modifiers) const {
  return {worldAt(px), px, modifiers};
}

void MapView::drawForeground(QPainter* painter, const QRectF& rect) {
  QGraphicsView::drawForeground(painter, rect);
  // The scene's coordinates are viewport pixels.
  painter->save();
  painter->setClipRect(rect, Qt::IntersectClip);
  tool_->paint(*painter);
  painter->restore();
  if (!keyboard_came_) return;
  painter->setPen(QPen(appColors().focus, 2));
  painter->setBrush(Qt::NoBrush);
  painter->drawRect(QRectF(viewport()->rect()).adjusted(1, scene_->coveredTop() + 1, -1, -1));
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

double ladderScale(double scale_m_per_px, double steps) {
  using geometry::kMaxScaleMPerPx;
  using geometry::kMinScaleMPerPx;
  double rung = std::log(kNativeScaleMPerPx / scale_m_per_px) / std::log(kLadder);
  if (steps == std::round(steps)) {
    // Between two rungs, the first step goes to the next rung in its direction.
    const double near = std::round(rung);
    if (std::abs(rung - near) < 1e-6) rung = near;
    rung = steps > 0 ? std::floor(rung) : std::ceil(rung);
  }
  const double scale = kNativeScaleMPerPx / std::pow(kLadder, rung + steps);
  return std::clamp(scale, kMinScaleMPerPx, kMaxScaleMPerPx);
}

geometry::ViewTransform CameraMotion::at(double t) const {
  if (t >= 1) return to;
  const double eased = 1 - (1 - t) * (1 - t);
  const double turn = geometry::normalizeAngle(to.rotation_rad - from.rotation_rad);
  const double zoom = from.scale_m_per_px / to.scale_m_per_px;
  if (anchor) {
    geometry::ViewTransform view = from.zoomedAt(*anchor, std::pow(zoom, eased));
    return turn == 0 ? view : view.rotatedAt(*anchor, turn * eased);
  }
  geometry::ViewTransform view = to;
  view.scale_m_per_px = from.scale_m_per_px / std::pow(zoom, eased);
  view.rotation_rad = geometry::normalizeAngle(from.rotation_rad + turn * eased);
  view.center_m = from.center_m + (to.center_m - from.center_m) * eased;
  return view;
}

bool MapView::event(QEvent* event) {
  if (event->type() == QEvent::NativeGesture && nativeGesture(static_cast<QNativeGestureEvent*>(event)))
    return true;
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* const key = static_cast<QKeyEvent*>(event);
    if (tool_->claims({key->key(), key->modifiers(), key->isAutoRepeat()})) return event->accept(), true;
  }
  return QGraphicsView::event(event);
}

bool MapView::viewportEvent(QEvent* event) {
  switch (event->type()) {
    case QEvent::NativeGesture:
      if (nativeGesture(static_cast<QNativeGestureEvent*>(event))) return true;
      break;
    case QEvent::Gesture:
      if (gesture(static_cast<QGestureEvent*>(event))) return true;
      break;
    case QEvent::Leave:
      cursor_px_.reset();
      tool_->left();
      Q_EMIT cursorMoved();
      break;
    default:
      break;
  }
  return QGraphicsView::viewportEvent(event);
}

void MapView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::RightButton) return;  // contextMenuEvent follows
  if (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton) {
    event->ignore();
    return;
  }
  if (std::exchange(keyboard_came_, false)) viewport()->update();
  stopMoving();
  cancelToolDrag();
  press_ = drag_last_ = event->position();
  // Middle and Space+left drag at once; a left press may still become a click.
  dragging_ = event->button() == Qt::MiddleButton || space_held_;
  if (!dragging_) tool_takes_ = tool_->pressed(pointAt(event->position(), event->modifiers()));
  updateCursor();
  event->accept();
}

void MapView::mouseMoveEvent(QMouseEvent* event) {
  cursor_px_ = event->position();
  if (press_ && (event->buttons() & (Qt::LeftButton | Qt::MiddleButton))) {
    const QPointF moved = event->position() - *press_;
    const double start_px = tool_takes_ ? kDragStartPx : kPanStartPx;
    if (!dragging_ && !tool_dragging_ && std::hypot(moved.x(), moved.y()) >= start_px) {
      (tool_takes_ ? tool_dragging_ : dragging_) = true;
      updateCursor();
    }
    if (tool_dragging_) tool_->dragged(pointAt(event->position(), event->modifiers()));
    if (dragging_) {
      panBy(event->position() - drag_last_);
      drag_last_ = event->position();
    }
  } else {
    activeTool()->hovered(pointAt(event->position(), event->modifiers()));
  }
  Q_EMIT cursorMoved();
  event->accept();
}

void MapView::mouseReleaseEvent(QMouseEvent* event) {
  if (!press_ || (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton)) {
    event->ignore();
    return;
  }
  const bool click = !dragging_ && !tool_dragging_ && event->button() == Qt::LeftButton;
  const MapPoint at = pointAt(event->position(), event->modifiers());
  press_.reset();
  dragging_ = false;
  tool_takes_ = false;
  if (std::exchange(tool_dragging_, false)) tool_->released(at);
  updateCursor();
  if (click) activeTool()->clicked(at);
  event->accept();
}

void MapView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (activeTool()->takesEveryPress()) return mousePressEvent(event);
  if (event->button() != Qt::LeftButton) return;
  event->accept();
  const Eigen::Vector2d world = worldAt(event->position());
  if (activeTool()->doubleClicked(pointAt(event->position(), event->modifiers()))) return;
  geometry::ViewTransform to = destination();
  to.center_m = world;
  to.scale_m_per_px = ladderScale(to.scale_m_per_px, 3);
  onMovedByHand();
  moveTo(to, true);
}

void MapView::wheelEvent(QWheelEvent* event) {
  event->accept();
  const bool touchpad = event->device() && event->device()->type() == QInputDevice::DeviceType::TouchPad;
  const bool phased = event->phase() != Qt::NoScrollPhase && !event->pixelDelta().isNull();
  const Qt::KeyboardModifiers modifiers = event->modifiers();
  if ((touchpad || phased) && !(modifiers & (Qt::ControlModifier | Qt::ShiftModifier))) {
    const QPointF pixels =
        event->pixelDelta().isNull() ? QPointF(event->angleDelta()) / 2 : QPointF(event->pixelDelta());
    panBy(pixels);
    return;
  }
  // With Shift and Alt some platforms report the wheel sideways.
  const int angle = event->angleDelta().y() != 0 ? event->angleDelta().y() : event->angleDelta().x();
  if (angle == 0) return;
  const double notches = angle / kNotch;
  if (modifiers & Qt::ShiftModifier) {
    rotateBy(notches * kWheelTurn, event->position());
  } else if (modifiers & Qt::ControlModifier) {
    zoomFactorAt(event->position(), std::pow(kLadder, notches * kFineZoom));
  } else {
    zoomSteps(notches, event->position());
  }
}

void MapView::keyPressEvent(QKeyEvent* event) {
  if (tool_->keyPressed({event->key(), event->modifiers(), event->isAutoRepeat()})) {
    // What was ended by a key is ignored from then on.
    if (event->key() == Qt::Key_Escape && !dragging_) {
      press_.reset();
      tool_takes_ = tool_dragging_ = false;
    }
    updateCursor();
    event->accept();
    return;
  }
  const double step = event->modifiers() & Qt::ShiftModifier ? kArrowPx * 4 : kArrowPx;
  switch (event->key()) {
    case Qt::Key_Left:
      panBy({step, 0});
      break;
    case Qt::Key_Right:
      panBy({-step, 0});
      break;
    case Qt::Key_Up:
      panBy({0, step});
      break;
    case Qt::Key_Down:
      panBy({0, -step});
      break;
    case Qt::Key_Escape:
      stopMoving();
      setFollowing(false);
      Q_EMIT escaped();
      break;
    case Qt::Key_Space:
      if (!event->isAutoRepeat() && !tool_dragging_) {
        space_held_ = true;
        updateCursor();
      }
      break;
    default:
      event->ignore();
      return;
  }
  event->accept();
}

void MapView::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
    space_held_ = false;
    updateCursor();
    event->accept();
    return;
  }
  event->ignore();
}

void MapView::focusInEvent(QFocusEvent* event) {
  keyboard_came_ = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason ||
                   event->reason() == Qt::ShortcutFocusReason;
  if (keyboard_came_) viewport()->update();
  QGraphicsView::focusInEvent(event);
}

void MapView::focusOutEvent(QFocusEvent* event) {
  if (std::exchange(keyboard_came_, false)) viewport()->update();
  space_held_ = false;
  cancelToolDrag();
  updateCursor();
  QGraphicsView::focusOutEvent(event);
}

void MapView::contextMenuEvent(QContextMenuEvent* event) {
  const QPointF at =
      event->reason() == QContextMenuEvent::Keyboard ? cursor_px_.value_or(middle()) : QPointF(event->pos());
  Q_EMIT menuRequested(viewport()->mapToGlobal(at.toPoint()), at);
  event->accept();
}

bool MapView::nativeGesture(QNativeGestureEvent* event) {
  switch (event->gestureType()) {
    case Qt::ZoomNativeGesture:
      zoomFactorAt(event->position(), std::exp(event->value()));
      return true;
    case Qt::RotateNativeGesture: {
      onMovedByHand(true);
      stopMoving();
      const QPointF at = event->position();
      setView(scene_->view().rotatedAt({at.x(), at.y()}, -geometry::radiansFromDegrees(event->value())));
      return true;
    }
    case Qt::SmartZoomNativeGesture:
      zoomSteps(3, event->position());
      return true;
    default:
      return false;
  }
}

bool MapView::gesture(QGestureEvent* event) {
  auto* pinch = static_cast<QPinchGesture*>(event->gesture(Qt::PinchGesture));
  if (!pinch) return false;
  const QPointF at = viewport()->mapFromGlobal(pinch->centerPoint());
  if (pinch->changeFlags() & QPinchGesture::CenterPointChanged) {
    panBy(pinch->centerPoint() - pinch->lastCenterPoint());
  }
  if ((pinch->changeFlags() & QPinchGesture::ScaleFactorChanged) && pinch->scaleFactor() > 0) {
    zoomFactorAt(at, pinch->scaleFactor());
  }
  event->accept(pinch);
  return true;
}

void addCameraActions(Actions& actions, MapView& view) {
  actions.add({.id = "zoomIn",
               .text = MapView::tr("Zoom &in"),
               .icon = "zoom-in",
               .keys = {"+", "="},
               .reach = Reach::OutsideText,
               .tip = MapView::tr("Zoom in"),
               .needs_session = true,
               .menu = {MenuGroup::Zoom, 10}},
              &view, [&view] { view.zoomSteps(1); });
  actions.add({.id = "zoomOut",
               .text = MapView::tr("Zoom &out"),
               .icon = "zoom-out",
               .keys = {"-"},
               .reach = Reach::OutsideText,
               .tip = MapView::tr("Zoom out"),
               .needs_session = true,
               .menu = {MenuGroup::Zoom, 20}},
              &view, [&view] { view.zoomSteps(-1); });
  actions.add({.id = "native",
               .text = QStringLiteral("&1:1"),
               .name = MapView::tr("Zoom to 1:1"),
               .icon = "native",
               .keys = {"0"},
               .reach = Reach::OutsideText,
               .tip = MapView::tr("One cell of 5 cm on one pixel"),
               .needs_session = true,
               .menu = {MenuGroup::Zoom, 30},
               .bar = {BarGroup::Look, 20}},
              &view, [&view] { view.setScale(kNativeScaleMPerPx); });
  actions.add({.id = "fit",
               .text = MapView::tr("&Fit"),
               .name = MapView::tr("Fit the map"),
               .icon = "fit",
               .keys = {"F"},
               .reach = Reach::OutsideText,
               .tip = MapView::tr("Show the whole map"),
               .needs_session = true,
               .menu = {MenuGroup::Zoom, 40},
               .bar = {BarGroup::Look, 10},
               .map_menu = {MapMenuGroup::Look, 10}},
              &view, [&view] { view.fit(view.mapScene()->contentBounds(), true); });
  actions.add({.id = "northUp",
               .text = MapView::tr("&North up"),
               .name = MapView::tr("Turn the map north up"),
               .icon = "north",
               .keys = {"N"},
               .reach = Reach::OutsideText,
               .tip = MapView::tr("Rotate the view so that the map's y axis points up"),
               .needs_session = true,
               .menu = {MenuGroup::Turn, 10},
               .bar = {BarGroup::Look, 40},
               .map_menu = {MapMenuGroup::Look, 20}},
              &view, [&view] { view.setRotation(0); });
  actions.add({.id = "rotateLeft",
               .text = MapView::tr("Rotate &left"),
               .name = MapView::tr("Rotate the map left"),
               .icon = "rotate-left",
               .keys = {"["},
               .reach = Reach::OutsideText,
               .tip = MapView::tr("Rotate the view by 15° counter-clockwise"),
               .needs_session = true,
               .menu = {MenuGroup::Turn, 30}},
              &view, [&view] { view.rotateBy(geometry::radiansFromDegrees(kTurnDegrees)); });
  actions.add({.id = "rotateRight",
               .text = MapView::tr("Rotate r&ight"),
               .name = MapView::tr("Rotate the map right"),
               .icon = "rotate-right",
               .keys = {"]"},
               .reach = Reach::OutsideText,
               .tip = MapView::tr("Rotate the view by 15° clockwise"),
               .needs_session = true,
               .menu = {MenuGroup::Turn, 40}},
              &view, [&view] { view.rotateBy(-geometry::radiansFromDegrees(kTurnDegrees)); });
}

}  // namespace mapwright::ui

#include "moc_map_view.cpp"
