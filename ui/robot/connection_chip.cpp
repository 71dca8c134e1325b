#include "ui/robot/connection_chip.h"

#include <algorithm>

#include <QPainter>

#include "ui/kit/icons.h"
#include "ui/kit/plain_label.h"
#include "ui/kit/state_mark.h"
#include "ui/robot/robot_look.h"
#include "words/listed.h"

namespace mapwright::ui {

namespace {
constexpr int kBeforeTextPx = 30, kAfterTextPx = 28;  // the mark, the arrow
constexpr int kNameLetters = 22, kLeastNameLetters = 8;
constexpr int kSafetyGapPx = 8, kWordGapPx = 8, kColorPx = 12, kColorGapPx = 6;
}  // namespace

ConnectionChip::ConnectionChip(QWidget* parent) : QToolButton(parent) {
  setPopupMode(QToolButton::InstantPopup);
  setFocusPolicy(Qt::TabFocus);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void ConnectionChip::setRobot(const QString& name, Mark mark, const QString& word, const QString& detail) {
  const bool same = name == name_ && mark == mark_ && word == word_;
  detail_ = detail;
  name_ = name;
  mark_ = mark;
  word_ = word;
  describe();
  if (!same) update();
}

void ConnectionChip::setColor(const QColor& color) {
  if (color == color_) return;
  color_ = color;
  updateGeometry();
  update();
}

int ConnectionChip::colorRoom() const { return color_.isValid() ? kColorPx + kColorGapPx : 0; }

void ConnectionChip::setSafety(const SafetyText& text) {
  if (text == safety_) return;
  safety_ = text;
  describe();
  update();
}

void ConnectionChip::describe() {
  const QString tip = safety_.detail.isEmpty() ? detail_ : safety_.detail + QStringLiteral("\n\n") + detail_;
  setToolTip(plainToolTip(tip));
  QString called = word_.isEmpty() ? name_ : tr("%1, %2").arg(name_, word_);
  if (!safety_.badge.isEmpty()) called = words::listed({called, safety_.badge});
  setAccessibleName(called);
}

QSize ConnectionChip::sizeHint() const {
  // The same whatever it shows: the tools next to it never move.
  const QFontMetrics metrics = fontMetrics();
  return {kBeforeTextPx + kColorPx + kColorGapPx + kNameLetters * metrics.averageCharWidth() + kWordGapPx +
              metrics.horizontalAdvance(QStringLiteral("reconnecting")) + kAfterTextPx,
          30};
}

void ConnectionChip::paintEvent(QPaintEvent*) {
  const UiColors colors = appColors();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(hasFocus() ? QPen(colors.focus, 2) : QPen(colors.border, 1));
  painter.setBrush(isDown() || underMouse() ? colors.hover : colors.base);
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 6, 6);
  paintMark(&painter, QRectF(10, height() / 2.0 - 6, 12, 12), mark_, colors);
  const QFontMetrics metrics = fontMetrics();
  paintRobotColor(painter, QRectF(kBeforeTextPx, height() / 2.0 - kColorPx / 2.0, kColorPx, kColorPx),
                  color_);
  QRect area = rect().adjusted(kBeforeTextPx + colorRoom(), 0, -kAfterTextPx, 0);
  if (const int wanted = safetyWidth(safety_, font()); wanted > 0) {
    // An alert stands where the word was, which the mark and the status bar tell, too.
    const int least_name = kLeastNameLetters * metrics.averageCharWidth();
    const int width = std::min(wanted, area.width() - least_name - kSafetyGapPx);
    paintSafety(&painter, QRect(area.right() + 1 - width, 4, width, height() - 8), safety_, colors);
    area.setRight(area.right() - width - kSafetyGapPx);
  } else if (!word_.isEmpty()) {
    painter.setPen(colors.secondary_text);
    painter.drawText(area, Qt::AlignRight | Qt::AlignVCenter | Qt::TextSingleLine, word_);
    area.setRight(area.right() - metrics.horizontalAdvance(word_) - kWordGapPx);
  }
  painter.setPen(colors.text);
  painter.drawText(area, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine,
                   metrics.elidedText(name_, Qt::ElideMiddle, area.width()));
  paintIcon(&painter, QRectF(width() - 22, height() / 2.0 - 7, 14, 14), QStringLiteral("chevron-down"),
            colors.secondary_text);
}

}  // namespace mapwright::ui

#include "moc_connection_chip.cpp"
