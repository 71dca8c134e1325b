#include "ui/view/map_furniture.h"

#include <cmath>

#include <QAction>
#include <QPainter>
#include <QPainterPath>
#include <QToolButton>
#include <QVBoxLayout>

#include "geometry/pose.h"
#include "ui/kit/ui_colors.h"

namespace mapwright::window {

NorthArrow::NorthArrow(QWidget* parent) : QAbstractButton(parent) {
  setFocusPolicy(Qt::NoFocus);
  setFixedSize(32, 32);
  setAccessibleName(tr("North up"));
}

void NorthArrow::setRotation(double rad) {
  if (rad == rotation_) return;
  rotation_ = rad;
  update();
}

void NorthArrow::enterEvent(QEnterEvent*) { update(); }
void NorthArrow::leaveEvent(QEvent*) { update(); }

void NorthArrow::paintEvent(QPaintEvent*) {
  const UiColors colors = appColors();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (underMouse()) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(colors.hover);
    painter.drawRoundedRect(rect(), 4, 4);
  }
  painter.translate(width() / 2.0, height() / 2.0);
  // Rotating the picture counter-clockwise rotates the painter (y down) by the negative angle.
  painter.rotate(-geometry::degreesFromRadians(rotation_));
  QPainterPath north, south;
  north.moveTo(0, -12);
  north.lineTo(4.5, 1);
  north.lineTo(-4.5, 1);
  north.closeSubpath();
  south.moveTo(0, 12);
  south.lineTo(4.5, 1);
  south.lineTo(-4.5, 1);
  south.closeSubpath();
  painter.setPen(Qt::NoPen);
  painter.setBrush(colors.error);
  painter.drawPath(north);
  painter.setBrush(colors.neutral);
  painter.drawPath(south);
}

MapFurniture::MapFurniture(QAction* zoom_in, QAction* zoom_out, QAction* fit, QAction* north_up,
                           QWidget* parent)
    : QFrame(parent), north_(new NorthArrow(this)) {
  setObjectName(QStringLiteral("furniture"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  column->setSpacing(2);
  for (QAction* action : {zoom_in, zoom_out, fit}) {
    auto* button = new QToolButton(this);
    button->setDefaultAction(action);
    button->setIconSize({20, 20});
    button->setFixedSize(32, 32);
    button->setFocusPolicy(Qt::NoFocus);
    button->setAutoRepeat(action != fit);
    column->addWidget(button);
  }
  column->addWidget(north_);
  north_->setToolTip(north_up->toolTip());
  connect(north_, &QAbstractButton::clicked, north_up, &QAction::trigger);
  connect(north_up, &QAction::enabledChanged, north_, &QWidget::setEnabled);
}

}  // namespace mapwright::window

#include "moc_map_furniture.cpp"
