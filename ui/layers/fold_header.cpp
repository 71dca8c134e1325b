#include "ui/layers/fold_header.h"

#include <algorithm>

#include <QKeyEvent>
#include <QPainter>

#include "ui/kit/forms.h"
#include "ui/kit/icons.h"
#include "ui/kit/ui_colors.h"

namespace mapwright::ui {

namespace {

constexpr int kHeaderPx = 24, kTextFromPx = 26, kEndPx = 8, kChevronPx = 14;

}  // namespace

FoldHeader::FoldHeader(const QString& text, QWidget* parent) : QAbstractButton(parent) {
  setCheckable(true);
  setChecked(true);
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_Hover);
  makeHeading(*this);
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
  setTitle(text);
}

void FoldHeader::setOpen(bool open) {
  setChecked(open);
  setAccessibleDescription(open ? tr("unfolded") : tr("folded"));
}

void FoldHeader::setNote(const QString& note) {
  if (note == note_) return;
  note_ = note;
  setAccessibleName(text() + QLatin1Char(' ') + note);
  updateGeometry();
  update();
}

void FoldHeader::setTitle(const QString& title) {
  if (title == text()) return;
  setText(title);
  setAccessibleName(title);
  updateGeometry();
}

QRect FoldHeader::textRoom(int width) const {
  const int note = note_.isEmpty() ? 0 : fontMetrics().horizontalAdvance(note_) + 8;
  return QRect(kTextFromPx, 0, std::max(10, width - kTextFromPx - kEndPx - note), 1000);
}

QSize FoldHeader::sizeHint() const { return {160, kHeaderPx}; }

int FoldHeader::heightForWidth(int width) const {
  const int text_height =
      fontMetrics().boundingRect(textRoom(width), Qt::AlignLeft | Qt::TextWordWrap, text()).height();
  return std::max(kHeaderPx, text_height + kHeaderPx - fontMetrics().height());
}

void FoldHeader::paintEvent(QPaintEvent*) {
  const UiColors colors = appColors();
  QPainter painter(this);
  if (hasFocus() || underMouse()) painter.fillRect(rect(), colors.hover);
  if (hasFocus()) painter.fillRect(QRect(0, 0, 2, height()), colors.accent);
  paintIcon(&painter, QRectF(6, (kHeaderPx - kChevronPx) / 2.0, kChevronPx, kChevronPx),
            open() ? QStringLiteral("chevron-down") : QStringLiteral("chevron-right"), colors.neutral);
  painter.setFont(font());
  painter.setPen(colors.text);
  QRect room = textRoom(width());
  room.setHeight(height());
  painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, text());
  QFont plain = font();
  plain.setWeight(QFont::Normal);
  painter.setFont(plain);
  painter.setPen(colors.secondary_text);
  painter.drawText(rect().adjusted(0, 0, -kEndPx, 0), Qt::AlignRight | Qt::AlignVCenter, note_);
}

void FoldHeader::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Up:
      return Q_EMIT focusWanted(-1);
    case Qt::Key_Down:
      return Q_EMIT focusWanted(1);
    case Qt::Key_Left:
      return Q_EMIT foldWanted(false);
    case Qt::Key_Right:
      return Q_EMIT foldWanted(true);
    default:
      QAbstractButton::keyPressEvent(event);
  }
}

void FoldHeader::nextCheckState() { Q_EMIT foldWanted(!isChecked()); }

}  // namespace mapwright::ui

#include "moc_fold_header.cpp"
