#include "ui/clouds/height_slider.h"

#include <algorithm>
#include <cmath>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include "ui/kit/ui_colors.h"

namespace mapwright::ui {
namespace {

constexpr double kHandlePx = 6, kFootPx = 14;

}  // namespace

HeightSlider::HeightSlider(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  updateAccessibleText();
}

void HeightSlider::setHeights(const clouds::Heights& heights) {
  heights_ = heights;
  setEnabled(usable());
  updateAccessibleText();
  update();
}

void HeightSlider::setRange(std::optional<clouds::HeightRange> range) {
  range_ = range;
  updateAccessibleText();
  update();
}

void HeightSlider::updateAccessibleText() {
  setAccessibleName(tr("Visible heights"));
  const clouds::HeightRange now = shown();
  setAccessibleDescription(
      usable() ? tr("from %1 m to %2 m")
                     .arg(QString::number(now.low_m, 'f', 2), QString::number(now.high_m, 'f', 2))
               : tr("There are no heights to choose from."));
}

clouds::HeightRange HeightSlider::shown() const {
  return range_.value_or(clouds::HeightRange{heights_.usual_low_m, heights_.usual_high_m});
}

double HeightSlider::xOf(double z_m) const {
  const double room = std::max(1.0, width() - 2 * kHandlePx);
  if (!usable()) return kHandlePx;
  const double part = (z_m - heights_.usual_low_m) / (heights_.usual_high_m - heights_.usual_low_m);
  return kHandlePx + std::clamp(part, 0.0, 1.0) * room;
}

double HeightSlider::zAt(double x) const {
  const double part = std::clamp((x - kHandlePx) / std::max(1.0, width() - 2 * kHandlePx), 0.0, 1.0);
  return heights_.usual_low_m + part * (heights_.usual_high_m - heights_.usual_low_m);
}

void HeightSlider::moveHandle(Handle handle, double z_m) {
  clouds::HeightRange next = shown();
  if (handle == Handle::Low) {
    next.low_m = std::clamp(z_m, heights_.usual_low_m, std::max(heights_.usual_low_m, next.high_m));
  } else {
    next.high_m = std::clamp(z_m, std::min(next.low_m, heights_.usual_high_m), heights_.usual_high_m);
  }
  // From end to end means everything, including values beyond.
  const bool all = next.low_m <= heights_.usual_low_m && next.high_m >= heights_.usual_high_m;
  const std::optional<clouds::HeightRange> chosen = all ? std::nullopt : std::optional(next);
  if (chosen == range_) return;
  setRange(chosen);
  Q_EMIT rangeChosen(range_);
}

void HeightSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !usable()) return;
  const double x = event->position().x();
  const clouds::HeightRange now = shown();
  const double low = xOf(now.low_m), high = xOf(now.high_m);
  // If both are at one position, the one that can move towards the cursor.
  active_ = dragged_ =
      std::abs(x - low) < std::abs(x - high) || (low == high && x < low) ? Handle::Low : Handle::High;
  moveHandle(dragged_, zAt(x));
  update();
}

void HeightSlider::mouseMoveEvent(QMouseEvent* event) {
  if (dragged_ != Handle::None) moveHandle(dragged_, zAt(event->position().x()));
}

void HeightSlider::mouseReleaseEvent(QMouseEvent*) { dragged_ = Handle::None; }

void HeightSlider::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !range_) return;
  setRange(std::nullopt);
  Q_EMIT rangeChosen(range_);
}

void HeightSlider::keyPressEvent(QKeyEvent* event) {
  if (!usable()) return QWidget::keyPressEvent(event);
  const double step =
      (heights_.usual_high_m - heights_.usual_low_m) * (event->modifiers() & Qt::ShiftModifier ? 0.1 : 0.01);
  const clouds::HeightRange now = shown();
  const double at = active_ == Handle::Low ? now.low_m : now.high_m;
  switch (event->key()) {
    case Qt::Key_Left:
      return moveHandle(active_, at - step);
    case Qt::Key_Right:
      return moveHandle(active_, at + step);
    case Qt::Key_Home:
      return moveHandle(active_, heights_.usual_low_m);
    case Qt::Key_End:
      return moveHandle(active_, heights_.usual_high_m);
    case Qt::Key_Up:
      active_ = Handle::High;
      return update();
    case Qt::Key_Down:
      active_ = Handle::Low;
      return update();
    default:
      QWidget::keyPressEvent(event);
  }
}

void HeightSlider::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const UiColors colors = appColors();
  const QRectF field(kHandlePx, 0, std::max(1.0, width() - 2 * kHandlePx), height() - kFootPx);
  painter.fillRect(field, colors.base);
  painter.setPen(colors.border);
  painter.drawRect(field.adjusted(0.5, 0.5, -0.5, -0.5));
  if (!usable()) return;
  const clouds::HeightRange now = shown();
  const double low = xOf(now.low_m), high = xOf(now.high_m);
  // Square roots: a floor has a hundred times as many points as the objects on it, and both should be
  // visible.
  const auto most = *std::max_element(heights_.bins.begin(), heights_.bins.end());
  const double bin_px = field.width() / double(heights_.bins.size());
  for (std::size_t i = 0; i < heights_.bins.size(); ++i) {
    if (heights_.bins[i] == 0 || most == 0) continue;
    const double tall =
        std::max(1.0, std::sqrt(double(heights_.bins[i]) / double(most)) * (field.height() - 2));
    const double x = field.left() + double(i) * bin_px;
    const bool in = x + bin_px / 2 >= low && x + bin_px / 2 <= high;
    painter.fillRect(QRectF(x, field.bottom() - tall, std::max(1.0, bin_px), tall),
                     in ? colors.accent : colors.border);
  }
  for (const Handle handle : {Handle::Low, Handle::High}) {
    const double x = handle == Handle::Low ? low : high;
    const bool focused = hasFocus() && handle == active_;
    painter.setPen(QPen(focused ? colors.focus : colors.outline, focused ? 2 : 1));
    painter.drawLine(QPointF(x, 0), QPointF(x, field.bottom()));
    QPainterPath grip;
    grip.moveTo(x, field.bottom());
    grip.lineTo(x + kHandlePx - 1, field.bottom() + 6);
    grip.lineTo(x + kHandlePx - 1, height() - 1);
    grip.lineTo(x - kHandlePx + 1, height() - 1);
    grip.lineTo(x - kHandlePx + 1, field.bottom() + 6);
    grip.closeSubpath();
    painter.setBrush(focused ? colors.focus : colors.window);
    painter.drawPath(grip);
  }
}

}  // namespace mapwright::ui

#include "moc_height_slider.cpp"
