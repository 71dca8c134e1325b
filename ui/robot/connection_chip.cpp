#include "ui/robot/connection_chip.h"

#include <algorithm>

#include <QPainter>

#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/safety_badge.h"
#include "ui/kit/state_mark.h"

namespace mapwright::window {

namespace {
constexpr int kNameLimitPx = 200, kSafetyGapPx = 8;
}

ConnectionChip::ConnectionChip(QWidget* parent) : QToolButton(parent) {
  setPopupMode(QToolButton::InstantPopup);
  setFocusPolicy(Qt::TabFocus);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void ConnectionChip::setRobot(const QString& name, Mark mark, const QString& word, const QString& detail) {
  const bool same = name == name_ && mark == mark_ && word == word_;
  detail_ = detail;
  if (name != name_) safety_room_ = 0;
  name_ = name;
  mark_ = mark;
  word_ = word;
  describe();
  if (same) return;
  updateGeometry();
  update();
}

void ConnectionChip::setSafety(const SafetyText& text) {
  if (text == safety_) return;
  safety_ = text;
  describe();
  safety_room_ = std::max(safety_room_, safetyRoom());
  updateGeometry();
  update();
}

void ConnectionChip::describe() {
  const QString tip = safety_.detail.isEmpty() ? detail_ : safety_.detail + QStringLiteral("\n\n") + detail_;
  setToolTip(plainToolTip(tip));
  QString called = tr("Robot %1, %2").arg(name_, word_);
  if (!safety_.badge.isEmpty()) called += QStringLiteral(", ") + safety_.badge;
  setAccessibleName(called);
}

int ConnectionChip::safetyRoom() const {
  const int width = safetyWidth(safety_, font());
  return width == 0 ? 0 : width + kSafetyGapPx;
}

QSize ConnectionChip::sizeHint() const {
  const QFontMetrics metrics = fontMetrics();
  const int name = qMin(metrics.horizontalAdvance(name_), kNameLimitPx);
  // As wide as the longest word, so that the tool bar does not move.
  const int word = word_.isEmpty() ? 0 : metrics.horizontalAdvance(QStringLiteral("reconnecting")) + 8;
  return {10 + 12 + 8 + name + word + safety_room_ + 8 + 16 + 6, 30};
}

void ConnectionChip::paintEvent(QPaintEvent*) {
  const UiColors colors = appColors();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(hasFocus() ? colors.accent : colors.border);
  painter.setBrush(isDown() || underMouse() ? colors.hover : colors.base);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
  paintMark(&painter, QRectF(10, height() / 2.0 - 6, 12, 12), mark_, colors);
  const QFontMetrics metrics = fontMetrics();
  const int safety_room = safetyRoom();
  const QRect area = rect().adjusted(30, 0, -26 - safety_room_, 0);
  paintSafety(&painter, QRect(area.right() + 1 + kSafetyGapPx, 4, safety_room - kSafetyGapPx, height() - 8),
              safety_, colors);
  const int word_width = word_.isEmpty() ? 0 : metrics.horizontalAdvance(QStringLiteral("reconnecting")) + 8;
  const QRect name = area.adjusted(0, 0, -word_width, 0);
  painter.setPen(colors.text);
  painter.drawText(name, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine,
                   metrics.elidedText(name_, Qt::ElideMiddle, name.width()));
  painter.setPen(colors.secondary_text);
  painter.drawText(area, Qt::AlignRight | Qt::AlignVCenter | Qt::TextSingleLine, word_);
  paintIcon(&painter, QRectF(width() - 22, height() / 2.0 - 7, 14, 14), QStringLiteral("chevron-down"),
            colors.secondary_text);
}

}  // namespace mapwright::window

#include "moc_connection_chip.cpp"
