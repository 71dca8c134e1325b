#include "window/status/connection_chip.h"

#include <QPainter>

#include "window/look/icons.h"
#include "window/look/plain_label.h"
#include "window/status/state_mark.h"

namespace mapwright::window {

namespace {
constexpr int kNameLimitPx = 200;
}

ConnectionChip::ConnectionChip(QWidget* parent) : QToolButton(parent) {
  setPopupMode(QToolButton::InstantPopup);
  setFocusPolicy(Qt::TabFocus);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void ConnectionChip::setRobot(const QString& name, Mark mark, const QString& word, const QString& detail) {
  setToolTip(plainToolTip(detail));
  setAccessibleName(QStringLiteral("Robot %1, %2").arg(name, word));
  if (name == name_ && mark == mark_ && word == word_) return;
  name_ = name;
  mark_ = mark;
  word_ = word;
  updateGeometry();
  update();
}

QSize ConnectionChip::sizeHint() const {
  const QFontMetrics metrics = fontMetrics();
  const int name = qMin(metrics.horizontalAdvance(name_), kNameLimitPx);
  // As wide as the longest word, so that the tool bar does not jump with the link.
  const int word = word_.isEmpty() ? 0 : metrics.horizontalAdvance(QStringLiteral("reconnecting")) + 8;
  return {10 + 12 + 8 + name + word + 8 + 16 + 6, 30};
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
  QRect area = rect().adjusted(30, 0, -26, 0);
  const int word_width = word_.isEmpty() ? 0 : metrics.horizontalAdvance(QStringLiteral("reconnecting")) + 8;
  QRect name = area.adjusted(0, 0, -word_width, 0);
  painter.setPen(colors.text);
  painter.drawText(name, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine,
                   metrics.elidedText(name_, Qt::ElideMiddle, name.width()));
  painter.setPen(colors.secondary_text);
  painter.drawText(area, Qt::AlignRight | Qt::AlignVCenter | Qt::TextSingleLine, word_);
  paintIcon(&painter, QRectF(width() - 22, height() / 2.0 - 7, 14, 14), QStringLiteral("chevron-down"),
            colors.secondary_text);
}

}  // namespace mapwright::window
